//! Rays that are spread: pictures of scenes with all that spreads are, to the last bit, those that are traced one ray and one object after
//! the other; those to which samples are added are those that have them from the beginning.

use std::sync::Arc;

use rta_core::Q16;
use rta_core::accelerator::Lists;
use rta_core::color::Rgb;
use rta_core::needs::Everything;
use rta_core::raster::{Pixels, Raster};
use rta_core::sampling::{Places, Sobol};
use rta_core::trace::{Distributed, Tracer};
use rta_packets::agreement::Agreement;
use rta_packets::picture::{Added, Format, Pass, Picture, Setup};
use rta_scenes::description::Description;
use rta_scenes::model::Model;
use rta_scenes::narrow::narrow;
use rta_scenes::sampler::{Integrator, Lamps, Sampler, Spreading};
use rta_scenes::shading::any_model;
use rta_scenes::shipped;
use rta_scenes::solution::{Arriving, Shown, Solution, Solved, patch_count};

use crate::scenes::clusters;

/// Pixels of a side: not all samples of a row have three others beside them.
const SIDE: u32 = 23;
/// Recursion depth.
const DEPTH: u32 = 4;

const LAMPS: [Lamps; 4] = [Lamps::Area, Lamps::Fixed(2), Lamps::Point, Lamps::Cone];

/// A lens, lamps that are balls and a parallelogram, one about the eye, rough metal and glass, faces that are mixed, a coat.
const ALL: &str = "rta 1
model whitted
camera at 0 -7 2  to 0 0 .8  lens 1.4  aperture .3
sky horizon .8 .87 .97  zenith .15 .3 .65
ambient grey .2
material plate like mirror  roughness .2
material pane  specular .3 transmit .7 diffuse 0 index 1.5  roughness .1
material clear  specular .2 transmit .8 diffuse 0 index 1.5
floor .9 .9 .9  .2 .2 .25
lamp at -5 -6 8  radius 1.5  power 60  square
lamp at 0 -7 2  radius 1  power 3  square
lamp corner 3 -3 5  edges 2 0 0  0 2 .5  power 30  square
sphere at 0 0 .8  radius .8  color .9 .25 .15
sphere at 1.6 .5 .8  radius .8  of plate
sphere at -1.1 -3 .4  radius .4  of pane
sphere at -1.8 .5 .9  radius .9  of clear
triangle -3 2 0  3 2 0  0 2.2 4  color .3 .5 .9
";

fn raster() -> Raster {
    Raster::new(SIDE, SIDE).expect("a raster")
}

/// Checks the picture of a scene by rows, and as samples that are added in passes.
fn compare<S: Format>(scene: &Description, model: Model, spreading: Spreading, name: &str) -> bool {
    let sampling = Sampler::Sobol(spreading);
    let setup = Setup { raster: raster(), aspect: 1.0, depth: DEPTH, cutoff: None, sampling };
    let Ok(picture) = S::picture(scene, model, &setup) else { return false };
    let mut narrowed = narrow::<S>(scene, 1.0).expect("it has a picture");
    let limits = narrowed.admit().expect("it has a picture").limits;
    narrowed.solve(scene, limits).expect("it has a picture");
    let admitted = narrowed.scene().admit_with(&narrowed.camera, Lists).expect("it fits");
    let shade = any_model(model, &scene.air, &narrowed, admitted.limits);
    let tracer: Tracer<S, _, Everything, 32> = Tracer::new(&admitted, shade, DEPTH).expect("a depth");
    let (samples, spread) = (spreading.samples, narrowed.spread(&spreading));
    let tracer = Distributed { tracer, spread: &spread, seed: samples.seed() };
    let right: Vec<_> = Pixels::sampled(&tracer, &narrowed.camera, raster(), samples, 0, SIDE).collect();
    let mut rows = Vec::new();
    picture.rows(0, SIDE, &mut |row| rows.extend_from_slice(row));
    assert!(rows == right, "{name} in {}", S::NAME);
    assert!(in_passes(&*picture, samples) == right, "{name} in {}, in passes", S::NAME);
    true
}

