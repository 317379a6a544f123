//! The curves of the figures: the functions of `rta values`, which are those of the core that pictures are made with, along one of
//! their arguments.

use core::ops::Range;

use rta_core::color::Rgb;
use rta_core::needs::Everything;
use rta_core::ray::Ray;
use rta_core::shape::{Primitive, Triangle};
use rta_core::vector::{UnitVec3, Vec3, Vector};
use rta_scenes::rta;

use super::chart::{Axis, Chart, Curve, Ink};
use crate::study::values::value;

const ANGLE: Range<f64> = 0.0..90.0;
const REGISTERS: [(&str, Ink); 3] = [("red", Ink::Red), ("green", Ink::Green), ("blue", Ink::Blue)];

/// Figure 2.5: the index of refraction over the wavelength, of materials that every scene knows.
pub(super) fn refraction() -> Chart {
    let over = 400.0..700.0;
    let glasses = [
        ("dense-flint", Ink::Red),
        ("carbon-disulfide", Ink::Orange),
        ("rock-salt", Ink::Purple),
        ("crown", Ink::Blue),
        ("fused-quartz", Ink::Green),
        ("ethyl-alcohol", Ink::Sky),
        ("water", Ink::Black),
    ];
    let index = |name: &str, nm: f64| rta::built_in(name).and_then(|material| material.at(nm).index);
    let curve = |(name, ink)| Curve::of(name, ink, &over, |nm| index(name, nm).unwrap_or(f64::NAN));
    Chart {
        title: "Index of refraction over the wavelength",
        x: Axis { name: "wavelength (nm)", range: over.clone() },
        y: Axis { name: "index of refraction", range: 1.3..1.75 },
        curves: glasses.map(curve).into(),
    }
}

/// Figure 2.8: the distributions of facets with half of their facets at one angle.
pub(super) fn distributions() -> Chart {
    const GLOSS: f64 = 10.0;
    let over = 0.0..45.0;
    let kinds = [
        ("trowbridge", "d_tr", "c_tr", Ink::Green),
        ("power", "d_power", "n_blinn", Ink::Blue),
        ("gauss", "d_gauss", "c_gauss", Ink::Red),
        ("beckmann", "d_beckmann", "m_beckmann", Ink::Black),
    ];
    let curve = |(name, density, parameter, ink)| {
        let (density, parameter) = (value(density), value(parameter)(&[GLOSS]));
        let whole = density(&[parameter, 0.0]);
        Curve::of(name, ink, &over, move |angle| density(&[parameter, angle]) / whole)
    };
    let mut curves: Vec<_> = kinds.map(curve).into();
    curves = curves.into_iter().map(|c| if c.name == "gauss" { c.dashed() } else { c }).collect();
    Chart {
        title: "Distributions of facets, gloss 10",
        x: Axis { name: "angle of the facet's and the surface's normals (degrees)", range: over },
        y: Axis { name: "facets, as a part of those at 0", range: 0.0..1.0 },
        curves,
    }
}

/// Figure 3.2: what a sphere that is lit from the right sends back, from its dark side to its bright edge.
pub(super) fn mach_bands() -> Chart {
    let over = -0.5..1.0;
    let powers =
        [("p = 1 (Lambert)", 1.0, Ink::Black), ("p = 1.25", 1.25, Ink::Red), ("p = 1.5", 1.5, Ink::Blue)];
    let curve = |(name, power, ink)| {
        let light = value("bouknight");
        Curve::of(name, ink, &over, move |x: f64| light(&[0.3, 0.6, power, x.acos().to_degrees()]))
    };
    Chart {
        title: "The terminator with and without an exponent",
        x: Axis { name: "place on a sphere of radius 1, 0 at the terminator", range: over.clone() },
        y: Axis { name: "light, ka = .3, kd = .6", range: 0.2..1.0 },
        curves: powers.map(curve).into(),
    }
}

/// The direction at an angle from the vertical, in the plane of x and z.
fn leaning(degrees: f64) -> UnitVec3<f64> {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    Vector::new(sine, 0.0, cosine)
}

/// Figure 3.4: N.L along a line across two triangles that stand for a cylinder, by interpolated cosines and interpolated normals.
pub(super) fn gouraud() -> Chart {
    const LAMP: f64 = 12.0;
    const EDGES: [f64; 3] = [-50.0, 0.0, 50.0];
    let over = EDGES[0].to_radians().sin()..EDGES[2].to_radians().sin();
    let lamp = leaning(LAMP);
    let facet = |x: f64| if x < 0.0 { (EDGES[0], EDGES[1]) } else { (EDGES[1], EDGES[2]) };
    // A triangle from edge to edge, above which the line runs at y = 0, and the hit of a ray from above at x.
    let hit = move |x: f64| {
        let (from, to) = facet(x);
        let corner = |degrees: f64, y: f64| -> Vec3<f64> { leaning(degrees) + Vec3::<f64>::new(0.0, y, 0.0) };
        let triangle = Triangle::<f64> {
            vertices: [corner(from, -4.0), corner(to, 0.0), corner(from, 4.0)],
            extent: 9.0,
            normal: leaning(f64::midpoint(from, to)),
            normals: Some([leaning(from), leaning(to), leaning(from)]),
            one_sided: false,
            color: Rgb::new(1.0, 1.0, 1.0),
            material: 0,
        };
        let origin: Vec3<f64> = Vector::new(x, 0.0, 5.0);
        let ray = Ray::new(origin, -UnitVec3::<f64>::Z);
        (triangle, triangle.point::<Everything>(&ray, 5.0))
    };
    let lit = move |normal: UnitVec3<f64>| normal.dot(lamp).max(0.0);
    let flat = Curve::of("flat", Ink::Black, &over, |x| lit(hit(x).0.normal)).dotted();
    let gouraud = Curve::of("Gouraud", Ink::Red, &over, |x| {
        let (triangle, point) = hit(x);
        let [a, b, c] = triangle.weights(point.point);
        triangle.normals.map_or(f64::NAN, |[k, l, m]| a * lit(k) + b * lit(l) + c * lit(m))
    });
    let phong = Curve::of("Phong", Ink::Blue, &over, |x| lit(hit(x).1.normal));
    let round =
        Curve::of("the cylinder", Ink::Green, &over, |x| lit(leaning(x.asin().to_degrees()))).dashed();
    Chart {
        title: "Across the edge of two triangles",
        x: Axis { name: "place across a cylinder of radius 1, 0 at the edge", range: over.clone() },
        y: Axis { name: "N.L", range: 0.4..1.05 },
        curves: vec![phong, round, gouraud, flat],
    }
}

