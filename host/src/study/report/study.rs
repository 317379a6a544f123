//! The study of one scene: every setting with its errors and its cost.

use core::sync::atomic::{AtomicBool, Ordering};
use std::path::Path;
use std::thread;

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use rta_core::raster::Raster;
use rta_core::sampling::Sampling;

use super::Source;
use super::bench::{Bench, Lattice, Picture, Pictures, bench, smaller};
use super::measure::{Difference, median};
use super::setting::{LIMITS, Limit, Method, reference_sampling, samplings};
use super::{display, instructions};

use crate::engine::callgrind::CountError;
use crate::engine::progress::Progress;
use crate::engine::{EngineError, Format};
use crate::picture::device::Device;
use crate::picture::raster::Size;
use crate::request::error::RequestError;
use crate::study::error::StudyError;
use rta_packets::tally::Rays;

/// The devices whose display error is measured.
pub const DEVICES: [Device; 3] = [Device::Vga, Device::Graphigs, Device::Pixrect];

/// The reference of 1024 samples is traced for every `TRUTH_STEP`th pixel of every `TRUTH_STEP`th row.
pub const TRUTH_STEP: u32 = 2;

/// CPU time is taken on every `TIME_STEP`th pixel of every `TIME_STEP`th row.
pub const TIME_STEP: u32 = 8;

/// Number of times that the CPU time is taken; the median counts.
pub const REPEATS: usize = 5;

/// One level of a gun with 8 bits.
const LEVEL: f64 = 1.0 / 255.0;

/// Steps of [`Progress`] that a scene takes.
pub const STEPS: u32 = 30;

/// The errors and the cost of one setting.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Number format and samples.
    pub method: Method,
    /// Depth and cut-off.
    pub limit: Limit,
    /// Rays of the whole picture, by kind.
    pub rays: Rays,
    /// Instructions of the whole picture, if they could be counted.
    pub instructions: Option<u64>,
    /// CPU seconds of the whole picture on one thread.
    pub seconds: f64,
    /// Rounding error: against `f64` with the same depth, cut-off and samples.
    pub rounding: Difference,
    /// Truncation error of `f64`: against the reference's depth without a cut-off, with the same samples.
    pub truncation: Difference,
    /// Sampling error of `f64` with the reference's depth: against 1024 samples.
    pub sampling: Difference,
    /// Rounding and truncation together: against `f64` with the reference's depth and the same samples.
    pub tracing: Difference,
    /// All errors together: against `f64` with the reference's depth and 1024 samples.
    pub total: Difference,
    /// Error of the display: the picture that each of [`DEVICES`] shows against the one it is sent, in levels of its guns.
    pub display: [Difference; 3],
}

impl Row {
    /// Rays of all kinds.
    #[must_use]
    pub fn all_rays(&self) -> u64 {
        self.rays.iter().sum()
    }
}

/// A scene's rows, method by method, and why there are no instructions if there are none.
#[derive(Debug)]
pub struct Study {
    /// The scene's name in file names and titles.
    pub title: String,
    /// Number of objects and of lamps.
    pub size: (usize, usize),
    /// One for each setting.
    pub rows: Vec<Row>,
    /// Why no instructions were counted.
    pub uncounted: Option<CountError>,
}

/// The settings that all scenes of a report have in common.
#[derive(Clone, Copy, Debug)]
pub struct Setup<'a> {
    /// Pixels.
    pub size: Size,
    /// Width over height of the screen.
    pub aspect: f64,
    /// This program, to be run under valgrind; without it nothing is counted.
    pub program: Option<&'a Path>,
    /// Becomes true at an interrupt.
    pub stop: &'a AtomicBool,
}

impl Setup<'_> {
    /// # Errors
    /// [`StudyError::INTERRUPTED`] after an interrupt.
    pub(super) fn go_on(&self) -> Result<(), StudyError> {
        if self.stop.load(Ordering::Relaxed) { Err(StudyError::INTERRUPTED) } else { Ok(()) }
    }
}

