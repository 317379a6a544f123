//! What of a lamp's light comes through to four places beside each other.

use glam::Vec4;

use super::next_group;
use crate::bvh::{Bits, Item, index};
use crate::lanes::geometry::{Ray4, to_floor};
use crate::lanes::vectors::{Vec3x4, lane, mask, one, one_mut};
use crate::lanes::{Entry, Four, Pack};
use crate::needs::Needs;
use crate::scene::shadow::{Shade, dim};
use crate::scene::{Known, Scene};

/// Four shadow rays while something may hide their lamp.
struct Shadows<'a> {
    rays: &'a Ray4,
    t_max: Vec4,
    /// A bit for each that nothing has hidden.
    open: u32,
    /// What comes through the others' objects.
    shades: [Shade<f32>; 4],
    /// What has hidden the lamp from the last one.
    occluder: Item,
    /// How many items were asked.
    asked: u32,
}

impl Scene<'_, f32> {
    /// What part of a lamp's light comes through along each of four shadow rays with their lengths, of those in
    /// `there`; see [`Scene::transmittance`](Scene::transmittance).
    #[inline(never)]
    pub(crate) fn transmittance_four<N: Needs>(
        &self,
        rays: &Ray4,
        t_max: Vec4,
        there: u32,
        lid: f32,
        lamp: usize,
        known: &mut Known,
    ) -> [f32; 4] {
        let mut parts = [1.0; 4];
        let left = if self.is_laned::<N>() && there & there.wrapping_sub(1) != 0 {
            // Others are anything.
            let (rays, t_max) = if there == 15 { (*rays, t_max) } else { only(there, rays, t_max) };
            self.through_four::<N>((&rays, t_max, there), lid, lamp, known, &mut parts)
        } else {
            there
        };
        for k in Bits(left) {
            let ray = self.ray::<N>(rays.origin.lane(k), rays.direction.lane(k));
            *one_mut(&mut parts, k) = self.transmittance_after::<N>(&ray, lane(&t_max, k), lid, lamp, known);
        }
        parts
    }

    /// The same by lanes: a bit for each ray that has to look for itself.
    #[inline(always)]
    fn through_four<N: Needs>(
        &self,
        (rays, t_max, there): (&Ray4, Vec4, u32),
        lid: f32,
        lamp: usize,
        known: &mut Known,
        parts: &mut [f32; 4],
    ) -> u32 {
        let Some(lately) = known.of(lamp) else { return there };
        if !lately.go_together() {
            return there;
        }
        let mut open = there;
        if lately.occluder != Item::NONE {
            open &= !self.hidden_by::<N>(lately.occluder, rays, t_max, there);
            hide(there & !open, parts);
            if open == 0 {
                return 0;
            }
            if open == there {
                lately.occluder = Item::NONE;
            }
        }
        let Some(four) = Four::new(&self.lanes, rays, t_max) else { return open };
        let shades = core::array::from_fn(|_| Shade::new());
        let mut shadows = Shadows { rays, t_max, open, shades, occluder: lately.occluder, asked: 0 };
        let mut behind_cylinders = 0;
        if N::CYLINDERS {
            behind_cylinders = self.pass_posts::<N>(&four, lid, &mut shadows);
        }
        let left = self.pass_packs::<N>(&four, lamp, &mut shadows);
        lately.occluder = shadows.occluder;
        lately.have_asked(shadows.asked);
        let mut open = shadows.open & !left;
        if N::FLOOR && self.floor.is_some() {
            let (met, distance) = to_floor(rays);
            open &= !(met & distance.cmplt(t_max)).bitmask();
        }
        hide(there & !(open | left), parts);
        for k in Bits(open) {
            let shade = one_mut(&mut shadows.shades, k);
            if shade.is_empty() && behind_cylinders == 0 {
                continue;
            }
            let (ray, t_max) = (rays.lane(k), lane(&t_max, k));
            let light = shade.light().unwrap_or_else(|| self.through_lists::<N>(&ray, t_max));
            *one_mut(parts, k) =
                self.through_rest::<N>(&ray, t_max, lid, light, behind_cylinders >> k & 1 == 1);
        }
        left
    }

    /// Asks the vertical cylinders: a bit for each ray that one lets something through of.
    #[inline(always)]
    fn pass_posts<N: Needs>(&self, four: &Four, lid: f32, shadows: &mut Shadows) -> u32 {
        let mut behind = 0;
        for posts in self.lanes.posts {
            for (slot, &i) in posts.cylinders.iter().enumerate() {
                let Some(cylinder) = self.cylinders.get(index(i)) else { continue };
                for k in four.meet_post(posts, slot) {
                    let (ray, t_max) = (shadows.rays.lane(k), lane(&shadows.t_max, k));
                    if shadows.open >> k & 1 == 1 && cylinder.intersect(&ray, t_max, lid).is_some() {
                        if dim::<f32, N>(&mut { 1.0 }, &cylinder.material) {
                            behind |= 1 << k;
                        } else {
                            shadows.open &= !(1 << k);
                        }
                    }
                }
            }
        }
        behind
    }

    /// Asks what may hide the lamp: a bit for each ray for which there may be more.
    #[inline(always)]
    fn pass_packs<N: Needs>(&self, four: &Four, lamp: usize, shadows: &mut Shadows) -> u32 {
        if self.lanes.nodes.is_empty() {
            for pack in self.lanes.packs {
                self.pass_pack::<N>(four, (pack, pack.slots()), 15, shadows);
            }
            return 0;
        }
        let (Some((cells, far)), Some(beam)) = (four.lamp_cells(lamp), four.beam()) else {
            return shadows.open;
        };
        let longest = four.longest();
        let (mut waiting, mut left) = (shadows.open, 0);
        while let Some((cell, group)) = next_group(&cells, &mut waiting) {
            let cell = self.lanes.in_cell(lamp + 1, cell);
            if let Some(&rest) = cell.entries.last()
                && rest.pack() == Entry::REST
                && cell.near(rest) <= far
            {
                left |= group;
                continue;
            }
            for &entry in cell.entries {
                if cell.near(entry) > far || shadows.open & group == 0 {
                    break;
                }
                let Some(pack) = self.lanes.packs.get(index(entry.pack())) else { break };
                self.pass_pack::<N>(four, (pack, beam.touch(pack, longest)), group, shadows);
            }
        }
        left
    }

    /// Asks some items of a pack for the rays in `group`.
    #[inline(never)]
    fn pass_pack<N: Needs>(
        &self,
        four: &Four,
        (pack, slots): (&Pack, Bits),
        group: u32,
        shadows: &mut Shadows,
    ) {
        for slot in slots {
            let item = one(&pack.items, slot);
            if matches!(item, Item::Lamp(_)) {
                continue;
            }
            shadows.asked += 1;
            let among = group & shadows.open;
            let hit = match item {
                Item::Sphere(_) => {
                    let (center, radius) = pack.sphere(slot);
                    let (is_met, distance) = shadows.rays.meet_sphere(center, radius);
                    among & (is_met & distance.cmplt(shadows.t_max)).bitmask()
                }
                Item::Triangle(_) => self.hidden_by::<N>(item, shadows.rays, shadows.t_max, among),
                // Each is asked by itself.
                _ => {
                    let among = among & four.meet(pack, slot);
                    shadows.asked += among.count_ones();
                    self.hidden_by::<N>(item, shadows.rays, shadows.t_max, among)
                }
            };
            if hit != 0
                && let Some(material) = self.item_material(item)
            {
                for k in Bits(hit) {
                    if !one_mut(&mut shadows.shades, k).pass::<N>(item, material) {
                        shadows.open &= !(1 << k);
                        shadows.occluder = item;
                    }
                }
            }
        }
    }

    /// Which of some rays an item is in the way of.
    #[inline(always)]
    fn hidden_by<N: Needs>(&self, item: Item, rays: &Ray4, t_max: Vec4, among: u32) -> u32 {
        let met = match item {
            Item::Sphere(i) if N::SPHERES => self.spheres.get(index(i)).map(|sphere| {
                let (center, radius) = (Vec3x4::splat(sphere.center), Vec4::splat(sphere.radius));
                let (is_met, distance) = rays.meet_sphere(center, radius);
                is_met & distance.cmplt(t_max)
            }),
            Item::Triangle(i) if N::TRIANGLES => {
                self.triangles.get(index(i)).map(|triangle| rays.meet_triangle::<false>(triangle, t_max).0)
            }
            _ => {
                let is_met =
                    |&k: &usize| self.meet_other::<N>(item, &rays.lane(k), lane(&t_max, k)).is_some();
                return Bits(among).filter(is_met).fold(0, |hidden, k| hidden | 1 << k);
            }
        };
        met.map_or(0, |met| among & met.bitmask())
    }
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
