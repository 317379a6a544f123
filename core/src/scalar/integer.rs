//! Integer arithmetic under the fixed-point formats: reciprocal square root, square root, reciprocal, on words of 32
//! and 64 bits, with 32 x 32 -> 64 multiplications and no division.
#![allow(clippy::cast_possible_truncation)] // sizes are at the line

pub use exponential::{exp2_minus, minus_log2};
pub use rough::{arc_squared, shadow};
pub use turn::turn;

/// A positive number `m / 2^(30 + e)`, `m` in [2^30, 2^31], as a reciprocal of an integer between 1 and 2^32.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reciprocal {
    mantissa: u32,
    exponent: u8,
}

/// Makes a table at compile time: `$value` for each index `$i`.
macro_rules! table {
    ($length:literal, $i:ident => $value:expr) => {{
        let mut table = [0; $length];
        let mut $i = 0;
        while $i < $length {
            #[allow(clippy::indexing_slicing, reason = "below the length")]
            {
                table[$i] = $value;
            }
            $i += 1;
        }
        table
    }};
}

mod exponential;
mod rough;
mod turn;

/// First guess of [`rsqrt`]: `2^14 / sqrt(i / 64)` for `i` in `16..=64`, at most 2^15.
pub(super) const GUESS: [u16; 49] = table!(49, i => ((64u64 << 28) / (i as u64 + 16)).isqrt() as u16);

/// Returns `2^30 / sqrt(m / 2^32)`, for `m >= 2^30`: the reciprocal square root of a number in [1/4, 1[, within 2 units of
/// the last place (2^-30).
///
/// A table with linear interpolation gives 11 bits, two steps of Newton's iteration the rest.
pub fn rsqrt(m: u32) -> u32 {
    let i = (m >> 26) as usize - 16 * usize::from(m >= 1 << 30);
    let at = |i: usize| u32::from(GUESS.get(i).copied().unwrap_or(1 << 14));
    let (here, next) = (at(i), at(i + 1));
    let part = (m >> 10) & 0xffff;
    let guess = (here << 16) - (here - next) * part; // 2^30 is 1
    let first = {
        let square = wide_unsigned(guess, guess) >> 30; // at most 2^32
        let error = (3u64 << 30).saturating_sub((u64::from(m) * square) >> 32); // about 2^31
        ((u64::from(guess) * error) >> 31) as u32
    };
    let square = (wide_unsigned(first, first) + (1 << 29)) >> 30;
    let error = (1i64 << 62) - (u64::from(m) * square) as i64; // 2^62 (1 - m y^2), below 2^42
    let correction = (i64::from(first) * (error >> 31)) >> 32;
    (i64::from(first) + correction) as u32
}

/// `value << shift` with an even shift such that the top two bits are not both 0, its upper word, and the shift.
fn normalize(value: u64) -> (u64, u32) {
    let shift = value.leading_zeros() & !1;
    (value << (shift & 63), shift)
}

/// Returns the square root, rounded to the nearest (an exact half cannot occur).
#[cfg_attr(not(target_os = "none"), inline)]
pub fn sqrt(value: u64) -> u32 {
    if value == 0 {
        return 0;
    }
    let (wide, shift) = normalize(value);
    let m = (wide >> 32) as u32;
    let y = rsqrt(m);
    // m y is the root of the upper word; one step of Newton's iteration brings in the lower.
    let root = (wide_unsigned(m, y) >> 30).min(u64::from(u32::MAX)); // 2^32 is 1
    let rest = wide.wrapping_sub(wide_unsigned(root as u32, root as u32)) as i64;
    let root = (root as i64 + (((rest >> 31) * i64::from(y)) >> 32)) as u64;
    let half = shift / 2;
    let mut root = (root + ((1 << half) >> 1)) >> half;
    // The nearest root holds root^2 - root < value <= root^2 + root.
    if root * root - root >= value {
        root -= 1;
    } else if root * root + root < value {
        root += 1;
    }
    root.min(u64::from(u32::MAX)) as u32
}

impl Reciprocal {
    /// Returns the reciprocal from its [`Reciprocal::parts`], for generated code.
    pub const fn from_parts(mantissa: u32, exponent: u8) -> Self {
        Self { mantissa, exponent }
    }

    /// Returns `1 / value`; a `value` of 0 counts as 1.
    #[cfg_attr(not(target_os = "none"), inline)]
    pub fn of(value: u32) -> Self {
        let value = value.max(1);
        let exponent = 32 - value.leading_zeros();
        let m = value << (32 - exponent); // [1/2, 1[
        let y = u64::from(rsqrt(m));
        let guess = (y * y) >> 30; // within 8 units, at most 2^31 + 8
        let error = (1i64 << 62) - (u64::from(m) * guess) as i64; // 2^62 (1 - m z), below 2^36
        let mantissa = guess as i64 + (((error >> 16) * guess as i64) >> 46);
        Self { mantissa: mantissa.min(1 << 31) as u32, exponent: exponent as u8 }
    }

