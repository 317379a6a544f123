#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use fastrand::Rng;
use rta_core::scene::Object;
use rta_core::vector::Vector;
use rta_core::{Q16, Q20};

use super::{Built, build, over_all, over_spheres, solids, spread};
use crate::description::{Camera, Cone, Description, Ellipsoid, Sphere, Surface, Triangle};
use crate::narrow::{Narrow, narrow};
use crate::space::{cross, difference, length, unit};

const COLOR: [f64; 3] = [0.5; 3];

fn balls() -> Description {
    crate::read(include_bytes!("../../../balls2.nff"), "balls2.nff").expect("it ships")
}

/// Spheres, ellipsoids, cones and triangles of sizes that differ a hundredfold, in no order.
fn random(count: usize, seed: u64) -> Description {
    let rng = &mut Rng::with_seed(seed);
    let mut scene = Description::empty(Camera::upright([0.0; 3], [0.0, 1.0, 0.0], 1.0));
    for number in 0..count {
        let middle = [(); 3].map(|()| 40.0 * (rng.f64() - 0.5));
        let radius = 10f64.powf(-2.0 * rng.f64());
        let mut near = || middle.map(|c| c + 2.0 * radius * (rng.f64() - 0.5));
        let (color, surface, line) = (COLOR, Surface::Opaque, 0);
        let [a, b, c] = [near(), near(), near()];
        match number % 4 {
            0 => scene.spheres.push(Sphere { position: a, radius, color, surface, line }),
            1 => {
                let radii = [radius, 0.3 * radius, 0.7 * radius];
                scene.ellipsoids.push(Ellipsoid {
                    position: a,
                    radii,
                    inside_only: false,
                    color,
                    surface,
                    line,
                });
            }
            2 => scene.cones.push(Cone {
                base: a,
                base_radius: radius,
                apex: b,
                apex_radius: 0.3 * radius,
                capped: true,
                inside_only: false,
                color,
                surface,
                line,
            }),
            _ => {
                scene.triangles.push(Triangle {
                    vertices: [a, b, c],
                    normals: None,
                    one_sided: false,
                    color,
                    surface,
                    line,
                });
            }
        }
    }
    scene
}

/// Returns how far the farthest of an object's points is from a place, by the object's own geometry: of a sphere exactly, of the
/// others at many points on them, the outermost among these.
fn farthest(scene: &Description, object: Object, from: [f64; 3]) -> f64 {
    let away = |place: [f64; 3]| length(difference(place, from));
    let turns = || (0..720).map(|step| f64::from(step).to_radians() / 2.0).map(f64::sin_cos);
    let most = |all: &mut dyn Iterator<Item = [f64; 3]>| all.map(away).fold(0.0, f64::max);
    match object {
        Object::Sphere(i) => {
            let sphere = &scene.spheres[i as usize];
            away(sphere.position) + sphere.radius
        }
        Object::Ellipsoid(i) => {
            let Ellipsoid { position: [x, y, z], radii: [a, b, c], .. } = scene.ellipsoids[i as usize];
            most(&mut turns().step_by(8).flat_map(|(s, t)| {
                turns().step_by(8).map(move |(u, v)| [x + a * s * u, y + b * s * v, z + c * t])
            }))
        }
        Object::Cone(i) => {
            let cone = &scene.cones[i as usize];
            let axis = unit(difference(cone.apex, cone.base)).expect("it has a height");
            let aside = if axis[0].abs() < 0.5 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
            let u = unit(cross(axis, aside)).expect("it is aside");
            let v = cross(axis, u);
            let disc = |center: [f64; 3], radius: f64| {
                turns().map(move |(s, t)| [0, 1, 2].map(|k| center[k] + radius * (s * u[k] + t * v[k])))
            };
            most(&mut disc(cone.base, cone.base_radius).chain(disc(cone.apex, cone.apex_radius)))
        }
        Object::Triangle(i) => most(&mut scene.triangles[i as usize].vertices.into_iter()),
        Object::Floor | Object::Cylinder(_) | Object::Plane(_) | Object::Lamp(_) => {
            panic!("{object} has no place in a hierarchy")
        }
    }
}

/// Asserts that each node contains all objects of its run, and that its nodes are admitted; returns how many nodes there are.
fn check<S: Narrow>(scene: &Description, built: &Built<S>) -> usize {
    let spheres: Vec<_> = (0..).zip(&scene.spheres).map(|(i, _)| Object::Sphere(i)).collect();
    let order = if built.order.is_empty() { &spheres } else { &built.order };
    for (number, node) in built.nodes.iter().enumerate() {
        let center = [node.center.x(), node.center.y(), node.center.z()].map(S::to_f64);
        let radius = node.radius.to_f64();
        for object in &order[node.first as usize..node.end as usize] {
            let reach = farthest(scene, *object, center);
            assert!(reach <= radius, "node {number} of {radius}: {object} reaches {reach} in {}", S::NAME);
        }
    }
    let narrowed = narrow::<S>(scene, 1.0).expect("it fits");
    let bvh = built.bvh().expect("there are objects enough");
    narrowed.scene().admit_with(&narrowed.camera, bvh).expect("it is a right hierarchy");
    built.nodes.len()
}

