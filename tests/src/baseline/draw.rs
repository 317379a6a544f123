//! Hashes of the linear light of small pictures, which tell whether a change of the code has changed a picture.
//!
//! The pictures are traced as `rta render --device none --size 46x35 --aspect 4:3` traces them, with `--fit` where a number format
//! does not admit the scene, and hashed bit for bit in their own number format, before any rounding to levels.

use std::borrow::Cow;

use rta::engine::admission::admits;
use rta::engine::{Format, Model};
use rta_core::raster::Raster;
use rta_core::sampling::Sampling;
use rta_core::scalar::Radiance;
use rta_core::{Q16, Q20};
use rta_packets::picture::{self, Setup};
use rta_scenes::description::Description;
use rta_scenes::fit::{Fitted, fit};
use rta_scenes::in_format;

use crate::exact::fnv1a;

/// Width and height of the pictures in pixels. The width is no multiple of 4, so that packets of four pixels end early.
pub(super) const SIZE: (u32, u32) = (46, 35);

/// Width over height of the screen.
pub(super) const ASPECT: f64 = 4.0 / 3.0;

/// The number formats.
pub(super) const FORMATS: [Format; 4] = [Format::F32, Format::F64, Format::Q16, Format::Q20];

/// The illumination models.
pub(super) const MODELS: [Model; 3] = [Model::Rta, Model::Whitted, Model::Phong];

/// Recursion depth and samples a pixel.
pub(super) const SETTINGS: [(u32, u8); 4] = [(0, 1), (0, 4), (5, 1), (5, 4)];

/// Draws a scene with each of [`SETTINGS`] and returns the hashes of the pictures in that order; `None` where the scene
/// cannot be drawn in this format, not even scaled.
pub(super) fn hashes(scene: &Description, format: Format, model: Model) -> [Option<u64>; SETTINGS.len()] {
    let Some(scene) = fitted(scene, format, model) else { return [None; SETTINGS.len()] };
    SETTINGS.map(|setting| in_format!(format, S => drawn::<S>(&scene, model, setting)))
}

/// A number format whose radiance has bits.
trait Bits: picture::Format {
    /// Returns all bits of a radiance.
    fn bits(light: Self::Light) -> u64;
}

impl Bits for f32 {
    fn bits(light: Self) -> u64 {
        light.to_bits().into()
    }
}

impl Bits for f64 {
    fn bits(light: Self) -> u64 {
        light.to_bits()
    }
}

impl Bits for Q16 {
    fn bits(Radiance(light): Radiance) -> u64 {
        light.to_bits().cast_unsigned().into()
    }
}

impl Bits for Q20 {
    fn bits(Radiance(light): Radiance) -> u64 {
        light.to_bits().cast_unsigned().into()
    }
}

/// Returns the scene, scaled as `--fit` scales it if the number format does not admit it as it is; nothing if no scale helps.
fn fitted(scene: &Description, format: Format, model: Model) -> Option<Cow<'_, Description>> {
    let admits = |scene: &Description| admits(scene, format, ASPECT, 0);
    if admits(scene) {
        return Some(Cow::Borrowed(scene));
    }
    match fit(scene, model, format, false, admits) {
        Ok(Fitted::Scaled { scene, .. }) => Some(Cow::Owned(*scene)),
        _ => None,
    }
}

/// Returns the hash of a picture as `rta render` draws it: of red, green and blue of each pixel, eight bytes each, little
/// endian.
fn drawn<S: Bits>(scene: &Description, model: Model, (depth, samples): (u32, u8)) -> Option<u64> {
    let raster = Raster::new(SIZE.0, SIZE.1).ok()?;
    let sampling = Sampling::grid(samples.isqrt())?;
    let setup = Setup { raster, aspect: ASPECT, depth, cutoff: None, sampling: sampling.into() };
    let picture = S::picture(scene, model, &setup).ok()?;
    let mut bytes = Vec::new();
    picture.rows(0, raster.height(), &mut |row| {
        let registers = row.iter().flat_map(|light| [light.r, light.g, light.b]).map(S::bits);
        bytes.extend(registers.flat_map(u64::to_le_bytes));
    });
    Some(fnv1a(bytes))
}
