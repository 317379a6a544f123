//! Fixed point: lengths in a signed 32-bit format, components of unit vectors in Q2.30, squares in 64 bits.
//!
//! Everything is integer arithmetic, so a picture is the same bytes on every processor, in debug and in release. A
//! product is formed whole in 64 bits and rounded once. Debug builds check that each result fits its format; that it
//! does, for any ray, is what [`crate::range`] proves of a scene before it may be drawn.

use fixed::types::{I2F30, I12F20, I16F16, I24F40, I32F32};

use super::integer::{self, Reciprocal, shift_right, shift_right_by, wide};
use super::{Light, Scalar, Unit};
use crate::lanes;
use crate::range::Magnitude;
use crate::vector::{LengthVector, Plan, UnitVector, Xyz};

/// Lengths in Q16.16: a scene may be 24576 units across, one LSB is 1.5e-5.
pub type Q16 = I16F16;

/// Lengths in Q12.20: a scene may be 1536 units across, one LSB is 9.5e-7.
pub type Q20 = I12F20;

/// Fractional bits of a unit vector's component.
const UNIT_BITS: u32 = 30;
/// Fractional bits of radiance.
const LIGHT_BITS: u32 = 16;
/// How far a ray's origin is pushed off a surface at least, in LSBs of a length; see [`LengthVector::clearance`].
///
/// The place `p = c + r n` is rounded by half an LSB in each component, sqrt(3)/2 LSB in all. Four LSBs leave more than 3
/// between the place and a sphere. The foot point `l` of a ray that leaves is rounded by as much again, so that
/// `|l|^2 - r^2` errs by at most `1.8 r` LSB, while it is `6 r` LSB for a tangent: both roots stay behind the ray.
const LEAVE_LSB: i32 = 4;
/// A large object adds its extent times 2^-26: the places that an ellipsoid is seen at, 30 bits of its extent, carry the
/// roundings of a dozen products; times its largest radius over its smallest, which is what squashing takes of the bits.
const LOCAL_BITS: u32 = 26;

/// The low word of a result that the range check promises to fit.
#[allow(clippy::cast_possible_truncation)] // checked in debug builds, proved before a release build draws
fn word(value: i64) -> i32 {
    debug_assert!(i32::try_from(value).is_ok(), "{value} exceeds its fixed-point format");
    value as i32
}

/// The nearest value that fits.
#[allow(clippy::cast_possible_truncation)] // clamped
fn saturate(value: i64) -> i32 {
    value.clamp(-i64::from(i32::MAX), i64::from(i32::MAX)) as i32
}

/// A product with a unit, rounded to the format of the other factor.
fn round(product: i64) -> i32 {
    word(shift_right(product, UNIT_BITS))
}

/// Direction, length and reciprocal of the length of a vector whose squares add up to less than 2^64.
fn normalize(v: Xyz<i32>) -> Option<(Xyz<I2F30>, u32, Reciprocal)> {
    let square = v.map(|c| u64::from(c.unsigned_abs()).pow(2));
    let square = square.x + square.y + square.z;
    if square == 0 {
        return None;
    }
    let (reciprocal, length) = Reciprocal::of_sqrt(square);
    Some((v.map(|c| I2F30::from_bits(word(reciprocal.times(c)))), length, reciprocal))
}

/// Shifts a vector up as far as it goes, so that a short one is normalised to full precision, and says how far.
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
    fn times(self, factor: Self) -> Self {
        Self::from_bits(round(wide(self.to_bits(), factor.to_bits())))
    }
    fn over(self, divisor: Reciprocal) -> Self {
        Self::from_bits(saturate(divisor.times(self.to_bits())))
    }
    fn discriminant(b: Self, a: Self, c: Self) -> Option<Self> {
        root(wide(b.to_bits(), b.to_bits()) - wide(a.to_bits(), c.to_bits()))
    }
    fn quotient(self, divisor: Self) -> Self {
        let reciprocal = Reciprocal::of(divisor.to_bits().unsigned_abs());
        let size = saturate(reciprocal.times(self.to_bits().saturating_abs()));
        Self::from_bits(if (self < Self::ZERO) == (divisor < Self::ZERO) { size } else { -size })
    }
    fn reciprocal(self) -> Reciprocal {
        Reciprocal::of(self.to_bits().unsigned_abs())
    }
    #[inline]
    fn coarse(self) -> f32 {
        lanes::coarse(self.to_bits(), UNIT_BITS)
    }
    fn radical(a: Self, b: Self, minus: Self) -> Option<Self> {
        let square = |c: Self| wide(c.to_bits(), c.to_bits());
        root(square(a) - square(minus) + square(b))
    }
}

