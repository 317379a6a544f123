//! Reading the numbers of every format, and the unit in which their errors are counted.

use fixed::types::{I2F30, I24F40, I32F32};
use rta_core::scalar::{Radiance, Scalar};
use rta_core::{Q16, Q20};
use rta_scenes::narrow::Narrow;

use crate::log::Kind;

/// A number that can be read as `f64`, exactly.
pub trait Value: Copy {
    /// The kind of number.
    const KIND: Kind;
    /// Returns the number as `f64`.
    fn value(self) -> f64;
    /// Returns the unit in which the error of a number of about the size `at` is counted: one LSB in fixed point; one ulp in a float,
    /// or the ulp of 1 for a smaller number, since it is added to numbers of that size; for a square, the change that changes its
    /// root by an LSB.
    fn last_place(at: f64) -> f64;
}

/// A number format all of whose quantities can be read as `f64`.
pub trait Format: Value + Narrow<Unit: UnitFormat, Wide: Value, Light: Value> {
    /// The value of [`Scalar::FAR`].
    const FARTHEST: f64;
}

/// The format of a unit vector's components.
pub trait UnitFormat: Value + rta_core::scalar::Unit {
    /// A length that goes with it: any will do where only the unit matters.
    type Length: Scalar<Unit = Self>;
}

macro_rules! fixed_point {
    ($f:ty, $wide:ty, $bits:literal) => {
        impl Value for $f {
            const KIND: Kind = Kind::Length;
            fn value(self) -> f64 {
                self.to_num()
            }
            fn last_place(_at: f64) -> f64 {
                1.0 / f64::from(1u32 << $bits)
            }
        }
        impl Value for $wide {
            const KIND: Kind = Kind::Square;
            fn value(self) -> f64 {
                self.to_bits() as f64 / (1u64 << (2 * $bits)) as f64
            }
            fn last_place(at: f64) -> f64 {
                let lsb = <$f>::last_place(0.0);
                2.0 * lsb * at.abs().sqrt().max(lsb)
            }
        }
        impl Format for $f {
            const FARTHEST: f64 = i32::MAX as f64 / (1u32 << $bits) as f64;
        }
    };
}

fixed_point!(Q16, I32F32, 16);
fixed_point!(Q20, I24F40, 20);

// The unit of both fixed-point formats.
impl Value for I2F30 {
    const KIND: Kind = Kind::Unit;
    fn value(self) -> f64 {
        self.to_num()
    }
    fn last_place(_at: f64) -> f64 {
        1.0 / f64::from(1u32 << 30)
    }
}

impl UnitFormat for I2F30 {
    type Length = Q16;
}

impl Value for Radiance {
    const KIND: Kind = Kind::Light;
    fn value(self) -> f64 {
        self.0.to_num()
    }
    fn last_place(_at: f64) -> f64 {
        1.0 / f64::from(1u32 << 16)
    }
}

macro_rules! float {
    ($f:ty) => {
        impl Value for $f {
            // A float has one range for all.
            const KIND: Kind = Kind::Length;
            fn value(self) -> f64 {
                f64::from(self)
            }
            fn last_place(at: f64) -> f64 {
                at.abs().max(1.0).log2().floor().exp2() * f64::from(<$f>::EPSILON)
            }
        }
        impl UnitFormat for $f {
            type Length = $f;
        }
        impl Format for $f {
            const FARTHEST: f64 = <$f as Scalar>::FAR as f64;
        }
    };
}

float!(f32);
float!(f64);
