//! The branches that a pixel took: each ray of its tree, what it met, and how each lamp shone there.
//!
//! A [`RayTree`] is recorded by an observer of the tracer. It holds what
//! matters: objects, insides, tiles, shadows, highlights, total reflections. A search that was only cut short at
//! another place is not in it. One ray is sent through the middle of each pixel, and all of its tree is followed.

use core::ops::Range;

use rayon::prelude::*;
use rta_core::color::Rgb;
use rta_core::illumination::Illumination;
use rta_core::needs::Everything;
use rta_core::raster::{Pixels, Raster};
use rta_core::trace::Tracer;
use rta_scenes::description::Description;
use rta_scenes::narrow::narrow;
use rta_scenes::{in_format, in_model};

use super::log::{self, Log};
use super::ray_tree::RayTree;
use super::recorder::{Readable, Recorder};
use super::{Paired, Value};
use crate::engine::{EngineError, MAX_DEPTH, Settings};

/// A pixel and how it came about.
#[derive(Clone, Debug)]
pub struct Pixel {
    /// Linear light.
    pub light: [f64; 3],
    /// The levels of the guns, rounded by the number format itself, for each of [`GUNS`].
    pub levels: [Rgb<u8>; GUNS.len()],
    /// The branches.
    pub tree: RayTree,
    /// What paired numbers recorded; empty for all others.
    pub log: Log,
}

/// The largest levels of the guns of the three devices: mode 13h, graPHIGS, PIXRECT.
pub const GUNS: [u8; 3] = [63, 15, 255];

/// The pixels of some rows, from left to right and from top to bottom.
///
/// # Errors
/// Whatever keeps the scene from being drawn with these settings.
pub fn pixels(scene: &Description, settings: &Settings, rows: Range<u32>) -> Result<Vec<Pixel>, EngineError> {
    let window = Window { rows, skip: 0, take: usize::MAX };
    in_format!(settings.format, S => modelled::<S>(scene, settings, &window))
}

/// All pixels of a picture, on all cores.
///
/// # Errors
/// Whatever keeps the scene from being drawn with these settings.
pub fn picture(scene: &Description, settings: &Settings) -> Result<Vec<Pixel>, EngineError> {
    let row = |y| pixels(scene, settings, y..y + 1);
    let rows: Result<Vec<_>, _> = (0..settings.height).into_par_iter().map(row).collect();
    Ok(rows?.into_iter().flatten().collect())
}

/// One pixel in lock step with `f64`; nothing where the raster has no such pixel.
///
/// # Errors
/// Whatever keeps the scene from being drawn with these settings.
pub fn lock_step(
    scene: &Description,
    settings: &Settings,
    x: u32,
    y: u32,
) -> Result<Option<Pixel>, EngineError> {
    let window = Window { rows: y..y.saturating_add(1), skip: x as usize, take: 1 };
    let pixels = in_format!(settings.format, S => modelled::<Paired<S>>(scene, settings, &window));
    Ok(if x < settings.width { pixels?.pop() } else { None })
}

/// The pixels to trace: of some rows, `take` pixels after the first `skip`.
struct Window {
    rows: Range<u32>,
    skip: usize,
    take: usize,
}

fn modelled<S: Readable>(
    scene: &Description,
    settings: &Settings,
    window: &Window,
) -> Result<Vec<Pixel>, EngineError> {
    in_model!(settings.model, model => watched::<S, _>(scene, settings, window, model))
}

fn watched<S: Readable, M: Illumination<S>>(
    scene: &Description,
    settings: &Settings,
    window: &Window,
    model: M,
) -> Result<Vec<Pixel>, EngineError> {
    let raster = Raster::new(settings.width, settings.height)?;
    let scene = narrow::<S>(scene, settings.aspect)?;
    // One object after the other: what a hierarchy leaves out decides nothing in a picture, so its decisions are none of the
    // picture's branches.
    let admitted = scene.scene().admit(&scene.camera).map_err(rta_core::Error::from)?;
    let tracer = Tracer::<S, _, Everything, { MAX_DEPTH as usize }>::new(admitted, model, settings.depth)?;
    let mut traced = Pixels::rows(&tracer, &scene.camera, raster, window.rows.start, window.rows.end);
    let mut recorder = Recorder::new(&scene.scene());
    let mut pixels = Vec::new();
    for _ in traced.by_ref().take(window.skip) {}
    while pixels.len() < window.take {
        let (light, log) = log::record(|| traced.next_observed(&mut recorder));
        let Some(light) = light else { break };
        let tree = core::mem::take(&mut recorder.tree);
        let Rgb { r, g, b } = light.map(Value::value);
        pixels.push(Pixel { light: [r, g, b], levels: GUNS.map(|max| light.levels(max)), tree, log });
    }
    Ok(pixels)
}
