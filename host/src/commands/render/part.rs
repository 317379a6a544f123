//! Some rows of a picture, or frames of a film, for `rta merge`.

use core::ops::Range;
use std::io::{self, Write};
use std::time::Instant;

use rta_core::color::Rgb;
use rta_drivers::checksum::Fnv;

use super::Work;
use super::film::{Film, tempo};
use crate::args::DrawingArgs;
use crate::engine::interrupt;
use crate::error::Error;
use crate::picture::device::Target;
use crate::picture::error::{PictureError, name};
use crate::picture::output::Output;
use crate::picture::part::{Light, Part, Whole};
use crate::request::Request;
use crate::request::error::RequestError;
use crate::request::sampler::with_paths;
use crate::request::scene_file::SceneFile;

/// Traces some rows of a scene's picture, or some frames of its film, into a file.
pub(super) fn draw(
    args: &DrawingArgs,
    some: &Range<u32>,
    scene: impl FnOnce() -> Result<SceneFile, RequestError>,
) -> Result<(), Error> {
    let began = Instant::now();
    Request::of(&args.tracing, args.device).raster()?;
    let linear = args.file_type.filter(|file_type| file_type.is_linear());
    if let (Some(file_type), Target::On(device)) = (linear, args.device) {
        return Err(PictureError::LinearFromDevice { file_type, device }.into());
    }
    if let (Some(file_type), Some(_)) = (linear, args.film.frames) {
        return Err(PictureError::OnePicture(file_type).into());
    }
    let scene = scene()?;
    let output = Output::open(&args.output, &scene.inputs)?;
    let mut request = Request::of_scene(&args.tracing, args.device, &scene)?;
    request.sampling = with_paths(request.sampling, None, linear.is_some());
    let (size, aspect) = request.raster()?;
    let film = args.film.frames.map(|frames| (frames, args.film.rate));
    let mut caption = request.caption(&scene);
    let (what, all) = match film {
        Some((frames, rate)) => {
            caption.settings += &tempo(frames, rate);
            ("frames", frames)
        }
        None => ("rows", size.height()),
    };
    if some.end > all {
        return Err(PictureError::NoSuchPart { what, some: some.clone(), all }.into());
    }
    let whole = Whole {
        size,
        aspect,
        target: request.target,
        coloring: request.coloring,
        is_linear: linear.is_some(),
        film,
        caption,
        scene: hash(&scene, request.fit),
    };
    if !args.quiet {
        request.fit(aspect).advise(&scene);
    }
    let part = match film {
        Some((frames, _)) => {
            let height = size.height();
            let rows = some.start * height..some.end * height;
            let mut part = Part { light: whole.dark(), rows, grid: Vec::new(), whole };
            Film { request: &request, scene: &scene, args, frames }.each(some.clone(), None, |work| {
                let frame = traced(work, &part.whole, &(0..height))?;
                part.light.add(frame.0);
                part.grid.extend(frame.1);
                Ok::<_, Error>(())
            })?;
            part
        }
        None => {
            let work =
                Work::new(&request, &scene, args.tracing.threads, interrupt::watch())?.quiet(args.quiet);
            let (light, grid) = traced(&work, &whole, some)?;
            Part { whole, rows: some.clone(), light, grid }
        }
    };
    output.write(&part.write())?;
    if !args.quiet {
        let (file, settings, seconds) = (name(&args.output), &part.whole.caption.settings, began.elapsed());
        let some = format!("{what} {}..{} of {all}, {size}", some.start, some.end);
        // Whoever has closed standard error does not want to know.
        let _ = writeln!(io::stderr(), "rta: {file}: {some}, {settings}; {:.2} s", seconds.as_secs_f64());
    }
    Ok(())
}

/// Returns the light of some rows of a picture, and the colours of the pixels in them of which its colour table is made.
fn traced(work: &Work<'_>, whole: &Whole, rows: &Range<u32>) -> Result<(Light, Vec<Rgb<u8>>), Error> {
    let light = if whole.is_linear {
        Light::Linear(work.rows(rows, |engine, first, out: &mut [Rgb<f32>]| engine.linear_rows(first, out))?)
    } else {
        let most = whole.most();
        Light::Levels(work.rows(rows, |engine, first, out: &mut [_]| engine.level_rows(first, most, out))?)
    };
    let grid = match whole.lattice() {
        Some(lattice) => work.grid_rows(lattice, &whole.grid_rows(rows))?,
        None => Vec::new(),
    };
    Ok((light, grid))
}

/// Returns a hash of all of a scene that its picture depends on, and of whether it is scaled to fit.
fn hash(scene: &SceneFile, fit: bool) -> u64 {
    let (description, mut hash) = (&scene.description, Fnv::EMPTY);
    let mut add = |text: &str| text.bytes().for_each(|byte| hash.add(byte));
    add(&description.to_rta());
    add(&format!("{fit} {}", description.details.scanline));
    for (file, pixels) in &description.details.pictures {
        add(file);
        add(&format!("{pixels:?}"));
    }
    hash.value()
}
