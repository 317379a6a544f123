//! Pictures that are traced in passes: each doubles the samples that a pixel has, and tells how far the picture is from a converged one.

use core::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use rayon::ThreadPool;
use rta_core::color::Rgb;
use rta_core::sampling::Sobol;
use rta_core::sampling::pairs::hash;
use rta_packets::picture::Pass;

use super::Engine;
use super::bands::BandsError;

pub(super) use accumulated::begin;

mod accumulated;

/// Scrambles of the samples whose spread is the error, that of the picture among them.
const SCRAMBLES: usize = 4;

/// What a pixel whose one sample does not agree with its neighbours has at least: two that are alike by chance would say that it does.
const ENOUGH: u32 = 4;

/// Where pixels end early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tolerance {
    /// How far their samples may be from agreeing, in [`Agreement::PARTS`](rta_packets::agreement::Agreement::PARTS) of a level.
    pub parts: u16,
    /// The fewest samples of a pixel, 1 or more.
    pub fewest: u32,
}

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
///
/// With a tolerance a pixel ends early: after its fewest samples, twice as many, and so on, once its own samples and those of its eight
/// neighbours agree within it ([`Agreement::is_within`](rta_packets::agreement::Agreement::is_within)). What a pixel's few samples have
/// missed, an edge or a small thing, a neighbour has mostly met. A single sample says nothing of its own error: such a pixel ends where its
/// light and that of each neighbour differ by no more than chance would with an error of the tolerance
/// ([`Agreement::is_near`](rta_packets::agreement::Agreement::is_near)). Such a picture has no estimated error, and 60 bytes more a pixel.
pub struct Passes<'e> {
    sums: Box<dyn Sums + 'e>,
    samples: u32,
    /// The fewest samples after the first pass, and after any other.
    fewest: [u32; 2],
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

    /// Returns how many pixels are to take more samples.
    fn unsettled(&self) -> usize;

    /// Returns how many samples all pixels have together, if each that is not settled has `all`.
    fn taken(&self, all: u32) -> u64;

    /// Returns the rms error of the light, by the spread of the scrambles; infinite where it is not asked for.
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
        self.passes_within(None)
    }

    /// Begins a picture that is traced in passes, whose pixels end early where there is a tolerance; `None` where there is no memory for it.
    #[must_use]
    pub fn passes_within(&self, tolerance: Option<Tolerance>) -> Option<Passes<'_>> {
        let seed = self.settings.sampling.spreading().map_or(0, |spreading| spreading.samples.seed());
        let sums = self.rows.sums(seed, tolerance)?;
        // No pixel ends sooner, and samples of one pixel are traced side by side.
        let fewest = tolerance.map_or([1, 2], |tolerance| [tolerance.fewest, ENOUGH]);
        Some(Passes { sums, samples: 0, fewest, error: f64::INFINITY, seed })
    }
}

impl Passes<'_> {
    /// Returns the samples that each pixel has.
    #[must_use]
    pub const fn samples(&self) -> u32 {
        self.samples
    }

    /// Returns whether all pixels have ended early.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        self.sums.unsettled() == 0
    }

    /// Returns how many samples all pixels have together.
    #[must_use]
    pub fn taken(&self) -> u64 {
        self.sums.taken(self.samples)
    }

    /// Returns whether another pass is to come: with fewer samples than `most`, an estimated error above `error`, and pixels that go on.
    #[must_use]
    pub fn goes_on(&self, most: u32, error: f64) -> bool {
        self.samples < most && self.error > error && !self.is_settled()
    }

    /// Returns the estimated error: rms of linear light, from 0 for black to 1 for white, over all pixels and their three registers. It is
    /// infinite before the first pass, and of a picture whose pixels end early.
    #[must_use]
    pub const fn error(&self) -> f64 {
        self.error
    }

    /// Returns the samples that each pixel will have after the next pass, at most `most`: 1, 2, 4, 8 and so on, with a tolerance from its fewest on,
    /// and 4 after 1.
    #[must_use]
    pub fn next(&self, most: u32) -> u32 {
        let [first, later] = self.fewest;
        let fewest = if self.samples == 0 { first } else { later };
        self.samples.saturating_mul(2).max(fewest).min(most.clamp(1, Sobol::MAX_SAMPLES))
    }

    /// Adds the pass after which each pixel has [`Passes::next`] samples. `done` is told of pixels that are traced, by any thread.
    ///
    /// # Errors
    /// [`Ended::Interrupted`] soon after `stop` becomes true, [`Ended::Late`] soon after the `deadline`, which the first pass has none of; then
    /// the picture is as it was.
    pub fn pass(
        &mut self,
        most: u32,
        pool: &ThreadPool,
        stop: &AtomicBool,
        deadline: Option<Instant>,
        done: &(dyn Fn(usize) + Sync),
    ) -> Result<(), Ended> {
        let (next, first) = (self.next(most), self.samples);
        // There is a picture, however short the time.
        let deadline = deadline.filter(|_| first > 0);
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
