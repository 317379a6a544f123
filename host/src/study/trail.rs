//! The branches that the pixels of a picture took: see [`rta_paired::trail`].

use rta_paired::trail::{Pixel, Window, pixels};
use rta_scenes::description::Description;
use rta_scenes::in_format;

use crate::engine::{EngineError, Settings};

/// Returns all pixels of a picture.
///
/// # Errors
/// Whatever keeps the scene from being drawn with these settings.
pub fn picture(scene: &Description, settings: &Settings) -> Result<Vec<Pixel>, EngineError> {
    traced(scene, settings, &Window { rows: 0..settings.height, columns: 0..settings.width })
}

/// Returns one pixel; nothing where the raster has no such pixel.
///
/// # Errors
/// Whatever keeps the scene from being drawn with these settings.
pub fn pixel(scene: &Description, settings: &Settings, x: u32, y: u32) -> Result<Option<Pixel>, EngineError> {
    Ok(traced(scene, settings, &Window::at(x, y))?.pop())
}

/// Returns one pixel in lock step with `f64`; nothing where the raster has no such pixel.
///
/// # Errors
/// Whatever keeps the scene from being drawn with these settings.
pub fn lock_step(
    scene: &Description,
    settings: &Settings,
    x: u32,
    y: u32,
) -> Result<Option<Pixel>, EngineError> {
    rta_paired::trail::lock_step(scene, (settings.format, settings.model), &settings.setup()?, (x, y))
}

fn traced(scene: &Description, settings: &Settings, window: &Window) -> Result<Vec<Pixel>, EngineError> {
    in_format!(settings.format, S => pixels::<S>(scene, settings.model, &settings.setup()?, window))
}
