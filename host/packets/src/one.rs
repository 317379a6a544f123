//! One ray: the packets as an accelerator for every number format.

mod shadow;

use core::ops::ControlFlow;

use rta_core::accelerator::{self, Accelerator, Closest, Lists, transmitted};
use rta_core::needs::Needs;
use rta_core::ray::Ray;
use rta_core::scalar::Unit;
use rta_core::scene::{Hit, Object, Scene, Visit};
use rta_core::shape::{Primitive, Sphere};
use rta_core::world::World;

use crate::cache::ShadowCache;
use crate::leaf::{Sphere4, index};
use crate::number::ToF32;
use crate::packets::Packets;
use crate::query::{Query, Traversal, TraversalStack};
use crate::rays::Mask;

/// The number of transparent objects on the way of a shadow ray from which on all objects are gone through in the order of their
/// lists.
pub(crate) const MOST_FILTERS: usize = 32;

/// The transparent objects on the way of a shadow ray.
pub(crate) type Filters<S> = accelerator::Filters<S, MOST_FILTERS>;

impl<S: ToF32> Accelerator<S> for &Packets {
    type Memory = ShadowCache;
    const IN_ORDER: bool = false;
    // Few rays come near a cylinder.
    const WITH_PLAN: bool = false;

    /// All objects, as they come: the search itself overrides what asks for candidates.
    fn candidates<N: Needs>(
        &self,
        scene: &Scene<'_, S>,
        _ray: &Ray<S>,
        visit: &mut impl Visit<S>,
    ) -> ControlFlow<()> {
        scene.each::<N>(visit)
    }

    fn check(&self, _scene: &Scene<'_, S>) -> Result<(), rta_core::Error> {
        Ok(())
    }

    #[inline(always)]
    fn closest<N: Needs>(
        &self,
        world: &World<'_, S>,
        ray: &Ray<S>,
        _cache: &mut ShadowCache,
    ) -> Option<Hit<S>> {
        if self.is_too_large {
            return closest_of_lists::<S, N>(world, ray);
        }
        if has_flat::<S, N>(world) {
            closest_with_flat::<S, N>(self, world, ray)
        } else {
            search::<S, N, 0>(self, world, ray)
        }
    }

    #[inline]
    fn transmittance<N: Needs>(
        &self,
        world: &World<'_, S>,
        ray: &Ray<S>,
        t_max: S,
        lamp: usize,
        cache: &mut ShadowCache,
    ) -> S::Unit {
        if self.is_too_large {
            return through_lists::<S, N>(world, ray, t_max);
        }
        // Not returned by what fills it, as it would be copied whole; and made only where something is transparent.
        let mut filters = None;
        let is_open = shadow::is_open::<S, N>(self, world, ray, t_max, (lamp, cache), &mut filters);
        if !is_open || world.floor::<N>(ray).is_some_and(|t| t < t_max) {
            return S::Unit::ZERO;
        }
        let Some(filters) = filters else { return S::Unit::ONE };
        filters.product().unwrap_or_else(|| through_lists::<S, N>(world, ray, t_max))
    }
}

/// Returns whether flat objects may lie at one place, for which [`Closest`] keeps others; the floor alone is none of them.
#[inline]
pub(crate) fn has_flat<S: ToF32, N: Needs>(world: &World<'_, S>) -> bool {
    N::TRIANGLES && !world.scene.triangles.is_empty() || N::PLANES && !world.scene.planes.is_empty()
}

/// Returns the nearest hit where flat objects may lie at one place.
#[inline(never)] // so that the way of the other scenes is short
fn closest_with_flat<S: ToF32, N: Needs>(
    packets: &Packets,
    world: &World<'_, S>,
    ray: &Ray<S>,
) -> Option<Hit<S>> {
    search::<S, N, 3>(packets, world, ray)
}

#[inline(always)]
fn search<S: ToF32, N: Needs, const OTHERS: usize>(
    packets: &Packets,
    world: &World<'_, S>,
    ray: &Ray<S>,
) -> Option<Hit<S>> {
    let mut closest = Closest::<S, OTHERS>::new();
    if let Some(distance) = world.floor::<N>(ray) {
        closest.offer(Hit { distance, object: Object::Floor });
    }
    let mut query = Query::new(packets, ray, closest.limit());
    if N::CYLINDERS {
        for columns in &packets.columns {
            for k in query.meet_columns(columns) {
                let Some(&i) = columns.cylinders.get(k) else { continue };
                if let Some((distance, _)) = cylinder::<S, N>(world, i, ray, closest.limit()) {
                    closest.offer(Hit { distance, object: Object::Cylinder(i) });
                    query.shorten(closest.limit());
                }
            }
        }
    }
    if N::PLANES {
        for (i, plane) in (0..).zip(world.scene.planes) {
            if let Some(distance) = plane.intersect(ray, closest.limit()) {
                closest.offer(Hit { distance, object: Object::Plane(i) });
                query.shorten(closest.limit());
            }
        }
    }
    if packets.nodes.is_empty() {
        closest_of::<S, N, _>(world, &packets.leaves, ray, &mut query, &mut closest);
    } else if !closest_seen::<S, N, _>(packets, world, ray, &mut query, &mut closest) {
        let mut stack = TraversalStack::new();
        let mut traversal = Traversal::of_all(query, &mut stack);
        while let Some(leaves) = traversal.leaf() {
            closest_of::<S, N, _>(world, leaves, ray, &mut traversal.query, &mut closest);
        }
    }
    closest.seen(&world.scene, ray)
}

