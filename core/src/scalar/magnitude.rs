//! Upper bounds of absolute values, for interval arithmetic without floats.

use core::fmt;

use super::Number;
use super::integer::{Reciprocal, sqrt};

/// An upper bound of an absolute value: `mantissa * 2^exponent`, the mantissa's top bit set unless it is 0. Sums, products and
/// quotients of bounds are bounds; each operation rounds up by less than 2^-31 of the result.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Magnitude {
    // First, so that it is compared first.
    exponent: i32,
    mantissa: u32,
}

impl Magnitude {
    /// The bound 0.
    pub const ZERO: Self = Self { mantissa: 0, exponent: i32::MIN / 4 };

    /// Returns `value * 2^exponent`, rounded up.
    #[allow(clippy::cast_possible_truncation)] // shifted to 32 bits
    pub const fn new(value: u64, exponent: i32) -> Self {
        if value == 0 {
            return Self::ZERO;
        }
        let shift = 32 - value.leading_zeros().cast_signed();
        let (mantissa, shift) = if shift > 0 {
            let floor = value >> shift;
            let up = floor + (floor << shift != value) as u64;
            if up >> 32 != 0 { (1 << 31, shift + 1) } else { (up as u32, shift) }
        } else {
            ((value << -shift) as u32, shift)
        };
        Self { mantissa, exponent: exponent + shift }
    }

    /// Returns the mantissa and the exponent.
    pub const fn parts(self) -> (u32, i32) {
        (self.mantissa, self.exponent)
    }

    /// Returns the bound times `2^by`.
    pub const fn shift(self, by: i32) -> Self {
        Self { mantissa: self.mantissa, exponent: self.exponent + by }
    }

    /// Returns the sum.
    pub fn plus(self, other: Self) -> Self {
        let (large, small) = if self > other { (self, other) } else { (other, self) };
        let apart = u32::try_from(large.exponent - small.exponent).unwrap_or(0);
        let wide = u64::from(large.mantissa) << 31;
        let small =
            (u64::from(small.mantissa) << 31).checked_shr(apart).unwrap_or(0) + u64::from(small.mantissa > 0);
        Self::new(wide + small, large.exponent - 31)
    }

    /// Returns the difference, for an `other` that is not larger, rounded up by at most 2^-31 of `self`: 0 or more.
    pub fn minus(self, other: Self) -> Self {
        let apart = u32::try_from(self.exponent - other.exponent).unwrap_or(0);
        let small = (u64::from(other.mantissa) << 31).checked_shr(apart).unwrap_or(0);
        Self::new((u64::from(self.mantissa) << 31).saturating_sub(small), self.exponent - 31)
    }

    /// Returns the product.
    // Not inlined in firmware, as the quotient is not: 640 bytes less with cook-torrance on a Cortex-M0, 1 % more instructions.
    #[cfg_attr(target_os = "none", inline(never))]
    pub fn times(self, other: Self) -> Self {
        Self::new(u64::from(self.mantissa) * u64::from(other.mantissa), self.exponent + other.exponent)
    }

    /// Returns the quotient by a divisor that is no bound but exact, as the size of a fixed-point number is; 0 counts as the smallest
    /// number above 0.
    #[cfg_attr(target_os = "none", inline(never))]
    pub fn over(self, other: Self) -> Self {
        // By the reciprocal, made exact: a machine without a division would need 700 bytes of code for one of 64 bits.
        let (divisor, exponent) = match other.mantissa {
            0 => (1 << 31, other.exponent - 31),
            mantissa => (mantissa, other.exponent),
        };
        let mut quotient = (u64::from(self.mantissa) * u64::from(Reciprocal::of(divisor).parts().0)) >> 30;
        let divisor = u64::from(divisor);
        let rest = (u64::from(self.mantissa) << 32).wrapping_sub(quotient * divisor);
        let (mut rest, divisor) = (rest.cast_signed(), divisor.cast_signed());
        while rest > 0 {
            (quotient, rest) = (quotient + 1, rest - divisor);
        }
        while rest <= -divisor {
            (quotient, rest) = (quotient - 1, rest + divisor);
        }
        Self::new(quotient, self.exponent - exponent - 32)
    }

    /// Returns the square root.
    pub fn root(self) -> Self {
        let odd = self.exponent & 1;
        let wide = u64::from(self.mantissa) << (30 + odd);
        let nearest = u64::from(sqrt(wide));
        let floor = nearest - u64::from(nearest * nearest > wide);
        Self::new(floor + u64::from(self.mantissa > 0), (self.exponent - 30 - odd) / 2)
    }
}

impl Number for Magnitude {
    fn size(self) -> Magnitude {
        self
    }
}

impl fmt::Display for Magnitude {
    /// Writes a number in decimals, to at most four places or, where it is very large or small, four digits, rounded up.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { mantissa, exponent } = *self;
        let mantissa = u64::from(mantissa);
        match exponent {
            _ if mantissa == 0 => f.write_str("0"),
            0..=31 => write!(f, "{}", mantissa << exponent),
            -45..0 => {
                let ten_thousandths = (mantissa * 10_000).div_ceil(1 << -exponent);
                let (whole, part) = (ten_thousandths / 10_000, ten_thousandths % 10_000);
                if part == 0 { write!(f, "{whole}") } else { write!(f, "{whole}.{part:04}") }
            }
            _ => {
                let (digits, power) = four_digits(mantissa, exponent);
                let (first, rest) = (digits / 1000, digits % 1000);
                let power = power + 3;
                if rest == 0 { write!(f, "{first}e{power}") } else { write!(f, "{first}.{rest:03}e{power}") }
            }
        }
    }
}

