//! What four rays side by side meet.

use glam::{BVec4A, Vec4};
use rta_core::Scalar;
use rta_core::accelerator::Accelerator;
use rta_core::needs::Needs;
use rta_core::scene::{Hit, Object};
use rta_core::shape::Primitive;
use rta_core::world::World;

use super::geometry::{Ray4, to_floor};
use super::packet::RayPacket;
use super::vector::{lane, mask, one, one_mut, set};
use crate::cache::ShadowCache;
use crate::leaf::{Bits, Sphere4, index};
use crate::one::{distance, nearest_plane};
use crate::packets::Packets;

/// The nearest hits of four rays.
pub(crate) struct Closest4 {
    /// How far away; of a ray that meets nothing, [`Scalar::FAR`], and of one that is not there, 0.
    pub(crate) distance: Vec4,
    pub(crate) objects: [Option<Object>; 4],
}

impl Closest4 {
    /// Takes hits of those rays that are not farther away; where one is as near, the first in order.
    #[inline(always)]
    fn offer(&mut self, met: BVec4A, distance: Vec4, object: Object) {
        let nearer = met & distance.cmplt(self.distance);
        let mut taken = nearer.bitmask();
        for k in Bits(met.bitmask() & !taken) {
            taken |= u32::from(one(&self.objects, k).is_none_or(|met| object < met)) << k;
        }
        self.distance = Vec4::select(nearer, distance, self.distance);
        for k in Bits(taken) {
            *one_mut(&mut self.objects, k) = Some(object);
        }
    }

    /// Takes the hit of one.
    #[inline(always)]
    fn offer_one(&mut self, k: usize, hit: Hit<f32>) {
        let place = one_mut(&mut self.objects, k);
        if hit.distance < lane(&self.distance, k) || place.is_none_or(|met| hit.object < met) {
            set(&mut self.distance, k, hit.distance);
            *place = Some(hit.object);
        }
    }

    /// What one ray has to be nearer than.
    #[inline(always)]
    fn limit(&self, k: usize) -> f32 {
        lane(&self.distance, k).next_up()
    }
}

impl Packets {
    /// Returns the nearest hits of four rays, of those in `there`. `are_eyes` is whether they have just left the eye: then the
    /// others are copies, later they are rays of samples that are done.
    #[inline(always)]
    pub(crate) fn closest_four<N: Needs>(
        &self,
        world: &World<'_, f32>,
        rays: &Ray4,
        (there, are_eyes): (u32, bool),
        cache: &mut ShadowCache,
    ) -> Closest4 {
        let far = Vec4::select(mask(there), Vec4::splat(f32::FAR), Vec4::ZERO);
        let mut nearest = Closest4 { distance: far, objects: [None; 4] };
        if N::FLOOR && world.scene.floor.is_some() {
            let (met, distance) = to_floor(rays);
            nearest.offer(met & distance.cmple(nearest.distance), distance, Object::Floor);
        }
        let left = if !self.is_too_large && (are_eyes || self.nodes.is_empty()) {
            self.closest_together::<N>(world, rays, there, cache, &mut nearest)
        } else {
            there
        };
        for k in Bits(left) {
            if let Some(hit) = self.closest::<N>(world, &rays.lane(k), cache) {
                nearest.offer_one(k, hit);
            }
        }
        nearest
    }

