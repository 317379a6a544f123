//! The hierarchy over the spheres leaves nothing out: pictures and single rays are the same with it and without.

#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use fastrand::Rng;
use rta_core::bvh::{Child, Item};
use rta_core::hierarchy::Node;
use rta_core::illumination::Rta;
use rta_core::lanes::{Entry, LANES};
use rta_core::needs::Everything;
use rta_core::range::RangeError;
use rta_core::ray::Ray;
use rta_core::scalar::Unit;
use rta_core::vector::{UnitVec3, UnitVector, Vector};
use rta_core::{Q16, Q20};
use rta_scenes::description::{Cone, Cylinder, Description, Ellipsoid, Sphere, Surface, Triangle};
use rta_scenes::narrow::{Built, Narrow, narrow};
use rta_tests::exact::{DEPTH, Exact, OneByOne, shipped_scene};
use rta_tests::random_scenes;

/// `count` spheres of sizes that differ a thousandfold, in clusters and far from each other; some of them touch or coincide.
fn cloud(count: usize, spread: f64, seed: u64) -> Description {
    let mut rng = Rng::with_seed(seed);
    let mut scene = shipped_scene("juggler");
    let mut center = [0.0; 3];
    scene.spheres = (0..count)
        .map(|i| {
            if i % 7 == 0 {
                center = [(); 3].map(|()| spread * (rng.f64() - 0.5));
            }
            let radius = spread * 0.05 * 10f64.powf(-3.0 * rng.f64());
            let position = center.map(|c| c + spread * 0.05 * (rng.f64() - 0.5));
            // Rays that go through many glasses, each of which lets another part through.
            let kt = 0.5 + 0.5 * rng.f64();
            let glass = Surface::Transparent { ks: 1.0 - kt, kt, ior: 1.5 };
            let surface = if i % 5 == 0 { Surface::Opaque } else { glass };
            Sphere { position, color: [0.8, 0.5, 0.3], radius, surface, line: 0 }
        })
        .collect();
    let twin = scene.spheres[count / 2].clone();
    scene.spheres.insert(count / 3, twin);
    scene
}

/// The same with a cone, a triangle and an ellipsoid beside every third sphere.
fn medley(count: usize, spread: f64, seed: u64) -> Description {
    let mut scene = cloud(count, spread, seed);
    let mut rng = Rng::with_seed(seed + 1);
    for sphere in scene.spheres.iter().filter(|sphere| sphere.radius > 0.02).step_by(2) {
        let (radius, position, color) = (sphere.radius, sphere.position, sphere.color);
        let mut near = |size: f64| position.map(|c| c + size * radius * (2.0 * rng.f64() - 1.0));
        let (surface, line) = (Surface::Opaque, 0);
        let vertices = [near(2.0), near(2.0), near(2.0)];
        scene.triangles.push(Triangle { vertices, normals: None, color, surface, line });
        let [base, apex] = [near(2.0), near(2.0)];
        let radii = [radius, 0.2 * radius, 0.0];
        let (base_radius, apex_radius) = (radii[rng.usize(..2)], radii[rng.usize(..3)]);
        let (capped, inside_only) = (rng.bool(), rng.u8(..4) == 0);
        scene.cones.push(Cone {
            base,
            base_radius,
            apex,
            apex_radius,
            capped,
            inside_only,
            color,
            surface,
            line,
        });
        let radii = [radius, 0.5 * radius, 0.7 * radius];
        scene.ellipsoids.push(Ellipsoid { position: base, radii, color, surface, line });
    }
    scene
}

