//! What four rays beside each other meet.

use super::nearest::Best;
use super::shadow::{Shade, dim};
use super::{Hit, Known, Object, Scene};
use crate::bvh::{Bits, Item, index};
use crate::lanes::{Entry, Four, Met, Pack};
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::{Scalar, Unit};

impl<S: Scalar> Scene<'_, S> {
    /// The nearest hits of four rays, of those in `there`. `are_eyes` is whether they have just left the eye: then the others are
    /// copies, later they are rays of pixels that are done.
    #[inline(always)]
    pub(crate) fn find_four<N: Needs>(
        &self,
        rays: &[Ray<S>; 4],
        there: u32,
        are_eyes: bool,
        lid: S,
        known: &mut Known,
    ) -> [Option<Hit<S>>; 4] {
        let mut hits = [None; 4];
        let left = if self.is_laned::<N>() && (are_eyes || self.lanes.nodes.is_empty()) {
            self.nearest_four::<N>(rays, there, lid, known, &mut hits)
        } else {
            there
        };
        for r in Bits(left) {
            if let (Some(hit), Some(ray)) = (hits.get_mut(r), rays.get(r)) {
                *hit = self.find::<N>(ray, lid);
            }
        }
        hits
    }

    /// The nearest hit of each, by lanes: a bit for each ray that has to look for itself.
    #[inline(always)]
    fn nearest_four<N: Needs>(
        &self,
        rays: &[Ray<S>; 4],
        there: u32,
        lid: S,
        known: &mut Known,
        hits: &mut [Option<Hit<S>>; 4],
    ) -> u32 {
        let Some(lately) = known.of_eye() else { return there };
        if !lately.go_together() {
            return there;
        }
        let mut asked = 0;
        let floors = rays.each_ref().map(|ray| {
            if N::FLOOR { self.floor.as_ref().and_then(|floor| floor.intersect(ray)) } else { None }
        });
        let mut bests = floors.map(Best::new);
        let t_max = floors.map(|floor| floor.unwrap_or(S::FAR));
        let Some(mut four) = Four::new(&self.lanes, rays.each_ref(), t_max) else { return there };
        let mut left = 0;
        if N::CYLINDERS {
            for posts in self.lanes.posts {
                for (k, &i) in posts.cylinders.iter().enumerate() {
                    let Some(cylinder) = self.cylinders.get(index(i)) else { continue };
                    for r in four.meet_post(posts, k) {
                        if let (Some(best), Some(ray)) = (bests.get_mut(r), rays.get(r)) {
                            let distance = cylinder.intersect(ray, best.limit, lid);
                            let hit =
                                distance.map(|distance| Hit { distance, object: Object::Cylinder(index(i)) });
                            if let Some(distance) = hit.and_then(|hit| best.offer(hit)) {
                                four.shorten(r, distance);
                            }
                        }
                    }
                }
            }
        }
        if self.lanes.nodes.is_empty() {
            for pack in self.lanes.packs {
                asked += self.nearest_of_four::<N>(pack, there, rays, &mut four, &mut bests);
            }
        } else {
            let Some(cells) = four.eye_cells() else { return there };
            let mut waiting = there;
            while let Some((cell, group)) = next_group(&cells, &mut waiting) {
                let cell = self.lanes.in_cell(0, cell);
                for &entry in cell.entries {
                    if four.ends_before(cell.near(entry)) {
                        break;
                    }
                    let Some(pack) = self.lanes.packs.get(index(entry.pack())) else {
                        // There may be more.
                        left |= group;
                        break;
                    };
                    asked += self.nearest_of_four::<N>(pack, group, rays, &mut four, &mut bests);
                }
            }
        }
        lately.have_asked(asked);
        for (hit, best) in hits.iter_mut().zip(bests) {
            *hit = best.hit;
        }
        left
    }

    /// The nearest hits with a pack of the rays in `group`, and how many items were asked.
    #[inline(always)]
    fn nearest_of_four<N: Needs>(
        &self,
        pack: &Pack,
        group: u32,
        rays: &[Ray<S>; 4],
        four: &mut Four,
        bests: &mut [Best<S>; 4],
    ) -> u32 {
        let mut asked = 0;
        for k in four.touch(pack) {
            asked += 1;
            let met = four.meet::<S>(pack, k);
            for r in Bits(met.mask() & group) {
                if let (Some(best), Some(ray)) = (bests.get_mut(r), rays.get(r)) {
                    let found = self.meet_four::<N>(four, (pack, k), (&met, r), ray, best.limit);
                    if let Some(distance) = found.and_then(|found| best.offer(found)) {
                        four.shorten(r, distance);
                    }
                }
            }
        }
        asked
    }

    /// Where ray `r` of four meets item `k` of a pack nearer than `t_max`.
    #[inline(always)]
    fn meet_four<N: Needs>(
        &self,
        four: &Four,
        (pack, k): (&Pack, usize),
        (met, r): (&Met, usize),
        ray: &Ray<S>,
        t_max: S,
    ) -> Option<Hit<S>> {
        let &item = pack.items.get(k)?;
        let object = match item {
            Item::Sphere(i) if N::SPHERES => Object::Sphere(index(i)),
            Item::Lamp(i) if N::VISIBLE_LAMPS => Object::Lamp(index(i)),
            _ => return self.meet_other::<N>(item, ray, t_max),
        };
        match four.sphere((pack, k), met, r, t_max) {
            Some(distance) => Some(Hit { distance: distance?, object }),
            None => self.meet::<N>(item, ray, t_max),
        }
    }

    /// What part of a lamp's light comes through along each of four shadow rays with their lengths, of those in
    /// `there`; see [`Scene::transmittance`](Scene::transmittance).
    #[inline(never)]
    pub(crate) fn transmittance_four<N: Needs>(
        &self,
        shadows: &[Option<(Ray<S>, S)>; 4],
        there: u32,
        lid: S,
        lamp: usize,
        known: &mut Known,
    ) -> [S::Unit; 4] {
        let Some(first) = shadows.iter().flatten().next() else { return [S::Unit::ONE; 4] };
        let rays = shadows.each_ref().map(|shadow| &shadow.as_ref().unwrap_or(first).0);
        let t_max = shadows.each_ref().map(|shadow| shadow.as_ref().unwrap_or(first).1);
        let mut parts = [S::Unit::ONE; 4];
        let left = if self.is_laned::<N>() && there & there.wrapping_sub(1) != 0 {
            self.through_four::<N>((rays, t_max, there), lid, lamp, known, &mut parts)
        } else {
            there
        };
        for r in Bits(left) {
            if let (Some(part), Some(ray), Some(t_max)) = (parts.get_mut(r), rays.get(r), t_max.get(r)) {
                *part = self.transmittance_after::<N>(ray, *t_max, lid, lamp, known);
            }
        }
        parts
    }

    /// The same by lanes: a bit for each ray that has to look for itself.
    #[inline(always)]
    fn through_four<N: Needs>(
        &self,
        (rays, t_max, there): ([&Ray<S>; 4], [S; 4], u32),
        lid: S,
        lamp: usize,
        known: &mut Known,
        parts: &mut [S::Unit; 4],
    ) -> u32 {
        let mut open = there;
        let Some(lately) = known.of(lamp) else { return open };
        if !lately.go_together() {
            known.tell(false);
            return open;
        }
        let last = &mut lately.occluder;
        let mut asked = 0;
        let mut hide = |open: &mut u32, r: usize| {
            *open &= !(1 << r);
            if let Some(part) = parts.get_mut(r) {
                *part = S::Unit::ZERO;
            }
        };
        if *last != Item::NONE {
            for r in Bits(there) {
                if let (Some(ray), Some(t_max)) = (rays.get(r), t_max.get(r))
                    && self.meet::<N>(*last, ray, *t_max).is_some()
                {
                    hide(&mut open, r);
                }
            }
            if open == 0 {
                return 0;
            }
            if open == there {
                *last = Item::NONE;
            }
        }
        let Some(four) = Four::new(&self.lanes, rays, t_max) else { return open };
        let mut behind_cylinders = 0;
        if N::CYLINDERS {
            for posts in self.lanes.posts {
                for (k, &i) in posts.cylinders.iter().enumerate() {
                    let Some(cylinder) = self.cylinders.get(index(i)) else { continue };
                    for r in four.meet_post(posts, k) {
                        if open >> r & 1 == 1
                            && let (Some(ray), Some(t_max)) = (rays.get(r), t_max.get(r))
                            && cylinder.intersect(ray, *t_max, lid).is_some()
                        {
                            if dim::<S, N>(&mut { S::Unit::ONE }, &cylinder.material) {
                                behind_cylinders |= 1 << r;
                            } else {
                                hide(&mut open, r);
                            }
                        }
                    }
                }
            }
        }
        let mut shades = core::array::from_fn::<_, 4, _>(|_| Shade::<S>::new());
        let mut left = 0;
        let mut ask = |pack: &Pack, group: u32, open: &mut u32| {
            for k in four.touch(pack) {
                let Some(&item) = pack.items.get(k) else { continue };
                if matches!(item, Item::Lamp(_)) {
                    continue;
                }
                asked += 1;
                let met = four.meet::<S>(pack, k);
                for r in Bits(met.mask() & group & *open) {
                    if let (Some(ray), Some(t_max), Some(shade)) =
                        (rays.get(r), t_max.get(r), shades.get_mut(r))
                        && self.meet_four::<N>(&four, (pack, k), (&met, r), ray, *t_max).is_some()
                        && !self.item_material(item).is_none_or(|material| shade.pass::<N>(item, material))
                    {
                        hide(open, r);
                        *last = item;
                    }
                }
            }
        };
        if self.lanes.nodes.is_empty() {
            for pack in self.lanes.packs {
                ask(pack, 15, &mut open);
            }
        } else {
            let Some((cells, far)) = four.lamp_cells(lamp) else { return open };
            let mut waiting = open;
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
                    if cell.near(entry) > far || open & group == 0 {
                        break;
                    }
                    let Some(pack) = self.lanes.packs.get(index(entry.pack())) else { break };
                    ask(pack, group, &mut open);
                }
            }
        }
        let was_good = lately.have_asked(asked);
        known.tell(was_good);
        left &= open;
        for r in Bits(open & !left) {
            if let (Some(part), Some(ray), Some(t_max), Some(shade)) =
                (parts.get_mut(r), rays.get(r), t_max.get(r), shades.get_mut(r))
            {
                let light = shade.light().unwrap_or_else(|| self.through_lists::<N>(ray, *t_max));
                *part = self.through_rest::<N>(ray, *t_max, lid, light, behind_cylinders >> r & 1 == 1);
            }
        }
        left
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