    /// Finds the nearest hit of each together: a bit for each ray that has to look for itself.
    #[inline(always)]
    fn closest_together<N: Needs>(
        &self,
        world: &World<'_, f32>,
        rays: &Ray4,
        there: u32,
        cache: &mut ShadowCache,
        nearest: &mut Closest4,
    ) -> u32 {
        let history = cache.of_eye();
        if !history.go_together() {
            return there;
        }
        let Some(mut four) = RayPacket::new(self, rays, nearest.distance) else {
            return there;
        };
        let mut asked = 0;
        let mut left = 0;
        if N::CYLINDERS {
            for columns in &self.columns {
                for (k, &i) in columns.cylinders.iter().enumerate() {
                    let Some(cylinder) = world.scene.cylinders.get(index(i)) else { continue };
                    for r in four.meet_column(columns, k) {
                        let ray = world.ray::<N>(rays.origin.lane(r), rays.direction.lane(r));
                        if let Some(distance) = cylinder.intersect(&ray, nearest.limit(r)) {
                            nearest.offer_one(r, Hit { distance, object: Object::Cylinder(i) });
                            four.shorten(nearest.distance);
                        }
                    }
                }
            }
        }
        if N::PLANES && !world.scene.planes.is_empty() {
            for k in Bits(there) {
                if let Some(hit) = nearest_plane(world, &rays.lane(k), nearest.limit(k)) {
                    nearest.offer_one(k, hit);
                }
            }
            four.shorten(nearest.distance);
        }
        if self.nodes.is_empty() {
            for leaf in &self.leaves {
                asked += self.closest_of::<N>(world, (leaf, leaf.slots(), 15), rays, &mut four, nearest);
            }
        } else {
            let (Some(cells), Some(frustum)) = (four.eye_cells(), four.frustum()) else { return there };
            let mut waiting = there;
            while let Some((cell, group)) = next_group(&cells, &mut waiting) {
                let cell = self.light_buffers.in_cell(0, cell);
                for &entry in cell.entries {
                    let longest = four.longest();
                    if cell.near(entry) > longest {
                        break;
                    }
                    let Some(leaf) = self.leaves.get(index(entry.leaf())) else {
                        // There may be more.
                        left |= group;
                        break;
                    };
                    let slots = frustum.touch(leaf, longest);
                    asked += self.closest_of::<N>(world, (leaf, slots, group), rays, &mut four, nearest);
                }
            }
        }
        history.have_tested(asked);
        left
    }

    /// The nearest hits with some items of a leaf of the rays in `group`, and how many items that were.
    #[inline(always)]
    fn closest_of<N: Needs>(
        &self,
        world: &World<'_, f32>,
        (leaf, slots, group): (&Sphere4, Bits, u32),
        rays: &Ray4,
        four: &mut RayPacket,
        nearest: &mut Closest4,
    ) -> u32 {
        let mut asked = 0;
        for k in slots {
            asked += 1;
            let item = one(&leaf.items, k);
            let sphere = || {
                let (center, radius) = leaf.sphere(k);
                let (is_met, distance) = rays.meet_sphere(center, radius);
                (is_met & distance.cmple(nearest.distance), distance)
            };
            let (is_met, distance) = match item {
                Object::Sphere(_) if N::SPHERES => sphere(),
                Object::Lamp(_) if N::VISIBLE_LAMPS => sphere(),
                Object::Triangle(i) if N::TRIANGLES => {
                    let Some(triangle) = world.scene.triangles.get(index(i)) else { continue };
                    rays.meet_triangle::<true>(triangle, nearest.distance)
                }
                _ => {
                    for r in Bits(four.meet(leaf, k) & group) {
                        if let Some(distance) = distance::<_, N>(world, item, &rays.lane(r), nearest.limit(r))
                        {
                            nearest.offer_one(r, Hit { distance, object: item });
                            four.shorten(nearest.distance);
                        }
                    }
                    continue;
                }
            };
            let is_met = if group == 15 { is_met } else { is_met & mask(group) };
            if is_met.any() {
                nearest.offer(is_met, distance, item);
                four.shorten(nearest.distance);
            }
        }
        asked
    }
}

/// The cell of the next of the rays in `waiting`, and which of them look through it.
#[inline(always)]
pub(crate) fn next_group(cells: &[usize; 4], waiting: &mut u32) -> Option<(usize, u32)> {
    let first = *cells.get(Bits(*waiting).next()?)?;
    let mut group = 0;
    for (k, &cell) in cells.iter().enumerate() {
        group |= u32::from(cell == first) << k;
    }
    group &= *waiting;
    *waiting &= !group;
    Some((first, group))
}
