//! Places on a lamp that has a size, as seen from four points: four times [`rta_core::light::area`].

use glam::Vec4;
use rta_core::light::area::{Glimpse, Square};
use rta_core::light::{Incident, Lamp};
use rta_core::scalar::Unit;

use super::geometry::normalize;
use super::mapping::{Frame4, disc, lifted};
use super::vector::{Vec3x4, lane, mask, set};
use crate::leaf::Bits;

/// A lamp as seen from four points: four times [`Incident`].
#[derive(Clone, Copy)]
pub(crate) struct Incidents4 {
    pub(crate) direction: Vec3x4,
    pub(crate) distance: Vec4,
    pub(crate) inverse_distance: Vec4,
    pub(crate) cosine: Vec4,
}

impl Incidents4 {
    /// One of them.
    #[inline(always)]
    pub(crate) fn lane<'l>(&self, lamp: &'l Lamp<f32>, k: usize) -> Incident<'l, f32> {
        Incident {
            direction: self.direction.lane(k),
            distance: lane(&self.distance, k),
            inverse_distance: lane(&self.inverse_distance, k),
            cosine: lane(&self.cosine, k),
            lamp,
        }
    }

    /// Changes one of them.
    fn set(&mut self, k: usize, incident: &Incident<f32>) {
        self.direction.set(k, incident.direction);
        set(&mut self.distance, k, incident.distance);
        set(&mut self.inverse_distance, k, incident.inverse_distance);
        set(&mut self.cosine, k, incident.cosine);
    }
}

/// Places on a lamp as seen from four points: four times [`Glimpse`].
#[derive(Clone, Copy)]
pub(crate) struct Glimpses4 {
    pub(crate) place: Incidents4,
    pub(crate) lamp: Incidents4,
}

impl Glimpses4 {
    /// Nothing.
    const NONE: Self = {
        let none = Incidents4 {
            direction: Vec3x4::ZERO,
            distance: Vec4::ONE,
            inverse_distance: Vec4::ONE,
            cosine: Vec4::ZERO,
        };
        Self { place: none, lamp: none }
    };

    /// One of them has changed.
    fn set(&mut self, k: usize, glimpse: &Glimpse<f32>) {
        self.place.set(k, &glimpse.place);
        self.lamp.set(k, &glimpse.lamp);
    }
}

/// A lamp with a size from four points: what is computed once for all places on it.
pub(crate) struct Large4<'l> {
    /// As a point, of the radius 0.
    point: &'l Lamp<f32>,
    /// Its own radius, and the reciprocal.
    own: (f32, f32),
    /// What it is, if it is no sphere.
    square: Option<&'l Square<f32>>,
    frame: Frame4,
    sine: Vec4,
    /// A bit for each point that lies within the sphere.
    within: u32,
}

impl<'l> Large4<'l> {
    /// Returns the lamp from four points, and room for places on it, see [`Large4::look`]. `point` is the lamp as a point, of the radius 0, and `own`
    /// its radius with the reciprocal.
    #[inline(always)]
    pub(crate) fn new(
        point: &'l Lamp<f32>,
        own: (f32, f32),
        square: Option<&'l Square<f32>>,
        points: Vec3x4,
    ) -> (Self, Glimpses4) {
        let (direction, distance, inverse_distance, none) = normalize(Vec3x4::splat(point.position) - points);
        let within = none | !distance.cmpgt(Vec4::splat(own.0)).bitmask() & 15;
        let (sine, frame) = (Vec4::splat(own.0) * inverse_distance, Frame4::about(direction));
        let middle = Incidents4 { direction, distance, inverse_distance, cosine: Vec4::ZERO };
        let seen = Glimpses4 { place: middle, lamp: middle };
        let seen = if square.is_some() { Glimpses4::NONE } else { seen };
        (Self { point, own, square, frame, sine, within }, seen)
    }

    /// Looks at places for four pairs of numbers from 0 to 1, from four points with unit normals, of those in `which`: a bit for each that the lamp
    /// shines to. `seen` is what there was at the places before, or what [`Large4::new`] has returned.
    #[inline(always)]
    pub(crate) fn look(
        &self,
        (points, normals): (Vec3x4, Vec3x4),
        pair: [Vec4; 2],
        which: u32,
        seen: &mut Glimpses4,
    ) -> u32 {
        if let Some(square) = self.square {
            return self.look_at_square(square, (points, normals), pair, which, seen);
        }
        let spot = disc(pair);
        let [x, y] = spot.map(|c| c * self.sine);
        let along = lifted([x, y]);
        let direction = self.frame.vector([x, y, along]);
        let cosine = normals.dot(direction);
        let least = Vec4::splat(<f32 as Unit>::of_word(1 << 18));
        let reach = along - self.sine * lifted(spot);
        seen.lamp.cosine = cosine / Vec4::select(along.cmplt(least), least, along);
        seen.place.direction = direction;
        seen.place.distance = seen.lamp.distance * reach;
        seen.place.cosine = cosine;
        for k in Bits(self.within & which) {
            let from = (points.lane(k), normals.lane(k));
            let pair = pair.map(|four| lane(&four, k));
            seen.set(k, &Glimpse::of_sphere(self.point, self.own, from, pair));
        }
        which
    }

    /// Looks at places on a parallelogram: four times [`Glimpse::of_square`].
    #[inline(never)] // spheres do not pay for it
    fn look_at_square(
        &self,
        square: &Square<f32>,
        (points, normals): (Vec3x4, Vec3x4),
        [u, v]: [Vec4; 2],
        which: u32,
        seen: &mut Glimpses4,
    ) -> u32 {
        let corner = Vec3x4::splat(square.corner + (self.point.position - square.middle));
        let [along, across] = square.edges.map(Vec3x4::splat);
        let spot = corner.plus(along, u).plus(across, v);
        let (direction, distance, inverse_distance, none) = normalize(spot - points);
        let sent = -Vec3x4::splat(square.normal).dot(direction);
        let lit = which & !none & sent.cmpgt(Vec4::ZERO).bitmask();
        if lit == 0 {
            return 0;
        }
        let cosine = normals.dot(direction);
        let (middle, .., none) = normalize(Vec3x4::splat(self.point.position) - points);
        let middle = if none == 0 { middle } else { Vec3x4::select(mask(none), direction, middle) };
        let (least, inverse_least) = square.least;
        let is_near = distance.cmplt(Vec4::splat(least));
        let reached = distance - Vec4::splat(least * <f32 as Unit>::ratio(1, 64));
        seen.place = Incidents4 { direction, distance: reached, inverse_distance, cosine };
        let inverse_distance = Vec4::select(is_near, Vec4::splat(inverse_least), inverse_distance);
        seen.lamp = Incidents4 { direction: middle, distance, inverse_distance, cosine: cosine * sent };
        lit
    }
}
