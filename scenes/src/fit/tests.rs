use super::{Fitted, FloorError, fit, missing};
use crate::description::{Cylinder, Description, Ellipsoid, FallOff, Model, Surface};
use crate::narrow::narrow;
use crate::{Format, in_format, nff, read, shipped};

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
    scene.lamps.iter_mut().for_each(|lamp| (lamp.radius, lamp.fall_off) = (2.0, FallOff::OfModel));
    scene
}

#[test]
fn lengths_are_scaled_and_nothing_else() {
    for (model, brighter) in [(Model::Rta, 0.25), (Model::Phong, 1.0)] {
        let mut expected = scene(model);
        expected.optics.hither = Some(0.5);
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

/// Returns whether a format admits a scene.
fn admits(scene: &Description, format: Format) -> bool {
    in_format!(format, S => narrow::<S>(scene, 1.0)
        .is_ok_and(|narrowed| narrowed.admit().is_ok()))
}

/// Returns the factor by which a scene is scaled, 1 where it is best as it is and none where no scale helps, and the bits that are
/// gained. Sees that the scene is scaled by it, that it is admitted and, where it is scaled, that none is that is twice as large.
fn factor(scene: &Description, format: Format) -> (Option<f64>, Option<f64>) {
    let fitted = fit(scene, scene.model, format, admits(scene, format), |scene| admits(scene, format))
        .expect("it has no floor");
    let (factor, gain) = match fitted {
        Fitted::AsItIs => return (Some(1.0), None),
        Fitted::Never => return (None, None),
        Fitted::Scaled { factor, scene: scaled, gain } => {
            assert_eq!(Ok(*scaled), scene.clone().scaled(factor));
            (factor, gain)
        }
    };
    let by = |factor| scene.clone().scaled(factor).expect("it has no floor");
    assert!(admits(&by(factor), format), "{format}: {factor}");
    assert!(!admits(&by(2.0 * factor), format), "{format}: {factor} is not the largest");
    (Some(factor), gain)
}

#[test]
fn the_factor_is_the_largest_that_is_admitted() {
    for model in [Model::Phong, Model::Rta] {
        // A world of every size, of which nothing is as far as 24 from the origin.
        for exponent in -90..90 {
            let size = 2_f64.powi(exponent) * 1.1;
            let world = scene(model).scaled(size).expect("it has no floor");
            for format in [Format::Q16, Format::Q20] {
                let (factor, gain) = factor(&world, format);
                let factor = factor.expect("a scale helps");
                let steps = (factor * size * 20.0 / format.step().expect("fixed point")).log2();
                // Where lamps are attenuated, their limit is reached before that of lengths.
                assert!((20.0..31.0).contains(&steps), "{model:?}, {format}, {size}: 2^{steps} steps");
                let is_admitted = admits(&world, format);
                assert_eq!(gain.is_some(), is_admitted && factor > 1.0, "{format}, {size}");
                assert!(factor >= 1.0 || !is_admitted, "{format}, {size}");
            }
        }
    }
}

#[test]
fn a_scene_with_enough_steps_is_left_as_it_is() {
    let world = |size: f64| scene(Model::Phong).scaled(size).expect("it has no floor");
    // It is some 20 across.
    for (format, coarse, fine) in [(Format::Q16, 1.0, 4.0), (Format::Q20, 0.0625, 0.25)] {
        let (larger, gain) = factor(&world(coarse), format);
        assert!(larger > Some(64.0) && gain.is_some_and(|gain| (1.0..2.0).contains(&gain)), "{gain:?}");
        assert_eq!(factor(&world(fine), format), (Some(1.0), None));
        assert!(missing(&world(fine), format) <= 0.0);
    }
    let (_, gain) = factor(&world(1.0 / 1024.0), Format::Q16);
    assert!(gain.is_some_and(|gain| (11.0..12.0).contains(&gain)), "{gain:?}");
    let (_, gain) = factor(&world(1e-9), Format::Q16);
    assert_eq!(gain, None, "it is not admitted as it is");
}

#[test]
fn floats_are_scaled_only_where_they_must() {
    for (size, admitted) in [(1e-9, true), (1.0, true), (1e9, true), (1e30, false)] {
        let (factor, gain) = factor(&scene(Model::Phong).scaled(size).expect("no floor"), Format::F32);
        assert_eq!((factor == Some(1.0), gain), (admitted, None), "{size}");
    }
}

#[test]
fn few_proofs_tell_that_no_scale_helps() {
    let calls = core::cell::Cell::new(0);
    let admits = |_: &Description| {
        calls.set(calls.get() + 1);
        false
    };
    assert_eq!(fit(&scene(Model::Phong), Model::Phong, Format::Q16, false, admits), Ok(Fitted::Never));
    assert!((2..10).contains(&calls.get()), "{} proofs", calls.get());
}

#[test]
fn no_scale_helps_a_color() {
    let mut scene = scene(Model::Phong);
    scene.spheres.iter_mut().for_each(|sphere| sphere.color = [9.0; 3]);
    for format in [Format::Q16, Format::Q20] {
        assert_eq!(factor(&scene, format), (None, None));
    }
}

#[test]
fn a_floor_cannot_be_scaled() {
    let scene = read(shipped::GLASS_2.as_bytes(), "glass-2.dat").expect("it ships");
    assert_eq!(fit(&scene, scene.model, Format::Q16, true, |_| false), Ok(Fitted::AsItIs));
    assert_eq!(fit(&scene, scene.model, Format::Q16, false, |_| true), Err(FloorError));
    assert_eq!(scene.scaled(0.5), Err(FloorError));
}
