//! What of a lamp's light comes through to four points side by side.

use glam::Vec4;
use rta_core::accelerator::{Accelerator, transmitted};
use rta_core::needs::Needs;
use rta_core::scene::Object;
use rta_core::shape::Primitive;
use rta_core::world::World;

use super::closest::next_group;
use super::geometry::{Ray4, to_floor};
use super::packet::RayPacket;
use super::vector::{Vec3x4, lane, mask, one, one_mut};
use super::walk::Walk;
use crate::cache::ShadowCache;
use crate::leaf::{Bits, Sphere4, index};
use crate::light_buffer::Candidate;
use crate::one::{Filters, distance, through_lists};
use crate::packets::Packets;

/// Four shadow rays while something may hide their lamp.
struct Shadows<'a> {
    rays: &'a Ray4,
    t_max: Vec4,
    /// A bit for each that nothing has hidden.
    open: u32,
    /// What comes through the others' objects.
    filters: [Filters<f32>; 4],
    /// What has hidden the lamp from the last one.
    occluder: Option<Object>,
    /// How many items were asked.
    asked: u32,
}

impl Packets {
    /// Returns what part of a lamp's light comes through along each of four shadow rays with their lengths, of those in
    /// `there`; see [`Accelerator::transmittance`].
    #[inline(never)]
    pub(crate) fn transmittance_four<N: Needs>(
        &self,
        world: &World<'_, f32>,
        (rays, t_max, there): (&Ray4, Vec4, u32),
        lamp: usize,
        cache: &mut ShadowCache,
    ) -> [f32; 4] {
        let mut parts = [1.0; 4];
        let left = if !self.is_too_large && there & there.wrapping_sub(1) != 0 {
            // Others are anything.
            let (rays, t_max) = if there == 15 { (*rays, t_max) } else { only(there, rays, t_max) };
            self.through_together::<N>(world, (&rays, t_max, there), lamp, cache, &mut parts)
        } else {
            there
        };
        for k in Bits(left) {
            *one_mut(&mut parts, k) =
                self.transmittance::<N>(world, &rays.lane(k), lane(&t_max, k), lamp, cache);
        }
        parts
    }

    /// Finds what comes through along each ray together: a bit for each ray that has to look for itself.
    #[inline(always)]
    fn through_together<N: Needs>(
        &self,
        world: &World<'_, f32>,
        (rays, t_max, there): (&Ray4, Vec4, u32),
        lamp: usize,
        cache: &mut ShadowCache,
        parts: &mut [f32; 4],
    ) -> u32 {
        let history = cache.of_lamp(lamp);
        if !history.go_together() {
            return there;
        }
        let mut open = there;
        if let Some(occluder) = history.occluder {
            open &= !hidden_by::<N>(world, occluder, (rays, t_max, Vec4::INFINITY), there);
            hide(there & !open, parts);
            if open == 0 {
                return 0;
            }
            if open == there {
                history.occluder = None;
            }
        }
        let Some(four) = RayPacket::new(self, rays, t_max) else { return open };
        let filters = core::array::from_fn(|_| Filters::new());
        let mut shadows = Shadows { rays, t_max, open, filters, occluder: history.occluder, asked: 0 };
        if N::CYLINDERS {
            self.pass_columns::<N>(world, &four, &mut shadows);
        }
        if N::PLANES && !world.scene.planes.is_empty() {
            pass_planes::<N>(world, &mut shadows);
        }
        let left = self.pass_leaves::<N>(world, &four, lamp, &mut shadows);
        history.occluder = shadows.occluder;
        history.have_tested(shadows.asked);
        let mut open = shadows.open & !left;
        if N::FLOOR && world.scene.floor.is_some() {
            let (met, distance) = to_floor(rays);
            open &= !(met & distance.cmplt(t_max)).bitmask();
        }
        hide(there & !(open | left), parts);
        for k in Bits(open) {
            let filters = one_mut(&mut shadows.filters, k);
            if !filters.is_empty() {
                let through = || through_lists::<_, N>(world, &rays.lane(k), lane(&t_max, k));
                *one_mut(parts, k) = filters.product().unwrap_or_else(through);
            }
        }
        left
    }

    /// Asks the vertical cylinders.
    #[inline(always)]
    fn pass_columns<N: Needs>(&self, world: &World<'_, f32>, four: &RayPacket, shadows: &mut Shadows) {
        for columns in &self.columns {
            for (slot, &i) in columns.cylinders.iter().enumerate() {
                let Some(cylinder) = world.scene.cylinders.get(index(i)) else { continue };
                for k in four.meet_column(columns, slot) {
                    let ray = world.ray::<N>(shadows.rays.origin.lane(k), shadows.rays.direction.lane(k));
                    let is_open = shadows.open >> k & 1 == 1;
                    if is_open && cylinder.intersect(&ray, lane(&shadows.t_max, k)).is_some() {
                        match transmitted::<_, N>(world, cylinder.material) {
                            Some(kt) => one_mut(&mut shadows.filters, k).add(Object::Cylinder(i), kt),
                            None => shadows.open &= !(1 << k),
                        }
                    }
                }
            }
        }
    }

