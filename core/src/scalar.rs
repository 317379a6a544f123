//! Number types: lengths, components of unit vectors, squares, radiances.
//!
//! A picture is drawn in one [`Scalar`]. The quantities of a ray tracer differ in range, so in fixed point each has its own
//! format, which is an associated type of the scalar:
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

mod exponent;
mod fixed;
mod float;
pub mod integer;
mod magnitude;
mod positive;
#[cfg(test)]
#[cfg(feature = "f64")]
pub(crate) mod read;
mod sum;
pub mod vector;

pub use exponent::Exponent;
pub use fixed::{Q16, Q20, Radiance};
pub use magnitude::Magnitude;
pub use positive::Positive;
pub use sum::Summed;
use vector::{LengthVector, UnitVector};

/// A number whose size can be bounded.
pub trait Number: Copy + Debug + PartialEq + Send + Sync + 'static {
    /// Returns a bound of the absolute value.
    fn size(self) -> Magnitude;
}

/// A length: coordinates, radii, distances, in the scene's unit.
pub trait Scalar: Number + PartialOrd + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self> {
    /// A component of a unit vector, a cosine, a coefficient. It holds at least the range [-1.99, 1.99].
    type Unit: Unit<Positive = Self::Power>;
    /// A sum of products of two lengths, unrounded.
    type Wide: Copy + Debug + PartialOrd + Add<Output = Self::Wide> + Sub<Output = Self::Wide>;
    /// Radiance and irradiance.
    type Light: Light<Unit = Self::Unit>;
    /// The intensity of a lamp, 0 or from 1e-4 up to 1e9, and any other number of 0 or more that has no bound.
    type Power: Positive<Unit = Self::Unit>;
    /// The reciprocal of a length, to about 30 bits whatever its size.
    type Inverse: Copy + Debug + PartialEq + Send + Sync;
    /// Three lengths.
    type Vector: LengthVector<Scalar = Self, Component = Self>;
    /// Three components of a unit vector.
    type UnitVector: UnitVector<Component = Self::Unit>;

    /// The length 0.
    const ZERO: Self;
    /// `t_max` of a ray that is not bounded otherwise: the largest length.
    const FAR: Self;
    /// The largest square of a length.
    const LARGEST_SQUARE: Magnitude;
    /// The largest sum of products of a length and a unit.
    const LARGEST_PRODUCT: Magnitude;
    /// The largest ratio of an ellipsoid's radii.
    const LARGEST_STRETCH: Magnitude;
    /// The least distance by which a ray's origin is pushed off a surface, where that is a constant of the format.
    const CLEARANCE: Magnitude;

    /// Returns the largest length that does not exceed `size`.
    fn at_most(size: Magnitude) -> Self;

    /// Returns `self * factor`, rounded.
    fn scale(self, factor: Self::Unit) -> Self;
    /// Returns `self * other`, exact in fixed point.
    fn product(self, other: Self) -> Self::Wide;
    /// Returns `self^2`, exact in fixed point.
    fn square(self) -> Self::Wide {
        self.product(self)
    }
    /// Returns `part / whole`, where both are of one sign and `part` is not larger; 1 for a `whole` of 0.
    fn part(part: Self::Wide, whole: Self::Wide) -> Self::Unit;
    /// Returns the square root; 0 for a negative square.
    fn sqrt(square: Self::Wide) -> Self;
    /// Returns a length of 0 or more as a number without a unit; a negative one counts as 0.
    fn positive(self) -> Self::Power;
    /// Returns `1 / self`, for `self > 0`; for anything else an unspecified value, never a panic.
    fn inverse(self) -> Self::Inverse;
    /// Returns `self / whole` for `0 <= self <= whole`, where `whole` is given by its reciprocal.
    fn fraction(self, whole: Self::Inverse) -> Self::Unit;
    /// Returns `self / slope`, where `slope` (0 to 1) is given by its reciprocal; saturates at the last length before
    /// [`Scalar::FAR`] and at its negative.
    fn stretch(self, slope: <Self::Unit as Unit>::Inverse) -> Self;
    /// Returns `self / slope` for `self >= 0` and `slope > 0`; saturates at [`Scalar::FAR`].
    fn over(self, slope: Self::Unit) -> Self;