/// Makes the study of a scene; `done` steps of the progress are behind it.
///
/// # Errors
/// [`RequestError::Engine`], [`PictureError::Display`](crate::picture::error::PictureError::Display) and [`BandsError::Interrupted`](crate::engine::bands::BandsError::Interrupted).
pub fn study(source: &Source, setup: Setup, progress: &mut Progress, done: u32) -> Result<Study, StudyError> {
    let counting = thread::scope(|scope| {
        // Callgrind has one core for itself; the pictures take what is left.
        let counts = setup.program.map(|program| {
            let place = (setup.size.to_string(), setup.aspect.to_string());
            scope.spawn(move || instructions::count(program, &source.text, (&place.0, &place.1), setup.stop))
        });
        let rows = pictures(source, setup, progress, done);
        let counts = match counts {
            None => None,
            Some(counts) => counts.join().ok(),
        };
        rows.map(|rows| (rows, counts))
    });
    let (mut rows, counts) = counting?;
    setup.go_on()?;
    let uncounted = match counts {
        Some(Ok(counts)) => {
            scale_instructions(source, setup, &counts, &mut rows)?;
            None
        }
        Some(Err(error)) => Some(error),
        None => None,
    };
    progress.reached(done + STEPS - 10);
    // Nothing else runs while time is taken.
    times(source, setup, &mut rows, |part| progress.reached(done + STEPS - 10 + part))?;
    let scene = &source.scene.description;
    let objects = scene.cylinders.len() + scene.ellipsoids.len() + scene.spheres.len();
    let size = (objects, scene.lamps.len());
    Ok(Study { title: source.title.clone(), size, rows, uncounted })
}

fn ready(source: &Source, setup: Setup, format: Format) -> Result<Box<dyn Bench>, StudyError> {
    bench(&source.scene.description, setup.aspect, format).map_err(failed(source))
}

pub(super) fn failed(source: &Source) -> impl Fn(EngineError) -> StudyError {
    |error| RequestError::Engine { name: source.scene.source.clone(), source: error }.into()
}

fn raster(source: &Source, setup: Setup) -> Result<Raster, StudyError> {
    Raster::new(setup.size.width(), setup.size.height()).map_err(EngineError::from).map_err(failed(source))
}

/// Returns the rows of all settings with their errors and rays, without their costs.
fn pictures(
    source: &Source,
    setup: Setup,
    progress: &mut Progress,
    done: u32,
) -> Result<Vec<Row>, StudyError> {
    let raster = raster(source, setup)?;
    let (all, sparse) = (Lattice::all(raster), Lattice::every(raster, TRUTH_STEP));
    let exact = ready(source, setup, Format::F64)?;
    let truth = exact.picture(Limit::REFERENCE, reference_sampling(), sparse).map_err(failed(source))?;
    let mut step = done + 4;
    progress.reached(step);
    let mut rows = Vec::new();
    for sampling in samplings() {
        setup.go_on()?;
        let reference = exact.pictures(sampling, all, true).map_err(failed(source))?;
        for method in Method::with(sampling) {
            setup.go_on()?;
            let bench = ready(source, setup, method.format)?;
            let pictures = bench.pictures(sampling, all, false).map_err(failed(source))?;
            let judge = Judge { method, reference: &reference, truth: &truth, sparse, setup };
            let limits: Vec<_> = Limit::all().zip(&pictures.limited).zip(&reference.limited).collect();
            let judged = limits
                .into_par_iter()
                .map(|((limit, (picture, rays)), (same, _))| judge.row(limit, picture, *rays, same));
            rows.extend(judged.collect::<Result<Vec<_>, _>>()?);
            step += 1;
            progress.reached(step);
        }
    }
    Ok(rows)
}

/// The pictures that those of a method are compared with.
#[derive(Clone, Copy)]
struct Judge<'a> {
    method: Method,
    reference: &'a Pictures,
    truth: &'a Picture,
    sparse: Lattice,
    setup: Setup<'a>,
}

