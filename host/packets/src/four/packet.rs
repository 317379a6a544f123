//! Four rays beside each other, which are searched for together.
//!
//! Rays of neighbouring pixels hardly differ: an object that one of them does not come near is seldom met by the others (I. Wald,
//! P. Slusallek, C. Benthin and M. Wagner, "Interactive Rendering with Coherent Ray Tracing", Computer Graphics Forum 20(3), 2001). So four items
//! are tested at once against one of the rays, widened to a cone that contains the others; each item that is left is then tested
//! against the four rays at once.

use glam::Vec4;

use super::geometry::Ray4;
use super::vector::{Vec3x4, pick};
use crate::leaf::{Bits, Column4, Cone4, LARGEST, Sphere4, index};
use crate::number::ToF32;
use crate::packets::Packets;
use crate::rays::Rays;

/// Directions of rays that differ by more do not lead beside each other.
const LARGEST_TURN: f32 = 0.25;
/// A ray is not made thicker than this part of its length.
const THICKEST: f32 = 0.0625;

/// Four rays, or less.
pub(crate) struct RayPacket<'a> {
    packets: &'a Packets,
    rays: Rays,
}

/// One of four rays, widened so that the others are in it.
pub(crate) struct Frustum {
    origin: [Vec4; 3],
    direction: [Vec4; 3],
    /// Of a sphere that one of the rays meets, this one meets this part of its radius, and so much more, and so much of how
    /// far away it is.
    thick: [Vec4; 3],
}

impl Frustum {
    /// Which of a leaf's items a ray may meet, if none is longer than `longest`.
    #[inline(always)]
    pub(crate) fn touch(&self, leaf: &Sphere4, longest: f32) -> Bits {
        let ([ox, oy, oz], [dx, dy, dz], [cx, cy, cz]) = (self.origin, self.direction, leaf.center);
        let (x, y, z) = (cx - ox, cy - oy, cz - oz);
        let b = x * dx + y * dy + z * dz;
        let (x, y, z) = (x - dx * b, y - dy * b, z - dz * b);
        let across = x * x + y * y + z * z;
        let [part, more, far] = self.thick;
        let r = leaf.radius * part + more + b.abs() * far;
        let is_along = (b + r).cmpgt(Vec4::ZERO) & (b - r).cmplt(Vec4::splat(longest));
        Bits((across.cmple(r * r) & is_along).bitmask())
    }
}

impl<'a> RayPacket<'a> {
    /// Four rays, and how far each goes; nothing where one comes from too far away.
    #[inline(always)]
    pub(crate) fn new(packets: &'a Packets, rays: &Ray4, t_max: Vec4) -> Option<Self> {
        let far = rays.origin.largest().max(Vec4::splat(packets.size)).max_element();
        if far > LARGEST {
            return None;
        }
        let (Vec3x4(origin), Vec3x4(direction)) = (rays.origin, rays.direction);
        let margin = f32::margin(far);
        let rays = Rays { origin, direction, margin, t_max: t_max + Vec4::splat(margin) };
        Some(Self { packets, rays })
    }

    /// All in one; nothing where they do not lead beside each other.
    #[inline(always)]
    pub(crate) fn frustum(&self) -> Option<Frustum> {
        let first = |v: [Vec4; 3]| v.map(|four| Vec4::splat(four.x));
        let (origin, direction) = (first(self.rays.origin), first(self.rays.direction));
        let beside = apart(Vec3x4(self.rays.origin) - Vec3x4(origin));
        let turn = apart(Vec3x4(self.rays.direction) - Vec3x4(direction));
        if !(turn < LARGEST_TURN && beside < THICKEST * self.longest()) {
            return None;
        }
        // A sphere of the radius r that a ray meets is r + beside + turn x distance away from this one there, and the distance
        // is not above that of this one's foot point, and as much.
        let more = (1.0 - turn).recip();
        let part = more * (1.0 + turn);
        let thick = [part, part * (beside + 2.0 * self.rays.margin), more * turn].map(Vec4::splat);
        Some(Frustum { origin, direction, thick })
    }

