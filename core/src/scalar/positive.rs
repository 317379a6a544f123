//! Numbers of 0 or more and of any size: what is computed between coefficients, and leaves their range on the way.

use fixed::types::I2F30;

use super::integer::{exp2_minus, shadow};
use super::{Magnitude, Number, Unit};

/// A number of 0 or more and of any size, such as the number of facets of a rough surface that face one way, or its reflectance
/// near grazing mirror light. In fixed point it is 32 bits and an exponent, and each operation rounds by less than 2^-31 of
/// its result.
pub trait Positive: Number {
    /// The type of coefficients.
    type Unit: Unit<Positive = Self>;
    /// Returns `value * 2^exponent`.
    fn new(value: u64, exponent: i32) -> Self;
    /// Returns the sum.
    fn plus(self, other: Self) -> Self;
    /// Returns the product.
    fn times(self, other: Self) -> Self;
    /// Returns the quotient by a divisor above 0.
    fn over(self, divisor: Self) -> Self;
    /// Returns the square root.
    fn root(self) -> Self;
    /// Returns the number as a coefficient; saturates at 2 in fixed point.
    fn unit(self) -> Self::Unit;
    /// Returns `2^-self`, within 3e-9 in fixed point.
    fn exp2_minus(self) -> Self::Unit;
    /// Returns `self U(self)`, where `U(A) = exp(-A^2) / (2 A sqrt pi) - erfc(A) / 2` is what the facets of a rough surface hide
    /// of one another (Sancer 1969): 0.282 at 0, falling; within 1e-6 in fixed point.
    fn shadow(self) -> Self::Unit;
    /// Returns `e^-self`.
    fn exp_minus(self) -> Self::Unit {
        // log2 e.
        self.times(Self::new(0xb8aa_3b29_5c17_f0bc, -63)).exp2_minus()
    }
}

/// Returns `2^places number`, rounded to the nearest; saturates.
#[allow(clippy::cast_possible_truncation)] // at most 2^32 - 1
pub(super) fn bits(number: Magnitude, places: i32) -> u32 {
    let (mantissa, exponent) = number.parts();
    match exponent + places {
        0 => mantissa,
        1.. if mantissa > 0 => u32::MAX,
        down @ -32..0 => (((u64::from(mantissa) << 1 >> -down) + 1) >> 1).min(u64::from(u32::MAX)) as u32,
        _ => 0,
    }
}

impl Positive for Magnitude {
    type Unit = I2F30;
    fn new(value: u64, exponent: i32) -> Self {
        Self::new(value, exponent)
    }
    fn plus(self, other: Self) -> Self {
        self.plus(other)
    }
    fn times(self, other: Self) -> Self {
        self.times(other)
    }
    fn over(self, divisor: Self) -> Self {
        self.over(divisor)
    }
    fn root(self) -> Self {
        self.root()
    }
    fn unit(self) -> I2F30 {
        I2F30::from_bits(bits(self, 30).min(i32::MAX.cast_unsigned()).cast_signed())
    }
    fn exp2_minus(self) -> I2F30 {
        I2F30::from_bits(exp2_minus(bits(self, 27)).cast_signed())
    }
    fn shadow(self) -> I2F30 {
        I2F30::from_bits(shadow(bits(self, 30 - 1)).cast_signed())
    }
}
