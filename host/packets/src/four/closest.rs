//! What four rays side by side meet.

use glam::{BVec4A, Vec4};
use rta_core::Scalar;
use rta_core::accelerator::{Accelerator, Closest};
use rta_core::needs::Needs;
use rta_core::scene::{Hit, Object};
use rta_core::shape::Primitive;
use rta_core::world::World;

use super::geometry::{Ray4, to_floor};
use super::packet::RayPacket;
use super::vector::{lane, mask, one, one_mut, one_ref, set};
use crate::cache::ShadowCache;
use crate::leaf::{Bits, Sphere4, index};
use crate::one::distance;
use crate::packets::Packets;

/// The hits that four rays see.
pub(crate) struct Hits4 {
    /// How far away; of a ray that meets nothing, [`Scalar::FAR`].
    pub(crate) distance: Vec4,
    pub(crate) objects: [Option<Object>; 4],
}

/// The hits of four rays: four times [`Closest`].
struct Closest4 {
    /// From where on hits are of no interest; of a ray that is not there, 0.
    limit: Vec4,
    rays: [Closest<f32>; 4],
}

impl Closest4 {
    /// Adds the hits of an object at distances before [`Closest4::limit`].
    #[inline(always)]
    fn offer<N: Needs>(&mut self, met: BVec4A, distance: Vec4, object: Object) {
        for k in Bits(met.bitmask()) {
            self.offer_one::<N>(k, Hit { distance: lane(&distance, k), object });
        }
    }

    /// Adds the hit of one ray.
    #[inline(always)]
    fn offer_one<N: Needs>(&mut self, k: usize, hit: Hit<f32>) {
        let ray = one_mut(&mut self.rays, k);
        ray.offer::<N>(hit);
        set(&mut self.limit, k, ray.limit());
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
    ) -> Hits4 {
        let limit = Vec4::select(mask(there), Vec4::splat(f32::FAR), Vec4::ZERO);
        let mut closest = Closest4 { limit, rays: [const { Closest::new() }; 4] };
        if N::FLOOR && world.scene.floor.is_some() {
            let (met, distance) = to_floor(rays);
            closest.offer::<N>(met & distance.cmplt(closest.limit), distance, Object::Floor);
        }
        let left = if !self.is_too_large && (are_eyes || self.nodes.is_empty()) {
            self.closest_together::<N>(world, rays, there, cache, &mut closest)
        } else {
            there
        };
        let mut hits = Hits4 { distance: Vec4::splat(f32::FAR), objects: [None; 4] };
        for k in Bits(there) {
            let hit = if left >> k & 1 == 1 {
                self.closest::<N>(world, &rays.lane(k), cache)
            } else {
                one_ref(&closest.rays, k).seen::<N>(&world.scene, &rays.lane(k))
            };
            if let Some(hit) = hit {
                set(&mut hits.distance, k, hit.distance);
                *one_mut(&mut hits.objects, k) = Some(hit.object);
            }
        }
        hits
    }

    /// Finds the nearest hit of each together: a bit for each ray that has to look for itself.
    #[inline(always)]
    fn closest_together<N: Needs>(
        &self,
        world: &World<'_, f32>,
        rays: &Ray4,
        there: u32,
        cache: &mut ShadowCache,
        closest: &mut Closest4,
    ) -> u32 {
        let history = cache.of_eye();
        if !history.go_together() {
            return there;
        }
        let Some(mut four) = RayPacket::new(self, rays, closest.limit) else {
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
                        if let Some(distance) = cylinder.intersect(&ray, lane(&closest.limit, r)) {
                            closest.offer_one::<N>(r, Hit { distance, object: Object::Cylinder(i) });
                            four.shorten(closest.limit);
                        }
                    }
                }
            }
        }
        if self.nodes.is_empty() {
            for leaf in &self.leaves {
                asked += self.closest_of::<N>(world, (leaf, leaf.slots(), 15), rays, &mut four, closest);
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
                    asked += self.closest_of::<N>(world, (leaf, slots, group), rays, &mut four, closest);
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
        closest: &mut Closest4,
    ) -> u32 {
        let mut asked = 0;
        for k in slots {
            asked += 1;
            let item = one(&leaf.items, k);
            let sphere = || {
                let (center, radius) = leaf.sphere(k);
                let (is_met, distance) = rays.meet_sphere(center, radius);
                (is_met & distance.cmplt(closest.limit), distance)
            };
            let (is_met, distance) = match item {
                Object::Sphere(_) if N::SPHERES => sphere(),
                Object::Lamp(_) if N::VISIBLE_LAMPS => sphere(),
                Object::Triangle(i) if N::TRIANGLES => {
                    let Some(triangle) = world.scene.triangles.get(index(i)) else { continue };
                    rays.meet_triangle(triangle, closest.limit)
                }
                _ => {
                    for r in Bits(four.meet(leaf, k) & group) {
                        if let Some(distance) =
                            distance::<_, N>(world, item, &rays.lane(r), lane(&closest.limit, r))
                        {
                            closest.offer_one::<N>(r, Hit { distance, object: item });
                            four.shorten(closest.limit);
                        }
                    }
                    continue;
                }
            };
            let is_met = if group == 15 { is_met } else { is_met & mask(group) };
            if is_met.any() {
                closest.offer::<N>(is_met, distance, item);
                four.shorten(closest.limit);
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
