//! The form factor from a point to a polygon.

use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3};
use crate::scalar::{Positive, Scalar, Unit};

/// The outline of a polygon as it is seen from a point.
struct Outline<S: Scalar> {
    normal: UnitVec3<S>,
    first: Option<UnitVec3<S>>,
    last: UnitVec3<S>,
    sum: S::Unit,
}

impl<S: Scalar> Outline<S> {
    /// Goes on to the next corner, in that direction.
    fn to(&mut self, corner: UnitVec3<S>) {
        if self.first.is_none() {
            self.first = Some(corner);
        } else {
            self.edge(corner);
        }
        self.last = corner;
    }

    /// Adds `angle(a, b) (a x b) . N / |a x b|` in turns.
    fn edge(&mut self, end: UnitVec3<S>) {
        let across = self.last.cross(end);
        let Some((axis, _)) = across.normalize() else { return };
        let angle = S::Unit::turn(self.last.dot(end), across.dot(axis));
        self.sum = self.sum + angle.times(axis.dot(self.normal));
    }
}

/// Returns the part, 0 to 1, of what a point of a surface with the unit normal `normal` sees, each direction by its cosine, that a polygon of
/// these corners fills if nothing is in the way (J. Lambert, "Photometria", 1760): `1/2pi sum over edges of angle(a, b) (a x b).N / |a x b|`.
/// It is cut at the point's horizon. The corners run counterclockwise as seen from the point; otherwise the result is 0, and so it is for a
/// point that is a corner. Within 1e-7 in fixed point.
pub fn point_to_polygon<S: Scalar>(point: Vec3<S>, normal: UnitVec3<S>, corners: &[Vec3<S>]) -> S::Unit {
    let zero = S::Unit::ZERO;
    let seen = |corner: Vec3<S>| {
        (corner - point).normalize().map(|(direction, ..)| (direction, direction.dot(normal)))
    };
    let Some(mut before) = corners.last().and_then(|&corner| seen(corner)) else { return zero };
    let mut outline = Outline::<S> { normal, first: None, last: normal, sum: zero };
    for &corner in corners {
        let Some(now) = seen(corner) else { return zero };
        if (before.1 < zero) != (now.1 < zero) {
            // The place on the horizon lies between both, nearer to the lower one.
            let [far, near] =
                [before.1, now.1].map(|high| (if high < zero { -high } else { high }).positive());
            let part = far.over(far.plus(near)).unit();
            let crossing = before.0.scale(S::Unit::ONE - part).plus(now.0, part);
            if let Some((direction, _)) = crossing.normalize() {
                outline.to(direction);
            }
        }
        if now.1 >= zero {
            outline.to(now.0);
        }
        before = now;
    }
    if let Some(first) = outline.first {
        outline.edge(first);
    }
    // As seen from the point, a polygon that runs counterclockwise turns the other way about the normal.
    super::quad::clamped(-outline.sum)
}
