//! What does not depend on the order in which a search comes upon objects: which of equally near ones is seen, and how what
//! glasses let through is multiplied.

use core::fmt::Debug;

use rta_core::needs::Everything;
use rta_core::scalar::Unit;
use rta_core::scene::Object;
use rta_core::{Q16, Q20};
use rta_scenes::description::{
    Camera, Cone, Cylinder, Description, Ellipsoid, FallOff, Floor, Lamp, Sphere, Surface, Triangle,
};
use rta_scenes::narrow::{Narrow, narrow};

use super::compare::aim;
use super::{over_all, over_spheres};

const COLOR: [f64; 3] = [0.5; 3];

/// Returns an empty scene that is seen from the origin along the y axis.
fn empty() -> Description {
    Description::empty(Camera::upright([0.0, 0.0, 1.0], [0.0, 1.0, 0.0], 1.0))
}

/// Returns the scene with every object twice, the second ones at the end of each list, and with triangles in its floor.
fn doubled() -> Description {
    let surface = Surface::Opaque;
    let mut scene = empty();
    for i in 0..6 {
        let x = f64::from(i);
        let (position, color, line) = ([x, 9.0, 1.0], COLOR, 0);
        scene.spheres.push(Sphere { position, radius: 0.4, color, surface, line });
        let position = [x, 9.0, 2.0];
        scene.ellipsoids.push(Ellipsoid {
            position,
            radii: [0.4, 0.3, 0.2],
            inside_only: false,
            color,
            surface,
            line,
        });
        scene.cones.push(Cone {
            base: [x, 9.0, 2.6],
            base_radius: 0.4,
            apex: [x, 9.0, 3.4],
            apex_radius: 0.2,
            capped: true,
            inside_only: false,
            color,
            surface,
            line,
        });
        let vertices = [[x, 9.0, 4.0], [x + 0.8, 9.0, 4.0], [x, 9.0, 4.8]];
        scene.triangles.push(Triangle { vertices, normals: None, one_sided: false, color, surface, line });
    }
    let copy = scene.clone();
    scene.spheres.extend(copy.spheres);
    scene.ellipsoids.extend(copy.ellipsoids);
    scene.cones.extend(copy.cones);
    scene.triangles.extend(copy.triangles);
    // In the floor, where the floor is seen.
    let vertices = [[0.0, 3.0, 0.0], [4.0, 3.0, 0.0], [0.0, 7.0, 0.0]];
    let triangle = Triangle { vertices, normals: None, one_sided: false, color: COLOR, surface, line: 0 };
    scene.triangles.push(triangle);
    scene.floor = Some(Floor { colors: [COLOR; 2], surface: Surface::Opaque });
    scene
}

fn ties<S: Narrow + Debug>() {
    let scene = doubled();
    let narrowed = narrow::<S>(&scene, 1.0).expect("it fits");
    let lists = narrowed.admit().expect("it fits");
    for seed in 0..8 {
        let built = if seed == 0 { over_spheres::<S>(&scene) } else { over_all::<S>(&scene, seed) };
        let bvh = built.bvh().expect("it has nodes");
        let admitted = narrowed.scene().admit_with(&narrowed.camera, bvh).expect("it is right");
        let (mut firsts, mut floor) = (0, 0);
        for (i, z) in (0..6).flat_map(|i| [1.05, 2.05, 3.05, 4.2].map(|z| (i, z))) {
            let Some((origin, direction, _)) = aim::<S>([0.1, 0.3, 1.0], [f64::from(i) + 0.1, 9.0, z]) else {
                continue;
            };
            let ray = lists.ray::<Everything>(origin, direction);
            let (found, right) = (admitted.closest::<Everything>(&ray), lists.closest::<Everything>(&ray));
            assert_eq!(found.map(|hit| hit.object), right.map(|hit| hit.object), "{ray:?}");
            let (Object::Sphere(number)
            | Object::Ellipsoid(number)
            | Object::Cone(number)
            | Object::Triangle(number)) = right.expect("it is aimed at").object
            else {
                panic!("{right:?}")
            };
            assert!(number < 6, "the first of two is seen");
            firsts += 1;
        }
        for (x, y) in [(0.5, 3.5), (1.5, 3.9), (1.0, 5.0)] {
            let (origin, direction, _) = aim::<S>([0.1, 0.3, 1.0], [x, y, 0.0]).expect("it is away");
            let ray = lists.ray::<Everything>(origin, direction);
            let found = admitted.closest::<Everything>(&ray).expect("there is a floor");
            assert_eq!(found.object, lists.closest::<Everything>(&ray).expect("there is a floor").object);
            floor += usize::from(found.object == Object::Floor);
        }
        assert!(firsts == 24 && floor > 0, "{firsts} objects, {floor} of three times the floor");
    }
}

