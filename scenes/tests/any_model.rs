//! A model behind a pointer draws the pictures of the model itself.

use rta_core::Q16;
use rta_core::illumination::{Illumination, Phong, Rta, Whitted};
use rta_core::prelude::*;
use rta_scenes::narrow::{Narrowed, narrow};
use rta_scenes::shading::any_model;
use rta_scenes::{Model, read, shipped};

fn drawn(scene: &Narrowed<Q16>, model: impl Illumination<Q16>) -> Vec<Rgb<u8>> {
    let admitted = scene.admit().expect("it fits");
    let tracer: Tracer<_, _, Everything, 5, _> = Tracer::new(&admitted, model, 3).expect("a stack of five");
    let raster = Raster::new(96, 48).expect("small");
    Pixels::new(&tracer, &scene.camera, raster).map(|light| light.levels(255)).collect()
}

/// A triangle whose corners face a lamp that is behind it: not lit, though the light is mixed from that of its corners.
const LIT_FROM_BEHIND: &str = "rta 1
camera at 0 -5 1  look 0 1 0  lens 1
ambient grey .1
lamp at 0 2 6  power 75
triangle -1 0 0  1 0 0  0 0 2  color 1 1 1  normals 0 -1 1  0 -1 1  0 -1 1  gouraud
";

#[test]
fn a_model_behind_a_pointer_draws_the_same_picture() {
    let scenes =
        [("mesh.rta", shipped::MESH), ("glass-2.dat", shipped::GLASS_2), ("lit.rta", LIT_FROM_BEHIND)];
    for (name, text) in scenes {
        let described = read(text.as_bytes(), name).expect("a scene");
        let scene = narrow::<Q16>(&described, 2.0).expect("it fits");
        let limits = scene.admit().expect("it fits").limits;
        let any = |model| drawn(&scene, any_model(model, &described.air, &scene, limits));
        assert!(drawn(&scene, Phong::default()) == any(Model::Phong), "phong, {name}");
        assert!(drawn(&scene, Whitted::default()) == any(Model::Whitted), "whitted, {name}");
        assert!(drawn(&scene, Rta) == any(Model::Rta), "rta, {name}");
    }
}
