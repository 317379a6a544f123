//! Numbers of all formats from and to floats, for tests.

use super::vector::{UnitVec3, Vec3, Vector};
use super::{Q16, Q20, Radiance, Scalar};

/// A number format whose numbers are read as floats.
pub(crate) trait Read: Scalar {
    fn length(value: f64) -> Self;
    fn unit(value: f64) -> Self::Unit;
    fn read(unit: Self::Unit) -> f64;
    fn far(length: Self) -> f64;
    fn shine(light: Self::Light) -> f64;
}

macro_rules! read {
    ($($f:ty, $from:expr, $unit:expr, $read:expr, $far:expr, $shine:expr;)*) => {
        $(impl Read for $f {
            fn length(value: f64) -> Self { $from(value) }
            fn unit(value: f64) -> Self::Unit { $unit(value) }
            fn read(unit: Self::Unit) -> f64 { $read(unit) }
            fn far(length: Self) -> f64 { $far(length) }
            fn shine(light: Self::Light) -> f64 { $shine(light) }
        })*
    };
}

type Fixed = <Q16 as Scalar>::Unit;

#[allow(clippy::cast_possible_truncation, reason = "to the nearest")]
fn single(value: f64) -> f32 {
    value as f32
}

read! {
    f64, |value| value, |value| value, |unit| unit, |length| length, |light| light;
    f32, single, single, f64::from, f64::from, f64::from;
    Q16, Q16::from_num, Fixed::from_num, |unit: Fixed| unit.to_num(), |length: Q16| length.to_num(), |light: Radiance| light.0.to_num();
    Q20, Q20::from_num, Fixed::from_num, |unit: Fixed| unit.to_num(), |length: Q20| length.to_num(), |light: Radiance| light.0.to_num();
}

pub(crate) fn place<S: Read>([x, y, z]: [f64; 3]) -> Vec3<S> {
    Vec3::<S>::new(S::length(x), S::length(y), S::length(z))
}

pub(crate) fn direction<S: Read>([x, y, z]: [f64; 3]) -> UnitVec3<S> {
    UnitVec3::<S>::new(S::unit(x), S::unit(y), S::unit(z))
}
