//! Wherever eye and lamps are, light buffers hide nothing, and neither do rays that are searched for four by four: pictures of
//! random scenes are, to the last bit of light, those that are traced one ray and one object after the other, with the model behind
//! a pointer.

use rta_core::accelerator::Lists;
use rta_core::color::Rgb;
use rta_core::needs::Everything;
use rta_core::raster::{Pixels, Raster};
use rta_core::sampling::{Center, Places};
use rta_core::trace::Tracer;
use rta_core::trace::dice::Sample;
use rta_core::{Q16, Q20};
use rta_packets::ShadowCache;
use rta_packets::picture::{Format, Setup};
use rta_scenes::description::Air;
use rta_scenes::model::Model;
use rta_scenes::narrow::{Narrowed, narrow};
use rta_scenes::sampler::Sampler;
use rta_scenes::shading::any_model;

use crate::scenes::clusters;

/// Scenes of each number format.
const SCENES: u64 = 60;
/// Pixels of a side: not all rays of a row have three others beside them.
const SIDE: u32 = 46;
/// Recursion depth.
const DEPTH: u32 = 3;

fn raster() -> Raster {
    Raster::new(SIDE, SIDE).expect("a raster")
}

/// Returns the picture, traced one ray and one object after the other.
fn listed<S: Format>(scene: &Narrowed<S>, (model, air): (Model, Air)) -> Vec<Rgb<S::Light>> {
    let admitted = scene.scene().admit_with(&scene.camera, Lists).expect("it fits");
    let tracer: Tracer<S, _, Everything, 32> =
        Tracer::new(&admitted, any_model(model, &air, scene, admitted.limits), DEPTH).expect("a depth");
    Pixels::new(&tracer, &scene.camera, raster()).collect()
}

fn compare<S: Format>() {
    let mut drawn = 0;
    for seed in 0..SCENES {
        let mut scene = clusters(seed);
        // Every model with every air, in some scene.
        let airs = ["none", "warnock", "romney:2:1.5", "haze:1:40", "fog:.1:.2:.3"];
        scene.air = airs
            .iter()
            .cycle()
            .nth(usize::try_from(seed).expect("small"))
            .map_or(Air::default(), |text| text.parse().expect("air"));
        let setup =
            Setup { raster: raster(), aspect: 1.0, depth: DEPTH, cutoff: None, sampling: Sampler::CENTER };
        let model = Model::ALL.iter().cycle().nth(usize::try_from(seed / 3).expect("small"));
        let model = *model.expect("there are models");
        let Ok(picture) = S::picture(&scene, model, &setup) else { continue };
        let narrowed = narrow::<S>(&scene, 1.0).expect("it has a picture");
        let right = listed::<S>(&narrowed, (model, scene.air));
        let (mut single, mut rows) = (Vec::new(), Vec::new());
        let mut cache = ShadowCache::default();
        for y in 0..SIDE {
            let row = Center.row::<S::Unit>(raster(), y);
            for x in 0..SIDE {
                let own = Sample { x, y, number: 0 };
                single.push(picture.sample(Center.place(raster(), row, x, 0), own, &mut cache, &mut ()));
            }
        }
        picture.rows(0, SIDE, &mut |row| rows.extend_from_slice(row));
        assert!(single == right, "scene {seed} in {}", S::NAME);
        assert!(rows == right, "scene {seed} in {}, as whole rows", S::NAME);
        drawn += 1;
    }
    assert!(drawn > 30, "only {drawn} scenes fit {}", S::NAME);
}

#[test]
fn pictures_are_the_same_in_floating_point() {
    compare::<f32>();
    compare::<f64>();
}

#[test]
fn pictures_are_the_same_in_fixed_point() {
    compare::<Q16>();
    compare::<Q20>();
}
