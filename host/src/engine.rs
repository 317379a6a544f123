//! The engine: a scene made ready to be traced in one number format with one illumination model, both chosen when the program
//! runs.
//!
//! Everything about it that does not draw is beside it: [`admission`] proves that a scene fits a format, [`bands`] shares rows
//! among threads, [`cones`] draws pictures by cones instead of rays, [`radiosity`] solves for the light of diffuse surfaces, [`passes`] adds samples to a picture and [`callgrind`] counts instructions.

use core::sync::atomic::AtomicBool;

use rayon::ThreadPool;
use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::raster::lattice::Lattice;
use rta_packets::picture::{self, Picture, PutRow, Setup};
use rta_packets::tally::{Rays, Tally};
use rta_scenes::description::Description;
use rta_scenes::in_format;
use rta_scenes::narrow::Narrow;
use rta_scenes::sampler::Sampler;

use crate::picture::raster::Size;
use bands::BandsError;
use cones::Coned;
use probe::Probe;

pub mod admission;
pub mod bands;
pub mod callgrind;
pub mod cones;
pub mod interrupt;
pub mod passes;
pub mod probe;
pub mod progress;
pub mod radiosity;

pub use rta_args::value::cutoff::{self, Cutoff};
pub use rta_packets::picture::{MAX_DEPTH, PictureError as EngineError};
pub use rta_scenes::{Format, Model};

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
    /// Rays that would bring a smaller part of their light into the pixel are not traced; without it, the model's cut-off counts.
    pub cutoff: Option<Cutoff>,
    /// Samples of a pixel. The light of one in its middle is kept as it is; the mean of several is that of displayable
    /// light.
    pub sampling: Sampler,
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
            cutoff: None,
            sampling: Sampler::CENTER,
        }
    }
}

impl Settings {
    /// Returns what of the settings does not depend on number format and model.
    ///
    /// # Errors
    /// Where a side of the raster is 0 or too long.
    pub fn setup(&self) -> Result<Setup, EngineError> {
        let Self { aspect, depth, cutoff, sampling, .. } = *self;
        let raster = Raster::new(self.width, self.height)?;
        let cutoff = cutoff.map(|cutoff| (cutoff.numerator(), cutoff.denominator()));
        Ok(Setup { raster, aspect, depth, cutoff, sampling })
    }
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
    fn preview(&self, raster: Raster, first: u32, gun_max: u8, out: &mut [Rgb<u8>]);
    fn on_grid(&self, lattice: Lattice, first: u32, out: &mut [Rgb<u8>]);
    fn sums(&self, seed: u32, tolerance: Option<passes::Tolerance>) -> Option<Box<dyn passes::Sums + '_>>;
    fn rays(&self) -> Rays;
    fn rays_before(&self) -> u64;
    fn probe(&self, x: u32, y: u32) -> Probe;
}

impl<S: Narrow> Rows for Box<dyn Picture<S>> {
    fn linear(&self, first: u32, out: &mut [Rgb<f32>]) {
        let rows = |first, end, put: PutRow<S>| self.rows(first, end, put);
        fill::<S, _>(self.setup().raster, first, out, |light| light.map(single::<S>), rows);
    }

    fn levels(&self, first: u32, gun_max: u8, out: &mut [Rgb<u8>]) {
        let rows = |first, end, put: PutRow<S>| self.rows(first, end, put);
        fill::<S, _>(self.setup().raster, first, out, |light| light.levels(gun_max), rows);
    }

    fn preview(&self, raster: Raster, first: u32, gun_max: u8, out: &mut [Rgb<u8>]) {
        let rows = |first, end, put: PutRow<S>| self.preview_rows(raster, first, end, put);
        fill::<S, _>(raster, first, out, |light| light.levels(gun_max), rows);
    }

    fn on_grid(&self, lattice: Lattice, first: u32, out: &mut [Rgb<u8>]) {
        let count = out.len().div_ceil(lattice.grid().width() as usize);
        let end = first.saturating_add(u32::try_from(count).unwrap_or(u32::MAX));
        let mut out = out.iter_mut();
        self.grid_rows(lattice, first, end, &mut |light| {
            out.by_ref().take(1).for_each(|pixel| *pixel = light.levels(u8::MAX));
        });
    }

    fn sums(&self, seed: u32, tolerance: Option<passes::Tolerance>) -> Option<Box<dyn passes::Sums + '_>> {
        passes::begin(&**self, seed, tolerance)
    }

    fn rays(&self) -> Rays {
        let mut tally = Tally::default();
        self.observed_rows(0, u32::MAX, &mut tally);
        tally.0
    }

    fn rays_before(&self) -> u64 {
        (**self).rays_before()
    }

    fn probe(&self, x: u32, y: u32) -> Probe {
        let mut probe = Probe::default();
        self.observed_pixel(x, y, &mut probe);
        probe
    }
}

