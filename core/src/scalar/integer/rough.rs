//! Functions of rough surfaces: the square of an arc by its series, Sancer's shadowing by a table that is made at compile time
//! from integers.

use super::{shift_right, sqrt};

/// `2^30 / (n^2 C(2n, n) / 2^(2n - 1))` for `n` from 1 to 10: the coefficients of `arcsin(sqrt z)^2` in `z`.
const ARC: [i64; 10] = table!(10, i => {
    // Each is the one before times 2 n^2 / ((n + 1) (2 n + 1)); the first is 1. The numerator and the denominator are exact.
    let (mut above, mut below, mut n) = (1u128, 1u128, 1u128);
    while n <= i as u128 {
        above *= 2 * n * n;
        below *= (n + 1) * (2 * n + 1);
        n += 1;
    }
    #[allow(clippy::cast_possible_truncation, reason = "at most 2^30")]
    let coefficient = (((above << 30) + below / 2) / below) as i64;
    coefficient
});

/// Returns `2^30 arcsin(sqrt(z / 2^30))^2`, within 10, for `z` up to 2^29.
#[allow(clippy::cast_possible_truncation, reason = "below 2^30")]
pub fn arc_squared(z: u32) -> u32 {
    let z = z.min(1 << 29);
    // The series gains less than a digit a term at 1/2. Half the arc has a square of a sine of at most 0.1465.
    let halves = z > 1 << 27;
    let z = if halves { (1 << 29) - sqrt(u64::from((1 << 30) - z) << 28) } else { z };
    let z = i64::from(z);
    let series = ARC.into_iter().rev().fold(0, |rest, coefficient| coefficient + shift_right(z * rest, 30));
    let square = shift_right(z * series, 30);
    (if halves { 4 * square } else { square }) as u32
}

/// `2^78 / (2 sqrt pi)`.
const AT_0: i128 = 85_257_919_338_563_446_615_611;

/// `2^30 A U(A)` for `A = i / 32`.
const SHADOWS: [i64; 129] = table!(129, i => {
    // y = A U(A) solves y'' + 2 A y' - 2 y = 0 with y(0) = 1 / (2 sqrt pi), y'(0) = -1/2, so the term of A^(k + 2) is that of
    // A^k times -2 (k - 1) A^2 / ((k + 1) (k + 2)), and of the odd terms only the first is not 0. Terms are up to 2^18.
    let mut term = AT_0;
    let mut sum = AT_0 - ((i as i128) << 72);
    let mut k = 0;
    while k < 120 {
        term = term * (-2 * (k - 1) * (i * i) as i128) / (1024 * (k + 1) * (k + 2));
        sum += term;
        k += 2;
    }
    #[allow(clippy::cast_possible_truncation, reason = "below 2^29")]
    let rounded = ((sum + (1 << 47)) >> 48) as i64;
    rounded
});

/// Returns `2^30 A U(A)` for `A = a / 2^29`, within 1e-6; 0 from A = 4 on, where it is below 1e-9. See
/// [`Positive::shadow`](crate::scalar::Positive::shadow).
#[allow(clippy::cast_possible_truncation, reason = "below 2^29")]
pub fn shadow(a: u32) -> u32 {
    if a >= 1 << 31 {
        return 0;
    }
    // The parabola through three entries, of which the middle one is not the last.
    let middle = (shift_right(i64::from(a), 24) as usize).clamp(1, 127);
    let at = |i: usize| SHADOWS.get(i).copied().unwrap_or(0);
    let (before, here, after) = (at(middle - 1), at(middle), at(middle + 1));
    let t = i64::from(a) - ((middle as i64) << 24); // a part of the step, times 2^24
    let bend = after - 2 * here + before;
    let slope = after - before + shift_right(bend * t, 24);
    (here + shift_right(slope * t, 25)).max(0) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    const ONE: f64 = (1 << 30) as f64;

    #[test]
    fn arcs_are_close() {
        let edges = (0..30).flat_map(|k| [(1u32 << k) - 1, 1 << k, (1 << k) + 1]);
        for z in (0..100_000).map(|i| i * 5368).chain(edges).filter(|&z| z <= 1 << 29) {
            let exact = libm::asin(libm::sqrt(f64::from(z) / ONE)).powi(2) * ONE;
            let off = f64::from(arc_squared(z)) - exact;
            assert!(off.abs() <= 10.0, "{z}: {off}");
        }
    }

    #[test]
    fn shadows_are_close() {
        for i in 0..100_000u32 {
            let a = i * 21_474;
            let x = f64::from(a) / f64::from(1 << 29);
            let exact = libm::exp(-x * x) / (2.0 * core::f64::consts::PI.sqrt()) - x * libm::erfc(x) / 2.0;
            let off = f64::from(shadow(a)) / ONE - exact;
            assert!(off.abs() <= 1e-6, "{x}: {off}");
        }
        assert_eq!((shadow(1 << 31), shadow(u32::MAX)), (0, 0));
    }
}
