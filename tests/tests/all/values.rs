//! The functions of the illumination models against the values of their specification, in every format.

use core::f64::consts::PI;

use rta::engine::Format;
use rta::values::{Comparison, compare, names, statements};
use rta_tests::assert_close;

/// The values of the specification, by its sections.
const VALUES: &str = include_str!("../../models.md");

fn assert_all_agree(format: Format) {
    let comparisons = compare(VALUES, format, None).expect("all are known");
    assert!(comparisons.len() > 195, "{} values", comparisons.len());
    let off: Vec<&Comparison> = comparisons.iter().filter(|comparison| !comparison.agrees).collect();
    assert!(off.is_empty(), "{format}: {off:#?}");
}

#[test]
fn values_agree_in_f64() {
    assert_all_agree(Format::F64);
}

#[test]
fn values_agree_in_f32() {
    assert_all_agree(Format::F32);
}

#[test]
fn values_agree_in_q16() {
    assert_all_agree(Format::Q16);
}

#[test]
fn values_agree_in_q20() {
    assert_all_agree(Format::Q20);
}

#[test]
fn every_function_has_a_value() {
    let stated: Vec<String> = statements(VALUES).into_iter().map(|stated| stated.name).collect();
    for name in names() {
        assert!(stated.iter().any(|stated| stated == name), "{name} has no value");
    }
}

#[test]
fn a_wrong_value_is_off_and_a_wrong_name_is_an_error() {
    let agrees = |text: &str, tolerance| {
        let comparisons = compare(text, Format::F64, tolerance).expect("a known function");
        comparisons.first().expect("one value").agrees
    };
    assert!(agrees("lambert(60) = .5", None));
    assert!(!agrees("lambert(60) = .50001", None));
    assert!(agrees("lambert(60) = .50001", Some(1e-3)));
    // An integral has its own bound, whatever is asked for.
    assert!(agrees("albedo(0,.3,1) = .9956", Some(0.0)));
    let message = |text: &str| compare(text, Format::F64, None).expect_err("it is wrong").to_string();
    let unknown = message("text\nfong(1) = 2");
    assert!(unknown.starts_with("line 2: there is no function fong; there are lamp, "), "{unknown}");
    assert_eq!(message("lambert(1,2) = 3"), "line 1: lambert has the arguments (tl), found 2 numbers");
}

/// Returns the value of a function in a format.
fn value(format: Format, call: &str) -> f64 {
    let comparisons = compare(&format!("{call} = 0"), format, None).expect("a known function");
    comparisons.first().expect("one value").computed
}

#[test]
fn mirrors_are_perfect_at_grazing_and_as_stated_at_right_angles() {
    for format in [Format::F64, Format::Q16] {
        for eta in [0.4, 0.66, 1.01, 1.33, 1.52, 2.417, 10.0] {
            assert_close!(
                value(format, &format!("fresnel({eta},90)")),
                1.0,
                1e-7,
                "of the light",
                "eta {eta}"
            );
            let (f0, straight) =
                (value(format, &format!("f0({eta},0)")), value(format, &format!("fresnel({eta},0)")));
            assert_close!(f0, straight, 1e-7, "of the light", "eta {eta}");
        }
        for k in [0.5, 2.0, 7.0] {
            assert_close!(
                value(format, &format!("fresnel_k(.6,{k},90)")),
                1.0,
                1e-7,
                "of the light",
                "k {k}"
            );
        }
    }
}

#[test]
fn cook_torrance_is_reciprocal() {
    for (light, view, around, m) in
        [(10, 60, 140, 0.3), (45, 80, 180, 0.5), (5, 30, 20, 0.2), (70, 71, 170, 0.1)]
    {
        for name in ["ct", "ct_sancer"] {
            let cosine = |degrees: i32| f64::from(degrees).to_radians().cos();
            let one = value(Format::F64, &format!("{name}({light},{view},{around},{m},.5)")) / cosine(light);
            let other = value(Format::F64, &format!("{name}({view},{light},{around},{m},.5)")) / cosine(view);
            assert_close!(one, other, 1e-11 * one.max(1.0), "of the reflectance", "{light}, {view}");
        }
    }
}

#[test]
fn rough_surfaces_return_no_more_than_they_get() {
    for m in [0.1, 0.2, 0.3, 0.4, 0.6] {
        for angle in [0, 45, 75, 88] {
            for kind in [1, 2] {
                let albedo = value(Format::F64, &format!("albedo({angle},{m},{kind})"));
                assert!((0.5..=1.001).contains(&albedo), "m {m}, {angle} degrees, {kind}: {albedo}");
            }
        }
    }
}

#[test]
fn facets_cover_the_surface_once() {
    for m in [0.05_f64, 0.2, 0.3, 0.6, 1.0] {
        // 1/pi of the integral of D cos over the hemisphere, of which facets steeper than 6 m are less than 1e-15.
        let steps = 4000;
        let step = (6.0 * m).atan().to_degrees() / f64::from(steps);
        let sum = (0..steps).map(|i| (f64::from(i) + 0.5) * step).map(|angle| {
            let (sine, cosine) = angle.to_radians().sin_cos();
            value(Format::F64, &format!("d_beckmann({m},{angle})")) * cosine * sine
        });
        assert_close!(2.0 * sum.sum::<f64>() * step.to_radians(), 1.0, 1e-6, "of the surface", "m {m}");
    }
}

