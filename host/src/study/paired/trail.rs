//! The branches that a pixel took: each ray of its tree, what it met, and how each lamp shone there.
//!
//! A [`RayTree`] is told by a model of illumination that passes everything on to another one and looks on. It holds what
//! matters: objects, insides, tiles, shadows, highlights, total reflections. A search that was only cut short at
//! another place is not in it. One ray is sent through the middle of each pixel, and all of its tree is followed.

use core::ops::Range;
use std::sync::Mutex;

use rayon::prelude::*;
use rta_core::color::Rgb;
use rta_core::illumination::Illumination;
use rta_core::needs::Needs;
use rta_core::raster::{Pixels, Raster};
use rta_core::trace::Tracer;
use rta_scenes::description::Description;
use rta_scenes::narrow::narrow;

use super::log::{self, Log};
use super::ray_tree::RayTree;
use super::witness::{Notes, Readable, Witness, lock};
use super::{Paired, Value};
use crate::engine::{EngineError, MAX_DEPTH, Settings, in_format, in_model};

/// Everything, but the spheres are tried one after the other: what a hierarchy leaves out decides nothing in a picture,
/// so its decisions are none of the picture's branches.
struct OneByOne;

impl Needs for OneByOne {
    const HIERARCHY: bool = false;
    const BOXES: bool = false;
}

/// A pixel with its ray tree.
#[derive(Clone, Debug)]
pub struct Pixel {
    /// Linear light.
    pub light: [f64; 3],
    /// The levels of the guns, rounded by the number format itself, for each of [`GUNS`].
    pub levels: [Rgb<u8>; GUNS.len()],
    /// The ray tree.
    pub trail: RayTree,
    /// The log of paired numbers; empty for all others.
    pub log: Log,
}

/// The largest levels of the guns of the three devices: mode 13h, graPHIGS, PIXRECT.
pub const GUNS: [u8; 3] = [63, 15, 255];

/// Returns the pixels of some rows, from left to right and from top to bottom.
///
/// # Errors
/// [`EngineError`] if the scene cannot be drawn with these settings.
pub fn pixels(scene: &Description, settings: &Settings, rows: Range<u32>) -> Result<Vec<Pixel>, EngineError> {
    let window = Window { rows, skip: 0, take: usize::MAX };
    in_format!(settings.format, S => modelled::<S>(scene, settings, &window))
}

/// Returns all pixels of a picture, traced on all cores.
///
/// # Errors
/// [`EngineError`] if the scene cannot be drawn with these settings.
pub fn picture(scene: &Description, settings: &Settings) -> Result<Vec<Pixel>, EngineError> {
    let row = |y| pixels(scene, settings, y..y + 1);
    let rows: Result<Vec<_>, _> = (0..settings.height).into_par_iter().map(row).collect();
    Ok(rows?.into_iter().flatten().collect())
}

/// Traces one pixel in lock step with `f64`; returns none where the raster has no such pixel.
///
/// # Errors
/// [`EngineError`] if the scene cannot be drawn with these settings.
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
    let notes = Mutex::new(Notes::default());
    let witness = Witness { model, scene: scene.scene(), notes: &notes };
    let admitted = scene.scene().admit(&scene.camera).map_err(rta_core::Error::from)?;
    let tracer = Tracer::<S, _, OneByOne, { MAX_DEPTH as usize }>::new(admitted, witness, settings.depth)?;
    let mut traced = Pixels::rows(&tracer, &scene.camera, raster, window.rows.start, window.rows.end);
    let mut pixels = Vec::new();
    for _ in traced.by_ref().take(window.skip) {
        *lock(&notes) = Notes::default();
    }
    while pixels.len() < window.take {
        let (light, log) = log::record(|| traced.next());
        let Some(light) = light else { break };
        let trail = core::mem::take(&mut *lock(&notes)).trail;
        let Rgb { r, g, b } = light.map(Value::value);
        pixels.push(Pixel { light: [r, g, b], levels: GUNS.map(|max| light.levels(max)), trail, log });
    }
    Ok(pixels)
}