    /// Returns the radius `self` of a bounding sphere, enlarged by the greatest rounding error of its foot point and of that of
    /// an object in it, so that a ray that meets the object meets the sphere. `distance` is the distance of the centre along
    /// the ray.
    fn padded(self, distance: Self) -> Self;

    /// Returns the next larger length, for a finite `self` of 0 or more; `self` where there is none.
    fn next_up(self) -> Self;

    /// Returns the distance, at most [`Scalar::FAR`], up to which hits cannot be told from one at the distance `self`: that of a
    /// surface at the same place is farther by no more than its and this one's rounding. `extent` is the size of the other
    /// object, `cosine`, above 0, that of the angle between the ray and its normal.
    fn at_one_place(self, extent: Self, cosine: Self::Unit) -> Self;

    /// Returns the extent to pass to [`LengthVector::clearance`] for an ellipsoid of the extent `self` whose smallest radius is
    /// `thickness` times that. It is larger in fixed point, which loses digits where the ellipsoid is scaled to a sphere.
    #[inline]
    fn squashed(self, _thickness: Self::Unit) -> Self {
        self
    }

    /// Returns whether a coordinate lies in an odd tile of the floor: whether `floor(self / tile)` is odd. `tile` is the side of a tile,
    /// above 0; `None` is 3, which takes no division in fixed point.
    fn odd_tile(self, tile: Option<Self>) -> bool;
    /// Returns whether the coordinate `self + slope * height / fall`, which may exceed [`Scalar::FAR`], lies in an odd tile.
    fn odd_far_tile(self, slope: Self::Unit, height: Self, fall: Self::Unit, tile: Option<Self>) -> bool;

    /// Returns the floor of the coordinate times `frequency / 2^24` in 65536ths, as the low 32 bits of it.
    fn lattice(self, frequency: u32) -> i32;
    /// Returns `place / 65536`, which the format can hold, rounded towards zero where it has fewer bits behind the point.
    fn of_lattice(place: i32) -> Self;

    /// Returns a place on a sphere as seen from a point outside, for a pair of numbers from 0 to 1, in less time than
    /// [`light::area`](crate::light::area) takes; `None` for a format that has no such way. The first two are unit vectors, to the middle of the sphere
    /// and of the normal at the point; `sine`, from 0 to 1, is the sphere's radius over the distance of its middle.
    fn sight(
        _axis_and_normal: (Self::UnitVector, Self::UnitVector),
        _sine: Self::Unit,
        _pair: [Self::Unit; 2],
    ) -> Option<Sight<Self>> {
        None
    }

    /// Returns the intensity `mantissa * 2^exponent`.
    fn power(mantissa: u32, exponent: i16) -> Self::Power;
    /// Returns an intensity as a radiance, for a lamp that is not attenuated; saturates in fixed point.
    fn intensity(power: Self::Power) -> Self::Light;
    /// Returns `power / distance^2`, the irradiance of a lamp (inverse-square law); saturates. `distance` is a reciprocal.
    fn fall_off(power: Self::Power, distance: Self::Inverse) -> Self::Light;
}

/// A place on a sphere as seen from a point outside.
#[derive(Clone, Copy, Debug)]
pub struct Sight<S: Scalar> {
    /// Unit vector to the place.
    pub direction: S::UnitVector,
    /// Cosine of the angle between the normal and that.
    pub cosine: S::Unit,
    /// That cosine over the one between the directions to the place and to the middle of the sphere. In fixed point it saturates at 2.
    pub slanted: S::Unit,
    /// Distance of the place as a part of that of the middle.
    pub reach: S::Unit,
}

