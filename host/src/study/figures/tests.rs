//! Values of the curves that are stated elsewhere, most of them in the formulas' own documents.
#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use super::Content;
use super::list::ALL;

/// Figure, curve, argument, value, and how far the value may be off: curves are drawn from point to point.
const STATED: &[(&str, &str, f64, f64, f64)] = &[
    ("refraction", "water", 589.3, 1.333_349_06, 1e-6),
    ("refraction", "fused-quartz", 589.3, 1.458_402_72, 1e-6),
    ("refraction", "dense-flint", 450.0, 1.681_382_66, 1e-8),
    ("refraction", "crown", 450.0, 1.529_422_87, 1e-8),
    ("refraction", "rock-salt", 650.0, 1.540_755_27, 1e-8),
    ("refraction", "ethyl-alcohol", 500.0, 1.365_21, 1e-8),
    ("refraction", "carbon-disulfide", 589.3, 1.628_086_42, 1e-6),
    ("distributions", "power", 10.0, 0.5, 1e-3),
    ("distributions", "gauss", 10.0, 0.5, 1e-3),
    ("distributions", "trowbridge", 10.0, 0.5, 1e-3),
    ("distributions", "beckmann", 10.0, 0.5, 1e-3),
    ("mach-bands", "p = 1 (Lambert)", 0.5, 0.6, 1e-9),
    ("mach-bands", "p = 1.25", 0.5, 0.552_268_925, 1e-8),
    ("mach-bands", "p = 1.5", -0.25, 0.3, 1e-9),
    // Half of the way from 0 to 50 degrees: the mean of two cosines, and the cosine of the mean.
    ("gouraud-phong", "Gouraud", 0.383_022_221_6, 0.883_079_22, 1e-4),
    ("gouraud-phong", "Phong", 0.383_022_221_6, 0.974_370_06, 1e-4),
    ("gouraud-phong", "flat", 0.383_022_221_6, 0.974_370_06, 1e-8),
    ("gouraud-phong", "the cylinder", 0.0, 0.978_147_6, 1e-6),
    ("mesh-error", "Gouraud: N^-1.91", 3.0, -1.9928, 1e-3),
    ("masking", "Torrance, Sparrow", 60.0, 1.0, 1e-9),
    ("masking", "Sancer, m = .3", 30.0, 0.999_637_329, 1e-8),
    ("fresnel-glasses", "crown (1.52)", 0.0, 0.042_579_995, 1e-9),
    ("fresnel-glasses", "crown (1.52)", 80.0, 0.390_949_863, 1e-3),
    ("fresnel-glasses", "water (1.3334)", 90.0, 1.0, 1e-9),
    ("fresnel-metals", "gold, red", 0.0, 0.924_012_058, 1e-8),
    ("fresnel-metals", "gold, blue", 60.0, 0.438_398_952, 1e-5),
    ("fresnel-metals", "copper, green", 90.0, 1.0, 1e-9),
    ("fresnel-green", "silver", 0.0, 0.982892734, 1e-8),
    ("fresnel-green", "iron", 90.0, 1.0, 1e-9),
    ("attenuation", "warnock", 20.0, 0.5, 1e-9),
    ("attenuation", "romney 2", 20.0, 0.25, 1e-9),
    ("attenuation", "romney 4", 20.0, 0.0625, 1e-9),
    ("attenuation", "haze 10 40", 17.5, 0.75, 1e-9),
    ("attenuation", "fog .04", 25.0, 0.367_879_441, 1e-6),
];

#[test]
fn curves_go_through_stated_values() {
    for &(figure, name, x, stated, error) in STATED {
        let Content::Curves(curves) = ALL.iter().find(|f| f.name == figure).expect(figure).content else {
            panic!("{figure} has no curves")
        };
        let curve = curves().curves.into_iter().find(|curve| curve.name == name).expect(name);
        let pair =
            curve.points.windows(2).find(|pair| (pair[0].0..=pair[1].0).contains(&x)).expect("in range");
        let way = (x - pair[0].0) / (pair[1].0 - pair[0].0);
        let drawn = pair[0].1 + (pair[1].1 - pair[0].1) * way;
        assert!((drawn - stated).abs() <= error, "{figure}, {name} at {x}: {drawn}, not {stated}");
    }
}

#[test]
fn every_diagram_has_a_stated_value_and_shows_its_curves_whole() {
    for figure in ALL {
        let Content::Curves(curves) = figure.content else { continue };
        assert!(STATED.iter().any(|(name, ..)| *name == figure.name), "{}", figure.name);
        let chart = curves();
        for curve in &chart.curves {
            let is_shown = |&(x, y): &(f64, f64)| {
                (chart.x.range.start..=chart.x.range.end).contains(&x)
                    && (chart.y.range.start..=chart.y.range.end).contains(&y)
            };
            assert!(curve.points.iter().all(is_shown), "{}, {}", figure.name, curve.name);
        }
    }
}