/// Returns `value * 2^exponent` as 1000 to 9999 times a power of ten, and that power, rounded up. `value` is not 0.
fn four_digits(mut value: u64, mut exponent: i32) -> (u64, i32) {
    let mut power = 0;
    // Factors of two become factors of ten, with as many digits on the way as a word holds.
    while exponent > 0 {
        if value.leading_zeros() > 0 {
            (value, exponent) = (value << 1, exponent - 1);
        } else {
            (value, power) = (value.div_ceil(10), power + 1);
        }
    }
    while exponent < 0 {
        if let Some(more) = value.checked_mul(10) {
            (value, power) = (more, power - 1);
        } else {
            (value, exponent) = (value.div_ceil(2), exponent + 1);
        }
    }
    while value > 9999 {
        (value, power) = (value.div_ceil(10), power + 1);
    }
    while value < 1000 {
        (value, power) = (value * 10, power - 1);
    }
    (value, power)
}

/// Returns the size of an `f32`.
pub(super) const fn size32(value: f32) -> Magnitude {
    size(value.to_bits() as u64, 23, 0xff)
}

/// Returns the size of an `f64`.
#[cfg(feature = "f64")]
pub(super) const fn size64(value: f64) -> Magnitude {
    size(value.to_bits(), 52, 0x7ff)
}

/// Returns the size of a number from its bits (IEEE 754), of which `digits` are the fraction, and its largest exponent; of one
/// that is not finite, larger than any other.
#[allow(clippy::cast_possible_truncation)] // 11 bits
const fn size(bits: u64, digits: u32, most: u64) -> Magnitude {
    let (exponent, fraction) = (bits >> digits & most, bits & ((1 << digits) - 1));
    let last_place = exponent as i32 - (most / 2) as i32 - digits.cast_signed();
    match exponent {
        0 => Magnitude::new(fraction, last_place + 1),
        _ => Magnitude::new(fraction | 1 << digits, last_place),
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::string::ToString;

    use super::*;

    fn value(m: Magnitude) -> f64 {
        f64::from(m.mantissa) * 2f64.powi(m.exponent)
    }

    #[test]
    fn arithmetic_bounds_from_above_and_closely() {
        let numbers =
            [1u64, 2, 3, 7, 10, 1 << 31, (1 << 32) - 1, 1 << 32, (1 << 33) + 1, u64::MAX / 3, u64::MAX];
        for a in numbers {
            for b in numbers {
                for shift in [-70, -33, -1, 0, 5, 40] {
                    let (m, n) = (Magnitude::new(a, 0), Magnitude::new(b, shift));
                    let (x, y) = (a as f64, b as f64 * 2f64.powi(shift));
                    let check = |m: Magnitude, exact: f64, what: &str| {
                        assert!(
                            value(m) >= exact * (1.0 - 1e-15),
                            "{what} of {x} and {y}: {} below {exact}",
                            value(m)
                        );
                        assert!(
                            value(m) <= exact * (1.0 + 4e-9),
                            "{what} of {x} and {y}: {} far above {exact}",
                            value(m)
                        );
                    };
                    check(m.plus(n), x + y, "sum");
                    check(m.times(n), x * y, "product");
                    check(m.over(n), x / value(n), "quotient");
                    check(n.root(), y.sqrt(), "root");
                    assert_eq!(m < n, x < y || (x == y && m < n), "order of {x} and {y}");
                }
            }
        }
    }

    #[test]
    fn quotients_are_rounded_up_exactly() {
        let mut state = 1u64;
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state >> 33 | 1 << 31
        };
        let ends = [1 << 31, (1 << 31) + 1, (1 << 32) - 1, (1 << 32) - 2];
        let random = core::iter::repeat_with(|| (number(), number())).take(100_000);
        for (m, n) in random.chain(ends.into_iter().flat_map(|m| ends.map(|n| (m, n)))) {
            let want = Magnitude::new((m << 32).div_ceil(n), -32);
            assert_eq!(Magnitude::new(m, 0).over(Magnitude::new(n, 0)), want, "{m} / {n}");
        }
        let none = Magnitude { exponent: 5, mantissa: 0 };
        assert_eq!(
            Magnitude::new(3, 0).over(none),
            Magnitude::new(3, -5),
            "0 counts as the smallest above 0"
        );
    }

    #[test]
    fn quotients_that_are_exact_are_not_rounded() {
        for divisor in [1, 3, 32, 12_345] {
            assert_eq!(
                Magnitude::new(4096 * divisor, -16).over(Magnitude::new(divisor, -16)).to_string(),
                "4096"
            );
        }
    }

    #[test]
    fn prints_decimals() {
        let show = |value, exponent| std::format!("{}", Magnitude::new(value, exponent));
        assert_eq!(show(32768, 0), "32768");
        assert_eq!(show(3, -1), "1.5000");
        assert_eq!(show(1, 40), "1099511627776");
        assert_eq!(show(3, 99), "1.902e30");
        assert_eq!(show(1, -70), "8.471e-22");
        assert_eq!(show(5 << 60, 1000), "6.177e319");
        assert_eq!(show(125, -60), "1.085e-16");
        assert_eq!(show(0, 0), "0");
    }
}
