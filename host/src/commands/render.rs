//! `rta render`: a scene into a picture file.

use core::sync::atomic::AtomicBool;
use std::io::{self, Write};
use std::time::Instant;

use rta_scenes::shipped;

use crate::args::{DrawingArgs, JuggleArgs, RenderArgs};
use crate::engine::bands::BandsError;
use crate::engine::interrupt;
use crate::error::Error;
use crate::picture::device::Target;
use crate::picture::error::{PictureError, name};
use crate::picture::output::{Failure, PictureOutput};
use crate::request::Request;
use crate::request::error::RequestError;
use crate::request::sampler::{with_paths, with_samples};
use crate::request::scene_file::SceneFile;
use rta_args::value::rows::Rows;

pub use film::{Film, tempo};
pub use passes::{Goal, Traced, trace};
pub use work::{Source, Work};

mod film;
mod part;
mod passes;
mod work;

/// Frames of the Juggler's film of 1987, after which it begins anew.
const JUGGLER_FRAMES: u32 = 24;

/// Runs `rta render`.
///
/// # Errors
/// All of [`Error`].
pub fn run(args: &RenderArgs) -> Result<(), Error> {
    let RenderArgs { scene, rows, only, until, keep, tolerance, drawing } = args;
    let scene = || SceneFile::open_as(scene, drawing.tracing.reading.into());
    match rows.as_ref().or(only.as_ref()) {
        Some(Rows(some)) => part::draw(drawing, some, scene),
        None => {
            let end = until.map(|end| Goal::Until(end, *keep));
            draw(drawing, end.or(tolerance.map(Goal::Settled)), scene)
        }
    }
}

/// Runs `rta juggle`.
///
/// # Errors
/// All of [`Error`].
pub fn juggle(args: &JuggleArgs) -> Result<(), Error> {
    let mut drawing = args.drawing.clone();
    if drawing.tracing.reading.instant.is_none() {
        drawing.film.frames.get_or_insert(JUGGLER_FRAMES);
    }
    draw(&drawing, None, || SceneFile::of_text("juggler", shipped::JUGGLING, drawing.tracing.reading.into()))
}

/// Draws a scene into a file. Errors of the options, the scene and the output are found before the first ray, and a file is only
/// replaced once the picture is complete. A picture that is traced in passes has a `goal`.
fn draw(
    args: &DrawingArgs,
    goal: Option<Goal>,
    scene: impl FnOnce() -> Result<SceneFile, RequestError>,
) -> Result<(), Error> {
    let began = Instant::now();
    Request::of(&args.tracing, args.device).raster()?;
    let output = PictureOutput::open(&args.output, args.file_type)?;
    let file_type = output.file_type();
    match args.device {
        Target::On(device) if file_type.is_linear() => {
            return Err(PictureError::LinearFromDevice { file_type, device }.into());
        }
        Target::None if file_type.needs_table() => return Err(PictureError::NeedsTable(file_type).into()),
        _ => {}
    }
    if args.film.frames.is_some() && !file_type.holds_films() {
        return Err(PictureError::OnePicture(file_type).into());
    }
    let scene = scene()?;
    let output = output.beside(&scene.inputs)?;
    let mut request = Request::of_scene(&args.tracing, args.device, &scene)?;
    request.sampling = with_paths(request.sampling, None, file_type.is_linear());
    let request = match goal {
        Some(Goal::Until(end, _)) => request.until(Some(end), &args.tracing, &scene)?,
        Some(Goal::Settled(_)) => request.settling(&args.tracing, &scene)?,
        None => request,
    };
    let (size, aspect) = request.raster()?;
    let mut caption = request.caption(&scene);
    let advise = || {
        if !args.quiet {
            request.fit(aspect).advise(&scene);
        }
    };
    let (mut told, mut is_interrupted) = (String::new(), false);
    if let Some(goal) = goal {
        let engine = request.engine(&scene)?;
        advise();
        let traced = trace(&engine, size, goal, (args.tracing.threads, args.quiet))?;
        if let Some(warning) = traced.warning() {
            // Whoever has closed standard error does not want to know.
            let _ = writeln!(io::stderr(), "rta: warning: {warning}");
        }
        (told, is_interrupted) = (traced.told(), traced.is_interrupted());
        let sampling = with_samples(request.sampling, traced.samples());
        caption = Request { sampling, ..request.clone() }.caption(&scene);
        if let Goal::Settled(tolerance) = goal {
            caption.settings += &format!(" at most, tolerance {tolerance}");
        }
        // The interrupt that has ended the passes is not to end the writing too.
        let not_again = AtomicBool::new(false);
        let stop = if is_interrupted { &not_again } else { interrupt::watch() };
        let display = (request.target, request.coloring);
        let work = Work::of(traced, display, (size, aspect), args.tracing.threads, stop)?.quiet(true);
        output.fill(|out| work.write(file_type, &caption, out))?;
    } else if let Some(frames) = args.film.frames {
        caption.settings += &tempo(frames, args.film.rate);
        let film = Film { request: &request, scene: &scene, args, frames };
        advise();
        output.fill(|out| film.write(file_type, &caption, out))?;
    } else {
        let work = Work::new(&request, &scene, args.tracing.threads, interrupt::watch())?.quiet(args.quiet);
        advise();
        output.fill(|out| work.write(file_type, &caption, out))?;
    }
    if !args.quiet {
        let (picture, settings) = (name(&args.output), &caption.settings);
        let seconds = began.elapsed().as_secs_f64();
        // Whoever has closed standard error does not want to know.
        let _ =
            writeln!(io::stderr(), "rta: {picture}: {file_type}, {size}, {settings}{told}; {seconds:.2} s");
    }
    if is_interrupted { Err(BandsError::Interrupted.into()) } else { Ok(()) }
}

impl<T> From<T> for Failure<Error>
where
    Error: From<T>,
{
    fn from(error: T) -> Self {
        Self::Other(error.into())
    }
}
