//! Four rays and one thing, or one ray and four things: spheres and cylinders; and four triangles.

use glam::Vec4;
use rta_core::ray::Ray;
use rta_core::vector::Vector;

use crate::four::geometry::Ray4;
use crate::four::triangle::Met4;
use crate::four::vector::Vec3x4;
use crate::leaf::{Bits, Cone4, Exact4, LARGEST, Triangle4};
use crate::number::ToF32;

/// A ray in `f32`.
pub(crate) struct RayF32 {
    pub(crate) origin: Vec4,
    pub(crate) direction: Vec4,
    pub(crate) margin: f32,
}

impl RayF32 {
    /// Of a ray from so far away that its test could overflow, one that meets everything.
    #[inline(always)]
    pub(crate) fn new<S: ToF32>(ray: &Ray<S>, size: f32) -> Self {
        let (o, d) = (ray.origin, ray.direction);
        let origin = Vec4::new(o.x().to_f32(), o.y().to_f32(), o.z().to_f32(), size);
        let direction = Vec4::new(S::unit_to_f32(d.x()), S::unit_to_f32(d.y()), S::unit_to_f32(d.z()), 0.0);
        let far = origin.abs().max_element();
        if far <= LARGEST {
            Self { origin, direction, margin: S::margin(far) }
        } else {
            Self { origin: Vec4::ZERO, direction: Vec4::ZERO, margin: f32::INFINITY }
        }
    }
}

/// Four rays side by side, or one ray four times, and how far they go.
#[derive(Clone, Copy)]
pub(crate) struct Rays {
    /// x, y and z of where they start.
    pub(crate) origin: [Vec4; 3],
    /// x, y and z of where they lead.
    pub(crate) direction: [Vec4; 3],
    /// The largest of their margins.
    pub(crate) margin: f32,
    /// Distances, with the margin.
    pub(crate) t_max: Vec4,
}

impl Rays {
    /// Which of them meet which spheres ahead and before their end.
    #[inline(always)]
    pub(crate) fn meet_spheres(&self, [cx, cy, cz]: [Vec4; 3], radius: Vec4) -> Mask {
        let ([ox, oy, oz], [dx, dy, dz]) = (self.origin, self.direction);
        let (x, y, z) = (cx - ox, cy - oy, cz - oz);
        let b = x * dx + y * dy + z * dz;
        let (x, y, z) = (x - dx * b, y - dy * b, z - dz * b);
        let across = x * x + y * y + z * z;
        let r = radius + Vec4::splat(self.margin);
        let is_along = (b + r).cmpgt(Vec4::ZERO) & (b - r).cmplt(self.t_max);
        let mask = (across.cmple(r * r) & is_along).bitmask();
        Mask { mask, along: b, across, triangles: 0, distance: Vec4::ZERO, begin: Vec4::ZERO }
    }

    /// A bit for each vertical cylinder that a ray may meet ahead and before its end: as [`Rays::meet_cones`] sees it. The way
    /// seen from above is not longer than the way.
    #[inline(always)]
    pub(crate) fn meet_columns(&self, [cx, cy]: [Vec4; 2], radius: Vec4) -> u32 {
        let ([ox, oy, _], [dx, dy, _]) = (self.origin, self.direction);
        let margin = Vec4::splat(self.margin);
        let (x, y, r) = (cx - ox, cy - oy, radius + margin);
        let (b, s) = (x * dx + y * dy, ((x * dy - y * dx).abs() - margin).max(Vec4::ZERO));
        let is_along = (b + r).cmpgt(Vec4::ZERO) & (b - r).cmplt(self.t_max);
        (is_along & !(s * s).cmpgt(r * r * (dx * dx + dy * dy))).bitmask()
    }

