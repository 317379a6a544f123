//! Single rays, searched for by any accelerator and by one object after the other.

#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use fastrand::Rng;
use rta_core::accelerator::Accelerator;
use rta_core::needs::Everything;
use rta_core::scalar::Unit;
use rta_core::vector::{UnitVec3, UnitVector, Vec3, Vector};
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrow, Narrowed};

/// Returns origin, direction and length of the way from one place to another; nothing if it is too short.
pub(crate) fn aim<S: Narrow>(from: [f64; 3], to: [f64; 3]) -> Option<(Vec3<S>, UnitVec3<S>, f64)> {
    let way = [0, 1, 2].map(|axis| to[axis] - from[axis]);
    let length = way.iter().map(|c| c * c).sum::<f64>().sqrt();
    if length < 1e-3 {
        return None;
    }
    let [x, y, z] = way.map(|c| S::unit(c / length));
    let (direction, _) = UnitVec3::<S>::new(x, y, z).normalize()?;
    let [x, y, z] = from.map(S::length);
    Some((Vector::new(x, y, z), direction, length))
}

/// Asserts that each accelerator finds of random rays what one object after the other finds: the nearest hits of rays from the
/// eye, from surfaces and from far away, and what comes through along them and to a lamp. Returns how many rays met something.
pub(crate) fn compare<S: Narrow, A: Accelerator<S>>(
    scene: &Description,
    narrowed: &Narrowed<S>,
    accelerators: &[A],
    rays: usize,
    seed: u64,
) -> usize {
    let lists = narrowed.admit().expect("it fits");
    let others = accelerators.iter().map(|other| narrowed.scene().admit_with(&narrowed.camera, *other));
    let others: Vec<_> = others.collect::<Result<_, _>>().expect("it fits");
    // What is kept from ray to ray makes no difference.
    let mut memories: Vec<_> = others.iter().map(|_| A::Memory::default()).collect();
    let mut rng = Rng::with_seed(seed);
    let (mut met, mut dimmed, mut lit) = (0, 0, 0);
    for number in 0..rays {
        let spheres = &scene.spheres;
        let towards = &spheres[rng.usize(..spheres.len())];
        let from = match number % 3 {
            0 => scene.camera.eye,
            1 => {
                let start = &spheres[rng.usize(..spheres.len())];
                start.position.map(|c| c + start.radius * (2.0 * rng.f64() - 1.0))
            }
            _ => [(); 3].map(|()| 100.0 * (rng.f64() - 0.5)),
        };
        // Close to the sphere's edge, on either side of it.
        let edge = towards.position.map(|c| c + 1.5 * towards.radius * (2.0 * rng.f64() - 1.0));
        let Some((origin, direction, length)) = aim::<S>(from, edge) else { continue };
        let ray = lists.ray::<Everything>(origin, direction);
        let without = lists.closest::<Everything>(&ray);
        met += usize::from(without.is_some());
        // The last part of a sphere, and all of it.
        let t_max = S::length(if number % 2 == 0 { 0.9 } else { 3.0 } * length);
        let shadow = lists.transmittance::<Everything>(&ray, t_max, 0);
        for other in &others {
            let with = other.closest::<Everything>(&ray);
            assert_eq!(with.map(|hit| hit.object), without.map(|hit| hit.object), "{ray:?}");
            assert!(with.map(|hit| hit.distance) == without.map(|hit| hit.distance), "{ray:?}");
            assert!(other.transmittance::<Everything>(&ray, t_max, 0) == shadow, "{ray:?}");
        }
        dimmed += usize::from(shadow > S::Unit::ZERO && shadow < S::Unit::ONE);
        // From about as far to a lamp.
        let Some((origin, direction, length)) = aim::<S>(edge, scene.lamps[0].position) else { continue };
        let (ray, t_max) = (lists.ray::<Everything>(origin, direction), S::length(length));
        let light = lists.transmittance::<Everything>(&ray, t_max, 0);
        for (other, memory) in others.iter().zip(&mut memories) {
            let found = other.accelerator().transmittance::<Everything>(other, &ray, t_max, 0, memory);
            assert!(found == light, "to the lamp: {ray:?}");
        }
        lit += usize::from(light > S::Unit::ZERO);
    }
    assert!(lit > rays / 50 && lit < rays - rays / 50, "{lit} rays came to the lamp");
    assert!(dimmed > rays / 50, "only {dimmed} rays went through glass");
    met
}