    /// Returns `1 / sqrt(square)` and `sqrt(square)`, rounded; a `square` of 0 counts as 1.
    #[cfg_attr(not(target_os = "none"), inline)]
    pub fn of_sqrt(square: u64) -> (Self, u32) {
        let (wide, shift) = normalize(square.max(1));
        let m = (wide >> 32) as u32;
        let mantissa = rsqrt(m);
        let half = shift / 2;
        let root = wide_unsigned(m, mantissa) >> 30; // 2^32 is 1
        let root = ((root + ((1 << half) >> 1)) >> half).min(u64::from(u32::MAX));
        (Self { mantissa, exponent: (32 - half) as u8 }, root as u32)
    }

    /// Returns the reciprocal of `value` if `self` is that of `value << shift`: `self` times `2^shift`.
    pub(crate) fn unscale(self, shift: u32) -> Self {
        Self { exponent: self.exponent.saturating_sub(shift as u8), ..self }
    }

    /// Returns `2^30 factor / value`, rounded.
    #[cfg_attr(not(target_os = "none"), inline)]
    pub fn times(self, factor: i32) -> i64 {
        shift_right_by(wide_mixed(factor, self.mantissa), u32::from(self.exponent))
    }

    /// Returns the mantissa, in [2^30, 2^31], and the exponent `e` of `mantissa / 2^(30 + e)`.
    pub const fn parts(self) -> (u32, u8) {
        (self.mantissa, self.exponent)
    }
}

/// Returns `value / 2^shift`, rounded to the nearest, halves up; `shift < 64`.
pub fn shift_right(value: i64, shift: u32) -> i64 {
    (value + ((1 << shift) >> 1)) >> shift
}

/// Returns what [`shift_right`] does with one 64-bit shift, which is slow on 32-bit processors, for a `shift` known at run time.
pub(crate) fn shift_right_by(value: i64, shift: u32) -> i64 {
    match shift {
        0 => value,
        _ => ((value >> (shift - 1)) + 1) >> 1,
    }
}

/// Whether products of two words are put together from halves: on ARMv6-M, the one ARM profile without compare-and-swap,
/// which has no multiplication with a result of 64 bits either. The compiler's routine takes factors of 64 bits.
const HALVES: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// Returns the product of two words.
#[cfg_attr(all(target_arch = "arm", not(target_has_atomic = "32")), inline(never))]
#[cfg_attr(not(all(target_arch = "arm", not(target_has_atomic = "32"))), inline(always))]
pub(crate) fn wide(a: i32, b: i32) -> i64 {
    if HALVES { wide_by_halves(a, b) } else { i64::from(a) * i64::from(b) }
}

/// Returns the product of a signed and an unsigned word.
#[inline(always)]
pub(crate) fn wide_mixed(a: i32, b: u32) -> i64 {
    if !HALVES {
        return i64::from(a) * i64::from(b);
    }
    // Read with a sign, a large one is 2^32 too little.
    let missing = if b > i32::MAX.cast_unsigned() { i64::from(a) << 32 } else { 0 };
    wide(a, b.cast_signed()) + missing
}

/// Returns the product of two unsigned words.
#[inline(always)]
pub(crate) fn wide_unsigned(a: u32, b: u32) -> u64 {
    if !HALVES {
        return u64::from(a) * u64::from(b);
    }
    let missing = if a > i32::MAX.cast_unsigned() { u64::from(b) << 32 } else { 0 };
    wide_mixed(a.cast_signed(), b).cast_unsigned().wrapping_add(missing)
}

/// Returns the product of two words by four products of half words, none of which overflows.
#[inline(always)]
#[allow(clippy::cast_sign_loss)] // the halves
fn wide_by_halves(a: i32, b: i32) -> i64 {
    let (a_high, b_high) = (a >> 16, b >> 16);
    let (a_low, b_low) = (a as u32 & 0xffff, b as u32 & 0xffff);
    let low = a_low * b_low;
    let middle = a_high * b_low.cast_signed() + (low >> 16).cast_signed();
    let other = a_low.cast_signed() * b_high + (middle & 0xffff);
    let high = a_high * b_high + (middle >> 16) + (other >> 16);
    (i64::from(high) << 32) | i64::from((other as u32) << 16 | low & 0xffff)
}

/// Returns whether `floor(value / 3)` is odd, without a division.
pub fn odd_third(value: i64) -> bool {
    // 2^16, 2^8 and 2^64 are 1 modulo 3, so the sum of the digits leaves what the number does; a negative one has 2^64
    // too much in its bits.
    let digits = [0, 16, 32, 48].map(|place| u32::from((value >> place) as u16));
    let sum = digits.iter().sum::<u32>() + if value < 0 { 2 } else { 0 };
    let sum = (sum & 0xff) + (sum >> 8); // below 2^11
    let rest = sum - 3 * ((sum * 0xaaab) >> 17);
    (rest & 1 == 1) != (value & 1 == 1)
}