    /// Asks what may hide the lamp: a bit for each ray for which there may be more.
    #[inline(always)]
    fn pass_leaves<N: Needs>(
        &self,
        world: &World<'_, f32>,
        four: &RayPacket,
        lamp: usize,
        shadows: &mut Shadows,
    ) -> u32 {
        if self.nodes.is_empty() {
            for leaf in &self.leaves {
                self.pass_leaf::<N>(world, four, (leaf, leaf.slots()), 15, shadows);
            }
            return 0;
        }
        let Some(frustum) = four.frustum() else { return shadows.open };
        let longest = four.longest();
        let Some((cells, far)) = four.lamp_cells(lamp) else {
            let mut walk = Walk::new(self, four);
            while shadows.open != 0
                && let Some(leaves) = walk.leaves(longest)
            {
                for leaf in leaves {
                    self.pass_leaf::<N>(world, four, (leaf, frustum.touch(leaf, longest)), 15, shadows);
                }
            }
            // One by one they would walk as far.
            shadows.asked = 0;
            return 0;
        };
        let (mut waiting, mut left) = (shadows.open, 0);
        while let Some((cell, group)) = next_group(&cells, &mut waiting) {
            let cell = self.light_buffers.in_cell(lamp + 1, cell);
            if let Some(&rest) = cell.entries.last()
                && rest.leaf() == Candidate::REST
                && cell.near(rest) <= far
            {
                left |= group;
                continue;
            }
            for &entry in cell.entries {
                if cell.near(entry) > far || shadows.open & group == 0 {
                    break;
                }
                let Some(leaf) = self.leaves.get(index(entry.leaf())) else { break };
                self.pass_leaf::<N>(world, four, (leaf, frustum.touch(leaf, longest)), group, shadows);
            }
        }
        left
    }

    /// Asks some items of a leaf for the rays in `group`.
    #[inline(never)]
    fn pass_leaf<N: Needs>(
        &self,
        world: &World<'_, f32>,
        four: &RayPacket,
        (leaf, slots): (&Sphere4, Bits),
        group: u32,
        shadows: &mut Shadows,
    ) {
        for slot in slots {
            let item = one(&leaf.items, slot);
            if matches!(item, Object::Lamp(_)) {
                continue;
            }
            shadows.asked += 1;
            let among = group & shadows.open;
            let hit = match item {
                Object::Sphere(_) => {
                    let (center, radius) = leaf.sphere(slot);
                    let (is_met, distance) = shadows.rays.meet_sphere(center, radius);
                    among & (is_met & distance.cmplt(shadows.t_max)).bitmask()
                }
                Object::Triangle(_) => {
                    hidden_by::<N>(world, item, (shadows.rays, shadows.t_max, four.height_margin()), among)
                }
                // Each is asked by itself.
                _ => {
                    let among = among & four.meet(leaf, slot);
                    shadows.asked += among.count_ones();
                    hidden_by::<N>(world, item, (shadows.rays, shadows.t_max, four.height_margin()), among)
                }
            };
            if hit != 0
                && let Some(look) = world.scene.look::<N>(item)
            {
                let through = transmitted::<_, N>(world, look.material);
                for k in Bits(hit) {
                    match through {
                        Some(kt) => one_mut(&mut shadows.filters, k).add(item, kt),
                        None => {
                            shadows.open &= !(1 << k);
                            shadows.occluder = Some(item);
                        }
                    }
                }
            }
        }
    }
}

/// Asks the infinite planes.
#[inline(never)] // no ray of a scene without planes prepares for it
fn pass_planes<N: Needs>(world: &World<'_, f32>, shadows: &mut Shadows) {
    for (i, plane) in (0..).zip(world.scene.planes) {
        for k in Bits(shadows.open) {
            if plane.intersect(&shadows.rays.lane(k), lane(&shadows.t_max, k)).is_some() {
                match transmitted::<_, N>(world, plane.material) {
                    Some(kt) => one_mut(&mut shadows.filters, k).add(Object::Plane(i), kt),
                    None => shadows.open &= !(1 << k),
                }
            }
        }
    }
}

/// Returns which of some rays an object is in the way of.
#[inline(always)]
fn hidden_by<N: Needs>(
    world: &World<'_, f32>,
    item: Object,
    (rays, t_max, margin): (&Ray4, Vec4, Vec4),
    among: u32,
) -> u32 {
    let met = match item {
        Object::Sphere(i) if N::SPHERES => world.scene.spheres.get(index(i)).map(|sphere| {
            let (center, radius) = (Vec3x4::splat(sphere.center), Vec4::splat(sphere.radius));
            let (is_met, distance) = rays.meet_sphere(center, radius);
            is_met & distance.cmplt(t_max)
        }),
        Object::Triangle(i) if N::TRIANGLES => {
            let triangle = world.scene.triangles.get(index(i));
            triangle.map(|triangle| rays.meet_triangle(triangle, t_max, margin).0)
        }
        _ => {
            let is_met = |&k: &usize| distance::<_, N>(world, item, &rays.lane(k), lane(&t_max, k)).is_some();
            return Bits(among).filter(is_met).fold(0, |hidden, k| hidden | 1 << k);
        }
    };
    met.map_or(0, |met| among & met.bitmask())
}

/// Four rays with their lengths, of which those that are not `there` have become copies of one that is.
#[inline(always)]
fn only(there: u32, rays: &Ray4, t_max: Vec4) -> (Ray4, Vec4) {
    let (first, mask) = (there.trailing_zeros() as usize, mask(there));
    let fill = |v: Vec3x4| Vec3x4::select(mask, v, Vec3x4::splat(v.lane(first)));
    let rays = Ray4 { origin: fill(rays.origin), direction: fill(rays.direction) };
    (rays, Vec4::select(mask, t_max, Vec4::splat(lane(&t_max, first))))
}

/// Nothing comes through along those rays.
#[inline(always)]
fn hide(hidden: u32, parts: &mut [f32; 4]) {
    for k in Bits(hidden) {
        *one_mut(parts, k) = 0.0;
    }
}
