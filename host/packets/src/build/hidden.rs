//! Objects in the very place of others.

use rta_core::scene::Object;
use rta_scenes::accelerator::solid::Solid;
use rta_scenes::description::{Cone, Description, Ellipsoid, Sphere, Surface, Triangle};

use crate::one::MOST_FILTERS;

/// The most objects of one box that others are compared with: a triangle has six orders of its vertices.
const VARIANTS: usize = 8;

/// Objects that differ only in what is seen of their surfaces.
struct Alike {
    first: Object,
    /// How many are kept that let light through.
    clear: usize,
    /// Whether one is kept that lets none through.
    is_opaque: bool,
}

/// Leaves out objects in the very place of others of their kind, as no hierarchy can tell them apart and each ray would have to be
/// tested against all of them. Of equally near objects the first is seen, so that another matters to shadow rays only: not after
/// an opaque one, and not where so many let light through that a shadow ray is traced without the hierarchy.
pub(super) fn leave_out(scene: &Description, solids: &mut Vec<Solid>) {
    // Equal boxes have equal keys, which are sorted more quickly than boxes.
    let mut keys: Vec<(u64, usize)> = solids.iter().map(key).zip(0..).collect();
    keys.sort_unstable();
    let mut hidden = Vec::new();
    for same in keys.chunk_by(|(a, _), (b, _)| a == b).filter(|same| same.len() > 1) {
        let mut found: Vec<Alike> = Vec::new();
        for &(_, number) in same {
            let Some(&Solid { object, .. }) = solids.get(number) else { continue };
            let is_opaque = is_opaque(scene, object);
            let is_room = found.len() < VARIANTS;
            match found.iter_mut().find(|alike| are_alike(scene, alike.first, object)) {
                Some(alike) if alike.is_opaque || (!is_opaque && alike.clear >= MOST_FILTERS) => {
                    hidden.push(number);
                }
                Some(alike) => {
                    alike.is_opaque |= is_opaque;
                    alike.clear += usize::from(!is_opaque);
                }
                None if is_room => {
                    found.push(Alike { first: object, clear: usize::from(!is_opaque), is_opaque });
                }
                None => {}
            }
        }
    }
    if !hidden.is_empty() {
        hidden.sort_unstable();
        let mut number = 0;
        solids.retain(|_| {
            number += 1;
            hidden.binary_search(&(number - 1)).is_err()
        });
    }
}

/// Returns a number that is as good as random and the same for the same box.
fn key(solid: &Solid) -> u64 {
    let corners = solid.bounds.low.iter().chain(&solid.bounds.high);
    // Zeros of both signs are the same.
    corners.fold(0, |key: u64, c| {
        (key.rotate_left(23) ^ (c + 0.0).to_bits()).wrapping_mul(0x9e37_79b9_7f4a_7c15)
    })
}

/// Returns whether two objects are of one kind and differ only in what is seen of their surfaces.
fn are_alike(scene: &Description, one: Object, other: Object) -> bool {
    let index = |i: u32| i as usize;
    // The second is given the looks of the first, so that all else is compared, whatever it is.
    macro_rules! compare {
        ($list:ident, $Kind:ident, $i:ident, $k:ident, { $($look:ident),+ }) => {
            scene.$list.get(index($i)).zip(scene.$list.get(index($k))).is_some_and(|(a, b)| {
                let $Kind { $($look,)+ .. } = *a;
                *a == $Kind { $($look,)+ ..b.clone() }
            })
        };
    }
    match (one, other) {
        (Object::Sphere(i), Object::Sphere(k)) => compare!(spheres, Sphere, i, k, { color, surface, line }),
        (Object::Ellipsoid(i), Object::Ellipsoid(k)) => {
            compare!(ellipsoids, Ellipsoid, i, k, { color, surface, line })
        }
        (Object::Cone(i), Object::Cone(k)) => compare!(cones, Cone, i, k, { color, surface, line }),
        (Object::Triangle(i), Object::Triangle(k)) => {
            compare!(triangles, Triangle, i, k, { color, surface, line, normals })
        }
        _ => false,
    }
}

/// Returns whether an object lets no light through, in every number format.
fn is_opaque(scene: &Description, object: Object) -> bool {
    let index = |i: u32| i as usize;
    let surface = match object {
        Object::Sphere(i) => scene.spheres.get(index(i)).map(|object| &object.surface),
        Object::Ellipsoid(i) => scene.ellipsoids.get(index(i)).map(|object| &object.surface),
        Object::Cone(i) => scene.cones.get(index(i)).map(|object| &object.surface),
        Object::Triangle(i) => scene.triangles.get(index(i)).map(|object| &object.surface),
        _ => None,
    };
    match surface {
        Some(Surface::Opaque | Surface::Shiny | Surface::Mirror) => true,
        Some(Surface::Finish { kt, .. }) => *kt == 0.0,
        _ => false,
    }
}
