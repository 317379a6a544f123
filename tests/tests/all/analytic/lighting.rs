//! Direct and ambient light on a surface, in each model.

#![allow(clippy::indexing_slicing, reason = "arrays of three")]

use rta_core::illumination::{Illumination, Rta, Whitted};
use rta_core::light::Incident;
use rta_core::material::Material;
use rta_core::scene::Scene;
use rta_tests::assert_close;
use rta_tests::measure::{Measure, direction, light, place};

use super::{
    BLACK, COSINE, RADIANCE, WHITE, assert_light, dark, dot, floor, lamp, minus, see, sphere, tolerance,
};

in_every_format! {
    lit_plane ambient_by_direction lamp_seen whitted attenuation glint solid_angle
}

fn lit_plane<S: Measure>() {
    let tint = [0.8, 0.5, 0.2];
    let (position, intensity, ambient) = ([1.0, 2.0, 6.0], [60.0, 45.0, 20.0], [0.1, 0.2, 0.3]);
    let lamps = [lamp::<S>(position, 0.0, intensity)];
    let scene =
        Scene { lamps: &lamps, floor: Some(floor(tint, tint)), ambient: light::<S>(ambient), ..dark::<S>() };
    let eye = [8.0, -7.0, 5.0];
    for target in [[-1.5, 2.2, 0.0], [1.0, 2.0, 0.0], [4.0, -3.0, 0.0], [-12.0, 9.0, 0.0]] {
        let to_lamp = minus(position, target);
        let d = dot(to_lamp, to_lamp).sqrt();
        // Upwards the ambient term is (1 + 1.5) 0.4 = 1.
        let want = [0, 1, 2].map(|i| tint[i] * (intensity[i] * (to_lamp[2] / d) / (d * d) + ambient[i]));
        assert_light::<S>(see(scene, Rta, 0, eye, minus(target, eye)), want, &format!("at {target:?}"));
    }
}

fn ambient_by_direction<S: Measure>() {
    for material in [Material::Opaque, Material::Shiny] {
        let ball = [sphere::<S>([0.0, 0.0, 3.0], 1.0, [0.8, 0.4, 0.2])];
        let materials = [material];
        let scene = Scene {
            spheres: &ball,
            materials: &materials,
            ambient: light::<S>([0.5, 1.0, 2.0]),
            ..dark::<S>()
        };
        // (n.z + 1.5) 0.4
        for (from, factor) in [([0.0, 0.0, 5.0], 1.0), ([0.0, -5.0, 0.0], 0.6), ([0.0, 0.0, -5.0], 0.2)] {
            let eye = [from[0], from[1], from[2] + 3.0];
            let got = see(scene, Rta, 5, eye, minus([0.0; 3], from));
            assert_light::<S>(got, [0.4 * factor; 3], &format!("seen from {from:?}"));
        }
    }
}

fn lamp_seen<S: Measure>() {
    for radius in [0.5, 2.0, 3.0] {
        let lamps = [lamp::<S>([0.0, 9.0, 0.0], radius, [50.0, 20.0, 5.0])];
        let scene = Scene { lamps: &lamps, ..dark::<S>() };
        let got = see(scene, Rta, 0, [0.3, 0.0, 0.2], [0.0, 1.0, 0.0]);
        for (got, intensity) in got.into_iter().zip([50.0, 20.0, 5.0]) {
            let want = intensity / (radius * radius);
            assert_close!(
                got,
                want,
                tolerance::<S>().max(2.0 * S::LIGHT * want),
                RADIANCE,
                "radius {radius}"
            );
        }
        assert_eq!(see(scene, Rta, 0, [radius + 0.01, 0.0, 0.0], [0.0, 1.0, 0.0]), BLACK);
    }
    let lamps = [lamp::<S>([0.0, 9.0, 0.0], 0.0, [50.0; 3])];
    let scene = Scene { lamps: &lamps, ..dark::<S>() };
    assert_eq!(see(scene, Rta, 0, [0.0; 3], [0.0, 1.0, 0.0]), BLACK, "radius 0 is never seen");
}

/// Returns the radiance of the top of a unit sphere, seen at 40 degrees from the normal, with a lamp on the other side.
fn on_top<S: Measure>(
    model: impl Illumination<S>,
    material: Material<S>,
    tint: [f64; 3],
    lamp_degrees: f64,
    distance: f64,
    intensity: [f64; 3],
) -> [f64; 3] {
    let ball = [sphere([0.0, 0.0, -1.0], 1.0, tint)];
    let materials = [material];
    let (sine, cosine) = lamp_degrees.to_radians().sin_cos();
    let lamps = [lamp::<S>([-distance * sine, 0.0, distance * cosine], 0.0, intensity)];
    let (sine, cosine) = 40.0_f64.to_radians().sin_cos();
    let ambient = light::<S>([0.1, 0.2, 0.3]);
    let scene = Scene { spheres: &ball, materials: &materials, lamps: &lamps, ambient, ..dark::<S>() };
    see(scene, model, 5, [5.0 * sine, 0.0, 5.0 * cosine], [-sine, 0.0, -cosine])
}

