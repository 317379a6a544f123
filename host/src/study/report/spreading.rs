//! The study of rays that are spread: error against run time and rays for samples, sampler, lamps, antialiasing and splitting.
//!
//! Everything is traced in `f64`, so that roundings play no part, and compared with a picture of [`REFERENCE`] samples whose lamps have
//! their size and whose seed is another.

use core::sync::atomic::AtomicBool;

use cpu_time::ThreadTime;
use rta_core::color::Rgb;
use rta_core::sampling::{Sampling, Sobol};
use rta_packets::tally::Rays;
use rta_scenes::description::{Description, LampShape};
use rta_scenes::sampler::{self, Adaptive, Cutting, Integrator, Lamps, Sampler, Spreading, is_spectral};

use super::Source;
use super::measure::{Difference, median, slope};
use super::study::Setup;
use crate::engine::{Cutoff, Engine, Format, Settings, bands, cones};
use crate::picture::error::PictureError;
use crate::picture::raster::Size;
use crate::study::error::StudyError;
use variance::Variances;

pub mod page;
pub mod variance;

/// Samples of the picture that the others are compared with.
pub const REFERENCE: u32 = 1024;

/// Its seed. Those of the pictures that are compared with it are 0.
const REFERENCE_SEED: u32 = 0x5eed;

/// A side of the pictures is a `STEP`th as long as that of the report's others.
pub const STEP: u32 = 4;

/// Number of times that the CPU time is taken of pictures that are soon traced; the median counts.
pub const REPEATS: usize = 3;

/// Samples of a pixel: they fill a grid, and are powers of two.
pub const SAMPLES: [u32; 5] = [1, 4, 16, 64, 256];

/// The most shadow rays to a lamp for a pixel: samples times places on the lamp, or samples times the split.
const MOST: u32 = 256;

/// Recursion depth where the scene states none.
const DEPTH: u32 = 5;

/// One picture with its error and its cost.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Samples of a pixel; 1 where pixels are cut.
    pub samples: u32,
    /// Its difference from the reference.
    pub error: Difference,
    /// Its rays, by kind.
    pub rays: Rays,
    /// CPU seconds on one thread.
    pub seconds: f64,
}

/// The pictures of one way to spread rays.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// How it is told: sampler, lamps, antialiasing and split, each as its option has it, or `-`.
    pub way: [String; 4],
    /// From few samples to many.
    pub rows: Vec<Row>,
    /// The slope of log error over log samples, by least squares; `None` of a picture whose pixels are cut.
    pub slope: Option<f64>,
}

/// The study of one scene.
#[derive(Clone, Debug)]
pub struct Spread {
    /// The scene's name in titles.
    pub title: String,
    /// Pixels of the pictures.
    pub size: Size,
    /// The ways.
    pub curves: Vec<Curve>,
    /// The variances of a pixel, where the scene has a lamp with a size.
    pub variances: Option<Variances>,
    /// The reference's own error, as its scrambles estimate it.
    pub reference_error: f64,
}

/// Returns whether a lamp of the scene has a size.
fn has_area_lamp(scene: &Description) -> bool {
    scene.lamps.iter().any(|lamp| lamp.radius > 0.0)
        || scene.details.lamps.iter().any(|(_, shape)| matches!(shape, LampShape::Area { .. }))
}

/// Returns whether rays of a scene can be spread over anything but the pixel.
#[must_use]
pub fn spreads(scene: &Description) -> bool {
    !is_spectral(scene) && (has_area_lamp(scene) || sampler::spreads(scene, scene.optics.aperture))
}

/// Ways to place samples on a grid, where nothing is spread.
fn grid(seed: Option<u32>) -> impl Fn(u32) -> Option<Sampler> {
    move |samples| {
        let side = u8::try_from(samples.isqrt()).ok()?;
        let grid = Sampling::grid(side)?;
        Some(Sampler::Grid(seed.map_or(grid, |seed| grid.jittered(seed))))
    }
}

/// Samples of a sequence.
fn sobol(lamps: Lamps, split: u16) -> impl Fn(u32) -> Option<Sampler> {
    let places = match lamps {
        Lamps::Fixed(side) => u32::from(side) * u32::from(side),
        _ => u32::from(split),
    };
    move |samples| {
        let spreading =
            Spreading { samples: Sobol::new(samples, 0)?, lamps, split, integrator: Integrator::Whitted };
        (places == 1 || samples * places <= MOST).then_some(Sampler::Sobol(spreading))
    }
}

