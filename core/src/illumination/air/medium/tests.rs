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
    /// `None` where it meets nothing.
    length: Option<f64>,
    reach: Option<f64>,
    shift: Option<f64>,
    fall_off: FallOff,
}

const CASE: Case = Case {
    extinction: 0.15,
    halvings: 4,
    kind: RayKind::Primary,
    lit: [-3.0, 5.0],
    start: -3.0,
    length: Some(8.0),
    reach: None,
    shift: None,
    fall_off: FallOff::Square,
};

/// Returns what is scattered into the ray, for an intensity of 1 as a radiance: over pi.
fn veil<S: Read>(case: Case) -> f64 {
    passage::<S>(case)[0]
}

/// Returns that, and the part of the ray's light that is left.
fn passage<S: Read>(case: Case) -> [f64; 2] {
    let (one, density) = (S::Unit::ONE, number::<S>(case.extinction * core::f64::consts::LOG2_E));
    let medium = Medium::<S> {
        fog: Fog { density: Rgb::new(density, density, density), glow: Rgb::BLACK },
        albedo: S::unit(0.1 / case.extinction),
        phase: Phase { forward: S::Unit::ZERO },
        halvings: case.halvings,
        shadows: true,
        reach: case.reach.map(S::length),
        fades: false,
    };
    let lamp = Lamp::<S>::white(place::<S>([2.0, 0.0, 0.0]), S::ZERO, 1000);
    let lamps = [Lamp { fall_off: case.fall_off, ..lamp }];
    let start = Start { origin: place::<S>([0.0, case.start, 0.0]), direction: UnitVec3::<S>::Y };
    let (length, shift) = (case.length.map(S::length), case.shift.map(S::unit));
    let way = Way { kind: case.kind, start, length, surface: None, shift, lamps: &lamps };
    let lit = |place: Vec3<S>, _| {
        let y = S::far(place.y());
        if y > case.lit[0] && y < case.lit[1] { one } else { S::Unit::ZERO }
    };
    let Some(passage) = medium.passage::<Everything>(&way, length, lit) else { return [0.0, 1.0] };
    [S::shine(passage.veil.r) / 1000.0 / core::f64::consts::PI, S::read(passage.weight.r)]
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
    // Middles of equal parts of the angle err less than those of equal parts of the ray, .0020 with 8, .00050, .00013, .000031.
    for (halvings, error) in [(4, 5.0e-4), (5, 1.3e-4), (6, 3.1e-5), (10, 1e-6)] {
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
    let long = Case { start: 20.0, length: Some(2040.0), lit: [0.0, 3000.0], ..CASE };
    let [own, short] = [veil::<f64>(long), veil::<Q20>(long)];
    assert!(own > 0.0 && (short / own - 1.0).abs() < 5e-3, "{short}, not {own}");
}

/// A constant lamp is one of the irradiance pi times its intensity.
#[test]
fn a_shaft_of_sunlight_is_seen() {
    for halvings in [4, 6] {
        let sun = Case {
            extinction: 0.2,
            halvings,
            lit: [2.0, 5.0],
            start: 0.0,
            fall_off: FallOff::Constant,
            ..CASE
        };
        check(sun, 0.012_033_729, 5e-8);
    }
    let left = [
        passage::<f64>(Case { extinction: 0.2, length: Some(6.0), ..CASE })[1],
        passage::<f32>(Case { extinction: 0.2, length: Some(6.0), ..CASE })[1],
        passage::<Q16>(Case { extinction: 0.2, length: Some(6.0), ..CASE })[1],
        passage::<Q20>(Case { extinction: 0.2, length: Some(6.0), ..CASE })[1],
    ];
    for (left, error) in left.into_iter().zip([5e-10, 1e-7, 5e-9, 5e-9]) {
        assert!((left - 0.301_194_212).abs() < error, "{left}");
    }
}

#[test]
fn a_medium_ends_at_its_reach() {
    let short = passage::<f64>(Case { length: Some(5.0), ..CASE });
    for length in [None, Some(5.0), Some(8.0)] {
        assert_eq!(passage::<f64>(Case { length, reach: Some(5.0), ..CASE }), short);
    }
    let within = Case { length: Some(3.0), ..CASE };
    assert_eq!(passage::<f64>(Case { reach: Some(5.0), ..within }), passage::<f64>(within));
    // Without it a ray that meets nothing shows the sky as it is.
    assert_eq!(passage::<Q16>(Case { length: None, ..CASE }), [0.0, 1.0]);
    let [whole, cut] =
        [None, Some(8.0)].map(|length| passage::<Q16>(Case { length, reach: Some(5.0), ..CASE }));
    assert_eq!(whole, cut);
}

/// Returns the mean over steps that are shifted by as much for each of 256 shifts, evenly.
fn shifted<S: Read>(case: Case) -> f64 {
    let one = |shift: u32| veil::<S>(Case { shift: Some((f64::from(shift) + 0.5) / 256.0), ..case });
    (0..256).map(one).sum::<f64>() / 256.0
}

#[test]
fn the_mean_of_shifted_steps_has_no_error_of_steps() {
    for fall_off in [FallOff::Square, FallOff::Constant] {
        let case = Case { fall_off, ..CASE };
        let exact = veil::<f64>(Case { halvings: 13, ..case });
        let mean = shifted::<f64>(case);
        assert!((mean / exact - 1.0).abs() < 2e-5, "{mean}, {exact}");
        // The ends of a shaft, too, which steps in their middles miss by a fifth of one.
        let shaft = Case { lit: [-1.0, 0.55], ..case };
        let exact = veil::<f64>(Case { halvings: 13, ..shaft });
        let [mean, few] = [shifted::<f64>(shaft), veil::<f64>(shaft)].map(|own| (own / exact - 1.0).abs());
        assert!(mean < 1e-3 && few > 5.0 * mean, "{mean} {few}");
        for (got, name) in
            [(shifted::<f32>(shaft), "f32"), (shifted::<Q16>(shaft), "q16"), (shifted::<Q20>(shaft), "q20")]
        {
            let own = shifted::<f64>(shaft);
            assert!((got / own - 1.0).abs() < 2e-5, "{name}: {got}, {own}");
        }
    }
    // A shift of a half is the middle.
    let [middle, half] = [None, Some(0.5)].map(|shift| veil::<f64>(Case { shift, ..CASE }));
    assert!((middle / half - 1.0).abs() < 1e-12, "{middle} {half}");
    // Without shadows there is nothing to shift.
    let mirrored = Case { kind: RayKind::Reflected, ..CASE };
    assert_eq!(veil::<f64>(Case { shift: Some(0.1), ..mirrored }), veil::<f64>(mirrored));
}
