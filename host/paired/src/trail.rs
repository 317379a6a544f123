//! The branches that a pixel took: each ray of its tree, what it met, and how each lamp shone there.
//!
//! A [`RayTree`] is recorded by an observer of the tracer. It holds what
//! matters: objects, insides, tiles, shadows, highlights, total reflections. A search that was only cut short at
//! another place is not in it. One ray is sent through the middle of each pixel, and all of its tree is followed.

use core::ops::Range;

use rayon::prelude::*;
use rta_core::camera::Camera;
use rta_core::color::Rgb;
use rta_core::needs::Everything;
use rta_core::range::Admitted;
use rta_core::raster::Raster;
use rta_core::sampling::{Center, Places};
use rta_core::trace::Trace;
use rta_packets::picture::{MAX_DEPTH, PictureError, Setup};
use rta_packets::{Packets, ShadowCache, ToF32};
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrowed, narrow};
use rta_scenes::shading::{AnySpectrum, Wavelengths};
use rta_scenes::{Format, Model, in_format};

use crate::log::{self, Log};
use crate::ray_tree::RayTree;
use crate::recorder::{Readable, Recorder};
use crate::{Paired, Value};

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

/// Returns one pixel in lock step with `f64`; nothing where the raster has no such pixel.
///
/// # Errors
/// Whatever keeps the scene from being drawn with these settings.
pub fn lock_step(
    scene: &Description,
    (format, model): (Format, Model),
    setup: &Setup,
    (x, y): (u32, u32),
) -> Result<Option<Pixel>, PictureError> {
    let window = Window::at(x, y);
    let pixels = in_format!(format, S => pixels::<Paired<S>>(scene, model, setup, &window));
    Ok(pixels?.pop())
}

/// The pixels to trace, as far as the raster has them.
#[derive(Clone, Debug)]
pub struct Window {
    /// Rows.
    pub rows: Range<u32>,
    /// Columns.
    pub columns: Range<u32>,
}

impl Window {
    /// Returns the window of one pixel.
    #[must_use]
    pub const fn at(x: u32, y: u32) -> Self {
        Self { rows: y..y.saturating_add(1), columns: x..x.saturating_add(1) }
    }
}

/// Returns the pixels of a window in the format `S`, from left to right and from top to bottom. They are traced on all cores, all of each
/// tree, whatever the cut-off.
///
/// # Errors
/// Whatever keeps the scene from being drawn with these settings.
// The objects are searched for as in a picture: what a hierarchy leaves out decides nothing in it, is none of its branches, and
// would take the time of a ray's way through all of a large scene, and the memory of all its operations.
pub fn pixels<S: Readable + ToF32>(
    scene: &Description,
    model: Model,
    setup: &Setup,
    window: &Window,
) -> Result<Vec<Pixel>, PictureError> {
    let narrowed = narrow::<S>(scene, setup.aspect)?;
    let limits = narrowed.admit()?.limits;
    let depth = u8::try_from(setup.depth).unwrap_or(u8::MAX);
    narrowed.scene().check_depth(depth)?;
    let packets = Packets::build::<S>(scene);
    let admitted = Admitted::baked(narrowed.scene(), limits, &packets);
    let wavelengths = Wavelengths::new(model, &scene.air, &narrowed, limits);
    let place = (&narrowed, setup.raster, window);
    Ok(wavelengths.with_tracer(&narrowed, &admitted, (setup.depth, None), |tracer| trace(tracer, place))?)
}

type Traced<'t, 'a, S> = AnySpectrum<'t, S, Everything, { MAX_DEPTH as usize }, &'a Packets>;

/// Traces the pixels of a window. Where one is made of several wavelengths, the trees of all follow each other.
fn trace<S: Readable + ToF32>(
    tracer: &Traced<'_, '_, S>,
    (narrowed, raster, window): (&Narrowed<S>, Raster, &Window),
) -> Vec<Pixel> {
    let rows = window.rows.start..window.rows.end.min(raster.height());
    let row = |y: u32| -> Vec<Pixel> {
        let mut recorder = Recorder::new(&narrowed.scene());
        let row = Places::row::<S::Unit>(&Center, raster, y);
        let columns = window.columns.start..window.columns.end.min(raster.width());
        let pixels = columns.map(|x| {
            let (light, log) = log::record(|| {
                let (right, up) = Center.place(raster, row, x, 0);
                let Camera { eye, .. } = narrowed.camera;
                let direction = narrowed.camera.direction(right, up);
                // Nothing is kept from pixel to pixel, so that each is explained by itself.
                tracer.trace(eye, direction, &mut ShadowCache::default(), &mut recorder)
            });
            let tree = core::mem::take(&mut recorder.tree);
            let Rgb { r, g, b } = light.map(Value::value);
            Pixel { light: [r, g, b], levels: GUNS.map(|max| light.levels(max)), tree, log }
        });
        pixels.collect()
    };
    rows.into_par_iter().flat_map_iter(row).collect()
}
