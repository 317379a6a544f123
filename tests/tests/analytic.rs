//! Where the answer is known from a formula, in every number format.

#![allow(clippy::indexing_slicing)] // arrays of three

use rta_core::camera::{Camera, Lens};
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Rta, Surface, Whitted};
use rta_core::light::{Incident, Lamp};
use rta_core::material::{Glass, Material};
use rta_core::needs::Everything;
use rta_core::scene::{Floor, Scene, Sky};
use rta_core::shape::Sphere;
use rta_core::trace::{Tracer, refract};
use rta_core::vector::{UnitVector, Vector};
use rta_core::{Q16, Q20};
use rta_scenes::narrow::Narrow;
use rta_tests::assert_close;
use rta_tests::measure::{Measure, color, direction, light, place, read_direction, read_light};

/// Makes a test of a generic function for each number format.
macro_rules! in_every_format {
    ($($name:ident)*) => {$(
        mod $name {
            #[test]
            fn f32() {
                super::$name::<f32>();
            }
            #[test]
            fn f64() {
                super::$name::<f64>();
            }
            #[test]
            fn q16() {
                super::$name::<super::Q16>();
            }
            #[test]
            fn q20() {
                super::$name::<super::Q20>();
            }
        }
    )*};
}

in_every_format! {
    snell total_internal_reflection nothing_leaves_beyond_the_critical_angle mirror lit_plane ambient_by_direction
    sky shadow_of_a_sphere glass_keeps_all_light lamp_seen tiles whitted attenuation glint solid_angle far_floor
}

const BLACK: [f64; 3] = [0.0; 3];
const WHITE: [f64; 3] = [1.0; 3];
const RADIANCE: &str = "of white";
const COSINE: &str = "of a unit vector's component";

/// A few roundings of places some ten units away, and of light.
fn tolerance<S: Measure>() -> f64 {
    8.0 * (S::LENGTH + S::LIGHT)
}

/// Nothing, in the dark.
fn dark<S: Measure>() -> Scene<'static, S> {
    Scene {
        floor: None,
        sky: Sky { horizon: light::<S>(BLACK), zenith: light::<S>(BLACK) },
        ambient: light::<S>(BLACK),
        ..Scene::day()
    }
}

fn sphere<S: Measure>(center: [f64; 3], radius: f64, tint: [f64; 3], material: Material<S>) -> Sphere<S> {
    Sphere::new(place::<S>(center), S::length(radius), color::<S>(tint), material)
}

fn lamp<S: Measure>(position: [f64; 3], radius: f64, intensity: [f64; 3]) -> Lamp<S> {
    let most = intensity.into_iter().fold(0.0, f64::max);
    let (power, tint) = (<S as Narrow>::power(most), color::<S>(intensity.map(|register| register / most)));
    Lamp::new(place::<S>(position), S::length(radius), power, tint)
}

fn floor<S: Measure>(even: [f64; 3], odd: [f64; 3]) -> Floor<S> {
    Floor { colors: [color::<S>(even), color::<S>(odd)] }
}

fn glass<S: Measure>(ks: f64, ior: f64) -> Glass<S> {
    let eta = if ior > 1.0 { 1.0 / ior } else { ior };
    Glass { ks: S::unit(ks), kt: S::unit(1.0 - ks), eta: S::unit(eta), denser: ior >= 1.0 }
}

