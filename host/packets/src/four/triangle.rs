//! Triangles and four rays at once, with the arithmetic of [`Triangle`].

use glam::{BVec4A, Vec4};
use rta_core::Scalar;
use rta_core::shape::Triangle;

use super::geometry::{Ray4, SurfacePoint4};
use super::vector::Vec3x4;

/// Where four rays meet the planes of triangles, from the corners.
struct Way {
    /// Distances of the feet of the corners.
    along: Vec4,
    /// From the rays to the corners, across.
    foot: Vec3x4,
    /// From the feet along the rays to the planes.
    way: Vec4,
}

impl Way {
    #[inline(always)]
    fn new(displacement: Vec3x4, normal: Vec3x4, cosine: Vec4, direction: Vec3x4) -> Self {
        let along = displacement.dot(direction);
        let foot = displacement - direction.scale(along);
        let (height, zero) = (foot.dot(normal), Vec4::ZERO);
        let way = (height.abs() / cosine.abs()).min(Vec4::splat(f32::FAR));
        let is_ahead = height.cmpgt(zero) ^ cosine.cmplt(zero);
        Self { along, foot, way: Vec4::select(is_ahead, way, -way) }
    }

    /// The places from the corners.
    #[inline(always)]
    fn place(&self, direction: Vec3x4) -> Vec3x4 {
        (-self.foot).plus(direction, self.way)
    }
}

impl Ray4 {
    /// Which of them meet a triangle before `t_max`, or `AT` it too, and how far away: four times [`Triangle::intersect`].
    #[inline(always)]
    pub(crate) fn meet_triangle<const AT: bool>(
        &self,
        triangle: &Triangle<f32>,
        t_max: Vec4,
    ) -> (BVec4A, Vec4) {
        let (normal, zero) = (Vec3x4::splat(triangle.normal), Vec4::ZERO);
        let displacement = Vec3x4::splat(triangle.corner) - self.origin;
        let (height, cosine) = (displacement.dot(normal), normal.dot(self.direction));
        let mut is_ahead = cosine.cmplt(zero) & height.cmplt(zero);
        if !triangle.one_sided {
            is_ahead |= cosine.cmpgt(zero) & height.cmpgt(zero);
        }
        if !is_ahead.any() {
            return (is_ahead, zero);
        }
        let is_before = |t: Vec4| if AT { t.cmple(t_max) } else { t.cmplt(t_max) };
        let way = Way::new(displacement, normal, cosine, self.direction);
        let (b, extent) = (way.along, Vec4::splat(triangle.extent));
        let reach = extent + Vec4::splat(16.0 * f32::EPSILON) * (b.abs() + extent);
        let slack = extent - reach;
        let t = b + way.way;
        let place = way.place(self.direction);
        let [first, second, third] = triangle.inward.map(|inward| place.dot(Vec3x4::splat(inward)));
        let is_near = (b + extent).cmpgt(zero)
            & is_before(b - extent)
            & way.foot.dot(way.foot).cmple(reach * reach)
            & way.way.abs().cmple(reach);
        let is_inside = (Vec4::splat(triangle.heights[0]) + first).cmpge(slack)
            & second.cmpge(slack)
            & third.cmpge(slack);
        (is_ahead & is_near & t.cmpgt(zero) & is_before(t) & is_inside, t)
    }
}

impl SurfacePoint4 {
    /// Where rays meet triangles without normals at their vertices: four times [`Triangle::point`].
    #[inline(always)]
    pub(crate) fn on_triangles(triangles: [&Triangle<f32>; 4], rays: &Ray4) -> Self {
        let corner = Vec3x4::new(triangles.map(|triangle| triangle.corner));
        let normal = Vec3x4::new(triangles.map(|triangle| triangle.normal));
        let cosine = normal.dot(rays.direction);
        let way = Way::new(corner - rays.origin, normal, cosine, rays.direction);
        let place = way.place(rays.direction);
        // Back into the plane by what the roundings have left.
        let place = place - normal.scale(place.dot(normal));
        Self { distance: way.along + way.way, point: corner + place, normal }
    }
}
