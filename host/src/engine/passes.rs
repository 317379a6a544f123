//! Pictures that are traced in passes: each doubles the samples that a pixel has, and tells how far the picture is from a converged one.

use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Instant;

use rayon::ThreadPool;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};
use rta_core::color::Rgb;
use rta_core::raster::Places;
use rta_core::sampling::Sobol;
use rta_core::sampling::pairs::hash;
use rta_packets::picture::{Pass, Picture, Setup};
use rta_scenes::narrow::Narrow;

use super::bands::BandsError;
use super::{Engine, single};

/// Scrambles of the samples whose spread is the error, that of the picture among them.
const SCRAMBLES: usize = 4;

/// The error is told by one pixel of each block of so many rows and columns of a large picture.
const BLOCK: u32 = 4;

/// A small picture has smaller blocks, so that there are about as many.
const BLOCKS: u32 = 1024;

/// Pixels that a thread adds to before it asks whether the work is to end.
const CHUNK: usize = 32;

/// Why a pass is not completed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// The time is over.
    Late,
    /// An interrupt or a request to terminate arrived.
    Interrupted,
}

impl From<Ended> for BandsError {
    /// Whoever sets no deadline is never late.
    fn from(_: Ended) -> Self {
        Self::Interrupted
    }
}

/// A picture to which samples are added pass by pass.
///
/// With `n` samples a pixel it is, to the last bit, the picture of as many samples by the same seed. It has the sum of each pixel's light,
/// 12 bytes (24 in `f64`), twice while a pass runs, so that a pass that is not completed leaves it as it was.
///
/// Its error is told by the same pixels with three more seeds: the sample variance of the four sums has the mean of the picture's own
/// squared error, as scrambled samples have the right mean (A. Owen, "Randomly Permuted (t,m,s)-Nets", 1995). One pixel of each block of
/// 4 x 4 is asked (more of a picture below 128 x 128), so that it costs 3/16 of the picture's rays.
pub struct Passes<'e> {
    sums: Box<dyn Sums + 'e>,
    samples: u32,
    error: f64,
    seed: u32,
}

/// The sums of a picture in any number format.
pub(super) trait Sums: Send + Sync {
    /// Adds the samples of a pass, with the threads of `pool`, as long as `goes_on` says so. Returns whether it is complete; if it is
    /// not, the sums are as they were.
    fn add(
        &mut self,
        passes: [Pass; SCRAMBLES],
        pool: &ThreadPool,
        goes_on: &(dyn Fn() -> bool + Sync),
        done: &(dyn Fn(usize) + Sync),
    ) -> bool;

    /// Returns the rms error of the light, by the spread of the scrambles.
    fn error(&self, samples: Sobol) -> f64;

    /// Fills `out` with linear light, from row `first` on.
    fn linear(&self, samples: Sobol, first: u32, out: &mut [Rgb<f32>]);

    /// Fills `out` with levels `0..=gun_max`, from row `first` on.
    fn levels(&self, samples: Sobol, first: u32, gun_max: u8, out: &mut [Rgb<u8>]);
}

impl Engine {
    /// Begins a picture that is traced in passes; `None` where there is no memory for it. Its seed is that of the engine's samples.
    #[must_use]
    pub fn passes(&self) -> Option<Passes<'_>> {
        let seed = self.settings.sampling.spreading().map_or(0, |spreading| spreading.samples.seed());
        Some(Passes { sums: self.rows.sums(seed)?, samples: 0, error: f64::INFINITY, seed })
    }
}