fn see<S: Measure>(
    scene: Scene<S>,
    model: impl Illumination<S>,
    depth: u32,
    eye: [f64; 3],
    towards: [f64; 3],
) -> [f64; 3] {
    let (eye, towards) = (place::<S>(eye), direction::<S>(towards));
    let camera = Camera::new(eye, towards, Lens::new(1, 1, (1, 1)));
    let admitted = scene.admit(&camera).expect("the scene fits");
    let tracer: Tracer<_, _, Everything, 16> = Tracer::new(admitted, model, depth).expect("it is no deeper");
    read_light::<S>(tracer.radiance(eye, towards))
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn assert_light<S: Measure>(got: [f64; 3], want: [f64; 3], case: &str) {
    for (got, want) in got.into_iter().zip(want) {
        assert_close!(got, want, tolerance::<S>(), RADIANCE, "{case}");
    }
}

/// What becomes of a ray that falls at `degrees` on a horizontal face of glass.
fn refracted<S: Measure>(degrees: f64, ior: f64, inside: bool) -> Option<[f64; 3]> {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let glass = glass::<S>(0.0, ior);
    let surface = Surface {
        point: place::<S>(BLACK),
        normal: direction::<S>([0.0, 0.0, 1.0]),
        incoming: direction::<S>([sine, 0.0, -cosine]),
        distance: S::length(1.0),
        inside,
        color: color::<S>(WHITE),
        material: &Material::Transparent(glass),
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

/// In a sphere a ray meets the surface at the same angle again and again.
fn nothing_leaves_beyond_the_critical_angle<S: Measure>() {
    let ball = [sphere([0.0; 3], 2.0, WHITE, Material::Transparent(glass::<S>(0.1, 1.5)))];
    let uniform = Sky { horizon: light::<S>(WHITE), zenith: light::<S>(WHITE) };
    let scene = Scene { spheres: &ball, sky: uniform, ..dark::<S>() };
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
    let ball = [sphere([0.0, 0.0, 3.0], 1.0, tint, Material::Mirror)];
    let sky = Sky { horizon: light::<S>([0.2, 0.0, 1.0]), zenith: light::<S>([1.0, 0.5, 0.0]) };
    let scene = Scene { spheres: &ball, sky, ..dark::<S>() };
    for degrees in [0.0_f64, 15.0, 30.0, 45.0, 60.0] {
        let angle = degrees.to_radians();
        let s = (2.0 * angle).sin().powi(2);
        let want = [tint[0] * (0.2 * (1.0 - s) + s), tint[1] * 0.5 * s, tint[2] * (1.0 - s)];
        let got = see(scene, Rta, 1, [0.0, -6.0, 3.0 + angle.sin()], [0.0, 1.0, 0.0]);
        assert_light::<S>(got, want, &format!("met at {degrees} degrees"));
        assert_eq!(see(scene, Rta, 0, [0.0, -6.0, 3.0 + angle.sin()], [0.0, 1.0, 0.0]), BLACK);
    }
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
        let ball = [sphere::<S>([0.0, 0.0, 3.0], 1.0, [0.8, 0.4, 0.2], material)];
        let scene = Scene { spheres: &ball, ambient: light::<S>([0.5, 1.0, 2.0]), ..dark::<S>() };
        // (n.z + 1.5) 0.4
        for (from, factor) in [([0.0, 0.0, 5.0], 1.0), ([0.0, -5.0, 0.0], 0.6), ([0.0, 0.0, -5.0], 0.2)] {
            let eye = [from[0], from[1], from[2] + 3.0];
            let got = see(scene, Rta, 5, eye, minus([0.0; 3], from));
            assert_light::<S>(got, [0.4 * factor; 3], &format!("seen from {from:?}"));
        }
    }
}

fn sky<S: Measure>() {
    let (horizon, zenith) = ([0.75, 0.82, 0.95], [0.1, 0.22, 0.6]);
    let scene =
        Scene { sky: Sky { horizon: light::<S>(horizon), zenith: light::<S>(zenith) }, ..dark::<S>() };
    for elevation in [-90.0_f64, -45.0, 0.0, 10.0, 30.0, 60.0, 90.0] {
        let (sine, cosine) = elevation.to_radians().sin_cos();
        let s = sine * sine;
        let want = [0, 1, 2].map(|i| (1.0 - s) * horizon[i] + s * zenith[i]);
        for towards in [[cosine, 0.0, sine], [-0.6 * cosine, 0.8 * cosine, sine]] {
            let got = see(scene, Rta, 5, [1.0, 2.0, 3.0], towards);
            for (got, want) in got.into_iter().zip(want) {
                assert_close!(got, want, 4.0 * S::LIGHT, RADIANCE, "elevation {elevation}");
            }
        }
    }
}

/// The edge of a sphere's shadow on the floor is where the cone around it from the lamp meets the floor: a circle
/// below, an ellipse aside.
fn shadow_of_a_sphere<S: Measure>() {
    let (center, radius) = ([0.0, 0.0, 5.0], 1.0);
    let eye = [14.0, -17.0, 2.5];
    for position in [[0.0, 0.0, 10.0], [-4.0, 3.0, 10.0]] {
        let axis = minus(center, position);
        let d = dot(axis, axis).sqrt();
        let axis = axis.map(|c| c / d);
        // Two directions across the axis, which is not parallel to x.
        let u = [axis[2], 0.0, -axis[0]];
        let u = u.map(|c| c / dot(u, u).sqrt());
        let v = [
            axis[1] * u[2] - axis[2] * u[1],
            axis[2] * u[0] - axis[0] * u[2],
            axis[0] * u[1] - axis[1] * u[0],
        ];
        let edge = (radius / d).asin();
        for (material, part) in [
            (Material::Opaque, 0.0),
            (Material::Shiny, 0.0),
            (Material::Mirror, 0.0),
            // Once for the whole sphere, though the ray goes in and out.
            (Material::Transparent(glass::<S>(0.4, 1.5)), 0.6),
        ] {
            let balls = [sphere::<S>(center, radius, WHITE, material)];
            let lamps = [lamp::<S>(position, 0.0, [50.0; 3])];
            let scene =
                Scene { spheres: &balls, lamps: &lamps, floor: Some(floor(WHITE, WHITE)), ..dark::<S>() };
            for step in 0..16 {
                let (sine, cosine) = (f64::from(step) * core::f64::consts::TAU / 16.0).sin_cos();
                for (share, through) in [(0.5, part), (0.999, part), (1.001, 1.0), (1.5, 1.0)] {
                    let (s, c) = (share * edge).sin_cos();
                    let ray = [0, 1, 2].map(|i| c * axis[i] + s * (cosine * u[i] + sine * v[i]));
                    let way = -position[2] / ray[2];
                    let target = [position[0] + way * ray[0], position[1] + way * ray[1], 0.0];
                    let want = through * 50.0 * -ray[2] / (way * way);
                    let got = see(scene, Rta, 0, eye, minus(target, eye));
                    let case = format!("lamp at {position:?}, {share} of the way to the edge at step {step}");
                    assert_light::<S>(got, [want; 3], &case);
                }
            }
        }
    }
}

/// Through one glass sphere under a sky of radiance 1 all light arrives but for what depth cuts off: outside ks is
/// reflected, inside kt leaves at each meeting, so that depth D leaves out kt ks^(D - 1).
fn glass_keeps_all_light<S: Measure>() {
    let uniform = Sky { horizon: light::<S>(WHITE), zenith: light::<S>(WHITE) };
    for (ks, ior) in [(0.3_f64, 1.5), (0.12, 1.52), (0.3, 1.0)] {
        let ball = [sphere([0.0; 3], 1.0, WHITE, Material::Transparent(glass::<S>(ks, ior)))];
        let scene = Scene { spheres: &ball, sky: uniform, ..dark::<S>() };
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

/// The colours of the far and near floors: red where the tile is even, green where it is odd.
fn tile(x: f64, y: f64) -> [f64; 3] {
    // From -1 to 1 for an odd sum, whatever its sign.
    let odd = ((x / 3.0).floor() + (y / 3.0).floor()).rem_euclid(2.0) > 0.5;
    if odd { [0.0, 1.0, 0.0] } else { [1.0, 0.0, 0.0] }
}

fn tiles<S: Measure>() {
    let scene = Scene {
        floor: Some(floor([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])),
        ambient: light::<S>(WHITE),
        ..dark::<S>()
    };
    let edges = [-9.0, -6.0, -3.0, 0.0, 3.0, 6.0, 9.0];
    let places: Vec<f64> = edges.into_iter().flat_map(|e| [e - 0.01, e + 0.01, e + 1.5]).collect();
    // From below the normal points down, and the ambient term is 0.2.
    for (eye, ambient) in [([0.3, 0.4, 20.0], 1.0), ([-5.0, 7.0, -11.0], 0.2)] {
        for &x in &places {
            for &y in &places {
                let got = see(scene, Rta, 0, eye, minus([x, y, 0.0], eye));
                let want = tile(x, y).map(|register| ambient * register);
                assert_light::<S>(got, want, &format!("at {x}, {y} from {eye:?}"));
            }
        }
    }
}

/// A place on top of a unit sphere, seen at 40 degrees from the normal, with a lamp on the other side.
fn on_top<S: Measure>(
    model: impl Illumination<S>,
    material: Material<S>,
    tint: [f64; 3],
    lamp_degrees: f64,
    distance: f64,
    intensity: [f64; 3],
) -> [f64; 3] {
    let ball = [sphere([0.0, 0.0, -1.0], 1.0, tint, material)];
    let (sine, cosine) = lamp_degrees.to_radians().sin_cos();
    let lamps = [lamp::<S>([-distance * sine, 0.0, distance * cosine], 0.0, intensity)];
    let (sine, cosine) = 40.0_f64.to_radians().sin_cos();
    let scene = Scene { spheres: &ball, lamps: &lamps, ambient: light::<S>([0.1, 0.2, 0.3]), ..dark::<S>() };
    see(scene, model, 5, [5.0 * sine, 0.0, 5.0 * cosine], [-sine, 0.0, -cosine])
}

fn whitted<S: Measure>() {
    let model =
        |ka: f64, shine: f64, exponent| Whitted::<S> { ka: S::unit(ka), shine: S::unit(shine), exponent };
    let (tint, intensity, ambient) = ([0.9, 0.5, 0.1], [0.8, 0.4, 0.6], [0.1, 0.2, 0.3]);
    for degrees in [0.0_f64, 25.0, 40.0, 70.0] {
        // The halfway vector lies between 40 degrees on one side and these on the other.
        let (nl, nh) = (degrees.to_radians().cos(), ((40.0 - degrees) / 2.0).to_radians().cos());
        for (ka, shine, exponent) in [(1.0, 0.2, 50), (0.5, 0.4, 20), (0.5, 1.0, 1), (1.0, 0.0, 7)] {
            let got = on_top::<S>(model(ka, shine, exponent), Material::Shiny, tint, degrees, 8.0, intensity);
            let highlight = nh.powi(i32::try_from(exponent).expect("small"));
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

/// Within 13 degrees of the reflected ray a lamp shows its full intensity, whatever its distance and the colour.
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
        assert_close!(S::read_unit(incident.solid_angle()), want, 4.0 * S::UNIT, "of the sphere", "{case}");
        assert_close!(incident.distance.read_length(), distance, S::LENGTH, "units", "{case}");
        assert_close!(S::read_unit(incident.cosine), 0.8, 4.0 * S::UNIT, COSINE, "{case}");
    }
}

/// Up to a million units away, and so beyond what Q16.16 can hold, a place has the colour of its tile.
fn far_floor<S: Measure>() {
    let scene = Scene {
        floor: Some(floor([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])),
        ambient: light::<S>(WHITE),
        ..dark::<S>()
    };
    let mut dice = fastrand::Rng::with_seed(3);
    let (mut looked, mut odd) = (0, 0);
    for _ in 0..2000 {
        let height = 1.0 + 99.0 * dice.f64();
        let eye = [200.0 * dice.f64() - 100.0, 200.0 * dice.f64() - 100.0, height];
        // From 1000 to 1 000 000 units away.
        let way = 1000.0 * 1000.0_f64.powf(dice.f64());
        let (sine, cosine) = (core::f64::consts::TAU * dice.f64()).sin_cos();
        let towards = [way * sine, way * cosine, -height];
        // Where the ray goes that the format has made of it, from the eye that it has made of it.
        let ray = read_direction::<S>(direction::<S>(towards));
        let from = place::<S>(eye);
        let from = [from.x(), from.y(), from.z()].map(S::read_length);
        let t = from[2] / -ray[2];
        let target = [from[0] + t * ray[0], from[1] + t * ray[1]];
        // Not where a rounding on the way decides.
        let blur = 0.01 + 4.0 * (t * S::UNIT + S::LENGTH);
        let edge = |c: f64| (c / 3.0 - (c / 3.0).round()).abs() * 3.0;
        if edge(target[0]) < blur || edge(target[1]) < blur {
            continue;
        }
        let got = see(scene, Rta, 0, eye, towards);
        let want = tile(target[0], target[1]);
        assert_light::<S>(got, want, &format!("{t} units away at {target:?}"));
        looked += 1;
        odd += u32::from(want[1] > 0.5);
    }
    assert!(looked > 1000 && odd > looked / 3 && odd < looked * 2 / 3, "{odd} odd tiles of {looked}");
}

/// The trait's own numbers, so that an `Rgb` of every format is what the tests read.
#[test]
fn what_is_read_is_what_was_written() {
    let color: Rgb<<Q16 as rta_core::Scalar>::Light> = light::<Q16>([0.25, 3.5, 100.0]);
    assert_eq!(read_light::<Q16>(color), [0.25, 3.5, 100.0]);
    assert_eq!(read_direction::<Q16>(direction::<Q16>([3.0, 0.0, 4.0]))[1], 0.0);
    assert_close!(read_direction::<f32>(direction::<f32>([3.0, 0.0, 4.0]))[2], 0.8, 1e-7, COSINE);
}
