//! Sums of many radiances, which are rounded once.

use fixed::types::I16F16;

use super::fixed::Radiance;
use super::integer::wide;
use super::positive::bits;
use super::{Light, Magnitude, Unit};

/// A radiance of which many, each times a weight, are added up before the sum is rounded.
pub trait Summed: Copy {
    /// The type of the weights, from -2 to 2.
    type Weight;
    /// A sum, exact in fixed point for fewer than 2^64 radiances.
    type Sum: Copy;
    /// The sum of no radiances.
    const EMPTY: Self::Sum;
    /// Returns the sum and this radiance times `weight`.
    fn added(self, sum: Self::Sum, weight: Self::Weight) -> Self::Sum;
    /// Returns `factor * sum / whole`, where `whole` is the sum, above 0, of the weights: of as many radiances of 1; 0 for a negative sum.
    /// It is rounded once, to the nearest, and saturates.
    fn mean(sum: Self::Sum, whole: Self::Sum, factor: Self::Weight) -> Self;
}

macro_rules! float {
    ($($f:ty)*) => {
        $(impl Summed for $f {
            type Weight = Self;
            type Sum = Self;
            const EMPTY: Self = 0.0;
            fn added(self, sum: Self, weight: Self) -> Self {
                Light::plus(sum, Light::times(self, weight))
            }
            fn mean(sum: Self, whole: Self, factor: Self) -> Self {
                Unit::positive(Unit::times(sum.quotient(whole), factor))
            }
        })*
    };
}

float!(f32);
#[cfg(feature = "f64")]
float!(f64);

impl Summed for Radiance {
    type Weight = <Self as Light>::Unit;
    /// In units of 2^-46.
    type Sum = i128;
    const EMPTY: i128 = 0;
    fn added(self, sum: i128, weight: Self::Weight) -> i128 {
        sum + i128::from(wide(self.0.to_bits(), weight.to_bits()))
    }
    fn mean(sum: i128, whole: i128, factor: Self::Weight) -> Self {
        let mean = magnitude(sum).times(factor.positive()).over(magnitude(whole));
        let bits = bits(mean, I16F16::FRAC_NBITS.cast_signed());
        Self(I16F16::from_bits(bits.min(i32::MAX.cast_unsigned()).cast_signed()))
    }
}

/// Returns a number as a bound, which differs from it by at most 2^-31 of it; 0 for a negative one.
#[allow(clippy::cast_possible_truncation, reason = "shifted to 64 bits")]
fn magnitude(number: i128) -> Magnitude {
    let number = number.max(0).cast_unsigned();
    let cut = u64::BITS.saturating_sub(number.leading_zeros());
    Magnitude::new((number >> cut) as u64, cut.cast_signed())
}

#[cfg(test)]
mod tests {
    use super::{I16F16, Radiance, Summed};
    use crate::{Q16, Scalar};

    type Fixed = <Q16 as Scalar>::Unit;

    #[test]
    fn means_are_exact_and_rounded_once() {
        let of = |bits| Radiance(I16F16::from_bits(bits));
        let mean = |light: &[(i32, f32)], factor: f32| {
            let (mut sum, mut whole) = (Radiance::EMPTY, Radiance::EMPTY);
            for &(bits, weight) in light {
                let weight = Fixed::from_num(weight);
                sum = of(bits).added(sum, weight);
                whole = of(1 << 16).added(whole, weight);
            }
            Radiance::mean(sum, whole, Fixed::from_num(factor)).0.to_bits()
        };
        assert_eq!(mean(&[(1, 1.0); 16384], 1.0), 1, "the smallest light");
        assert_eq!(mean(&[(i32::MAX, 1.0); 16384], 1.0), i32::MAX, "the largest");
        assert_eq!(mean(&[(3, 1.0), (4, 1.0), (4, 1.0), (4, 1.0)], 1.0), 4, "3.75");
        assert_eq!(mean(&[(5, 1.0), (5, 1.0)], 0.5), 3, "2.5");
        assert_eq!(mean(&[(1 << 16, 0.25), (1 << 17, 0.75)], 1.0), 7 << 14, "weights");
        assert_eq!(mean(&[(1 << 16, 1.5), (1 << 17, -0.5)], 1.0), 1 << 15, "below 0 on the way");
        assert_eq!(mean(&[(0, 1.5), (1 << 17, -0.5)], 1.0), 0, "below 0");
    }
}
