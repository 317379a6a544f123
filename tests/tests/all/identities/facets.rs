//! Identities of small mirrors: how they hide each other, and what they reflect.

use rta_core::illumination::fresnel::{Conductor, Shift, dielectric, f0, index, inverse_index};
use rta_core::illumination::microfacet::{Attenuation, Roughness, Sancer, TorranceSparrow};
use rta_core::scalar::Unit;
use rta_core::{Q16, Q20};
use rta_scenes::narrow::Narrow;
use rta_tests::assert_close;
use rta_tests::measure::Measure;

use super::{CASES, dice, directions, dot, facet, in_all_formats, unit};

#[test]
fn grooves_and_slopes_hide_the_same_from_both_sides() {
    fn check<S: Measure>() {
        let mut dice = dice();
        for _ in 0..CASES {
            let [normal, light, view] = directions::<S>(&mut dice);
            let m = dice.choice([0.01, 0.1, 0.3, 1.0]).expect("one of them");
            let slopes = [Roughness { share: S::Unit::ONE, inverse: <S as Narrow>::power(1.0 / m) }];
            let passed = |light, view| {
                let facet = facet::<S>([normal, light, view])?;
                Some([TorranceSparrow.passed(&facet), Sancer(&slopes).passed(&facet)].map(unit::<S>))
            };
            let case = format!("{} {normal:?} {light:?} {view:?}, m {m}", S::NAME);
            let [one, other] = [passed(light, view), passed(view, light)];
            for (one, other) in one.into_iter().flatten().zip(other.into_iter().flatten()) {
                assert!((0.0..=1.0).contains(&one), "{case}: {one}");
                let incidence = f64::midpoint(1.0, dot(light, view)).max(1e-6);
                assert_close!(one, other, 16.0 * S::UNIT / incidence, "of the facets", "{case}");
            }
            for whole in passed(normal, normal).expect("they are above") {
                assert_close!(whole, 1.0, 4.0 * S::UNIT, "of the facets", "{case}");
            }
        }
    }
    in_all_formats!(check);
}

#[test]
fn nothing_is_seen_along_the_surface_but_in_the_direction_of_a_mirror() {
    fn check<S: Measure>() {
        let at = |cosine: f64, side: f64| [side * (1.0 - cosine * cosine).sqrt(), 0.0, cosine];
        let slopes = [Roughness { share: S::Unit::ONE, inverse: <S as Narrow>::power(1.0 / 0.3) }];
        let flat = 1e-5;
        for (light, view, grooves) in [
            (at(flat, 1.0), at(0.8, 1.0), 0.0),
            (at(0.6, -1.0), at(flat, 1.0), 0.0),
            (at(flat, 1.0), at(flat, -1.0), 1.0),
        ] {
            let facet = facet::<S>([[0.0, 0.0, 1.0], light, view]).expect("they are above");
            let passed = unit::<S>(TorranceSparrow.passed(&facet));
            assert_close!(passed, grooves, 1e-4, "of the facets", "{}", S::NAME);
            assert_close!(
                unit::<S>(Sancer(&slopes).passed(&facet)),
                0.0,
                2e-4,
                "of the facets",
                "{}",
                S::NAME
            );
        }
    }
    in_all_formats!(check);
}

#[test]
fn at_brewsters_angle_only_one_polarisation_is_reflected() {
    fn check<S: Measure>() {
        for eta in [1.1_f64, 1.33, 1.5, 2.4, 10.0] {
            // tan = eta; rs = (eta^2 - 1) / (eta^2 + 1).
            let cosine = S::unit((1.0 + eta * eta).sqrt().recip());
            let reflected = unit::<S>(dielectric(S::unit(1.0 / eta), true, cosine));
            let wanted = 0.5 * ((eta * eta - 1.0) / (eta * eta + 1.0)).powi(2);
            assert_close!(reflected, wanted, 32.0 * S::UNIT, "of the light", "{}, {eta}", S::NAME);
        }
    }
    in_all_formats!(check);
}

#[test]
fn reflectances_at_right_angles_give_indices_and_back() {
    for reflectance in [0.0, 1e-6, 0.02, 0.04, 0.25, 0.6, 0.955, 0.999] {
        let eta: f64 = index(reflectance);
        let none: f64 = 0.0;
        assert_close!(f0(eta, none), reflectance, 1e-12, "of the light", "{reflectance}");
        let q = inverse_index(reflectance);
        assert_close!(eta * q, 1.0, 1e-12, "of an index", "{reflectance}");
        assert_close!(dielectric(q, true, 1.0), reflectance, 1e-12, "of the light", "{reflectance}");
    }
}

#[test]
fn a_metal_that_absorbs_nothing_is_glass() {
    fn check<S: Measure>() {
        for eta in [0.4, 0.66, 1.01, 1.33, 2.417, 10.0] {
            let sum: f64 = eta * eta + 1.0;
            let metal = Conductor {
                difference: S::unit(eta * eta / sum),
                product: S::Unit::ZERO,
                scale: S::unit(sum.sqrt().recip()),
            };
            for cosine in [1.0, 0.9, 0.7, 0.4, 0.1] {
                let glass = dielectric(S::unit(eta.min(1.0 / eta)), eta > 1.0, S::unit(cosine));
                let metal = unit::<S>(metal.reflectance(S::unit(cosine)));
                let case = format!("{}, {eta}, {cosine}", S::NAME);
                assert_close!(metal, unit::<S>(glass), 64.0 * S::UNIT, "of the light", "{case}");
            }
        }
    }
    in_all_formats!(check);
}

#[test]
fn coloured_metals_are_white_along_the_surface_and_grey_ones_follow_fresnel() {
    fn check<S: Measure>() {
        for mean in [0.0, 0.04, 0.3, 0.7, 0.95] {
            let shift = Shift::new(S::unit(mean));
            for f0 in [0.0, 0.04, 0.5, 0.999] {
                let at = |cosine: f64| unit::<S>(shift.reflectance(S::unit(f0), S::unit(cosine)));
                let case = format!("{}, {f0} of {mean}", S::NAME);
                let tolerance = 64.0 * S::UNIT / (1.0 - mean);
                assert_close!(at(1.0), f0, tolerance, "of the light", "{case}");
                assert_close!(at(0.0), 1.0, tolerance, "of the light", "{case}");
            }
            for cosine in [0.9, 0.5, 0.1] {
                let own = unit::<S>(shift.reflectance(S::unit(mean), S::unit(cosine)));
                // Of an index above 3.7 the reflectance first falls; the approximation does not.
                let wanted = unit::<S>(dielectric(shift.q, true, S::unit(cosine))).max(mean);
                assert_close!(own, wanted, 16.0 * S::UNIT, "of the light", "{}, {mean}", S::NAME);
            }
        }
    }
    in_all_formats!(check);
}
