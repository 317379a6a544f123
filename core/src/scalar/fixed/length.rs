//! Lengths in fixed point, and their vectors.

use fixed::types::{I2F30, I12F20, I16F16, I24F40, I32F32};

use super::sight::sight;
use super::{LIGHT_BITS, Radiance, UNIT_BITS, normalize, radiance, round, saturate, word};
use crate::scalar::integer::{
    self, Reciprocal, shift_right, shift_right_by, wide, wide_mixed, wide_unsigned,
};
use crate::scalar::vector::{LengthVector, Plan, Xyz};
use crate::scalar::{Magnitude, Number, Scalar, Sight};

/// How far a ray's origin is pushed off a surface at least, in LSBs of a length; see [`LengthVector::clearance`].
///
/// The place `p = c + r n` is rounded by half an LSB in each component, sqrt(3)/2 LSB in all, and `n` by less than that over
/// `r` in the admitted range. Four LSBs leave more than 3 between the place and the surface. The foot point `l` of a ray that
/// leaves is rounded by as much again, so that `|l|^2 - r^2` errs by at most `1.8 r` LSB, while it is `6 r` LSB for a tangent:
/// both roots stay behind the ray.
const LEAVE_LSB: i32 = 4;
/// A large object adds its extent times 2^-26: the places that an ellipsoid is seen at, 30 bits of its extent, carry the
/// roundings of a dozen products; times its largest radius over its smallest, which is what squashing takes of the bits.
const LOCAL_BITS: u32 = 26;