#[test]
fn gloss_is_where_half_of_the_facets_are() {
    for angle in [3.0, 10.0, 30.0] {
        let of = |parameter: &str| value(Format::F64, &format!("{parameter}({angle})"));
        let part = |name: &str, parameter: f64| {
            let at = |angle: f64| value(Format::F64, &format!("{name}({parameter:.17},{angle})"));
            at(angle) / at(0.0)
        };
        let parts = [
            part("d_power", of("n_blinn")),
            part("d_gauss", of("c_gauss")),
            part("d_tr", of("c_tr")),
            part("d_beckmann", of("m_beckmann")),
        ];
        for part in parts {
            assert_close!(part, 0.5, 1e-6, "of the facets", "{angle} degrees");
        }
    }
}

#[test]
fn scattered_light_is_all_there() {
    for g in [-0.9, -0.3, 0.0, 0.6, 0.9] {
        let steps = 4000;
        let step = 180.0 / f64::from(steps);
        let sum = (0..steps)
            .map(|i| (f64::from(i) + 0.5) * step)
            .map(|angle| value(Format::F64, &format!("phase({g},{angle})")) * angle.to_radians().sin());
        assert_close!(sum.sum::<f64>() * step.to_radians() / 2.0, 1.0, 1e-5, "of the light", "g {g}");
    }
}

#[test]
fn thin_air_shows_the_angle_that_the_lamp_sees() {
    for format in [Format::F64, Format::F32, Format::Q16, Format::Q20] {
        for (height, from, to) in [(1.0, -50.0, 50.0), (0.5, 3.0, 4.0), (4.0, -100.0, -0.5), (2.0, 0.0, 9.0)]
        {
            let extinction = 1e-6;
            let angle = f64::atan(to / height) - f64::atan(from / height);
            let light = value(format, &format!("airlight({extinction},{height},{from},{to})"));
            let expected = extinction / (4.0 * height) * angle;
            assert_close!(
                light,
                expected,
                2e-4 * expected,
                "of a lamp",
                "{format}, {height}, {from} to {to}"
            );
        }
    }
}

#[test]
fn light_through_air_can_be_cut_where_one_likes() {
    // What a ray gathers up to a place, and what is left there of what it gathers beyond.
    let (s, height) = (0.3_f64, 0.7_f64);
    for (from, cut, to) in [(-3.0, -1.0, 5.0), (-3.0, 2.0, 2.5), (0.5, 1.0, 8.0)] {
        let gathered =
            |from: f64, to: f64| value(Format::F64, &format!("airlight({s},{height},{from},{to})"));
        let left = (-s * (cut - from)).exp();
        let parts = gathered(from, cut) + left * gathered(cut, to);
        assert_close!(parts, gathered(from, to), 1e-7 * parts, "of a lamp", "{from}, {cut}, {to}");
    }
}

#[test]
fn light_grows_from_nothing_at_the_edge_of_a_shadow() {
    // The slope at the terminator: kd for Lambert's cosine, 0 for any power above 1.
    let slope = |exponent: f64, cosine: f64| {
        let angle = cosine.acos().to_degrees();
        value(Format::F64, &format!("bouknight(0,.6,{exponent},{angle:.15})")) / cosine
    };
    assert_close!(slope(1.0, 1e-4), 0.6, 1e-9, "of kd");
    for exponent in [1.125, 1.25, 1.5, 2.0] {
        for cosine in [1e-2, 1e-4, 1e-6] {
            let expected = 0.6 * f64::powf(cosine, exponent - 1.0);
            assert_close!(slope(exponent, cosine), expected, 1e-7, "of kd", "power {exponent}");
        }
    }
}

#[test]
fn facets_refract_without_a_slope_by_snells_law() {
    for index in [1.1_f64, 1.33, 1.5, 2.4] {
        for view in [1.0_f64, 10.0, 20.0] {
            let light = (index * view.to_radians().sin()).asin().to_degrees();
            let slope = value(Format::F64, &format!("hall_h({light:.15},{view},180,{index})"));
            assert_close!(slope, 1.0, 1e-12, "of a cosine", "index {index}, {view} degrees");
        }
    }
}

#[test]
fn facets_fill_what_the_eye_sees_of_the_surface() {
    // 1/pi of the integral of D max(0, V.H) is the area of all facets that face the eye: more than N.V by what hides some.
    for (m, view) in [(0.2_f64, 20.0_f64), (0.3, 60.0), (0.5, 75.0), (0.3, 85.0)] {
        let (tilts, turns) = (1200, 1200);
        let step = (6.0 * m).atan() / f64::from(tilts);
        let turn = PI / f64::from(turns);
        let (sine, cosine) = view.to_radians().sin_cos();
        let mut sum = 0.0;
        for tilt in (0..tilts).map(|i| (f64::from(i) + 0.5) * step) {
            let density = value(Format::F64, &format!("d_beckmann({m},{:.15})", tilt.to_degrees()));
            let facing = |j: i32| {
                let around = (f64::from(j) + 0.5) * turn;
                (tilt.sin() * around.cos() * sine + tilt.cos() * cosine).max(0.0)
            };
            sum += density * tilt.sin() * (0..turns).map(facing).sum::<f64>();
        }
        // G with a lamp over the surface is 1 / (1 + U(N.V)).
        let seen = value(Format::F64, &format!("g_sancer(0,{view},{m})"));
        let area = 2.0 / PI * sum * step * turn;
        assert_close!(area * seen, cosine, 2e-6, "of the area", "m {m}, {view} degrees");
    }
}