    /// Returns where they start and where they lead, by x, y and z, and the largest of their margins.
    #[inline(always)]
    pub(crate) fn rays(&self) -> ([[Vec4; 3]; 2], f32) {
        ([self.rays.origin, self.rays.direction], self.rays.margin)
    }

    /// Returns the margin for the heights of planes, see [`Ray4::meet_planes`].
    #[inline(always)]
    pub(crate) fn height_margin(&self) -> Vec4 {
        Vec4::splat(4.0 * self.rays.margin)
    }

    /// The end of the longest.
    #[inline(always)]
    pub(crate) fn longest(&self) -> f32 {
        self.rays.t_max.max_element()
    }

    /// Returns the cells of the eye's light buffer that the rays lead through; `None` unless all start at the eye.
    #[inline(always)]
    pub(crate) fn eye_cells(&self) -> Option<[usize; 4]> {
        let buffer = self.packets.light_buffers.buffers.first()?;
        let ([x, y, z], slack) = (self.rays.origin, buffer.slack * buffer.slack);
        let [cx, cy, cz, _] = buffer.center.to_array();
        let (x, y, z) = (Vec4::splat(cx) - x, Vec4::splat(cy) - y, Vec4::splat(cz) - z);
        let there = (x * x + y * y + z * z).max_element() <= slack && self.rays.margin <= buffer.margin;
        if there { Some(buffer.cells(self.rays.direction)) } else { None }
    }

    /// Returns the cells of a lamp's light buffer, if all rays end at the lamp with that number, and the farthest origin's distance.
    #[inline(always)]
    pub(crate) fn lamp_cells(&self, lamp: usize) -> Option<([usize; 4], f32)> {
        let buffer = self.packets.light_buffers.buffers.get(lamp + 1)?;
        let ([ox, oy, oz], [dx, dy, dz]) = (self.rays.origin, self.rays.direction);
        let [cx, cy, cz, _] = buffer.center.to_array();
        let (x, y, z) = (Vec4::splat(cx) - ox, Vec4::splat(cy) - oy, Vec4::splat(cz) - oz);
        let along = x * dx + y * dy + z * dz;
        let (x, y, z) = (x - dx * along, y - dy * along, z - dz * along);
        let beside = (x * x + y * y + z * z).max_element();
        let far = along + Vec4::splat(buffer.slack);
        let there = beside <= buffer.slack * buffer.slack
            && self.rays.margin <= buffer.margin
            && self.rays.t_max.cmple(far).all();
        if there { Some((buffer.cells([-dx, -dy, -dz]), far.max_element())) } else { None }
    }

    /// A bit for each ray that may meet item `k` of a leaf, which is no triangle.
    #[inline(always)]
    pub(crate) fn meet(&self, leaf: &Sphere4, k: usize) -> u32 {
        let (Vec3x4(center), radius) = leaf.sphere(k);
        let mask = self.rays.meet_spheres(center, radius).mask;
        if mask == 0 || leaf.cones == Sphere4::NO_CONES {
            return mask;
        }
        let one = |cones: &Cone4| Cone4 {
            axis: cones.axis.map(|four| pick(four, k)),
            radius: pick(cones.radius, k),
        };
        let cones = self.packets.cones.get(index(leaf.cones));
        cones.map_or(mask, |cones| mask & self.rays.meet_cones(center, &one(cones)))
    }

    /// Which rays may meet cylinder `k` of four.
    #[inline(always)]
    pub(crate) fn meet_column(&self, columns: &Column4, k: usize) -> Bits {
        Bits(self.rays.meet_columns(columns.center.map(|four| pick(four, k)), pick(columns.radius, k)))
    }

    /// From now on for each ray only what is not farther than that is looked for.
    #[inline(always)]
    pub(crate) fn shorten(&mut self, t: Vec4) {
        self.rays.t_max = t + Vec4::splat(self.rays.margin);
    }
}

/// The length of the longest.
#[inline(always)]
fn apart(vectors: Vec3x4) -> f32 {
    // Rounded upwards.
    vectors.dot(vectors).max_element().sqrt() * (1.0 + 4.0 * f32::EPSILON)
}
