//! A scene in one number format, ready to be traced with any setting on a part of its pixels.
//!
//! It is traced with the thesis's model alone, for which the scenes were made: every further model would take as many minutes
//! again, and the page tells of one model.

use core::time::Duration;

use cpu_time::ThreadTime;
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Rta};
use rta_core::needs::Everything;
use rta_core::raster::Raster;
use rta_core::sampling::Sampling;
use rta_core::scalar::Unit;
use rta_core::trace::Tracer;
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrow, Narrowed, narrow};

use super::setting::{DEPTHS, LIMITS, Limit, REFERENCE_DEPTH};
use super::tap::{self, Tap};
use crate::engine::tally::Rays;
use crate::engine::{EngineError, Format, MAX_DEPTH, in_format};
use crate::request::sampling::Cutoff;

/// Linear light of pixels, each register from 0 to 1.
pub type Picture = Vec<Rgb<f32>>;

/// Some of a raster's pixels, evenly spread: every `step`th of every `step`th row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lattice {
    raster: Raster,
    step: u32,
}

impl Lattice {
    /// Returns the lattice of all pixels.
    #[must_use]
    pub const fn all(raster: Raster) -> Self {
        Self { raster, step: 1 }
    }

    /// Returns the lattice of every `step`th pixel of every `step`th row, at least one pixel; a step of 0 counts as 1.
    #[must_use]
    pub fn every(raster: Raster, step: u32) -> Self {
        Self { raster, step: step.clamp(1, raster.width().min(raster.height())) }
    }

    /// Returns the rows of its pixels.
    fn rows(self) -> Vec<u32> {
        Self::side(self.raster.height(), self.step).collect()
    }

    /// Returns its pixels in row `y`.
    fn row(self, y: u32) -> impl Iterator<Item = (u32, u32)> {
        Self::side(self.raster.width(), self.step).map(move |x| (x, y))
    }

    fn side(pixels: u32, step: u32) -> impl Iterator<Item = u32> {
        (step / 2..pixels).step_by(step as usize)
    }

    /// Selects the values of its pixels from those of all pixels.
    #[must_use]
    pub fn select<T: Copy>(self, whole: &[T]) -> Vec<T> {
        let at = |(x, y): (u32, u32)| y as usize * self.raster.width() as usize + x as usize;
        let rows = Self::side(self.raster.height(), self.step);
        rows.flat_map(|y| self.row(y)).filter_map(|pixel| whole.get(at(pixel)).copied()).collect()
    }
}

/// The pictures of all limits, and the one without a limit, from one walk of the ray trees.
#[derive(Clone, Debug, Default)]
pub struct Pictures {
    /// The picture with each limit, in the order of [`Limit::all`], and its rays.
    pub limited: Vec<(Picture, Rays)>,
    /// The picture with the depth of the walk and without a cut-off.
    pub whole: Picture,
}

/// A scene in one number format.
pub trait Bench: Send + Sync {
    /// Returns the pictures of all limits at once. The depth of the walk is that of the reference if `deep`, else the greatest under
    /// test.
    ///
    /// # Errors
    /// [`EngineError::Core`] if the scene or the depth is refused.
    fn pictures(&self, sampling: Sampling, lattice: Lattice, deep: bool) -> Result<Pictures, EngineError>;

    /// Returns the picture of one setting, traced on all threads.
    ///
    /// # Errors
    /// [`EngineError::Core`] if the scene or the depth is refused.
    fn picture(&self, limit: Limit, sampling: Sampling, lattice: Lattice) -> Result<Picture, EngineError>;

    /// Traces the picture of one setting on the calling thread without keeping it, and returns the CPU time that it takes.
    ///
    /// # Errors
    /// [`EngineError::Core`] if the scene or the depth is refused.
    fn time(&self, limit: Limit, sampling: Sampling, lattice: Lattice) -> Result<Duration, EngineError>;
}

/// Makes a scene ready in a format, for a screen of the shape `aspect : 1`.
///
/// # Errors
/// [`EngineError`] if the scene does not fit the format.
pub fn bench(scene: &Description, aspect: f64, format: Format) -> Result<Box<dyn Bench>, EngineError> {
    fn ready<S: Narrow>(scene: &Description, aspect: f64) -> Result<Box<dyn Bench>, EngineError> {
        let narrowed = narrow::<S>(scene, aspect)?;
        narrowed.scene().admit(&narrowed.camera).map_err(rta_core::Error::from)?;
        Ok(Box::new(narrowed))
    }
    in_format!(format, S => ready::<S>(scene, aspect))
}

