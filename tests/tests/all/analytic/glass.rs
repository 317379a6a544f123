//! Mirrors and glass: Snell's law, total reflection, and where the light goes.

#![allow(clippy::indexing_slicing, reason = "arrays of three")]

use rta_core::illumination::Rta;
use rta_core::material::Material;
use rta_core::scene::{Scene, Sky};
use rta_core::surface::Surface;
use rta_core::trace::decision::refract;
use rta_core::vector::UnitVector;
use rta_tests::assert_close;
use rta_tests::measure::{Measure, color, direction, light, place, read_direction};

use super::{BLACK, COSINE, WHITE, assert_light, dark, glass, see, sphere};

in_every_format! {
    snell total_internal_reflection nothing_leaves_beyond_the_critical_angle mirror glass_keeps_all_light
}

/// Returns the direction in which a ray goes on that falls at `degrees` on a horizontal face of glass; nothing where it
/// is totally reflected.
fn refracted<S: Measure>(degrees: f64, ior: f64, inside: bool) -> Option<[f64; 3]> {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let glass = glass::<S>(0.0, ior);
    let surface = Surface {
        point: place::<S>(BLACK),
        normal: direction::<S>([0.0, 0.0, 1.0]),
        face: None,
        incoming: direction::<S>([sine, 0.0, -cosine]),
        distance: S::length(1.0),
        inside,
        extent: S::ZERO,
        color: color::<S>(WHITE),
        material: &Material::Transparent(glass),
        surroundings: false,
        mesh: None,
        number: 0,
    };
    refract(&surface, &glass).map(read_direction::<S>)
}

fn snell<S: Measure>() {
    let cases =
        [(1.5, false), (1.5, true), (1.0 / 1.5, false), (1.0 / 1.5, true), (1.33, true), (1.0, false)];
    for (ior, inside) in cases {
        for degrees in [0.0, 30.0_f64, 60.0] {
            let sine = degrees.to_radians().sin() * if inside { ior } else { 1.0 / ior };
            let case = format!("{degrees} degrees, index {ior}, inside {inside}");
            let Some([x, y, z]) = refracted::<S>(degrees, ior, inside) else {
                assert!(sine > 1.0, "{case}: reflected");
                continue;
            };
            assert!(sine < 1.0, "{case}: not reflected");
            let few = 8.0 * S::UNIT;
            assert_close!(x, sine, few, COSINE, "{case}");
            assert_close!(y, 0.0, few, COSINE, "{case}");
            assert_close!(z, -(1.0 - sine * sine).sqrt(), few, COSINE, "{case}");
        }
    }
}

fn total_internal_reflection<S: Measure>() {
    for (ior, inside) in [(1.5_f64, true), (1.0 / 1.5, false), (1.1, true)] {
        let ratio: f64 = if inside { ior } else { 1.0 / ior };
        let critical = (1.0 / ratio).asin().to_degrees();
        let case = format!("index {ior}, critical angle {critical}");
        let below = critical - 0.01;
        let [x, _, z] = refracted::<S>(below, ior, inside).expect(&case);
        let sine = ratio * below.to_radians().sin();
        let cosine = (1.0 - sine * sine).sqrt();
        // A rounding of the sine is one of the cosine times tan = 50 and more.
        assert_close!(x, sine, 8.0 * S::UNIT, COSINE, "{case}");
        assert_close!(z, -cosine, 8.0 * S::UNIT / cosine, COSINE, "{case}");
        assert_eq!(refracted::<S>(critical + 0.01, ior, inside), None, "{case}");
    }
}

/// In a sphere all meetings with the surface are at one angle, so a ray is totally reflected at all of them or at none.
fn nothing_leaves_beyond_the_critical_angle<S: Measure>() {
    let ball = [sphere([0.0; 3], 2.0, WHITE)];
    let materials = [Material::Transparent(glass::<S>(0.1, 1.5))];
    let uniform = Sky { horizon: light::<S>(WHITE), zenith: light::<S>(WHITE) };
    let scene = Scene { spheres: &ball, materials: &materials, sky: uniform, ..dark::<S>() };
    let at = |sine: f64, depth| see(scene, Rta, depth, [0.0, 0.0, 2.0 * sine], [1.0, 0.0, 0.0]);
    for depth in [1, 5, 16] {
        assert_eq!(at(0.675, depth), BLACK, "depth {depth}");
        // What leaves at the first, second, ... meeting with the surface.
        let want = 1.0 - 0.1_f64.powi(i32::try_from(depth).expect("small"));
        assert_light::<S>(at(0.66, depth), [want; 3], &format!("depth {depth}"));
    }
}

fn mirror<S: Measure>() {
    for degrees in [0.0_f64, 30.0, 60.0, 89.0] {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let incoming = direction::<S>([sine, 0.0, -cosine]);
        let reflected = read_direction::<S>(incoming.reflect(direction::<S>([0.0, 0.0, 1.0])));
        for (got, want) in reflected.into_iter().zip([sine, 0.0, cosine]) {
            assert_close!(got, want, 2.0 * S::UNIT, COSINE, "{degrees} degrees");
        }
    }
    // A mirror ball that is met at an angle shows the sky at twice that elevation.
    let tint = [0.9, 0.6, 0.3];
    let ball = [sphere([0.0, 0.0, 3.0], 1.0, tint)];
    let sky = Sky { horizon: light::<S>([0.2, 0.0, 1.0]), zenith: light::<S>([1.0, 0.5, 0.0]) };
    let scene = Scene { spheres: &ball, materials: &[Material::Mirror], sky, ..dark::<S>() };
    for degrees in [0.0_f64, 15.0, 30.0, 45.0, 60.0] {
        let angle = degrees.to_radians();
        let s = (2.0 * angle).sin().powi(2);
        let want = [tint[0] * (0.2 * (1.0 - s) + s), tint[1] * 0.5 * s, tint[2] * (1.0 - s)];
        let got = see(scene, Rta, 1, [0.0, -6.0, 3.0 + angle.sin()], [0.0, 1.0, 0.0]);
        assert_light::<S>(got, want, &format!("met at {degrees} degrees"));
        assert_eq!(see(scene, Rta, 0, [0.0, -6.0, 3.0 + angle.sin()], [0.0, 1.0, 0.0]), BLACK);
    }
}

/// Through one glass sphere under a sky of radiance 1 all light arrives that the depth does not cut off. Outside, ks is
/// reflected; inside, kt leaves at each meeting: depth D leaves out kt ks^(D - 1).
fn glass_keeps_all_light<S: Measure>() {
    let uniform = Sky { horizon: light::<S>(WHITE), zenith: light::<S>(WHITE) };
    for (ks, ior) in [(0.3_f64, 1.5), (0.12, 1.52), (0.3, 1.0)] {
        let ball = [sphere([0.0; 3], 1.0, WHITE)];
        let materials = [Material::Transparent(glass::<S>(ks, ior))];
        let scene = Scene { spheres: &ball, materials: &materials, sky: uniform, ..dark::<S>() };
        for height in [0.0, 0.3, 0.9] {
            for depth in [0, 1, 2, 5, 16] {
                let missing = if depth == 0 { 1.0 } else { (1.0 - ks) * ks.powi(depth - 1) };
                let depth = u32::try_from(depth).expect("small");
                let got = see(scene, Rta, depth, [0.0, -5.0, height], [0.0, 1.0, 0.0]);
                assert_light::<S>(
                    got,
                    [1.0 - missing; 3],
                    &format!("ks {ks}, height {height}, depth {depth}"),
                );
            }
        }
    }
}