impl Passes<'_> {
    /// Returns the samples that each pixel has.
    #[must_use]
    pub const fn samples(&self) -> u32 {
        self.samples
    }

    /// Returns the estimated error: rms of linear light, from 0 for black to 1 for white, over all pixels and their three registers. It is
    /// infinite before the first pass.
    #[must_use]
    pub const fn error(&self) -> f64 {
        self.error
    }

    /// Returns the samples that each pixel will have after the next pass, at most `most`: 1, 2, 4, 8 and so on.
    #[must_use]
    pub fn next(&self, most: u32) -> u32 {
        self.samples.saturating_mul(2).clamp(1, most.clamp(1, Sobol::MAX_SAMPLES))
    }

    /// Adds the pass after which each pixel has [`Passes::next`] samples. `done` is told of pixels that are traced, by any thread.
    ///
    /// # Errors
    /// [`Ended::Interrupted`] soon after `stop` becomes true, [`Ended::Late`] soon after the `deadline`; then the picture is as it was.
    pub fn pass(
        &mut self,
        most: u32,
        pool: &ThreadPool,
        stop: &AtomicBool,
        deadline: Option<Instant>,
        done: &(dyn Fn(usize) + Sync),
    ) -> Result<(), Ended> {
        let (next, first) = (self.next(most), self.samples);
        let is_late = || deadline.is_some_and(|deadline| Instant::now() >= deadline);
        let goes_on = || !stop.load(Ordering::Relaxed) && !is_late();
        let seeds: [u32; SCRAMBLES] = core::array::from_fn(|scramble| match u32::try_from(scramble) {
            Ok(0) | Err(_) => self.seed,
            Ok(other) => hash([self.seed, other, 0, 0])[0],
        });
        let samples = |seed| Sobol::new(next, seed);
        // There are as many samples as there may be.
        let [Some(own), Some(a), Some(b), Some(c)] = seeds.map(samples) else { return Ok(()) };
        let passes = [own, a, b, c].map(|samples| Pass { samples, first });
        if !self.sums.add(passes, pool, &goes_on, done) {
            return Err(if stop.load(Ordering::Relaxed) { Ended::Interrupted } else { Ended::Late });
        }
        (self.samples, self.error) = (next, self.sums.error(own));
        Ok(())
    }

    /// Returns the samples as they are placed; one before there is any.
    fn placed(&self) -> Option<Sobol> {
        Sobol::new(self.samples.max(1), self.seed)
    }

    /// Fills `out` with linear light, from row `first` on; it is black before the first pass.
    pub fn linear_rows(&self, first: u32, out: &mut [Rgb<f32>]) {
        if let Some(samples) = self.placed() {
            self.sums.linear(samples, first, out);
        }
    }

    /// Fills `out` with levels `0..=gun_max` of a display's guns, from row `first` on; they are 0 before the first pass.
    pub fn level_rows(&self, first: u32, gun_max: u8, out: &mut [Rgb<u8>]) {
        if let Some(samples) = self.placed() {
            self.sums.levels(samples, first, gun_max, out);
        }
    }
}

/// The sums of a picture in the number format `S`.
struct Accumulated<'e, S: Narrow> {
    picture: &'e dyn Picture<S>,
    width: usize,
    sums: Vec<Rgb<S::Light>>,
    /// Room for the next pass.
    next: Vec<Rgb<S::Light>>,
    checked: Vec<Checked<S>>,
    next_checked: Vec<Checked<S>>,
}

/// A pixel by which the error is told: its place, and its sums by the other seeds.
#[derive(Clone, Copy)]
struct Checked<S: Narrow> {
    pixel: [u32; 2],
    sums: [Rgb<S::Light>; SCRAMBLES - 1],
}

/// Begins the sums of a picture; `None` where there is no memory for them.
pub(super) fn begin<S: Narrow>(picture: &dyn Picture<S>, seed: u32) -> Option<Box<dyn Sums + '_>> {
    let Setup { raster, .. } = *picture.setup();
    let (width, height) = (usize::try_from(raster.width()).ok()?, usize::try_from(raster.height()).ok()?);
    let black = || {
        let mut sums = Vec::new();
        sums.try_reserve_exact(width.checked_mul(height)?).ok()?;
        sums.resize(width * height, Rgb::BLACK);
        Some(sums)
    };
    // Both sides are below 2^16.
    let side = (raster.width() * raster.height() / BLOCKS).isqrt().clamp(1, BLOCK);
    let mut checked = Vec::new();
    for y in (0..raster.height()).step_by(side as usize) {
        for x in (0..raster.width()).step_by(side as usize) {
            // A place of its own in each block: what repeats in the picture is met as often as it is there.
            let [right, down, ..] = hash([x, y, seed, 1]);
            let pixel = [x + right % side, y + down % side];
            if pixel[0] < raster.width() && pixel[1] < raster.height() {
                checked.push(Checked { pixel, sums: [Rgb::BLACK; SCRAMBLES - 1] });
            }
        }
    }
    let next_checked = checked.clone();
    Some(Box::new(Accumulated { picture, width, sums: black()?, next: black()?, checked, next_checked }))
}

