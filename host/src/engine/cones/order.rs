//! The things in a cone, and which of them is before which.

use rta_core::ray::Ray;
use rta_core::scene::Object;

/// The part of their distance by which surfaces at one place may be apart.
const LEVEL: f64 = 1e-9;

/// A thing in a cone.
#[derive(Clone, Copy, Debug)]
pub struct Met {
    /// The thing.
    pub object: Object,
    /// The ray in the middle of the part that it covers, and the distance at which that meets it.
    pub ray: Ray<f64>,
    /// Distance along that ray.
    pub distance: f64,
    /// Distance along the cone's axis.
    pub along: f64,
    /// The part of the cone that it covers, with nothing before it.
    pub part: f64,
    /// The part that is seen of it.
    pub seen: f64,
    /// Of which body it is.
    pub body: Body,
}

/// Of which body a thing is a face: those of one body cover what is beside each other, those of different bodies cover what chance has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// The body.
    pub own: Own,
    /// Whether it is a face that is seen from behind: those of a closed body cover what its front faces do.
    pub is_behind: bool,
}

/// A body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Own {
    /// One of several faces, by its number.
    Faces(u32),
    /// A thing by itself.
    Thing(Object),
}

/// Sorts things by where the middles of their parts are along the axis; but of two of which one is met before the other by a ray to the middle
/// of either, that one is before it, as the wall is that stands on a floor in the same pixel. `distance` returns where a ray meets a thing.
pub fn sort(met: &mut [Met], distance: impl Fn(Object, &Ray<f64>) -> Option<f64>) {
    met.sort_by(|a, b| a.along.total_cmp(&b.along));
    for end in 1..met.len() {
        for at in (0..end).rev() {
            match met.get_mut(at..).and_then(<[Met]>::first_chunk_mut::<2>) {
                Some(pair) if is_after(&pair[0], &pair[1], &distance) => pair.swap(0, 1),
                _ => break,
            }
        }
    }
}

/// Returns whether the first of two things, as the middles of their parts are sorted, is behind the other wherever a ray meets both.
fn is_after(near: &Met, far: &Met, distance: impl Fn(Object, &Ray<f64>) -> Option<f64>) -> bool {
    // Of surfaces at one place the first in order is seen, as by rays.
    let wins = |own: f64, other: f64| {
        if (own - other).abs() <= LEVEL * own { far.object < near.object } else { own < other }
    };
    let there = distance(far.object, &near.ray).map(|own| wins(own, near.distance));
    let here = distance(near.object, &far.ray).map(|other| wins(far.distance, other));
    matches!((there, here), (Some(true), Some(true) | None) | (None, Some(true)))
}
