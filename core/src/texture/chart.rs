//! Where a point lies on a picture that covers an object.

use super::Axis;
use crate::scalar::vector::{UnitVec3, UnitVector, Vec3, Vector};
use crate::scalar::{Magnitude, Scalar, Unit};

/// A place on a picture, and the directions along it.
#[derive(Clone, Copy, Debug)]
pub struct Chart<S: Scalar> {
    /// The place from the upper left corner, to the right and down, in parts of the picture, which repeats.
    pub place: [S; 2],
    /// Unit directions of the surface in which the place goes to the right and down.
    pub axes: [UnitVec3<S>; 2],
}

/// Returns the place on a picture that is wrapped around a ball, of a unit vector from the centre: the longitude from x towards y in turns, 0 to
/// 1, and the angle from the zenith in half turns, 0 to 1 (Catmull 1975).
pub fn ball<S: Scalar>(direction: UnitVec3<S>) -> [S::Unit; 2] {
    let (x, y, z) = (direction.x(), direction.y(), direction.z());
    let flat = S::Unit::radical(x, y, S::Unit::ZERO).unwrap_or(S::Unit::ZERO);
    let half = S::Unit::turn(z, flat);
    [around::<S>(x, y), half + half]
}

/// Returns the longitude of a direction in turns, 0 to 1.
fn around<S: Scalar>(x: S::Unit, y: S::Unit) -> S::Unit {
    let turn = S::Unit::turn(x, y);
    if turn < S::Unit::ZERO { turn + S::Unit::ONE } else { turn }
}

/// Returns two unit directions across an axis: one near x, where the axis is not near x itself, and the one to its left.
fn frame<V: UnitVector>(axis: V) -> [V; 2] {
    let part = |one: V| one.plus(axis, -one.dot(axis)).normalize().map_or(one, |(part, _)| part);
    let is_along_x = axis.x().times(axis.x()) > Unit::ratio(1, 2);
    let first = part(if is_along_x { V::Y } else { V::X });
    [first, axis.cross(first)]
}

impl<S: Scalar> Chart<S> {
    /// Returns the place of a direction from the centre, a unit vector, on a picture that is wrapped around a [`ball`].
    pub fn on_ball(direction: UnitVec3<S>) -> Self {
        let one = S::at_most(Magnitude::new(1, 0));
        let east = UnitVec3::<S>::new(-direction.y(), direction.x(), S::Unit::ZERO).normalize();
        let east = east.map_or(UnitVec3::<S>::X, |(east, _)| east);
        let place = ball::<S>(direction).map(|part| one.scale(part));
        Self { place, axes: [east, east.cross(direction)] }
    }

    /// Returns the place at the `height` above the middle of a tube with an `axis`, of the unit normal of the surface there: pictures stand upright,
    /// and their rows are 1 high.
    pub fn on_tube(axis: UnitVec3<S>, outward: UnitVec3<S>, height: S) -> Self {
        let one = S::at_most(Magnitude::new(1, 0));
        let [x, y] = frame(axis);
        let east = axis.cross(outward).normalize().map_or(y, |(east, _)| east);
        let longitude = around::<S>(outward.dot(x), outward.dot(y));
        Self { place: [one.scale(longitude), -height], axes: [east, -axis] }
    }

    /// Returns the place on a picture that lies along two axes of the world, upright if the second is z: the two that are stated, or those across
    /// the largest component of the normal.
    pub fn on_plane(plane: Option<[Axis; 2]>, point: Vec3<S>, normal: UnitVec3<S>) -> Self {
        let [x, y, z] = [normal.x(), normal.y(), normal.z()].map(|part| part.times(part));
        let chosen = if z >= x && z >= y {
            [Axis::X, Axis::Y]
        } else if y >= x {
            [Axis::X, Axis::Z]
        } else {
            [Axis::Y, Axis::Z]
        };
        let [right, up] = plane.unwrap_or(chosen);
        Self {
            place: [right.of(point), -up.of(point)],
            axes: [right.direction::<UnitVec3<S>>(), -up.direction::<UnitVec3<S>>()],
        }
    }
}

/// What stands for the first texture coordinate of a triangle that has none.
pub const NO_COORDINATES: i32 = i32::MIN;