macro_rules! fixed_point {
    ($f:ty, $wide:ty, $bits:literal) => {
        impl Scalar for $f {
            type Unit = I2F30;
            type Wide = $wide;
            type Light = Radiance;
            type Power = Magnitude;
            type Inverse = Reciprocal;
            type Vector = Xyz<Self>;
            type UnitVector = Xyz<I2F30>;

            const ZERO: Self = Self::ZERO;
            const FAR: Self = Self::MAX;
            const LARGEST_SQUARE: Magnitude = Magnitude::new(1 << 63, -2 * $bits);
            const LARGEST_PRODUCT: Magnitude = Magnitude::new(1 << 63, -$bits - UNIT_BITS.cast_signed());
            // A squashed direction is then at least 2^18 LSBs long.
            const LARGEST_STRETCH: Magnitude = Magnitude::new(1 << 12, 0);
            const CLEARANCE: Magnitude = Magnitude::new(LEAVE_LSB.cast_unsigned() as u64, -$bits);

            fn at_most(size: Magnitude) -> Self {
                let (mantissa, exponent) = size.parts();
                let bits = match exponent + $bits {
                    0.. => u32::MAX,
                    down => mantissa.checked_shr(down.unsigned_abs()).unwrap_or(0),
                };
                Self::from_bits(saturate(i64::from(bits)))
            }
            fn scale(self, factor: I2F30) -> Self {
                Self::from_bits(round(wide(self.to_bits(), factor.to_bits())))
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn product(self, other: Self) -> $wide {
                <$wide>::from_bits(wide(self.to_bits(), other.to_bits()))
            }
            #[allow(clippy::cast_possible_truncation)] // shifted so that it fits
            fn part(part: $wide, whole: $wide) -> I2F30 {
                let (part, whole) = (part.to_bits().unsigned_abs(), whole.to_bits().unsigned_abs());
                // 31 bits of the whole are left, as many as a reciprocal has.
                let cut = 33u32.saturating_sub(whole.leading_zeros());
                let (part, whole) = ((part >> cut) as u32, (whole >> cut) as u32);
                if part >= whole {
                    return I2F30::ONE;
                }
                I2F30::from_bits(saturate(Reciprocal::of(whole).times(part.cast_signed())))
            }
            fn sqrt(square: Self::Wide) -> Self {
                let root = integer::sqrt(u64::try_from(square.to_bits()).unwrap_or(0));
                Self::from_bits(word(i64::from(root)))
            }
            fn positive(self) -> Magnitude {
                if self < Self::ZERO { Magnitude::ZERO } else { self.size() }
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn inverse(self) -> Reciprocal {
                Reciprocal::of(self.to_bits().unsigned_abs())
            }
            fn fraction(self, whole: Reciprocal) -> I2F30 {
                I2F30::from_bits(saturate(whole.times(self.to_bits())))
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn stretch(self, slope: Reciprocal) -> Self {
                let last = i64::from(i32::MAX - 1);
                Self::from_bits(word(slope.times(self.to_bits()).clamp(-last, last)))
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
            fn padded(self, distance: Self) -> Self {
                let slack = 4 + (distance.to_bits().unsigned_abs() >> 25).cast_signed();
                Self::from_bits(self.to_bits() + slack)
            }
            fn next_up(self) -> Self {
                self.saturating_add(Self::DELTA)
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn at_one_place(self, _extent: Self, cosine: I2F30) -> Self {
                let error = Self::from_bits(LEAVE_LSB + (self.to_bits() >> 28));
                self.saturating_add(Scalar::over(error, cosine))
            }
            fn odd_tile(self, tile: Option<Self>) -> bool {
                match tile {
                    None => integer::odd_third(i64::from(self.to_bits() >> $bits)),
                    Some(tile) => integer::odd_part(self.to_bits().into(), tile.to_bits().unsigned_abs()),
                }
            }
            fn odd_far_tile(self, slope: I2F30, height: Self, fall: I2F30, tile: Option<Self>) -> bool {
                let way = Reciprocal::of(fall.to_bits().unsigned_abs()).times(height.to_bits());
                let slope = i64::from(slope.to_bits());
                // 32 bits of the way are as many as the fall has.
                let cut = (64 - way.leading_zeros()).saturating_sub(32);
                let offset = shift_right((way >> cut) * slope, UNIT_BITS - cut);
                let place = i64::from(self.to_bits()) + offset;
                match tile {
                    None => integer::odd_third(place >> $bits),
                    Some(tile) => integer::odd_part(place, tile.to_bits().unsigned_abs()),
                }
            }
            #[allow(clippy::cast_possible_truncation)] // the low word is asked for
            fn lattice(self, frequency: u32) -> i32 {
                (wide_mixed(self.to_bits(), frequency) >> (24 - 16 + $bits)) as i32
            }
            fn of_lattice(place: i32) -> Self {
                Self::from_bits(word(i64::from(place) << ($bits - 16)))
            }
            fn power(mantissa: u32, exponent: i16) -> Magnitude {
                Magnitude::new(u64::from(mantissa), i32::from(exponent))
            }
            fn sight(
                (axis, normal): (Xyz<I2F30>, Xyz<I2F30>),
                sine: I2F30,
                pair: [I2F30; 2],
            ) -> Option<Sight<Self>> {
                let [axis, normal] = [axis, normal].map(|vector| vector.map(I2F30::to_bits));
                let (direction, parts) = sight((axis, normal), sine.to_bits(), pair.map(I2F30::to_bits));
                let [cosine, slanted, reach] = parts.map(I2F30::from_bits);
                Some(Sight { direction: direction.map(I2F30::from_bits), cosine, slanted, reach })
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn intensity(power: Magnitude) -> Radiance {
                let (mantissa, exponent) = power.parts();
                radiance(u64::from(mantissa), exponent + LIGHT_BITS.cast_signed())
            }
            fn fall_off(power: Magnitude, distance: Reciprocal) -> Radiance {
                let ((mantissa, exponent), (y, e)) = (power.parts(), distance.parts());
                let square = wide_unsigned(y, y) >> 30; // at most 2^32, of 2^(30 + 2e)
                let exponent = exponent - 30 - 2 * i32::from(e) + 2 * $bits;
                radiance(u64::from(mantissa) * square, exponent + LIGHT_BITS.cast_signed())
            }
        }

        impl LengthVector for Xyz<$f> {
            type Scalar = $f;
            #[cfg_attr(not(target_os = "none"), inline)]
            fn dot(self, direction: Xyz<I2F30>) -> $f {
                let p = self.zip(direction, |a, b| wide(a.to_bits(), b.to_bits()));
                <$f>::from_bits(round(p.x + p.y + p.z))
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn norm_squared(self) -> $wide {
                self.x.square() + self.y.square() + self.z.square()
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn along(self, direction: Xyz<I2F30>, distance: $f) -> Self {
                self.zip(direction, |p, d| {
                    let (p, way) = (i64::from(p.to_bits()), wide(d.to_bits(), distance.to_bits()));
                    <$f>::from_bits(round((p << UNIT_BITS) + way))
                })
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn local(self, direction: Xyz<I2F30>, distance: $f, radius: Reciprocal) -> Xyz<I2F30> {
                let (y, e) = radius.parts();
                self.zip(direction, |f, d| {
                    // Exact, then cut to the size of the radius: 30 bits of it are left.
                    let place = wide(d.to_bits(), distance.to_bits()) - (i64::from(f.to_bits()) << UNIT_BITS);
                    let place = shift_right_by(place, u32::from(e));
                    I2F30::from_bits(round(place * i64::from(y)))
                })
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn normalize(self) -> Option<(Xyz<I2F30>, $f, Reciprocal)> {
                let (direction, length, reciprocal) = normalize(self.map(<$f>::to_bits))?;
                Some((direction, <$f>::from_bits(word(i64::from(length))), reciprocal))
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn clearance(self, extent: $f) -> ($f, $f) {
                let step = LEAVE_LSB + (extent.to_bits() >> LOCAL_BITS);
                (<$f>::from_bits(step), <$f>::from_bits(6 * step))
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn dot_plan(self, plan: Plan<$f>) -> $f {
                let (x, y) = (self.x.to_bits(), self.y.to_bits());
                <$f>::from_bits(round(wide(x, plan.x.to_bits()) + wide(y, plan.y.to_bits())))
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn cross_plan(self, plan: Plan<$f>) -> $f {
                let (x, y) = (self.x.to_bits(), self.y.to_bits());
                <$f>::from_bits(round(wide(x, plan.y.to_bits()) - wide(y, plan.x.to_bits())))
            }
            #[cfg_attr(not(target_os = "none"), inline)]
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
