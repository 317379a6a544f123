//! Triangles and four rays at once, or one ray and four triangles, with the arithmetic of [`Triangle`].

use glam::{BVec4A, Vec3, Vec4};
use rta_core::Scalar;
use rta_core::shape::Triangle;

use super::geometry::{Ray4, SurfacePoint4};
use super::vector::Vec3x4;
use crate::leaf::Exact4;

/// Where four rays meet triangles.
pub(crate) struct Met4 {
    /// Which of them do.
    pub(crate) is_met: BVec4A,
    /// How far away.
    pub(crate) distance: Vec4,
    /// The least distance at which anything of the triangle may be: one that is not below `t_max` is not met.
    pub(crate) begin: Vec4,
}

/// Four rays and the planes of triangles, relative to their first vertices.
struct Feet {
    /// Distances of the feet of the three vertices.
    along: [Vec4; 3],
    /// From the rays to the first vertices, across.
    foot: Vec3x4,
    /// From the feet of the first vertices along the rays to the planes.
    way: Vec4,
}

impl Feet {
    /// `vertices` are relative to the rays' origins.
    #[inline(always)]
    fn new(vertices: [Vec3x4; 3], normal: Vec3x4, cosine: Vec4, direction: Vec3x4) -> Self {
        let along = vertices.map(|vertex| vertex.dot(direction));
        let [corner, ..] = vertices;
        let [b, second, third] = along;
        let foot = corner - direction.scale(b);
        let (rise, zero) = (foot.dot(normal), Vec4::ZERO);
        let way = (rise.abs() / cosine.abs()).min(Vec4::splat(f32::FAR));
        let way = Vec4::select(rise.cmpgt(zero) ^ cosine.cmplt(zero), way, -way);
        let (least, most) = (b.min(second).min(third), b.max(second).max(third));
        Self { along, foot, way: way.max(least - b).min(most - b) }
    }

    /// Returns the places of the hits relative to the first vertices.
    #[inline(always)]
    fn place(&self, direction: Vec3x4) -> Vec3x4 {
        (-self.foot).plus(direction, self.way)
    }
}

impl Ray4 {
    /// Which of them meet a triangle before `t_max`, and how far away: four times [`Triangle::intersect`]. `margin` is that of
    /// [`Ray4::meet_planes`].
    #[inline(always)]
    pub(crate) fn meet_triangle(
        &self,
        triangle: &Triangle<f32>,
        t_max: Vec4,
        margin: Vec4,
    ) -> (BVec4A, Vec4) {
        let triangle = Exact4::splat(triangle);
        let is_near = self.meet_planes(&triangle, t_max, margin);
        if !is_near.any() {
            return (is_near, Vec4::ZERO);
        }
        let Met4 { is_met, distance, .. } = self.meet_triangles(&triangle, t_max);
        (is_met, distance)
    }

    /// Which of them meet the planes of triangles ahead and before `t_max`, or a little beyond: each ray that meets its triangle before `t_max` is
    /// among them. The way to a plane, times the cosine, is the height; the triangle's own test computes the way from feet on the ray, with an
    /// error that comes to less than the margin of a foot in height. `margin` is four of these.
    #[inline(always)]
    pub(crate) fn meet_planes(&self, triangles: &Exact4, t_max: Vec4, margin: Vec4) -> BVec4A {
        let [corner, ..] = triangles.vertices;
        let (height, cosine) =
            ((corner - self.origin).dot(triangles.normal), triangles.normal.dot(self.direction));
        let is_near = height.abs().cmple(cosine.abs() * t_max + margin);
        is_near & is_ahead(triangles, height, cosine)
    }

    /// Where each meets its triangle before `t_max`: four times [`Triangle::intersect`].
    #[inline(always)]
    pub(crate) fn meet_triangles(&self, triangles: &Exact4, t_max: Vec4) -> Met4 {
        let (normal, zero) = (triangles.normal, Vec4::ZERO);
        let vertices = triangles.vertices.map(|vertex| vertex - self.origin);
        let (height, cosine) = (vertices[0].dot(normal), normal.dot(self.direction));
        let is_ahead = is_ahead(triangles, height, cosine);
        if !is_ahead.any() {
            return Met4 { is_met: is_ahead, distance: zero, begin: zero };
        }
        let feet = Feet::new(vertices, normal, cosine, self.direction);
        let ([along, second, third], extent) = (feet.along, triangles.extent);
        let reach = extent + Vec4::splat(16.0 * f32::EPSILON) * (along.abs() + extent);
        let begin = along - extent;
        let is_near =
            (along + extent).cmpgt(zero) & begin.cmplt(t_max) & feet.foot.dot(feet.foot).cmple(reach * reach);
        let distance = along + feet.way;
        let [_, b, c] = vertices;
        let feet = [feet.foot, b - self.direction.scale(second), c - self.direction.scale(third)];
        let is_between = self.passes_between(feet) & distance.cmpgt(zero) & distance.cmplt(t_max);
        Met4 { is_met: is_ahead & is_near & is_between, distance, begin }
    }

    /// Returns which rays pass between three feet on them, by the areas of their triangles with each two of the feet.
    #[inline(always)]
    fn passes_between(&self, feet: [Vec3x4; 3]) -> BVec4A {
        let [x, y, z] = self.direction.0.map(Vec4::abs);
        let is_x = x.cmpge(y) & x.cmpge(z);
        let is_z = !is_x & z.cmpge(y);
        let [(a, b), (c, d), (e, f)] =
            feet.map(|Vec3x4([x, y, z])| (Vec4::select(is_x, y, x), Vec4::select(is_z, y, z)));
        let areas = [c * f - e * d, e * b - a * f, a * d - c * b];
        let [left, right] = [|v: Vec4| v.cmpgt(Vec4::ZERO), |v: Vec4| v.cmplt(Vec4::ZERO)]
            .map(|side| side(areas[0]) | side(areas[1]) | side(areas[2]));
        left ^ right
    }
}

/// Returns which rays lead to the planes of triangles, on a side from which these are seen.
#[inline(always)]
fn is_ahead(triangles: &Exact4, height: Vec4, cosine: Vec4) -> BVec4A {
    let zero = Vec4::ZERO;
    (cosine.cmplt(zero) & height.cmplt(zero)) | (cosine.cmpgt(zero) & height.cmpgt(triangles.back))
}

impl SurfacePoint4 {
    /// Where rays meet triangles without normals at their vertices: four times [`Triangle::point`].
    #[inline(always)]
    pub(crate) fn on_triangles(triangles: [&Triangle<f32>; 4], rays: &Ray4) -> Self {
        let vertex: [fn(&Triangle<f32>) -> Vec3; 3] =
            [|t| t.vertices[0], |t| t.vertices[1], |t| t.vertices[2]];
        let [corner, second, third] = vertex.map(|of| Vec3x4::new(triangles.map(of)));
        let normal = Vec3x4::new(triangles.map(|triangle| triangle.normal));
        let cosine = normal.dot(rays.direction);
        let vertices = [corner, second, third].map(|vertex| vertex - rays.origin);
        let feet = Feet::new(vertices, normal, cosine, rays.direction);
        let place = feet.place(rays.direction);
        // Back into the plane by what the roundings have left.
        let place = place - normal.scale(place.dot(normal));
        Self { distance: feet.along[0] + feet.way, point: corner + place, normal }
    }
}