/// The square root of a number with twice the fractional bits of a unit.
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
    fn size(self) -> Magnitude {
        Magnitude::new(u64::from(self.0.to_bits().unsigned_abs()), -16)
    }
    fn plus(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }
    fn times(self, factor: I2F30) -> Self {
        // A cosine of 0 may be one LSB below it.
        let product = shift_right(wide(self.0.to_bits(), factor.to_bits()), UNIT_BITS);
        Self(I16F16::from_bits(saturate(product.max(0))))
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // clamped
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
    /// From what [`Power::parts`] told, for scenes that are made ahead.
    pub const fn from_parts(mantissa: u32, exponent: i16) -> Self {
        Self { mantissa, exponent }
    }

    /// The mantissa and the exponent `e` of `mantissa * 2^e`.
    pub const fn parts(self) -> (u32, i16) {
        (self.mantissa, self.exponent)
    }
}

/// `value * 2^exponent` as radiance.
#[allow(clippy::cast_possible_truncation)] // clamped
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
    fn dot(self, other: Self) -> I2F30 {
        let p = self.zip(other, |a, b| wide(a.to_bits(), b.to_bits()));
        I2F30::from_bits(round(p.x + p.y + p.z))
    }
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
    fn scale(self, factor: I2F30) -> Self {
        self.map(|c| c.times(factor))
    }
    fn times(self, other: Self) -> Self {
        self.zip(other, Unit::times)
    }
    fn plus(self, other: Self, factor: I2F30) -> Self {
        self.zip(other, |a, b| {
            let (a, b) = (i64::from(a.to_bits()), wide(b.to_bits(), factor.to_bits()));
            I2F30::from_bits(round((a << UNIT_BITS) + b))
        })
    }
    fn normalize(self) -> Option<(Self, Reciprocal)> {
        let (v, shift) = scale_up(self.map(I2F30::to_bits));
        let (direction, _, reciprocal) = normalize(v)?;
        Some((direction, reciprocal.unscale(shift)))
    }
    fn reflect(self, normal: Self) -> Self {
        let cosine = self.dot(normal).to_bits();
        self.zip(normal, |i, n| {
            let (i, n) = (i64::from(i.to_bits()), wide(n.to_bits(), cosine));
            I2F30::from_bits(round((i << UNIT_BITS) - 2 * n))
        })
    }
    fn halfway(self, other: Self) -> Option<Self> {
        let mean = self.zip(other, |a, b| {
            I2F30::from_bits(word((i64::from(a.to_bits()) + i64::from(b.to_bits())) >> 1))
        });
        UnitVector::normalize(mean).map(|(halfway, _)| halfway)
    }
    fn half_chord(self, radius: I2F30) -> Option<I2F30> {
        let square = |c: I2F30| wide(c.to_bits(), c.to_bits());
        root(square(radius) - square(self.x) - square(self.y) - square(self.z))
    }
    fn plan<S: Scalar<Unit = I2F30>>(self) -> Option<Plan<S>> {
        let flat = Self::new(self.x, self.y, I2F30::ZERO);
        UnitVector::normalize(flat).map(|(plan, stretch)| Plan { x: plan.x, y: plan.y, stretch })
    }
}

