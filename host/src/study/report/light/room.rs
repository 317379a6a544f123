//! A room ready to be drawn by every method, and its picture of converged paths.

use core::sync::atomic::AtomicBool;
use std::sync::Arc;

use cpu_time::ThreadTime;
use rayon::ThreadPool;
use rta_args::radiosity;
use rta_core::color::Rgb;
use rta_core::sampling::{Sampling, Sobol};
use rta_scenes::description::Description;
use rta_scenes::sampler::{Integrator, Lamps, Sampler, Spreading, is_spectral};
use rta_scenes::solution::{Arriving, Shown, Solution, Solved, patch_count};

use super::method::{Method, Solving};
use crate::engine::radiosity::{self as solver, RadiosityError};
use crate::engine::{Cutoff, Engine, Format, Settings, bands};
use crate::picture::error::PictureError;
use crate::picture::raster::Size;
use crate::request::error::RequestError;
use crate::request::sampler::BOUNCES;
use crate::study::error::StudyError;
use crate::study::report::Source;
use crate::study::report::measure::Difference;
use crate::study::report::study::failed;

/// Recursion depth where the scene states none.
const DEPTH: u32 = 5;

/// Seed of the reference. Those of the pictures that are compared with it are 0.
const REFERENCE_SEED: u32 = 0x5eed;

/// Samples by which a pixel is found in which something that emits is seen.
const SEEING: u32 = 64;

/// A room.
pub struct Room<'a> {
    source: &'a Source,
    scene: Description,
    settings: Settings,
    size: Size,
}

/// A solution of a room, and what it took.
#[derive(Clone, Debug)]
pub struct Light {
    /// What arrives at the patches.
    pub solution: Solution,
    /// Rays.
    pub rays: u64,
    /// CPU seconds on one thread.
    pub seconds: f64,
}

/// The picture of converged paths.
#[derive(Clone, Debug)]
pub struct Reference {
    /// Linear light, not cut.
    pub light: Vec<Rgb<f32>>,
    /// Of each pixel, whether it is compared: where something that emits is seen, its edge alone would decide, which is a matter of samples and
    /// not of how light goes round.
    pub compared: Vec<bool>,
    /// Its samples.
    pub samples: u32,
    /// Its own error, as its scrambles estimate it.
    pub error: f64,
}

impl<'a> Room<'a> {
    /// Makes a room ready for pictures of so many pixels on a screen of such a shape.
    ///
    /// # Errors
    /// [`RequestError::Spectral`] and [`RequestError::Moving`] for a scene that paths are not for, and [`RadiosityError::NoLight`] for one in
    /// which no quad emits.
    pub fn new(source: &'a Source, (size, aspect): (Size, f64)) -> Result<Self, StudyError> {
        let description = &source.scene.description;
        if is_spectral(description) {
            return Err(RequestError::Spectral("--light").into());
        }
        if description.has_motion() {
            return Err(RequestError::Moving.into());
        }
        if !description.has_emitters() {
            return Err(unsolved(source)(RadiosityError::NoLight));
        }
        let settings = Settings {
            width: size.width(),
            height: size.height(),
            aspect,
            format: Format::F32,
            model: description.model,
            depth: description.settings.depth.unwrap_or(DEPTH),
            cutoff: Cutoff::of(&description.settings),
            sampling: Sampler::CENTER,
        };
        Ok(Self { source, scene: description.clone(), settings, size })
    }

    /// Returns the tracer of a method with so many samples, in a room with solved light if there is some.
    ///
    /// # Errors
    /// [`RequestError::Engine`].
    pub fn engine(
        &self,
        (method, samples): (Method, u32),
        light: Option<&Arc<Solved>>,
    ) -> Result<Engine, StudyError> {
        let sampling = match method {
            Method::Ambient => u8::try_from(samples.isqrt()).ok().and_then(Sampling::grid).map(Sampler::Grid),
            Method::Radiosity => sobol(samples, 0, Lamps::Point, Integrator::Whitted),
            Method::Distributed | Method::TwoPasses | Method::Cache => {
                sobol(samples, 0, Lamps::Area, Integrator::Whitted)
            }
            Method::Paths => sobol(samples, 0, Lamps::Area, PATHS),
        };
        let lit = light.map(|light| self.scene.lit_by(light));
        self.engine_of(lit.as_ref().unwrap_or(&self.scene), sampling.unwrap_or(Sampler::CENTER))
    }

