//! Pictures by cones against exact ones and against pictures of many rays; and where they are wrong, by how much.
#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::sampling::{Places, Sobol};
use rta_core::trace::dice::Sample;
use rta_packets::ShadowCache;
use rta_packets::picture::{Format, Picture, PictureError, Setup};
use rta_scenes::description::Description;
use rta_scenes::sampler::{Integrator, Lamps, Sampler, Spreading};

use super::Coned;

fn scene(text: &str) -> Description {
    rta_scenes::read(format!("rta 1\n{text}").as_bytes(), "a scene.rta").expect("it is one")
}

fn setup(width: u32, height: u32, sampling: Sampler) -> Setup {
    let raster = Raster::new(width, height).expect("small");
    Setup { raster, aspect: f64::from(width) / f64::from(height), depth: 5, cutoff: None, sampling }
}

fn coned(text: &str, (width, height): (u32, u32)) -> Coned {
    let scene = scene(text);
    Coned::new(&scene, scene.model, setup(width, height, Sampler::Cones)).expect("cones know it")
}

fn rays(text: &str, (width, height): (u32, u32), samples: u32, lamps: Lamps) -> Box<dyn Picture<f64>> {
    let scene = scene(text);
    let samples = Sobol::new(samples, 5).expect("few");
    let spreading = Spreading { samples, lamps, split: 1, integrator: Integrator::Whitted };
    let setup = setup(width, height, Sampler::Sobol(spreading));
    f64::picture(&scene, scene.model, &setup).expect("it fits")
}

fn light(picture: &(impl Picture<f64> + ?Sized)) -> Vec<Rgb<f64>> {
    let mut all = Vec::new();
    picture.rows(0, u32::MAX, &mut |row| all.extend_from_slice(row));
    all
}

/// The green light of a picture of one pixel by a cone, and by 16,384 rays.
fn one_pixel(text: &str) -> [f64; 2] {
    let cone = light(&coned(text, (1, 1)))[0].g;
    let rays = light(&*rays(text, (1, 1), 16_384, Lamps::Point))[0].g;
    [cone, rays]
}

/// Root of the mean square of the difference, over all registers.
fn rms(one: &[Rgb<f64>], other: &[Rgb<f64>]) -> f64 {
    let square = |a: f64, b: f64| (a - b) * (a - b);
    let sums = one.iter().zip(other).map(|(a, b)| square(a.r, b.r) + square(a.g, b.g) + square(a.b, b.b));
    (sums.sum::<f64>() / (3.0 * one.len() as f64)).sqrt()
}

/// The part of a cap of the half angle `a` that one of `b` covers, whose axis is `c` away: ring by ring.
fn cap(a: f64, b: f64, c: f64) -> f64 {
    let rings = 20_000;
    let (mut all, mut covered) = (0.0, 0.0);
    for ring in 0..rings {
        let angle = a * (f64::from(ring) + 0.5) / f64::from(rings);
        let cosine = (b.cos() - angle.cos() * c.cos()) / (angle.sin() * c.sin());
        all += angle.sin();
        covered += angle.sin() * cosine.clamp(-1.0, 1.0).acos() / core::f64::consts::PI;
    }
    covered / all
}

const BALL: &str = "\
model flat
camera at 0 0 0  look 0 1 0  lens 1.5
sky black
ambient white
sphere at .3 8 .2  radius 1.5  color white
";

#[test]
fn a_sphere_alone_covers_what_it_does() {
    let (width, height) = (40, 40);
    let picture = coned(BALL, (width, height));
    let all = light(&picture);
    let center = rta_core::vector::Vec3::<f64>::new(0.3, 8.0, 0.2);
    let other = (1.5 / center.length()).asin();
    let (mut edges, mut sum) = (0, 0.0);
    for (i, light) in (0..).zip(&all) {
        let row = Places::row::<f64>(&Sampler::CENTER, picture.setup().raster, i / width);
        let place = Sampler::CENTER.place(picture.setup().raster, row, i % width, 0);
        let beam = picture.eye(picture.setup().raster, place);
        let apart = (beam.axis.dot(center) / center.length()).clamp(-1.0, 1.0).acos();
        let exact = cap(beam.angle, other, apart);
        assert!((light.g - exact).abs() < 4e-4, "{i}: {}, {exact}", light.g);
        edges += u32::from(exact > 0.01 && exact < 0.99);
        sum += light.g;
    }
    assert!(edges > 50, "{edges}");
    // On the image plane it is an ellipse, and pixels about its middle are as large as their discs.
    let off = (center.y / center.length()).acos();
    let area = core::f64::consts::PI * other.sin().powi(2) * off.cos()
        / (off.cos().powi(2) - other.sin().powi(2)).powf(1.5);
    let pixels = area * (1.5 * f64::from(width)).powi(2);
    assert!((sum / pixels - 1.0).abs() < 0.02, "{sum} {pixels}");
}

const MANY: &str = "\
camera at 0 -7 2.4  to 0 0 .8  lens 1.4
sky horizon .6 .65 .75  zenith .15 .3 .65
ambient grey .2
floor .8 .8 .8  .2 .2 .3
lamp at -4 -6 8  power 45  square
sphere at -1.4 0 1  radius 1  of mirror  color .9 .9 .9
sphere at 1.2 -.5 .9  radius .9  of crown
sphere at .2 2.5 .6  radius .6  color .8 .2 .1
sphere at -.2 -2.5 .3  radius .3  of shiny  color .2 .7 .3
polygon -4 4 0  4 4 0  4 4 3  -4 4 3  of mirror  color .7 .7 .7
";