/// The attenuation of facets by facets, over the direction of the eye in the plane of the lamp.
pub(super) fn masking() -> Chart {
    const LAMP: f64 = 60.0;
    let over = -90.0..90.0;
    let around = |angle: f64| if angle < 0.0 { 0.0 } else { 180.0 };
    let grooves = value("g_ts");
    let grooves = Curve::of("Torrance, Sparrow", Ink::Black, &over, |angle: f64| {
        grooves(&[LAMP, angle.abs(), around(angle)])
    });
    let slopes = [(".3", 0.3, Ink::Blue), (".6", 0.6, Ink::Green), ("1", 1.0, Ink::Red)];
    let sancer = slopes.map(|(name, slope, ink)| {
        let passed = value("g_sancer");
        Curve::of(format!("Sancer, m = {name}"), ink, &over, move |angle: f64| {
            passed(&[LAMP, angle.abs(), slope])
        })
        .dashed()
    });
    Chart {
        title: "Facets neither in shadow nor hidden, lamp at 60 degrees",
        x: Axis { name: "angle of the eye, mirrored side on the right (degrees)", range: over.clone() },
        y: Axis { name: "G", range: 0.0..1.05 },
        curves: [vec![grooves], sancer.into()].concat(),
    }
}

/// Fresnel's reflectance of glasses.
pub(super) fn glasses() -> Chart {
    let glasses =
        [("diamond", Ink::Black), ("dense-flint", Ink::Red), ("crown", Ink::Blue), ("water", Ink::Green)];
    let curve = |(name, ink)| {
        let reflected = value("fresnel");
        let index = rta::built_in(name).and_then(|material| material.index).unwrap_or(f64::NAN);
        Curve::of(format!("{name} ({index})"), ink, &ANGLE, move |angle| reflected(&[index, angle]))
    };
    reflectance("Reflectance of glasses", glasses.map(curve).into())
}

/// Fresnel's reflectance of two metals in three registers.
pub(super) fn metals() -> Chart {
    let metal = |name: &'static str| {
        let nk = rta::built_in(name).and_then(|material| material.nk).unwrap_or([[f64::NAN; 2]; 3]);
        REGISTERS.into_iter().zip(nk).map(move |((register, ink), [n, k])| {
            let reflected = value("fresnel_k");
            Curve::of(format!("{name}, {register}"), ink, &ANGLE, move |angle| reflected(&[n, k, angle]))
        })
    };
    reflectance(
        "Reflectance of gold and copper",
        metal("gold").chain(metal("copper").map(Curve::dashed)).collect(),
    )
}

/// Fresnel's reflectance of five metals in green light.
pub(super) fn five_metals() -> Chart {
    let metals = [
        ("silver", Ink::Black),
        ("aluminium", Ink::Blue),
        ("gold", Ink::Purple),
        ("copper", Ink::Red),
        ("iron", Ink::Green),
    ];
    let curve = |(name, ink)| {
        let reflected = value("fresnel_k");
        let [_, [n, k], _] =
            rta::built_in(name).and_then(|material| material.nk).unwrap_or([[f64::NAN; 2]; 3]);
        Curve::of(name, ink, &ANGLE, move |angle| reflected(&[n, k, angle]))
    };
    reflectance("Reflectance of five metals in green light", metals.map(curve).into())
}

fn reflectance(title: &'static str, curves: Vec<Curve>) -> Chart {
    let (x, y) =
        (Axis { name: "angle of incidence (degrees)", range: ANGLE }, Axis { name: "F", range: 0.0..1.05 });
    Chart { title, x, y, curves }
}

/// What is left of light on a long way.
pub(super) fn attenuation() -> Chart {
    let over = 0.0..60.0;
    let faded = |power: f64| {
        let fade = value("fade");
        move |d: f64| fade(&[power, d, 10.0])
    };
    let (haze, fog) = (value("haze"), value("fog"));
    let curves = vec![
        Curve::of("warnock", Ink::Black, &over, faded(1.0)),
        Curve::of("fog .04", Ink::Green, &over, move |d| fog(&[0.04, d])).dotted(),
        Curve::of("romney 2", Ink::Blue, &over, faded(2.0)),
        Curve::of("romney 4", Ink::Red, &over, faded(4.0)),
        Curve::of("haze 10 40", Ink::Purple, &over, move |d| 1.0 - haze(&[d, 10.0, 40.0])).dashed(),
    ];
    Chart {
        title: "What is left of light on its way to the eye",
        x: Axis { name: "length of the ray, d0 = 10", range: over },
        y: Axis { name: "part of the light", range: 0.0..1.05 },
        curves,
    }
}
