//! Error and rays of whole pictures beside those of samples on a grid, and things that are smaller than a pixel.

use core::sync::atomic::{AtomicU64, Ordering};

use rta_core::Q16;
use rta_core::sampling::Sampling;
use rta_scenes::description::Description;
use rta_scenes::sampler::Sampler;
use rta_scenes::{dat, shipped};

use super::*;
use crate::picture::Format;

/// A picture whose rays from the eye are counted.
struct Counted<S: Narrow> {
    picture: Box<dyn Picture<S>>,
    rays: &'static AtomicU64,
}

impl<S: Narrow> Picture<S> for Counted<S> {
    fn rows(&self, first: u32, end: u32, put: PutRow<S>) {
        self.picture.rows(first, end, put);
    }

    fn preview_rows(&self, raster: Raster, first: u32, end: u32, put: PutRow<S>) {
        self.picture.preview_rows(raster, first, end, put);
    }

    fn sample(
        &self,
        place: (S::Unit, S::Unit),
        sample: Sample,
        cache: &mut ShadowCache,
        observer: &mut dyn Observer<S>,
    ) -> Rgb<S::Light> {
        self.rays.fetch_add(1, Ordering::Relaxed);
        self.picture.sample(place, sample, cache, observer)
    }

    fn setup(&self) -> &Setup {
        self.picture.setup()
    }

    fn scene(&self) -> &Narrowed<S> {
        self.picture.scene()
    }
}

fn setup((width, height): (u32, u32), sampling: Sampler) -> Setup {
    let raster = Raster::new(width, height).expect("small");
    Setup { raster, aspect: 4.0 / 3.0, depth: 5, cutoff: None, sampling }
}

fn lights<S: Narrow>(picture: &dyn Picture<S>) -> Vec<[f64; 3]> {
    let (mut lights, height) = (Vec::new(), picture.setup().raster.height());
    let light = |Rgb { r, g, b }: &Rgb<S::Light>| [*r, *g, *b].map(S::light_to_f64);
    picture.rows(0, height, &mut |row| lights.extend(row.iter().map(light)));
    lights
}

/// Draws a scene with so many samples along the side of a pixel.
fn sampled<S: Format>(scene: &Description, size: (u32, u32), side: u8) -> Vec<[f64; 3]> {
    let sampling = Sampler::Grid(Sampling::grid(side).expect("small"));
    let picture = S::picture(scene, scene.model, &setup(size, sampling)).expect("it fits");
    lights(&*picture)
}

/// Draws a scene with adaptive antialiasing, and returns its rays a pixel too.
fn antialiased<S: Format>(scene: &Description, size: (u32, u32), adaptive: Adaptive) -> (Vec<[f64; 3]>, f64) {
    let picture = S::picture(scene, scene.model, &setup(size, Sampler::CENTER)).expect("it fits");
    let rays: &'static AtomicU64 = Box::leak(Box::new(AtomicU64::new(0)));
    let single = Box::new(Counted { picture, rays });
    let picture = Antialiased::new(single, setup(size, Sampler::Adaptive(adaptive)), adaptive);
    let lights = lights(&picture);
    #[expect(clippy::cast_precision_loss, reason = "few")]
    let rays = rays.load(Ordering::Relaxed) as f64 / lights.len() as f64;
    (lights, rays)
}

/// Returns the root of the mean square of the differences of two pictures.
fn rms(one: &[[f64; 3]], other: &[[f64; 3]]) -> f64 {
    let squares =
        one.as_flattened().iter().zip(other.as_flattened()).map(|(one, other)| (one - other).powi(2));
    #[expect(clippy::cast_precision_loss, reason = "few")]
    let n = one.as_flattened().len() as f64;
    (squares.sum::<f64>() / n).sqrt()
}

fn shipped_scene(name: &str) -> Description {
    let (_, text) = shipped::ALL.iter().find(|(known, _)| *known == name).expect("a shipped scene");
    dat::read(text.as_bytes(), name).expect("it is one")
}

