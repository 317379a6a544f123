//! The triangle, by the perpendicular feet of its vertices on the ray.
//!
//! A foot depends on ray and vertex alone, so triangles that share an edge compare equal numbers, whose difference has an exact
//! sign: no ray passes between them, and no tolerance is needed (S. Woop, C. Benthin and I. Wald, "Watertight Ray/Triangle
//! Intersection", JCGT 2(1), 2013, here without its shear and its division).

use super::{Look, Move, Primitive, SurfacePoint};
use crate::color::Rgb;
use crate::light::cone::{Hidden, LampCone};
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};
use crate::scalar::{Scalar, Unit};

/// A triangle.
#[derive(Clone, Copy, Debug)]
pub struct Triangle<S: Scalar> {
    /// The vertices.
    pub vertices: [Vec3<S>; 3],
    /// The length of the longer edge at the first vertex.
    pub extent: S,
    /// Unit normal on the side from which the vertices run counterclockwise.
    pub normal: UnitVec3<S>,
    /// Unit normals at the vertices, interpolated for a surface that is shaded as if it were curved (Phong 1975).
    pub normals: Option<[UnitVec3<S>; 3]>,
    /// Whether it is visible only from where the vertices run counterclockwise. A ray that meets it from behind passes, a
    /// shadow ray too.
    pub one_sided: bool,
    /// Reflectance of the surface.
    pub color: Rgb<S::Unit>,
    /// Number of its material in the scene's list, from 0.
    pub material: u16,
}

/// A ray that meets the plane of a triangle from a side on which this is seen, and comes as near to the first vertex as the longer edge
/// there is long.
struct Approach<S: Scalar> {
    /// Distances of the vertices' feet on the ray.
    along: [S; 3],
    /// From the first vertex's foot to the vertex.
    foot: Vec3<S>,
    /// The others, relative to the ray's origin.
    others: [Vec3<S>; 2],
    /// Of the ray and the normal, which is not 0.
    cosine: S::Unit,
}

impl<S: Scalar> Approach<S> {
    /// Returns the way from the first vertex's foot along the ray to the plane.
    #[inline]
    fn way(&self, normal: UnitVec3<S>) -> S {
        let ([b, ..], rise, is_upwards) = (self.along, self.foot.dot(normal), self.cosine > S::Unit::ZERO);
        let size = if rise < S::ZERO { -rise } else { rise };
        let way = size.over(if is_upwards { self.cosine } else { -self.cosine });
        let way = if (rise > S::ZERO) == is_upwards { way } else { -way };
        // No hit is beyond the vertices' own feet, even if the triangle is seen on edge.
        let (least, most) = self.along.iter().fold((b, b), |(least, most), &along| {
            (if along < least { along } else { least }, if along > most { along } else { most })
        });
        let way = if way < least - b { least - b } else { way };
        if way > most - b { most - b } else { way }
    }

    /// Returns the areas of the ray with two vertices each; `None` where it does not pass between the three.
    #[inline]
    fn areas(&self, direction: UnitVec3<S>) -> Option<[S::Wide; 3]> {
        let ([second, third], [_, b, c]) = (self.others, self.along);
        areas::<S>(direction, [self.foot, second.reject(direction, b), third.reject(direction, c)])
    }
}

impl<S: Scalar> Triangle<S> {
    /// Returns how a ray comes near, if it does so before `t_max`.
    #[inline]
    fn approach(&self, ray: &Ray<S>, t_max: S) -> Option<Approach<S>> {
        let direction = ray.direction;
        let [corner, second, third] = self.vertices.map(|vertex| vertex - ray.origin);
        // A ray that leads away from the plane, as most do that begin on it.
        let (height, cosine) = (corner.dot(self.normal), self.normal.dot(direction));
        let is_upwards = cosine > S::Unit::ZERO;
        let is_ahead = if is_upwards {
            height > S::ZERO && !self.one_sided
        } else {
            cosine < S::Unit::ZERO && height < S::ZERO
        };
        if !is_ahead {
            return None;
        }
        let b = corner.dot(direction);
        if b + self.extent <= S::ZERO || b - self.extent >= t_max {
            return None;
        }
        let foot = corner.reject(direction, b);
        if foot.norm_squared() > self.extent.padded(b).square() {
            return None;
        }
        let along = [b, second.dot(direction), third.dot(direction)];
        Some(Approach { along, foot, others: [second, third], cosine })
    }

    /// Returns the place in the middle: the mean of the vertices.
    pub fn middle(&self) -> Vec3<S> {
        let [corner, second, third] = self.vertices;
        let third_of = |edge: Vec3<S>| {
            let part = S::Unit::ratio(1, 3);
            Vec3::<S>::new(edge.x().scale(part), edge.y().scale(part), edge.z().scale(part))
        };
        corner + third_of(second - corner) + third_of(third - corner)
    }

    /// Returns the barycentric coordinates of a place of the triangle: 0 or more each, and 1 in all. They are areas as seen along the axis that is
    /// nearest to the normal.
    pub fn weights(&self, place: Vec3<S>) -> [S::Unit; 3] {
        let size = |c: S::Unit| if c < S::Unit::ZERO { -c } else { c };
        let (x, y, z) = (size(self.normal.x()), size(self.normal.y()), size(self.normal.z()));
        let is_x = x >= y && x >= z;
        let is_z = !is_x && z >= y;
        let flat = |v: Vec3<S>| (if is_x { v.y() } else { v.x() }, if is_z { v.y() } else { v.z() });
        let area = |(a, b): (S, S), (c, d): (S, S)| a.product(d) - c.product(b);
        let [corner, second, third] = self.vertices;
        let [place, second, third] = [place - corner, second - corner, third - corner].map(flat);
        let zero = S::ZERO.square();
        let whole = area(second, third);
        let share = |part: S::Wide| {
            // The place may be a rounding beyond an edge.
            let is_inside = (part > zero) == (whole > zero);
            if is_inside { S::part(part, whole) } else { S::Unit::ZERO }
        };
        let (b, c) = (share(area(place, third)), share(area(second, place)));
        let rest = S::Unit::ONE - b;
        let c = if c > rest { rest } else { c };
        [rest - c, b, c]
    }