    fn engine_of(&self, scene: &Description, sampling: Sampler) -> Result<Engine, StudyError> {
        let settings = Settings { sampling, ..self.settings.clone() };
        Engine::new(scene, &settings).map_err(failed(self.source))
    }

    /// Returns the light of a picture, and the CPU seconds that it takes on this thread.
    #[must_use]
    pub fn drawn(&self, engine: &Engine) -> (Vec<Rgb<f32>>, f64) {
        let mut light = vec![Rgb::default(); self.size.pixels()];
        let ((), seconds) = timed(|| engine.linear_rows(0, &mut light));
        (light, seconds)
    }

    /// Returns of each pixel whether nothing that emits is seen in it: where no light arrives and the sky is black, all else is.
    fn is_dark(&self) -> Result<Vec<bool>, StudyError> {
        let mut scene = self.scene.clone();
        (scene.sky.horizon, scene.sky.zenith) = ([0.0; 3], [0.0; 3]);
        let dark = Arriving { direct: [0.0; 3], indirect: [0.0; 3] };
        let arriving = vec![dark; patch_count(&scene.meshed(None).quads)];
        let light = Solved { shown: Shown::All, solution: Solution { patches: None, arriving } };
        let sampling = sobol(SEEING, REFERENCE_SEED, Lamps::Point, Integrator::Whitted);
        let engine = self.engine_of(&scene.lit_by(&Arc::new(light)), sampling.unwrap_or(Sampler::CENTER))?;
        Ok(self.drawn(&engine).0.iter().map(|light| *light == Rgb::default()).collect())
    }

    /// Returns the picture of so many paths a pixel.
    ///
    /// # Errors
    /// [`BandsError`](bands::BandsError) and [`PictureError::Memory`].
    pub fn reference(
        &self,
        samples: u32,
        (pool, stop): (&ThreadPool, &AtomicBool),
    ) -> Result<Reference, StudyError> {
        let sampling = sobol(samples, REFERENCE_SEED, Lamps::Area, PATHS);
        let engine = self.engine_of(&self.scene, sampling.unwrap_or(Sampler::CENTER))?;
        let mut passes = engine.passes().ok_or(PictureError::Memory(self.size))?;
        while passes.samples() < samples {
            passes.pass(samples, pool, stop, None, &|_| {}).map_err(bands::BandsError::from)?;
        }
        let mut light = vec![Rgb::default(); self.size.pixels()];
        passes.linear_rows(0, &mut light);
        Ok(Reference { light, compared: self.is_dark()?, samples, error: passes.error() })
    }

    /// Solves for the light of the room. `None` where a quad emits in a part that holds the middle of none of its patches.
    ///
    /// # Errors
    /// [`StudyError::Radiosity`].
    pub fn solved(&self, solving: Solving, stop: &AtomicBool) -> Result<Option<Light>, StudyError> {
        let Solving { patches, factors } = solving;
        let settings = solver::Settings {
            format: Format::F64,
            method: radiosity::Method::Gather,
            factors: Some(factors),
            patches,
            seed: 0,
            sweeps: None,
        };
        let start = ThreadTime::now();
        match solver::solve(&self.scene, &settings, stop) {
            Ok(solver::Solved { solution, rays, .. }) => {
                Ok(Some(Light { solution, rays, seconds: start.elapsed().as_secs_f64() }))
            }
            Err(RadiosityError::NoPatch(_)) => Ok(None),
            Err(error) => Err(unsolved(self.source)(error)),
        }
    }

