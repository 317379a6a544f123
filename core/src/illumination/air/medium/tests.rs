//! The light of one lamp that a medium scatters into a ray, against exact values, with and without a shaft of light or shadow.

use super::Medium;
use crate::color::Rgb;
use crate::illumination::Way;
use crate::illumination::air::{Air, Fog};
use crate::illumination::fade::Phase;
use crate::light::{FallOff, Lamp};
use crate::needs::Everything;
use crate::ray::{RayKind, Start};
use crate::scalar::read::{Read, place};
use crate::scalar::vector::{UnitVec3, UnitVector, Vec3, Vector};
use crate::scalar::{Positive, Scalar, Unit};
use crate::{Q16, Q20};

/// A number of 0 or more.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "to the nearest")]
fn number<S: Scalar>(value: f64) -> S::Power {
    S::Power::new((value * f64::from(1u32 << 31) + 0.5) as u64, -31)
}

/// A ray along y, and a lamp of the intensity 1000 at the height 2 over 0. What is scattered is .1 for each unit of length.
#[derive(Clone, Copy)]
struct Case {
    extinction: f64,
    halvings: u8,
    kind: RayKind,
    /// Where the lamp's light passes, along y.
    lit: [f64; 2],
    /// Where the ray starts.
    start: f64,
    length: f64,
}

const CASE: Case = Case {
    extinction: 0.15,
    halvings: 4,
    kind: RayKind::Primary,
    lit: [-3.0, 5.0],
    start: -3.0,
    length: 8.0,
};

/// Returns what is scattered into the ray, for an intensity of 1 as a radiance: over pi.
fn veil<S: Read>(case: Case) -> f64 {
    let (one, density) = (S::Unit::ONE, number::<S>(case.extinction * core::f64::consts::LOG2_E));
    let medium = Medium::<S> {
        fog: Fog { density: Rgb::new(density, density, density), glow: Rgb::BLACK },
        albedo: S::unit(0.1 / case.extinction),
        phase: Phase { forward: S::Unit::ZERO },
        halvings: case.halvings,
        shadows: true,
        fades: false,
    };
    let lamp = Lamp::<S>::white(place::<S>([2.0, 0.0, 0.0]), S::ZERO, 1000);
    let lamps = [Lamp { fall_off: FallOff::Square, ..lamp }];
    let start = Start { origin: place::<S>([0.0, case.start, 0.0]), direction: UnitVec3::<S>::Y };
    let way =
        Way { kind: case.kind, start, length: Some(S::length(case.length)), surface: None, lamps: &lamps };
    let lit = |place: Vec3<S>, _| {
        let y = S::far(place.y());
        if y > case.lit[0] && y < case.lit[1] { one } else { S::Unit::ZERO }
    };
    let passage = medium.passage::<Everything>(&way, S::length(case.length), lit).expect("it scatters");
    S::shine(passage.veil.r) / 1000.0 / core::f64::consts::PI
}

/// Checks a value in all formats: in f64 within the part `error` of it, in the others within `rounding` of f64's.
fn check(case: Case, exact: f64, error: f64) {
    let own = veil::<f64>(case);
    assert!((own / exact - 1.0).abs() < error, "{own}, not {exact}: {}", own / exact - 1.0);
    for (got, rounding, name) in
        [(veil::<f32>(case), 1e-6, "f32"), (veil::<Q16>(case), 1e-5, "q16"), (veil::<Q20>(case), 1e-5, "q20")]
    {
        assert!((got / own - 1.0).abs() < rounding, "{name}: {got}, {own}: {}", got / own - 1.0);
    }
}

#[test]
fn a_lamp_beside_a_ray_lights_the_air() {
    // Nothing is taken, as nearly as may be; then with an extinction, by 16 places, 32 and 64.
    check(
        Case { extinction: 0.1, ..CASE },
        veil::<f64>(Case { extinction: 0.1, halvings: 12, ..CASE }),
        2e-3,
    );
    for (halvings, error) in [(4, 2e-3), (5, 5e-4), (6, 1.3e-4), (10, 1e-6)] {
        check(Case { halvings, ..CASE }, 0.003_702_455, error);
    }
}

#[test]
fn shafts_are_lit_and_cut_out() {
    let shaft = Case { halvings: 12, lit: [-1.0, 0.5], ..CASE };
    check(shaft, 0.001_369_009, 1e-3);
    let cut = veil::<f64>(Case { halvings: 12, ..CASE }) - veil::<f64>(shaft);
    assert!((cut - 0.002_333_446).abs() < 2e-6, "{cut}");
    // With few places the ends of the shaft are wrong by up to a place.
    let few = veil::<f64>(Case { halvings: 4, ..shaft }) / 0.001_369_009 - 1.0;
    assert!(few.abs() < 0.2 && few.abs() > 1e-3, "{few}");
}

#[test]
fn rays_that_do_not_come_from_the_eye_see_no_shadows_in_the_air() {
    let shaft = Case { lit: [-1.0, 0.5], ..CASE };
    let whole = veil::<f64>(CASE);
    for kind in [RayKind::Reflected, RayKind::Transmitted] {
        assert!((veil::<f64>(Case { kind, ..shaft }) - whole).abs() < 1e-12);
    }
    assert!(veil::<f64>(shaft) < 0.6 * whole);
}

#[test]
fn a_lamp_behind_a_ray_may_be_farther_from_its_end_than_lengths_are() {
    let long = Case { start: 20.0, length: 2040.0, lit: [0.0, 3000.0], ..CASE };
    let [own, short] = [veil::<f64>(long), veil::<Q20>(long)];
    assert!(own > 0.0 && (short / own - 1.0).abs() < 5e-3, "{short}, not {own}");
}
