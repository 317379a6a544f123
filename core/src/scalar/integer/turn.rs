//! The angle of a direction in the plane.

use super::{Reciprocal, shift_right, wide};

/// Coefficients of `arctan(t) / 2 pi` in odd powers of `t` from 0 to 1, in Q.32: the polynomial of least error, 4e-8.
const ARC: [i32; 7] =
    [683_562_618, -227_745_958, 135_399_342, -90_458_507, 54_427_934, -22_970_642, 4_656_293];

/// Returns the angle from the x axis to `(x, y)`, towards y, in turns in Q2.30: above -1/2, at most 1/2; 0 for `(0, 0)`. Within 5e-8.
pub fn turn(x: i32, y: i32) -> i32 {
    let (a, b) = (x.unsigned_abs(), y.unsigned_abs());
    let (less, more) = (a.min(b), a.max(b));
    // At most 2^30; a size of 2^31 is that of no unit.
    let t = Reciprocal::of(more).times(less.cast_signed()) as i32;
    let times = |p: i32, q: i32| shift_right(wide(p, q), 30) as i32;
    let square = times(t, t);
    let sum = ARC.iter().rev().fold(0, |sum, term| times(sum, square) + term);
    // An eighth of a turn from the nearer axis.
    let arc = shift_right(wide(sum, t), 32) as i32;
    let arc = if b > a { (1 << 28) - arc } else { arc };
    let arc = if x < 0 { (1 << 29) - arc } else { arc };
    if y < 0 { -arc } else { arc }
}

#[cfg(test)]
mod tests {
    use super::turn;

    #[test]
    fn turns_are_those_of_the_arc_tangent() {
        let one = f64::from(1 << 30);
        for k in 0..=100_000 {
            let angle = core::f64::consts::TAU * f64::from(k) / 100_000.0;
            for size in [1.0, 0.3, 1e-5] {
                let (x, y) = ((angle.cos() * size * one) as i32, (angle.sin() * size * one) as i32);
                let exact = f64::from(y).atan2(f64::from(x)) / core::f64::consts::TAU;
                let got = f64::from(turn(x, y)) / one;
                let error = (got - exact).abs();
                assert!(error < 5e-8 || (1.0 - error) < 5e-8, "{x} {y}: {got}, not {exact}");
            }
        }
        let quarter = 1 << 28;
        for (x, y, want) in [(0, 0, 0), (5, 0, 0), (0, 7, quarter), (0, -7, -quarter), (-3, 0, 2 * quarter)] {
            assert_eq!(turn(x, y), want, "{x} {y}");
        }
    }
}