impl<S: Narrow> Accumulated<'_, S> {
    /// Hands each pixel from row `first` on over with its mean light.
    fn each<T>(&self, samples: Sobol, first: u32, out: &mut [T], convert: impl Fn(Rgb<S::Light>) -> T) {
        let sums = self.sums.iter().skip(first as usize * self.width);
        for (pixel, &sum) in out.iter_mut().zip(sums) {
            *pixel = convert(samples.mean(sum));
        }
    }
}

impl<S: Narrow> Sums for Accumulated<'_, S> {
    fn add(
        &mut self,
        [own, others @ ..]: [Pass; SCRAMBLES],
        pool: &ThreadPool,
        goes_on: &(dyn Fn() -> bool + Sync),
        done: &(dyn Fn(usize) + Sync),
    ) -> bool {
        let (picture, width) = (self.picture, self.width);
        let added = AtomicUsize::new(0);
        let place = |index: usize| {
            // Both are sides of a raster.
            [index % width, index / width].map(|side| u32::try_from(side).unwrap_or(u32::MAX))
        };
        pool.install(|| {
            let chunks = self.next.par_chunks_mut(CHUNK).zip(self.sums.par_chunks(CHUNK)).enumerate();
            chunks.for_each(|(chunk, (next, sums))| {
                if goes_on() {
                    next.copy_from_slice(sums);
                    picture.add(own, &mut (chunk * CHUNK..).map(place).zip(next.iter_mut()));
                    added.fetch_add(sums.len(), Ordering::Relaxed);
                    done(sums.len());
                }
            });
            let chunks = self.next_checked.par_chunks_mut(CHUNK).zip(self.checked.par_chunks(CHUNK));
            chunks.for_each(|(next, checked)| {
                if goes_on() {
                    next.copy_from_slice(checked);
                    for (scramble, pass) in others.into_iter().enumerate() {
                        let sums = next
                            .iter_mut()
                            .filter_map(|Checked { pixel, sums }| Some((*pixel, sums.get_mut(scramble)?)));
                        picture.add(pass, &mut { sums });
                    }
                    added.fetch_add(checked.len(), Ordering::Relaxed);
                }
            });
        });
        let is_complete = added.into_inner() == self.sums.len() + self.checked.len();
        if is_complete {
            core::mem::swap(&mut self.sums, &mut self.next);
            core::mem::swap(&mut self.checked, &mut self.next_checked);
        }
        is_complete
    }

    #[allow(clippy::cast_precision_loss)] // a picture has fewer than 2^32 pixels
    fn error(&self, samples: Sobol) -> f64 {
        let spread = |checked: &Checked<S>| {
            let [x, y] = checked.pixel.map(|side| side as usize);
            let own = self.sums.get(y * self.width + x).copied().unwrap_or(Rgb::BLACK);
            let light = |sum| samples.mean(sum).map(S::light_to_f64);
            let [a, b, c] = checked.sums;
            let lights = [own, a, b, c].map(light);
            let variance = |register: fn(&Rgb<f64>) -> f64| {
                let mean = lights.iter().map(register).sum::<f64>() / SCRAMBLES as f64;
                let squares = lights.iter().map(|light| (register(light) - mean).powi(2));
                squares.sum::<f64>() / (SCRAMBLES - 1) as f64
            };
            (variance(|light| light.r) + variance(|light| light.g) + variance(|light| light.b)) / 3.0
        };
        (self.checked.iter().map(spread).sum::<f64>() / self.checked.len().max(1) as f64).sqrt()
    }

    fn linear(&self, samples: Sobol, first: u32, out: &mut [Rgb<f32>]) {
        self.each(samples, first, out, |light| light.map(single::<S>));
    }

    fn levels(&self, samples: Sobol, first: u32, gun_max: u8, out: &mut [Rgb<u8>]) {
        self.each(samples, first, out, |light| light.levels(gun_max));
    }
}
