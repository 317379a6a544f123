//! A picture in memory, before any device.

use core::sync::atomic::AtomicBool;

use rayon::ThreadPool;
use rta_core::color::Rgb;
use rta_core::raster::lattice::Lattice;
use rta_scenes::sampler::Sampler;

use crate::engine::{Engine, bands};
use crate::picture::coloring::{Coloring, on_grid};
use crate::picture::device::Device;
use crate::picture::error::PictureError;
use crate::picture::file::Displayed;
use crate::picture::raster::Size;
use crate::picture::screen::Screen;
use crate::request::Request;
use crate::request::scene_file::SceneFile;
use crate::study::error::StudyError;

/// A scene's picture as linear light, in a device's raster and shape.
#[derive(Clone, Debug)]
pub struct Traced {
    /// Pixels.
    pub size: Size,
    /// Width over height of the screen that they fill.
    pub aspect: f64,
    /// Linear light, row by row from the top.
    pub light: Vec<Rgb<f32>>,
    /// The reference: the light clamped to 0..1, with 8 bits a register, as a window or a picture file without a device shows it.
    pub reference: Vec<Rgb<u8>>,
    /// One sample in the middle of each pixel, of which colour tables are made.
    centers: Vec<Rgb<u8>>,
}

impl Traced {
    /// Traces a scene.
    ///
    /// # Errors
    /// Those of [`Request::engine`], [`PictureError::Memory`], and
    /// [`Interrupted`](crate::engine::bands::BandsError::Interrupted).
    pub fn new(
        request: &Request,
        scene: &SceneFile,
        pool: &ThreadPool,
        stop: &AtomicBool,
    ) -> Result<Self, StudyError> {
        let (size, aspect) = request.raster()?;
        let trace = |request: &Request| light(&request.engine(scene)?, size, pool, stop);
        let light = trace(request)?;
        let reference = levels(&light, u8::MAX);
        let centers = if request.sampling == Sampler::CENTER {
            reference.clone()
        } else {
            levels(&trace(&Request { sampling: Sampler::CENTER, ..request.clone() })?, u8::MAX)
        };
        Ok(Self { size, aspect, light, reference, centers })
    }

    /// Returns the picture as a device shows it, read back from the device.
    ///
    /// # Errors
    /// [`PictureError::LargerThanDevice`] and [`PictureError::Display`].
    pub fn displayed(&self, device: Device, coloring: Coloring) -> Result<Displayed, PictureError> {
        let samples = |lattice: Lattice| Ok::<_, PictureError>(on_grid(&self.centers, self.size, lattice));
        let mut screen = Screen::new((device, coloring), (self.size, self.aspect), samples)?;
        screen.put_rows(0, &levels(&self.light, coloring.light_max(device.capabilities())))?;
        screen.picture()
    }
}

/// Returns light as levels of guns 0..=`most`.
#[must_use]
pub fn levels(light: &[Rgb<f32>], most: u8) -> Vec<Rgb<u8>> {
    light.iter().map(|light| light.levels(most)).collect()
}

/// Returns the light of a whole picture.
///
/// # Errors
/// [`PictureError::Memory`] and [`Interrupted`](crate::engine::bands::BandsError::Interrupted).
pub fn light(
    engine: &Engine,
    size: Size,
    pool: &ThreadPool,
    stop: &AtomicBool,
) -> Result<Vec<Rgb<f32>>, StudyError> {
    let mut light = Vec::new();
    light.try_reserve_exact(size.pixels()).map_err(|_| PictureError::Memory(size))?;
    let trace = |first, rows: &mut [_]| engine.linear_rows(first, rows);
    bands::bands(size, pool, stop, trace, |_, rows| {
        light.extend(rows);
        Ok::<_, StudyError>(())
    })?;
    Ok(light)
}
