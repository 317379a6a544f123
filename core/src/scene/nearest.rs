//! What a ray meets first: by lanes, by boxes, by a hierarchy of spheres, or one after the other.

use super::{Hit, Object, Scene};
use crate::bvh::{Item, index};
use crate::hierarchy::Walk;
use crate::lanes::{LANES, Met, Pack, Probe, Search, Waiting};
use crate::material::Material;
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::shape::sphere;

/// The nearest hit so far, of objects that come in any order.
#[derive(Clone, Copy)]
pub(super) struct Best<S> {
    pub(super) hit: Option<Hit<S>>,
    /// What is as near as that hit is looked at too.
    pub(super) limit: S,
}

impl<S: Scalar> Best<S> {
    /// A ray that meets the floor at a distance, if it does.
    pub(super) fn new(floor: Option<S>) -> Self {
        let hit = floor.map(|distance| Hit { distance, object: Object::Floor });
        Self { hit, limit: floor.unwrap_or(S::FAR).next_up() }
    }

    /// Takes a hit below the limit that is nearer, or comes before it in order: its distance.
    #[inline(always)]
    pub(super) fn offer(&mut self, found: Hit<S>) -> Option<S> {
        if self.hit.is_some_and(|hit| found.distance >= hit.distance && found.object >= hit.object) {
            return None;
        }
        *self = Self { hit: Some(found), limit: found.distance.next_up() };
        Some(found.distance)
    }
}

