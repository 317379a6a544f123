//! Every model of the list at the ends of its parameters and of its angles, in every number format: its light is a number from 0 to
//! a bound, and the weights of its rays are shares.

use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Weight};
use rta_core::light::{FallOff, Lamp};
use rta_core::needs::Everything;
use rta_core::ray::{RayKind, Start};
use rta_core::scalar::Unit;
use rta_core::trace::decision::direct;
use rta_core::vector::{Vec3, Vector};
use rta_core::{Q16, Q20};
use rta_scenes::description::{Air, Attenuation, Fading, Medium};
use rta_scenes::model::Model;
use rta_scenes::narrow::narrow;
use rta_scenes::rta;
use rta_scenes::shading::{AnyModel, any_model};
use rta_tests::measure::{Measure, color, read_light};
use rta_tests::point::Point;

const MATERIALS: &str = include_str!("../../scenes/edges.rta");

/// No surface sends back more of a lamp than this: facets of the least slope, .01, in the direction of a mirror and along the surface
/// send back `D G F / (N.V)`, at most 1024 / m^2.
const MOST: f64 = 1024.0 / 1e-4;

/// Directions from below the surface, along it and above it, the normal being (0, 0, 1). The steps near the surface are that of a
/// fixed-point format, less than it, and some that every format holds.
const DIRECTIONS: [[f64; 3]; 13] = [
    [0.0, 0.0, 1.0],
    [1e-5, 0.0, 1.0],
    [0.6, 0.0, 0.8],
    [-0.6, 0.0, 0.8],
    [0.0, 1.0, 1e-3],
    [0.0, -1.0, 1e-3],
    [1.0, 0.0, 1e-9],
    [-1.0, 0.0, 1e-10],
    [1.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [-1.0, 0.0, -1e-9],
    [-0.6, 0.0, -0.8],
    [0.0, 0.0, -1.0],
];

/// Returns the air that a model stands in: none, and all of it.
fn airs() -> [Air; 2] {
    let all = Air {
        attenuation: Some(Attenuation { fading: Fading::Haze([0.0, 1e-3]), from: None, color: None }),
        medium: Some(Medium::fog([1e-6, 1.0, 1e3])),
    };
    [Air::default(), all]
}

fn assert_light<S: Measure>(light: Rgb<S::Light>, most: f64, case: &dyn Fn() -> String) {
    let registers = read_light::<S>(light);
    let is_light = registers.iter().all(|register| (0.0..=most).contains(register));
    assert!(is_light, "{}: a light of {registers:?}", case());
}

fn assert_shares<S: Measure>(weight: impl Weight<S>, case: &dyn Fn() -> String) {
    let Rgb { r, g, b } = weight.registers();
    let registers = [r, g, b].map(S::unit_to_f64);
    let are_shares = registers.iter().all(|part| (0.0..=1.0 + 4.0 * S::UNIT).contains(part));
    assert!(are_shares, "{}: a weight of {registers:?}", case());
}

/// Asks a model for all that it says of a point and of a lamp.
fn ask<S: Measure>(model: &AnyModel<S>, point: &Point<S>, lamps: &[Lamp<S>], case: &dyn Fn() -> String) {
    let surface = point.surface();
    let one = S::light(1.0);
    assert_light::<S>(
        model.ambient::<Everything>(&surface, Rgb::new(one, one, one)),
        1.0 + 4.0 * S::LIGHT,
        case,
    );
    let secondary = model.secondary::<Everything>(&surface);
    for weight in [secondary.reflected, secondary.transmitted].into_iter().flatten() {
        assert_shares::<S>(weight, case);
    }
    for lamp in lamps {
        let light = direct::<S, _, Everything>(model, &surface, &point.incident(lamp, S::length(1.0)));
        assert_light::<S>(light, MOST, case);
    }
    let origin: Vec3<S> = Vector::new(S::ZERO, S::ZERO, S::ZERO);
    for kind in [RayKind::Primary, RayKind::Reflected, RayKind::Transmitted] {
        for length in [None, Some(S::ZERO), Some(S::length(1.0)), Some(S::length(S::largest()))] {
            let start = Start { origin, direction: surface.incoming };
            let way = rta_core::illumination::Way {
                kind,
                start,
                length,
                surface: Some(&surface),
                shift: None,
                lamps: &[],
            };
            if let Some(passage) = model.along::<Everything>(&way, |_, _| S::Unit::ONE) {
                assert_shares::<S>(passage.weight, case);
                assert_light::<S>(passage.veil, 1.0 + 4.0 * S::LIGHT, case);
            }
        }
    }
}

fn check<S: Measure>() {
    let scene = rta::read(MATERIALS.as_bytes(), "edges.rta").expect("a scene");
    let narrowed = narrow::<S>(&scene, 1.0).expect("it fits");
    let admitted = narrowed.admit().expect("it fits");
    let steady: Lamp<S> = Point::lamp();
    let radius = S::length(1.0);
    let large = Lamp { radius, inverse_radius: radius.inverse(), fall_off: FallOff::Square, ..steady };
    let lamps = [steady, large];
    let mut asked = 0;
    for (&name, air) in Model::ALL.iter().flat_map(|name| airs().map(|air| (name, air))) {
        let model = any_model(name, &air, &narrowed, admitted.limits);
        for (number, material) in (0..).zip(&narrowed.materials) {
            for (light, view) in DIRECTIONS.iter().flat_map(|&light| DIRECTIONS.map(|view| (light, view))) {
                let [_, _, height] = view;
                for inside in [false, true].into_iter().filter(|_| height >= 0.0) {
                    for (length, shade) in [(0.0, 1.0), (1.0, 0.0), (S::largest(), 0.999)] {
                        let (distance, color) = (S::length(length), color::<S>([shade; 3]));
                        let point =
                            Point { inside, distance, color, ..Point::new([0.0, 0.0, 1.0], light, view) };
                        let point = Point { material: *material, number, ..point };
                        let case = || format!("{name}, {}, air {air:?}, {point:?}", S::NAME);
                        ask::<S>(&model, &point, &lamps, &case);
                        asked += 1;
                    }
                }
            }
        }
    }
    assert!(asked > 18 * 13 * 13 * 10 * 2, "{asked} points");
}

#[test]
fn models_return_light_at_the_ends_of_their_parameters_in_f64() {
    check::<f64>();
}

#[test]
fn models_return_light_at_the_ends_of_their_parameters_in_f32() {
    check::<f32>();
}

#[test]
fn models_return_light_at_the_ends_of_their_parameters_in_q16() {
    check::<Q16>();
}

#[test]
fn models_return_light_at_the_ends_of_their_parameters_in_q20() {
    check::<Q20>();
}
