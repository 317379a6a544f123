//! Fixed point: lengths in a signed 32-bit format, components of unit vectors in Q2.30, squares in 64 bits.
//!
//! Everything is integer arithmetic, so a picture is the same bytes on every processor, in debug and in release. A
//! product is computed exactly in 64 bits and rounded once. [`crate::range`] proves of a scene, before it may be drawn, that
//! each result fits its format for any ray; debug builds check it too.

mod length;
mod sight;

use fixed::FixedI32;
use fixed::types::extra::LeEqU32;
use fixed::types::{I2F30, I12F20, I16F16};

use super::integer::{self, Reciprocal, arc_squared, exp2_minus, minus_log2, shift_right, turn, wide};
use super::vector::{UnitVector, Xyz};
use super::{Light, Magnitude, Number, Unit};

/// Lengths in Q16.16: a scene may be 24576 units across, one LSB is 1.5e-5.
pub type Q16 = I16F16;

/// Lengths in Q12.20: a scene may be 1536 units across, one LSB is 9.5e-7.
pub type Q20 = I12F20;

/// Fractional bits of a unit vector's component.
const UNIT_BITS: u32 = 30;
/// Fractional bits of radiance.
const LIGHT_BITS: u32 = 16;

/// Returns the low word of a result that fits, as the range proof has shown.
#[allow(clippy::cast_possible_truncation)] // checked in debug builds, proved before a release build draws
fn word(value: i64) -> i32 {
    debug_assert!(i32::try_from(value).is_ok(), "{value} exceeds its fixed-point format");
    value as i32
}

/// Returns the nearest value that fits.
#[allow(clippy::cast_possible_truncation)] // clamped
#[cfg_attr(not(target_os = "none"), inline)]
fn saturate(value: i64) -> i32 {
    value.clamp(-i64::from(i32::MAX), i64::from(i32::MAX)) as i32
}

/// Returns a product with a unit, rounded to the format of the other factor.
fn round(product: i64) -> i32 {
    word(shift_right(product, UNIT_BITS))
}

/// Returns direction, length and reciprocal of the length of a vector whose squares add up to less than 2^64.
#[cfg_attr(not(target_os = "none"), inline)]
fn normalize(v: Xyz<i32>) -> Option<(Xyz<I2F30>, u32, Reciprocal)> {
    let square = v.map(|c| u64::from(c.unsigned_abs()).pow(2));
    let square = square.x + square.y + square.z;
    if square == 0 {
        return None;
    }
    let (reciprocal, length) = Reciprocal::of_sqrt(square);
    Some((v.map(|c| I2F30::from_bits(word(reciprocal.times(c)))), length, reciprocal))
}

impl<F: LeEqU32 + Send + Sync + 'static> Number for FixedI32<F> {
    fn size(self) -> Magnitude {
        Magnitude::new(u64::from(self.to_bits().unsigned_abs()), -F::I32)
    }
}

impl Number for Radiance {
    fn size(self) -> Magnitude {
        self.0.size()
    }
}

