//! Hashes of the linear light of small pictures, which tell whether a change of the code has changed a picture.
//!
//! The pictures are traced as `rta render --device none --fit --size 46x35 --aspect 4:3` traces them, and hashed bit
//! for bit in their own number format, before any rounding to levels.

use rta::engine::{Format, MAX_DEPTH, Model};
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Phong, Rta, Whitted};
use rta_core::needs::Everything;
use rta_core::raster::{Pixels, Raster};
use rta_core::sampling::{Sampling, Supersampled};
use rta_core::scalar::Radiance;
use rta_core::trace::Tracer;
use rta_core::{Q16, Q20};
use rta_scenes::description::{self, Description};
use rta_scenes::fit::fit;
use rta_scenes::narrow::{Narrow, Narrowed, narrow};

use rta_tests::exact::fnv1a;

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
    match format {
        Format::F32 => in_format::<f32>(scene, model),
        Format::F64 => in_format::<f64>(scene, model),
        Format::Q16 => in_format::<Q16>(scene, model),
        Format::Q20 => in_format::<Q20>(scene, model),
    }
}

/// A number format whose radiance has bits.
trait Bits: Narrow {
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

fn in_format<S: Bits>(scene: &Description, model: Model) -> [Option<u64>; SETTINGS.len()] {
    let Some(scene) = fitted::<S>(scene, model) else { return [None; SETTINGS.len()] };
    SETTINGS.map(|setting| match model {
        Model::Rta => drawn(&scene, Rta, setting),
        Model::Whitted => drawn(&scene, Whitted::default(), setting),
        Model::Phong => drawn(&scene, Phong::default(), setting),
    })
}

/// Returns the scene in a number format, scaled as `--fit` scales it if it does not fit; nothing if no scale helps.
fn fitted<S: Narrow>(scene: &Description, model: Model) -> Option<Narrowed<S>> {
    let admitted = |scene: &Description| {
        let narrowed = narrow::<S>(scene, ASPECT).ok()?;
        narrowed.scene().admit(&narrowed.camera).is_ok().then_some(narrowed)
    };
    if let Some(narrowed) = admitted(scene) {
        return Some(narrowed);
    }
    // The model of the picture decides whether lamps are attenuated, and so scaled.
    let model = match model {
        Model::Rta => description::Model::Rta,
        Model::Whitted | Model::Phong => description::Model::Phong,
    };
    let scene = Description { model, ..scene.clone() };
    let factor = fit(&scene, |scene| admitted(scene).is_some()).ok()??;
    admitted(&scene.scaled(factor).ok()?)
}

/// Returns the hash of a picture: of red, green and blue of each pixel, eight bytes each, little endian.
fn drawn<S: Bits, M: Illumination<S>>(
    scene: &Narrowed<S>,
    model: M,
    (depth, samples): (u32, u8),
) -> Option<u64> {
    let admitted = scene.scene().admit(&scene.camera).ok()?;
    let tracer: Tracer<_, M, Everything, { MAX_DEPTH as usize }> =
        Tracer::new(admitted, model, depth).ok()?;
    let (raster, camera) = (Raster::new(SIZE.0, SIZE.1).ok()?, &scene.camera);
    let mut bytes = Vec::new();
    let mut add = |light: Rgb<S::Light>| {
        let registers = [light.r, light.g, light.b].map(S::bits);
        bytes.extend(registers.into_iter().flat_map(u64::to_le_bytes));
    };
    // A loop over all pixels, as in the program: in f32 it traces four of them side by side.
    if samples == 1 {
        Pixels::rows(&tracer, camera, raster, 0, raster.height()).for_each(add);
    } else {
        let sampling = Sampling::grid(samples.isqrt())?;
        Supersampled::rows(&tracer, camera, raster, sampling, 0, raster.height()).for_each(&mut add);
    }
    Some(fnv1a(bytes))
}
