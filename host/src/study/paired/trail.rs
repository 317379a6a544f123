//! The branches that a pixel took: each ray of its tree, what it met, and how each lamp shone there.
//!
//! A [`Trail`] is told by a model of illumination that passes everything on to another one and looks on. It holds what
//! matters: objects, insides, tiles, shadows, highlights, total reflections. A search that was only cut short at
//! another place is not in it. One ray is sent through the middle of each pixel, and all of its tree is followed.

use core::ops::Range;
use std::sync::Mutex;

use rayon::prelude::*;
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Phong, RayKind, Rta, Whitted};
use rta_core::needs::Needs;
use rta_core::raster::{Pixels, Raster};
use rta_core::scene::Object;
use rta_core::trace::Tracer;
use rta_core::{Q16, Q20};
use rta_scenes::description::Description;
use rta_scenes::narrow::narrow;

use super::log::{self, Log};
use super::witness::{Notes, Readable, Witness, lock};
use super::{Paired, Value};
use crate::engine::{self, EngineError, MAX_DEPTH, Model, Settings};

/// Everything, but the spheres are tried one after the other: what a hierarchy leaves out decides nothing in a picture,
/// so its decisions are none of the picture's branches.
struct OneByOne;

impl Needs for OneByOne {
    const HIERARCHY: bool = false;
    const BOXES: bool = false;
}

/// What a ray met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Met {
    /// Nothing.
    Sky,
    /// A tile of the floor: one of the odd ones, or not.
    Floor {
        /// Whether it has the second colour.
        odd: bool,
    },
    /// Any other object, by its place in its list.
    Object(Object),
}

/// How a lamp shines on a surface.
#[derive(Clone, Copy, Debug)]
pub enum Shine {
    /// Not at all: it is behind the surface.
    Behind,
    /// Too faint for the number format, so nobody asked for its shadow.
    Faint,
    /// It is in front.
    Front {
        /// What part of its light comes through: 0 in the shadow.
        part: f64,
        /// Whether it makes a cut-out highlight there.
        glint: bool,
    },
}

impl Shine {
    /// Whether the two are one branch. What is too faint in one format brings next to nothing in another.
    fn is_like(self, other: Self) -> bool {
        // The parts are products of a few coefficients, each rounded.
        const ROUNDING: f64 = 1e-5;
        match (self, other) {
            (Self::Behind, Self::Behind) | (Self::Faint, Self::Faint | Self::Behind) => true,
            (Self::Behind, Self::Faint) => true,
            (Self::Faint, Self::Front { glint, .. }) | (Self::Front { glint, .. }, Self::Faint) => !glint,
            (Self::Front { part: a, glint: b }, Self::Front { part: c, glint: d }) => {
                (a - c).abs() < ROUNDING && (b == d || a == 0.0)
            }
            _ => false,
        }
    }
}

/// One ray and what came of it.
#[derive(Clone, Debug)]
pub struct Step {
    /// What it was traced for.
    pub kind: RayKind,
    /// How many rays there are between it and the eye.
    pub depth: u8,
    /// What it met.
    pub met: Met,
    /// How far away, where that was a surface.
    pub distance: Option<f64>,
    /// Whether it met that from the inside.
    pub inside: bool,
    /// Whether all of it was reflected there that should have been transmitted.
    pub total_reflection: bool,
    /// How each lamp shines there; none where the surface is not lit.
    pub lamps: Vec<Shine>,
}

impl Step {
    /// Whether the two took the same branches.
    #[must_use]
    pub fn is_like(&self, other: &Self) -> bool {
        self.kind == other.kind
            && self.depth == other.depth
            && self.met == other.met
            && self.inside == other.inside
            && self.total_reflection == other.total_reflection
            && self.lamps.len() == other.lamps.len()
            && self.lamps.iter().zip(&other.lamps).all(|(a, b)| a.is_like(*b))
    }
}

/// The ray tree of a pixel, in the order it is followed.
#[derive(Clone, Debug, Default)]
pub struct Trail {
    /// The rays.
    pub steps: Vec<Step>,
}

impl Trail {
    /// The first ray with another branch; nothing where the two are one.
    #[must_use]
    pub fn parting(&self, other: &Self) -> Option<usize> {
        let like = self.steps.iter().zip(&other.steps).take_while(|(a, b)| a.is_like(b)).count();
        (like < self.steps.len().max(other.steps.len())).then_some(like)
    }
}

/// A pixel and how it came about.
#[derive(Clone, Debug)]
pub struct Pixel {
    /// Linear light.
    pub light: [f64; 3],
    /// The levels of the guns, rounded by the number format itself, for each of [`GUNS`].
    pub levels: [Rgb<u8>; GUNS.len()],
    /// The branches.
    pub trail: Trail,
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
    match settings.format {
        engine::Format::F32 => modelled::<f32>(scene, settings, &window),
        engine::Format::F64 => modelled::<f64>(scene, settings, &window),
        engine::Format::Q16 => modelled::<Q16>(scene, settings, &window),
        engine::Format::Q20 => modelled::<Q20>(scene, settings, &window),
    }
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
    let pixels = match settings.format {
        engine::Format::F32 => modelled::<Paired<f32>>(scene, settings, &window),
        engine::Format::F64 => modelled::<Paired<f64>>(scene, settings, &window),
        engine::Format::Q16 => modelled::<Paired<Q16>>(scene, settings, &window),
        engine::Format::Q20 => modelled::<Paired<Q20>>(scene, settings, &window),
    };
    Ok(if x < settings.width { pixels?.pop() } else { None })
}

/// Which pixels: of some rows, `take` after the first `skip`.
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
    match settings.model {
        Model::Rta => watched::<S, _>(scene, settings, window, Rta),
        Model::Whitted => watched::<S, _>(scene, settings, window, Whitted::default()),
        Model::Phong => watched::<S, _>(scene, settings, window, Phong::default()),
    }
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