fn whitted<S: Measure>() {
    let model = |ka: f64, shine: f64, exponent: u16| Whitted::<S> {
        ka: S::unit(ka),
        shine: S::unit(shine),
        exponent: exponent.into(),
    };
    let (tint, intensity, ambient) = ([0.9, 0.5, 0.1], [0.8, 0.4, 0.6], [0.1, 0.2, 0.3]);
    for degrees in [0.0_f64, 25.0, 40.0, 70.0] {
        // The halfway vector lies between 40 degrees on one side and these on the other.
        let (nl, nh) = (degrees.to_radians().cos(), ((40.0 - degrees) / 2.0).to_radians().cos());
        for (ka, shine, exponent) in [(1.0, 0.2, 50), (0.5, 0.4, 20), (0.5, 1.0, 1), (1.0, 0.0, 7)] {
            let got = on_top::<S>(model(ka, shine, exponent), Material::Shiny, tint, degrees, 8.0, intensity);
            let highlight = nh.powi(exponent.into());
            let want = [0, 1, 2].map(|i| {
                ambient[i] * tint[i] * ka
                    + (1.0 - shine) * nl * tint[i] * intensity[i]
                    + shine * highlight * intensity[i]
            });
            let case = format!("lamp at {degrees} degrees, ka {ka}, ks {shine}, n {exponent}");
            assert_light::<S>(got, want, &case);
        }
        let got = on_top::<S>(model(0.5, 0.4, 20), Material::Opaque, tint, degrees, 8.0, intensity);
        let want = [0, 1, 2].map(|i| tint[i] * (ambient[i] * 0.5 + nl * intensity[i]));
        assert_light::<S>(got, want, &format!("opaque, lamp at {degrees} degrees"));
    }
}

fn attenuation<S: Measure>() {
    let (tint, cosine) = ([0.9, 0.5, 0.1], 70.0_f64.to_radians().cos());
    for distance in [2.0, 4.0, 8.0] {
        let got = on_top::<S>(Rta, Material::Opaque, tint, 70.0, distance, [3.0, 2.0, 1.0]);
        let want = [(3.0, 0.1), (2.0, 0.2), (1.0, 0.3)].map(|(i, a)| i * cosine / (distance * distance) + a);
        let want = [0, 1, 2].map(|i| tint[i] * want[i]);
        assert_light::<S>(got, want, &format!("Rta, lamp {distance} away"));
        let model = Whitted::<S>::default();
        // Above 1 an intensity counts as 1, the other registers in proportion.
        let got = on_top::<S>(model, Material::Opaque, tint, 70.0, distance, [3.0, 1.5, 0.0]);
        let want = [tint[0] * (cosine + 0.1), tint[1] * (0.5 * cosine + 0.2), tint[2] * 0.3];
        assert_light::<S>(got, want, &format!("Whitted, lamp {distance} away"));
    }
}

/// Within 13 degrees of the reflected ray a lamp is seen with its full intensity, whatever its distance and the
/// surface's colour.
fn glint<S: Measure>() {
    let (tint, intensity, ambient) = ([0.9, 0.5, 0.1], [0.8, 0.4, 0.6], [0.1, 0.2, 0.3]);
    for (offset, inside) in [(0.0_f64, true), (12.95, true), (-12.95, true), (13.05, false), (-13.05, false)]
    {
        for material in [Material::Shiny, Material::Opaque] {
            let degrees = 40.0 + offset;
            let got = on_top::<S>(Rta, material, tint, degrees, 8.0, intensity);
            let want = [0, 1, 2].map(|i| {
                let diffuse = intensity[i] * degrees.to_radians().cos() / 64.0 * tint[i];
                let is_glint = inside && material == Material::Shiny;
                ambient[i] * tint[i] + if is_glint { intensity[i] } else { diffuse }
            });
            assert_light::<S>(got, want, &format!("{offset} degrees off, {material:?}"));
        }
    }
}

fn solid_angle<S: Measure>() {
    for (radius, distance, want) in [
        (0.0, 5.0, 0.0),
        // A sphere that is seen under 60 degrees covers (1 - cos 30) / 2 of all there is.
        (2.5, 5.0, (1.0 - 0.75_f64.sqrt()) / 2.0),
        (3.0, 5.0, 0.1),
        (4.0, 5.0, 0.2),
        (5.0, 5.0, 0.5),
        (6.0, 5.0, 0.5),
    ] {
        let lamp = lamp::<S>([0.0, 3.0, 4.0], radius, WHITE);
        let incident = Incident::new(&lamp, place::<S>([0.0; 3]), direction::<S>([0.0, 0.0, 1.0]));
        let incident = incident.expect("not at the lamp's centre");
        let case = format!("radius {radius} at {distance}");
        assert_close!(S::unit_to_f64(incident.solid_angle()), want, 4.0 * S::UNIT, "of the sphere", "{case}");
        assert_close!(incident.distance.to_f64(), distance, S::LENGTH, "units", "{case}");
        assert_close!(S::unit_to_f64(incident.cosine), 0.8, 4.0 * S::UNIT, COSINE, "{case}");
    }
}
