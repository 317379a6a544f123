//! The extent of a scene: its box, the ball about the box's centre, and the greatest distance between two places.

use super::{Cause, Worst};
use crate::accelerator::Accelerator;
use crate::scalar::vector::{Vec3, Vector, Xyz};
use crate::scalar::{Magnitude, Number, Scalar, Unit};
use crate::scene::{Object, Scene};

/// The bounding box of a scene, scaled to a quarter so that no sum of two coordinates leaves the format.
pub(super) struct Extent<'a, 's, S: Scalar, A> {
    scene: &'a Scene<'s, S>,
    /// The eye, and how far rays start from it.
    eye: (Vec3<S>, S),
    accelerator: &'a A,
    /// The ends of the box along each axis, and what is there; `None` for the eye.
    low: Xyz<(S, Option<Object>)>,
    high: Xyz<(S, Option<Object>)>,
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
fn axes<S: Scalar>(v: Vec3<S>) -> Xyz<S> {
    Xyz::new(v.x(), v.y(), v.z())
}

/// Returns a bound of a vector's length from bounds of its components.
fn norm(Xyz { x, y, z }: Xyz<Magnitude>) -> Magnitude {
    x.times(x).plus(y.times(y)).plus(z.times(z)).root()
}

impl<'a, 's, S: Scalar, A: Accelerator<S>> Extent<'a, 's, S, A> {
    /// Returns the extent of a scene with an eye and what reaches that far around it.
    pub(super) fn of(scene: &'a Scene<'s, S>, (eye, reach): (Vec3<S>, S), accelerator: &'a A) -> Self {
        let middle = axes::<S>(eye).map(|c| (quarter(c), None));
        let mut extent = Self { scene, eye: (eye, reach), accelerator, low: middle, high: middle };
        extent.hold(eye, reach, None);
        scene.solids(|object, place, radius, _| extent.hold(place, radius, Some(object)));
        // Distances from rays to the centres of nodes are computed too.
        accelerator.places(|center| extent.hold(center, S::ZERO, None));
        extent
    }

    fn hold(&mut self, place: Vec3<S>, radius: S, object: Option<Object>) {
        let (place, radius) = (axes::<S>(place).map(quarter), quarter(radius));
        self.low = self.low.zip(place, |low, c| if c - radius < low.0 { (c - radius, object) } else { low });
        self.high =
            self.high.zip(place, |high, c| if c + radius > high.0 { (c + radius, object) } else { high });
    }

    /// Returns what is at the other end of the scene along its longest side from an object, or from the eye; nothing where that is
    /// at both ends.
    pub(super) fn opposite(&self, object: Option<Object>) -> Option<Cause> {
        let Xyz { x, y, z } = self.low.zip(self.high, |low, high| (high.0 - low.0, [low.1, high.1]));
        let longer = |a: (S, _), b: (S, _)| if b.0 > a.0 { b } else { a };
        let (_, ends) = longer(longer(x, y), z);
        let other = ends.into_iter().find(|end| *end != object)?;
        Some(other.map_or(Cause::Eye, Cause::Object))
    }

    /// Returns the height at which cylinders end: the highest power of two, up to a quarter of the format, with which no
    /// distance exceeds `most`, but at least the height of the scene.
    pub(super) fn cylinder_end(&self, has_cylinders: bool, most: Magnitude) -> Magnitude {
        let own = self.low.z.0.size().max(self.high.z.0.size()).shift(2);
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
        let (low, high) = (self.low.map(|end| end.0), self.high.map(|end| end.0));
        let mut sides = high.zip(low, |high, low| (high - low).size().shift(2).plus(slack));
        if has_cylinders {
            sides.z = sides.z.max(cylinder_end.shift(1));
        }
        let diagonal = norm(sides);
        let center = low.zip(high, |low, high| half(low) + half(high));
        let mut coordinate = Worst::NONE;
        let mut radius = Worst::NONE;
        // The square of the distance from the centre and the radius of the one that is farthest away so far.
        let mut farthest: Option<(S::Wide, S)> = None;
        let mut see = |object: Option<Object>, place: Vec3<S>, extent: S| {
            let place = axes::<S>(place);
            let Xyz { x, y, z } = place.map(Number::size);
            coordinate.see(x.max(y).max(z).plus(extent.size()), object);
            let away = place.zip(center, |c, center| {
                let difference = quarter(c) - center;
                let size = if difference < S::ZERO { -difference } else { difference };
                size + rounding
            });
            let Xyz { x, y, z } = away.map(Scalar::square);
            let (apart, is_cylinder) = (x + y + z, matches!(object, Some(Object::Cylinder(_))));
            // Most objects are neither as far away as another nor larger, and need no root.
            if !is_cylinder && farthest.is_some_and(|(most, largest)| apart <= most && extent <= largest) {
                return;
            }
            let mut away = away.map(|away| away.size().shift(2));
            if is_cylinder {
                away.z = cylinder_end.plus(center.z.size().shift(2));
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
        see(None, self.eye.0, self.eye.1);
        self.scene.solids(|object, place, radius, _| see(Some(object), place, radius));
        self.accelerator.places(|center| see(None, center, S::ZERO));
        let Worst(radius, object) = radius;
        let distance = radius.shift(1);
        (coordinate, Worst(if diagonal < distance { diagonal } else { distance }, object))
    }
}