/// A way, and the samplers by their numbers of samples.
type Way = ([&'static str; 4], Vec<(u32, Sampler)>);

/// Returns the ways that make a difference for a scene.
fn ways(has_area_lamp: bool) -> Vec<Way> {
    let each = |of: &dyn Fn(u32) -> Option<Sampler>| {
        SAMPLES.into_iter().filter_map(|samples| Some((samples, of(samples)?))).collect()
    };
    let mut ways = vec![
        (["grid", "point", "-", "-"], each(&grid(None))),
        (["jitter", "point", "-", "-"], each(&grid(Some(0)))),
        (["sobol", "point", "-", "-"], each(&sobol(Lamps::Point, 1))),
    ];
    for (depth, name) in (0..).zip(["whitted:0", "whitted:1", "whitted:2", "whitted:3"]) {
        let cutting = Cutting::new(depth, Cutting::TOLERANCE)
            .map(|cutting| Sampler::Adaptive(Adaptive::Whitted(cutting)));
        ways.push((["-", "point", name, "-"], cutting.map(|cutting| (1, cutting)).into_iter().collect()));
    }
    ways.push((["-", "cone", "cones", "-"], vec![(1, Sampler::Cones)]));
    ways.push((["-", "point", "mitchell", "-"], vec![(1, Sampler::Adaptive(Adaptive::Mitchell))]));
    if has_area_lamp {
        ways.extend([
            (["sobol", "fixed:4", "-", "-"], each(&sobol(Lamps::Fixed(2), 1))),
            (["sobol", "fixed:16", "-", "-"], each(&sobol(Lamps::Fixed(4), 1))),
            (["sobol", "cone", "-", "-"], each(&sobol(Lamps::Cone, 1))),
            (["sobol", "area", "-", "1"], each(&sobol(Lamps::Area, 1))),
            (["sobol", "area", "-", "4"], each(&sobol(Lamps::Area, 4))),
            (["sobol", "area", "-", "16"], each(&sobol(Lamps::Area, 16))),
        ]);
    }
    ways
}

/// A scene about to be traced in one way after the other.
struct Scene<'a> {
    source: &'a Source,
    settings: Settings,
}

impl Scene<'_> {
    fn engine(&self, sampling: Sampler) -> Result<Engine, StudyError> {
        let settings = Settings { sampling, ..self.settings.clone() };
        let scene = &self.source.scene;
        Engine::new(&scene.description, &settings).map_err(super::study::failed(self.source))
    }

    fn pixels(&self) -> usize {
        self.settings.width as usize * self.settings.height as usize
    }

    /// Returns the light of a picture, and the CPU seconds that it takes.
    fn traced(&self, engine: &Engine) -> (Vec<Rgb<f32>>, f64) {
        let mut light = vec![Rgb::default(); self.pixels()];
        let start = ThreadTime::now();
        engine.linear_rows(0, &mut light);
        (light, start.elapsed().as_secs_f64())
    }

    /// Returns the picture that the others are compared with, and its own error.
    fn reference(
        &self,
        lamps: Lamps,
        size: Size,
        stop: &AtomicBool,
    ) -> Result<(Vec<Rgb<f32>>, f64), StudyError> {
        let spreading = |samples| Spreading { samples, lamps, split: 1, integrator: Integrator::Whitted };
        let sampling = Sobol::new(REFERENCE, REFERENCE_SEED).map(spreading).map(Sampler::Sobol);
        let engine = self.engine(sampling.unwrap_or(Sampler::CENTER))?;
        let mut passes = engine.passes().ok_or(PictureError::Memory(size))?;
        let pool = bands::pool(None)?;
        while passes.samples() < REFERENCE {
            passes.pass(REFERENCE, &pool, stop, None, &|_| {}).map_err(bands::BandsError::from)?;
        }
        let mut light = vec![Rgb::default(); self.pixels()];
        passes.linear_rows(0, &mut light);
        Ok((light, passes.error()))
    }
}

/// Studies how rays are spread in a scene.
///
/// # Errors
/// [`RequestError::Engine`](crate::request::error::RequestError::Engine), [`PictureError::Memory`] and
/// [`BandsError`](bands::BandsError).
pub fn study(source: &Source, setup: Setup) -> Result<Spread, StudyError> {
    let description = &source.scene.description;
    let side = |pixels: u32| (pixels / STEP).max(1);
    let size = Size::clamped(side(setup.size.width()), side(setup.size.height()));
    let settings = Settings {
        width: size.width(),
        height: size.height(),
        aspect: setup.aspect,
        format: Format::F64,
        model: description.model,
        depth: description.settings.depth.unwrap_or(DEPTH),
        cutoff: Cutoff::of(&description.settings),
        sampling: Sampler::CENTER,
    };
    let (scene, has_area_lamp) = (Scene { source, settings }, has_area_lamp(description));
    let lamps = if has_area_lamp { Lamps::Area } else { Lamps::Point };
    let (reference, reference_error) = scene.reference(lamps, size, setup.stop)?;
    let mut curves = Vec::new();
    for (way, samplers) in ways(has_area_lamp) {
        let mut rows = Vec::new();
        for (samples, sampling) in samplers {
            setup.go_on()?;
            // Cones do not know all scenes.
            if sampling == Sampler::Cones && !cones::knows(description) {
                continue;
            }
            let engine = scene.engine(sampling)?;
            let (light, seconds) = scene.traced(&engine);
            let more = if samples <= 16 { REPEATS - 1 } else { 0 };
            let times = (0..more).map(|_| scene.traced(&engine).1).chain([seconds]).collect();
            rows.push(Row {
                samples,
                error: Difference::between(&light, &reference, 1.0 / 255.0),
                rays: engine.rays(),
                seconds: median(times),
            });
        }
        if rows.is_empty() {
            continue;
        }
        let points: Vec<_> = rows.iter().map(|row| (f64::from(row.samples), row.error.rmse)).collect();
        curves.push(Curve { way: way.map(String::from), slope: slope(&points), rows });
    }
    let variances = has_area_lamp.then(|| variance::measured(&scene, setup)).transpose()?;
    Ok(Spread { title: source.title.clone(), size, curves, variances, reference_error })
}
