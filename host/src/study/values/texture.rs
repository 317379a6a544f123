//! Values of textures.

use rta_core::texture::{STEEP, ball, fold, noise, tilt};
use rta_core::vector::{UnitVec3, UnitVector, Vec3, Vector};
use rta_scenes::narrow::Narrow;

use super::functions::{Function, functions};

/// The relative error of what is exact: integers of up to 32 bits.
const EXACT: f64 = 1e-12;
/// The error of an angle in turns.
const TURN: f64 = 3e-7;
/// The relative error of what is computed in a few operations in fixed point.
const NEAR: f64 = 1e-6;

/// Returns the functions of textures, as they are computed in the format `S`. Places of patterns are in 65536ths, but for `checker`.
pub(super) fn all<S: Narrow>() -> Vec<Function> {
    functions! {
        hash3(x, y, z) within EXACT => f64::from(noise::hash([x, y, z].map(whole)));
        noise(x, y, z) within EXACT => f64::from(noise::noise([x, y, z].map(whole)));
        turbulence(k, x, y, z) within EXACT => f64::from(noise::turbulence(octaves(k), [x, y, z].map(whole)));
        wave(t) within EXACT => f64::from(noise::wave(whole(t)));
        marble(k, amp, x, y, z) within EXACT => {
            f64::from(noise::marble(octaves(k), whole(amp), [x, y, z].map(whole)))
        };
        wood(amp, x, y, z) within EXACT => f64::from(noise::wood(whole(amp), [x, y, z].map(whole)));
        checker(x, y, z) within EXACT => {
            let place = [x, y, z].map(|part| S::length(part).lattice(1 << 24));
            f64::from(u8::from(noise::checker(place) != 0))
        };
        sphere_u(x, y, z) within TURN => S::unit_to_f64(first(ball::<S>(direction::<S>([x, y, z]))));
        sphere_v(x, y, z) within TURN => S::unit_to_f64(second(ball::<S>(direction::<S>([x, y, z]))));
        octa_u(x, y, z) within NEAR => S::unit_to_f64(first(fold::<S>(direction::<S>([x, y, z]))));
        octa_v(x, y, z) within NEAR => S::unit_to_f64(second(fold::<S>(direction::<S>([x, y, z]))));
        bump_z(fu, fv, a) within NEAR => bumped::<S>([fu, fv], a);
    }
}

/// Returns an argument that is an integer of 32 bits.
#[allow(clippy::cast_possible_truncation)] // a float's cast saturates
const fn whole(number: f64) -> i32 {
    number as i32
}

/// Returns a number of octaves.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a float's cast saturates
const fn octaves(number: f64) -> u8 {
    number as u8
}

const fn first<T: Copy>([first, _]: [T; 2]) -> T {
    first
}

const fn second<T: Copy>([_, second]: [T; 2]) -> T {
    second
}

pub(super) fn direction<S: Narrow>(direction: [f64; 3]) -> UnitVec3<S> {
    let [x, y, z] = direction.map(S::unit);
    UnitVec3::<S>::new(x, y, z)
}

/// Returns the cosine of the angle by which bumps of the slopes F_u and F_v times a tilt a normal.
#[allow(clippy::cast_precision_loss)] // 4
fn bumped<S: Narrow>(slopes: [f64; 2], a: f64) -> f64 {
    let [x, y] = slopes.map(|slope| S::length(slope * a * STEEP as f64));
    let normal = UnitVec3::<S>::Z;
    S::unit_to_f64(tilt::<S>(normal, Vec3::<S>::new(x, y, S::ZERO)).dot(normal))
}
