//! Several samples a pixel, and a cut-off: the places and the mean of samples, and the pictures that they change.

#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use rta::engine::Cutoff;
use rta::engine::{Engine, Format, Settings};
use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::sampling::{Places, Sampling};
use rta_core::scalar::Light;
use rta_core::{Q16, Q20};
use rta_scenes::description::Description;
use rta_scenes::narrow::Narrow;
use rta_tests::exact::shipped_scene;

fn grid(side: u8) -> Sampling {
    Sampling::grid(side).expect("a grid of that size")
}

/// Returns the places of a pixel's samples as floats; one LSB of a fixed-point unit is 2^-30.
fn places<S: Narrow>(
    sampling: Sampling,
    raster: Raster,
    x: u32,
    y: u32,
    read: fn(S::Unit) -> f64,
) -> Vec<(f64, f64)> {
    let row = Places::row::<S::Unit>(&sampling, raster, y);
    let place = |sample| sampling.place(raster, row, x, sample);
    (0..sampling.samples()).map(place).map(|(right, up)| (read(right), read(up))).collect()
}

#[test]
fn the_mean_of_regular_samples_of_a_ramp_is_its_value_in_the_middle() {
    let raster = Raster::new(320, 200).expect("small");
    for side in [1, 2, 3, 4, 32] {
        for (x, y) in [(0, 0), (319, 199), (17, 101)] {
            let middle = (f64::from(2 * x + 1) / 640.0 - 0.5, 0.5 - f64::from(2 * y + 1) / 400.0);
            let all = [
                (places::<f64>(grid(side), raster, x, y, |u| u), 1e-15),
                (places::<Q16>(grid(side), raster, x, y, |u| u.to_num()), 1e-9),
            ];
            for (places, tolerance) in all {
                let n = places.len() as f64;
                let mean = places.iter().fold((0.0, 0.0), |sum, p| (sum.0 + p.0 / n, sum.1 + p.1 / n));
                assert!(
                    (mean.0 - middle.0).abs() < tolerance && (mean.1 - middle.1).abs() < tolerance,
                    "{side}"
                );
            }
        }
    }
}

fn mean<S: Narrow>(sampling: Sampling, lights: &[f64]) -> f64 {
    let lights = lights.iter().map(|light| Rgb::new(S::light(*light), S::Light::ZERO, S::Light::WHITE));
    let mean = sampling.mean(lights.fold(Rgb::BLACK, |sum, light| sampling.add(sum, light)));
    assert!(mean.g == S::Light::ZERO && mean.b == S::Light::WHITE, "black and white stay what they are");
    S::light_to_f64(mean.r)
}

#[test]
fn means_are_of_what_a_display_shows() {
    for side in 1..=8 {
        let n = usize::from(side) * usize::from(side);
        let ramp: Vec<_> = (0..n).map(|k| (2 * k + 1) as f64 / (2 * n) as f64).collect();
        // The ramp's own rounding and one more.
        for (mean, lsb) in [
            (mean::<f32>(grid(side), &ramp), 1e-7),
            (mean::<Q16>(grid(side), &ramp), 1.0 / 65_536.0),
            (mean::<Q20>(grid(side), &ramp), 1.0 / 65_536.0),
        ] {
            assert!((mean - 0.5).abs() <= 2.0 * lsb, "{side}: {mean}");
        }
    }
    // A glint counts as white.
    assert_eq!(mean::<Q16>(grid(2), &[25_000.0, 0.0, 0.0, 0.0]), 0.25);
    assert_eq!(mean::<f32>(grid(2), &[25_000.0, 0.0, 0.0, 0.0]), 0.25);
}

#[test]
fn jittered_samples_stay_in_their_cells_and_repeat() {
    let raster = Raster::new(50, 40).expect("small");
    let mut all = Vec::new();
    for side in [1_u8, 2, 3, 4] {
        for (x, y) in [(0, 0), (49, 39), (12, 7), (7, 12)] {
            let jittered = places::<f64>(grid(side).jittered(3), raster, x, y, |u| u);
            assert_eq!(jittered, places::<f64>(grid(side).jittered(3), raster, x, y, |u| u));
            assert_ne!(jittered, places::<f64>(grid(side).jittered(4), raster, x, y, |u| u));
            let fixed = places::<Q16>(grid(side).jittered(3), raster, x, y, |u| u.to_num());
            let regular = places::<f64>(grid(side), raster, x, y, |u| u);
            let side = f64::from(side);
            for ((place, middle), fixed) in jittered.iter().zip(regular).zip(fixed) {
                let (across, down) = ((place.0 - middle.0) * 50.0 * side, (place.1 - middle.1) * 40.0 * side);
                assert!(across.abs() <= 0.5 && down.abs() <= 0.5, "{place:?} {middle:?}");
                assert!(
                    (fixed.0 - place.0).abs() < 2e-9 && (fixed.1 - place.1).abs() < 2e-9,
                    "the same in each format"
                );
                all.extend([across, down]);
            }
        }
    }
    // Neither stuck nor biased: 240 numbers that are even from -1/2 to 1/2 have a mean within 4 x 0.29 / sqrt(240).
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    let spread = (all.iter().map(|part| part * part).sum::<f64>() / all.len() as f64).sqrt();
    assert!(mean.abs() < 0.075 && (0.24..0.34).contains(&spread), "{mean} {spread}");
}

#[test]
fn grids_have_limits() {
    assert!(Sampling::grid(0).is_none() && Sampling::grid(129).is_none());
    assert_eq!(grid(128).samples(), 16_384);
    assert_eq!(grid(1), Sampling::CENTER);
}

fn levels(scene: &Description, settings: &Settings) -> Vec<Rgb<u8>> {
    let mut picture = vec![Rgb::default(); settings.width as usize * settings.height as usize];
    Engine::new(scene, settings).expect("it fits").level_rows(0, 255, &mut picture);
    picture
}

fn small(format: Format) -> Settings {
    Settings { width: 48, height: 30, format, depth: 8, ..Settings::default() }
}

#[test]
fn no_cutoff_changes_nothing_and_some_cutoff_does() {
    for format in [Format::F32, Format::Q16, Format::Q20] {
        let scene = shipped_scene("glass-2");
        // Four bounces of a quarter are far from one in 65535.
        let small = |format| Settings { depth: 4, ..small(format) };
        let plain = levels(&scene, &small(format));
        let least = Cutoff::one_in(u16::MAX);
        assert!(plain == levels(&scene, &Settings { cutoff: Some(Cutoff::OFF), ..small(format) }));
        assert!(
            plain == levels(&scene, &Settings { cutoff: Some(least), ..small(format) }),
            "nothing is that faint"
        );
        assert!(plain != levels(&scene, &Settings { cutoff: Some(Cutoff::one_in(2)), ..small(format) }));
    }
}

#[test]
fn samples_change_edges_and_do_not_depend_on_how_a_picture_is_cut() {
    let scene = shipped_scene("juggler");
    for sampling in [grid(2), grid(3).jittered(1)] {
        let settings = Settings { sampling: sampling.into(), ..small(Format::Q16) };
        let whole = levels(&scene, &settings);
        assert!(whole != levels(&scene, &small(Format::Q16)));
        let engine = Engine::new(&scene, &settings).expect("it fits");
        let mut rows = vec![Rgb::default(); 48 * 10];
        engine.level_rows(20, 255, &mut rows);
        assert!(whole[48 * 20..] == rows);
    }
}