    /// Of the triangles in `mask`, those that a ray may meet.
    ///
    /// Those are left out whose plane it meets beyond an edge, by the part `cosine` of how far. A triangle's own test moves an edge by no more
    /// than a foot point errs, one margin at most, and these sums err by less than 60 EPSILON of `far`: four margins are more.
    #[inline(always)]
    pub(crate) fn meet_triangles(&self, triangles: &Triangle4, mask: u32) -> u32 {
        let ([ox, oy, oz], [dx, dy, dz]) = (self.origin, self.direction);
        let ([x, y, z], [nx, ny, nz]) = (triangles.corner, triangles.normal);
        let (x, y, z) = (x - ox, y - oy, z - oz);
        let height = x * nx + y * ny + z * nz;
        let cosine = nx * dx + ny * dy + nz * dz;
        let zero = Vec4::ZERO;
        let is_upwards = cosine.cmpgt(zero);
        let least = Vec4::splat(-4.0 * self.margin);
        let [first, second, third] = triangles
            .inward
            .map(|[ix, iy, iz]| height * (ix * dx + iy * dy + iz * dz) - cosine * (x * ix + y * iy + z * iz));
        let first = first + triangles.height * cosine;
        // Upwards none of them is below 0, downwards none above.
        let is_upwards = is_upwards & (first.cmplt(least) | second.cmplt(least) | third.cmplt(least));
        let is_downwards =
            cosine.cmplt(zero) & (first.cmpgt(-least) | second.cmpgt(-least) | third.cmpgt(-least));
        mask & !(is_upwards | is_downwards).bitmask()
    }

    /// Finds where a ray, in `f32`, meets the triangles of a leaf. Of what else is in the leaf nothing changes.
    #[inline(always)]
    pub(crate) fn find_triangles(&self, triangles: &Exact4, met: &mut Mask) {
        let ray = Ray4 { origin: Vec3x4(self.origin), direction: Vec3x4(self.direction) };
        let margin = Vec4::splat(4.0 * self.margin);
        met.mask &= ray.meet_planes(triangles, self.t_max, margin).bitmask() | !triangles.which;
        if met.mask & triangles.which == 0 {
            return;
        }
        let Met4 { is_met, distance, begin } = ray.meet_triangles(triangles, self.t_max);
        let found = is_met.bitmask() & triangles.which;
        met.mask &= found | !triangles.which;
        (met.triangles, met.distance, met.begin) = (found, distance, begin);
    }

    /// A bit for each cylinder that a ray meets if it is endless too. The nearest of the two lines is `|s| / |n|`, with `n`
    /// normal to both; `s` errs by less than the margin, as a foot point does. What is no number, as where the margin is
    /// infinite, is met.
    #[inline(always)]
    pub(crate) fn meet_cones(&self, [cx, cy, cz]: [Vec4; 3], cones: &Cone4) -> u32 {
        let ([ox, oy, oz], [dx, dy, dz]) = (self.origin, self.direction);
        let ([ax, ay, az], margin) = (cones.axis, Vec4::splat(self.margin));
        let (nx, ny, nz) = (dy * az - dz * ay, dz * ax - dx * az, dx * ay - dy * ax);
        let s = (cx - ox) * nx + (cy - oy) * ny + (cz - oz) * nz;
        let (s, r) = ((s.abs() - margin).max(Vec4::ZERO), cones.radius + margin);
        (!(s * s).cmpgt(r * r * (nx * nx + ny * ny + nz * nz))).bitmask()
    }
}

/// What a ray may meet of a leaf.
pub(crate) struct Mask {
    pub(crate) mask: u32,
    /// Distance of the foot point of each centre.
    pub(crate) along: Vec4,
    /// The square of how far the foot point is from the centre.
    pub(crate) across: Vec4,
    /// A bit for each triangle that is met; else 0. Then the distances at which they are, and the least at which anything of them may be.
    pub(crate) triangles: u32,
    pub(crate) distance: Vec4,
    pub(crate) begin: Vec4,
}

impl Mask {
    /// The numbers of the items, 0 to 3.
    #[inline(always)]
    pub(crate) fn items(&self) -> Bits {
        Bits(self.mask)
    }
}
