//! Lamps that have a size: a place on one as seen from a point, for a pair of numbers.
//!
//! A sphere of the radius r and the radiance I/r^2 gives a surface that it is wholly above exactly what a point of the intensity I in its
//! middle does, at any distance; so lamps with a size change the edges of shadows, and light where a lamp sets, and nothing else. R.
//! Cook, T. Porter and L. Carpenter, "Distributed Ray Tracing", SIGGRAPH 84; C. Verbeck and D. Greenberg, "A Comprehensive
//! Light-Source Description for Computer Graphics", IEEE CG&A 4, 1984.

use super::{Incident, Lamp};
use crate::sampling::mapping::{Frame, disc, hemisphere, lifted};
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};
use crate::scalar::{Scalar, Sight, Unit};

/// A lamp that is a parallelogram, and shines to one side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Square<S: Scalar> {
    /// A corner, where the lamp's middle is at [`middle`](Self::middle).
    pub corner: Vec3<S>,
    /// The middle, the position of its [`Lamp`]: a lamp that moves is moved from there.
    pub middle: Vec3<S>,
    /// The two edges that begin there.
    pub edges: [Vec3<S>; 2],
    /// Unit normal on the side to which it shines: along the product of the edges.
    pub normal: UnitVec3<S>,
    /// The distance below which a place on it gets no brighter: a 64th of the root of its area; and its reciprocal.
    pub least: (S, S::Inverse),
}

impl<S: Scalar> Square<S> {
    /// Returns whether a place is on the side to which the lamp shines, where its middle is at `middle`.
    pub fn shines_to(&self, place: Vec3<S>, middle: Vec3<S>) -> bool {
        (place - middle).dot(self.normal) > S::ZERO
    }
}

/// A place on a lamp as seen from a point of a surface.
#[derive(Clone, Copy, Debug)]
pub struct Glimpse<'l, S: Scalar> {
    /// The place: the direction in which it is seen, its distance, and the cosine there. It decides whether the lamp lights the point,
    /// and a shadow ray goes there.
    pub place: Incident<'l, S>,
    /// The lamp as a model of illumination is to see it: its middle, and the cosine with which the mean over all places is what the whole
    /// lamp sends. Highlights are so those of the middle.
    pub lamp: Incident<'l, S>,
}

impl<'l, S: Scalar> Glimpse<'l, S> {
    /// Returns a place on a lamp that is a sphere, for a pair of numbers from 0 to 1, evenly spread over the solid angle that is projected
    /// along the way to its middle. `point` is the lamp as a point, of the radius 0, and `radius` is its own, above 0, with the
    /// reciprocal.
    ///
    /// The cosine of [`Glimpse::lamp`] is `N.w / a.w`, for the direction w of the place and a of the middle. In fixed point it
    /// saturates at 2, which only a lamp that is nearer than twice its radius reaches.
    pub fn of_sphere(
        point: &'l Lamp<S>,
        (radius, inverse_radius): (S, S::Inverse),
        (place, normal): (Vec3<S>, UnitVec3<S>),
        pair: [S::Unit; 2],
    ) -> Self {
        let way = point.position - place;
        let Some((axis, distance, inverse_distance)) = way.normalize().filter(|way| way.1 > radius) else {
            return Self::from_within(point, (radius, inverse_radius), way, normal, pair);
        };
        let sine = radius.fraction(inverse_distance);
        let seen = S::sight((axis, normal), sine, pair).unwrap_or_else(|| sight((axis, normal), sine, pair));
        let Sight { direction, cosine, slanted, reach } = seen;
        let shown = Incident { direction: axis, distance, inverse_distance, cosine: slanted, lamp: point };
        let reached = distance.scale(reach);
        Self { place: Incident { direction, distance: reached, cosine, ..shown }, lamp: shown }
    }

