//! The bounds of the numbers that models of illumination form on the way, which are stated where they are formed: they hold at the
//! extremes of what goes in, in every number format. `bounds` measures those of the range proof.

use core::f64::consts::FRAC_1_SQRT_2;

use rta_core::color::Rgb;
use rta_core::illumination::CookTorrance;
use rta_core::illumination::fade::{Phase, airlight};
use rta_core::illumination::fresnel::{Conductor, Shift, dielectric};
use rta_core::illumination::microfacet::{
    Attenuation, Beckmann, Distribution, Facet, Gauss, Power, Roughness, Sancer, Slope, TorranceSparrow,
    Trowbridge,
};
use rta_core::illumination::table::Tabled;
use rta_core::light::{FallOff, Lamp};
use rta_core::needs::Everything;
use rta_core::scalar::{Exponent, Unit};
use rta_core::trace::decision::direct;
use rta_core::{Q16, Q20};
use rta_scenes::description::{self, Kind, Material};
use rta_scenes::narrow::Narrow;
use rta_tests::measure::{Measure, direction, read_light};
use rta_tests::point::Point;

/// Calls a generic function in each number format.
macro_rules! in_all_formats {
    ($function:ident) => {
        $function::<f64>();
        $function::<f32>();
        $function::<Q16>();
        $function::<Q20>();
    };
}

/// Shares from 0 to 1: the ends, steps of a fixed-point format and less, and what lies between.
fn shares() -> impl Iterator<Item = f64> + Clone {
    let small = (1..=31).map(|k| 2f64.powi(-k));
    let even = (0..=20).map(|i| f64::from(i) / 20.0);
    small.clone().chain(small.map(|part| 1.0 - part)).chain(even)
}

fn roughness<S: Narrow>(m: f64) -> [Roughness<S::Unit>; 1] {
    [Roughness { share: S::Unit::ONE, inverse: <S as Narrow>::power(1.0 / m) }]
}

/// The slopes that models are made for.
const SLOPES: [f64; 8] = [0.01, 0.02, 0.05, 0.1, 0.3, 0.7, 0.708, 1.0];

#[test]
fn reflectances_are_shares() {
    fn check<S: Measure>() {
        let is_share = |part: S::Unit| (0.0..=1.0 + 4.0 * S::UNIT).contains(&S::unit_to_f64(part));
        for (one, other) in shares().flat_map(|one| shares().map(move |other| (one, other))) {
            let (q, cosine) = (S::unit(one), S::unit(other));
            for denser in [false, true] {
                let part = dielectric(q, denser, cosine);
                assert!(is_share(part), "{}: q {one} {denser}, cosine {other}: {part:?}", S::NAME);
            }
            let shift = Shift::new(q);
            for f0 in [0.0, 0.5, 0.999, 1.0] {
                let part = shift.reflectance(S::unit(f0), cosine);
                assert!(is_share(part), "{}: {f0} of {one}, cosine {other}: {part:?}", S::NAME);
            }
        }
        for n in [0.01, 0.2, 1.0, 3.0, 1000.0] {
            for k in [0.0, 1e-6, 0.5, n, 8.0, 1e4] {
                let sum: f64 = n * n + k * k + 1.0;
                let metal = Conductor {
                    difference: S::unit((n * n - k * k) / sum),
                    product: S::unit(2.0 * n * k / sum),
                    scale: S::unit(sum.sqrt().recip()),
                };
                for cosine in shares() {
                    let part = metal.reflectance(S::unit(cosine));
                    assert!(is_share(part), "{}: n {n}, k {k}, cosine {cosine}: {part:?}", S::NAME);
                }
            }
        }
    }
    in_all_formats!(check);
}

#[test]
fn nothing_enters_along_the_surface_of_what_is_infinitely_dense() {
    fn check<S: Measure>() {
        for (q, cosine) in [(0.0, 0.0), (2f64.powi(-16), 2f64.powi(-16)), (2f64.powi(-30), 2f64.powi(-17))] {
            for denser in [false, true] {
                let part = S::unit_to_f64(dielectric(S::unit(q), denser, S::unit(cosine)));
                assert!(part == 1.0, "{}: q {q} {denser}, cosine {cosine}: {part}", S::NAME);
            }
        }
    }
    in_all_formats!(check);
}

