//! A technique that finds what is seen, drawn by an algorithm of `rta visibility`.

use cpu_time::ThreadTime;
use rta_core::color::Rgb;

use super::super::Fineness;
use super::super::room::PLAIN;
use super::super::technique::Shade;
use super::{Cost, Drawn, References, coarser, render, shown_error};
use crate::picture::device::Target;
use crate::request::Request;
use crate::study::error::StudyError;
use crate::study::visibility::algorithm;
use crate::study::visibility::eye::Seen;
use crate::study::visibility::faces::Faces;
use crate::study::visibility::integer::View;

/// Bands of a ball that is cut, as `--tessellate` has it.
const BANDS: u32 = 6;

/// Draws the visible triangles of the scene.
pub(super) fn visible(
    name: &str,
    (wanted, shade): (&str, Shade),
    references: &References,
    fineness: Fineness,
) -> Result<Drawn, StudyError> {
    let (args, _) = render((PLAIN, name), "")?;
    let scene = PLAIN.scene(args.drawing.tracing.reading.into())?;
    let mut request = Request::of_scene(&args.drawing.tracing, Target::None, &scene)?;
    request.size = request.size.map(|size| coarser(size, fineness));
    let (size, aspect) = request.raster()?;
    let start = ThreadTime::now();
    let faces = Faces::new(&scene.description, BANDS);
    let seen = Seen::new(&faces.all, &scene.description.camera, (size, aspect), 0.0)?;
    let missing = || StudyError::Visibility(format!("there is no algorithm {wanted}").into());
    let algorithm = algorithm::ALL.iter().find(|algorithm| algorithm.name == wanted).ok_or_else(missing)?;
    let outcome = (algorithm.draw)(&seen.view).map_err(|source| StudyError::Visibility(source.into()))?;
    let light = shaded(&seen.view, &outcome.ids, shade);
    let seconds = start.elapsed().as_secs_f64();
    let error = Some(shown_error(&light, &references.whole().light));
    let cost = Cost { rays: outcome.counts.steps(), is_steps: true, solving: 0, seconds };
    let commands = vec![format!("rta visibility {}.rta --tessellate {BANDS}", PLAIN.name)];
    Ok(Drawn { size, aspect, light, error, cost, commands })
}

/// Returns the light of the triangles that are seen: grey.
fn shaded(view: &View, ids: &[u32], shade: Shade) -> Vec<Rgb<f32>> {
    let width = view.raster.size.width();
    let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    // Distance along the ray, or along the axis of view, and the cosine at the face.
    let seen = |place: u32, id: u32| {
        let own = view.triangle(id)?;
        let ray = view.raster.ray(place % width, place / width).map(|c| c as f64);
        let [_, _, ahead] = ray;
        let (normal, length) = (own.normal.map(|c| c as f64), dot(ray, ray).sqrt());
        let steep = dot(normal, ray);
        let parts = own.distance as f64 / steep;
        let distance = if shade == Shade::Depth { ahead } else { length } * parts;
        Some((distance, (steep / (length * dot(normal, normal).sqrt())).abs()))
    };
    let all: Vec<_> = (0..).zip(ids).map(|(place, id)| seen(place, *id)).collect();
    let middle = all.get(ids.len() / 2 + width as usize / 2).copied().flatten();
    let nearest = all.iter().flatten().map(|seen| seen.0).fold(f64::INFINITY, f64::min);
    #[expect(clippy::cast_possible_truncation, reason = "to the nearest")]
    let grey = |seen: &Option<(f64, f64)>| {
        let light = seen.map_or(0.0, |(distance, cosine)| match shade {
            Shade::Angle => cosine * middle.map_or(1.0, |(middle, _)| (middle / distance).min(1.0)),
            Shade::Depth => nearest / distance,
        }) as f32;
        Rgb::new(light, light, light)
    };
    all.iter().map(grey).collect()
}
