//! The functions of what spreads rays: the sampler, edges of shadows, the lens, and rough surfaces.

use rta_core::light::cover::{beyond, covered};
use rta_core::sampling::mapping::Facets;
use rta_core::sampling::pairs::{Pairs, sobol};
use rta_core::vector::{UnitVec3, UnitVector};
use rta_scenes::narrow::Narrow;

use super::frame::direction;
use super::functions::{Function, functions};

/// The relative error of a part of a disc in fixed point.
const PART: f64 = 2e-6;
/// Cells along a side of the grid of which an albedo is the mean.
const CELLS: u32 = 1024;

/// Returns the functions, as they are computed in the format `S`. Angles are in degrees, those of `cap` in radians; words are whole numbers
/// of 32 bits.
pub(super) fn all<S: Narrow>() -> Vec<Function> {
    functions! {
        seg(s) within PART => part::<S>(s);
        half_plane(x, h, occluder, r) within PART => part::<S>(-x * (h - occluder) / (occluder * r));
        disc_irradiance(x, h, r) within 0.0 => {
            let (height, radius, offset) = (h * h, r * r, x * x);
            let sum = height + offset + radius;
            (1.0 - (height + offset - radius) / (sum * sum - 4.0 * radius * offset).sqrt()) / 2.0
        };
        circle(a, f, zf, z, nx) within 0.0 => a * f * (z - zf).abs() / (z * zf) * nx;
        square_cover(degrees, d) within 0.0 => square_cover(degrees, d);
        cap(a, b, c) within 0.0 => cap(a, b, c);
        lens_discs(own, other, apart) within PART => {
            // Only their ratios matter.
            let largest = own.max(other).max(apart);
            let [own, other, apart] = [own, other, apart].map(|length| S::unit(length / largest));
            S::unit_to_f64(covered(own, other, apart))
        };
        ggx_albedo(alpha, degrees) within PART, always 1e-5 => ggx_albedo::<S>(alpha, degrees);
        sobol_u(i) within 0.0 => f64::from(sobol(word(i))[0]);
        sobol_v(i) within 0.0 => f64::from(sobol(word(i))[1]);
        pair_u(x, y, tag, seed, i) within 0.0 => f64::from(pair([x, y, tag, seed, i])[0]);
        pair_v(x, y, tag, seed, i) within 0.0 => f64::from(pair([x, y, tag, seed, i])[1]);
    }
}

/// Returns a number as a word; what is no word counts as 0 or as the largest.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it saturates")]
const fn word(number: f64) -> u32 {
    number as u32
}

fn pair(numbers: [f64; 5]) -> [u32; 2] {
    let [x, y, tag, seed, i] = numbers.map(word);
    Pairs::new(x, y, tag, seed).words(i)
}

fn part<S: Narrow>(s: f64) -> f64 {
    S::unit_to_f64(beyond(S::unit(s.clamp(-1.0, 1.0))))
}

/// Returns the part of the unit square about the origin where `n . x < d`, for a unit vector n that is that many degrees from the x axis.
fn square_cover(degrees: f64, d: f64) -> f64 {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let (a, b) = (cosine.abs(), sine.abs());
    if a * b < 1e-15 {
        return (d + 0.5).clamp(0.0, 1.0);
    }
    let square = |t: f64| t.max(0.0) * t.max(0.0);
    let d = d + f64::midpoint(a, b);
    (square(d) - square(d - a) - square(d - b) + square(d - a - b)) / (2.0 * a * b)
}

/// Returns the part of a spherical cap of half the angle `a` that one of `b` covers, whose axis is `c` away; all in radians.
fn cap(a: f64, b: f64, c: f64) -> f64 {
    let whole = |angle: f64| 2.0 * (angle / 2.0).sin().powi(2);
    if c >= a + b {
        return 0.0;
    }
    if c + a <= b {
        return 1.0;
    }
    if c + b <= a {
        return whole(b) / whole(a);
    }
    // The angles of the spherical triangle of both axes and a place where the edges cross.
    let angle = |far: f64, near: f64, other: f64| {
        ((far.cos() - near.cos() * other.cos()) / (near.sin() * other.sin())).clamp(-1.0, 1.0).acos()
    };
    let (crossing, own, other) = (angle(c, a, b), angle(b, a, c), angle(a, b, c));
    // Its excess, twice, and the sectors of both caps on the inside of it.
    let sectors = own * whole(a) + other * whole(b);
    let excess = crossing + own + other - core::f64::consts::PI;
    (2.0 * sectors - 2.0 * excess) / (core::f64::consts::TAU * whole(a))
}

/// Returns the part of the light that a rough mirror reflects.
fn ggx_albedo<S: Narrow>(alpha: f64, degrees: f64) -> f64 {
    let facets = Facets { roughness: S::unit(alpha) };
    let (normal, view) = (UnitVec3::<S>::Z, direction::<S>(degrees, 0.0));
    let middle = |cell: u32| (2 * cell + 1) * (u32::MAX / (2 * CELLS));
    let mut sum = 0.0;
    for u in 0..CELLS {
        for v in 0..CELLS {
            let facet = facets.seen::<S>(normal, view, [middle(u), middle(v)]);
            let out = S::unit_to_f64((-view).reflect(facet).dot(normal));
            if out > 0.0 {
                sum += S::unit_to_f64(facets.passed(view.dot(normal), S::unit(out)));
            }
        }
    }
    sum / f64::from(CELLS * CELLS)
}
