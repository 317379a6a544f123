//! A picture that is traced in passes until its error is small, or its time is over.

use core::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::Mutex;
use std::time::Instant;

use rayon::ThreadPool;
use rta_args::value::sampling::ToleranceValue;
use rta_args::value::until::Until;
use rta_core::color::Rgb;
use rta_core::raster::lattice::Lattice;
use rta_core::sampling::{Places, Sobol};
use rta_packets::agreement::Agreement;

use super::Source;
use crate::engine::bands::{self, BandsError};
use crate::engine::passes::{Ended, Passes, Tolerance};
use crate::engine::progress::Progress;
use crate::engine::{Engine, interrupt};
use crate::error::Error;
use crate::picture::error::PictureError;
use crate::picture::raster::Size;

/// When a picture that is traced in passes is done.
#[derive(Clone, Copy, Debug)]
pub enum Goal {
    /// At this end; an interrupt keeps what is there where the second says so.
    Until(Until, bool),
    /// Once the pixels agree within a tolerance, or have as many samples as the engine's.
    Settled(ToleranceValue),
}

/// A picture with its last complete pass.
pub struct Traced<'e> {
    engine: &'e Engine,
    passes: Passes<'e>,
    is_interrupted: bool,
    /// Whether there are as many samples as there may be, and the error is still larger.
    is_short: bool,
    /// The mean number of samples, where pixels end early.
    mean: Option<f64>,
}

/// Adds passes to a picture until its end; if one is interrupted, the picture is that of the passes before it where that is to be kept.
///
/// # Errors
/// [`PictureError::Memory`], [`BandsError::Threads`], and [`BandsError::Interrupted`] where nothing is kept.
pub fn trace<'e>(
    engine: &'e Engine,
    size: Size,
    goal: Goal,
    (threads, is_quiet): (Option<u16>, bool),
) -> Result<Traced<'e>, Error> {
    let (began, stop) = (Instant::now(), interrupt::watch());
    let pool = bands::pool(threads)?;
    let tolerance = match goal {
        Goal::Until(..) => None,
        Goal::Settled(tolerance) => {
            Some(Tolerance { parts: Agreement::tolerance(tolerance.part()), fewest: tolerance.fewest() })
        }
    };
    let mut passes = engine.passes_within(tolerance).ok_or(PictureError::Memory(size))?;
    let (enough, deadline, keeps) = match goal {
        Goal::Until(Until::Error(error), keeps) => (error, None, keeps),
        Goal::Until(Until::Time(time), keeps) => (0.0, began.checked_add(time), keeps),
        Goal::Settled(_) => (0.0, None, false),
    };
    let most = match goal {
        Goal::Until(..) => Sobol::MAX_SAMPLES,
        Goal::Settled(_) => engine.settings().sampling.samples(),
    };
    let mut outcome = Ok(());
    while outcome.is_ok() && passes.goes_on(most, enough) {
        outcome = pass(&mut passes, (size, most), &pool, (stop, deadline), is_quiet);
    }
    let is_interrupted = outcome == Err(Ended::Interrupted);
    if is_interrupted && !(keeps && passes.samples() > 0) {
        return Err(BandsError::Interrupted.into());
    }
    let is_short = tolerance.is_none() && outcome.is_ok() && passes.error() > enough;
    #[allow(clippy::cast_precision_loss)] // below 2^46
    let mean = tolerance.map(|_| passes.taken() as f64 / size.pixels() as f64);
    Ok(Traced { engine, passes, is_interrupted, is_short, mean })
}

/// Adds a pass, with a bar that shows how far it is.
fn pass(
    passes: &mut Passes,
    (size, most): (Size, u32),
    pool: &ThreadPool,
    (stop, deadline): (&AtomicBool, Option<Instant>),
    is_quiet: bool,
) -> Result<(), Ended> {
    let so_far = match passes.samples() {
        0 => String::new(),
        samples if passes.error().is_finite() => format!("  {samples} samples, error {:.2e}", passes.error()),
        samples => format!("  {samples} samples"),
    };
    // Both sides are below 2^16.
    let all = size.width() * size.height();
    let progress = (!is_quiet).then(|| Mutex::new(Progress::new(all).beside(so_far)));
    let traced = AtomicU32::new(0);
    passes.pass(most, pool, stop, deadline, &|pixels| {
        let pixels = u32::try_from(pixels).unwrap_or(0);
        let traced = traced.fetch_add(pixels, Ordering::Relaxed) + pixels;
        // The bar need not be told of each.
        if let Some(Ok(mut progress)) = progress.as_ref().map(Mutex::try_lock) {
            progress.reached(traced);
        }
    })
}

impl Traced<'_> {
    /// Returns the samples of each pixel.
    #[must_use]
    pub const fn samples(&self) -> u32 {
        self.passes.samples()
    }

    /// Returns a warning where the picture is not as good as it was to be.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        let (error, samples) = (self.passes.error(), self.samples());
        let warning = || format!("the estimated error is {error:.2e} with {samples} samples, the most");
        self.is_short.then(warning)
    }

    /// Returns whether an interrupt has ended the passes.
    #[must_use]
    pub const fn is_interrupted(&self) -> bool {
        self.is_interrupted
    }

    /// Returns what the last line says of the error.
    #[must_use]
    pub fn told(&self) -> String {
        if let Some(mean) = self.mean {
            return format!("; {mean:.2} samples in the mean");
        }
        let end = if self.is_interrupted { ", interrupted" } else { "" };
        format!("; estimated error {:.2e}{end}", self.passes.error())
    }
}

impl Source for Traced<'_> {
    fn linear_rows(&self, first: u32, out: &mut [Rgb<f32>]) {
        self.passes.linear_rows(first, out);
    }

    fn level_rows(&self, first: u32, gun_max: u8, out: &mut [Rgb<u8>]) {
        self.passes.level_rows(first, gun_max, out);
    }

    fn on_grid(
        &self,
        lattice: Lattice,
        pool: &ThreadPool,
        stop: &AtomicBool,
    ) -> Result<Vec<Rgb<u8>>, BandsError> {
        self.engine.on_grid(lattice, pool, stop)
    }
}