impl Judge<'_> {
    /// `same` is the picture in `f64` with the same limit.
    fn row(&self, limit: Limit, picture: &Picture, rays: Rays, same: &Picture) -> Result<Row, StudyError> {
        let whole = &self.reference.whole;
        let between = |a: &Picture, b: &Picture| Difference::between(a, b, LEVEL);
        let mut display = [Difference { rmse: 0.0, worst: 0.0, within: 1.0 }; 3];
        for (difference, device) in display.iter_mut().zip(DEVICES) {
            *difference = display::error(device, (self.setup.size, self.setup.aspect), picture)?;
        }
        Ok(Row {
            method: self.method,
            limit,
            rays,
            instructions: None,
            seconds: 0.0,
            rounding: between(picture, same),
            truncation: between(same, whole),
            sampling: between(&self.sparse.select(whole), self.truth),
            tracing: between(picture, whole),
            total: between(&self.sparse.select(picture), self.truth),
            display,
        })
    }
}

/// A part of the pixels. Costs that were measured there are divided by its rays.
struct Parts<'a> {
    source: &'a Source,
    setup: Setup<'a>,
    lattice: Lattice,
}

impl Parts<'_> {
    /// Returns the rays of a method on these pixels, for each limit.
    fn rays(&self, format: Format, sampling: Sampling) -> Result<Vec<f64>, StudyError> {
        let bench = ready(self.source, self.setup, format)?;
        let pictures = bench.pictures(sampling, self.lattice, false).map_err(failed(self.source))?;
        Ok(pictures.limited.iter().map(|(_, rays)| count(*rays)).collect())
    }
}

/// Returns the number of rays of all kinds, as a float.
#[allow(clippy::cast_precision_loss)] // below 2^53
fn count(rays: Rays) -> f64 {
    rays.iter().sum::<u64>() as f64
}

/// Computes the instructions of the whole pictures from those of a part of the pixels, in proportion to the rays.
fn scale_instructions(
    source: &Source,
    setup: Setup,
    counts: &[u64],
    rows: &mut [Row],
) -> Result<(), StudyError> {
    let lattice = Lattice::all(smaller(raster(source, setup)?, instructions::STEP));
    let parts = Parts { source, setup, lattice };
    let methods: Vec<_> = instructions::order().map(|(method, _)| method).step_by(LIMITS).collect();
    for rows in rows.chunks_mut(LIMITS) {
        let Some(method) = rows.first().map(|row| row.method) else { continue };
        let sampling = instructions::counted(method.sampling);
        let stands = |counted: &Method| *counted == Method { sampling, ..method };
        let Some(counts) = methods.iter().position(stands).and_then(|at| counts.chunks(LIMITS).nth(at))
        else {
            continue;
        };
        let rays = parts.rays(method.format, sampling)?;
        for ((row, part), rays) in rows.iter_mut().zip(counts).zip(rays) {
            row.instructions = Some(scale(*part, count(row.rays) / rays));
        }
    }
    Ok(())
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)] // below 2^53
fn scale(count: u64, factor: f64) -> u64 {
    (count as f64 * factor).round() as u64
}

/// Measures the CPU seconds, and scales them up in proportion to the rays like the instructions.
fn times(
    source: &Source,
    setup: Setup,
    rows: &mut [Row],
    mut reached: impl FnMut(u32),
) -> Result<(), StudyError> {
    let raster = smaller(raster(source, setup)?, TIME_STEP);
    let parts = Parts { source, setup, lattice: Lattice::all(raster) };
    let mut part = 0;
    for rows in rows.chunks_mut(LIMITS) {
        let Some(Method { format, sampling }) = rows.first().map(|row| row.method) else { continue };
        let rays = parts.rays(format, sampling)?;
        let bench = ready(source, setup, format)?;
        for (row, rays) in rows.iter_mut().zip(rays) {
            setup.go_on()?;
            let time = || Ok(bench.time(row.limit, sampling, raster)?.as_secs_f64());
            let times: Result<Vec<_>, EngineError> = (0..REPEATS).map(|_| time()).collect();
            row.seconds = median(times.map_err(failed(source))?) * count(row.rays) / rays;
        }
        part += 1;
        reached(part * 10 / 15);
    }
    Ok(())
}
