//! What is known of the measures without another program: equal pictures, pictures of one colour, and what is refused.

use rta::picture::raster::Size;
use rta::study::measure::colorimetry::{Lab, RGB_OF_XYZ, WHITE as WHITE_XYZ, XYZ_OF_RGB, product, xyz};
use rta::study::measure::{MeasureError, Pair, PixelsPerDegree, Psnr, ciede2000, flip, mean, psnr, scielab};
use rta_core::color::Rgb;

use super::{BLACK, Pictures, WHITE, noise, pixels_per_degree};

const SIZES: [(u32, u32); 5] = [(1, 1), (1, 9), (7, 1), (3, 2), (31, 20)];
/// From a screen so near that a pixel fills the view to the highest that is accepted.
const DISTANCES: [f64; 8] = [f64::MIN_POSITIVE, 1e-9, 0.5, 2.0, 13.0, 38.0, 67.0, 1000.0];

#[test]
fn equal_pictures_have_no_error_and_any_others_have_one_between_0_and_the_limit() {
    for size in SIZES {
        let equal = Pictures::drawn(size, noise(1), noise(1));
        let unequal = Pictures::drawn(size, noise(1), noise(2));
        assert_eq!(psnr(&equal.pair()), Psnr::Equal);
        for distance in DISTANCES {
            let pixels = pixels_per_degree(distance);
            assert!(flip::map(&equal.pair(), pixels).iter().all(|&error| error == 0.0), "{size:?}");
            assert!(scielab::map(&equal.pair(), pixels).iter().all(|&error| error == 0.0), "{size:?}");
            for error in flip::map(&unequal.pair(), pixels) {
                assert!((0.0..=1.0).contains(&error), "{size:?}, {distance}: {error}");
            }
            for error in scielab::map(&unequal.pair(), pixels) {
                assert!((0.0..=150.0).contains(&error), "{size:?}, {distance}: {error}");
            }
            assert!(mean(&flip::map(&unequal.pair(), pixels)) > 0.1, "{size:?}, {distance}");
        }
    }
}

#[test]
fn it_does_not_matter_which_picture_is_the_reference() {
    let pictures = Pictures::drawn((31, 20), noise(1), noise(2));
    let (pair, swapped) = (pictures.pair(), pictures.swapped());
    assert_eq!(psnr(&pair), psnr(&swapped));
    for pixels in [13.0, 67.0].map(pixels_per_degree) {
        assert_eq!(flip::map(&pair, pixels), flip::map(&swapped, pixels));
        let (there, back) = (scielab::map(&pair, pixels), scielab::map(&swapped, pixels));
        super::assert_maps_close(&there, &back, 1e-4, "S-CIELAB");
    }
}

/// Green and blue are the farthest colours of the screen, which have error 1 by definition. The distance of black
/// from white is 100 in lightness alone, that of green from blue 203.0 by the paper's equations, so that their errors are 1 and
/// 0.95 + 0.05 (100^0.7 - 0.4 d) / (0.6 d) with d = 203.0^0.7.
#[test]
fn flip_of_plain_pictures_is_what_the_equations_say() {
    let (green, blue) = (Rgb::new(0, 255, 0), Rgb::new(0, 0, 255));
    let greatest = 203.0_f32.powf(0.7);
    let black_white = 0.95 + 0.05 * (100.0_f32.powf(0.7) - 0.4 * greatest) / (0.6 * greatest);
    for (reference, test, want) in [(green, blue, 1.0), (BLACK, WHITE, black_white), (BLACK, BLACK, 0.0)] {
        for pixels in [1.0, 13.0, 67.0].map(pixels_per_degree) {
            let map = flip::map(&Pictures::plain((12, 9), reference, test).pair(), pixels);
            super::assert_maps_close(&map, &[want; 108], 2e-4, &format!("{reference:?} {test:?}"));
        }
    }
}

