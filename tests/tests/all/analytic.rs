//! Pictures whose radiance is known from a formula, in every number format.

use rta::engine::MAX_DEPTH;
use rta_core::Q16;
use rta_core::camera::{Camera, Lens};
use rta_core::color::Rgb;
use rta_core::illumination::Illumination;
use rta_core::light::Lamp;
use rta_core::material::Glass;
use rta_core::needs::Everything;
use rta_core::scene::{Floor, PLAIN, Scene, Sky};
use rta_core::shape::Sphere;
use rta_core::trace::Tracer;
use rta_scenes::narrow::Narrow;
use rta_tests::assert_close;
use rta_tests::measure::{Measure, color, direction, light, place, read_direction, read_light};

/// Makes a module with four tests, one for each number format, of each generic function named.
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
                super::$name::<rta_core::Q16>();
            }
            #[test]
            fn q20() {
                super::$name::<rta_core::Q20>();
            }
        }
    )*};
}

mod floor;
mod glass;
mod lighting;

const BLACK: [f64; 3] = [0.0; 3];
const WHITE: [f64; 3] = [1.0; 3];
const RADIANCE: &str = "of white";
const COSINE: &str = "of a unit vector's component";

/// Returns a few roundings of places some ten units away, and of radiance.
fn tolerance<S: Measure>() -> f64 {
    8.0 * (S::LENGTH + S::LIGHT)
}

/// Returns an empty scene without any light.
fn dark<S: Measure>() -> Scene<'static, S> {
    Scene {
        floor: None,
        sky: Sky { horizon: light::<S>(BLACK), zenith: light::<S>(BLACK) },
        ambient: light::<S>(BLACK),
        ..Scene::day()
    }
}

/// Returns a sphere of the scene's first material.
fn sphere<S: Measure>(center: [f64; 3], radius: f64, tint: [f64; 3]) -> Sphere<S> {
    Sphere::new(place::<S>(center), S::length(radius), color::<S>(tint), 0)
}

fn lamp<S: Measure>(position: [f64; 3], radius: f64, intensity: [f64; 3]) -> Lamp<S> {
    let most = intensity.into_iter().fold(0.0, f64::max);
    let (power, tint) = (<S as Narrow>::power(most), color::<S>(intensity.map(|register| register / most)));
    Lamp::new(place::<S>(position), S::length(radius), power, tint)
}

fn floor<S: Measure>(even: [f64; 3], odd: [f64; 3]) -> Floor<S> {
    Floor { colors: [color::<S>(even), color::<S>(odd)], tile: None, material: PLAIN }
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
    // With the engine's stack the engine's tracers are linked, not compiled anew.
    let tracer: Tracer<_, _, Everything, { MAX_DEPTH as usize }> =
        Tracer::new(&admitted, model, depth).expect("it is no deeper");
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

/// The conversions that all of these tests go through.
#[test]
fn what_is_read_is_what_was_written() {
    let color: Rgb<<Q16 as rta_core::Scalar>::Light> = light::<Q16>([0.25, 3.5, 100.0]);
    assert_eq!(read_light::<Q16>(color), [0.25, 3.5, 100.0]);
    assert_eq!(read_direction::<Q16>(direction::<Q16>([3.0, 0.0, 4.0]))[1], 0.0);
    assert_close!(read_direction::<f32>(direction::<f32>([3.0, 0.0, 4.0]))[2], 0.8, 1e-7, COSINE);
}