impl Unit for I2F30 {
    type Inverse = Reciprocal;
    type Positive = Magnitude;
    const ZERO: Self = Self::ZERO;
    const ONE: Self = Self::ONE;
    const LARGEST: Magnitude = Magnitude::new(1 << 31, -30);
    const ROUNDING: Self = Self::from_bits(8);
    #[inline(always)] // of constants it is one, and no division of 128 bits is in the program
    fn ratio(numerator: i64, denominator: i64) -> Self {
        let scaled =
            (i128::from(numerator.unsigned_abs()) << (UNIT_BITS + 1)) / i128::from(denominator.max(1));
        let bits = i32::try_from((scaled + 1) >> 1).unwrap_or(i32::MAX);
        Self::from_bits(if numerator < 0 { -bits } else { bits })
    }
    #[cfg_attr(not(target_os = "none"), inline)]
    fn fraction(numerator: i32, denominator: u32) -> Self {
        let divisor = denominator.clamp(1, 1 << 31);
        let mut rest = numerator.unsigned_abs();
        // Long division, a bit at a time: the whole part, which is 0 or 1, the bits behind the point, and one more.
        let mut bits = 0u32;
        for _ in 0..UNIT_BITS + 2 {
            bits <<= 1;
            if rest >= divisor {
                rest -= divisor;
                bits |= 1;
            }
            rest <<= 1;
        }
        let bits = (bits / 2 + bits % 2).min(i32::MAX.cast_unsigned()).cast_signed();
        Self::from_bits(if numerator < 0 { -bits } else { bits })
    }
    fn of_word(word: u32) -> Self {
        Self::from_bits((word >> (32 - UNIT_BITS)).cast_signed())
    }
    fn of_level(level: i32) -> Self {
        // 2^30 / 65535 is 2^14 + 1/4, and a little.
        Self::from_bits((level << (UNIT_BITS - 16)) + ((level + 2) >> 2))
    }
    fn turn(x: Self, y: Self) -> Self {
        Self::from_bits(turn(x.to_bits(), y.to_bits()))
    }
    #[cfg_attr(not(target_os = "none"), inline)]
    fn times(self, factor: Self) -> Self {
        Self::from_bits(round(wide(self.to_bits(), factor.to_bits())))
    }
    fn over(self, divisor: Reciprocal) -> Self {
        Self::from_bits(saturate(divisor.times(self.to_bits())))
    }
    #[allow(clippy::cast_possible_truncation)] // at most 30 2^27
    fn root(self, part: u32) -> Self {
        if self <= Self::ZERO {
            return Self::ZERO;
        }
        let log = u64::from(minus_log2(self.to_bits().unsigned_abs())) * u64::from(part);
        Self::from_bits(exp2_minus((log >> 32) as u32).cast_signed())
    }
    fn arc_squared(self) -> Self {
        Self::from_bits(arc_squared(self.to_bits().max(0).cast_unsigned()).cast_signed())
    }
    fn positive(self) -> Magnitude {
        if self < Self::ZERO { Magnitude::ZERO } else { self.size() }
    }
    fn quotient(self, divisor: Self) -> Self {
        let reciprocal = Reciprocal::of(divisor.to_bits().unsigned_abs());
        let size = saturate(reciprocal.times(self.to_bits().saturating_abs()));
        Self::from_bits(if (self < Self::ZERO) == (divisor < Self::ZERO) { size } else { -size })
    }
    #[cfg_attr(not(target_os = "none"), inline)]
    fn radical(a: Self, b: Self, minus: Self) -> Option<Self> {
        let square = |c: Self| wide(c.to_bits(), c.to_bits());
        root(square(a) - square(minus) + square(b))
    }
}

/// Returns the square root of a number with twice the fractional bits of a unit.
#[cfg_attr(not(target_os = "none"), inline)]
fn root(square: i64) -> Option<I2F30> {
    let root = integer::sqrt(u64::try_from(square).ok()?);
    Some(I2F30::from_bits(word(i64::from(root))))
}

/// Radiance in Q16.16: 0 to 32768, saturating.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Radiance(pub I16F16);

impl Light for Radiance {
    type Unit = I2F30;
    const ZERO: Self = Self(I16F16::ZERO);
    const WHITE: Self = Self(I16F16::ONE);
    const LARGEST: Magnitude = Magnitude::new(1 << 31, -16);
    fn plus(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }
    #[cfg_attr(not(target_os = "none"), inline)]
    fn times(self, factor: I2F30) -> Self {
        // A cosine of 0 may be one LSB below it.
        let product = shift_right(wide(self.0.to_bits(), factor.to_bits()), UNIT_BITS);
        Self(I16F16::from_bits(saturate(product.max(0))))
    }
    #[cfg_attr(not(target_os = "none"), inline)]
    fn level(self, max: u8) -> u8 {
        let scaled = shift_right(wide(self.0.to_bits(), i32::from(max)), LIGHT_BITS);
        u8::try_from(scaled.max(0)).map_or(max, |level| level.min(max))
    }
}