macro_rules! fixed_point {
    ($f:ty, $wide:ty, $bits:literal) => {
        impl Scalar for $f {
            type Unit = I2F30;
            type Wide = $wide;
            type Light = Radiance;
            type Power = Power;
            type Inverse = Reciprocal;
            type Vector = Xyz<$f>;
            type UnitVector = Xyz<I2F30>;

            const ZERO: Self = Self::ZERO;
            const FAR: Self = Self::MAX;
            const LARGEST_SQUARE: Magnitude = Magnitude::new(1 << 63, -2 * $bits);
            const LARGEST_PRODUCT: Magnitude = Magnitude::new(1 << 63, -$bits - UNIT_BITS.cast_signed());
            // A squashed direction is then at least 2^18 LSBs long.
            const LARGEST_STRETCH: Magnitude = Magnitude::new(1 << 12, 0);
            const CLEARANCE: Magnitude = Magnitude::new(LEAVE_LSB.cast_unsigned() as u64, -$bits);

            fn size(self) -> Magnitude {
                Magnitude::new(u64::from(self.to_bits().unsigned_abs()), -$bits)
            }
            fn at_most(size: Magnitude) -> Self {
                let (mantissa, exponent) = size.parts();
                let bits = match exponent + $bits {
                    0.. => u32::MAX,
                    down => mantissa.checked_shr(down.unsigned_abs()).unwrap_or(0),
                };
                Self::from_bits(saturate(i64::from(bits)))
            }
            fn power_size(power: Power) -> Magnitude {
                Magnitude::new(u64::from(power.mantissa), i32::from(power.exponent))
            }
            fn scale(self, factor: I2F30) -> Self {
                Self::from_bits(round(wide(self.to_bits(), factor.to_bits())))
            }
            fn square(self) -> $wide {
                <$wide>::from_bits(wide(self.to_bits(), self.to_bits()))
            }
            fn sqrt(square: $wide) -> Self {
                let root = integer::sqrt(u64::try_from(square.to_bits()).unwrap_or(0));
                Self::from_bits(word(i64::from(root)))
            }
            fn inverse(self) -> Reciprocal {
                Reciprocal::of(self.to_bits().unsigned_abs())
            }
            fn fraction(self, whole: Reciprocal) -> I2F30 {
                I2F30::from_bits(saturate(whole.times(self.to_bits())))
            }
            fn stretch(self, slope: Reciprocal) -> Self {
                Self::from_bits(saturate(slope.times(self.to_bits())))
            }
            fn over(self, slope: I2F30) -> Self {
                Self::from_bits(saturate(
                    Reciprocal::of(slope.to_bits().unsigned_abs()).times(self.to_bits()),
                ))
            }
            fn squashed(self, thickness: I2F30) -> Self {
                Scalar::over(self, thickness)
            }
            /// A component of a foot point is rounded by half an LSB, and a direction is a unit long to within 2^-29,
            /// which leaves 2^-28 of the distance. Two foot points of three components err by less than 2 LSB and 2^-26
            /// of the distance together; twice that is added.
            fn swollen(self, distance: Self) -> Self {
                let slack = 4 + (distance.to_bits().unsigned_abs() >> 25).cast_signed();
                Self::from_bits(self.to_bits() + slack)
            }
            /// A foot point errs by 2 LSB and 2^-26 of its distance, which is below 2^31 LSB; twice that, and what the
            /// reciprocal of a direction is wrong by, 2^-29 of as much.
            fn margin(self) -> Self {
                Self::from_bits(72)
            }
            fn either_side(self, by: Self) -> [Self; 2] {
                [self.saturating_sub(by), self.saturating_add(by)]
            }
            #[inline]
            fn coarse(self) -> f32 {
                lanes::coarse(self.to_bits(), $bits)
            }
            /// Its own [`Scalar::margin`] is the same for all places.
            #[inline]
            fn coarse_margin(far: f32) -> f32 {
                lanes::margin(far, lanes::coarse(72, $bits))
            }
            fn next_up(self) -> Self {
                self.saturating_add(Self::DELTA)
            }
            fn odd_tile(self) -> bool {
                integer::odd_third(i64::from(self.to_bits() >> $bits))
            }
            fn odd_far_tile(self, slope: I2F30, height: Self, fall: I2F30) -> bool {
                let way = Reciprocal::of(fall.to_bits().unsigned_abs()).times(height.to_bits());
                let slope = i64::from(slope.to_bits());
                // 32 bits of the way are as many as the fall has.
                let cut = (64 - way.leading_zeros()).saturating_sub(32);
                let offset = shift_right((way >> cut) * slope, UNIT_BITS - cut);
                integer::odd_third((i64::from(self.to_bits()) + offset) >> $bits)
            }
            fn power(mantissa: u32, exponent: i16) -> Power {
                if mantissa == 0 {
                    return Power { mantissa, exponent: 0 };
                }
                #[allow(clippy::cast_possible_truncation)] // at most 32
                let shift = mantissa.leading_zeros() as i16;
                Power { mantissa: mantissa << shift, exponent: exponent.saturating_sub(shift) }
            }
            fn intensity(power: Power) -> Radiance {
                radiance(u64::from(power.mantissa), i32::from(power.exponent) + LIGHT_BITS.cast_signed())
            }
            fn fall_off(power: Power, distance: Reciprocal) -> Radiance {
                let (y, e) = distance.parts();
                let square = integer::wide_unsigned(y, y) >> 30; // at most 2^32, of 2^(30 + 2e)
                let exponent = i32::from(power.exponent) - 30 - 2 * i32::from(e) + 2 * $bits;
                radiance(u64::from(power.mantissa) * square, exponent + LIGHT_BITS.cast_signed())
            }
        }

        impl LengthVector for Xyz<$f> {
            type Scalar = $f;
            fn dot(self, direction: Xyz<I2F30>) -> $f {
                let p = self.zip(direction, |a, b| wide(a.to_bits(), b.to_bits()));
                <$f>::from_bits(round(p.x + p.y + p.z))
            }
            fn norm_squared(self) -> $wide {
                self.x.square() + self.y.square() + self.z.square()
            }
            fn along(self, direction: Xyz<I2F30>, distance: $f) -> Self {
                self.zip(direction, |p, d| {
                    let (p, way) = (i64::from(p.to_bits()), wide(d.to_bits(), distance.to_bits()));
                    <$f>::from_bits(round((p << UNIT_BITS) + way))
                })
            }
            fn reject(self, direction: Xyz<I2F30>, distance: $f) -> Self {
                self.along(direction, -distance)
            }
            fn local(self, direction: Xyz<I2F30>, distance: $f, radius: Reciprocal) -> Xyz<I2F30> {
                let (y, e) = radius.parts();
                self.zip(direction, |f, d| {
                    // Exact, then cut to the size of the radius: 30 bits of it are left.
                    let place = wide(d.to_bits(), distance.to_bits()) - (i64::from(f.to_bits()) << UNIT_BITS);
                    let place = shift_right_by(place, u32::from(e));
                    I2F30::from_bits(round(place * i64::from(y)))
                })
            }
            fn normalize(self) -> Option<(Xyz<I2F30>, $f, Reciprocal)> {
                let (direction, length, reciprocal) = normalize(self.map(<$f>::to_bits))?;
                Some((direction, <$f>::from_bits(word(i64::from(length))), reciprocal))
            }
            /// The place `p = c + r n` is rounded by half an LSB in each component, sqrt(3)/2 LSB in all, and `n` by less
            /// than that over `r` in the admitted range. Four LSBs leave more than 3 between the place and the surface.
            /// The foot point of a ray that leaves, `l`, is rounded by as much again, so that `|l|^2 - r^2` errs by at
            /// most `1.8 r` LSB, while it is `6 r` LSB for a tangent: the nearest and the farther root stay behind.
            fn clearance(self, extent: $f) -> ($f, $f) {
                let step = LEAVE_LSB + (extent.to_bits() >> LOCAL_BITS);
                (<$f>::from_bits(step), <$f>::from_bits(6 * step))
            }
            fn dot_plan(self, plan: Plan<$f>) -> $f {
                let (x, y) = (self.x.to_bits(), self.y.to_bits());
                <$f>::from_bits(round(wide(x, plan.x.to_bits()) + wide(y, plan.y.to_bits())))
            }
            fn cross_plan(self, plan: Plan<$f>) -> $f {
                let (x, y) = (self.x.to_bits(), self.y.to_bits());
                <$f>::from_bits(round(wide(x, plan.y.to_bits()) - wide(y, plan.x.to_bits())))
            }
            fn cross_plan_over(self, plan: Plan<$f>, radius: Reciprocal) -> I2F30 {
                let (x, y) = (self.x.to_bits(), self.y.to_bits());
                let (mantissa, e) = radius.parts();
                let across = wide(x, plan.y.to_bits()) - wide(y, plan.x.to_bits());
                let across = shift_right_by(across, u32::from(e));
                let one = 1 << UNIT_BITS;
                I2F30::from_bits(word(shift_right(across * i64::from(mantissa), UNIT_BITS).clamp(-one, one)))
            }
        }
    };
}

fixed_point!(I16F16, I32F32, 16);
fixed_point!(I12F20, I24F40, 20);
