//! What the range proof says of weights and of vertical cylinders.

use rta::engine::{Engine, Format};
use rta_core::Q16;
use rta_core::accelerator::Lists;
use rta_core::range::Quantity;
use rta_core::scene::Object;
use rta_scenes::description::{Camera, Cylinder, Description, Sky, Sphere, Surface};
use rta_scenes::narrow::{Narrow, narrow};
use rta_tests::picture::{render, settings, share_within};

/// Returns two mirrors face to face, the eye between them, that send back `part` of the light.
fn mirrors(part: f64) -> Description {
    let camera = Camera::upright([0.0, 0.0, 0.3], [0.0, 1.0, 0.0], 1.0);
    let sphere = |y| Sphere {
        position: [0.0, y, 0.0],
        radius: 400.0,
        color: [part; 3],
        surface: Surface::Mirror,
        line: 0,
    };
    let mut scene = Description::empty(camera);
    scene.spheres = vec![sphere(405.0), sphere(-405.0)];
    scene.sky = Sky { horizon: [0.3; 3], zenith: [0.1, 0.2, 0.4] };
    scene
}

#[test]
fn a_weight_is_bounded_at_the_depth_of_the_ray() {
    let scene = mirrors(1.1);
    let drawn = |format, depth| render(&scene, &rta::engine::Settings { depth, ..settings(format) });
    let (fixed, truth) =
        (drawn(Format::Q16, 7).expect("1.1^7 fits"), drawn(Format::F64, 7).expect("it fits"));
    let share = share_within(&fixed, &truth, 1.0 / 63.0);
    assert!(share > 99.5, "{share} %");
    // Rays of depth 7 are seen.
    let shallow = drawn(Format::F64, 6).expect("it fits");
    assert!(share_within(&shallow, &truth, 1.0 / 63.0) < 99.0, "no ray is as deep");
    let refused = drawn(Format::Q16, 8).expect_err("1.1^8 is more than 2").to_string();
    assert!(
        refused.starts_with("sphere 1 ") && refused.contains("weight of a ray at depth 8 2.14"),
        "{refused}"
    );
}

/// Returns the greatest depth of the rays between two such mirrors.
fn depth<S: Narrow>(part: f64) -> u8 {
    let narrowed = narrow::<S>(&mirrors(part), 1.0).expect("it fits");
    narrowed.admit().expect("it is admitted").limits.depth
}

#[test]
fn depths_are_those_of_the_largest_weight() {
    for (part, fixed, float) in [
        (0.9, 255, 255),
        (1.0, 255, 255),
        (1.0 + 2e-6, 255, 255),
        (1.02, 35, 255),
        (1.1, 7, 255),
        (1.2, 3, 227),
        (1.5, 1, 102),
        (1.99, 1, 60),
    ] {
        assert_eq!((depth::<Q16>(part), depth::<f32>(part)), (fixed, float), "{part}");
    }
}

#[test]
fn a_reflectance_is_that_of_the_colour_and_of_its_coefficient() {
    let scene = |kd: f64| Description {
        ambient: [1.0; 3],
        spheres: mirrors(1.5)
            .spheres
            .into_iter()
            .map(|sphere| Sphere { surface: finish(kd), ..sphere })
            .collect(),
        ..mirrors(1.5)
    };
    let drawn = |kd| render(&scene(kd), &settings(Format::Q16));
    assert!(drawn(1.3).is_ok(), "1.5 times 1.3 fits");
    let refused = drawn(1.4).expect_err("1.5 times 1.4 is more than 2").to_string();
    assert!(refused.starts_with("sphere 1 ") && refused.contains("reflectance 2.1"), "{refused}");
}

/// Returns a diffuse surface.
const fn finish(kd: f64) -> Surface {
    Surface::Finish { kd, ks: 0.0, exponent: 1.0, kt: 0.0, ior: 1.0 }
}

#[test]
fn the_height_at_which_cylinders_end_is_a_row() {
    let row = |scene: &Description| {
        let narrowed = narrow::<Q16>(scene, 1.0).expect("it fits");
        let proof = narrowed.scene().prove(&narrowed.camera, &Lists);
        let row = proof.bounds.into_iter().find(|row| row.quantity == Quantity::CylinderEnd);
        row.map(|row| (row.bound.to_string(), row.object, row.holds())).expect("there is one")
    };
    let mut scene = mirrors(0.9);
    assert_eq!(row(&scene), ("0".to_owned(), None, true));
    let (position, color, surface) = ([3.0, 5.0, 0.0], [0.5; 3], Surface::Opaque);
    scene.cylinders = vec![Cylinder { position, color, radius: 1.0, surface, line: 0 }];
    assert_eq!(row(&scene), ("8192".to_owned(), Some(Object::Cylinder(0)), true));
    assert!(Engine::new(&scene, &settings(Format::Q16)).is_ok());
}
