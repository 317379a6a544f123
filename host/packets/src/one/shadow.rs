//! What is on the way of one shadow ray.

use rta_core::accelerator::transmitted;
use rta_core::needs::Needs;
use rta_core::ray::Ray;
use rta_core::scene::Object;
use rta_core::shape::Primitive;
use rta_core::world::World;

use super::{Filters, cylinder, distance, meet};
use crate::cache::ShadowCache;
use crate::leaf::{Sphere4, index};
use crate::number::ToF32;
use crate::packets::Packets;
use crate::query::{Query, Traversal, TraversalStack};

/// Returns whether no opaque object is on the way of a shadow ray, and adds the transparent ones; the first opaque one becomes
/// the lamp's last occluder.
#[inline(always)]
pub(super) fn is_open<S: ToF32, N: Needs>(
    packets: &Packets,
    world: &World<'_, S>,
    ray: &Ray<S>,
    t_max: S,
    (lamp, cache): (usize, &mut ShadowCache),
    filters: &mut Option<Filters<S>>,
) -> bool {
    let last = &mut cache.of_lamp(lamp).occluder;
    if let Some(occluder) = *last {
        let is_hidden = match occluder {
            Object::Sphere(i) if N::SPHERES => {
                world.scene.spheres.get(index(i)).and_then(|sphere| sphere.intersect(ray, t_max)).is_some()
            }
            _ => distance::<S, N>(world, occluder, ray, t_max).is_some(),
        };
        if is_hidden {
            return false;
        }
        *last = None;
    }
    let query = Query::new(packets, ray, t_max);
    if N::CYLINDERS {
        for columns in &packets.columns {
            for k in query.meet_columns(columns) {
                let Some(&i) = columns.cylinders.get(k) else { continue };
                match cylinder::<S, N>(world, i, ray, t_max) {
                    Some((_, Some(kt))) => added(filters).add(Object::Cylinder(i), kt),
                    Some((_, None)) => return false,
                    None => {}
                }
            }
        }
    }
    if N::PLANES && !world.scene.planes.is_empty() && !planes_are_open::<S, N>(world, ray, t_max, filters) {
        return false;
    }
    let mut found = None;
    if packets.nodes.is_empty() {
        found = opaque_of::<S, N>(world, &packets.leaves, (ray, t_max, &query), filters);
    } else if let Some((seen, far)) = packets.light_buffers.lamp_sees(&query.ray, query.t_max, lamp) {
        for &candidate in seen.entries {
            if seen.near(candidate) > far {
                break;
            }
            let Some(leaf) = packets.leaves.get(index(candidate.leaf())) else { break };
            let leaves = core::slice::from_ref(leaf);
            found = opaque_of::<S, N>(world, leaves, (ray, t_max, &query), filters);
            if found.is_some() {
                break;
            }
        }
    } else {
        let mut stack = TraversalStack::new();
        let mut traversal = Traversal::of_objects(query, &mut stack);
        while found.is_none()
            && let Some(leaves) = traversal.leaf()
        {
            found = opaque_of::<S, N>(world, leaves, (ray, t_max, &traversal.query), filters);
        }
    }
    if found.is_some() {
        *last = found;
    }
    found.is_none()
}

/// Returns the transparent objects on the way so far, to which another is to be added.
fn added<S: ToF32>(filters: &mut Option<Filters<S>>) -> &mut Filters<S> {
    filters.get_or_insert_with(Filters::new)
}

/// Returns whether no opaque plane is on the way of a shadow ray, and adds the transparent ones.
#[inline(never)] // no ray of a scene without planes prepares for it
fn planes_are_open<S: ToF32, N: Needs>(
    world: &World<'_, S>,
    ray: &Ray<S>,
    t_max: S,
    filters: &mut Option<Filters<S>>,
) -> bool {
    for (i, plane) in (0..).zip(world.scene.planes) {
        if plane.intersect(ray, t_max).is_some() {
            match transmitted::<S, N>(world, plane.material) {
                Some(kt) => added(filters).add(Object::Plane(i), kt),
                None => return false,
            }
        }
    }
    true
}

/// Returns the first object of some leaves that lets nothing through, or none; adds what the others let through.
#[inline(always)]
fn opaque_of<S: ToF32, N: Needs>(
    world: &World<'_, S>,
    leaves: &[Sphere4],
    (ray, t_max, query): (&Ray<S>, S, &Query),
    filters: &mut Option<Filters<S>>,
) -> Option<Object> {
    for leaf in leaves {
        let mask = query.meet::<S>(leaf);
        for k in mask.items() {
            if let Some(&object) = leaf.items.get(k)
                && !matches!(object, Object::Lamp(_))
                && meet::<S, N>(world, query, (leaf, &mask, k), ray, t_max).is_some()
                && (!N::TRANSPARENT_SHADOWS || is_opaque::<S, N>(world, object, filters))
            {
                return Some(object);
            }
        }
    }
    None
}

/// Returns whether an object on the way lets nothing through; else it is added.
#[inline(never)] // so that a ray which meets nothing does not prepare for it
fn is_opaque<S: ToF32, N: Needs>(
    world: &World<'_, S>,
    object: Object,
    filters: &mut Option<Filters<S>>,
) -> bool {
    let Some(look) = world.scene.look::<N>(object) else { return false };
    match transmitted::<S, N>(world, look.material) {
        Some(kt) => added(filters).add(object, kt),
        None => return true,
    }
    false
}
