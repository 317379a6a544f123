//! What of a lamp's light comes through to a surface.

use heapless::Vec;

use super::{Known, Scene};
use crate::bvh::{Item, index};
use crate::hierarchy::Walk;
use crate::lanes::{LANES, Pack, Probe, Search, Waiting};
use crate::material::Material;
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::{Scalar, Unit};

/// If so many objects are on the way of a shadow ray, they are gone through in the order of their lists.
const MANY: usize = if LANES { 32 } else { 8 };

/// What comes through objects that are met in any order, in the order of their lists: it is multiplied in that order, as
/// rounded products depend on it.
pub(super) struct Shade<S: Scalar>(Vec<(Item, S::Unit), MANY>);

impl<S: Scalar> Shade<S> {
    /// Nothing yet.
    pub(super) const fn new() -> Self {
        Self(Vec::new())
    }

    /// Takes the part of the light that an object lets through: false if that is none of it.
    #[inline(never)] // so that a ray which meets nothing does not prepare for it
    pub(super) fn pass<N: Needs>(&mut self, item: Item, material: &Material<S>) -> bool {
        match material.glass::<N>() {
            Some(glass) if N::TRANSPARENT_SHADOWS => {
                // When it is full, what is in it does not matter any more.
                let _ = self.0.push((item, glass.kt));
                let mut rest = self.0.as_mut_slice();
                while let [.., before, last] = rest
                    && last.0 < before.0
                {
                    core::mem::swap(before, last);
                    let end = rest.len() - 1;
                    rest = rest.get_mut(..end).unwrap_or_default();
                }
                true
            }
            _ => false,
        }
    }

    /// Whether nothing was on the way.
    #[inline(always)]
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// What comes through all of them; nothing if they were too many.
    #[inline(always)]
    pub(super) fn light(&mut self) -> Option<S::Unit> {
        if self.0.is_empty() { Some(S::Unit::ONE) } else { self.product() }
    }

    #[inline(never)]
    fn product(&mut self) -> Option<S::Unit> {
        let light = self.0.iter().fold(S::Unit::ONE, |light, (_, kt)| light.times(*kt));
        (!self.0.is_full()).then_some(light)
    }
}

