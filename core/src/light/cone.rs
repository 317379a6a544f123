//! The cone from a point to a lamp that is a sphere, and how much of the lamp things in it hide (J. Amanatides, "Ray Tracing with Cones",
//! SIGGRAPH 84). One question for each lamp and thing gives shadows soft edges without noise.
//!
//! The sine of the cone's half angle is the lamp's radius over its distance. What is round is compared with the lamp as discs on the sphere of
//! directions, each as large as its solid angle: the radius of such a disc is the chord of its half angle, and the distance of two that of the
//! angle between them. Edges are straight on a plane across the axis.

use heapless::Vec;

use super::Incident;
use super::cover::{beyond, covered, over_pi};
use crate::sampling::mapping::Frame;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};
use crate::scalar::{Positive, Scalar, Unit};

/// What a thing hides of a lamp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hidden<U> {
    /// The part of the lamp, 0 to 1.
    pub part: U,
    /// Whether the thing is a face that is seen from behind. Of the faces of a closed body those that are seen from one side hide all that
    /// the body hides, and those seen from the other side hide it once more.
    pub from_behind: bool,
}

impl<U> From<U> for Hidden<U> {
    fn from(part: U) -> Self {
        Self { part, from_behind: false }
    }
}

/// The cone from a point to a lamp that is a sphere.
#[derive(Clone, Copy, Debug)]
pub struct LampCone<S: Scalar> {
    /// The point.
    pub apex: Vec3<S>,
    /// Unit vector to the lamp's centre.
    pub axis: UnitVec3<S>,
    /// Distance of the lamp's centre, more than its radius.
    pub distance: S,
    /// The lamp's centre.
    pub lamp: Vec3<S>,
    /// The lamp's radius, above 0.
    pub radius: S,
    /// Sine of the cone's half angle, above 0.
    pub sine: S::Unit,
    /// Half the chord of that angle, its tangent or 1 if that is less, and two directions across the axis.
    half_chord: S::Unit,
    tangent: S::Unit,
    frame: Frame<UnitVec3<S>>,
}

impl<S: Scalar> LampCone<S> {
    /// Returns the cone from `apex` to a lamp of the radius `radius`, above 0, with the reciprocal `inverse_distance` of its distance;
    /// `None` for a point within the lamp.
    pub fn new(apex: Vec3<S>, incident: &Incident<S>, radius: S) -> Option<Self> {
        if radius >= incident.distance {
            return None;
        }
        let (one, least) = (S::Unit::ONE, S::Unit::ratio(1, 1 << 24));
        let sine = radius.fraction(incident.inverse_distance);
        let sine = if sine < least { least } else { sine };
        let cosine = S::Unit::radical(one, S::Unit::ZERO, sine).unwrap_or(S::Unit::ZERO);
        Some(Self {
            apex,
            axis: incident.direction,
            distance: incident.distance,
            lamp: incident.lamp.position,
            radius,
            sine,
            half_chord: half_chord(sine),
            tangent: if sine < cosine { sine.quotient(cosine) } else { one },
            frame: Frame::about(incident.direction),
        })
    }

    /// Returns whether a sphere may hide any of the lamp: no, unless it is between the point and the lamp and near enough to the axis.
    pub fn is_near(&self, center: Vec3<S>, radius: S) -> bool {
        let way = center - self.apex;
        let along = way.dot(self.axis);
        if along + radius <= S::ZERO || along - radius >= self.distance {
            return false;
        }
        // Up to the lamp the cone is not wider than twice the lamp, unless it is nearer than 1.15 of its radii.
        let away = S::sqrt(way.reject(self.axis, along).norm_squared()) - radius;
        away <= self.radius || away - self.radius <= self.radius
    }

    /// Returns the part of the lamp that a sphere hides.
    pub fn sphere(&self, center: Vec3<S>, radius: S) -> S::Unit {
        let holds = |place: Vec3<S>| (place - center).norm_squared() < radius.square();
        self.before(center, holds).unwrap_or_else(|| self.disc(center, radius))
    }

