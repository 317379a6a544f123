//! Every scene that a format admits is drawn: without a panic in builds that check every operation, and with finite
//! light that is never negative.

#![allow(clippy::indexing_slicing, reason = "arrays of three")]

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use rta::engine::{Format, Model, Settings};
use rta_scenes::description::{
    Camera, Cylinder, Description, Ellipsoid, FallOff, Floor, Lamp, Sky, Sphere, Surface,
};
use rta_tests::picture::{render, settings};

fn point() -> impl Strategy<Value = [f64; 3]> {
    // Anywhere, or near enough together to overlap and to be seen.
    prop_oneof![prop::array::uniform3(-100.0..=100.0), prop::array::uniform3(-6.0..=6.0)]
}

fn color() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(0.0..=1.0)
}

fn radius() -> impl Strategy<Value = f64> {
    prop_oneof![0.05..=20.0, 0.05..=1.0]
}

fn surface() -> impl Strategy<Value = Surface> {
    let glass = (0.0..=1.0, 0.25..=4.0).prop_map(|(ks, ior)| Surface::Transparent { ks, kt: 1.0 - ks, ior });
    prop_oneof![Just(Surface::Opaque), Just(Surface::Shiny), Just(Surface::Mirror), glass]
}

fn camera() -> impl Strategy<Value = Camera> {
    let view = prop::array::uniform3(-1.0..=1.0_f64)
        .prop_filter("some direction", |v| v.iter().any(|c| c.abs() > 1e-3));
    // Along the floor, where rays are the longest.
    let level =
        [-1.0..=1.0, -1.0..=1.0, -1e-3..=1e-3_f64].prop_filter("some direction", |v| v[0].abs() > 1e-3);
    let view = prop_oneof![
        6 => view,
        3 => level,
        1 => Just([0.0, 0.0, -1.0]),
        1 => Just([0.0, 1.0, 0.0]),
    ];
    (point(), view, 0.1..=10.0).prop_map(|(eye, view, focal)| Camera::upright(eye, view, focal))
}

fn lamp() -> impl Strategy<Value = Lamp> {
    let power = prop_oneof![0.0..=1e6, 0.0..=100.0];
    let radius = prop_oneof![Just(0.0), radius()];
    (point(), prop::array::uniform3(power), radius).prop_map(|(position, color, radius)| Lamp {
        position,
        color,
        radius,
        fall_off: FallOff::OfModel,
        line: 0,
    })
}

fn scene() -> impl Strategy<Value = Description> {
    let cylinder = (point(), color(), radius(), surface()).prop_map(|(position, color, radius, surface)| {
        Cylinder { position, color, radius, surface, line: 0 }
    });
    let radii = prop::array::uniform3(radius());
    let ellipsoid = (point(), color(), radii, surface()).prop_map(|(position, color, radii, surface)| {
        Ellipsoid { position, color, radii, inside_only: false, surface, line: 0 }
    });
    let sphere = (point(), color(), radius(), surface())
        .prop_map(|(position, color, radius, surface)| Sphere { position, color, radius, surface, line: 0 });
    let floor =
        prop::option::of([color(), color()].prop_map(|colors| Floor { colors, surface: Surface::Opaque }));
    let sky = (color(), color()).prop_map(|(horizon, zenith)| Sky { horizon, zenith });
    (
        camera(),
        prop::collection::vec(cylinder, 0..3),
        prop::collection::vec(ellipsoid, 0..5),
        prop::collection::vec(sphere, 0..9),
        prop::collection::vec(lamp(), 0..4),
        floor,
        color(),
        sky,
    )
        .prop_map(|(camera, cylinders, ellipsoids, spheres, lamps, floor, ambient, sky)| Description {
            cylinders,
            ellipsoids,
            spheres,
            lamps,
            floor,
            ambient,
            sky,
            ..Description::empty(camera)
        })
}

fn small(format: Format, model: Model, depth: u32) -> Settings {
    Settings { width: 16, height: 12, model, depth, ..settings(format) }
}

/// Each run has one seed and so the same scenes; `PROPTEST_RNG_SEED` in the environment asks for others, and
/// `PROPTEST_CASES` for more.
fn config() -> ProptestConfig {
    let default = ProptestConfig::default();
    let is_told = std::env::var_os("PROPTEST_CASES").is_some();
    let cases = if is_told { default.cases } else { 2000 };
    let rng_seed = match default.rng_seed {
        RngSeed::Random => RngSeed::Fixed(1990),
        told @ RngSeed::Fixed(_) => told,
    };
    ProptestConfig { cases, rng_seed, failure_persistence: None, ..default }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn every_scene_is_drawn(scene in scene(), depth in 0..=8_u32, whitted in any::<bool>()) {
        let model = if whitted { Model::Whitted } else { Model::Rta };
        for format in [Format::Q16, Format::Q20, Format::F32] {
            let picture = render(&scene, &small(format, model, depth)).expect("it fits the format");
            for pixel in picture {
                prop_assert!(pixel.iter().all(|l| l.is_finite() && *l >= 0.0), "{format}: {pixel:?}");
            }
        }
    }
}
