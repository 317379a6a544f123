//! Pictures by cones beside those of rays.

use rta_core::color::Rgb;
use rta_scenes::Reading;
use rta_scenes::sampler::Sampler;

use super::Tracing;
use crate::args::TracingArgs;
use crate::engine::Format;
use crate::picture::device::Target;
use crate::picture::file::Displayed;
use crate::picture::frame::Frame;
use crate::picture::raster::Size;
use crate::request::Request;
use crate::request::scene_file::SceneFile;
use crate::study::cones::pictures::{PICTURES, Picture, SIZE};
use crate::study::cones::rays;
use crate::study::error::StudyError;
use crate::study::palette::traced::Traced;
use crate::study::sheet::{beside, cell, displayed, stacked};

/// Samples of the pictures that are right.
const SAMPLES: u32 = 64;

/// How much larger differences are shown.
const GAIN: i32 = 4;

/// The scenes of the study of cones.
pub(super) fn sheet(tracing: &Tracing) -> Result<Displayed, StudyError> {
    let rows = PICTURES.iter().map(|picture| row(picture, tracing)).collect::<Result<Vec<_>, _>>()?;
    displayed(&stacked(&rows))
}

/// Returns one scene by a cone, a ray and many rays a pixel, and the difference.
fn row(picture: &Picture, tracing: &Tracing) -> Result<Frame, StudyError> {
    let [width, height] = SIZE;
    let size = Size::clamped(width, height);
    let scene = SceneFile::of_text(picture.title, picture.text, Reading::default())?;
    let plain = Request::of_scene(&TracingArgs::default(), Target::None, &scene)?;
    let drawn = |sampling| {
        let request = Request { sampling, size: Some(size), format: Format::F64, ..plain.clone() };
        Traced::new(&request, &scene, tracing.pool, tracing.stop)
    };
    let [cones, ray, many] = [Sampler::Cones, Sampler::CENTER, rays(SAMPLES)].map(drawn);
    let (cones, ray, many) = (cones?.reference, ray?.reference, many?.reference);
    let difference: Vec<_> = cones.iter().zip(&many).map(|(cone, right)| apart(*cone, *right)).collect();
    let shown = |pixels: &[Rgb<u8>], words: &str| cell((size, size.ratio()), pixels, words);
    Ok(beside(&[
        shown(&cones, "one cone"),
        shown(&ray, "one ray"),
        shown(&many, "64 rays"),
        shown(&difference, "difference x 4"),
    ]))
}

/// Returns a difference about grey.
fn apart(one: Rgb<u8>, other: Rgb<u8>) -> Rgb<u8> {
    one.zip(other, |one, other| {
        let level = 128 + GAIN * (i32::from(one) - i32::from(other));
        u8::try_from(level.clamp(0, 255)).unwrap_or(u8::MAX)
    })
}
