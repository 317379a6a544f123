//! The formats against an independent renderer and against each other: the figures that `tests/README.md` states.

use rta::engine::Format;
use rta_scenes::{dat, description::Description, shipped};
use rta_tests::picture::{render, settings, share_within};
use rta_tests::{oracle, random_scenes};

mod nff;

fn shipped_scenes() -> Vec<(&'static str, Description)> {
    shipped::ALL
        .iter()
        .map(|(name, text)| (*name, dat::read(text.as_bytes(), name).expect("a shipped scene")))
        .collect()
}

/// Compares f64 with the oracle, and f32, q16 and q20 with f64; `least` is the share of pixels in a hundred that must
/// agree in each of these. Prints the shares.
fn check(scenes: &[(&'static str, Description)], least: [f64; 4]) {
    for (name, scene) in scenes {
        let at = settings(Format::F64);
        let truth = oracle::render(scene, at.width as usize, at.height as usize, at.aspect, at.depth);
        let f64 = render(scene, &at).expect(name);
        let against =
            |format, tolerance| share_within(&f64, &render(scene, &settings(format)).expect(name), tolerance);
        let shares = [
            share_within(&truth, &f64, 1e-3),
            against(Format::F32, 1.0 / 255.0),
            against(Format::Q16, 1.0 / 63.0),
            against(Format::Q20, 1.0 / 63.0),
        ];
        let [o, f32, q16, q20] = shares;
        println!("{name:20} oracle/f64 {o:7.3}  f64/f32 {f32:7.3}  f64/q16 {q16:7.3}  f64/q20 {q20:7.3} %");
        for (share, least) in shares.iter().zip(least) {
            assert!(*share >= least, "{name}: {shares:?} % agree, at least {least:?} % must");
        }
    }
}

#[test]
fn shipped_scenes_agree() {
    check(&shipped_scenes(), [99.9, 99.9, 99.5, 99.9]);
}

#[test]
fn generated_scenes_agree() {
    let scenes = random_scenes::all();
    let (some, others) = scenes.split_at(scenes.len() / 2);
    let check = |scenes| check(scenes, [99.9, 99.6, 99.3, 99.5]);
    std::thread::scope(|threads| {
        threads.spawn(|| check(some));
        check(others);
    });
}
