//! What four rays side by side meet.

use glam::{BVec4A, Vec4};
use rta_core::Scalar;
use rta_core::accelerator::{Accelerator, STEEPEST, is_flat};
use rta_core::needs::Needs;
use rta_core::scene::{Hit, Object};
use rta_core::shape::Primitive;
use rta_core::world::World;

use super::geometry::{Ray4, to_floor};
use super::packet::RayPacket;
use super::vector::{lane, mask, one, one_mut, set};
use crate::cache::ShadowCache;
use crate::leaf::{Bits, Sphere4, index};
use crate::one::{distance, has_flat};
use crate::packets::Packets;

/// The hits that four rays see.
#[derive(Clone, Copy)]
pub(crate) struct Hits4 {
    /// How far away; of a ray that meets nothing, [`Scalar::FAR`].
    pub(crate) distance: Vec4,
    pub(crate) objects: [Option<Object>; 4],
}

/// The hits of four rays so far.
struct Closest4 {
    /// The nearest hits; of equally near ones, the first in order.
    nearest: Hits4,
    /// From where on hits are of no interest; of a ray that is not there, 0.
    limit: Vec4,
    /// The limit over the distance of the nearest hit: so that an equally near object is not missed, which may come first in order,
    /// and, where flat objects may lie at one place, none that [`Closest`](rta_core::accelerator::Closest) would keep.
    reach: f32,
    /// A bit for each ray that meets two flat objects near one place, and has to look for itself which of them is seen.
    doubtful: u32,
}

impl Closest4 {
    /// Starts with no hit of the rays in `there`.
    #[inline(always)]
    fn new(there: u32, has_flat: bool) -> Self {
        let nearest = Hits4 { distance: Vec4::splat(f32::FAR), objects: [None; 4] };
        let limit = Vec4::select(mask(there), nearest.distance, Vec4::ZERO);
        let reach = if has_flat { flat_reach() } else { 1.0 + f32::EPSILON };
        Self { nearest, limit, reach, doubtful: 0 }
    }

    /// Adds the hits of an object at distances before [`Closest4::limit`].
    #[inline(always)]
    fn offer(&mut self, met: BVec4A, distance: Vec4, object: Object) {
        let Hits4 { distance: nearest, objects } = &mut self.nearest;
        if self.reach > 1.0 + f32::EPSILON && is_flat(object) {
            let (near, far) = (nearest.min(distance), nearest.max(distance));
            for k in Bits((met & far.cmplt(near * self.reach)).bitmask()) {
                self.doubtful |= u32::from(one(objects, k).is_some_and(is_flat)) << k;
            }
        }
        let nearer = met & distance.cmplt(*nearest);
        let mut taken = nearer.bitmask();
        for k in Bits((met & distance.cmpeq(*nearest)).bitmask()) {
            taken |= u32::from(one(objects, k).is_none_or(|met| object < met)) << k;
        }
        *nearest = Vec4::select(nearer, distance, *nearest);
        for k in Bits(taken) {
            *one_mut(objects, k) = Some(object);
        }
        self.limit = self.limit.min(*nearest * self.reach);
    }

    /// Adds the hit of one ray.
    #[inline(always)]
    fn offer_one(&mut self, k: usize, hit: Hit<f32>) {
        self.offer(mask(1 << k), Vec4::splat(hit.distance), hit.object);
    }
}

/// Returns [`Closest4::reach`] where flat objects may lie at one place, a little more than what [`Scalar::at_one_place`] gives.
fn flat_reach() -> f32 {
    1.0f32.at_one_place(0.0, 1.0 / STEEPEST as f32) + f32::EPSILON
}

impl Hits4 {
    #[inline(always)]
    pub(super) fn set(&mut self, k: usize, hit: Option<Hit<f32>>) {
        set(&mut self.distance, k, hit.map_or(f32::FAR, |hit| hit.distance));
        *one_mut(&mut self.objects, k) = hit.map(|hit| hit.object);
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
        let mut closest = Closest4::new(there, has_flat::<_, N>(world));
        if N::FLOOR && world.scene.floor.is_some() {
            let (met, distance) = to_floor(rays);
            closest.offer(met & distance.cmplt(closest.limit), distance, Object::Floor);
        }
        let left = if !self.is_too_large && (are_eyes || self.nodes.is_empty()) {
            self.closest_together::<N>(world, rays, there, cache, &mut closest)
        } else {
            there
        };
        let mut hits = closest.nearest;
        for k in Bits(left | closest.doubtful) {
            hits.set(k, self.closest::<N>(world, &rays.lane(k), cache));
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
                            closest.offer_one(r, Hit { distance, object: Object::Cylinder(i) });
                            four.shorten(closest.limit);
                        }
                    }
                }
            }
        }
        if N::PLANES {
            for (i, plane) in (0..).zip(world.scene.planes) {
                for r in Bits(there) {
                    if let Some(distance) = plane.intersect(&rays.lane(r), lane(&closest.limit, r)) {
                        closest.offer_one(r, Hit { distance, object: Object::Plane(i) });
                        four.shorten(closest.limit);
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
                    rays.meet_triangle(triangle, closest.limit, four.height_margin())
                }
                _ => {
                    for r in Bits(four.meet(leaf, k) & group) {
                        if let Some(distance) =
                            distance::<_, N>(world, item, &rays.lane(r), lane(&closest.limit, r))
                        {
                            closest.offer_one(r, Hit { distance, object: item });
                            four.shorten(closest.limit);
                        }
                    }
                    continue;
                }
            };
            let is_met = if group == 15 { is_met } else { is_met & mask(group) };
            if is_met.any() {
                closest.offer(is_met, distance, item);
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
