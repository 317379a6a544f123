//! Parts of a disc, exactly: of the cross section of a cone.

use core::f64::consts::{PI, TAU};

/// Returns the part of a disc beyond a straight line, `s` radii from its middle.
pub fn seg(s: f64) -> f64 {
    let s = s.clamp(-1.0, 1.0);
    (s.acos() - s * (1.0 - s * s).sqrt()) / PI
}

/// Returns the part of a disc of the radius `own` that one of the radius `other` covers, whose middle is `apart` away.
pub fn lens(own: f64, other: f64, apart: f64) -> f64 {
    let ratio = other / own;
    if apart >= own + other {
        return 0.0;
    }
    if apart <= (own - other).abs() {
        return (ratio * ratio).min(1.0);
    }
    // How far the common chord is from the middles.
    let chord = (apart * apart + own * own - other * other) / (2.0 * apart);
    (seg(chord / own) + ratio * ratio * seg((apart - chord) / other)).min(1.0)
}

/// What covers a part of a disc: of the cross section of a cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Covered {
    /// The part, above 0 and at most 1.
    pub part: f64,
    /// The place in the middle of that part, as a part of the radius; the disc's own middle, if it is all of it.
    pub place: [f64; 2],
}

impl Covered {
    /// All of a disc.
    pub const WHOLE: Self = Self { part: 1.0, place: [0.0; 2] };

    /// Returns what covers a part, if there is anything of it.
    pub fn new(part: f64, place: [f64; 2]) -> Option<Self> {
        if part >= 1.0 {
            return Some(Self::WHOLE);
        }
        (part > 0.0).then_some(Self { part, place })
    }
}

/// Convex polygons on the disc of the radius 1: what a cone sees of one in space, before its focus and behind it.
#[derive(Clone, Debug, Default)]
pub struct Polygon {
    pieces: [Vec<[f64; 2]>; 2],
}

/// Sides of the polygon about the disc by which the middle of a part is found.
const SIDES: u32 = 16;

/// The least distance along a cone, and the least radius of a cross section, at which there is a picture of a corner.
const NEAR: f64 = 1e-12;

impl Polygon {
    /// Returns what is seen of a polygon whose corners are, across the axis of a cone, at x and y, where the radius of its cross section has
    /// the third value, at the distance of the fourth along the axis.
    pub fn seen(corners: &[[f64; 4]]) -> Self {
        let ahead = cut(corners, |[.., along]| along - NEAR);
        let pieces = [1.0, -1.0].map(|side| {
            let piece = cut(&ahead, |[_, _, radius, _]| side * radius - NEAR);
            piece.into_iter().map(|[x, y, radius, _]| [x / radius, y / radius]).collect()
        });
        Self { pieces }
    }

    /// Returns what the pieces cover of the disc.
    pub fn covered(&self) -> Option<Covered> {
        let [before, behind] = self.pieces.each_ref().map(|piece| area(piece));
        let larger = if before < behind { &self.pieces[1] } else { &self.pieces[0] };
        covered(before + behind, larger)
    }
}

/// Returns what a convex polygon covers of the disc.
pub fn part(corners: &[[f64; 2]]) -> Option<Covered> {
    covered(area(corners), corners)
}

/// Returns what covers an area of the disc, and has its middle in that of a polygon.
fn covered(area: f64, corners: &[[f64; 2]]) -> Option<Covered> {
    let part = area / PI;
    if part <= 1e-12 {
        return None;
    }
    if part >= 1.0 - 1e-9 { Some(Covered::WHOLE) } else { Covered::new(part, middle(corners)) }
}

/// Returns what of a convex polygon is where `inside`, which is linear, is 0 or more (I. Sutherland and G. Hodgman, "Reentrant Polygon
/// Clipping", CACM 17, 1974).
fn cut<const N: usize>(corners: &[[f64; N]], inside: impl Fn([f64; N]) -> f64) -> Vec<[f64; N]> {
    let mut kept = Vec::with_capacity(corners.len() + 1);
    let Some(&last) = corners.last() else { return kept };
    let mut before = (last, inside(last));
    for &corner in corners {
        let now = (corner, inside(corner));
        if (before.1 < 0.0) != (now.1 < 0.0) {
            let part = before.1 / (before.1 - now.1);
            let mut between = before.0;
            between.iter_mut().zip(corner).for_each(|(own, to)| *own += (to - *own) * part);
            kept.push(between);
        }
        if now.1 >= 0.0 {
            kept.push(corner);
        }
        before = now;
    }
    kept
}

/// Returns the area that a polygon has in common with the disc of the radius 1.
fn area(corners: &[[f64; 2]]) -> f64 {
    let Some(&last) = corners.last() else { return 0.0 };
    let mut before = last;
    let mut sum = 0.0;
    for &corner in corners {
        sum += edge(before, corner);
        before = corner;
    }
    sum.abs()
}

/// Returns the area, with its sign, that the disc has in common with the triangle of its middle and two places: of what lies outside, the
/// sectors.
fn edge(a: [f64; 2], b: [f64; 2]) -> f64 {
    let way = [b[0] - a[0], b[1] - a[1]];
    let square = way[0] * way[0] + way[1] * way[1];
    if square == 0.0 {
        return 0.0;
    }
    // Where the line is within the disc, as parts of the way.
    let along = -(a[0] * way[0] + a[1] * way[1]) / square;
    let cross = a[0] * way[1] - a[1] * way[0];
    let half = ((square - cross * cross).max(0.0)).sqrt() / square;
    let [enters, leaves] = [along - half, along + half].map(|part| part.clamp(0.0, 1.0));
    let at = |part: f64| [a[0] + way[0] * part, a[1] + way[1] * part];
    if half == 0.0 || enters >= leaves {
        return sector(a, b);
    }
    let [first, second] = [at(enters), at(leaves)];
    let triangle = (first[0] * second[1] - first[1] * second[0]) / 2.0;
    sector(a, first) + triangle + sector(second, b)
}

/// Returns the area of the sector of the disc between the directions of two places, with its sign.
fn sector(a: [f64; 2], b: [f64; 2]) -> f64 {
    if a == b {
        return 0.0;
    }
    (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]) / 2.0
}

/// Returns the centroid of what a polygon has in common with the disc, nearly: with a regular polygon about it. It is in the polygon.
fn middle(corners: &[[f64; 2]]) -> [f64; 2] {
    let mut kept = corners.to_vec();
    for side in 0..SIDES {
        let (sine, cosine) = (TAU * f64::from(side) / f64::from(SIDES)).sin_cos();
        kept = cut(&kept, |[x, y]| 1.0 - x * cosine - y * sine);
    }
    let Some(&first) = kept.first() else { return [0.0; 2] };
    let (mut whole, mut sum) = (0.0, [0.0; 2]);
    for pair in kept.windows(2) {
        let &[b, c] = pair else { continue };
        let twice = (b[0] - first[0]) * (c[1] - first[1]) - (b[1] - first[1]) * (c[0] - first[0]);
        whole += twice;
        let third = twice / 3.0;
        sum = [sum[0] + third * (first[0] + b[0] + c[0]), sum[1] + third * (first[1] + b[1] + c[1])];
    }
    if whole == 0.0 { first } else { sum.map(|moment| moment / whole) }
}