/// An edge or a point is seen although the colours on both sides hardly change: features raise an error.
#[test]
fn flip_of_a_line_is_larger_than_that_of_a_wide_step_of_the_same_height() {
    let gray = |level| Rgb::new(level, level, level);
    let line = |x, _| gray(if x == 20 { 160 } else { 128 });
    let plain = Pictures::plain((41, 41), gray(128), gray(160));
    let lined = Pictures::drawn((41, 41), |_, _| gray(128), line);
    let pixels = pixels_per_degree(20.0);
    let at = |pictures: &Pictures, x: usize| flip::map(&pictures.pair(), pixels)[20 * 41 + x];
    assert!(at(&lined, 20) > 1.05 * at(&plain, 20), "{} {}", at(&lined, 20), at(&plain, 20));
    assert!(at(&lined, 0) < 1e-6);
}

#[test]
fn psnr_counts_every_register() {
    let pictures = |test: Rgb<u8>| Pictures::drawn((4, 2), |_, _| Rgb::new(10, 20, 30), move |_, _| test);
    let decibels = |pictures: &Pictures| match psnr(&pictures.pair()) {
        Psnr::Decibels(decibels) => decibels,
        Psnr::Equal => panic!("they are not equal"),
    };
    // One register in three is off by one: 255^2 * 3.
    assert!((decibels(&pictures(Rgb::new(10, 20, 29))) - 52.902).abs() < 1e-3);
    assert!((decibels(&pictures(Rgb::new(13, 17, 33))) - 38.588).abs() < 1e-3);
    assert_eq!(decibels(&Pictures::plain((2, 2), BLACK, WHITE)), 0.0);
    assert_eq!(psnr(&pictures(Rgb::new(11, 20, 30)).pair()).to_string(), "52.90 dB");
    assert_eq!(format!("{:>8}", psnr(&pictures(Rgb::new(10, 20, 30)).pair())), "   equal");
}

#[test]
fn wrong_sizes_and_distances_are_refused() {
    let size = Size::new(3, 2).expect("within the limits");
    for (reference, test, pixels) in [(5, 6, 5), (6, 7, 7), (0, 0, 0)] {
        let error = Pair::new(&vec![BLACK; reference], &vec![BLACK; test], size).expect_err("a wrong size");
        assert_eq!(error, MeasureError::Pixels { width: 3, height: 2, pixels });
    }
    for pixels in [0.0, -1.0, f64::NAN, f64::INFINITY, 1000.1] {
        let error = PixelsPerDegree::new(pixels).expect_err("a wrong distance");
        assert_eq!(
            error.to_string(),
            format!("pixels per degree are above 0 and at most 1000, not {pixels}")
        );
    }
}

/// The sRGB standard's white and primaries in XYZ, and CIELAB of them as tables have them.
#[test]
fn colours_of_the_screen_have_their_known_cielab() {
    let known = [
        (WHITE, [100.0, 0.0, 0.0]),
        (BLACK, [0.0, 0.0, 0.0]),
        (Rgb::new(255, 0, 0), [53.24, 80.09, 67.20]),
        (Rgb::new(0, 255, 0), [87.73, -86.18, 83.18]),
        (Rgb::new(0, 0, 255), [32.30, 79.19, -107.86]),
        (Rgb::new(119, 119, 119), [50.03, 0.0, 0.0]),
    ];
    for (color, want) in known {
        let Lab { l, a, b } = Lab::of_xyz(xyz(&[color]).next().expect("one pixel"));
        for (got, want) in [l, a, b].into_iter().zip(want) {
            assert!((got - want).abs() < 0.02, "{color:?}: {l} {a} {b}");
        }
    }
    assert!((ciede2000(Lab::of_xyz([0.0; 3]), Lab::of_xyz(WHITE_XYZ)) - 100.0).abs() < 1e-9);
    let there_and_back = product(&RGB_OF_XYZ, product(&XYZ_OF_RGB, [0.1, 0.5, 0.9]));
    for (got, want) in there_and_back.into_iter().zip([0.1, 0.5, 0.9]) {
        assert!((got - want).abs() < 1e-12);
    }
}