/// Returns the angles between normal and facet, as the tangent of half of it: up to 90 degrees, more where there are more facets.
fn slopes<S: Measure>() -> impl Iterator<Item = Slope<S::Unit>> {
    let steps = (0..=400).map(|i| (f64::from(i) / 400.0).powi(3)).chain([1.0 - 1e-6, 1.0 - 1e-9]);
    steps.map(|half| {
        let normal = direction::<S>([0.0, 0.0, 1.0]);
        Slope::between(normal, direction::<S>([2.0 * half, 0.0, 1.0 - half * half]))
    })
}

#[test]
fn facets_are_no_more_than_their_distribution_allows() {
    fn check<S: Measure>() {
        let of = S::power_to_f64;
        for slope in slopes::<S>() {
            for m in SLOPES {
                let density = of(Beckmann(&roughness::<S>(m)).density(&slope));
                // Rounding is a part of the value, as these numbers have an exponent.
                let most =
                    if m <= FRAC_1_SQRT_2 { 1.0 } else { 4.0 * m.powi(4) * (1.0 / (m * m) - 2.0).exp() };
                let whole = density * m * m;
                assert!(
                    (0.0..=most * (1.0 + 1e-6)).contains(&whole),
                    "{}, m {m}, {slope:?}: {whole}",
                    S::NAME
                );
                assert!(whole <= 1.4716, "{}, m {m}, {slope:?}: {whole}", S::NAME);
            }
            for c in [0.01, 0.1, 0.5, 1.0] {
                let trowbridge = of(Trowbridge { roundness: S::unit(c) }.density(&slope));
                let range = c.powi(4) * (1.0 - 1e-5)..=1.0 + 1e-5;
                let is_in = range.contains(&trowbridge) || slope.cosine <= S::Unit::ZERO;
                assert!(is_in, "{}, c {c}, {slope:?}: {trowbridge}", S::NAME);
                let gauss = of(Gauss { narrowness: <S as Narrow>::power(1.0 / c) }.density(&slope));
                assert!((0.0..=1.0).contains(&gauss), "{}, c {c}, {slope:?}: {gauss}", S::NAME);
            }
            for n in [1, 50, 1000] {
                let power = of(Power(Exponent::new(n, 0)).density(&slope));
                assert!((0.0..=1.0).contains(&power), "{}, n {n}, {slope:?}: {power}", S::NAME);
            }
        }
    }
    in_all_formats!(check);
}

/// Returns the facets between directions that lie from high above the surface down to it, on the side of the mirror or elsewhere.
fn facets<S: Measure>() -> Vec<Facet<S::Unit>> {
    let heights = || [1.0, 0.7, 0.1, 1e-2, 1e-3, 9e-4, 1e-4, 1e-6, 2e-9];
    let at = |height: f64, around: f64| {
        let (sine, cosine) = around.to_radians().sin_cos();
        let flat = (1.0 - height * height).max(0.0).sqrt();
        direction::<S>([flat * cosine, flat * sine, height])
    };
    let pairs = heights().into_iter().flat_map(|light| heights().map(|view| (light, view)));
    let places =
        pairs.flat_map(|(light, view)| [0.0, 90.0, 179.0, 180.0].map(|around| (light, view, around)));
    let normal = direction::<S>([0.0, 0.0, 1.0]);
    places
        .filter_map(|(light, view, around)| Facet::between::<S>(normal, at(light, 0.0), at(view, around)))
        .collect()
}