/// A number of about 1 or less: a cosine, a weight, a reflectance.
pub trait Unit: Number + PartialOrd + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self> {
    /// The reciprocal of a number in ]0, 2[.
    type Inverse: Copy + Debug + PartialEq + Send + Sync;
    /// A number of 0 or more and of any size.
    type Positive: Positive<Unit = Self>;

    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// The largest absolute value.
    const LARGEST: Magnitude;
    /// More than the rounding error of a sum of a few products of numbers up to 1: 2 EPSILON of a float, or 8 LSB.
    const ROUNDING: Self;
    /// Returns `numerator / denominator`, rounded to the nearest, for `denominator > 0` and values between -2 and 2.
    fn ratio(numerator: i64, denominator: i64) -> Self;
    /// Returns what [`Unit::ratio`] does, for numbers that are known only at run time, without a 64-bit division.
    fn fraction(numerator: i32, denominator: u32) -> Self;
    /// Returns `level / 65535`, for a level of up to 65535 in size.
    fn of_level(level: i32) -> Self;
    /// Returns `word / 2^32`, cut to the bits that the format has behind the point (24 in `f32`), so that it is below 1.
    fn of_word(word: u32) -> Self;
    /// Returns the angle from the x axis to a direction in the plane, towards y, in turns: above -1/2, at most 1/2; 0 for no direction.
    /// Within 5e-8 in fixed point.
    fn turn(x: Self, y: Self) -> Self;
    /// Returns the product, rounded.
    fn times(self, factor: Self) -> Self;
    /// Returns `self / divisor`, where the divisor is given by its reciprocal; saturates at 2 in fixed point.
    fn over(self, divisor: Self::Inverse) -> Self;
    /// Returns `sqrt(a^2 + b^2 - minus^2)`, the difference exact in fixed point; `None` where it is negative.
    fn radical(a: Self, b: Self, minus: Self) -> Option<Self>;
    /// Returns `self / divisor`. In fixed point it saturates at 2, in floating point it may be infinite or NaN.
    fn quotient(self, divisor: Self) -> Self;
    /// Returns `self^(part / 2^32)`, for `self` in [0, 1] and a `part` above 0.
    fn root(self, part: u32) -> Self;
    /// Returns the square root; 0 for a negative number.
    fn sqrt(self) -> Self {
        self.positive().root().unit()
    }
    /// Returns `arcsin(sqrt(self))^2`, for `self` in [0, 1/2]: the square of half an angle (radians) whose cosine is
    /// `1 - 2 self`. Within 1e-8 in fixed point.
    fn arc_squared(self) -> Self;
    /// Returns the number, or 0 for a negative one.
    fn positive(self) -> Self::Positive;
    /// Returns `self^exponent`, for `self` in [0, 1]: by repeated squaring what is whole of the exponent.
    fn power(self, exponent: Exponent) -> Self {
        let (whole, part) = exponent.split();
        let (mut base, mut left, mut product) = (self, whole, Self::ONE);
        while left > 0 {
            if left & 1 == 1 {
                product = product.times(base);
            }
            base = base.times(base);
            left >>= 1;
        }
        if part > 0 { product.times(self.root(part)) } else { product }
    }
}

/// A radiance, 0 or more; 1 is the brightest level of a display. Fixed point saturates at 2^15 on purpose: light that bright
/// stays white through five faint reflections.
pub trait Light: Number + PartialOrd + Summed<Weight = <Self as Light>::Unit> {
    /// The type of the factors of a radiance.
    type Unit: Unit;
    /// No light.
    const ZERO: Self;
    /// The brightest level of a display: radiance 1.
    const WHITE: Self;
    /// The largest radiance.
    const LARGEST: Magnitude;
    /// Returns the sum of two radiances.
    fn plus(self, other: Self) -> Self;
    /// Returns the radiance times `factor`, 0 or more.
    fn times(self, factor: Self::Unit) -> Self;
    /// Returns the radiance times a factor of any size.
    fn scaled(self, by: <Self::Unit as Unit>::Positive) -> Self {
        let (mut light, mut by) = (self, by);
        // Fixed point multiplies by less than 2.
        for _ in 0..32 {
            if by.unit() <= Self::Unit::ONE {
                break;
            }
            by = by.times(Positive::new(1, -1));
            light = light.plus(light);
        }
        light.times(by.unit())
    }
    /// Returns the nearest of the levels `0..=max` of a display whose level `max` is radiance 1.
    fn level(self, max: u8) -> u8;
}
