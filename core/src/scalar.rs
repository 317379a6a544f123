//! Numbers: a length, a component of a unit vector, a square, a radiance.
//!
//! A picture is drawn in one [`Scalar`]. The quantities of a ray tracer differ in range, so in fixed point each has a
//! format of its own, and the scalar names them all:
//!
//! | quantity | type | Q16.16 | f32 |
//! | --- | --- | --- | --- |
//! | length, coordinate | the [`Scalar`] | Q16.16 | f32 |
//! | cosine, coefficient, component of a unit vector | [`Scalar::Unit`] | Q2.30 | f32 |
//! | square of a length, unrounded | [`Scalar::Wide`] | Q32.32 | f32 |
//! | radiance, irradiance | [`Scalar::Light`] | Q16.16, saturating | f32 |
//! | intensity of a lamp | [`Scalar::Power`] | 32 bits and an exponent | f32 |
//! | reciprocal of a length | [`Scalar::Inverse`] | 31 bits and an exponent | f32 |
//!
//! Unit vectors in Q2.30 beside lengths in Q16.16 are what makes 32-bit fixed point better than a schoolbook `f32`.
//! All arithmetic of the tracer goes through these traits, so that a test can run two formats in lock step.

use core::fmt::Debug;
use core::ops::{Add, Neg, Sub};

mod fixed;
mod float;
pub mod integer;
mod magnitude;
pub mod vector;

pub use fixed::{Power, Q16, Q20, Radiance};
pub use magnitude::Magnitude;
use vector::{LengthVector, UnitVector};

/// A length: coordinates, radii, distances, in the scene's unit.
pub trait Scalar:
    Copy
    + Debug
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// A component of a unit vector, a cosine, a coefficient: at least [-1.99, 1.99].
    type Unit: Unit;
    /// A sum of products of two lengths, unrounded.
    type Wide: Copy + Debug + PartialOrd + Add<Output = Self::Wide> + Sub<Output = Self::Wide>;
    /// Radiance and irradiance.
    type Light: Light<Unit = Self::Unit>;
    /// The intensity of a lamp, 0 or from 1e-4 up to 1e9.
    type Power: Copy + Debug + PartialEq + Send + Sync;
    /// The reciprocal of a length, to about 30 bits whatever its size.
    type Inverse: Copy + Debug + PartialEq + Send + Sync;
    /// Three lengths.
    type Vector: LengthVector<Scalar = Self, Component = Self>;
    /// Three components of a unit vector.
    type UnitVector: UnitVector<Component = Self::Unit>;

    /// Nothing.
    const ZERO: Self;
    /// `t_max` of a ray that is not bounded otherwise: the largest length.
    const FAR: Self;
    /// The largest square of a length.
    const LARGEST_SQUARE: Magnitude;
    /// The largest sum of products of a length and a unit.
    const LARGEST_PRODUCT: Magnitude;
    /// The largest ratio of an ellipsoid's radii.
    const LARGEST_STRETCH: Magnitude;
    /// How far the start of a ray stands off a surface at least, where that is a constant of the format.
    const CLEARANCE: Magnitude;

    /// The size of a length.
    fn size(self) -> Magnitude;
    /// The largest length that does not exceed a size.
    fn at_most(size: Magnitude) -> Self;
    /// The size of an intensity.
    fn power_size(power: Self::Power) -> Magnitude;

    /// `self * factor`, rounded.
    fn scale(self, factor: Self::Unit) -> Self;
    /// `self^2`, exact in fixed point.
    fn square(self) -> Self::Wide;
    /// Square root of a square; 0 of a negative one.
    fn sqrt(square: Self::Wide) -> Self;
    /// `1 / self`, for `self > 0`; of anything else an unspecified value, never a panic.
    fn inverse(self) -> Self::Inverse;
    /// `self / whole` for `0 <= self <= whole`, where `whole` is given by its reciprocal.
    fn fraction(self, whole: Self::Inverse) -> Self::Unit;
    /// `self / slope`, where `slope` (0 to 1) is given by its reciprocal; saturates at [`Scalar::FAR`] and its negative.
    fn stretch(self, slope: <Self::Unit as Unit>::Inverse) -> Self;
    /// `self / slope` for `self >= 0` and `slope > 0`; saturates at [`Scalar::FAR`].
    fn over(self, slope: Self::Unit) -> Self;

    /// Returns the radius of a sphere that a ray surely meets where it meets one of the things inside the sphere of radius
    /// `self`: larger by what the foot points of both can be wrong together. `distance` is how far along the ray the
    /// centre is.
    fn padded(self, distance: Self) -> Self;

    /// The next larger length of one that is 0 or more and finite; the same where there is none.
    fn next_up(self) -> Self;

    /// The extent that [`LengthVector::clearance`] is to be told of an ellipsoid of the extent `self` whose smallest radius
    /// is the part `thickness` of it. A format with a fixed point loses the digits that squashing the ellipsoid takes.
    #[inline]
    fn squashed(self, _thickness: Self::Unit) -> Self {
        self
    }

    /// Whether a coordinate lies in an odd one of the floor's tiles, which are 3 units wide.
    fn odd_tile(self) -> bool;
    /// The same for the coordinate `self + slope * height / fall`, where the quotient may lie beyond [`Scalar::FAR`].
    fn odd_far_tile(self, slope: Self::Unit, height: Self, fall: Self::Unit) -> bool;

    /// The intensity `mantissa * 2^exponent`.
    fn power(mantissa: u32, exponent: i16) -> Self::Power;
    /// Intensity as a radiance, for a lamp that is not attenuated; saturates.
    fn intensity(power: Self::Power) -> Self::Light;
    /// `power / distance^2`, the irradiance of a lamp (inverse-square law); saturates.
    fn fall_off(power: Self::Power, distance: Self::Inverse) -> Self::Light;
}