    /// Returns the part of the lamp that a convex body about `center` hides, where that needs no look at its outline: `holds` says whether a place
    /// is within it. All is hidden by a body about the point or the lamp, nothing by one about both or behind the lamp.
    pub fn before(&self, center: Vec3<S>, holds: impl Fn(Vec3<S>) -> bool) -> Option<S::Unit> {
        let is_behind = (center - self.apex).dot(self.axis) >= self.distance;
        match (holds(self.apex), holds(self.lamp)) {
            (false, false) if !is_behind => None,
            (true, false) | (false, true) => Some(S::Unit::ONE),
            _ => Some(S::Unit::ZERO),
        }
    }

    /// Returns the part of the lamp that is covered by what is seen as a disc about `center`, as a sphere of the radius `radius` is.
    pub fn disc(&self, center: Vec3<S>, radius: S) -> S::Unit {
        let Some((direction, distance, inverse)) = (center - self.apex).normalize() else {
            return S::Unit::ONE;
        };
        let sine = if radius < distance { radius.fraction(inverse) } else { S::Unit::ONE };
        covered(self.half_chord, half_chord(sine), half_distance::<S>(direction, self.axis))
    }

    /// Returns the part of the lamp beyond a plane: where the point is `own` above it, the lamp's centre `lamps`; `normal` is its unit normal.
    pub fn half_space(&self, own: S, lamps: S, normal: UnitVec3<S>) -> S::Unit {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        let height = if own < S::ZERO { -lamps } else { lamps };
        let slope = S::Unit::radical(one, zero, normal.dot(self.axis)).unwrap_or(zero);
        let width = self.radius.scale(slope);
        if own == S::ZERO || height >= width {
            zero
        } else if height <= -width {
            one
        } else if height < S::ZERO {
            beyond(-(-height).fraction(width.inverse()))
        } else {
            beyond(height.fraction(width.inverse()))
        }
    }

    /// Returns the part of the lamp beyond a plane through the point, whose unit normal points to what is not counted.
    pub fn beside(&self, normal: UnitVec3<S>) -> S::Unit {
        beyond(normal.dot(self.axis).quotient(self.sine))
    }

    /// Returns the part of the lamp that a convex polygon covers, of at most eight corners, by the sectors and triangles between its edges and
    /// the middle of the lamp. A lamp that is seen larger than a right angle counts as one that is not.
    pub fn polygon<const N: usize>(&self, corners: [Vec3<S>; N]) -> S::Unit {
        let (zero, one, half) = (S::Unit::ZERO, S::Unit::ONE, S::Unit::ratio(1, 2));
        let mut seen = Corners::<S>::new();
        for corner in corners {
            let Some((direction, ..)) = (corner - self.apex).normalize() else { return zero };
            // There is room.
            let _ = seen.push(self.frame.components(direction));
        }
        // The pyramid about the cone, so that what is left can be projected.
        for [a, b] in [[half, zero], [-half, zero], [zero, half], [zero, -half]] {
            seen = cut::<S>(&seen, |[x, y, z]| z.times(S::Unit::ratio(5, 8)) - x.times(a) - y.times(b));
        }
        let mut outline =
            Outline::<S> { disc: self.tangent.times(half), first: None, last: [zero; 2], sum: zero };
        seen.iter().filter(|corner| corner[2] > zero).for_each(|&corner| outline.to(corner));
        outline.close();
        let part = size(outline.sum);
        if part > one { one } else { part }
    }
}

/// The corners of a polygon of eight that is cut four times, along x, y and the axis of a cone.
type Corners<S> = Vec<[<S as Scalar>::Unit; 3], 12>;

