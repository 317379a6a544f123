//! Logarithm and power with the base 2, for real exponents: tables of 16 cells, made at compile time from integers, and a few
//! terms of a series.

use super::shift_right;

/// 1 in units of 2^-30. The coefficients of series are parts of it that the compiler divides: a division costs code where there is no
/// instruction for it.
const ONE: i64 = 1 << 30;
/// `2^62 ln 2`.
const LN_2: u64 = 0x2c5c_85fd_f473_de6b;
/// `2^30 ln 2`.
const LN_2_30: i64 = (LN_2 >> 32) as i64;
/// `2^30 / ln 2`.
#[allow(clippy::cast_possible_truncation, reason = "below 2^31")]
const PER_LN_2: i64 = ((1u128 << 92) / LN_2 as u128) as i64;

/// The middles of the cells are `(33 + 2 i) / 64`. Their reciprocals times 2^30.
const RECIPROCALS: [i64; 16] = table!(16, i => (64 << 30) / (33 + 2 * i as i64));

/// The negative logarithms of the cells' middles, times 2^36.
const LOGARITHMS: [i64; 16] = table!(16, i => {
    // A bit at a time: squaring doubles the logarithm. The number is (33 + 2 i) / 32, between 1 and 2, times 2^62.
    let mut y = (33 + 2 * i as u128) << 57;
    let mut log = 0;
    let mut bit = 0;
    while bit < 36 {
        y = (y * y) >> 62;
        log *= 2;
        if y >> 63 != 0 {
            y /= 2;
            log += 1;
        }
        bit += 1;
    }
    (1 << 36) - log
});

/// Returns `2^62` times the square root of `x / 2^62`.
const fn root(x: u128) -> u128 {
    (x << 62).isqrt()
}

/// `2^30 2^(-i/16)`.
const POWERS: [i64; 16] = {
    // 2^(-1/16) is the fourth square root of 1/2. Each is rounded down by 2^-62 at most.
    let root = root(root(root(root(1 << 61))));
    let mut power = 1u128 << 62;
    #[allow(clippy::cast_possible_truncation, reason = "at most 2^30")]
    let table = table!(16, i => {
        let rounded = ((power + (1 << 31)) >> 32) as i64;
        power = (power * root) >> 62;
        rounded
    });
    table
};

/// Returns `-2^27 log2(x / 2^30)`, 0 to 30 2^27, within 1, for `x` up to 2^30; an `x` of 0 counts as 1.
#[allow(clippy::cast_possible_truncation, reason = "sizes are at the line")]
pub fn minus_log2(x: u32) -> u32 {
    let x = x.clamp(1, 1 << 30);
    let zeros = x.leading_zeros();
    let m = i64::from(x << zeros); // 2^31 to below 2^32
    let cell = (m >> 27 & 15) as usize;
    let at = |table: &[i64; 16]| table.get(cell).copied().unwrap_or(0);
    // m is 2^32 times the cell's middle times 1 + z, |z| at most 1/33; z times 2^36 is below 2^31.
    let z = ((m - ((33 + 2 * cell as i64) << 26)) * at(&RECIPROCALS)) >> 26;
    // ln(1 + z) = z (1 - z (1/2 - z (1/3 - z (1/4 - z / 5)))), the bracket times 2^30; z^6 / 6 is below 1.3e-10.
    let [first, terms @ ..] = const { [ONE / 5, ONE / 4, ONE / 3, ONE / 2, ONE] };
    let series = terms.into_iter().fold(first, |rest, term| term - ((z * rest) >> 36));
    let log = (((z * series) >> 30) * PER_LN_2) >> 30;
    let whole = (i64::from(zeros) - 2) << 27; // -1 for 2^30 itself, whose mantissa is 1/2
    (whole + shift_right(at(&LOGARITHMS) - log, 9)).max(0) as u32
}

/// Returns `2^30 2^(-x / 2^27)`, within 3.
#[allow(clippy::cast_possible_truncation, reason = "at most 2^30")]
pub fn exp2_minus(x: u32) -> u32 {
    let table = POWERS.get((x >> 23 & 15) as usize).copied().unwrap_or(0);
    // The rest, below 1/16, as a logarithm times 2^34: at most 0.0434.
    let a = (i64::from(x & 0x7f_ffff) * LN_2_30) >> 23;
    // e^-a = 1 - a (1 - a (1/2 - a (1/6 - a / 24))), times 2^30; a^5 / 120 is below 1.3e-9.
    let [first, terms @ ..] = const { [ONE / 24, ONE / 6, ONE / 2, ONE, ONE] };
    let series = terms.into_iter().fold(first, |rest, term| term - ((a * rest) >> 34));
    shift_right(table * series, 30 + (x >> 27)) as u32
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;

    const UNITS: f64 = (1 << 30) as f64;

    #[test]
    fn logarithms_are_close() {
        let numbers = (0..200_000u32).map(|i| i.wrapping_mul(0x9e37_79b9) >> 2 >> (i % 30));
        let edges = (0..=30).flat_map(|k| [(1 << k) - 1, 1 << k, (1u32 << k) + 1]);
        for x in numbers.chain(edges).filter(|x| (1..=1 << 30).contains(x)) {
            let exact = -(f64::from(x) / UNITS).log2() * f64::from(1 << 27);
            let off = f64::from(minus_log2(x)) - exact;
            assert!(off.abs() <= 1.0, "{x}: {off}");
        }
        assert_eq!((minus_log2(1 << 30), minus_log2(1 << 29), minus_log2(1)), (0, 1 << 27, 30 << 27));
    }

    #[test]
    fn powers_are_close() {
        let numbers = (0..200_000u32).map(|i| i.wrapping_mul(0x9e37_79b9) >> (i % 32));
        let edges = (0..=31).map(|k| 1u32 << k);
        for x in numbers.chain(edges) {
            let exact = UNITS * (-f64::from(x) / f64::from(1 << 27)).exp2();
            let off = f64::from(exp2_minus(x)) - exact;
            assert!(off.abs() <= 3.0, "{x}: {off}");
        }
        assert_eq!((exp2_minus(0), exp2_minus(1 << 27)), (1 << 30, 1 << 29));
    }
}