impl<S: Scalar> Scene<'_, S> {
    /// Whether the search goes by lanes.
    pub(super) fn is_laned<N: Needs>(&self) -> bool {
        N::BOXES && LANES && !(self.lanes.packs.is_empty() && self.lanes.posts.is_empty())
    }

    /// Whether it goes by boxes: where there are some; but a hierarchy of spheres is quicker.
    pub(super) fn is_boxed<N: Needs>(&self) -> bool {
        N::BOXES && !self.boxes.nodes.is_empty() && (!N::HIERARCHY || self.hierarchy.is_empty())
    }

    /// Where a ray meets an item nearer than `t_max`.
    #[inline(always)]
    pub(super) fn meet<N: Needs>(&self, item: Item, ray: &Ray<S>, t_max: S) -> Option<Hit<S>> {
        match item {
            Item::Sphere(i) if N::SPHERES => {
                let i = index(i);
                let distance = self.spheres.get(i)?.intersect(ray, t_max)?;
                Some(Hit { distance, object: Object::Sphere(i) })
            }
            _ => self.meet_other::<N>(item, ray, t_max),
        }
    }

    /// The same for what is not a sphere.
    #[inline(never)] // so that spheres are tried at once
    pub(super) fn meet_other<N: Needs>(&self, item: Item, ray: &Ray<S>, t_max: S) -> Option<Hit<S>> {
        let (distance, object) = match item {
            Item::Ellipsoid(i) if N::ELLIPSOIDS => {
                (self.ellipsoids.get(index(i))?.intersect(ray, t_max)?, Object::Ellipsoid(index(i)))
            }
            Item::Cone(i) if N::CONES => {
                (self.cones.get(index(i))?.intersect(ray, t_max)?, Object::Cone(index(i)))
            }
            Item::Triangle(i) if N::TRIANGLES => {
                (self.triangles.get(index(i))?.intersect(ray, t_max)?, Object::Triangle(index(i)))
            }
            Item::Lamp(i) if N::VISIBLE_LAMPS && LANES => {
                let lamp = self.lamps.get(index(i))?;
                (sphere::intersect(lamp.position, lamp.radius, ray, t_max)?, Object::Lamp(index(i)))
            }
            _ => return None,
        };
        Some(Hit { distance, object })
    }

    /// Where a ray meets item `k` of a pack nearer than `t_max`.
    #[inline(always)]
    pub(super) fn meet_lane<N: Needs>(
        &self,
        probe: &Probe,
        (pack, met, k): (&Pack, &Met, usize),
        ray: &Ray<S>,
        t_max: S,
    ) -> Option<Hit<S>> {
        let &item = pack.items.get(k)?;
        let object = match item {
            Item::Sphere(i) if N::SPHERES => Object::Sphere(index(i)),
            Item::Lamp(i) if N::VISIBLE_LAMPS => Object::Lamp(index(i)),
            _ => return self.meet_other::<N>(item, ray, t_max),
        };
        match probe.sphere(pack, met, k, t_max) {
            Some(distance) => Some(Hit { distance: distance?, object }),
            None => self.meet::<N>(item, ray, t_max),
        }
    }

    /// The material of an item; a lamp has none.
    #[inline(never)] // so that a ray which meets nothing does not prepare for it
    pub(super) fn item_material(&self, item: Item) -> Option<&Material<S>> {
        self.material(match item {
            Item::Sphere(i) => Object::Sphere(index(i)),
            Item::Ellipsoid(i) => Object::Ellipsoid(index(i)),
            Item::Cone(i) => Object::Cone(index(i)),
            Item::Triangle(i) => Object::Triangle(index(i)),
            Item::Lamp(i) => Object::Lamp(index(i)),
        })
    }

    /// The material of what was hit; a lamp has none, and the floor is opaque.
    fn material(&self, object: Object) -> Option<&Material<S>> {
        match object {
            Object::Floor => Some(&Material::Opaque),
            Object::Cylinder(i) => self.cylinders.get(i).map(|c| &c.material),
            Object::Ellipsoid(i) => self.ellipsoids.get(i).map(|e| &e.material),
            Object::Sphere(i) => self.spheres.get(i).map(|s| &s.material),
            Object::Cone(i) => self.cones.get(i).map(|c| &c.material),
            Object::Triangle(i) => self.triangles.get(i).map(|t| &t.material),
            Object::Lamp(_) => None,
        }
    }

    /// The nearest hit of a ray, if it meets anything; cylinders end at the height `lid`.
    pub fn nearest<N: Needs>(&self, ray: &Ray<S>, lid: S) -> Option<Hit<S>> {
        self.find::<N>(ray, lid)
    }

    /// The same for the tracer, which asks in one place.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    pub(super) fn find<N: Needs>(&self, ray: &Ray<S>, lid: S) -> Option<Hit<S>> {
        let floor = if N::FLOOR { self.floor.as_ref().and_then(|floor| floor.intersect(ray)) } else { None };
        if self.is_laned::<N>() {
            self.nearest_laned::<N>(ray, floor, lid)
        } else {
            self.nearest_listed::<N>(ray, floor, lid)
        }
    }

    /// The nearest hit by boxes or one after the other, where a ray meets the floor at the distance `floor`.
    #[cfg_attr(not(target_os = "none"), inline(never))] // so that a ray through lanes does not prepare for it
    fn nearest_listed<N: Needs>(&self, ray: &Ray<S>, floor: Option<S>, lid: S) -> Option<Hit<S>> {
        let mut hit = floor.map(|distance| Hit { distance, object: Object::Floor });
        let mut t_max = floor.unwrap_or(S::FAR);
        let mut found = |distance: Option<S>, object: Object, t_max: &mut S| {
            if let Some(distance) = distance {
                *t_max = distance;
                hit = Some(Hit { distance, object });
            }
        };
        if N::CYLINDERS {
            for (i, cylinder) in self.cylinders.iter().enumerate() {
                found(cylinder.intersect(ray, t_max, lid), Object::Cylinder(i), &mut t_max);
            }
        }
        if self.is_boxed::<N>() {
            let mut best = Best { hit, limit: t_max.next_up() };
            self.boxes.nearest(ray, &mut t_max, |item| best.offer(self.meet::<N>(item, ray, best.limit)?));
            return self.nearest_lamp::<N>(ray, t_max).or(best.hit);
        }
        if N::ELLIPSOIDS {
            for (i, ellipsoid) in self.ellipsoids.iter().enumerate() {
                found(ellipsoid.intersect(ray, t_max), Object::Ellipsoid(i), &mut t_max);
            }
        }
        if N::SPHERES {
            let mut walk = Walk::<S, N>::new(self.hierarchy, self.spheres);
            while let Some((i, sphere)) = walk.next(ray, t_max) {
                found(sphere.intersect(ray, t_max), Object::Sphere(i), &mut t_max);
            }
        }
        if N::CONES {
            for (i, cone) in self.cones.iter().enumerate() {
                found(cone.intersect(ray, t_max), Object::Cone(i), &mut t_max);
            }
        }
        if N::TRIANGLES {
            for (i, triangle) in self.triangles.iter().enumerate() {
                found(triangle.intersect(ray, t_max), Object::Triangle(i), &mut t_max);
            }
        }
        self.nearest_lamp::<N>(ray, t_max).or(hit)
    }

    /// The nearest hit with what lanes hold, where a ray meets the floor at the distance `floor`.
    #[inline(always)]
    fn nearest_laned<N: Needs>(&self, ray: &Ray<S>, floor: Option<S>, lid: S) -> Option<Hit<S>> {
        let t_max = floor.unwrap_or(S::FAR);
        let mut best = Best::new(floor);
        let mut probe = Probe::new(&self.lanes, ray, t_max);
        if N::CYLINDERS {
            for posts in self.lanes.posts {
                for k in probe.meet_posts(posts) {
                    let i = posts.cylinders.get(k).map_or(usize::MAX, |&i| index(i));
                    let distance = self.cylinders.get(i).and_then(|c| c.intersect(ray, best.limit, lid));
                    let hit = distance.map(|distance| Hit { distance, object: Object::Cylinder(i) });
                    if let Some(distance) = hit.and_then(|hit| best.offer(hit)) {
                        probe.shorten(distance);
                    }
                }
            }
        }
        if self.lanes.nodes.is_empty() {
            self.nearest_of::<N>(self.lanes.packs, ray, &mut probe, &mut best);
        } else if !self.nearest_seen::<N>(ray, &mut probe, &mut best) {
            let mut waiting = Waiting::new();
            let mut search = Search::new(probe, &mut waiting);
            while let Some(packs) = search.leaf() {
                self.nearest_of::<N>(packs, ray, &mut search.probe, &mut best);
            }
        }
        best.hit
    }

    /// The nearest hit with what is seen from the eye in a ray's direction; false if the ray does not start there, or if there
    /// may be more.
    #[inline(always)]
    fn nearest_seen<N: Needs>(&self, ray: &Ray<S>, probe: &mut Probe, best: &mut Best<S>) -> bool {
        let Some(seen) = self.lanes.eye_sees(&probe.ray) else { return false };
        for &entry in seen.entries {
            if probe.ends_before(seen.near(entry)) {
                return true;
            }
            // The rest is none of them.
            let Some(pack) = self.lanes.packs.get(index(entry.pack())) else { return false };
            self.nearest_of::<N>(core::slice::from_ref(pack), ray, probe, best);
        }
        true
    }

    /// The nearest hit with some packs.
    #[inline(always)]
    fn nearest_of<N: Needs>(&self, packs: &[Pack], ray: &Ray<S>, probe: &mut Probe, best: &mut Best<S>) {
        for pack in packs {
            let met = probe.meet::<S>(pack);
            for k in met.items() {
                let found = self.meet_lane::<N>(probe, (pack, &met, k), ray, best.limit);
                if let Some(distance) = found.and_then(|found| best.offer(found)) {
                    probe.shorten(distance);
                }
            }
        }
    }

    /// The nearest lamp that a ray meets before `t_max`.
    fn nearest_lamp<N: Needs>(&self, ray: &Ray<S>, mut t_max: S) -> Option<Hit<S>> {
        let mut hit = None;
        if N::VISIBLE_LAMPS {
            for (i, lamp) in self.lamps.iter().enumerate() {
                if lamp.radius > S::ZERO
                    && let Some(distance) = sphere::intersect(lamp.position, lamp.radius, ray, t_max)
                {
                    t_max = distance;
                    hit = Some(Hit { distance, object: Object::Lamp(i) });
                }
            }
        }
        hit
    }
}