impl<S: Scalar> Scene<'_, S> {
    /// What part of a lamp's light comes through from `t_max` along a shadow ray: 0 behind anything that is not
    /// transparent, else the product of kt over the transparent objects on the way, once for each. Cylinders end at the
    /// height `lid`.
    pub fn transmittance<N: Needs>(&self, ray: &Ray<S>, t_max: S, lid: S) -> S::Unit {
        self.transmittance_after::<N>(ray, t_max, lid, 0, &mut Known::new())
    }

    /// The same of a lamp by its number, where `known` is what is known of other points.
    pub(crate) fn transmittance_after<N: Needs>(
        &self,
        ray: &Ray<S>,
        t_max: S,
        lid: S,
        lamp: usize,
        known: &mut Known,
    ) -> S::Unit {
        let zero = S::Unit::ZERO;
        let light;
        let mut has_cylinders = N::CYLINDERS;
        if self.is_laned::<N>() {
            let Some(through) = self.through_lanes::<N>(ray, t_max, lid, lamp, known) else {
                return zero;
            };
            (light, has_cylinders) = through;
        } else if self.is_boxed::<N>() {
            let mut shade = Shade::new();
            let is_open = self.boxes.all(ray, t_max, |item| {
                self.meet::<N>(item, ray, t_max).is_none()
                    || self.item_material(item).is_none_or(|material| shade.pass::<N>(item, material))
            });
            if !is_open {
                return zero;
            }
            light = shade.light().unwrap_or_else(|| self.through_lists::<N>(ray, t_max));
        } else {
            light = self.through_lists::<N>(ray, t_max);
        }
        self.through_rest::<N>(ray, t_max, lid, light, has_cylinders)
    }

    /// What of `light` comes through cylinders, if there are some on the way, and through the floor.
    #[inline(always)]
    pub(super) fn through_rest<N: Needs>(
        &self,
        ray: &Ray<S>,
        t_max: S,
        lid: S,
        mut light: S::Unit,
        has_cylinders: bool,
    ) -> S::Unit {
        let zero = S::Unit::ZERO;
        if light == zero {
            return zero;
        }
        if has_cylinders {
            for cylinder in self.cylinders {
                if cylinder.intersect(ray, t_max, lid).is_some()
                    && !dim::<S, N>(&mut light, &cylinder.material)
                {
                    return zero;
                }
            }
        }
        if N::FLOOR
            && let Some(floor) = &self.floor
            && floor.intersect(ray).is_some_and(|t| t < t_max)
        {
            return zero;
        }
        light
    }

    /// What comes through all finite objects, and whether there are cylinders on the way that let something through; nothing
    /// behind anything that does not, which becomes the `last` occluder.
    #[inline(always)]
    fn through_lanes<N: Needs>(
        &self,
        ray: &Ray<S>,
        t_max: S,
        lid: S,
        lamp: usize,
        known: &mut Known,
    ) -> Option<(S::Unit, bool)> {
        let last = &mut known.of(lamp)?.occluder;
        if *last != Item::NONE {
            if self.meet::<N>(*last, ray, t_max).is_some() {
                return None;
            }
            *last = Item::NONE;
        }
        let probe = Probe::new(&self.lanes, ray, t_max);
        let mut has_cylinders = false;
        if N::CYLINDERS {
            for posts in self.lanes.posts {
                for k in probe.meet_posts(posts) {
                    let cylinder = posts.cylinders.get(k).and_then(|&i| self.cylinders.get(index(i)));
                    if let Some(cylinder) = cylinder
                        && cylinder.intersect(ray, t_max, lid).is_some()
                    {
                        if !dim::<S, N>(&mut { S::Unit::ONE }, &cylinder.material) {
                            return None;
                        }
                        has_cylinders = true;
                    }
                }
            }
        }
        let mut shade = Shade::new();
        let mut found = Item::NONE;
        if self.lanes.nodes.is_empty() {
            found = self.first_opaque_of::<N>(self.lanes.packs, ray, t_max, &probe, &mut shade);
        } else if let Some((seen, far)) = self.lanes.lamp_sees(&probe.ray, probe.t_max, lamp) {
            for &entry in seen.entries {
                if seen.near(entry) > far {
                    break;
                }
                let Some(pack) = self.lanes.packs.get(index(entry.pack())) else { break };
                let packs = core::slice::from_ref(pack);
                found = self.first_opaque_of::<N>(packs, ray, t_max, &probe, &mut shade);
                if found != Item::NONE {
                    break;
                }
            }
        } else {
            let mut waiting = Waiting::new();
            let mut search = Search::new(probe, &mut waiting);
            while found == Item::NONE
                && let Some(packs) = search.leaf()
            {
                found = self.first_opaque_of::<N>(packs, ray, t_max, &search.probe, &mut shade);
            }
        }
        if found != Item::NONE {
            *last = found;
            return None;
        }
        let light = shade.light().unwrap_or_else(|| self.through_lists::<N>(ray, t_max));
        Some((light, has_cylinders))
    }

    /// The first object of some packs that lets nothing through, or none; and what the others let through.
    #[inline(always)]
    fn first_opaque_of<N: Needs>(
        &self,
        packs: &[Pack],
        ray: &Ray<S>,
        t_max: S,
        probe: &Probe,
        shade: &mut Shade<S>,
    ) -> Item {
        for pack in packs {
            let met = probe.meet::<S>(pack);
            for k in met.items() {
                if let Some(&item) = pack.items.get(k)
                    && !matches!(item, Item::Lamp(_))
                    && self.meet_lane::<N>(probe, (pack, &met, k), ray, t_max).is_some()
                    && !self.item_material(item).is_none_or(|material| shade.pass::<N>(item, material))
                {
                    return item;
                }
            }
        }
        Item::NONE
    }

    /// What comes through all finite objects, one after the other.
    pub(super) fn through_lists<N: Needs>(&self, ray: &Ray<S>, t_max: S) -> S::Unit {
        let mut light = S::Unit::ONE;
        if N::SPHERES {
            let mut walk = Walk::<S, N>::new(self.hierarchy, self.spheres);
            while let Some((_, sphere)) = walk.next(ray, t_max) {
                if sphere.intersect(ray, t_max).is_some() && !dim::<S, N>(&mut light, &sphere.material) {
                    return light;
                }
            }
        }
        if N::ELLIPSOIDS {
            for ellipsoid in self.ellipsoids {
                if ellipsoid.intersect(ray, t_max).is_some() && !dim::<S, N>(&mut light, &ellipsoid.material)
                {
                    return light;
                }
            }
        }
        if N::CONES {
            for cone in self.cones {
                if cone.intersect(ray, t_max).is_some() && !dim::<S, N>(&mut light, &cone.material) {
                    return light;
                }
            }
        }
        if N::TRIANGLES {
            for triangle in self.triangles {
                if triangle.intersect(ray, t_max).is_some() && !dim::<S, N>(&mut light, &triangle.material) {
                    return light;
                }
            }
        }
        light
    }
}

/// Dims light by what a material lets through of it: false if nothing is left, and no need to look further.
pub(super) fn dim<S: Scalar, N: Needs>(light: &mut S::Unit, material: &Material<S>) -> bool {
    *light = match material.glass::<N>() {
        Some(glass) if N::TRANSPARENT_SHADOWS => light.times(glass.kt),
        _ => S::Unit::ZERO,
    };
    *light > S::Unit::ZERO
}
