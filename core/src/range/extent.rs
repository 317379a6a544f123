//! The extent of a scene: its box, the ball about the box's centre, and the greatest distance between two places.

use super::{Cause, Worst};
use crate::accelerator::Accelerator;
use crate::camera::Camera;
use crate::scalar::vector::{Vec3, Vector};
use crate::scalar::{Magnitude, Scalar, Unit};
use crate::scene::{Object, Scene};

/// The bounding box of a scene, scaled to a quarter so that no sum of two coordinates leaves the format.
pub(super) struct Extent<'a, 's, S: Scalar, A> {
    scene: &'a Scene<'s, S>,
    eye: Vec3<S>,
    accelerator: &'a A,
    low: [S; 3],
    high: [S; 3],
    /// What is at each end of the box along x, y and z; `None` for the eye.
    ends: [[Option<Object>; 2]; 3],
}

/// Returns a quarter of a length.
fn quarter<S: Scalar>(length: S) -> S {
    length.scale(S::Unit::ratio(1, 4))
}

/// Returns half of a length.
fn half<S: Scalar>(length: S) -> S {
    length.scale(S::Unit::ratio(1, 2))
}

/// Returns the three coordinates of a place.
fn axes<S: Scalar>(v: Vec3<S>) -> [S; 3] {
    [v.x(), v.y(), v.z()]
}

/// Returns a bound of a vector's length from bounds of its components.
fn norm(sizes: [Magnitude; 3]) -> Magnitude {
    sizes.iter().fold(Magnitude::ZERO, |sum, &size| sum.plus(size.times(size))).root()
}

impl<'a, 's, S: Scalar, A: Accelerator<S>> Extent<'a, 's, S, A> {
    pub(super) fn of(scene: &'a Scene<'s, S>, camera: &Camera<S>, accelerator: &'a A) -> Self {
        let eye = axes::<S>(camera.eye).map(quarter);
        let mut extent =
            Self { scene, eye: camera.eye, accelerator, low: eye, high: eye, ends: [[None; 2]; 3] };
        scene.solids(|object, place, radius, _| extent.hold(place, radius, Some(object)));
        // Distances from rays to the centres of nodes are computed too.
        accelerator.places(|center| extent.hold(center, S::ZERO, None));
        extent
    }

    fn hold(&mut self, place: Vec3<S>, radius: S, object: Option<Object>) {
        let radius = quarter(radius);
        let sides = self.low.iter_mut().zip(&mut self.high).zip(&mut self.ends);
        for (((low, high), [lowest, highest]), c) in sides.zip(axes::<S>(place).map(quarter)) {
            if c - radius < *low {
                (*low, *lowest) = (c - radius, object);
            }
            if c + radius > *high {
                (*high, *highest) = (c + radius, object);
            }
        }
    }

    /// Returns what is at the other end of the scene along its longest side from an object, or from the eye; nothing where that is
    /// at both ends.
    pub(super) fn opposite(&self, object: Option<Object>) -> Option<Cause> {
        let mut longest = (S::ZERO, [None; 2]);
        for ((low, high), ends) in self.low.iter().zip(self.high).zip(self.ends) {
            if high - *low > longest.0 {
                longest = (high - *low, ends);
            }
        }
        let other = longest.1.into_iter().find(|end| *end != object)?;
        Some(other.map_or(Cause::Eye, Cause::Object))
    }

    /// Returns the height at which cylinders end: the highest power of two, up to a quarter of the format, with which no
    /// distance exceeds `most`, but at least the height of the scene.
    pub(super) fn cylinder_end(&self, has_cylinders: bool, most: Magnitude) -> Magnitude {
        let [_, _, low] = self.low;
        let [_, _, high] = self.high;
        let own = low.size().max(high.size()).shift(2);
        if !has_cylinders {
            return own;
        }
        let ends = (2..16).map(|k| S::FAR.size().shift(-k)).take_while(|end| *end > own);
        let mut fitting = ends.filter(|end| self.bounds(*end).1.0 <= most);
        fitting.next().unwrap_or(own)
    }

    /// Returns bounds of a coordinate and of the distance between two places, with cylinders up to the height `cylinder_end`.
    pub(super) fn bounds(&self, cylinder_end: Magnitude) -> (Worst, Worst) {
        let has_cylinders = !self.scene.cylinders.is_empty();
        // Quarters are rounded: four LSBs of the format, twice.
        let (rounding, slack) = (S::at_most(S::CLEARANCE), S::CLEARANCE.shift(2));
        let mut sides = [Magnitude::ZERO; 3];
        for (side, (low, high)) in sides.iter_mut().zip(self.low.iter().zip(self.high)) {
            *side = (high - *low).size().shift(2).plus(slack);
        }
        let [x, y, z] = sides;
        let diagonal = norm([x, y, if has_cylinders { z.max(cylinder_end.shift(1)) } else { z }]);

        let mut center = self.low;
        for (c, (low, high)) in center.iter_mut().zip(self.low.iter().zip(self.high)) {
            *c = half(*low) + half(high);
        }
        let mut coordinate = Worst::NONE;
        let mut radius = Worst::NONE;
        // The square of the distance from the centre and the radius of the one that is farthest away so far.
        let mut farthest: Option<(S::Wide, S)> = None;
        let mut see = |object: Option<Object>, place: Vec3<S>, extent: S| {
            let place = axes::<S>(place);
            let [x, y, z] = place.map(Scalar::size);
            coordinate.see(x.max(y).max(z).plus(extent.size()), object);
            let mut away = place.map(quarter);
            for (away, center) in away.iter_mut().zip(center) {
                let difference = *away - center;
                let size = if difference < S::ZERO { -difference } else { difference };
                *away = size + rounding;
            }
            let [x, y, z] = away.map(Scalar::square);
            let (apart, is_cylinder) = (x + y + z, matches!(object, Some(Object::Cylinder(_))));
            // Most objects are neither as far away as another nor larger, and need no root.
            if !is_cylinder && farthest.is_some_and(|(most, largest)| apart <= most && extent <= largest) {
                return;
            }
            let mut away = away.map(|away| away.size().shift(2));
            if let ([_, _, z], true) = (&mut away, is_cylinder) {
                let [_, _, middle] = center;
                *z = cylinder_end.plus(middle.size().shift(2));
                coordinate.see(cylinder_end, object);
            }
            let reach = norm(away).plus(extent.size());
            if reach > radius.0 {
                radius = Worst(reach, object);
                if !is_cylinder {
                    farthest = Some((apart, extent));
                }
            }
        };
        see(None, self.eye, S::ZERO);
        self.scene.solids(|object, place, radius, _| see(Some(object), place, radius));
        self.accelerator.places(|center| see(None, center, S::ZERO));
        let Worst(radius, object) = radius;
        let distance = radius.shift(1);
        (coordinate, Worst(if diagonal < distance { diagonal } else { distance }, object))
    }
}
