//! `f32` and `f64` as scalars: glam's vectors, libm's square root. Nothing is fused or reordered: results are those of any IEEE 754 processor.
#![allow(clippy::float_arithmetic)] // the one file of the core that has floats

use super::magnitude::size32;
#[cfg(feature = "f64")]
use super::magnitude::size64;
use super::vector::{LengthVector, Plan, UnitVector, Vector};
use super::{Light, Magnitude, Number, Positive, Scalar, Unit};

mod scale;
mod single {
    pub(super) use super::scale::single as ldexp;
    pub(super) use core::f32::consts::{FRAC_2_SQRT_PI, PI};
    pub(super) use libm::{
        asinf as asin, atan2f as atan2, erfcf as erfc, exp2f as exp2, expf as exp, powf as pow, sqrtf as sqrt,
    };
}

#[cfg(feature = "f64")]
mod double {
    pub(super) use super::scale::double as ldexp;
    pub(super) use core::f64::consts::{FRAC_2_SQRT_PI, PI};
    pub(super) use libm::{asin, atan2, erfc, exp, exp2, pow, sqrt};
}

macro_rules! float {
    ($f:ty, $vec:ty, $libm:ident, $int:ident, $far:expr, $size:path) => {
        impl Number for $f {
            fn size(self) -> Magnitude {
                $size(self)
            }
        }

        impl Unit for $f {
            type Inverse = $f;
            type Positive = $f;
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const LARGEST: Magnitude = $size($far);
            const ROUNDING: Self = 2.0 * <$f>::EPSILON;
            #[inline(always)] // of constants it is one
            fn ratio(numerator: i64, denominator: i64) -> Self {
                numerator as $f / denominator as $f
            }
            fn fraction(numerator: i32, denominator: u32) -> Self {
                numerator as $f / denominator as $f
            }
            fn of_word(word: u32) -> Self {
                let cut = u32::BITS.saturating_sub(<$f>::MANTISSA_DIGITS);
                (word >> cut) as $f / (1u64 << (u32::BITS - cut)) as $f
            }
            fn of_level(level: i32) -> Self {
                level as $f / 65_535.0
            }
            fn turn(x: Self, y: Self) -> Self {
                // The other end of the half circle for a y of -0.
                $libm::atan2(y + 0.0, x) / (2.0 * $libm::PI)
            }
            fn times(self, factor: Self) -> Self {
                self * factor
            }
            fn over(self, divisor: $f) -> Self {
                self * divisor
            }
            fn root(self, part: u32) -> Self {
                $libm::pow(self, part as $f / 4_294_967_296.0)
            }
            fn quotient(self, divisor: Self) -> Self {
                self / divisor
            }
            fn arc_squared(self) -> Self {
                let arc = $libm::asin($libm::sqrt(self));
                arc * arc
            }
            fn positive(self) -> Self {
                self.max(0.0)
            }
            fn radical(a: Self, b: Self, minus: Self) -> Option<Self> {
                // (a - m)(a + m) keeps the digits that a^2 - m^2 would cancel.
                let square = (a - minus) * (a + minus) + b * b;
                if square < 0.0 { None } else { Some($libm::sqrt(square)) }
            }
        }

        impl Positive for $f {
            type Unit = $f;
            #[cfg_attr(not(target_os = "none"), inline)] // of constants it is one
            fn new(value: u64, exponent: i32) -> Self {
                $libm::ldexp(value as $f, exponent)
            }
            fn plus(self, other: Self) -> Self {
                self + other
            }
            fn times(self, other: Self) -> Self {
                self * other
            }
            fn over(self, divisor: Self) -> Self {
                self / divisor
            }
            fn root(self) -> Self {
                $libm::sqrt(self)
            }
            fn unit(self) -> Self {
                self
            }
            fn exp2_minus(self) -> Self {
                $libm::exp2(-self)
            }
            fn shadow(self) -> Self {
                $libm::FRAC_2_SQRT_PI / 4.0 * $libm::exp(-self * self) - 0.5 * self * $libm::erfc(self)
            }
        }

        impl Light for $f {
            type Unit = $f;
            const ZERO: Self = 0.0;
            const WHITE: Self = 1.0;
            const LARGEST: Magnitude = $size($far);
            fn plus(self, other: Self) -> Self {
                self + other
            }
            fn times(self, factor: Self) -> Self {
                self * factor
            }
            fn scaled(self, by: Self) -> Self {
                self * by
            }
            #[cfg_attr(target_os = "none", inline(never))] // three registers ask
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a float's cast saturates
            fn level(self, max: u8) -> u8 {
                // Without a branch that depends on the light.
                let light = if self >= 1.0 { 1.0 } else { self };
                (light * max as $f + 0.5) as i32 as u8
            }
        }

        impl Scalar for $f {
            type Unit = $f;
            type Wide = $f;
            type Light = $f;
            type Power = $f;
            type Inverse = $f;
            type Vector = $vec;
            type UnitVector = $vec;

            const ZERO: Self = 0.0;
            const FAR: Self = $far;
            // Three squares of FAR still add up to a finite number.
            const LARGEST_SQUARE: Magnitude = $size($far * $far);
            const LARGEST_PRODUCT: Magnitude = $size($far * $far);
            const LARGEST_STRETCH: Magnitude = $size(1.0 / <$f>::EPSILON);
            const CLEARANCE: Magnitude = Magnitude::ZERO;

            fn at_most(size: Magnitude) -> Self {
                let (mantissa, exponent) = size.parts();
                // Cut to the digits of the smaller float, so that it is not rounded up.
                <$f as Scalar>::power(mantissa & !0xff, i16::try_from(exponent).unwrap_or(i16::MAX)).min($far)
            }
            fn scale(self, factor: Self) -> Self {
                self * factor
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn product(self, other: Self) -> Self {
                self * other
            }
            fn part(part: Self, whole: Self) -> Self {
                if part == whole { 1.0 } else { part / whole }
            }
            fn sqrt(square: Self) -> Self {
                if square > 0.0 { $libm::sqrt(square) } else { 0.0 }
            }
            fn positive(self) -> Self {
                self.max(0.0)
            }
            fn inverse(self) -> Self {
                1.0 / self
            }
            fn fraction(self, whole: Self) -> Self {
                self * whole
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn stretch(self, slope: Self) -> Self {
                let last = <$f>::next_down($far);
                (self * slope).clamp(-last, last)
            }
            fn over(self, slope: Self) -> Self {
                (self / slope).min($far)
            }
            /// A component of a foot errs by at most `4 u (|b| + r)`, `u = EPSILON / 2`; two of three by `7 EPSILON` of it. 16 are added.
            fn padded(self, distance: Self) -> Self {
                self + 16.0 * <$f>::EPSILON * (distance.abs() + self)
            }
            fn next_up(self) -> Self {
                Self::from_bits(self.to_bits() + 1)
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn at_one_place(self, extent: Self, cosine: Self) -> Self {
                (self + 2.0 * <$f>::EPSILON * (self + extent) / cosine).min($far)
            }
            #[allow(clippy::cast_possible_truncation)] // a float's cast saturates; then the low word is asked for
            fn lattice(self, frequency: u32) -> i32 {
                libm::floor(f64::from(self) * f64::from(frequency) / 256.0) as i64 as i32
            }
            fn of_lattice(place: i32) -> Self {
                place as $f / 65_536.0
            }
            #[cfg_attr(target_os = "none", inline(never))] // four places ask
            #[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss)] // within its digits
            fn odd_tile(self, tile: Option<Self>) -> bool {
                let tile = self / tile.unwrap_or(3.0);
                // Beyond twice its digits a float is an even number.
                if tile.abs() >= 4.0 / <$f>::EPSILON {
                    return false;
                }
                let cut = tile as $int;
                let floor = cut - $int::from(cut as $f > tile);
                floor & 1 == 1
            }
            fn odd_far_tile(self, slope: Self, height: Self, fall: Self, tile: Option<Self>) -> bool {
                (self + slope * (height / fall)).odd_tile(tile)
            }
            fn power(mantissa: u32, exponent: i16) -> Self {
                let step: $f = if exponent < 0 { 0.5 } else { 2.0 };
                (0..exponent.unsigned_abs()).fold(mantissa as $f, |power, _| power * step)
            }
            fn intensity(power: Self) -> Self {
                power
            }
            fn fall_off(power: Self, distance: Self) -> Self {
                // A lamp that all but touches the point: infinity times a cosine of 0 would be no number.
                (power * distance * distance).min($far)
            }
        }

        impl Vector for $vec {
            type Component = $f;
            fn new(x: $f, y: $f, z: $f) -> Self {
                Self::new(x, y, z)
            }
            fn x(self) -> $f {
                self.x
            }
            fn y(self) -> $f {
                self.y
            }
            fn z(self) -> $f {
                self.z
            }
        }

        impl LengthVector for $vec {
            type Scalar = $f;
            fn dot(self, direction: Self) -> $f {
                self.dot(direction)
            }
            fn norm_squared(self) -> $f {
                self.length_squared()
            }
            fn along(self, direction: Self, distance: $f) -> Self {
                self + direction * distance
            }
            fn local(self, direction: Self, distance: $f, radius: $f) -> Self {
                (direction * distance - self) * radius
            }
            fn normalize(self) -> Option<(Self, $f, $f)> {
                let length = $libm::sqrt(self.length_squared());
                let inverse = 1.0 / length;
                if inverse < <$f>::INFINITY { Some((self * inverse, length, inverse)) } else { None }
            }
            /// The place `p = c + r n` carries at most the rounding of its sum, `u |p|`, that of `r n`, `u r`, and `r` times the error of the
            /// normal, about `4 u`, in each component, with `u = EPSILON / 2`. The offset is `8 EPSILON (|p| + r)`, three times their sum: the
            /// rest answers for the rounding of the foot point when the ray that leaves is tested against the surface it left.
            fn clearance(self, extent: $f) -> ($f, $f) {
                let step = 8.0 * <$f>::EPSILON * (self.abs().max_element() + extent);
                (step, 6.0 * step)
            }
            fn dot_plan(self, plan: Plan<$f>) -> $f {
                self.x * plan.x + self.y * plan.y
            }
            fn cross_plan(self, plan: Plan<$f>) -> $f {
                self.x * plan.y - self.y * plan.x
            }
            #[cfg_attr(not(target_os = "none"), inline)]
            fn cross_plan_over(self, plan: Plan<$f>, radius: $f) -> $f {
                (self.cross_plan(plan) * radius).clamp(-1.0, 1.0)
            }
        }

        impl UnitVector for $vec {
            const X: Self = Self::X;
            const Y: Self = Self::Y;
            const Z: Self = Self::Z;
            fn dot(self, other: Self) -> $f {
                self.dot(other)
            }
            fn cross(self, other: Self) -> Self {
                self.cross(other)
            }
            fn scale(self, factor: $f) -> Self {
                self * factor
            }
            fn plus(self, other: Self, factor: $f) -> Self {
                self + other * factor
            }
            fn normalize(self) -> Option<(Self, $f)> {
                let inverse = 1.0 / $libm::sqrt(self.length_squared());
                if inverse < <$f>::INFINITY { Some((self * inverse, inverse)) } else { None }
            }
            // By itself, without the third square of the default.
            fn plan<S: Scalar<Unit = $f>>(self) -> Option<Plan<S>> {
                let stretch = 1.0 / $libm::sqrt(self.x * self.x + self.y * self.y);
                (stretch < <$f>::INFINITY).then(|| Plan { x: self.x * stretch, y: self.y * stretch, stretch })
            }
            fn reflect(self, normal: Self) -> Self {
                self - normal * (2.0 * self.dot(normal))
            }
            fn halfway(self, other: Self) -> Option<Self> {
                UnitVector::normalize(self + other).map(|(halfway, _)| halfway)
            }
            fn half_chord(self, radius: $f) -> Option<$f> {
                let square = radius * radius - self.length_squared();
                if square < 0.0 { None } else { Some($libm::sqrt(square)) }
            }
        }
    };
}

float!(f32, glam::Vec3, single, i32, 1e18, size32);
#[cfg(feature = "f64")]
float!(f64, glam::DVec3, double, i64, 1e150, size64);