/// A radiance as a float of single precision.
#[allow(clippy::cast_possible_truncation)] // to the nearest
pub(crate) fn single<S: Narrow>(light: S::Light) -> f32 {
    S::light_to_f64(light) as f32
}

/// Fills `out` with the pixels of a picture on `raster` from row `first` on; `rows` traces them.
fn fill<S: Narrow, T>(
    raster: Raster,
    first: u32,
    out: &mut [T],
    convert: impl Fn(Rgb<S::Light>) -> T,
    rows: impl FnOnce(u32, u32, PutRow<S>),
) {
    let width = raster.width() as usize;
    let count = u32::try_from(out.len().div_ceil(width)).unwrap_or(u32::MAX);
    let mut out = out.chunks_mut(width);
    rows(first, first.saturating_add(count), &mut |row| {
        let pixels = out.next().unwrap_or_default();
        for (pixel, &light) in pixels.iter_mut().zip(row) {
            *pixel = convert(light);
        }
    });
}

impl Engine {
    /// Makes a scene ready.
    ///
    /// # Errors
    /// Whatever keeps it from being drawn with these settings; once there is an engine, nothing does.
    pub fn new(scene: &Description, settings: &Settings) -> Result<Self, EngineError> {
        if settings.sampling == Sampler::Cones {
            let picture = Coned::new(scene, settings.model, settings.setup()?)?;
            let rows = Box::new(Box::new(picture) as Box<dyn Picture<f64>>);
            return Ok(Self { settings: settings.clone(), rows });
        }
        let rows: Box<dyn Rows> = in_format!(settings.format, S => Box::new(
            <S as picture::Format>::picture(scene, settings.model, &settings.setup()?)?
        ));
        Ok(Self { settings: settings.clone(), rows })
    }

    /// How the picture is computed.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Fills `out` with linear light from row `first` on, from left to right and from top to bottom.
    pub fn linear_rows(&self, first: u32, out: &mut [Rgb<f32>]) {
        self.rows.linear(first, out);
    }

    /// Fills `out` with levels `0..=gun_max` of a display's guns from row `first` on, rounded in the picture's own number format.
    pub fn level_rows(&self, first: u32, gun_max: u8, out: &mut [Rgb<u8>]) {
        self.rows.levels(first, gun_max, out);
    }

    /// Fills `out` with levels `0..=gun_max` of a preview of `size` pixels, one sample in the middle of each, from row `first` on. The
    /// preview fills the picture's screen, so that each of its pixels is the colour of about as many of the picture.
    ///
    /// # Errors
    /// Where the tracer has no raster of this size.
    pub fn preview_rows(
        &self,
        size: Size,
        first: u32,
        gun_max: u8,
        out: &mut [Rgb<u8>],
    ) -> Result<(), EngineError> {
        self.rows.preview(Raster::new(size.width(), size.height())?, first, gun_max, out);
        Ok(())
    }

    /// Fills `out` with the colours, 8 bits a gun, of those of the picture's pixels that are on a grid, from row `first` of the grid on,
    /// with one sample in the middle of each pixel.
    pub fn grid_rows(&self, lattice: Lattice, first: u32, out: &mut [Rgb<u8>]) {
        self.rows.on_grid(lattice, first, out);
    }

    /// Returns the colours, 8 bits a gun, of the picture's pixels on a grid, of which a colour table is made, with all threads of `pool`.
    ///
    /// # Errors
    /// [`BandsError::Interrupted`] soon after `stop` becomes true.
    pub fn on_grid(
        &self,
        lattice: Lattice,
        pool: &ThreadPool,
        stop: &AtomicBool,
    ) -> Result<Vec<Rgb<u8>>, BandsError> {
        let (grid, mut pixels) = (lattice.grid(), Vec::new());
        let size = Size::clamped(grid.width(), grid.height());
        bands::bands(
            size,
            pool,
            stop,
            |first, out: &mut [_]| self.grid_rows(lattice, first, out),
            |_, band| {
                pixels.extend(band);
                Ok::<_, BandsError>(())
            },
        )?;
        Ok(pixels)
    }

    /// Traces the pixel in column `x` of row `y` once more and returns what its rays hit and how many there are. Outside of the
    /// picture no ray is traced.
    #[must_use]
    pub fn probe(&self, x: u32, y: u32) -> Probe {
        let inside = x < self.settings.width && y < self.settings.height;
        if inside { self.rows.probe(x, y) } else { Probe::default() }
    }

    /// The rays that were traced to make the scene ready: those that gathered indirect light, where that is gathered for each picture.
    pub fn rays_before(&self) -> u64 {
        self.rows.rays_before()
    }

    /// The rays that the whole picture takes. It is traced for that, with an observer that counts them.
    pub fn rays(&self) -> Rays {
        self.rows.rays()
    }
}
