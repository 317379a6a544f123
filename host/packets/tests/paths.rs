//! Paths that are followed side by side are those that are followed one after the other, to the last bit.

use rta_core::color::Rgb;
use rta_core::raster::{Places, Raster};
use rta_core::sampling::{Sobol, Uncut};
use rta_core::trace::dice::Sample;
use rta_packets::ShadowCache;
use rta_packets::picture::{Added, Format, Pass, Picture, Setup};
use rta_scenes::sampler::{Integrator, Lamps, Sampler, Spreading};

const SIZE: u32 = 23;

fn picture(text: &str, samples: Sobol, (bounces, is_cut): (u8, bool)) -> Box<dyn Picture<f32>> {
    let scene = rta_scenes::read(text.as_bytes(), "room.rta").expect("a scene");
    let integrator = Integrator::Paths { bounces, is_cut };
    let sampling = Sampler::Sobol(Spreading { samples, lamps: Lamps::Area, split: 1, integrator });
    let raster = Raster::new(SIZE, SIZE).expect("small");
    let setup = Setup { raster, aspect: 1.0, depth: 5, cutoff: None, sampling };
    f32::picture(&scene, scene.model, &setup).expect("it fits")
}

/// The light of all pixels, of which each sample is traced by itself.
fn one_by_one(picture: &dyn Picture<f32>, samples: Sobol, is_cut: bool) -> Vec<Rgb<f32>> {
    let (raster, mut cache) = (picture.setup().raster, ShadowCache::default());
    let pixels = (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| (x, y)));
    let light = pixels.map(|(x, y)| {
        let mut sum = Rgb::BLACK;
        for number in 0..samples.samples() {
            let place = samples.place::<f32>(raster, y, x, number);
            let light = picture.sample(place, Sample { x, y, number }, &mut cache, &mut ());
            sum = if is_cut { samples.add(sum, light) } else { Uncut(samples).add(sum, light) };
        }
        samples.mean(sum)
    });
    light.collect()
}

/// Compares the rows of a room, and passes over its pixels.
fn compare(text: &str, samples: u32, (bounces, is_cut): (u8, bool)) {
    let samples = Sobol::new(samples, 7).expect("few");
    let picture = picture(text, samples, (bounces, is_cut));
    let want = one_by_one(&*picture, samples, is_cut);
    let mut got = Vec::new();
    picture.rows(0, SIZE, &mut |row| got.extend_from_slice(row));
    assert_eq!(got, want, "{bounces} bounces in {text}");
    assert!(got.iter().any(|light| light.r > 0.0), "{text}");
    // Row by row, and the samples in two passes.
    let mut rows = Vec::new();
    for y in (0..SIZE).rev() {
        picture.rows(y, y + 1, &mut |row| rows.push(row.to_vec()));
    }
    rows.reverse();
    assert_eq!(rows.concat(), want);
    let mut sums = vec![Rgb::BLACK; want.len()];
    let half = Sobol::new((samples.samples() / 2).max(1), 7).expect("few");
    for (samples, first) in [(half, 0), (samples, half.samples())] {
        let places = (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| [x, y]));
        let mut pixels = places.zip(&mut sums).map(|(place, sum)| Added { place, sum, agreement: None });
        picture.add(Pass { samples, first }, &mut pixels);
    }
    let means: Vec<_> = sums.into_iter().map(|sum| samples.mean(sum)).collect();
    assert_eq!(means, want);
}

const HEAD: &str = "rta 1\ncamera at 0 -1.9 1  look 0 1 0  lens .8\nmodel lambert\n\
                    material bright  emits 2 2 2\nmaterial dull  diffuse .5\n";
const BOX: &str = "box from -1 -2 0  to 1 1 2  inside  color .7 .6 .5\n";
const LAMP: &str = "quad -.5 -.5 1.9  -.5 .5 1.9  .5 .5 1.9  .5 -.5 1.9  color .5 .5 .5  of bright\n";
const SECOND: &str = "quad -.9 -.5 .5  -.9 -.5 .9  -.9 -.1 .9  -.9 -.1 .5  color .5 .5 .5  of bright\n";

#[test]
fn a_room_with_one_lamp() {
    for bounces in [0, 1, 2, 64] {
        for is_cut in [false, true] {
            compare(&format!("{HEAD}{BOX}{LAMP}"), 8, (bounces, is_cut));
        }
    }
    compare(&format!("{HEAD}{BOX}{LAMP}"), 1, (64, false));
}

#[test]
fn a_room_with_several_lamps_and_things() {
    let blocks = "box from -.6 -.2 0  to -.1 .4 .8  color .3 .8 .3  of dull\n\
                  box from .1 -.6 0  to .6 -.1 .5  color .9 .9 .9\n";
    compare(&format!("{HEAD}{BOX}{LAMP}{SECOND}{blocks}"), 8, (64, false));
    compare(&format!("{HEAD}{BOX}{LAMP}{SECOND}lamp at .3 -.5 1.2  power .5\n{blocks}"), 8, (64, true));
}

#[test]
fn triangles_under_the_sky() {
    let sky = "sky horizon .8 .9 1  zenith .2 .3 .7\n";
    let few =
        "triangle -2 -1 0  2 -1 0  0 3 0  color .5 .6 .7\ntriangle -1 1 0  1 1 0  0 1 2  color .9 .2 .1\n";
    compare(&format!("{HEAD}{sky}{few}{LAMP}"), 8, (64, false));
    // Two at one place.
    let same =
        "triangle -1 1 0  1 1 0  0 1 2  color .1 .2 .9\ntriangle -1 1 0  1 1 0  0 1 1.5  color .4 .9 .9\n";
    compare(&format!("{HEAD}{sky}{few}{same}{LAMP}"), 8, (64, false));
}

#[test]
fn the_cornell_box() {
    compare(rta_scenes::shipped::CORNELL, 4, (64, false));
}