/// Returns what of a convex polygon is where `inside` is 0 or more (I. Sutherland and G. Hodgman, "Reentrant Polygon Clipping", CACM 17,
/// 1974). It is linear.
fn cut<S: Scalar>(corners: &Corners<S>, inside: impl Fn([S::Unit; 3]) -> S::Unit) -> Corners<S> {
    let zero = S::Unit::ZERO;
    let mut kept = Corners::<S>::new();
    let Some(mut before) = corners.last().map(|&corner| (corner, inside(corner))) else { return kept };
    for &corner in corners {
        let now = (corner, inside(corner));
        if (before.1 < zero) != (now.1 < zero) {
            let [far, near] = [before.1, now.1].map(|away| size(away).positive());
            let part = far.over(far.plus(near)).unit();
            let (mut mixed, rest) = (now.0, S::Unit::ONE - part);
            for (mixed, before) in mixed.iter_mut().zip(before.0) {
                *mixed = mixed.times(part) + before.times(rest);
            }
            let _ = kept.push(mixed);
        }
        if now.1 >= zero {
            let _ = kept.push(corner);
        }
        before = now;
    }
    kept
}

/// The outline of a polygon on a plane across the axis, in halves of the distance of that plane.
struct Outline<S: Scalar> {
    /// Radius of the lamp there, at most 1/2.
    disc: S::Unit,
    first: Option<[S::Unit; 2]>,
    last: [S::Unit; 2],
    /// The part of the disc between its middle and the edges so far, positive for those that turn about it from x towards y.
    sum: S::Unit,
}

impl<S: Scalar> Outline<S> {
    /// Goes on to the next corner, along x, y and the axis.
    fn to(&mut self, [x, y, z]: [S::Unit; 3]) {
        let place = [x, y].map(|c| c.times(S::Unit::ratio(1, 2)).quotient(z));
        if self.first.is_none() {
            self.first = Some(place);
        } else {
            self.edge(place);
        }
        self.last = place;
    }

    fn close(&mut self) {
        if let Some(first) = self.first {
            self.edge(first);
        }
    }

    /// Adds the part of the disc between its middle and the edge from the last corner: the triangle to what of the edge is in the disc, and
    /// sectors to what is not.
    fn edge(&mut self, end: [S::Unit; 2]) {
        let (zero, one, half) = (S::Unit::ZERO, S::Unit::ONE, S::Unit::ratio(1, 2));
        let vector = |[x, y]: [S::Unit; 2]| UnitVec3::<S>::new(x, y, zero);
        let (start, end) = (vector(self.last), vector(end));
        let Some((direction, _)) = end.plus(start, -one).normalize() else { return };
        // Along the edge and across it: both ends are equally far to the right of the middle.
        let beside = start.cross(direction).z();
        let along = [start, end].map(|place| place.dot(direction));
        let radii = |length: S::Unit| length.quotient(self.disc);
        let (away, ends) = (radii(beside), along.map(radii));
        let is_near = away < one && away > -one;
        let reach = if is_near { S::Unit::radical(one, zero, away).unwrap_or(zero) } else { zero };
        let within = ends.map(|place| {
            if place < -reach {
                -reach
            } else if place > reach {
                reach
            } else {
                place
            }
        });
        let angle = |place: S::Unit, away: S::Unit| S::Unit::turn(place, -away);
        let mut part = (within[1].times(half) - within[0].times(half)).times(over_pi(away));
        if within[0] != ends[0] {
            part = part + angle(within[0], away) - angle(along[0], beside);
        }
        if within[1] != ends[1] {
            part = part + angle(along[1], beside) - angle(within[1], away);
        }
        self.sum = self.sum + part;
    }
}

/// Returns half the chord of an angle, from its sine, 0 to 1.
fn half_chord<U: Unit>(sine: U) -> U {
    let half = U::ratio(1, 2);
    let cosine = U::radical(U::ONE, U::ZERO, sine).unwrap_or(U::ZERO);
    sine.times(half).quotient((half + cosine.times(half)).sqrt())
}

/// Returns half the distance of two unit vectors, 0 to 1.
fn half_distance<S: Scalar>(one: UnitVec3<S>, other: UnitVec3<S>) -> S::Unit {
    let half = S::Unit::ratio(1, 2);
    let apart = one.scale(half).plus(other, -half);
    let square = |c: S::Unit| size(c).positive().times(size(c).positive());
    square(apart.x()).plus(square(apart.y())).plus(square(apart.z())).root().unit()
}

fn size<U: Unit>(number: U) -> U {
    if number < U::ZERO { -number } else { number }
}

#[cfg(test)]
#[cfg(feature = "f64")]
mod tests;
