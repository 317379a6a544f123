//! The number formats and their limits.

use fixed::types::{I2F30, I16F16};
use rta_core::accelerator::Lists;
use rta_core::scalar::{Light, Magnitude, Radiance};
use rta_core::scene::Limits;
use rta_core::{Error, Q16, Q20, Scalar};

use super::moving::proved;
use super::{Narrow, NarrowError, Narrowed, brought};
use crate::description::Description;

/// An intensity as 32 bits and an exponent, rounded to the nearest.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // scaled to [2^31, 2^32[
fn power<S: Scalar>(value: f64) -> S::Power {
    if value <= 0.0 {
        return S::power(0, 0);
    }
    let (mut mantissa, mut exponent) = (value, 0);
    while mantissa >= 4_294_967_295.5 {
        mantissa /= 2.0;
        exponent += 1;
    }
    while mantissa < 2_147_483_648.0 {
        mantissa *= 2.0;
        exponent -= 1;
    }
    S::power(mantissa.round() as u32, exponent)
}

/// Returns the bits of the nearest number with an LSB of 2^-`fraction`, the even one of two, as `fixed` rounds; that takes several
/// times as long, and most of the time of narrowing.
#[allow(clippy::cast_possible_truncation)] // it saturates
fn bits(value: f64, fraction: u32) -> i32 {
    (value * f64::from(1u32 << fraction)).round_ties_even() as i32
}

/// The methods that are compiled here, for the crates above.
macro_rules! compiled_here {
    () => {
        #[inline(never)]
        fn narrowed(description: &Description, aspect: f64) -> Result<Narrowed<Self>, NarrowError> {
            brought(description, aspect)
        }
        #[inline(never)]
        fn limits(scene: &Narrowed<Self>) -> Result<Limits<Self>, Error> {
            proved(scene, Lists)
        }
    };
}

macro_rules! fixed_point {
    ($f:ty, $name:literal) => {
        impl Narrow for $f {
            const NAME: &'static str = $name;
            // Four times the distance that a ray's start stands off a surface.
            const SMALLEST_RADIUS: f64 = 16.0 / (1u64 << <$f>::FRAC_NBITS) as f64;
            const LARGEST_COLOR: f64 = 1.99;
            const LARGEST_LIGHT: f64 = 32767.0;
            const LARGEST_POWER: f64 = 1e9;

            fn largest() -> f64 {
                Self::FAR.to_num()
            }
            fn length(value: f64) -> Self {
                Self::from_bits(bits(value, <$f>::FRAC_NBITS))
            }
            fn unit(value: f64) -> I2F30 {
                I2F30::from_bits(bits(value, I2F30::FRAC_NBITS))
            }
            fn light(value: f64) -> Radiance {
                Radiance(I16F16::from_bits(bits(value, I16F16::FRAC_NBITS)))
            }
            fn power(value: f64) -> <Self as Scalar>::Power {
                power::<Self>(value)
            }
            fn to_f64(self) -> f64 {
                self.to_num()
            }
            fn unit_to_f64(unit: I2F30) -> f64 {
                unit.to_num()
            }
            fn light_to_f64(light: Radiance) -> f64 {
                light.0.to_num()
            }
            fn power_to_f64(power: Magnitude) -> f64 {
                let (mantissa, exponent) = power.parts();
                f64::from(mantissa) * f64::from(exponent).exp2()
            }

            compiled_here!();
        }
    };
}

fixed_point!(Q16, "q16");
fixed_point!(Q20, "q20");

macro_rules! float {
    ($f:ty, $name:literal) => {
        #[allow(clippy::cast_possible_truncation)] // rounding is what narrowing is
        impl Narrow for $f {
            const NAME: &'static str = $name;
            const SMALLEST_RADIUS: f64 = <$f>::MIN_POSITIVE as f64 * 1e20;
            const LARGEST_COLOR: f64 = 1e9;
            const LARGEST_LIGHT: f64 = 1e9;
            const LARGEST_POWER: f64 = 1e15;

            fn largest() -> f64 {
                f64::from(Self::FAR)
            }
            fn length(value: f64) -> Self {
                value as $f
            }
            fn unit(value: f64) -> Self {
                value as $f
            }
            fn light(value: f64) -> Self {
                <$f as Light>::WHITE * value as $f
            }
            fn power(value: f64) -> Self {
                value as $f
            }
            fn to_f64(self) -> f64 {
                self.into()
            }
            fn unit_to_f64(unit: Self) -> f64 {
                unit.into()
            }
            fn light_to_f64(light: Self) -> f64 {
                light.into()
            }
            fn power_to_f64(power: Self) -> f64 {
                power.into()
            }

            compiled_here!();
        }
    };
}

float!(f32, "f32");
float!(f64, "f64");

#[cfg(test)]
mod tests {
    use fastrand::Rng;

    use super::*;

    #[test]
    fn numbers_are_rounded_as_fixed_rounds_them() {
        let mut rng = Rng::with_seed(1);
        let check = |value: f64| {
            assert_eq!(Q16::length(value), Q16::saturating_from_num(value), "{value}");
            assert_eq!(Q20::length(value), Q20::saturating_from_num(value), "{value}");
            assert_eq!(<Q16 as Narrow>::unit(value), I2F30::saturating_from_num(value), "{value}");
            assert_eq!(
                <Q16 as Narrow>::light(value),
                Radiance(I16F16::saturating_from_num(value)),
                "{value}"
            );
        };
        for exponent in -45..20 {
            // Between two numbers too.
            for half in -40..40 {
                check(f64::from(half) / 2.0 * 2f64.powi(exponent));
            }
            for _ in 0..200 {
                check((rng.f64() - 0.5) * 2f64.powi(exponent));
            }
        }
        for value in [0.0, -0.0, 1e300, -1e300, 5e-324, 32_767.999_99, -32_768.0, 1.999_999_999_9, -2.0] {
            check(value);
        }
    }
}
