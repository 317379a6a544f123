//! The variances of a pixel: of the place on the lamp, and of all else; and how often to split.

use rta_core::color::Rgb;
use rta_core::sampling::Sobol;
use rta_scenes::sampler::{Integrator, Lamps, Sampler, Spreading};

use super::{Scene, Setup};
use crate::study::error::StudyError;

/// Pictures by which the variances are told.
pub const SEEDS: u32 = 16;

/// Places on a lamp whose mean stands for that of all.
pub const PLACES: u16 = 64;

/// Shadow rays more by which the time of one is told.
const MORE: u16 = 16;

/// The variances of one sample of a pixel, as the mean over all pixels and registers of a picture, and what its rays cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variances {
    /// Of the place on the lamps, where the ray from the eye ends.
    pub lamp: f64,
    /// Of all else: the place in the pixel, on the lens, the time, and lobes.
    pub pixel: f64,
    /// What a sample costs in rays.
    pub rays: Costs,
    /// What it costs in CPU seconds.
    pub seconds: Costs,
}

/// What a sample costs, as the mean over all pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Costs {
    /// All but the shadow rays that a split adds.
    pub eye: f64,
    /// The shadow rays to the lamps from the eye's own hit, one to each.
    pub shadow: f64,
}

impl Costs {
    /// Tells the costs apart of pictures whose samples are split once, and `split` times.
    fn told_apart(once: f64, often: f64, split: f64) -> Self {
        let shadow = (often - once).max(0.0) / (split - 1.0);
        Self { eye: (once - shadow).max(0.0), shadow }
    }
}

impl Variances {
    /// Returns how many shadow rays to a lamp, from each point that the eye sees, make the least error for a cost:
    /// `sqrt(lamp eye / (pixel shadow))`. With `N` samples the squared error is `(pixel + lamp / S) / N` and the cost `N (eye + S shadow)`.
    /// It is infinite where nothing but the lamp varies, and no number where nothing does.
    #[must_use]
    pub fn best_split(&self, costs: Costs) -> f64 {
        (self.lamp * costs.eye / (self.pixel * costs.shadow)).sqrt()
    }
}

/// Measures the variances of a scene by pictures of one sample with independent seeds, each with one place on a lamp and with the mean
/// of many: both see the same points, so that the one differs from the other by the lamp alone.
pub(super) fn measured(scene: &Scene, setup: Setup) -> Result<Variances, StudyError> {
    let split = |seed, split| {
        let spreading =
            |samples| Spreading { samples, lamps: Lamps::Area, split, integrator: Integrator::Whitted };
        let sampling = Sobol::new(1, seed).map(spreading).map(Sampler::Sobol);
        scene.engine(sampling.unwrap_or(Sampler::CENTER))
    };
    let (mut sums, mut squares) = (vec![Rgb::<f64>::default(); scene.pixels()], 0.0);
    let mut lamp = 0.0;
    for seed in 0..SEEDS {
        setup.go_on()?;
        let (one, _) = scene.traced(&split(seed, 1)?);
        let (mean, _) = scene.traced(&split(seed, PLACES)?);
        for ((one, mean), sum) in one.into_iter().zip(mean).zip(&mut sums) {
            let (one, mean) = (one.map(f64::from), mean.map(f64::from));
            lamp += square(one.zip(mean, |one, mean| one - mean));
            squares += square(mean);
            *sum = sum.zip(mean, |sum, mean| sum + mean);
        }
    }
    let (seeds, registers) = (f64::from(SEEDS), 3.0 * count(scene.pixels()));
    let of_means = sums.into_iter().map(square).sum::<f64>() / seeds;
    let engines = [split(0, 1)?, split(0, 2)?, split(0, 1 + MORE)?];
    let [once, twice, _] = engines.each_ref().map(|engine| engine.rays().iter().sum::<u64>());
    let [first, _, often] = engines.each_ref().map(|engine| scene.traced(engine).1);
    let pixels = count(scene.pixels());
    Ok(Variances {
        lamp: lamp / (seeds * registers),
        pixel: ((squares - of_means) / ((seeds - 1.0) * registers)).max(0.0),
        rays: Costs::told_apart(rays(once) / pixels, rays(twice) / pixels, 2.0),
        seconds: Costs::told_apart(first / pixels, often / pixels, f64::from(1 + MORE)),
    })
}

fn square(light: Rgb<f64>) -> f64 {
    light.r * light.r + light.g * light.g + light.b * light.b
}

#[allow(clippy::cast_precision_loss)] // below 2^53
fn count(pixels: usize) -> f64 {
    pixels as f64
}

#[allow(clippy::cast_precision_loss)] // below 2^53
fn rays(count: u64) -> f64 {
    count as f64
}
