//! The engine: a scene made ready to be traced in one number format with one illumination model, both chosen when the program
//! runs.
//!
//! Everything about it that does not draw is beside it: [`admission`] proves that a scene fits a format, [`bands`] shares rows
//! among threads, [`tally`] counts rays and [`callgrind`] instructions.

use rta_core::Error;
use rta_core::color::Rgb;
use rta_core::illumination::Illumination;
use rta_core::needs::Everything;
use rta_core::range::{Admitted, Limits};
use rta_core::raster::{Pixels, Raster};
use rta_core::sampling::{Sampling, Supersampled};
use rta_core::scalar::Unit;
use rta_core::trace::Tracer;
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrow, NarrowError, Narrowed, narrow};

pub mod admission;
pub mod bands;
pub mod callgrind;
pub mod cutoff;
pub mod format;
pub mod interrupt;
pub mod model;
pub mod progress;
pub mod tally;

pub use cutoff::Cutoff;
pub use format::Format;
pub use model::Model;

pub(crate) use format::in_format;
pub(crate) use model::in_model;

use tally::{Rays, Tally};

/// The settings that a picture is computed with.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Width over height of the screen (not of the raster).
    pub aspect: f64,
    /// The number format.
    pub format: Format,
    /// The illumination model.
    pub model: Model,
    /// Recursion depth, 0 to [`MAX_DEPTH`].
    pub depth: u32,
    /// Rays that would bring a smaller part of their light into the pixel are not traced.
    pub cutoff: Cutoff,
    /// Samples of a pixel. The light of one in its middle is kept as it is; the mean of several is that of displayable
    /// light (see [`Sampling::mean`]).
    pub sampling: Sampling,
}

impl Default for Settings {
    /// The raster of a PS/2 on its 4 : 3 screen, in `f32`, with the thesis's model, depth 5 and one sample a pixel.
    fn default() -> Self {
        Self {
            width: 320,
            height: 200,
            aspect: 4.0 / 3.0,
            format: Format::F32,
            model: Model::Rta,
            depth: 5,
            cutoff: Cutoff::OFF,
            sampling: Sampling::CENTER,
        }
    }
}

/// The greatest recursion depth, which is the capacity of the tracer's stack of pending rays.
pub const MAX_DEPTH: u32 = 32;

/// Why a scene cannot be drawn with some settings.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EngineError {
    /// The scene does not fit the number format.
    #[error(transparent)]
    Narrow(#[from] NarrowError),
    /// Raster, depth, or what the core's own range check finds.
    #[error(transparent)]
    Core(#[from] Error),
}

/// A scene made ready to be drawn. Rows may be asked for in any order, from any number of threads.
pub struct Engine {
    settings: Settings,
    rows: Box<dyn Rows>,
}

/// A picture in any number format and with any model: the type behind which [`Engine`] hides them.
trait Rows: Send + Sync {
    fn linear(&self, first: u32, out: &mut [Rgb<f32>]);
    fn levels(&self, first: u32, gun_max: u8, out: &mut [Rgb<u8>]);
    fn rays(&self) -> Rays;
}

type Traced<'a, S, M> = Tracer<'a, S, M, Everything, { MAX_DEPTH as usize }>;

struct Picture<S: Narrow, M> {
    scene: Narrowed<S>,
    limits: Limits<S>,
    model: M,
    depth: u32,
    cutoff: Cutoff,
    sampling: Sampling,
    raster: Raster,
}

impl<S: Narrow, M: Illumination<S> + Copy> Picture<S, M> {
    fn tracer<I: Illumination<S>>(&self, model: I) -> Result<Traced<'_, S, I>, Error> {
        let cutoff = S::Unit::ratio(self.cutoff.numerator(), self.cutoff.denominator());
        // Proved once, when the picture was made ready.
        let admitted = Admitted::baked(self.scene.scene(), self.limits);
        Ok(Tracer::new(admitted, model, self.depth)?.with_cutoff(cutoff))
    }

    /// Converts the light of the pixels from row `first` on. `Engine::new` has made sure that there is a tracer.
    fn each<T, I: Illumination<S>>(
        &self,
        model: I,
        first: u32,
        out: &mut [T],
        convert: impl Fn(Rgb<S::Light>) -> T,
    ) {
        let Ok(tracer) = self.tracer(model) else { return };
        let (camera, raster) = (&self.scene.camera, self.raster);
        let rows = u32::try_from(out.len().div_ceil(raster.width() as usize)).unwrap_or(u32::MAX);
        let end = first.saturating_add(rows).min(raster.height());
        let mut out = out.iter_mut();
        let fill = |light| {
            if let Some(pixel) = out.next() {
                *pixel = convert(light);
            }
        };
        if self.sampling == Sampling::CENTER {
            Pixels::rows(&tracer, camera, raster, first, end).for_each(fill);
        } else {
            Supersampled::rows(&tracer, camera, raster, self.sampling, first, end).for_each(fill);
        }
    }
}

impl<S: Narrow, M: Illumination<S> + Copy> Rows for Picture<S, M> {
    fn linear(&self, first: u32, out: &mut [Rgb<f32>]) {
        self.each(self.model, first, out, |light| light.map(S::widen));
    }

    fn levels(&self, first: u32, gun_max: u8, out: &mut [Rgb<u8>]) {
        self.each(self.model, first, out, |light| light.levels(gun_max));
    }

    fn rays(&self) -> Rays {
        let tally = Tally::default();
        let mut dark = vec![(); (self.raster.width() * self.raster.height()) as usize];
        self.each(tally.model(self.model), 0, &mut dark, |_| ());
        tally.rays()
    }
}

impl Engine {
    /// Makes a scene ready.
    ///
    /// # Errors
    /// [`EngineError`] if the scene cannot be drawn with these settings. Drawing with the engine does not fail.
    pub fn new(scene: &Description, settings: &Settings) -> Result<Self, EngineError> {
        let rows = in_format!(settings.format, S => modelled::<S>(scene, settings))?;
        Ok(Self { settings: settings.clone(), rows })
    }

    /// Returns the settings that the picture is computed with.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Fills `out` with linear light from row `first` on, from left to right and from top to bottom.
    pub fn linear_rows(&self, first: u32, out: &mut [Rgb<f32>]) {
        self.rows.linear(first, out);
    }

    /// Fills `out` with levels `0..=gun_max` of a display's guns from row `first` on, from left to right and from top to bottom.
    /// Light is rounded to levels in the picture's own number format.
    pub fn level_rows(&self, first: u32, gun_max: u8, out: &mut [Rgb<u8>]) {
        self.rows.levels(first, gun_max, out);
    }

    /// Returns how many rays of each kind the whole picture takes. The picture is traced to count them.
    pub fn rays(&self) -> Rays {
        self.rows.rays()
    }
}

fn modelled<S: Narrow>(scene: &Description, settings: &Settings) -> Result<Box<dyn Rows>, EngineError> {
    in_model!(settings.model, model => picture::<S, _>(scene, settings, model))
}

fn picture<S: Narrow, M: Illumination<S> + Copy + 'static>(
    scene: &Description,
    settings: &Settings,
    model: M,
) -> Result<Box<dyn Rows>, EngineError> {
    let raster = Raster::new(settings.width, settings.height)?;
    let Settings { aspect, depth, cutoff, sampling, .. } = *settings;
    let scene = narrow::<S>(scene, aspect)?;
    let limits = scene.scene().admit(&scene.camera).map_err(Error::from)?.limits();
    let picture = Picture { scene, limits, model, depth, cutoff, sampling, raster };
    picture.tracer(model)?;
    Ok(Box::new(picture))
}
