use rta_core::Q16;

use super::{FloorError, fit};
use crate::description::{Cylinder, Description, Ellipsoid, Model, Surface};
use crate::narrow::narrow;
use crate::{nff, read, shipped};

const SCENE: &str = "
v from 1 2 3 at 4 6 8 up 0 0 1 angle 45 hither 1 resolution 64 48
l 8 9 10 .5 1 2
f 1 .5 .25 .5 .5 3 .5 1.5
s 1 2 3 4
c 1 2 3 4 5 6 7 8
pp 3 1 2 3 0 0 1  4 5 6 0 1 0  9 8 7 1 0 0
";

/// The scene with what NFF has not.
fn scene(model: Model) -> Description {
    let mut scene = nff::read(SCENE.as_bytes(), "s.nff").expect("it is well formed");
    scene.model = model;
    let (position, color, surface) = ([1.0, 2.0, 3.0], [0.5; 3], Surface::Shiny);
    scene.cylinders = vec![Cylinder { position, color, radius: 4.0, surface, line: 1 }];
    scene.ellipsoids =
        vec![Ellipsoid { position, color, radii: [4.0, 5.0, 6.0], inside_only: false, surface, line: 1 }];
    scene.lamps.iter_mut().for_each(|lamp| lamp.radius = 2.0);
    scene
}

#[test]
fn lengths_are_scaled_and_nothing_else() {
    for (model, brighter) in [(Model::Rta, 0.25), (Model::Phong, 1.0)] {
        let mut expected = scene(model);
        expected.camera.eye = [0.5, 1.0, 1.5];
        for cylinder in &mut expected.cylinders {
            (cylinder.position, cylinder.radius) = ([0.5, 1.0, 1.5], 2.0);
        }
        for ellipsoid in &mut expected.ellipsoids {
            (ellipsoid.position, ellipsoid.radii) = ([0.5, 1.0, 1.5], [2.0, 2.5, 3.0]);
        }
        for sphere in &mut expected.spheres {
            (sphere.position, sphere.radius) = ([0.5, 1.0, 1.5], 2.0);
        }
        for cone in &mut expected.cones {
            (cone.base, cone.base_radius, cone.apex, cone.apex_radius) =
                ([0.5, 1.0, 1.5], 2.0, [2.5, 3.0, 3.5], 4.0);
        }
        for triangle in &mut expected.triangles {
            triangle.vertices = [[0.5, 1.0, 1.5], [2.0, 2.5, 3.0], [4.5, 4.0, 3.5]];
        }
        for lamp in &mut expected.lamps {
            (lamp.position, lamp.radius) = ([4.0, 4.5, 5.0], 1.0);
            lamp.color = [0.5, 1.0, 2.0].map(|register| register * brighter);
        }
        assert_eq!(scene(model).scaled(0.5), Ok(expected), "{model:?}");
    }
}

#[test]
fn the_factor_is_the_nearest_to_one() {
    let scene = scene(Model::Phong);
    let radius = |scene: &Description| scene.spheres.iter().map(|sphere| sphere.radius).sum::<f64>();
    for (least, most, factor) in [
        (3.0, 5.0, Some(1.0)),
        (0.0, 3.9, Some(0.5)),
        (4.1, 1e9, Some(2.0)),
        (0.0, 0.001, Some(1.0 / 4096.0)),
        (5000.0, 1e9, Some(2048.0)),
        (4.1, 7.9, None),
        (1e13, 1e99, None),
        (0.0, 1e-13, None),
    ] {
        let fits = |scene: &Description| (least..=most).contains(&radius(scene));
        assert_eq!(fit(&scene, fits), Ok(factor), "{least} to {most}");
    }
    // As near on both sides.
    assert_eq!(fit(&scene, |scene| (radius(scene) - 4.0).abs() > 1.0), Ok(Some(0.5)));
    let (ends, scale) = ([-40, 40], |exponent| 4.0 * 2_f64.powi(exponent));
    for end in ends {
        let fits = |scene: &Description| (radius(scene) / scale(end) - 1.0).abs() < 1e-9;
        assert_eq!(fit(&scene, fits), Ok(Some(2_f64.powi(end))));
    }
}

#[test]
fn a_scene_of_a_large_world_fits_fixed_point() {
    let large = scene(Model::Phong).scaled(1e5).expect("it has no floor");
    let fits = |scene: &Description| narrow::<Q16>(scene, 1.0).is_ok();
    let factor = fit(&large, fits).expect("it has no floor").expect("it is not that large");
    assert!(factor < 1.0 && fits(&large.clone().scaled(factor).expect("no floor")), "{factor}");
    assert!(!fits(&large.scaled(factor * 2.0).expect("no floor")), "{factor}");
}

#[test]
fn a_floor_cannot_be_scaled() {
    let scene = read(shipped::GLASS_2.as_bytes(), "glass-2.dat").expect("it ships");
    assert_eq!(fit(&scene, |_| true), Ok(Some(1.0)));
    assert_eq!(fit(&scene, |_| false), Err(FloorError));
    assert_eq!(scene.scaled(0.5), Err(FloorError));
}
