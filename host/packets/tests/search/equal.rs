//! Single rays are found the same by packets as one object after the other, wherever they start.

use fastrand::Rng;
use rta_core::needs::Everything;
use rta_core::{Q16, Q20};
use rta_packets::{Packets, ToF32};
use rta_scenes::description::{Cylinder, Description, Lamp, Surface};
use rta_scenes::narrow::{Narrow, narrow};

use crate::compare::{aim, compare};
use crate::scenes::{cloud, medley};

fn by_packets<S: Narrow + ToF32>(scene: &Description, rays: usize, seed: u64) -> usize {
    let narrowed = narrow::<S>(scene, 1.0).expect("it fits");
    compare(scene, &narrowed, &[&Packets::build::<S>(scene)], rays, seed)
}

fn in_all_formats(scene: &Description, rays: usize) {
    for met in [
        by_packets::<Q16>(scene, rays, 1),
        by_packets::<Q20>(scene, rays, 2),
        by_packets::<f32>(scene, rays, 3),
        by_packets::<f64>(scene, rays, 4),
    ] {
        assert!(met > rays / 4, "only {met} of {rays} rays met anything");
    }
}

#[test]
fn single_rays_meet_the_same() {
    // One object after the other is slow: the more there are, the fewer rays.
    for (count, spread, rays) in
        [(13, 5.0, 20_000), (70, 20.0, 20_000), (500, 60.0, 8000), (3000, 90.0, 2000)]
    {
        in_all_formats(&cloud(count, spread, 7), rays);
    }
}

#[test]
fn single_rays_meet_the_same_of_every_kind() {
    for (count, spread, rays) in [(20, 5.0, 10_000), (300, 20.0, 8000), (3000, 90.0, 1200)] {
        in_all_formats(&medley(count, spread, 11), rays);
    }
}

#[test]
fn single_rays_meet_the_same_among_many_lamps_and_in_one_place() {
    let mut scene = medley(300, 20.0, 11);
    let lamp = scene.lamps.first().expect("it is lit").clone();
    scene.lamps.extend((1..100).map(|i| {
        let position = lamp.position.map(|c| c - 0.2 * f64::from(i));
        Lamp { position, radius: 0.3, ..lamp.clone() }
    }));
    // As many as a light buffer's cells list, and more.
    for first in scene.spheres.get(..3).expect("there are some").to_vec() {
        scene.spheres.extend((0..100).map(|_| first.clone()));
    }
    for first in scene.triangles.get(..2).expect("there are some").to_vec() {
        scene.triangles.extend((0..50).map(|_| first.clone()));
    }
    in_all_formats(&scene, 5000);
}

/// Returns a scene all of whose things are of a size that is seen from some 1e17 away, about the origin and beside it.
fn huge(size: f64) -> Description {
    let mut scene = medley(20, 5.0, 11);
    for sphere in &mut scene.spheres {
        (sphere.position, sphere.radius) = (sphere.position.map(|c| c * size / 5.0), sphere.radius * size);
    }
    if let Some(sphere) = scene.spheres.first_mut() {
        sphere.position = [0.0; 3];
    }
    for cone in &mut scene.cones {
        (cone.base, cone.apex) = (cone.base.map(|c| c * size / 5.0), cone.apex.map(|c| c * size / 5.0));
        (cone.base_radius, cone.apex_radius) = (cone.base_radius * size, cone.apex_radius * size);
    }
    scene.triangles.clear();
    scene.ellipsoids.clear();
    scene.floor = None;
    let (color, surface, line) = ([0.5; 3], Surface::Opaque, 0);
    scene.cylinders.push(Cylinder { position: [0.3 * size; 3], color, radius: 0.2 * size, surface, line });
    scene
}

/// Compares rays that start beyond all that the search in `f32` can tell anything of, and returns how many met something.
fn compare_far<S: Narrow + ToF32>(size: f64) -> usize {
    let scene = huge(size);
    let narrowed = narrow::<S>(&scene, 1.0).expect("it fits");
    let packets = Packets::build::<S>(&scene);
    let lists = narrowed.admit().expect("it fits");
    let packets = narrowed.scene().admit_with(&narrowed.camera, &packets).expect("it fits");
    let (mut rng, mut met) = (Rng::with_seed(1), 0);
    for _ in 0..2000 {
        let from = [(); 3].map(|()| 6e17 * (rng.f64() - 0.5));
        let Some(towards) = rng.choice(&scene.spheres) else { continue };
        let to = towards.position.map(|c| c + 1.2 * towards.radius * (2.0 * rng.f64() - 1.0));
        let Some((origin, direction, _)) = aim::<S>(from, to) else { continue };
        let ray = lists.ray::<Everything>(origin, direction);
        let (with, without) = (packets.closest::<Everything>(&ray), lists.closest::<Everything>(&ray));
        assert_eq!(with.map(|hit| hit.object), without.map(|hit| hit.object), "{ray:?}");
        assert!(with.map(|hit| hit.distance) == without.map(|hit| hit.distance), "{ray:?}");
        let shadow = lists.transmittance::<Everything>(&ray, S::FAR, 0);
        assert!(packets.transmittance::<Everything>(&ray, S::FAR, 0) == shadow, "{ray:?}");
        met += usize::from(with.is_some());
    }
    met
}

#[test]
fn rays_from_where_the_search_cannot_tell_anything_meet_the_same() {
    // In the second scene, all is too far away, and one object is asked after the other.
    for size in [1e16, 1e17] {
        for met in [compare_far::<f32>(size), compare_far::<f64>(size)] {
            assert!(met > 200, "only {met} rays met anything of size {size}");
        }
    }
}