    /// Returns the vertices' normals, interpolated by barycentric coordinates; `None` where they cancel out.
    fn curved(areas: [S::Wide; 3], normals: [UnitVec3<S>; 3]) -> Option<UnitVec3<S>> {
        let [a, b, c] = areas;
        let whole = a + b + c;
        let (b, c) = (S::part(b, whole), S::part(c, whole));
        half_sum::<S>([S::Unit::ONE - b - c, b, c], normals).normalize().map(|(normal, _)| normal)
    }
}

/// Returns half of what the normals of three vertices, mixed by their weights, come to: in fixed point, the whole might be longer than 1 by its
/// rounding.
#[inline]
pub(crate) fn half_sum<S: Scalar>(weights: [S::Unit; 3], normals: [UnitVec3<S>; 3]) -> UnitVec3<S> {
    let half = S::Unit::ratio(1, 2);
    let ([first, second, third], [a, b, c]) = (normals, weights.map(|weight| weight.times(half)));
    first.scale(a).plus(second, b).plus(third, c)
}

/// Returns for each of three feet on a ray twice the signed area of the triangle of the ray and the others, as seen along the
/// axis that is nearest to the ray's direction; `None` where the ray does not pass between the feet: where two areas differ in
/// sign, or all are 0. In floating point an area may be rounded to 0, but never to the other sign.
#[inline]
fn areas<S: Scalar>(direction: UnitVec3<S>, feet: [Vec3<S>; 3]) -> Option<[S::Wide; 3]> {
    let size = |c: S::Unit| if c < S::Unit::ZERO { -c } else { c };
    let (x, y, z) = (size(direction.x()), size(direction.y()), size(direction.z()));
    let is_x = x >= y && x >= z;
    let is_z = !is_x && z >= y;
    let [(a, b), (c, d), (e, f)] =
        feet.map(|foot| (if is_x { foot.y() } else { foot.x() }, if is_z { foot.y() } else { foot.z() }));
    let areas = [c.product(f) - e.product(d), e.product(b) - a.product(f), a.product(d) - c.product(b)];
    let zero = S::ZERO.square();
    let (mut is_left, mut is_right) = (false, false);
    for area in areas {
        is_left |= area > zero;
        is_right |= area < zero;
    }
    (is_left != is_right).then_some(areas)
}

impl<S: Scalar> Move<S> for Triangle<S> {
    fn moved(&self, by: Vec3<S>) -> Self {
        Self { vertices: self.vertices.map(|vertex| vertex + by), ..*self }
    }
}

impl<S: Scalar> Primitive<S> for Triangle<S> {
    #[inline]
    fn intersect(&self, ray: &Ray<S>, t_max: S) -> Option<S> {
        let approach = self.approach(ray, t_max)?;
        approach.areas(ray.direction)?;
        let [b, ..] = approach.along;
        let distance = b + approach.way(self.normal);
        (distance > S::ZERO && distance < t_max).then_some(distance)
    }

    fn point<N: Needs>(&self, ray: &Ray<S>, t: S) -> SurfacePoint<S> {
        let Some(approach) = self.approach(ray, S::FAR) else {
            return SurfacePoint {
                distance: t,
                point: ray.origin.along(ray.direction, t),
                normal: self.normal,
            };
        };
        let ([b, ..], way) = (approach.along, approach.way(self.normal));
        let (distance, place) = (b + way, (-approach.foot).along(ray.direction, way));
        // Project the place back into the plane, which rounding has left.
        let place = place.reject(self.normal, place.dot(self.normal));
        let mut normal = self.normal;
        if N::NORMALS
            && let Some(normals) = self.normals
            && let Some(areas) = approach.areas(ray.direction)
            && let Some(curved) = Self::curved(areas, normals)
            // Use the flat normal where the interpolated one is on the other side of the ray.
            && (curved.dot(ray.direction) > S::Unit::ZERO) == (normal.dot(ray.direction) > S::Unit::ZERO)
        {
            normal = curved;
        }
        let [corner, ..] = self.vertices;
        SurfacePoint { distance, point: corner + place, normal }
    }

    #[inline]
    fn look(&self) -> Look<S> {
        let Self { vertices: [center, ..], extent, color, material, .. } = *self;
        Look { color, material, extent, center, radius: extent, least: extent }
    }

    fn hidden(&self, cone: &LampCone<S>) -> Hidden<S::Unit> {
        let [corner, ..] = self.vertices;
        let height = |place: Vec3<S>| (place - corner).dot(self.normal);
        let (own, lamps) = (height(cone.apex), height(cone.lamp));
        let from_behind = own < S::ZERO;
        let is_between = if from_behind { lamps > S::ZERO } else { own > S::ZERO && lamps < S::ZERO };
        let is_seen = is_between && !(from_behind && self.one_sided);
        Hidden { part: if is_seen { cone.polygon(self.vertices) } else { S::Unit::ZERO }, from_behind }
    }

    fn face(&self) -> Option<UnitVec3<S>> {
        self.normals.map(|_| self.normal)
    }
}