/// A number whose size is about one: a cosine, a weight, a reflectance.
pub trait Unit:
    Copy
    + Debug
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// The reciprocal of a number in ]0, 2[.
    type Inverse: Copy + Debug + PartialEq + Send + Sync;

    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// The largest size.
    const LARGEST: Magnitude;
    /// The size.
    fn size(self) -> Magnitude;
    /// `numerator / denominator`, rounded to the nearest; `denominator > 0` and the value below 2 in size.
    fn ratio(numerator: i64, denominator: i64) -> Self;
    /// `numerator / denominator` of numbers that are known only when the program runs; the same value as
    /// [`Unit::ratio`], without a division of 64 bits.
    fn fraction(numerator: i32, denominator: u32) -> Self;
    /// The product, rounded.
    fn times(self, factor: Self) -> Self;
    /// `self / divisor`, where the divisor is given by its reciprocal; saturates at 2.
    fn over(self, divisor: Self::Inverse) -> Self;
    /// `sqrt(a^2 + b^2 - minus^2)`, the difference exact in fixed point; nothing where it is negative.
    fn radical(a: Self, b: Self, minus: Self) -> Option<Self>;
    /// `sqrt(b^2 - a c)`, the difference exact in fixed point; nothing where it is negative.
    fn discriminant(b: Self, a: Self, c: Self) -> Option<Self>;
    /// `self / divisor`; in fixed point it saturates at 2, in float it may be infinite or no number.
    fn quotient(self, divisor: Self) -> Self;
    /// `self^exponent` by squaring, for `self` in [0, 1].
    fn power(self, exponent: u32) -> Self {
        let (mut base, mut left, mut product) = (self, exponent, Self::ONE);
        while left > 0 {
            if left & 1 == 1 {
                product = product.times(base);
            }
            base = base.times(base);
            left >>= 1;
        }
        product
    }
}

/// Radiance: never negative, 1 is the brightest level of a display's gun. Fixed point saturates at its largest value,
/// 15 bits above that, on purpose: what is too bright by such a factor stays white through five faint reflections.
pub trait Light: Copy + Debug + PartialEq + PartialOrd + Send + Sync + 'static {
    /// What a radiance is multiplied with.
    type Unit: Unit;
    /// Darkness.
    const ZERO: Self;
    /// The brightest level of a display.
    const WHITE: Self;
    /// The largest radiance.
    const LARGEST: Magnitude;
    /// The size.
    fn size(self) -> Magnitude;
    /// The sum of two radiances.
    fn plus(self, other: Self) -> Self;
    /// The part `factor` (0 or more) of a radiance.
    fn times(self, factor: Self::Unit) -> Self;
    /// The nearest of the levels `0..=max` of a gun whose level `max` is radiance 1.
    fn level(self, max: u8) -> u8;
}