/// The nearest hits of random rays, from the eye, from surfaces and from far away; and how many there were.
fn compare<S: Narrow>(scene: &Description, rays: usize, seed: u64) -> usize {
    let narrowed = narrow::<S>(scene, 1.0).expect("it fits");
    assert!(!LANES || !narrowed.lanes.nodes.is_empty(), "there are objects enough");
    assert!(!LANES || narrowed.lanes.cubes.iter().all(|cube| cube.slack > 0.0), "they are of use");
    let admitted = narrowed.scene().admit(&narrowed.camera).expect("it fits");
    let firmware = narrowed.clone().without_lanes(scene);
    assert!(!firmware.hierarchy.is_empty() || !firmware.boxes.is_empty(), "there are objects enough");
    let firmware = firmware.scene().admit(&narrowed.camera).expect("it fits");
    let (lid, mut rng) = (admitted.limits().lid, Rng::with_seed(seed));
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
        let way = [0, 1, 2].map(|axis| edge[axis] - from[axis]);
        let length = way.iter().map(|c| c * c).sum::<f64>().sqrt();
        if length < 1e-3 {
            continue;
        }
        let [x, y, z] = way.map(|c| S::unit(c / length));
        let direction: UnitVec3<S> = Vector::new(x, y, z);
        let Some((direction, _)) = direction.normalize() else { continue };
        let [x, y, z] = from.map(S::length);
        let ray = Ray::new::<Everything>(Vector::new(x, y, z), direction);
        let without = admitted.nearest::<OneByOne>(&ray, lid);
        met += usize::from(without.is_some());
        // The last part of a sphere, and all of it.
        let t_max = S::length(if number % 2 == 0 { 0.9 } else { 3.0 } * length);
        let shadow = admitted.transmittance::<OneByOne>(&ray, t_max, lid);
        for scene in [&admitted, &firmware] {
            let with = scene.nearest::<Everything>(&ray, lid);
            assert_eq!(with.map(|hit| hit.object), without.map(|hit| hit.object), "{ray:?}");
            assert!(with.map(|hit| hit.distance) == without.map(|hit| hit.distance), "{ray:?}");
            assert!(scene.transmittance::<Everything>(&ray, t_max, lid) == shadow, "{ray:?}");
        }
        dimmed += usize::from(shadow > S::Unit::ZERO && shadow < S::Unit::ONE);
        // From about as far to a lamp.
        let (lamp, start) = (scene.lamps[0].position, edge);
        let way = [0, 1, 2].map(|axis| lamp[axis] - start[axis]);
        let length = way.iter().map(|c| c * c).sum::<f64>().sqrt();
        let [x, y, z] = way.map(|c| S::unit(c / length));
        let direction: UnitVec3<S> = Vector::new(x, y, z);
        let Some((direction, _)) = direction.normalize() else { continue };
        let [x, y, z] = start.map(S::length);
        let ray = Ray::new::<Everything>(Vector::new(x, y, z), direction);
        let t_max = S::length(length);
        let light = admitted.transmittance::<OneByOne>(&ray, t_max, lid);
        for scene in [&admitted, &firmware] {
            assert!(scene.transmittance::<Everything>(&ray, t_max, lid) == light, "to the lamp: {ray:?}");
        }
        lit += usize::from(light > S::Unit::ZERO);
    }
    assert!(lit > rays / 50 && lit < rays - rays / 50, "{lit} rays came to the lamp");
    assert!(dimmed > rays / 50, "only {dimmed} rays went through glass");
    met
}

#[test]
fn single_rays_meet_the_same() {
    // Without a hierarchy each ray is tried with each object: the more there are, the fewer rays.
    for (count, spread, rays) in
        [(13, 5.0, 20_000), (70, 20.0, 20_000), (500, 60.0, 8000), (3000, 90.0, 2000)]
    {
        let scene = cloud(count, spread, 7);
        for met in [
            compare::<Q16>(&scene, rays, 1),
            compare::<Q20>(&scene, rays, 2),
            compare::<f32>(&scene, rays, 3),
            compare::<f64>(&scene, rays, 4),
        ] {
            assert!(met > rays / 4, "only {met} of {rays} rays met anything");
        }
    }
}

#[test]
fn single_rays_meet_the_same_of_every_kind() {
    for (count, spread, rays) in [(20, 5.0, 10_000), (300, 20.0, 8000), (3000, 90.0, 1200)] {
        let scene = medley(count, spread, 11);
        for met in [
            compare::<Q16>(&scene, rays, 1),
            compare::<Q20>(&scene, rays, 2),
            compare::<f32>(&scene, rays, 3),
            compare::<f64>(&scene, rays, 4),
        ] {
            assert!(met > rays / 4, "only {met} of {rays} rays met anything");
        }
    }
}

#[test]
fn pictures_are_the_same() {
    let mut scenes = random_scenes::all();
    scenes.push(("juggler", shipped_scene("juggler")));
    scenes.push(("hall-22", shipped_scene("hall-22")));
    let mut with_one = 0;
    for (name, scene) in scenes {
        let exact = Exact::new(&scene, 120, 75);
        let firmware = exact.without_lanes(&scene);
        with_one += usize::from(!firmware.scene().hierarchy.is_empty());
        let same = exact.picture::<_, OneByOne>(Rta, DEPTH);
        assert!(exact.picture::<_, Everything>(Rta, DEPTH) == same, "{name} by lanes");
        assert!(firmware.picture::<_, Everything>(Rta, DEPTH) == same, "{name} by spheres");
    }
    assert!(with_one >= 3, "only {with_one} of the scenes have a hierarchy");
}

#[test]
fn a_hierarchy_that_is_wrong_is_refused() {
    let scene = shipped_scene("juggler");
    let good = narrow::<Q16>(&scene, 1.0).expect("it fits").without_lanes(&scene);
    assert!(good.hierarchy.len() > 8);
    let refused = |edit: &dyn Fn(&mut Vec<Node<Q16>>)| {
        let mut bad = good.clone();
        edit(&mut bad.hierarchy);
        bad.scene().admit(&bad.camera).err()
    };
    assert_eq!(refused(&|_| ()), None);
    let number = |error| matches!(error, Some(RangeError::Hierarchy(_)));
    assert!(number(refused(&|nodes| nodes[0].radius = Q16::from_num(1))), "too small a ball");
    assert!(number(refused(&|nodes| nodes[0].radius = Q16::from_num(20000))), "too large a ball");
    assert!(number(refused(&|nodes| nodes[3].skip = 3)), "it leads to itself");
    assert!(number(refused(&|nodes| nodes[3].skip = 10_000)), "it leads nowhere");
    assert!(number(refused(&|nodes| nodes[0].end = 71)), "beyond the list");
    assert!(number(refused(&|nodes| nodes.truncate(5))), "not complete");
    assert!(number(refused(&|nodes| nodes[2].center.x = Q16::from_num(90))), "beside its spheres");
}