type Traced<'a, S, M> = Tracer<'a, S, M, Everything, { MAX_DEPTH as usize }>;

fn tracer<S: Narrow, M: Illumination<S>>(
    scene: &Narrowed<S>,
    model: M,
    limit: Limit,
) -> Result<Traced<'_, S, M>, EngineError> {
    let Limit { depth, cutoff } = limit;
    let admitted = scene.scene().admit(&scene.camera).map_err(rta_core::Error::from)?;
    let cutoff = S::Unit::ratio(cutoff.numerator(), cutoff.denominator());
    Ok(Tracer::new(admitted, model, depth)?.with_cutoff(cutoff))
}

impl<S: Narrow> Bench for Narrowed<S> {
    fn pictures(&self, sampling: Sampling, lattice: Lattice, deep: bool) -> Result<Pictures, EngineError> {
        let depth = if deep { REFERENCE_DEPTH } else { *DEPTHS.end() };
        let tracer = tracer(self, Tap(Rta), Limit { depth, cutoff: Cutoff::OFF })?;
        let row = |y| {
            let mut rays = [Rays::default(); LIMITS];
            let mut samples = Vec::new();
            let mut pixels = Vec::new();
            for (x, y) in lattice.row(y) {
                samples.clear();
                for (right, up) in sampling.places(lattice.raster, x, y) {
                    let direction = self.camera.direction(right, up);
                    samples.push(tap::sample(&mut rays, || tracer.primary(&self.camera, direction)));
                }
                let shown = |at| {
                    let light =
                        |sample: &tap::Limited<S::Light>| *sample.lights.get(at).unwrap_or(&sample.whole);
                    sampling.mean(samples.iter().map(light)).map(S::widen)
                };
                pixels.push(core::array::from_fn::<_, { LIMITS + 1 }, _>(shown));
            }
            (pixels, rays)
        };
        let rows: Vec<_> = lattice.rows().into_par_iter().map(row).collect();
        let picture = |at: usize| -> Picture {
            rows.iter()
                .flat_map(|(pixels, _)| pixels.iter().filter_map(|pixel| pixel.get(at).copied()))
                .collect()
        };
        let rays = |at: usize| {
            let add = |sum: Rays, (_, more): &(_, [Rays; LIMITS])| {
                let more = more.get(at).copied().unwrap_or_default();
                core::array::from_fn(|kind| sum.get(kind).unwrap_or(&0) + more.get(kind).unwrap_or(&0))
            };
            rows.iter().fold(Rays::default(), add)
        };
        let limited = (0..LIMITS).map(|at| (picture(at), rays(at))).collect();
        Ok(Pictures { limited, whole: picture(LIMITS) })
    }

    fn picture(&self, limit: Limit, sampling: Sampling, lattice: Lattice) -> Result<Picture, EngineError> {
        let tracer = tracer(self, Rta, limit)?;
        let pixel = |at| sampling.pixel(&tracer, &self.camera, lattice.raster, at).map(S::widen);
        let rows = lattice.rows().into_par_iter().with_max_len(1);
        Ok(rows.flat_map_iter(|y| lattice.row(y).map(pixel).collect::<Vec<_>>()).collect())
    }

    fn time(&self, limit: Limit, sampling: Sampling, lattice: Lattice) -> Result<Duration, EngineError> {
        let tracer = tracer(self, Rta, limit)?;
        let start = ThreadTime::now();
        let light = traced_pixels(&tracer, self, sampling, lattice);
        let time = start.elapsed();
        core::hint::black_box(light);
        Ok(time)
    }
}

/// The function that is measured: callgrind is told its name. Besides tracing it adds up the light of all pixels, so that the
/// compiler can leave out none of them. It must not be inlined, or callgrind would not find it.
#[inline(never)]
fn traced_pixels<S: Narrow>(
    tracer: &Traced<'_, S, Rta>,
    scene: &Narrowed<S>,
    sampling: Sampling,
    lattice: Lattice,
) -> Rgb<S::Light> {
    let pixels = Lattice::side(lattice.raster.height(), lattice.step).flat_map(|y| lattice.row(y));
    let light = |at| sampling.pixel(tracer, &scene.camera, lattice.raster, at);
    pixels.map(light).fold(Rgb::BLACK, |sum: Rgb<S::Light>, light| sum.plus(light))
}
