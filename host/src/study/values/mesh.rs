//! Values of meshes. The triangle that they are asked of has the unit normals (0, 0, 1), (.6, 0, .8) and (0, .6, .8) and a lamp in the
//! direction (.48, .6, .64).

use rta_core::color::Rgb;
use rta_core::scalar::{Light, Unit};
use rta_core::texture::{bishop_weimer, gouraud, mixed_normal, on_screen};
use rta_core::vector::{UnitVec3, UnitVector};
use rta_scenes::narrow::Narrow;

use super::functions::{Function, functions};
use super::texture::direction;

/// The relative error of a few operations in fixed point.
const NEAR: f64 = 1e-6;
/// The relative error of light, which has 16 bits behind the point.
const LIGHT: f64 = 5e-5;

/// Returns the functions of meshes, as they are computed in the format `S`; the weight of vertex 0 is what those of the others leave of 1.
pub(super) fn all<S: Narrow>() -> Vec<Function> {
    functions! {
        gouraud_nl(b1, b2) within LIGHT => {
            let light = |normal: UnitVec3<S>| grey::<S>(S::Light::WHITE.times(normal.dot(lamp::<S>())));
            S::light_to_f64(gouraud::<S>(weights::<S>(b1, b2), normals::<S>().map(light)).r)
        };
        phong_nl(b1, b2) within NEAR => cosine::<S>(mixed_normal::<S>(weights::<S>(b1, b2), normals::<S>()));
        bishop_nl(b1, b2) within NEAR => cosine::<S>(bishop_weimer::<S>(weights::<S>(b1, b2), normals::<S>()));
        gouraud(b1, b2, i0, i1, i2) within LIGHT => {
            let lights = [i0, i1, i2].map(|light| grey::<S>(S::light(light)));
            S::light_to_f64(gouraud::<S>(weights::<S>(b1, b2), lights).r)
        };
        screen(b1, b2, z0, z1, z2) within NEAR => {
            let weights = on_screen::<S>(weights::<S>(b1, b2), [z0, z1, z2].map(S::length));
            weights.map_or(f64::NAN, |[_, second, _]| S::unit_to_f64(second))
        };
    }
}

fn weights<S: Narrow>(b1: f64, b2: f64) -> [S::Unit; 3] {
    let [second, third] = [b1, b2].map(S::unit);
    [S::Unit::ONE - second - third, second, third]
}

fn normals<S: Narrow>() -> [UnitVec3<S>; 3] {
    [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, 0.6, 0.8]].map(direction::<S>)
}

fn lamp<S: Narrow>() -> UnitVec3<S> {
    direction::<S>([0.48, 0.6, 0.64])
}

fn cosine<S: Narrow>(normal: Option<UnitVec3<S>>) -> f64 {
    normal.map_or(f64::NAN, |normal| S::unit_to_f64(normal.dot(lamp::<S>())))
}

const fn grey<S: Narrow>(light: S::Light) -> Rgb<S::Light> {
    Rgb::new(light, light, light)
}