/// Returns whether `floor(value / part)` is odd, without a division: exactly where the quotient is below 2^29, and beyond for a value
/// that differs by up to 2^-29 of it. A `part` of 0 counts as 1.
pub fn odd_part(value: i64, part: u32) -> bool {
    let cut = (65 - value.unsigned_abs().leading_zeros()).saturating_sub(32).min(32);
    let quotient = Reciprocal::of(part).times((value >> cut) as i32);
    // Rounding may be one off, which the rest tells.
    let parts = (quotient << 2) >> (32 - cut);
    let part = i64::from(part);
    let rest = value.wrapping_sub(parts.wrapping_mul(part));
    (parts & 1 == 1) != (rest < 0 || rest >= part)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bit patterns that cover each word length densely at its ends and thinly in between.
    fn words() -> impl Iterator<Item = u64> {
        let ends = (0..64).flat_map(|k| (-3i64..4).map(move |d| (1u64 << k).wrapping_add_signed(d)));
        let mut state = 0x9e37_79b9_7f4a_7c15u64;
        let random = (0..200_000).map(move |i| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            state >> (i % 64)
        });
        ends.chain(random)
    }

    #[test]
    fn products_by_halves() {
        let ends = [i32::MIN, i32::MIN + 1, -65_536, -65_535, -1, 0, 1, 32_768, 65_535, 65_536, i32::MAX];
        let all = ends.iter().flat_map(|&a| ends.map(|b| (a, b)));
        for (a, b) in all.chain(words().map(|w| ((w >> 32) as i32, w as i32))) {
            assert_eq!(wide_by_halves(a, b), i64::from(a) * i64::from(b), "{a} x {b}");
        }
    }

    #[test]
    fn shifts_round_alike() {
        for value in words().map(|word| word.cast_signed() >> 2) {
            for shift in 0..62 {
                assert_eq!(shift_right_by(value, shift), shift_right(value, shift), "{value} >> {shift}");
            }
        }
    }

    #[test]
    fn odd_thirds() {
        for value in words().map(u64::cast_signed).chain(-1000..1000) {
            assert_eq!(odd_third(value), value.div_euclid(3) & 1 == 1, "{value}");
        }
    }

    #[test]
    fn odd_parts() {
        for (value, part) in words().map(u64::cast_signed).zip(words().skip(500).map(|word| word as u32 >> 1))
        {
            let exact = value.checked_div_euclid(part.into()).unwrap_or_default();
            for value in [value, exact.wrapping_mul(part.into())] {
                if exact.abs() < 1 << 29 && part > 0 {
                    let odd = value.div_euclid(part.into()) & 1 == 1;
                    assert_eq!(odd_part(value, part), odd, "{value} / {part}");
                }
            }
        }
    }

    #[test]
    fn sqrt_is_the_nearest() {
        for value in words() {
            let root = u128::from(sqrt(value));
            let value = u128::from(value);
            assert!(root * root <= value + root, "sqrt({value}) = {root} is too large");
            assert!(
                root * root + root >= value || root == u128::from(u32::MAX),
                "sqrt({value}) = {root} is too small"
            );
        }
    }

    #[test]
    fn rsqrt_is_within_two_units() {
        for m in words().map(|w| (w >> 32) as u32).filter(|&m| m >= 1 << 30) {
            let exact = ((1u128 << 94) / u128::from(m)).isqrt(); // 2^31 / sqrt(m / 2^32)
            let error = 2 * i64::from(rsqrt(m)) - i64::try_from(exact).expect("it fits");
            assert!(error.abs() <= 4, "rsqrt({m}) is {error} half units off");
        }
    }

    #[test]
    fn reciprocal_is_within_two_units() {
        for value in words().map(|w| (w >> 32) as u32).filter(|&v| v > 0) {
            let (mantissa, exponent) = Reciprocal::of(value).parts();
            let exact = (1u128 << (31 + exponent)) / u128::from(value);
            let error = 2 * i64::from(mantissa) - i64::try_from(exact).expect("it fits");
            assert!(error.abs() <= 4, "1/{value} is {error} half units off");
            assert!((1 << 30..=1 << 31).contains(&mantissa));
        }
    }

    #[test]
    fn root_and_its_reciprocal_agree() {
        for square in words().filter(|&w| w > 0) {
            let (reciprocal, root) = Reciprocal::of_sqrt(square);
            assert!(root.abs_diff(sqrt(square)) <= 1 + (root >> 29), "root of {square}");
            let (mantissa, exponent) = reciprocal.parts();
            let product = (u128::from(mantissa).pow(2) * u128::from(square)) as f64;
            let one = product / 2f64.powi(60 + 2 * i32::from(exponent));
            assert!((one - 1.0).abs() < 4.0 / f64::from(1 << 30), "reciprocal root of {square}: {one}");
        }
    }
}
