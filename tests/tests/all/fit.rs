//! `--fit` in fixed point: the picture of a small world is that of `f64`.

use core::fmt::Write;

use rta::engine::admission::admits;
use rta::engine::{Format, Settings};
use rta_scenes::description::Description;
use rta_scenes::fit::{Fitted, fit};
use rta_scenes::nff;
use rta_tests::picture::{render, share_within};

const ASPECT: f64 = 4.0 / 3.0;

/// Returns the share of pixels, in a hundred, that a scene has in a format within a tolerance of `f64`.
fn share(scene: &Description, truth: &Description, format: Format, tolerance: f64) -> f64 {
    let at = |format| Settings {
        width: 96,
        height: 72,
        aspect: ASPECT,
        format,
        model: rta::engine::Model::Phong,
        ..Settings::default()
    };
    let draw = |scene, format| render(scene, &at(format)).expect("it is admitted");
    share_within(&draw(scene, format), &draw(truth, Format::F64), tolerance)
}

fn fitted(scene: &Description, format: Format) -> (f64, Description, Option<f64>) {
    let admits = |scene: &Description| admits(scene, format, ASPECT, 5);
    match fit(scene, scene.model, format, admits(scene), admits) {
        Ok(Fitted::Scaled { factor, scene, gain }) => (factor, *scene, gain),
        other => panic!("{format}: {other:?}"),
    }
}

#[test]
fn small_worlds_are_drawn_as_precisely_as_others() {
    for (name, text, factors) in [
        ("small-world", include_str!("../../scenes/cases/small-world.nff"), [26, 22]),
        ("fit-tiny", include_str!("../../scenes/cases/fit-tiny.nff"), [29, 25]),
    ] {
        let scene = nff::read(text.as_bytes(), name).expect(name);
        for (format, exponent) in [Format::Q16, Format::Q20].into_iter().zip(factors) {
            let (factor, scaled, gain) = fitted(&scene, format);
            assert_eq!((factor, gain), (2_f64.powi(exponent), None), "{name} in {format}");
            let share = share(&scaled, &scene, format, 1e-3);
            assert!(share == 100.0, "{name} in {format}: {share} % of the pixels within 1/1000");
        }
    }
}

/// Returns a lattice of thin rods that is one unit wide.
fn lattice() -> Description {
    let mut text = String::from(
        "b .2 .3 .4 v from 1.6 -1.9 1.2 at .5 .5 .5 up 0 0 1 angle 40 hither 0 resolution 96 72 l 3 -2 4
         f .8 .6 .4 .7 .3 20 0 1\n",
    );
    for i in 0..6 {
        for j in 0..6 {
            let (a, b) = (f64::from(i) / 5.0, f64::from(j) / 5.0);
            for (from, to) in
                [([0.0, a, b], [1.0, a, b]), ([a, 0.0, b], [a, 1.0, b]), ([a, b, 0.0], [a, b, 1.0])]
            {
                let ([x, y, z], [u, v, w]) = (from, to);
                writeln!(text, "c {x} {y} {z} .01 {u} {v} {w} .01").expect("memory takes it");
            }
        }
    }
    nff::read(text.as_bytes(), "lattice").expect("it is well formed")
}

#[test]
fn a_scene_that_is_admitted_gains_what_it_is_told() {
    let scene = lattice();
    let (_, scaled, gain) = fitted(&scene, Format::Q16);
    assert!(gain.is_some_and(|gain| gain > 3.0), "{gain:?}");
    let (as_it_is, scaled) =
        (share(&scene, &scene, Format::Q16, 1.0 / 63.0), share(&scaled, &scene, Format::Q16, 1.0 / 63.0));
    assert!(as_it_is < 99.5 && scaled > 99.9, "{as_it_is} % as it is, {scaled} % scaled");
}