/// Returns the error of each way beside that of 16 samples a pixel, and its rays beside those; `truth` is the number of samples along the side of
/// a pixel of what all are compared with.
fn beside_a_grid(name: &str, size: (u32, u32), truth: u8, ways: &[Adaptive]) -> Vec<[f64; 2]> {
    let scene = shipped_scene(name);
    let truth = sampled::<f32>(&scene, size, truth);
    let grid = rms(&sampled::<f32>(&scene, size, 4), &truth);
    let of = |&adaptive: &Adaptive| {
        let (picture, rays) = antialiased::<f32>(&scene, size, adaptive);
        let (error, rays) = (rms(&picture, &truth) / grid, rays / 16.0);
        println!("{name} {size:?}, {adaptive:?}: {error:.3} of the error, {rays:.3} of the rays");
        [error, rays]
    };
    ways.iter().map(of).collect()
}

#[test]
fn errors_are_those_of_many_more_rays() {
    let ways = [Adaptive::Whitted(Cutting::default()), Adaptive::Mitchell];
    for (name, most) in
        [("juggler.dat", [[1.03, 0.43], [1.24, 0.34]]), ("hall-22.dat", [[1.21, 0.46], [1.64, 0.32]])]
    {
        for (got, [most_error, most_rays]) in beside_a_grid(name, (160, 100), 16, &ways).into_iter().zip(most)
        {
            assert!(got[0] < most_error && got[1] < most_rays, "{name}: {got:?}");
        }
    }
}

/// What host/README.md tells, of the screens of the thesis among others.
#[test]
#[ignore = "takes minutes: cargo test --release -p rta-packets -- --ignored --nocapture displays"]
fn errors_on_displays_are_those_of_a_quarter_of_the_rays() {
    let cutting = |depth| Adaptive::Whitted(Cutting::new(depth, Cutting::TOLERANCE).expect("not deep"));
    let ways = [cutting(2), cutting(3), Adaptive::Mitchell];
    for (size, truth) in [((320, 200), 32), ((640, 400), 32), ((1152, 900), 20)] {
        for name in ["juggler.dat", "hall-22.dat"] {
            let [error, rays] = beside_a_grid(name, size, truth, &ways).first().copied().expect("a way");
            // Of 320 x 200 pixels too many lie on an edge.
            let most_rays = if size.0 < 640 { 0.32 } else { 0.25 };
            assert!(error < 1.1 && rays < most_rays, "{name} {size:?}: {error}, {rays}");
        }
    }
}

#[test]
fn an_object_smaller_than_a_pixel_is_seen() {
    // Off the corners of the pixels; its radius is a third of a pixel's side.
    let text = "rta 1\ncamera at 0 0 0  look 0 1 0\nsky black\nambient white\n\
                sphere at 0.4 20 0.4  radius .3  color white\n";
    let scene = rta_scenes::read(text.as_bytes(), "a scene.rta").expect("it is one");
    let size = (20, 20);
    let truth = sampled::<Q16>(&scene, size, 32);
    let brightest = |picture: &[[f64; 3]]| picture.iter().map(|light| light[1]).fold(0.0, f64::max);
    let (cut, _) = antialiased::<Q16>(&scene, size, Adaptive::Whitted(Cutting::default()));
    let error = rms(&cut, &truth);
    assert!(brightest(&truth) > 0.0 && brightest(&cut) > 0.0, "{} {}", brightest(&truth), brightest(&cut));
    assert!(error < 0.5 * rms(&vec![[0.0; 3]; cut.len()], &truth), "{error}");
}

#[test]
fn rows_do_not_depend_on_where_they_begin() {
    let scene = shipped_scene("juggler.dat");
    for adaptive in [Adaptive::Whitted(Cutting::default()), Adaptive::Mitchell] {
        let setup = setup((80, 50), Sampler::Adaptive(adaptive));
        let picture = Q16::picture(&scene, scene.model, &setup).expect("it fits");
        let (mut whole, mut parts) = (Vec::new(), Vec::new());
        picture.rows(0, 50, &mut |row| whole.extend_from_slice(row));
        for first in (0..50).step_by(7) {
            picture.rows(first, first + 7, &mut |row| parts.extend_from_slice(row));
        }
        assert!(whole == parts, "{adaptive:?}");
    }
}
