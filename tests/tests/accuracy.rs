//! The formats against an independent renderer and against each other.

use rta::engine::Format;
use rta_scenes::{dat, description::Description, shipped};
use rta_tests::picture::{render, settings, share_within};
use rta_tests::{oracle, random_scenes};

fn shipped_scenes() -> Vec<(&'static str, Description)> {
    shipped::ALL
        .iter()
        .map(|(name, text)| (*name, dat::read(text.as_bytes(), name).expect("a shipped scene")))
        .collect()
}

/// f64 against the oracle, f32 and q16 against f64, with the least share of pixels in a hundred that must agree.
fn check(scenes: &[(&'static str, Description)], least: [f64; 3]) {
    for (name, scene) in scenes {
        let at = settings(Format::F64);
        let truth = oracle::render(scene, at.width as usize, at.height as usize, at.aspect, at.depth);
        let [f64, f32, q16] =
            [Format::F64, Format::F32, Format::Q16].map(|f| render(scene, &settings(f)).expect(name));
        let shares = [
            share_within(&truth, &f64, 1e-3),
            share_within(&f64, &f32, 1.0 / 255.0),
            share_within(&f64, &q16, 1.0 / 63.0),
        ];
        println!(
            "{name:20} oracle/f64 {:.3}  f64/f32 {:.3}  f64/q16 {:.3} %",
            shares[0], shares[1], shares[2]
        );
        for (share, least) in shares.iter().zip(least) {
            assert!(*share >= least, "{name}: {shares:?} % agree, at least {least} % must");
        }
    }
}

#[test]
fn shipped_scenes_agree() {
    check(&shipped_scenes(), [99.9, 99.9, 99.5]);
}

#[test]
fn generated_scenes_agree() {
    check(&random_scenes::all(), [99.9, 99.6, 99.3]);
}