#[test]
fn few_objects_have_no_hierarchy() {
    let scene = random(19, 1);
    assert!(build::<Q16>(&scene).bvh().is_none());
    assert!(build::<f32>(&Description::empty(scene.camera)).bvh().is_none());
    let mut few = balls();
    few.spheres.truncate(11);
    few.triangles.clear();
    assert!(build::<Q16>(&few).bvh().is_none());
}

#[test]
fn spheres_in_a_good_order_keep_it() {
    fn keeps<S: Narrow>() {
        let scene = balls();
        let built = build::<S>(&scene);
        assert!(built.order.is_empty() && built.nodes.len() > 40, "{} nodes", built.nodes.len());
        check(&scene, &built);
    }
    keeps::<Q16>();
    keeps::<Q20>();
    keeps::<f32>();
    keeps::<f64>();
}

#[test]
fn a_shuffled_list_is_sorted() {
    let mut scene = balls();
    Rng::with_seed(3).shuffle(&mut scene.spheres);
    let built = build::<Q16>(&scene);
    assert_eq!(built.order.len(), solids(&scene).len());
    check(&scene, &built);
}

#[test]
fn a_list_in_order_costs_less_than_a_shuffled_one() {
    let cost = |scene: &Description| {
        let solids = solids(scene);
        let built = over_spheres::<f64>(scene, solids.get(..scene.spheres.len()).expect("they are first"));
        built.cost(spread(&solids), |first, end| f64::from(u32::try_from(end - first).expect("few")))
    };
    let (mut scene, good) = (balls(), cost(&balls()));
    Rng::with_seed(3).shuffle(&mut scene.spheres);
    let bad = cost(&scene);
    assert!(good < 0.5 * bad, "{good} in a good order, {bad} in a bad one");
}

#[test]
fn what_is_large_and_rarely_met_makes_no_search_look_cheap() {
    // The floor of the balls is 20 times as wide as they are; 200 times makes no difference to what is kept.
    let mut scene = balls();
    for triangle in &mut scene.triangles {
        triangle.vertices.iter_mut().flatten().for_each(|c| *c *= 10.0);
    }
    assert!(build::<Q16>(&scene).order.is_empty());
    Rng::with_seed(3).shuffle(&mut scene.spheres);
    assert!(!build::<Q16>(&scene).order.is_empty());
}

#[test]
fn every_node_contains_its_objects() {
    for (count, seed) in [(20, 1), (80, 2), (400, 3)] {
        let scene = random(count, seed);
        let ordered = [
            check(&scene, &over_all::<Q16>(&scene, &mut solids(&scene))),
            check(&scene, &over_all::<Q20>(&scene, &mut solids(&scene))),
            check(&scene, &over_all::<f32>(&scene, &mut solids(&scene))),
            check(&scene, &over_all::<f64>(&scene, &mut solids(&scene))),
        ];
        assert!(ordered.iter().all(|nodes| *nodes > count / 8), "{ordered:?}");
        let spheres = scene.spheres.len();
        check(&scene, &over_spheres::<Q16>(&scene, &solids(&scene)[..spheres]));
        check(&scene, &over_spheres::<f32>(&scene, &solids(&scene)[..spheres]));
    }
}

#[test]
fn of_two_children_the_one_nearer_the_eye_is_first() {
    let scene = random(200, 4);
    let built = over_all::<f64>(&scene, &mut solids(&scene));
    let eye = scene.camera.eye;
    let away = |number: usize| {
        let center = built.nodes[number].center;
        length(difference([center.x, center.y, center.z], eye))
    };
    let mut pairs = 0;
    for (number, node) in built.nodes.iter().enumerate() {
        let (first, end) = (number + 1, node.skip as usize);
        if first < end {
            let second = built.nodes[first].skip as usize;
            assert!(second < end && built.nodes[second].skip as usize == end, "two children");
            assert!(away(first) <= away(second));
            pairs += 1;
        }
    }
    assert!(pairs > 20, "{pairs} pairs");
}

#[test]
fn a_format_without_room_for_the_nodes_has_none() {
    let mut scene = random(80, 5);
    let scale = |place: &mut [f64; 3]| *place = place.map(|c| 40.0 * c);
    scene.spheres.iter_mut().for_each(|sphere| scale(&mut sphere.position));
    assert!(build::<Q16>(&scene).bvh().is_some());
    assert!(build::<Q20>(&scene).bvh().is_none(), "half of q20's range is 1024");
}
