//! What pictures by one cone over each pixel get wrong, beside pictures of many rays (J. Amanatides 1984).
//!
//! Pixels of which the right light is known tell why; pictures of small scenes tell by how much.

use core::sync::atomic::AtomicBool;

use cpu_time::ThreadTime;
use rayon::ThreadPool;
use rta_core::color::Rgb;
use rta_core::sampling::{Sampling, Sobol};
use rta_packets::tally::Rays;
use rta_scenes::Reading;
use rta_scenes::sampler::{Integrator, Lamps, Sampler, Spreading};

use crate::engine::{Engine, EngineError, Format, Settings, bands};
use crate::picture::error::PictureError;
use crate::picture::raster::Size;
use crate::request::error::RequestError;
use crate::request::scene_file::SceneFile;
use crate::study::error::StudyError;
use crate::study::report::measure::Difference;
use pictures::{PICTURES, Picture, SIZE};
use pixels::CASES;

pub mod page;
pub mod pictures;
pub mod pixels;

/// Samples of the pictures that are right.
pub const REFERENCE: u32 = 1024;

/// Samples of a pixel that is right.
pub const PIXEL: u32 = 1 << 14;

/// Depth of the rays.
const DEPTH: u32 = 5;

/// A pixel by one cone and by many rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Its green light by a cone.
    pub cone: f64,
    /// By [`PIXEL`] rays.
    pub rays: f64,
}

/// A picture in one way, beside one of [`REFERENCE`] samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The way.
    pub way: &'static str,
    /// Its error.
    pub error: Difference,
    /// Its rays or cones, by kind.
    pub rays: Rays,
    /// CPU seconds on one thread.
    pub seconds: f64,
}

/// The ways of a scene.
#[derive(Clone, Debug)]
pub struct Ways {
    /// The scene's name.
    pub title: &'static str,
    /// What is in it that is of interest.
    pub about: &'static str,
    /// The ways.
    pub rows: Vec<Row>,
}

/// The whole study.
#[derive(Clone, Debug)]
pub struct Study {
    /// The pixels, in the order of [`CASES`].
    pub pixels: Vec<Pixel>,
    /// The pictures.
    pub pictures: Vec<Ways>,
}

/// Returns samples whose rays are spread, lamps with a size at all of their places.
#[must_use]
pub fn rays(samples: u32) -> Sampler {
    let spreading =
        |samples| Spreading { samples, lamps: Lamps::Area, split: 1, integrator: Integrator::Whitted };
    Sobol::new(samples, 0x5eed).map_or(Sampler::CENTER, |samples| Sampler::Sobol(spreading(samples)))
}

/// Makes a scene of the study ready.
///
/// # Errors
/// Those of reading it and of [`Engine::new`]: none are expected.
fn engine(title: &str, text: &str, (size, sampling): (Size, Sampler)) -> Result<Engine, StudyError> {
    let scene = SceneFile::of_text(title, text, Reading::default())?;
    let settings = Settings {
        width: size.width(),
        height: size.height(),
        aspect: size.ratio(),
        format: Format::F64,
        model: scene.description.model,
        depth: DEPTH,
        cutoff: None,
        sampling,
    };
    let failed = |source: EngineError| RequestError::Engine { name: scene.source.clone(), source };
    Ok(Engine::new(&scene.description, &settings).map_err(failed)?)
}

/// Returns the number of pixels.
fn pixels(size: Size) -> usize {
    size.columns() * size.height() as usize
}

/// Returns the light of a picture.
fn light(engine: &Engine, size: Size) -> Vec<Rgb<f32>> {
    let mut light = vec![Rgb::default(); pixels(size)];
    engine.linear_rows(0, &mut light);
    light
}

/// Returns a pixel by one cone and by many rays.
///
/// # Errors
/// Those of reading its scene and of making it ready: none are expected.
pub fn pixel(text: &str) -> Result<Pixel, StudyError> {
    let size = Size::clamped(1, 1);
    let green = |sampling| {
        let light = light(&engine("pixel", text, (size, sampling))?, size);
        Ok::<_, StudyError>(light.first().map_or(0.0, |light| f64::from(light.g)))
    };
    Ok(Pixel { cone: green(Sampler::Cones)?, rays: green(rays(PIXEL))? })
}

/// Studies cones.
///
/// # Errors
/// [`BandsError::Interrupted`](bands::BandsError::Interrupted) soon after `stop` becomes true; others are not expected.
pub fn study(stop: &AtomicBool) -> Result<Study, StudyError> {
    let pool = bands::pool(None)?;
    let pixels = CASES.iter().map(|case| pixel(&case.text())).collect::<Result<_, _>>()?;
    let ways = |picture| ways(picture, (SIZE, REFERENCE), &pool, stop);
    Ok(Study { pixels, pictures: PICTURES.iter().map(ways).collect::<Result<_, _>>()? })
}

/// Returns a scene in all ways, in so many columns and rows, beside a picture of so many samples.
///
/// # Errors
/// Those of [`study`].
pub fn ways(
    picture: &Picture,
    ([width, height], reference): ([u32; 2], u32),
    pool: &ThreadPool,
    stop: &AtomicBool,
) -> Result<Ways, StudyError> {
    let size = Size::clamped(width, height);
    let made = |sampling| engine(picture.title, picture.text, (size, sampling));
    let right = made(rays(reference))?;
    let mut passes = right.passes().ok_or(PictureError::Memory(size))?;
    while passes.samples() < reference {
        passes.pass(reference, pool, stop, None, &|_| {}).map_err(bands::BandsError::from)?;
    }
    let mut right = vec![Rgb::default(); pixels(size)];
    passes.linear_rows(0, &mut right);
    let grid = Sampling::grid(4).map_or(Sampler::CENTER, Sampler::Grid);
    let samplers = [
        ("one cone", Sampler::Cones),
        ("1 ray", Sampler::CENTER),
        ("4 x 4 rays, points", grid),
        ("1 sample", other(1)),
        ("4 samples", other(4)),
        ("16 samples", other(16)),
        ("64 samples", other(64)),
    ];
    let rows = samplers.map(|(way, sampling)| {
        let engine = made(sampling)?;
        let start = ThreadTime::now();
        let own = light(&engine, size);
        let seconds = start.elapsed().as_secs_f64();
        Ok(Row { way, error: Difference::between(&own, &right, 1.0 / 255.0), rays: engine.rays(), seconds })
    });
    let rows = rows.into_iter().collect::<Result<_, StudyError>>()?;
    Ok(Ways { title: picture.title, about: picture.about, rows })
}

/// Returns samples by another seed than the reference's.
fn other(samples: u32) -> Sampler {
    match rays(samples) {
        Sampler::Sobol(own) => {
            let samples = Sobol::new(samples, 0).unwrap_or(own.samples);
            Sampler::Sobol(Spreading { samples, ..own })
        }
        sampler => sampler,
    }
}

#[cfg(test)]
mod tests;
