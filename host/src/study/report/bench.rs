//! A scene in one number format, ready to be traced with any setting on a part of its pixels.
//!
//! It is traced with the thesis's model alone, for which the scenes were made: every further model would take as many minutes
//! again, and the page tells of one model.

use core::marker::PhantomData;
use core::time::Duration;

use cpu_time::ThreadTime;
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::sampling::{Places, Sampling};
use rta_core::scalar::Light;
use rta_core::trace::dice::Sample;
use rta_packets::picture::{self, Setup};
use rta_packets::tally::Rays;
use rta_packets::{Picture as Traced, ShadowCache};
use rta_scenes::description::Description;
use rta_scenes::in_format;
use rta_scenes::narrow::Narrow;

use super::contributions::{Contributions, Limited};
use super::setting::{DEPTHS, LIMITS, Limit, REFERENCE_DEPTH};
use crate::engine::{Cutoff, EngineError, Format, Model, single};

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

/// Returns a raster of the same shape whose sides are a `step`th as long, at least one pixel.
#[must_use]
pub fn smaller(raster: Raster, step: u32) -> Raster {
    let side = |pixels: u32| (pixels / step.max(1)).max(1);
    Raster::new(side(raster.width()), side(raster.height())).unwrap_or(raster)
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

    /// Traces the picture of one setting on the calling thread, as every command traces pictures, without keeping it. Returns
    /// the CPU time that it takes.
    ///
    /// # Errors
    /// [`EngineError::Core`] if the scene or the depth is refused.
    fn time(&self, limit: Limit, sampling: Sampling, raster: Raster) -> Result<Duration, EngineError>;
}

/// Makes a scene ready in a format, for a screen of the shape `aspect : 1`.
///
/// # Errors
/// [`EngineError`] if the scene does not fit the format.
pub fn bench(scene: &Description, aspect: f64, format: Format) -> Result<Box<dyn Bench>, EngineError> {
    fn ready<S: picture::Format>(scene: &Description, aspect: f64) -> Result<Box<dyn Bench>, EngineError> {
        let ready = Ready::<S> { scene: scene.clone(), aspect, format: PhantomData };
        // Whatever is refused is refused now.
        ready.traced(Limit::REFERENCE, Sampling::CENTER, Raster::new(1, 1)?)?;
        Ok(Box::new(ready))
    }
    in_format!(format, S => ready::<S>(scene, aspect))
}

struct Ready<S> {
    scene: Description,
    aspect: f64,
    format: PhantomData<fn() -> S>,
}

impl<S: picture::Format> Ready<S> {
    fn traced(
        &self,
        limit: Limit,
        sampling: Sampling,
        raster: Raster,
    ) -> Result<Box<dyn Traced<S>>, EngineError> {
        let Limit { depth, cutoff } = limit;
        let cutoff = Some((cutoff.numerator(), cutoff.denominator()));
        S::picture(
            &self.scene,
            Model::Rta,
            &Setup { raster, aspect: self.aspect, depth, cutoff, sampling: sampling.into() },
        )
    }
}

impl<S: picture::Format> Bench for Ready<S> {
    fn pictures(&self, sampling: Sampling, lattice: Lattice, deep: bool) -> Result<Pictures, EngineError> {
        let depth = if deep { REFERENCE_DEPTH } else { *DEPTHS.end() };
        let traced = self.traced(Limit { depth, cutoff: Cutoff::OFF }, sampling, lattice.raster)?;
        let row = |y| {
            let mut rays = [Rays::default(); LIMITS];
            let (mut contributions, mut cache) = (Contributions::default(), ShadowCache::default());
            let mut pixels = Vec::new();
            let samples_of_row = sampling.row::<S::Unit>(lattice.raster, y);
            for (x, _) in lattice.row(y) {
                let mut sums = [Rgb::BLACK; LIMITS + 1];
                for sample in 0..sampling.samples() {
                    let place = sampling.place(lattice.raster, samples_of_row, x, sample);
                    let own = Sample { x, y, number: sample };
                    let trace = |observer: &mut Contributions<S::Light>| {
                        traced.sample(place, own, &mut cache, observer)
                    };
                    let Limited { lights, whole } = contributions.sample(&mut rays, trace);
                    for (sum, light) in sums.iter_mut().zip(lights.into_iter().chain([whole])) {
                        *sum = add(&sampling, *sum, light);
                    }
                }
                pixels.push(sums.map(|sum| sampling.mean(sum).map(single::<S>)));
            }
            (pixels, rays)
        };
        let rows = in_parallel(lattice, &row);
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
        let traced = self.traced(limit, sampling, lattice.raster)?;
        let row = |y| {
            let mut cache = ShadowCache::default();
            let samples_of_row = sampling.row::<S::Unit>(lattice.raster, y);
            let pixel = |(x, _)| {
                let mut sum = Rgb::BLACK;
                for sample in 0..sampling.samples() {
                    let place = sampling.place(lattice.raster, samples_of_row, x, sample);
                    let own = Sample { x, y, number: sample };
                    sum = add(&sampling, sum, traced.sample(place, own, &mut cache, &mut ()));
                }
                sampling.mean(sum).map(single::<S>)
            };
            lattice.row(y).map(pixel).collect::<Vec<_>>()
        };
        Ok(in_parallel(lattice, &row).concat())
    }

    fn time(&self, limit: Limit, sampling: Sampling, raster: Raster) -> Result<Duration, EngineError> {
        let traced = self.traced(limit, sampling, raster)?;
        let start = ThreadTime::now();
        let light = traced_pixels(&*traced);
        let time = start.elapsed();
        core::hint::black_box(light);
        Ok(time)
    }
}

/// Returns what `row` makes of each of a lattice's rows, on all threads. Compiled once for all formats: what it calls is behind a pointer.
fn in_parallel<T: Send>(lattice: Lattice, row: &(dyn Fn(u32) -> T + Sync)) -> Vec<T> {
    lattice.rows().into_par_iter().with_max_len(1).map(row).collect()
}

/// Adds a sample to a pixel. What a display cannot show of a single sample is cut off here too, as of several.
fn add<L: Light>(sampling: &Sampling, sum: Rgb<L>, light: Rgb<L>) -> Rgb<L> {
    let shown = light.map(|light| if light > L::WHITE { L::WHITE } else { light });
    sampling.add(sum, shown)
}

/// Traces the whole picture. Its name is the one that callgrind is told. All that it does besides tracing is one addition a
/// pixel, so that nothing can be left out.
#[inline(never)]
fn traced_pixels<S: Narrow>(traced: &dyn Traced<S>) -> Rgb<S::Light> {
    let mut sum = Rgb::BLACK;
    traced.rows(0, u32::MAX, &mut |row| sum = row.iter().fold(sum, |sum, light| sum.plus(*light)));
    sum
}
