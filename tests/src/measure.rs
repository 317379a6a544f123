//! The size of a rounding in each number format, and vectors and colours of a format from and to `f64`.

use rta_core::color::Rgb;
use rta_core::vector::{UnitVec3, Vec3, Vector};
use rta_core::{Q16, Q20};
use rta_scenes::shading::Shade;

/// A number format whose roundings a test can bound.
pub trait Measure: Shade {
    /// Size of one rounding of a length of about ten units, in units of length.
    const LENGTH: f64;
    /// Size of one rounding of a component of a unit vector.
    const UNIT: f64;
    /// Size of one rounding of a radiance of about one.
    const LIGHT: f64;
}

macro_rules! fixed {
    ($f:ty, $lsb:expr) => {
        impl Measure for $f {
            const LENGTH: f64 = $lsb;
            const UNIT: f64 = 1.0 / 1_073_741_824.0;
            const LIGHT: f64 = 1.0 / 65_536.0;
        }
    };
}

fixed!(Q16, 1.0 / 65_536.0);
fixed!(Q20, 1.0 / 1_048_576.0);

macro_rules! float {
    ($f:ty) => {
        impl Measure for $f {
            const LENGTH: f64 = 8.0 * <$f>::EPSILON as f64;
            const UNIT: f64 = <$f>::EPSILON as f64;
            const LIGHT: f64 = <$f>::EPSILON as f64;
        }
    };
}

float!(f32);
float!(f64);

/// Returns a place, each coordinate rounded to the nearest length of the format.
#[must_use]
pub fn place<S: Measure>([x, y, z]: [f64; 3]) -> Vec3<S> {
    Vector::new(S::length(x), S::length(y), S::length(z))
}

/// Returns the direction of a vector of any length but 0, each component rounded to the format.
#[must_use]
pub fn direction<S: Measure>(v: [f64; 3]) -> UnitVec3<S> {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    let [x, y, z] = v.map(|c| S::unit(c / length));
    Vector::new(x, y, z)
}

/// Returns a reflectance, each register rounded to the format.
#[must_use]
pub fn color<S: Measure>([r, g, b]: [f64; 3]) -> Rgb<S::Unit> {
    Rgb::new(S::unit(r), S::unit(g), S::unit(b))
}

/// Returns a radiance, each register rounded to the format.
#[must_use]
pub fn light<S: Measure>([r, g, b]: [f64; 3]) -> Rgb<S::Light> {
    Rgb::new(S::light(r), S::light(g), S::light(b))
}

/// Returns the components of a direction.
#[must_use]
pub fn read_direction<S: Measure>(v: UnitVec3<S>) -> [f64; 3] {
    [v.x(), v.y(), v.z()].map(S::unit_to_f64)
}

/// Returns red, green and blue of a radiance.
#[must_use]
pub fn read_light<S: Measure>(light: Rgb<S::Light>) -> [f64; 3] {
    [light.r, light.g, light.b].map(S::light_to_f64)
}
