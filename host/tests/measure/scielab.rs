//! S-CIELAB beside a plain sum over the neighbours of each pixel in two dimensions, and what is known of it.

use rta::study::measure::ciede2000;
use rta::study::measure::colorimetry::{Lab, inverse, product, xyz};
use rta::study::measure::scielab::{GAUSSIANS, OPPONENT_OF_XYZ, map};
use rta_core::color::Rgb;

use super::{BLACK, Pictures, WHITE, assert_maps_close, noise, pixels_per_degree};

/// Returns the blurred colour of one pixel: for each opponent part the weighted sum over a disc's square of neighbours of both its
/// Gaussians, each over the sum of its own weights.
fn seen(colors: &[[f64; 3]], (width, height): (u32, u32), place: (u32, u32), pixels: f64) -> Lab {
    let limit =
        |at: i64, side: u32| usize::try_from(at.clamp(0, i64::from(side) - 1)).expect("it is not negative");
    let mut opponent = [0.0; 3];
    for (part, gaussians) in GAUSSIANS.into_iter().enumerate() {
        let all: f64 = gaussians.iter().map(|(weight, _)| weight).sum();
        for (weight, spread) in gaussians {
            let spread = spread * pixels;
            let (mut sum, mut weights) = (0.0, 0.0);
            let radius =
                (0_i32..).find(|&radius| f64::from(radius) >= 3.0 * spread / 2.0_f64.sqrt()).expect("one");
            for (dy, dx) in (-radius..=radius).flat_map(|dy| (-radius..=radius).map(move |dx| (dy, dx))) {
                let x = limit(i64::from(place.0) + i64::from(dx), width);
                let y = limit(i64::from(place.1) + i64::from(dy), height);
                let here = (-f64::from(dx * dx + dy * dy) / (spread * spread)).exp();
                weights += here;
                sum += here * product(&OPPONENT_OF_XYZ, colors[y * width as usize + x])[part];
            }
            opponent[part] += weight / all * sum / weights;
        }
    }
    Lab::of_xyz(product(&inverse(&OPPONENT_OF_XYZ), opponent))
}

#[test]
fn separate_filters_are_the_sum_in_two_dimensions() {
    let size = (13, 10);
    let pictures = Pictures::drawn(size, noise(3), noise(4));
    let reference: Vec<_> = xyz(&pictures.reference).collect();
    let test: Vec<_> = xyz(&pictures.test).collect();
    for pixels in [5.0, 13.0, 38.0] {
        let map = map(&pictures.pair(), pixels_per_degree(pixels));
        for (x, y) in [(0, 0), (6, 5), (12, 3), (2, 9)] {
            let want = ciede2000(seen(&reference, size, (x, y), pixels), seen(&test, size, (x, y), pixels));
            let got = f64::from(map[(y * 13 + x) as usize]);
            assert!((got - want).abs() < 1e-3, "({x}, {y}) at {pixels}: {got}, not {want}");
        }
    }
}

#[test]
fn pictures_of_one_colour_are_as_far_apart_as_their_colours() {
    let (color, other) = (Rgb::new(200, 120, 40), Rgb::new(190, 128, 70));
    let [lab, other_lab] = [color, other].map(|color| Lab::of_xyz(xyz(&[color]).next().expect("one pixel")));
    #[expect(clippy::cast_possible_truncation, reason = "maps are f32")]
    let want = ciede2000(lab, other_lab) as f32;
    for pixels in [0.1, 13.0, 67.0] {
        let map = map(&Pictures::plain((9, 7), color, other).pair(), pixels_per_degree(pixels));
        assert_maps_close(&map, &[want; 63], 1e-3, "plain");
    }
    let far = map(&Pictures::plain((2, 2), BLACK, WHITE).pair(), pixels_per_degree(13.0));
    assert_maps_close(&far, &[100.0; 4], 1e-3, "black and white");
}

/// A checkerboard of black and white is gray from afar: half the light of white, which is sRGB code 188.
#[test]
fn a_fine_checkerboard_is_gray_from_afar() {
    let board = |x, y| if (x + y) % 2 == 0 { BLACK } else { WHITE };
    let pictures = Pictures::drawn((40, 40), board, |_, _| Rgb::new(188, 188, 188));
    // In the middle, since the border goes on with pixels of one colour.
    let error = |pixels| map(&pictures.pair(), pixels_per_degree(pixels))[20 * 40 + 20];
    assert!(error(120.0) < 0.3, "{}", error(120.0));
    assert!(error(10.0) > 20.0, "{}", error(10.0));
}
