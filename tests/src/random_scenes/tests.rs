use super::{all, crowd};
use crate::oracle::render;
use rta_scenes::dat;
use rta_scenes::description::Surface;

#[test]
fn they_are_the_same_each_time_and_pass_through_a_file() {
    for ((name, scene), (_, again)) in all().into_iter().zip(all()) {
        assert_eq!(scene, again, "{name}");
        let text = scene.to_dat().expect("it has a floor");
        let read = dat::read(text.as_bytes(), name).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(read.without_lines(), scene);
    }
    assert_ne!(crowd(1), crowd(2));
}

#[test]
fn between_them_they_hold_every_type_of_every_primitive() {
    let kind = |surface: &Surface| match surface {
        Surface::Opaque => 0,
        Surface::Shiny => 1,
        Surface::Mirror => 2,
        Surface::Transparent { ior, .. } if *ior < 1.0 => 4,
        Surface::Transparent { .. } => 3,
        Surface::Finish { .. } | Surface::Of(_) => 5,
    };
    let mut seen = std::collections::BTreeSet::new();
    for (_, scene) in all() {
        seen.extend(scene.cylinders.iter().map(|object| (0, kind(&object.surface))));
        seen.extend(scene.ellipsoids.iter().map(|object| (1, kind(&object.surface))));
        seen.extend(scene.spheres.iter().map(|object| (2, kind(&object.surface))));
    }
    assert_eq!(seen.len(), 15, "{seen:?}");
}

#[test]
fn they_are_of_moderate_size_and_brightness() {
    for (name, scene) in all() {
        let places = scene.spheres.iter().map(|object| object.position);
        let places = places.chain(scene.ellipsoids.iter().map(|object| object.position));
        let places = places.chain(scene.cylinders.iter().map(|object| object.position));
        let mut places = places.chain(scene.lamps.iter().map(|lamp| lamp.position)).chain([scene.camera.eye]);
        assert!(places.all(|place| place.iter().all(|part| part.abs() <= 50.0)), "{name}");
        let picture = render(&scene, 80, 60, 4.0 / 3.0, 5);
        let mean = picture.iter().flatten().map(|part| part.min(1.0)).sum::<f64>() / (80.0 * 60.0 * 3.0);
        let full = picture.iter().flatten().filter(|part| **part >= 1.0).count();
        assert!((0.15..0.75).contains(&mean), "{name}: mean {mean}");
        assert!(full < 80 * 60 * 3 / 5, "{name}: {full} registers are full");
    }
}
