//! The light of lamps that a medium scatters into a ray, against the integral of its definition, taken in many small steps.

use rta_core::color::Rgb;
use rta_core::illumination::Way;
use rta_core::illumination::air::{Air, Fog, Medium};
use rta_core::illumination::fade::Phase;
use rta_core::light::{FallOff, Lamp};
use rta_core::needs::Everything;
use rta_core::ray::{RayKind, Start};
use rta_core::vector::{Vec3, Vector};
use rta_core::{Q16, Q20};
use rta_scenes::narrow::Narrow;
use rta_tests::assert_close;

/// One ray along y from the origin, and one lamp.
#[derive(Clone, Copy)]
struct Case {
    extinction: [f64; 3],
    albedo: f64,
    forward: f64,
    lamp: [f64; 3],
    power: f64,
    fall_off: FallOff,
    length: f64,
    /// What is beyond this distance lies in shadow.
    shadow: Option<f64>,
}

const CASE: Case = Case {
    extinction: [0.1; 3],
    albedo: 1.0,
    forward: 0.0,
    lamp: [1.0, 5.0, 0.5],
    power: 20.0,
    fall_off: FallOff::Square,
    length: 10.0,
    shadow: None,
};

fn vector<S: Narrow>([x, y, z]: [f64; 3]) -> Vec3<S> {
    Vector::new(S::length(x), S::length(y), S::length(z))
}

/// Returns the veil of the ray, red, green and blue.
fn veil<S: Narrow>(case: &Case) -> [f64; 3] {
    let one = S::unit(1.0);
    let [r, g, b] = case.extinction.map(|s| <S as Narrow>::power(s * core::f64::consts::LOG2_E));
    let medium = Medium {
        fog: Fog { density: Rgb::new(r, g, b), glow: Rgb::new(S::light(0.0), S::light(0.0), S::light(0.0)) },
        albedo: S::unit(case.albedo),
        phase: Phase { forward: S::unit(case.forward) },
        halvings: 8,
        shadows: case.shadow.is_some(),
        reach: None,
        fades: false,
    };
    let lamp = Lamp::new(
        vector::<S>(case.lamp),
        S::length(0.0),
        <S as Narrow>::power(case.power),
        Rgb::new(one, one, one),
    );
    let lamps = [Lamp { fall_off: case.fall_off, ..lamp }];
    let zero = S::unit(0.0);
    let start = Start { origin: vector::<S>([0.0; 3]), direction: Vector::new(zero, one, zero) };
    let length = S::length(case.length);
    let way = Way {
        kind: RayKind::Primary,
        start,
        length: Some(length),
        surface: None,
        shift: None,
        lamps: &lamps,
    };
    let lit = |place: Vec3<S>, _| {
        let is_dark = case.shadow.is_some_and(|shadow| place.y().to_f64() > shadow);
        if is_dark { zero } else { one }
    };
    let passage = medium.passage::<Everything>(&way, Some(length), lit).expect("it does something");
    let Rgb { r, g, b } = passage.veil.map(S::light_to_f64);
    [r, g, b]
}

/// Returns the integral of its definition: w s E p exp(-s (t + r)) / 4 over the ray, with E = P / r^2, or P without the way from the
/// lamp for a constant lamp.
fn integral(case: &Case) -> [f64; 3] {
    const STEPS: u32 = 200_000;
    let width = case.length / f64::from(STEPS);
    case.extinction.map(|s| {
        let mut sum = 0.0;
        for step in 0..STEPS {
            let t = (f64::from(step) + 0.5) * width;
            if case.shadow.is_some_and(|shadow| t > shadow) {
                continue;
            }
            let [x, y, z] = case.lamp;
            let ahead = y - t;
            let away = (x * x + ahead * ahead + z * z).sqrt();
            let g = case.forward;
            let phase = (1.0 - g * g) / (1.0 + g * g - 2.0 * g * ahead / away).powf(1.5);
            let arrived = match case.fall_off {
                FallOff::Square => case.power / (away * away) * (-s * away).exp(),
                FallOff::Constant => case.power,
                FallOff::OfModel => case.power.min(1.0),
            };
            sum += case.albedo * s * phase * arrived * (-s * t).exp() / 4.0 * width;
        }
        sum
    })
}

fn check(case: &Case, tolerance: f64) {
    let want = integral(case);
    let all = [veil::<f64>(case), veil::<f32>(case), veil::<Q16>(case), veil::<Q20>(case)];
    for (got, format) in all.iter().zip(["f64", "f32", "q16", "q20"]) {
        // Radiances of fixed point are steps of 2^-16.
        let step = if format.starts_with('q') { 2.0 / 65536.0 } else { 1e-6 };
        for (got, want) in got.iter().zip(want) {
            assert_close!(*got, want, tolerance * want + step, "of a radiance in {format}");
        }
    }
}

#[test]
fn light_of_a_near_lamp_is_the_integral_over_the_ray() {
    let red = [0.3, 0.1, 0.02];
    for case in [
        CASE,
        Case { extinction: red, albedo: 0.4, ..CASE },
        Case { forward: 0.6, ..CASE },
        Case { forward: -0.3, extinction: red, ..CASE },
        // The lamp is behind the ray's start, and beyond its end.
        Case { lamp: [0.5, -2.0, 0.0], forward: 0.4, ..CASE },
        Case { lamp: [0.0, 12.0, 1.5], forward: 0.4, ..CASE },
    ] {
        check(&case, 1e-3);
    }
}

#[test]
fn light_of_a_constant_lamp_is_the_integral_over_the_ray() {
    let constant = Case { fall_off: FallOff::Constant, power: 0.8, ..CASE };
    for case in [
        constant,
        Case { forward: 0.6, extinction: [0.5, 0.1, 0.0], ..constant },
        // Of the model, it is cut to 1.
        Case { fall_off: FallOff::OfModel, power: 40_000.0, ..CASE },
    ] {
        check(&case, 1e-3);
    }
}

#[test]
fn shadows_take_the_light_of_the_places_that_lie_in_them() {
    for fall_off in [FallOff::Square, FallOff::Constant] {
        let case = Case { fall_off, power: 2.0, shadow: Some(4.3), ..CASE };
        // A shadow's edge is found to one of the 256 places.
        check(&case, 0.03);
        let whole = integral(&Case { shadow: None, ..case });
        assert!(whole[0] > 1.5 * integral(&case)[0], "the shadow matters");
    }
}

#[test]
fn a_medium_that_scatters_nothing_is_fog() {
    assert_eq!(veil::<f64>(&Case { albedo: 0.0, ..CASE }), [0.0; 3]);
}