    /// Gives the room the ambient light, register by register, that leaves the least error in a picture of distributed rays.
    ///
    /// # Errors
    /// [`RequestError::Engine`].
    pub fn suit_ambient(&mut self, reference: &Reference) -> Result<(), StudyError> {
        let mut picture = |ambient| {
            self.scene.ambient = [ambient; 3];
            let engine = self.engine((Method::Distributed, 16), None)?;
            Ok::<_, StudyError>(self.drawn(&engine).0)
        };
        // Little, so that no sample is cut.
        let part = 1.0 / 64.0;
        let (dark, lit) = (picture(0.0)?, picture(part)?);
        let mut sums = [[0.0; 2]; 3];
        let [dark, lit, light] = [&dark, &lit, &reference.light].map(|light| reference.only(light));
        for ((dark, lit), light) in dark.iter().zip(&lit).zip(&light) {
            let registers = [(dark.r, lit.r, light.r), (dark.g, lit.g, light.g), (dark.b, lit.b, light.b)];
            for ([products, squares], registers) in sums.iter_mut().zip(registers) {
                let (dark, lit, light) = registers;
                let [more, missing] = [lit - dark, light - dark].map(f64::from);
                *products += more * missing;
                *squares += more * more;
            }
        }
        let best =
            |[products, squares]: [f64; 2]| if squares > 0.0 { (products / squares).max(0.0) } else { 0.0 };
        self.scene.ambient = sums.map(|sums| part * best(sums));
        Ok(())
    }

    /// Returns the room's ambient light, linear RGB.
    #[must_use]
    pub const fn ambient(&self) -> [f64; 3] {
        self.scene.ambient
    }
}

impl Reference {
    /// Returns the pixels of a picture that are compared, cut to white.
    fn only(&self, light: &[Rgb<f32>]) -> Vec<Rgb<f32>> {
        let compared = light.iter().zip(&self.compared).filter(|(_, is_compared)| **is_compared);
        compared.map(|(light, _)| light.map(|register| register.min(1.0))).collect()
    }

    /// Returns the RMSE of a picture's light, each pixel cut to white, where nothing is seen that emits.
    #[must_use]
    pub fn error(&self, light: &[Rgb<f32>]) -> f64 {
        Difference::between(&self.only(light), &self.only(&self.light), 1.0 / 255.0).rmse
    }

    /// Returns the factor by which a picture's light comes nearest, and the RMSE that is left.
    #[must_use]
    pub fn scaled_error(&self, light: &[Rgb<f32>]) -> (f64, f64) {
        let (mut products, mut squares) = (0.0, 0.0);
        let registers = |light: &Rgb<f32>| [light.r, light.g, light.b].map(f64::from);
        for (own, right) in self.only(light).iter().zip(self.only(&self.light)) {
            for (own, right) in registers(own).into_iter().zip(registers(&right)) {
                products += own * right;
                squares += own * own;
            }
        }
        let factor = if squares > 0.0 { products / squares } else { 1.0 };
        #[allow(clippy::cast_possible_truncation)] // to the nearest
        let scaled: Vec<_> =
            light.iter().map(|light| light.map(|register| register * factor as f32)).collect();
        (factor, self.error(&scaled))
    }

    /// Returns the mean of all registers of its light that is compared.
    #[must_use]
    pub fn mean(&self) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for light in self.only(&self.light) {
            sum += [light.r, light.g, light.b].map(f64::from).iter().sum::<f64>();
            count += 3.0;
        }
        if count > 0.0 { sum / count } else { 0.0 }
    }
}

const PATHS: Integrator = Integrator::Paths { bounces: BOUNCES, is_cut: false };

fn sobol(samples: u32, seed: u32, lamps: Lamps, integrator: Integrator) -> Option<Sampler> {
    let samples = Sobol::new(samples, seed)?;
    Some(Sampler::Sobol(Spreading { samples, lamps, split: 1, integrator }))
}

/// Does something, and returns the CPU seconds that it takes on this thread.
pub(super) fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = ThreadTime::now();
    let done = work();
    (done, start.elapsed().as_secs_f64())
}

fn unsolved(source: &Source) -> impl Fn(RadiosityError) -> StudyError {
    |error| StudyError::Radiosity { scene: source.scene.source.clone(), source: error }
}