#[test]
fn lanes_that_are_wrong_are_refused() {
    if !LANES {
        return;
    }
    let scene = shipped_scene("hall-22");
    let good = narrow::<Q16>(&scene, 1.0).expect("it fits");
    assert!(good.lanes.nodes.len() > 1 && good.lanes.packs.len() > 3 && good.lanes.posts.len() == 2);
    let refused = |edit: &dyn Fn(&mut Built)| {
        let mut bad = good.clone();
        edit(&mut bad.lanes);
        matches!(bad.scene().admit(&bad.camera).err(), Some(RangeError::Hierarchy(_)))
    };
    assert!(!refused(&|_| ()));
    assert!(refused(&|lanes| lanes.nodes[0].children[0] = Child::node(0)), "it leads to itself");
    assert!(refused(&|lanes| lanes.nodes[0].children[0] = Child::node(99)), "it leads nowhere");
    assert!(refused(&|lanes| lanes.nodes[0].children = [Child::EMPTY; 4]), "it leads to nothing");
    assert!(refused(&|lanes| lanes.packs.truncate(3)), "a leaf is missing");
    assert!(refused(&|lanes| lanes.packs[0].items[0] = Item::Sphere(10)), "there is no such sphere");
    assert!(refused(&|lanes| lanes.posts[1].cylinders[1] = 6), "there is no such cylinder");
    assert!(refused(&|lanes| lanes.posts.truncate(1)), "two cylinders are missing");
    assert!(refused(&|lanes| lanes.entries[0] = Entry::new(0.0, 99)), "there is no such pack");
    assert!(refused(&|lanes| lanes.entries.truncate(1)), "entries are missing");
    assert!(refused(&|lanes| lanes.cells[1] = 99_999), "a cell begins beyond its end");
}

/// The nearest hits and shadows of rays from so far away that lanes cannot tell anything; and how many there were.
fn compare_far<S: Narrow>() -> usize {
    let mut scene = medley(20, 5.0, 11);
    // All of a size that is seen from there, about the origin and beside it.
    let size = 1e16;
    for sphere in &mut scene.spheres {
        (sphere.position, sphere.radius) = (sphere.position.map(|c| c * size / 5.0), sphere.radius * size);
    }
    scene.spheres[0].position = [0.0; 3];
    for cone in &mut scene.cones {
        (cone.base, cone.apex) = (cone.base.map(|c| c * size / 5.0), cone.apex.map(|c| c * size / 5.0));
        (cone.base_radius, cone.apex_radius) = (cone.base_radius * size, cone.apex_radius * size);
    }
    scene.triangles.clear();
    scene.ellipsoids.clear();
    scene.floor = None;
    let color = [0.5; 3];
    let (surface, line) = (Surface::Opaque, 0);
    scene.cylinders.push(Cylinder { position: [0.3 * size; 3], color, radius: 0.2 * size, surface, line });
    let narrowed = narrow::<S>(&scene, 1.0).expect("it fits");
    assert!(!LANES || !narrowed.lanes.nodes.is_empty(), "there are objects enough");
    let (scene, lid, mut rng, mut met) = (narrowed.scene(), S::FAR, Rng::with_seed(1), 0);
    for _ in 0..2000 {
        let from = [(); 3].map(|()| 6e17 * (rng.f64() - 0.5));
        let way = from.map(|c| size * (rng.f64() - 0.5) - c);
        let length = way.iter().map(|c| c * c).sum::<f64>().sqrt();
        let ([x, y, z], [dx, dy, dz]) = (from.map(S::length), way.map(|c| S::unit(c / length)));
        let Some((direction, _)) = UnitVec3::<S>::new(dx, dy, dz).normalize() else { continue };
        let ray = Ray::new::<Everything>(Vector::new(x, y, z), direction);
        let (with, without) = (scene.nearest::<Everything>(&ray, lid), scene.nearest::<OneByOne>(&ray, lid));
        assert_eq!(with.map(|hit| hit.object), without.map(|hit| hit.object), "{ray:?}");
        assert!(with.map(|hit| hit.distance) == without.map(|hit| hit.distance), "{ray:?}");
        let shadow = scene.transmittance::<OneByOne>(&ray, S::FAR, lid);
        assert!(scene.transmittance::<Everything>(&ray, S::FAR, lid) == shadow, "{ray:?}");
        met += usize::from(with.is_some());
    }
    met
}

#[test]
fn rays_from_beyond_the_lanes_meet_the_same() {
    for met in [compare_far::<f32>(), compare_far::<f64>()] {
        assert!(met > 200, "only {met} rays met anything");
    }
}
