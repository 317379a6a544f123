//! A ray, and where it goes through a surface.

use super::super::vector::Vector;

/// A ray: its origin and its direction of length 1.
#[derive(Clone, Copy)]
pub(super) struct Ray {
    pub(super) origin: Vector,
    pub(super) direction: Vector,
}

/// What a ray that starts on a surface does: it goes out of it, on the side of the outward normal, or into it.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Departure {
    Out,
    In,
}

/// Where a ray goes through a surface.
#[derive(Clone, Copy)]
pub(super) struct Crossing {
    /// Distance from the ray's origin, of either sign.
    pub(super) t: f64,
    /// The surface's own normal on its outer side, of length 1.
    pub(super) outward: Vector,
    /// The normal that the surface is shaded with, of length 1: in a proper file on the same side.
    pub(super) shading: Vector,
}

/// The crossings of a ray with one surface, two at most, in no order.
pub(super) type Crossings = [Option<Crossing>; 2];

/// Returns the box around some places.
pub(super) fn around(places: &[Vector]) -> [Vector; 2] {
    let [mut low, mut high] = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for [x, y, z] in places {
        low = [low[0].min(*x), low[1].min(*y), low[2].min(*z)];
        high = [high[0].max(*x), high[1].max(*y), high[2].max(*z)];
    }
    [low, high]
}

/// Of the two roots of a ray with a closed surface, leaves those that count after a departure from that surface. A root is
/// a distance along the ray from a place that is `start` from the ray's origin; the root of the origin itself is the nearer one.
pub(super) fn departed(roots: [f64; 2], start: f64, left: Option<Departure>) -> [Option<f64>; 2] {
    let [one, other] = roots;
    match left {
        None => roots.map(Some),
        Some(Departure::Out) => [None; 2],
        Some(Departure::In) => {
            [Some(if (start + one).abs() > (start + other).abs() { one } else { other }), None]
        }
    }
}
