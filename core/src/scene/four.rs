//! What four rays beside each other meet.

mod shadow;
mod spots;

use glam::{BVec4A, Vec4};

use super::{Hit, Known, Object, Scene};
use crate::bvh::{Bits, Item, index};
use crate::lanes::geometry::{Ray4, to_floor};
use crate::lanes::vectors::{lane, mask, one, one_mut, set};
use crate::lanes::{Four, Pack};
use crate::needs::Needs;
use crate::scalar::Scalar;
pub(crate) use spots::Spots;

/// What four rays meet first.
pub(crate) struct Nearest {
    /// How far away; of a ray that meets nothing, [`Scalar::FAR`], and of one that is not there, 0.
    distance: Vec4,
    objects: [Option<Object>; 4],
}

impl Nearest {
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

impl Scene<'_, f32> {
    /// The nearest hits of four rays, of those in `there`. `are_eyes` is whether they have just left the eye: then the others are
    /// copies, later they are rays of pixels that are done.
    #[inline(always)]
    pub(crate) fn find_four<N: Needs>(
        &self,
        rays: &Ray4,
        there: u32,
        are_eyes: bool,
        lid: f32,
        known: &mut Known,
    ) -> Nearest {
        let far = Vec4::select(mask(there), Vec4::splat(f32::FAR), Vec4::ZERO);
        let mut nearest = Nearest { distance: far, objects: [None; 4] };
        if N::FLOOR && self.floor.is_some() {
            let (met, distance) = to_floor(rays);
            nearest.offer(met & distance.cmple(nearest.distance), distance, Object::Floor);
        }
        let left = if self.is_laned::<N>() && (are_eyes || self.lanes.nodes.is_empty()) {
            self.nearest_four::<N>(rays, there, lid, known, &mut nearest)
        } else {
            there
        };
        for k in Bits(left) {
            let ray = self.ray::<N>(rays.origin.lane(k), rays.direction.lane(k));
            if let Some(hit) = self.find::<N>(&ray, lid) {
                nearest.offer_one(k, hit);
            }
        }
        nearest
    }

    /// The nearest hit of each, by lanes: a bit for each ray that has to look for itself.
    #[inline(always)]
    fn nearest_four<N: Needs>(
        &self,
        rays: &Ray4,
        there: u32,
        lid: f32,
        known: &mut Known,
        nearest: &mut Nearest,
    ) -> u32 {
        let Some(lately) = known.of_eye() else { return there };
        if !lately.go_together() {
            return there;
        }
        let Some(mut four) = Four::new(&self.lanes, rays, nearest.distance) else {
            return there;
        };
        let mut asked = 0;
        let mut left = 0;
        if N::CYLINDERS {
            for posts in self.lanes.posts {
                for (k, &i) in posts.cylinders.iter().enumerate() {
                    let Some(cylinder) = self.cylinders.get(index(i)) else { continue };
                    for r in four.meet_post(posts, k) {
                        let distance = cylinder.intersect(&rays.lane(r), nearest.limit(r), lid);
                        if let Some(distance) = distance {
                            nearest.offer_one(r, Hit { distance, object: Object::Cylinder(index(i)) });
                            four.shorten(nearest.distance);
                        }
                    }
                }
            }
        }
        if self.lanes.nodes.is_empty() {
            for pack in self.lanes.packs {
                asked += self.nearest_of_four::<N>((pack, pack.slots()), 15, rays, &mut four, nearest);
            }
        } else {
            let (Some(cells), Some(beam)) = (four.eye_cells(), four.beam()) else { return there };
            let mut waiting = there;
            while let Some((cell, group)) = next_group(&cells, &mut waiting) {
                let cell = self.lanes.in_cell(0, cell);
                for &entry in cell.entries {
                    let longest = four.longest();
                    if cell.near(entry) > longest {
                        break;
                    }
                    let Some(pack) = self.lanes.packs.get(index(entry.pack())) else {
                        // There may be more.
                        left |= group;
                        break;
                    };
                    let slots = beam.touch(pack, longest);
                    asked += self.nearest_of_four::<N>((pack, slots), group, rays, &mut four, nearest);
                }
            }
        }
        lately.have_asked(asked);
        left
    }

    /// The nearest hits with some items of a pack of the rays in `group`, and how many items that were.
    #[inline(always)]
    fn nearest_of_four<N: Needs>(
        &self,
        (pack, slots): (&Pack, Bits),
        group: u32,
        rays: &Ray4,
        four: &mut Four,
        nearest: &mut Nearest,
    ) -> u32 {
        let mut asked = 0;
        for k in slots {
            asked += 1;
            let item = one(&pack.items, k);
            let sphere = || {
                let (center, radius) = pack.sphere(k);
                let (is_met, distance) = rays.meet_sphere(center, radius);
                (is_met & distance.cmple(nearest.distance), distance)
            };
            let (object, (is_met, distance)) = match item {
                Item::Sphere(i) if N::SPHERES => (Object::Sphere(index(i)), sphere()),
                Item::Lamp(i) if N::VISIBLE_LAMPS => (Object::Lamp(index(i)), sphere()),
                Item::Triangle(i) if N::TRIANGLES => {
                    let Some(triangle) = self.triangles.get(index(i)) else { continue };
                    (Object::Triangle(index(i)), rays.meet_triangle::<true>(triangle, nearest.distance))
                }
                _ => {
                    for r in Bits(four.meet(pack, k) & group) {
                        if let Some(hit) = self.meet_other::<N>(item, &rays.lane(r), nearest.limit(r)) {
                            nearest.offer_one(r, hit);
                            four.shorten(nearest.distance);
                        }
                    }
                    continue;
                }
            };
            let is_met = if group == 15 { is_met } else { is_met & mask(group) };
            if is_met.any() {
                nearest.offer(is_met, distance, object);
                four.shorten(nearest.distance);
            }
        }
        asked
    }
}

/// The cell of the next of the rays in `waiting`, and which of them look through it.
#[inline(always)]
fn next_group(cells: &[usize; 4], waiting: &mut u32) -> Option<(usize, u32)> {
    let first = *cells.get(Bits(*waiting).next()?)?;
    let mut group = 0;
    for (k, &cell) in cells.iter().enumerate() {
        group |= u32::from(cell == first) << k;
    }
    group &= *waiting;
    *waiting &= !group;
    Some((first, group))
}
