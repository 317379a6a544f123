//! Fixed point: lengths in a signed 32-bit format, components of unit vectors in Q2.30, squares in 64 bits.
//!
//! Everything is integer arithmetic, so a picture is the same bytes on every processor, in debug and in release. A
//! product is computed exactly in 64 bits and rounded once. [`crate::range`] proves of a scene, before it may be drawn, that
//! each result fits its format for any ray; debug builds check it too.

mod length;

use fixed::types::{I2F30, I12F20, I16F16};

use super::integer::{self, Reciprocal, exp2_minus, minus_log2, shift_right, wide};
use super::vector::{Plan, UnitVector, Xyz};
use super::{Light, Magnitude, Scalar, Unit};

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
#[cfg_attr(not(target_os = "none"), inline)]
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
#[cfg_attr(not(target_os = "none"), inline)]
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

/// Returns a vector shifted up as far as it fits, so that a short one is normalised to full precision, and by how many bits.
#[cfg_attr(not(target_os = "none"), inline)]
fn scale_up(v: Xyz<i32>) -> (Xyz<i32>, u32) {
    let bits = v.x.unsigned_abs() | v.y.unsigned_abs() | v.z.unsigned_abs();
    let shift = bits.leading_zeros().clamp(1, 31) - 1;
    (v.map(|c| c << shift), shift)
}

impl Unit for I2F30 {
    type Inverse = Reciprocal;
    const ZERO: Self = Self::ZERO;
    const ONE: Self = Self::ONE;
    const LARGEST: Magnitude = Magnitude::new(1 << 31, -30);
    const ROUNDING: Self = Self::from_bits(8);
    #[cfg_attr(not(target_os = "none"), inline)]
    fn size(self) -> Magnitude {
        Magnitude::new(u64::from(self.to_bits().unsigned_abs()), -30)
    }
    #[allow(clippy::cast_possible_truncation)] // saturated
    #[inline(always)] // of constants it is one, and no division of 128 bits is in the program
    fn ratio(numerator: i64, denominator: i64) -> Self {
        let scaled =
            (i128::from(numerator.unsigned_abs()) << (UNIT_BITS + 1)) / i128::from(denominator.max(1));
        let bits = ((scaled + 1) >> 1).min(i128::from(i32::MAX)) as i32;
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
    #[cfg_attr(not(target_os = "none"), inline)]
    fn discriminant(b: Self, a: Self, c: Self) -> Option<Self> {
        root(wide(b.to_bits(), b.to_bits()) - wide(a.to_bits(), c.to_bits()))
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
    #[cfg_attr(not(target_os = "none"), inline)]
    fn size(self) -> Magnitude {
        Magnitude::new(u64::from(self.0.to_bits().unsigned_abs()), -16)
    }
    fn plus(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }
    #[cfg_attr(not(target_os = "none"), inline)]
    fn times(self, factor: I2F30) -> Self {
        // A cosine of 0 may be one LSB below it.
        let product = shift_right(wide(self.0.to_bits(), factor.to_bits()), UNIT_BITS);
        Self(I16F16::from_bits(saturate(product.max(0))))
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // clamped
    #[cfg_attr(not(target_os = "none"), inline)]
    fn level(self, max: u8) -> u8 {
        let scaled = shift_right(wide(self.0.to_bits(), i32::from(max)), LIGHT_BITS);
        scaled.clamp(0, i64::from(max)) as u8
    }
}

/// The intensity of a lamp: `mantissa * 2^exponent`, the mantissa's top bit set (or all of it 0).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Power {
    mantissa: u32,
    exponent: i16,
}

impl Power {
    /// Returns the intensity from its [`Power::parts`], for generated code.
    pub const fn from_parts(mantissa: u32, exponent: i16) -> Self {
        Self { mantissa, exponent }
    }

    /// Returns the mantissa and the exponent `e` of `mantissa * 2^e`.
    pub const fn parts(self) -> (u32, i16) {
        (self.mantissa, self.exponent)
    }
}

/// Returns `value * 2^exponent` as a radiance; saturates.
#[allow(clippy::cast_possible_truncation)] // clamped
#[cfg_attr(not(target_os = "none"), inline)]
fn radiance(value: u64, exponent: i32) -> Radiance {
    let bits = match exponent {
        0.. if value == 0 => 0,
        0.. if exponent.unsigned_abs() >= value.leading_zeros() => u64::MAX,
        0.. => value << exponent,
        _ => value.checked_shr(exponent.unsigned_abs()).unwrap_or(0),
    };
    Radiance(I16F16::from_bits(bits.min(i32::MAX as u64) as i32))
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
    fn scale(self, factor: I2F30) -> Self {
        self.map(|c| c.times(factor))
    }
    fn times(self, other: Self) -> Self {
        self.zip(other, Unit::times)
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
        let (v, shift) = scale_up(self.map(I2F30::to_bits));
        let (direction, _, reciprocal) = normalize(v)?;
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
    #[cfg_attr(not(target_os = "none"), inline)]
    fn plan<S: Scalar<Unit = I2F30>>(self) -> Option<Plan<S>> {
        let flat = Self::new(self.x, self.y, I2F30::ZERO);
        UnitVector::normalize(flat).map(|(plan, stretch)| Plan { x: plan.x, y: plan.y, stretch })
    }
}
