//! Packets that were built for another scene: things may not be seen, but nothing else happens.

use rta_core::needs::Everything;
use rta_core::raster::{Pixels, Raster};
use rta_core::trace::Tracer;
use rta_core::{Q16, illumination::Rta};
use rta_packets::{Packets, Rows, ToF32};
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrow, narrow};

use crate::scenes::clusters;

fn draw<S: Narrow + ToF32 + Rows>(scene: &Description, other: &Description) {
    let Ok(narrowed) = narrow::<S>(scene, 1.0) else { return };
    let packets = Packets::build::<S>(other);
    let Ok(admitted) = narrowed.scene().admit_with(&narrowed.camera, &packets) else { return };
    let tracer: Tracer<S, _, Everything, 32, _> = Tracer::new(&admitted, Rta, 3).expect("a depth");
    let raster = Raster::new(46, 10).expect("a raster");
    assert_eq!(Pixels::new(&tracer, &narrowed.camera, raster).count(), 460);
    let mut pixels = 0;
    S::trace_rows(&tracer, &narrowed.camera, (raster, rta_scenes::sampler::Sampler::CENTER), (0, 10), |_| {
        pixels += 1
    });
    assert_eq!(pixels, 460);
}

#[test]
fn packets_of_another_scene_do_no_harm() {
    let empty = Description::empty(clusters(0).camera);
    for seed in 0..20 {
        let (scene, other) = (clusters(seed), clusters(seed + 1));
        draw::<f32>(&scene, &other);
        draw::<Q16>(&scene, &other);
        draw::<f32>(&scene, &empty);
        draw::<f32>(&empty, &scene);
    }
}