#[test]
fn rough_surfaces_send_back_what_is_stated_at_most() {
    fn check<S: Measure>() {
        let facets = facets::<S>();
        assert!(facets.len() > 200, "{}", facets.len());
        let mut most: f64 = 0.0;
        for facet in &facets {
            for m in SLOPES {
                let slopes = roughness::<S>(m);
                let bound = if m <= FRAC_1_SQRT_2 { 256.0 } else { 377.0 } / (m * m) * (1.0 + 1e-5);
                let grooves = facet.balanced_reflectance(&Beckmann(&slopes), &TorranceSparrow, S::Unit::ONE);
                let hidden = facet.balanced_reflectance(&Beckmann(&slopes), &Sancer(&slopes), S::Unit::ONE);
                for reflectance in [grooves, hidden].map(S::power_to_f64) {
                    assert!(
                        (0.0..=bound).contains(&reflectance),
                        "{}, m {m}: {reflectance} {facet:?}",
                        S::NAME
                    );
                    most = most.max(reflectance * m * m);
                }
            }
            // Blinn's, of facets that all face one way: G / (N.V).
            let even = Trowbridge { roundness: S::Unit::ONE };
            let all = S::power_to_f64(facet.reflectance(&even, &TorranceSparrow, S::Unit::ONE));
            let [slope, incidence] = [facet.slope.cosine, facet.incidence].map(S::unit_to_f64);
            let passed = S::unit_to_f64(TorranceSparrow.passed(facet));
            assert!(all <= 1024.0 * (1.0 + 1e-5), "{}: {all} {facet:?}", S::NAME);
            let bound = (2.0 * slope / incidence).min(1024.0) * (1.0 + 1e-5) + 1024.0 * 4.0 * S::UNIT;
            assert!(all <= bound && passed <= 1.0, "{}: {all}, {bound} {facet:?}", S::NAME);
        }
        assert!(most > 200.0, "the bound is not tried: {most}");
    }
    in_all_formats!(check);
}

#[test]
fn the_brightest_highlight_saturates() {
    fn check<S: Measure>(largest: f64) {
        let material = Material {
            kind: Kind::Metal,
            metal: Some([0.999; 3]),
            slopes: vec![description::Slope { slope: 0.01, share: 1.0 }],
            ..Material::default()
        };
        let model = CookTorrance::default();
        let rows = [model.row(&material)];
        let point = Point::<S>::new([0.0, 0.0, 1.0], [1.0, 0.0, 1e-3], [-1.0, 0.0, 1e-3]);
        let point = Point { number: 0, ..point };
        for (length, radius) in [(S::length(1.0), 0.0), (S::length(1e-3), 0.0), (S::length(1e-3), 1.0)] {
            let radius = S::length(radius);
            let lamp = Lamp {
                power: <S as Narrow>::power(1e9),
                radius,
                inverse_radius: radius.inverse(),
                fall_off: FallOff::Square,
                ..Point::lamp()
            };
            let incident = point.incident(&lamp, length);
            let light: Rgb<S::Light> =
                direct::<S, _, Everything>(&model.over(&rows), &point.surface(), &incident);
            for register in read_light::<S>(light) {
                assert!(register >= largest && register.is_finite(), "{}: {register}", S::NAME);
            }
        }
    }
    let all = 32_768.0 - 1.0 / 65_536.0;
    check::<Q16>(all);
    check::<Q20>(all);
    check::<f32>(1e14);
    check::<f64>(1e14);
}

#[test]
fn media_scatter_what_is_stated_at_most() {
    fn check<S: Measure>() {
        for g in [-0.9, -0.5, 0.0, 0.3, 0.9] {
            for cosine in shares().flat_map(|cosine| [cosine, -cosine]) {
                let p = S::power_to_f64(Phase { forward: S::unit(g) }.scattered(S::unit(cosine)));
                assert!((0.027..=190.01).contains(&p), "{}, g {g}, {cosine}: {p}", S::NAME);
            }
        }
        let lengths = [0.0, 1.0 / 256.0, 0.5, 3.0, 100.0, 2000.0];
        let ends = lengths.iter().flat_map(|&length| [-length, length]);
        for (from, to) in ends.clone().flat_map(|from| ends.clone().map(move |to| (from, to))) {
            for height in [1.0 / 256.0, 0.1, 1.0, 40.0, 2000.0].into_iter().filter(|_| from < to) {
                for s in [1e-6, 0.1, 1.0, 100.0] {
                    let [h, t0, t1] = [height, from, to].map(S::length);
                    let light = S::power_to_f64(airlight::<S>(<S as Narrow>::power(s), h, t0, t1, 4));
                    let bound = s * (to - from) / (4.0 * height * height);
                    let case = format!("{}, s {s}, {height}, {from} to {to}", S::NAME);
                    assert!((0.0..=bound * (1.0 + 1e-5)).contains(&light), "{case}: {light}, {bound}");
                }
            }
        }
    }
    in_all_formats!(check);
}
