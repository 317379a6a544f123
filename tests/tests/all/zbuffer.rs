//! The core's Z-buffer draws what the tracer draws, to the last bit: all shipped scenes and random ones, in all formats.

use rta_core::illumination::Rta;
use rta_core::needs::Everything;
use rta_core::raster::{Pixels, Raster};
use rta_core::trace::Tracer;
use rta_core::zbuffer::{Told, ZBuffer};
use rta_core::{Error, Q16, Q20};
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrow, narrow};
use rta_scenes::shipped;
use rta_tests::random_scenes;

/// Compares both pictures of a scene, and returns whether the format can hold it.
fn is_drawn<S: Narrow>(name: &str, scene: &Description) -> bool {
    let Ok(narrowed) = narrow::<S>(scene, 4.0 / 3.0) else { return false };
    let Ok(admitted) = narrowed.scene().admit(&narrowed.camera) else { return false };
    let (raster, camera) = (Raster::new(80, 60).expect("a raster"), &narrowed.camera);
    let told = Told::of(&admitted);
    let buffer = ZBuffer::<S, _, Everything, 4, 80>::new(&told, Rta, 1, raster);
    let tracer = Tracer::<S, _, Everything, 4>::new(&admitted, Rta, 1);
    let (buffer, tracer) = (buffer.expect("a row of 80"), tracer.expect("a depth"));
    let pairs = Pixels::new(&buffer, camera, raster).zip(Pixels::new(&tracer, camera, raster));
    let apart = pairs.filter(|(own, traced)| own != traced).count();
    assert_eq!(apart, 0, "pixels of {name} in {}", S::NAME);
    true
}

#[test]
fn pictures_are_those_of_the_tracer() {
    let mut scenes = random_scenes::all();
    let read = |text: &str, name| rta_scenes::read(text.as_bytes(), name).expect("a scene");
    scenes.extend(shipped::FILES.map(|(name, text)| (name, read(text, name))));
    let mut drawn = 0;
    for (name, scene) in &scenes {
        drawn += usize::from(is_drawn::<Q16>(name, scene));
        drawn += usize::from(is_drawn::<Q20>(name, scene));
        drawn += usize::from(is_drawn::<f32>(name, scene));
        drawn += usize::from(is_drawn::<f64>(name, scene));
    }
    assert!(drawn > 3 * scenes.len(), "only {drawn} of {} scenes in four formats", scenes.len());
}

#[test]
fn a_row_that_is_too_long_is_refused() {
    let scene = rta_tests::exact::shipped_scene("juggler");
    let narrowed = narrow::<Q16>(&scene, 4.0 / 3.0).expect("it fits");
    let admitted = narrowed.scene().admit(&narrowed.camera).expect("it fits");
    let told = Told::of(&admitted);
    let raster = Raster::new(81, 60).expect("a raster");
    let buffer = ZBuffer::<Q16, _, Everything, 4, 80>::new(&told, Rta, 1, raster);
    assert_eq!(buffer.err(), Some(Error::Raster { width: 81, height: 60 }));
}