    /// Returns a place on a sphere that the point lies within: light from all sides, as strong as on the sphere.
    fn from_within(
        point: &'l Lamp<S>,
        (radius, inverse_distance): (S, S::Inverse),
        way: Vec3<S>,
        normal: UnitVec3<S>,
        pair: [S::Unit; 2],
    ) -> Self {
        let direction = hemisphere::<S>(normal, pair);
        let lamp =
            Incident { direction, distance: radius, inverse_distance, cosine: S::Unit::ONE, lamp: point };
        let foot = way.dot(direction);
        let distance = foot + S::sqrt(radius.square() - way.reject(direction, foot).norm_squared());
        Self { place: Incident { distance, cosine: normal.dot(direction), ..lamp }, lamp }
    }

    /// Returns a place on a lamp that is a parallelogram, for a pair of numbers from 0 to 1, evenly spread over its area; `None` from the
    /// side to which it does not shine. `point` is a point lamp of its intensity in its middle.
    #[cfg_attr(not(target_os = "none"), inline)] // paths do not ask for the direction of the middle
    pub fn of_square(
        point: &'l Lamp<S>,
        square: &Square<S>,
        (place, normal): (Vec3<S>, UnitVec3<S>),
        pair: [S::Unit; 2],
    ) -> Option<Self> {
        let mut glimpse = Self::on_square(point, square, (place, normal), pair)?;
        if let Some((direction, ..)) = (point.position - place).normalize() {
            glimpse.lamp.direction = direction;
        }
        Some(glimpse)
    }

    /// Returns what [`Glimpse::of_square`] does, but for the direction of [`Glimpse::lamp`], which is that of the place: a root less, where no
    /// model asks for highlights.
    #[cfg_attr(not(target_os = "none"), inline)]
    pub fn on_square(
        point: &'l Lamp<S>,
        square: &Square<S>,
        (place, normal): (Vec3<S>, UnitVec3<S>),
        [u, v]: [S::Unit; 2],
    ) -> Option<Self> {
        let part = |edge: Vec3<S>, part: S::Unit| {
            Vec3::<S>::new(edge.x().scale(part), edge.y().scale(part), edge.z().scale(part))
        };
        let [along, across] = square.edges;
        let corner = square.corner + (point.position - square.middle);
        let spot = corner + part(along, u) + part(across, v);
        let (direction, distance, inverse_distance) = (spot - place).normalize()?;
        let sent = -square.normal.dot(direction);
        if sent <= S::Unit::ZERO {
            return None;
        }
        let cosine = normal.dot(direction);
        let shown = Incident { direction, distance, inverse_distance, cosine, lamp: point };
        let (least, inverse_least) = square.least;
        // A shadow ray ends before it, so that the surface that a lamp is part of does not hide it.
        let place = Incident { distance: distance - least.scale(S::Unit::ratio(1, 64)), ..shown };
        let inverse_distance = if distance < least { inverse_least } else { inverse_distance };
        let lamp = Incident { inverse_distance, cosine: cosine.times(sent), ..shown };
        Some(Self { place, lamp })
    }
}

/// Returns what [`Scalar::sight`] does, with the arithmetic of any format.
pub fn sight<S: Scalar>(
    (axis, normal): (UnitVec3<S>, UnitVec3<S>),
    sine: S::Unit,
    pair: [S::Unit; 2],
) -> Sight<S> {
    let spot = disc(pair);
    let [x, y] = spot.map(|c| c.times(sine));
    let along = lifted::<S>([x, y]);
    let direction = Frame::about(axis).vector([x, y, along]);
    let cosine = normal.dot(direction);
    // 2^-14.
    let least = S::Unit::of_word(1 << 18);
    let slanted = cosine.quotient(if along < least { least } else { along });
    // The near side of the sphere.
    let reach = along - sine.times(lifted::<S>(spot));
    Sight { direction, cosine, slanted, reach }
}

#[cfg(test)]
#[cfg(feature = "f64")]
mod tests;