/// Returns the picture whose samples are added: one, then two more, then the rest; of every third pixel, then of the others.
fn in_passes<S: Format>(picture: &dyn Picture<S>, samples: Sobol) -> Vec<Rgb<S::Light>> {
    let pixels: Vec<_> = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| [x, y])).collect();
    let mut sums = vec![(Rgb::BLACK, Agreement::default()); pixels.len()];
    let all = samples.samples();
    for (first, end) in [(0, 1), (1, 3), (3, all)] {
        let (first, end) = (first.min(all), end.min(all));
        let Some(pass) = Sobol::new(end, samples.seed()).filter(|_| first < end) else { continue };
        for is_third in [true, false] {
            let some = sums.iter_mut().zip(&pixels).enumerate();
            let some = some.filter(|(index, _)| (index % 3 == 0) == is_third);
            let mut some = some.map(|(_, ((sum, agreement), place))| Added {
                place: *place,
                sum,
                agreement: Some(agreement),
            });
            picture.add(Pass { samples: pass, first }, &mut some);
        }
    }
    assert!(sums.iter().all(|(_, agreement)| agreement.samples() == all), "each sample is told of");
    sums.into_iter().map(|(sum, _)| samples.mean(sum)).collect()
}

fn spreading(samples: u32, lamps: Lamps, split: u16) -> Spreading {
    let samples = Sobol::new(samples, 0x5eed ^ samples).expect("few");
    Spreading { samples, lamps, split, integrator: Integrator::Whitted }
}

/// Checks scenes in one number format: that with all that spreads, by every way to ask lamps, and some random ones.
fn all<S: Format>(random: u64) {
    let scene = rta_scenes::read(ALL.as_bytes(), "all.rta").expect("it is one");
    for (lamps, (samples, split)) in LAMPS.into_iter().zip([(4, 1), (3, 1), (1, 1), (2, 1)]) {
        assert!(compare::<S>(&scene, scene.model, spreading(samples, lamps, split), "all"), "{}", S::NAME);
    }
    let mut bright = scene.clone();
    bright.air = "warnock".parse().expect("air");
    for (model, split) in [(Model::Lambert, 4), (Model::Phong, 1), (Model::Rta, 3)] {
        assert!(compare::<S>(&bright, model, spreading(2, Lamps::Area, split), "in air"), "{}", S::NAME);
    }
    let drawn = (0..random).filter(|&seed| {
        let mut scene = clusters(seed);
        // Every lamp has a size, some of them larger than the way to what they light.
        scene.lamps.iter_mut().for_each(|lamp| lamp.radius = lamp.radius.max(0.2) * 3.0);
        scene.optics.aperture = (seed % 2 == 0).then_some(0.05);
        let model = *Model::ALL.iter().cycle().nth(usize::try_from(seed).expect("small")).expect("models");
        let split = if seed % 4 == 0 { 3 } else { 1 };
        compare::<S>(&scene, model, spreading(5, Lamps::Area, split), &format!("scene {seed}"))
    });
    assert!(drawn.count() as u64 >= random / 2, "few scenes fit {}", S::NAME);
}

#[test]
fn spread_pictures_are_the_same_in_floating_point() {
    all::<f32>(40);
    all::<f64>(4);
}

#[test]
fn spread_pictures_are_the_same_in_fixed_point() {
    all::<Q16>(8);
}

#[test]
fn meshes_and_solved_light_are_the_same() {
    let read = |text: &str| rta_scenes::read(text.as_bytes(), "scene.rta").expect("it is one");
    for text in [shipped::MESH, shipped::TECHNIQUES, shipped::CORNELL] {
        let mut scene = read(text);
        scene.lamps.iter_mut().for_each(|lamp| lamp.radius = lamp.radius.max(0.3));
        let title = text.lines().nth(1).unwrap_or_default();
        assert!(compare::<f32>(&scene, scene.model, spreading(4, Lamps::Area, 2), title), "{title}");
        assert!(compare::<f32>(&scene, scene.model, spreading(2, Lamps::Cone, 1), title), "{title}");
    }
    let room = read(shipped::CORNELL);
    let arriving = Arriving { direct: [0.0; 3], indirect: [0.1, 0.2, 0.3] };
    let arriving = vec![arriving; patch_count(&room.meshed(None).quads)];
    let solution = Solution { patches: None, arriving };
    let lit = room.lit_by(&Arc::new(Solved { shown: Shown::Indirect, solution }));
    assert!(compare::<f32>(&lit, lit.model, spreading(4, Lamps::Area, 1), "a room with solved light"));
    assert!(compare::<Q16>(&lit, lit.model, spreading(4, Lamps::Area, 1), "a room with solved light"));
}