#[test]
fn of_equally_near_things_the_first_in_order_is_seen() {
    ties::<Q16>();
    ties::<Q20>();
    ties::<f32>();
    ties::<f64>();
}

/// Returns so many glasses in a row along the y axis, of all kinds in turn, each of which lets another part through.
fn glasses(count: u32) -> Description {
    let mut scene = empty();
    for i in 0..count {
        let kt = 1.0 - 0.37 / (f64::from(i) + 1.7);
        let (surface, color, line) = (Surface::Transparent { ks: 1.0 - kt, kt, ior: 1.5 }, COLOR, 0);
        let y = 3.0 * f64::from(i) + 4.0;
        match i % 5 {
            0 => {
                let vertices = [[-1.0, y, 0.0], [1.0, y, 0.0], [0.0, y, 3.0]];
                scene.triangles.push(Triangle {
                    vertices,
                    normals: None,
                    one_sided: false,
                    color,
                    surface,
                    line,
                });
            }
            1 => scene.spheres.push(Sphere { position: [0.1, y, 1.0], radius: 0.7, color, surface, line }),
            2 => scene.cones.push(Cone {
                base: [0.1, y, 0.2],
                base_radius: 0.6,
                apex: [0.1, y, 2.2],
                apex_radius: 0.4,
                capped: true,
                inside_only: false,
                color,
                surface,
                line,
            }),
            3 => {
                let (position, radii) = ([0.1, y, 1.0], [0.5, 0.8, 0.6]);
                scene.ellipsoids.push(Ellipsoid {
                    position,
                    radii,
                    inside_only: false,
                    color,
                    surface,
                    line,
                });
            }
            _ => {
                scene.cylinders.push(Cylinder { position: [0.1, y, 0.0], radius: 0.5, color, surface, line });
            }
        }
    }
    let position = [0.0, 3.0 * f64::from(count) + 9.0, 1.0];
    scene.lamps.push(Lamp { position, color: [100.0; 3], radius: 0.0, fall_off: FallOff::OfModel, line: 0 });
    scene
}

/// Compares what comes through, and returns whether another order would have brought another product.
fn row<S: Narrow>(count: u32) -> bool {
    let scene = glasses(count);
    let narrowed = narrow::<S>(&scene, 1.0).expect("it fits");
    let lists = narrowed.admit().expect("it fits");
    let (origin, direction, length) =
        aim::<S>(scene.camera.eye, scene.lamps.first().expect("there is one").position).expect("it is away");
    let (ray, t_max) = (lists.ray::<Everything>(origin, direction), S::length(length));
    let mut parts = Vec::new();
    lists.scene.looks(|_, look| {
        parts.extend(lists.scene.material(look.material).glass::<Everything>().map(|glass| glass.kt))
    });
    let product = |parts: &[S::Unit]| parts.iter().fold(S::Unit::ONE, |all, part| all.times(*part));
    let right = product(&parts);
    assert_eq!(parts.len(), usize::try_from(count).expect("few"));
    assert!(lists.transmittance::<Everything>(&ray, t_max, 0) == right, "{count} glasses in {}", S::NAME);
    for seed in 0..8 {
        let built = if seed == 0 { over_spheres::<S>(&scene) } else { over_all::<S>(&scene, seed) };
        let Some(bvh) = built.bvh() else { continue };
        let admitted = narrowed.scene().admit_with(&narrowed.camera, bvh).expect("it is right");
        let found = admitted.transmittance::<Everything>(&ray, t_max, 0);
        assert!(found == right, "{count} glasses in {}, order {seed}", S::NAME);
    }
    let mut turned = parts;
    turned.reverse();
    product(&turned) != right
}

#[test]
fn what_comes_through_glasses_in_a_row_is_multiplied_in_order() {
    // Up to seven are kept and sorted; of more, the lists are gone through.
    let mut differ = 0;
    for count in 1..=14 {
        differ += usize::from(row::<Q16>(count));
        differ += usize::from(row::<Q20>(count));
        differ += usize::from(row::<f32>(count));
        differ += usize::from(row::<f64>(count));
    }
    assert!(differ > 10, "in only {differ} rows the order makes a difference");
}
