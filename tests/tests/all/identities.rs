//! Identities of the illumination models and of their parts: what holds whatever the numbers are. Those of stated values and
//! integrals are in `values`, those of whole pictures in `reductions`.

use core::f64::consts::PI;

use rta_core::color::Rgb;
use rta_core::illumination::fade::{Phase, fade, haze, transmittance};
use rta_core::illumination::microfacet::Facet;
use rta_core::illumination::{Blinn, Bouknight, Illumination, Lambert, Phong, Romney};
use rta_core::light::{FallOff, Lamp};
use rta_core::needs::Everything;
use rta_core::scalar::{Positive, Unit};
use rta_core::{Q16, Q20};
use rta_scenes::narrow::{Narrow, exponent};
use rta_tests::assert_close;
use rta_tests::measure::{Measure, direction, read_direction, read_light};
use rta_tests::point::{Point, above, random};

mod facets;
mod glass;

/// Random cases of each identity.
const CASES: usize = 2000;

/// Calls a generic function in each number format.
macro_rules! in_all_formats {
    ($function:ident) => {
        $function::<f64>();
        $function::<f32>();
        $function::<Q16>();
        $function::<Q20>();
    };
}
use in_all_formats;

fn dice() -> fastrand::Rng {
    fastrand::Rng::with_seed(1982)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Returns random unit vectors of a format: a normal and two directions above it.
fn directions<S: Measure>(dice: &mut fastrand::Rng) -> [[f64; 3]; 3] {
    let normal = random(dice);
    let (light, view) = (above(normal, dice), above(normal, dice));
    [normal, light, view].map(|v| read_direction::<S>(direction::<S>(v)))
}

fn facet<S: Measure>([normal, light, view]: [[f64; 3]; 3]) -> Option<Facet<S::Unit>> {
    Facet::between::<S>(direction::<S>(normal), direction::<S>(light), direction::<S>(view))
}

fn unit<S: Narrow>(value: S::Unit) -> f64 {
    S::unit_to_f64(value)
}

#[test]
fn cosines_of_the_halfway_vector_follow_from_those_of_lamp_and_eye() {
    fn check<S: Measure>() {
        let mut dice = dice();
        for _ in 0..CASES {
            let [normal, light, view] = directions::<S>(&mut dice);
            let Some(facet) = facet::<S>([normal, light, view]) else { continue };
            let incidence = f64::midpoint(1.0, dot(light, view)).sqrt();
            // Near L = -V, both sides lose digits.
            if incidence < 0.05 {
                continue;
            }
            let slope = (dot(normal, light) + dot(normal, view)) / (2.0 * incidence);
            let tolerance = 4.0 * S::UNIT / incidence.powi(2);
            assert!(S::UNIT > 1e-10 || tolerance < 1e-12, "f64 is held to 1e-12");
            let case = format!("{} {normal:?} {light:?} {view:?}", S::NAME);
            assert_close!(unit::<S>(facet.incidence), incidence, tolerance, "of V.H", "{case}");
            assert_close!(unit::<S>(facet.slope.cosine), slope, tolerance, "of N.H", "{case}");
            let sine_squared = S::power_to_f64(facet.slope.sine_squared);
            assert_close!(sine_squared, 1.0 - slope * slope, 2.0 * tolerance, "of a square", "{case}");
        }
    }
    in_all_formats!(check);
}

#[test]
fn a_lamp_lights_by_its_solid_angle() {
    fn check<S: Measure>() {
        let point = Point::<S>::new([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
        let distance = S::length(1.0);
        for radius in [0.001, 0.1, 0.5, 0.75, 0.99, 1.0] {
            let radius = S::length(radius);
            let fall_off = FallOff::Square;
            let lamp = Lamp { radius, inverse_radius: radius.inverse(), fall_off, ..Point::lamp() };
            let incident = point.incident(&lamp, distance);
            let one = <S as Narrow>::power(1.0);
            let light = incident.reflected::<Everything>(Rgb::new(one, one, one), true);
            let light = S::light_to_f64(light.r);
            // A full sphere is 4 pi; a lamp without size would cover pi q^2.
            let q = radius.to_f64();
            let wanted = 4.0 * unit::<S>(incident.solid_angle()) / (q * q);
            assert!((1.0..=2.0 + S::LIGHT).contains(&light), "{}: {light}", S::NAME);
            let tolerance = 2.0 * S::LIGHT + 8.0 * S::UNIT / (q * q);
            assert_close!(light, wanted, tolerance, "of an irradiance", "{}, radius {q}", S::NAME);
        }
    }
    in_all_formats!(check);
}

#[test]
fn attenuation_begins_and_ends_without_a_step() {
    fn check<S: Measure>() {
        let step = 4.0 * S::LENGTH;
        for (start, end) in [(0.25, 0.75), (2.0, 2.5), (10.0, 40.0)] {
            let sides = |at: f64| [at - step, at, at + step].map(S::length);
            for power in [1.0, 2.0, 3.5, 4.0, 100.0] {
                for d in sides(start) {
                    let left = unit::<S>(fade(d, S::length(start), exponent(power)));
                    let tolerance = power * (2.0 * step / start + 8.0 * S::UNIT) + 8.0 * S::UNIT;
                    assert_close!(left, 1.0, tolerance, "of the light", "{}, {power}", S::NAME);
                    let model = Romney { exponent: exponent(2.0), reference: S::length(start) };
                    let point = Point::<S>::new([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
                    let [light, ..] = ambient(&Point { distance: d, ..point }, &model);
                    let tolerance = 8.0 * (step / start + S::UNIT + S::LIGHT);
                    assert_close!(light, 1.0, tolerance, "of the light", "{}", S::NAME);
                }
            }
            for (at, wanted) in [(start, 0.0), (end, 1.0)] {
                for d in sides(at) {
                    let part = unit::<S>(haze(d, S::length(start), S::length(end)));
                    let tolerance = 2.0 * step / (end - start) + 8.0 * S::UNIT;
                    assert_close!(part, wanted, tolerance, "of the light", "{}, {at}", S::NAME);
                }
            }
        }
    }
    in_all_formats!(check);
}

/// Returns what a model sends back of a black surrounding's ambient light.
fn ambient<S: Measure>(point: &Point<S>, model: &impl Illumination<S>) -> [f64; 3] {
    let black = Rgb::BLACK;
    let light = model.ambient::<Everything>(&point.surface(), black);
    read_light::<S>(light)
}

#[test]
fn bouknights_surface_without_a_power_is_lamberts() {
    fn check<S: Measure>() {
        let mut dice = dice();
        let (ka, kd) = (S::Unit::ZERO, S::Unit::ONE);
        let bouknight = Bouknight { ka, kd, exponent: exponent(1.0) };
        for _ in 0..CASES {
            let [normal, light, view] = directions::<S>(&mut dice);
            let point = Point::<S>::new(normal, light, view);
            assert_eq!(point.lit(&bouknight), point.lit(&Lambert::default()), "{}: {point:?}", S::NAME);
        }
    }
    in_all_formats!(check);
}

#[test]
fn highlights_are_the_same_for_lamp_and_eye_exchanged_and_largest_in_the_mirrors_direction() {
    fn check<S: Measure>() {
        let mut dice = dice();
        for _ in 0..CASES {
            let [normal, light, view] = directions::<S>(&mut dice);
            let n = dice.choice([1.0, 3.5, 20.0, 300.0]).expect("one of them");
            let tolerance = 2.0 * S::LIGHT + 16.0 * n * S::UNIT;
            let lit = |light, view| {
                let point = Point::<S>::new(normal, light, view).finish(0.0, 1.0, n);
                [point.lit(&Phong::default()), point.lit(&Blinn::default())].map(|[r, ..]| r)
            };
            let twice = 2.0 * dot(normal, light);
            let ([nx, ny, nz], [lx, ly, lz]) = (normal, light);
            let mirrored = [twice * nx - lx, twice * ny - ly, twice * nz - lz];
            let [one, other, most] = [lit(light, view), lit(view, light), lit(light, mirrored)];
            for ((one, other), most) in one.into_iter().zip(other).zip(most) {
                let case = format!("{} {normal:?} {light:?} {view:?}, n {n}", S::NAME);
                assert_close!(one, other, tolerance, "of a highlight", "{case}");
                // Phong's is a square of the normal's length more sensitive.
                assert_close!(most, 1.0, 2.0 * tolerance, "of a highlight", "{case}");
                assert!(one <= 1.0 + tolerance, "{case}: {one}");
            }
        }
    }
    in_all_formats!(check);
}

#[test]
fn the_reflected_rays_angle_is_twice_that_of_the_facet_in_the_plane_of_incidence() {
    for (tl, tv) in [(0.0, 50.0), (10.0, 70.0), (40.0, 45.0), (80.0, 5.0)] {
        let at = |degrees: f64, side: f64| {
            let (sine, cosine) = f64::to_radians(degrees).sin_cos();
            [side * sine, 0.0, cosine]
        };
        let point = Point::<f64>::new([0.0, 0.0, 1.0], at(tl, 1.0), at(tv, -1.0)).finish(0.0, 1.0, 1.0);
        let [[reflected, ..], [halfway, ..]] = [point.lit(&Phong::default()), point.lit(&Blinn::default())];
        assert_close!(reflected.acos(), 2.0 * halfway.acos(), 1e-12, "of a radian", "{tl}, {tv}");
    }
}

#[test]
fn phongs_highlight_holds_a_lobes_share_of_the_light() {
    for n in [1.0, 10.0, 50.5, 200.0] {
        let steps = 2000;
        let step = PI / 2.0 / f64::from(steps);
        let sum = (0..steps).map(|i| (f64::from(i) + 0.5) * step).map(|angle| {
            let view = [angle.sin(), 0.0, angle.cos()];
            let point = Point::<f64>::new([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], view).finish(0.0, 1.0, n);
            point.lit(&Phong::default())[0] * angle.sin()
        });
        let sum = 2.0 * PI * step * sum.sum::<f64>();
        assert_close!(sum, 2.0 * PI / (n + 1.0), 1e-4 * sum, "of the light", "n {n}");
    }
}

#[test]
fn what_two_lengths_leave_of_the_light_is_what_their_sum_leaves() {
    fn check<S: Measure>() {
        for left in [1.0, 0.9, 0.5, 0.05, 2f64.powi(-31)] {
            let density = <S as Narrow>::power(-f64::log2(left));
            for (a, b) in [(0.25, 0.5), (1.0, 2.0), (0.0, 3.0), (10.0, 30.0)] {
                let of = |length: f64| transmittance::<S>(density, S::length(length));
                let (product, whole) = (unit::<S>(of(a).times(of(b))), unit::<S>(of(a + b)));
                // The error of the logarithm's product counts as such.
                let tolerance = 16.0 * S::UNIT * (1.0 - left.log2() * (a + b) * whole);
                assert_close!(product, whole, tolerance, "of the light", "{}, {left}, {a} and {b}", S::NAME);
            }
        }
    }
    in_all_formats!(check);
}

#[test]
fn air_that_absorbs_nothing_sends_on_or_scatters_all_light() {
    fn check<S: Measure>() {
        let even = Phase { forward: S::Unit::ZERO };
        for left in [0.0, 0.3, 0.99, 1.0] {
            for cosine in [-1.0, 0.2, 1.0] {
                // A lamp of the irradiance 4 on all of the ray.
                let veil = even.sunbeam(S::Unit::ONE, S::unit(cosine), S::unit(left));
                let sum = S::power_to_f64(veil.times(S::Power::new(4, 0))) + unit::<S>(S::unit(left));
                assert_close!(sum, 1.0, 8.0 * S::UNIT, "of the light", "{}, {left}", S::NAME);
            }
        }
    }
    in_all_formats!(check);
}