/// Returns the nearest hit, one object after the other.
#[inline(never)] // no ray that is searched for prepares for it
fn closest_of_lists<S: ToF32, N: Needs>(world: &World<'_, S>, ray: &Ray<S>) -> Option<Hit<S>> {
    let ray = world.ray::<N>(ray.origin, ray.direction);
    Lists.closest::<N>(world, &ray, &mut ())
}

/// Returns what part of a lamp's light comes through, one object after the other.
#[inline(never)] // no ray that is searched for prepares for it
pub(crate) fn through_lists<S: ToF32, N: Needs>(world: &World<'_, S>, ray: &Ray<S>, t_max: S) -> S::Unit {
    let ray = world.ray::<N>(ray.origin, ray.direction);
    Lists.transmittance::<N>(world, &ray, t_max, 0, &mut ())
}

/// Returns the distance of a cylinder that is hit nearer than `t_max`, and the part of a shadow ray's light it lets through, if
/// any.
#[inline]
fn cylinder<S: ToF32, N: Needs>(
    world: &World<'_, S>,
    i: u32,
    ray: &Ray<S>,
    t_max: S,
) -> Option<(S, Option<S::Unit>)> {
    let cylinder = world.scene.cylinders.get(index(i))?;
    let distance = cylinder.intersect(&world.ray::<N>(ray.origin, ray.direction), t_max)?;
    Some((distance, transmitted::<S, N>(world, cylinder.material)))
}

/// Returns the distance of an object that is hit nearer than `t_max`.
#[inline(never)] // so that spheres are tried at once
pub(crate) fn distance<S: ToF32, N: Needs>(
    world: &World<'_, S>,
    object: Object,
    ray: &Ray<S>,
    t_max: S,
) -> Option<S> {
    if let Object::Lamp(i) = object {
        let lamp = world.scene.lamps.get(index(i))?;
        return Sphere::distance(lamp.position, lamp.radius, ray, t_max);
    }
    let mut visit = Distance { ray, t_max, found: None };
    let _ = world.scene.one::<N>(object, &mut visit);
    visit.found
}

/// Finds the distance of the object that it is shown.
struct Distance<'r, S: ToF32> {
    ray: &'r Ray<S>,
    t_max: S,
    found: Option<S>,
}

impl<S: ToF32> Visit<S> for Distance<'_, S> {
    #[inline]
    fn run<P: Primitive<S>>(&mut self, _first: Object, run: &[P]) -> ControlFlow<()> {
        self.found = run.first().and_then(|object| object.intersect(self.ray, self.t_max));
        ControlFlow::Continue(())
    }
}

/// Finds the nearest hit among what is seen from the eye in a ray's direction; false if the ray does not start there, or if
/// there may be more.
#[inline(always)]
fn closest_seen<S: ToF32, N: Needs, const OTHERS: usize>(
    packets: &Packets,
    world: &World<'_, S>,
    ray: &Ray<S>,
    query: &mut Query,
    closest: &mut Closest<S, OTHERS>,
) -> bool {
    let Some(seen) = packets.light_buffers.eye_sees(&query.ray) else { return false };
    for &candidate in seen.entries {
        if query.ends_before(seen.near(candidate)) {
            return true;
        }
        // The rest is none of the leaves.
        let Some(leaf) = packets.leaves.get(index(candidate.leaf())) else { return false };
        closest_of::<S, N, _>(world, core::slice::from_ref(leaf), ray, query, closest);
    }
    true
}

/// Finds the nearest hit in some leaves.
#[inline(always)]
fn closest_of<S: ToF32, N: Needs, const OTHERS: usize>(
    world: &World<'_, S>,
    leaves: &[Sphere4],
    ray: &Ray<S>,
    query: &mut Query,
    closest: &mut Closest<S, OTHERS>,
) {
    for leaf in leaves {
        let mask = query.meet::<S>(leaf);
        for k in mask.items() {
            if let Some(hit) = meet::<S, N>(world, query, (leaf, &mask, k), ray, closest.limit()) {
                closest.offer(hit);
                query.shorten(closest.limit());
            }
        }
    }
}

/// Returns where a ray meets item `k` of a leaf nearer than `t_max`.
#[inline(always)]
fn meet<S: ToF32, N: Needs>(
    world: &World<'_, S>,
    query: &Query,
    (leaf, mask, k): (&Sphere4, &Mask, usize),
    ray: &Ray<S>,
    t_max: S,
) -> Option<Hit<S>> {
    let &object = leaf.items.get(k)?;
    if matches!(object, Object::Sphere(_) if N::SPHERES)
        || matches!(object, Object::Lamp(_) if N::VISIBLE_LAMPS)
    {
        if let Some(distance) = query.sphere(leaf, mask, k, t_max) {
            return Some(Hit { distance: distance?, object });
        }
        if let Object::Sphere(i) = object {
            let distance = world.scene.spheres.get(index(i))?.intersect(ray, t_max)?;
            return Some(Hit { distance, object });
        }
    }
    if let Object::Triangle(_) = object
        && N::TRIANGLES
        && let Some(distance) = query.triangle(mask, k, t_max)
    {
        return Some(Hit { distance: distance?, object });
    }
    Some(Hit { distance: distance::<S, N>(world, object, ray, t_max)?, object })
}
