//! Form factors that are known exactly, in f64: what the others are tested against.

use core::f64::consts::{PI, TAU};
use libm::{atan, atan2, log, sqrt};

/// Returns the factor between two equal rectangles `a x b` that face each other at the distance `c`.
pub fn parallel(a: f64, b: f64, c: f64) -> f64 {
    let (x, y) = (a / c, b / c);
    let (x2, y2) = (1.0 + x * x, 1.0 + y * y);
    let (root_x, root_y) = (sqrt(x2), sqrt(y2));
    let sum =
        log(sqrt(x2 * y2 / (x2 + y2 - 1.0))) + x * root_y * atan(x / root_y) + y * root_x * atan(y / root_x)
            - x * atan(x)
            - y * atan(y);
    2.0 / (PI * x * y) * sum
}

/// Returns the factor from a rectangle `w x l` to one `h x l` at right angles, which have the side `l` in common.
pub fn perpendicular(w: f64, h: f64, l: f64) -> f64 {
    let (w, h) = (w / l, h / l);
    let (w2, h2) = (w * w, h * h);
    let (both, own, other) = (w2 + h2, 1.0 + w2, 1.0 + h2);
    let all = 1.0 + both;
    let logs =
        log(own * other / all) + w2 * log(w2 * all / (own * both)) + h2 * log(h2 * all / (other * both));
    let root = sqrt(both);
    (w * atan(1.0 / w) + h * atan(1.0 / h) - root * atan(1.0 / root) + logs / 4.0) / (PI * w)
}

/// Returns the factor from a disc of the radius `r1` to one of the radius `r2` on the same axis, at the distance `h`.
pub fn discs(r1: f64, r2: f64, h: f64) -> f64 {
    let (own, other) = (r1 / h, r2 / h);
    let x = 1.0 + (1.0 + other * other) / (own * own);
    let ratio = r2 / r1;
    (x - sqrt(x * x - 4.0 * ratio * ratio)) / 2.0
}

/// Adds up `(-1)^(i + j + k + l) f` over the ends of four intervals.
fn corners(intervals: [[f64; 2]; 4], f: impl Fn([f64; 4]) -> f64) -> f64 {
    (0..16u32)
        .map(|bits| {
            let mut k = 0;
            let ends = intervals.map(|[from, to]| {
                let end = if bits >> k & 1 == 0 { from } else { to };
                k += 1;
                end
            });
            let value = f(ends);
            if bits.count_ones().is_multiple_of(2) { value } else { -value }
        })
        .sum()
}

/// Returns area times factor between two rectangles on parallel planes at the distance `z`, one over the intervals `x` and `y`, the other
/// over `u` and `v` of the same axes.
pub fn offset_parallel(x: [f64; 2], y: [f64; 2], u: [f64; 2], v: [f64; 2], z: f64) -> f64 {
    corners([x, y, u, v], |[x, y, u, v]| {
        let (p, q) = (x - u, y - v);
        let (s, r) = (sqrt(p * p + z * z), sqrt(q * q + z * z));
        (q * s * atan(q / s) + p * r * atan(p / r) - z * z / 2.0 * log(p * p + q * q + z * z)) / TAU
    })
}

/// Returns area times factor between two rectangles on planes at right angles: one over `x`, its distance from the line that the planes have
/// in common, and `y` along that line, the other over `z`, its distance, and `v` along the line.
pub fn offset_perpendicular(x: [f64; 2], y: [f64; 2], z: [f64; 2], v: [f64; 2]) -> f64 {
    corners([x, y, z, v], |[x, y, z, v]| {
        let (q, s) = (y - v, sqrt(x * x + z * z));
        let square = s * s + q * q;
        let logs = if square > 0.0 { (s * s - q * q) / 4.0 * log(square) } else { 0.0 };
        // The angle of q and s, which is 0 where both are.
        (if s > 0.0 { q * s * atan2(q, s) } else { 0.0 } - logs) / TAU
    })
}

/// Places and weights of Gauss and Legendre on the interval from 0 to 1, for 2, 3 and 5 points; `None` for other numbers.
fn gauss_legendre(points: u8) -> Option<&'static [(f64, f64)]> {
    const TWO: [(f64, f64); 2] = [(0.211_324_865_405_187_1, 0.5), (0.788_675_134_594_812_9, 0.5)];
    const THREE: [(f64, f64); 3] =
        [(0.112_701_665_379_258_3, 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.887_298_334_620_741_7, 5.0 / 18.0)];
    const FIVE: [(f64, f64); 5] = [
        (0.046_910_077_030_668, 0.118_463_442_528_094_54),
        (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
        (0.5, 0.284_444_444_444_444_44),
        (0.769_234_655_052_841_5, 0.239_314_335_249_683_23),
        (0.953_089_922_969_332, 0.118_463_442_528_094_54),
    ];
    match points {
        2 => Some(&TWO),
        3 => Some(&THREE),
        5 => Some(&FIVE),
        _ => None,
    }
}

/// Returns area times factor between two polygons that see each other whole, as an integral along both outlines (Goral et al. 1984):
/// `1/2pi` times that of `ln r dx.dy`, with 2, 3 or 5 points on each edge; `None` for other numbers of points. Both run counterclockwise as
/// seen from the other. Edges that meet are beyond so few points.
pub fn contour(one: &[[f64; 3]], other: &[[f64; 3]], points: u8) -> Option<f64> {
    let table = gauss_legendre(points)?;
    let edges = |corners: &[[f64; 3]], sum: &mut dyn FnMut([f64; 3], [f64; 3])| {
        for (&from, &to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            let mut along = to;
            along.iter_mut().zip(from).for_each(|(along, from)| *along -= from);
            sum(from, along);
        }
    };
    let mut whole = 0.0;
    edges(one, &mut |a, along| {
        edges(other, &mut |b, across| {
            let dot: f64 = along.iter().zip(across).map(|(p, q)| p * q).sum();
            if dot == 0.0 {
                return;
            }
            for &(s, first) in table {
                for &(t, second) in table {
                    let place = |k: usize, origin: &[f64; 3], way: &[f64; 3], part: f64| {
                        origin.get(k).zip(way.get(k)).map_or(0.0, |(o, w)| o + w * part)
                    };
                    let square: f64 = (0..3)
                        .map(|k| place(k, &a, &along, s) - place(k, &b, &across, t))
                        .map(|apart| apart * apart)
                        .sum();
                    whole += first * second * dot * log(square) / 2.0;
                }
            }
        });
    });
    Some(whole / TAU)
}