#[test]
fn cones_without_extent_are_rays() {
    let reference = rays(MANY, (4, 4), 1, Lamps::Point);
    let mut worst = Vec::new();
    for side in [64, 2048, 65_535] {
        let picture = coned(MANY, (side, side));
        let mut sum = 0.0;
        let mut other = 0;
        for i in 0..400u32 {
            // Places on a lattice that is aslant to everything.
            let place = [0.754_877_666, 0.569_840_291].map(|step: f64| (f64::from(i) * step).fract() - 0.5);
            let (place, own) = ((place[0], place[1]), Sample { x: 0, y: 0, number: 0 });
            let cone = picture.sample(place, own, &mut ShadowCache::default(), &mut ());
            let ray = reference.sample(place, own, &mut ShadowCache::default(), &mut ());
            let error = rms(&[cone], &[ray]);
            sum += error / 400.0;
            other += u32::from(error > 1e-3);
        }
        worst.push((sum, other));
    }
    assert!(worst[0].0 > 4.0 * worst[1].0 && worst[1].0 > 4.0 * worst[2].0, "{worst:?}");
    assert!(worst[2].0 < 5e-4 && worst[2].1 <= 6, "{worst:?}");
}

/// The error of a picture by cones, and of one by one ray a pixel, beside 256 rays a pixel.
fn errors(text: &str, lamps: Lamps) -> [f64; 2] {
    let size = (48, 36);
    let exact = light(&*rays(text, size, 256, lamps));
    [rms(&light(&coned(text, size)), &exact), rms(&light(&*rays(text, size, 1, lamps)), &exact)]
}

#[test]
fn pictures_are_near_to_those_of_many_rays() {
    let [cones, one] = errors(MANY, Lamps::Point);
    assert!(cones < 0.5 * one, "{cones} {one}");
}

const PIXEL: &str = "\
model flat
camera at 0 0 0  look 0 1 0  lens 20
sky white
ambient white
";

#[test]
fn two_things_count_as_if_by_chance() {
    let with = |things: &str| one_pixel(&format!("{PIXEL}{things}"));
    // Half of the pixel, and the same half once more behind it.
    let [cone, rays] = with("sphere at -100 200 0  radius 100  color black\n");
    assert!((cone - 0.5).abs() < 0.02 && (cone - rays).abs() < 0.01, "{cone} {rays}");
    let [cone, rays] = with(
        "sphere at -100 200 0  radius 100  color black\nsphere at -150 300 0  radius 150  color black\n",
    );
    assert!((cone - 0.25).abs() < 0.02, "{cone}: a product");
    assert!((rays - 0.5).abs() < 0.02, "{rays}");
    // Two faces that meet in the middle: of two things, and of one.
    let left = "-9 50 -9  0 50 -9  0 50 9";
    let [cone, rays] = with(&format!(
        "polygon {left} -9 50 9  color black\npolygon 0 50 -9  9 50 -9  9 50 9  0 50 9  color black\n"
    ));
    assert!((cone - 0.25).abs() < 1e-9, "{cone}: light leaks");
    assert!(rays < 1e-9, "{rays}");
    let [cone, rays] = with("polygon -9 50 -9  9 50 -9  9 50 9  -9 50 9  color black\n");
    assert!(cone < 1e-9 && rays < 1e-9, "{cone} {rays}");
    // A closed body: its front hides its back.
    let [cone, rays] = with("box from -9 50 -9  to 0 60 9  color black\n");
    assert!((cone - 0.5).abs() < 1e-6 && (cone - rays).abs() < 1e-3, "{cone} {rays}");
    // A thing on another, and the same in the other order.
    let [cone, rays] = with(
        "sphere at -100 200 0  radius 100  color black\npolygon -40 400 -40  40 400 -40  40 400 40  -40 400 40  color .5 .5 .5\n",
    );
    assert!((cone - 0.25).abs() < 0.02 && (cone - rays).abs() < 0.01, "{cone} {rays}");
}

#[test]
fn a_wall_stands_on_the_floor_within_a_pixel() {
    // The axis meets the floor before the wall; where rays meet both, the wall is before the floor.
    let [cone, rays] = one_pixel(
        "model flat\ncamera at 0 0 1  look 0 20 -1.1  lens 20\nsky white\nambient white\nfloor white white\n\
         polygon -9 20 0  9 20 0  9 20 9  -9 20 9  color black\n",
    );
    assert!((rays - 0.6).abs() < 0.01, "{rays}");
    assert!((cone - rays).abs() < 0.02, "{cone} {rays}");
}

#[test]
fn what_cones_do_not_know_is_refused() {
    let refused = |things: &str| {
        let scene = scene(&format!("{PIXEL}{things}"));
        let found = Coned::new(&scene, scene.model, setup(4, 4, Sampler::Cones)).err();
        found.map(|error| error.to_string()).expect("it is refused")
    };
    assert!(refused("sphere at 0 5 0  radius 1  color white  moves 1 0 0\n").contains("move"));
    let scene = scene(BALL);
    let found = f64::picture(&scene, scene.model, &setup(4, 4, Sampler::Cones)).err();
    assert_eq!(found, Some(PictureError::Cones("pictures of rays")));
}