/// Returns `value * 2^exponent` as a radiance; saturates.
#[cfg_attr(not(target_os = "none"), inline)]
fn radiance(value: u64, exponent: i32) -> Radiance {
    let bits = match exponent {
        0.. if value == 0 => 0,
        0.. if exponent.unsigned_abs() >= value.leading_zeros() => u64::MAX,
        0.. => value << exponent,
        _ => value.checked_shr(exponent.unsigned_abs()).unwrap_or(0),
    };
    Radiance(I16F16::from_bits(i32::try_from(bits).unwrap_or(i32::MAX)))
}

impl UnitVector for Xyz<I2F30> {
    const X: Self = Self::new(I2F30::ONE, I2F30::ZERO, I2F30::ZERO);
    const Y: Self = Self::new(I2F30::ZERO, I2F30::ONE, I2F30::ZERO);
    const Z: Self = Self::new(I2F30::ZERO, I2F30::ZERO, I2F30::ONE);
    #[cfg_attr(not(target_os = "none"), inline)]
    fn dot(self, other: Self) -> I2F30 {
        let p = self.zip(other, |a, b| wide(a.to_bits(), b.to_bits()));
        I2F30::from_bits(round(p.x + p.y + p.z))
    }
    #[cfg_attr(not(target_os = "none"), inline)]
    fn cross(self, other: Self) -> Self {
        let part = |a: I2F30, b: I2F30, c: I2F30, d: I2F30| {
            I2F30::from_bits(round(wide(a.to_bits(), b.to_bits()) - wide(c.to_bits(), d.to_bits())))
        };
        Self::new(
            part(self.y, other.z, self.z, other.y),
            part(self.z, other.x, self.x, other.z),
            part(self.x, other.y, self.y, other.x),
        )
    }
    #[cfg_attr(not(target_os = "none"), inline)]
    fn plus(self, other: Self, factor: I2F30) -> Self {
        self.zip(other, |a, b| {
            let (a, b) = (i64::from(a.to_bits()), wide(b.to_bits(), factor.to_bits()));
            I2F30::from_bits(round((a << UNIT_BITS) + b))
        })
    }
    #[cfg_attr(not(target_os = "none"), inline)]
    fn normalize(self) -> Option<(Self, Reciprocal)> {
        // Shifted up as far as it fits, so that a short vector is normalised to full precision.
        let v = self.map(I2F30::to_bits);
        let bits = v.x.unsigned_abs() | v.y.unsigned_abs() | v.z.unsigned_abs();
        let shift = bits.leading_zeros().clamp(1, 31) - 1;
        let (direction, _, reciprocal) = normalize(v.map(|c| c << shift))?;
        Some((direction, reciprocal.unscale(shift)))
    }
    #[cfg_attr(not(target_os = "none"), inline)]
    fn reflect(self, normal: Self) -> Self {
        let cosine = self.dot(normal).to_bits();
        self.zip(normal, |i, n| {
            let (i, n) = (i64::from(i.to_bits()), wide(n.to_bits(), cosine));
            I2F30::from_bits(round((i << UNIT_BITS) - 2 * n))
        })
    }
    #[cfg_attr(not(target_os = "none"), inline)]
    fn halfway(self, other: Self) -> Option<Self> {
        let mean = self.zip(other, |a, b| {
            I2F30::from_bits(word((i64::from(a.to_bits()) + i64::from(b.to_bits())) >> 1))
        });
        UnitVector::normalize(mean).map(|(halfway, _)| halfway)
    }
    #[cfg_attr(not(target_os = "none"), inline)]
    fn half_chord(self, radius: I2F30) -> Option<I2F30> {
        let square = |c: I2F30| wide(c.to_bits(), c.to_bits());
        root(square(radius) - square(self.x) - square(self.y) - square(self.z))
    }
}
