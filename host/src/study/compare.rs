//! `rta compare`: scenes by several illumination models, or on several displays, side by side.

use core::sync::atomic::AtomicBool;

use rayon::ThreadPool;

use super::error::StudyError;
use super::palette::traced::Traced;
use super::sheet::{beside, cell, displayed, stacked, title};
use crate::args::CompareArgs;
use crate::engine::{Model, bands, interrupt};
use crate::picture::device::Target;
use crate::picture::error::PictureError;
use crate::picture::file::Caption;
use crate::picture::frame::Frame;
use crate::picture::output::{Failure, Inputs, PictureOutput};
use crate::request::Request;
use crate::request::scene_file::SceneFile;

/// Pictures in a row of the sheet.
const ACROSS: usize = 4;

/// Runs `rta compare`.
///
/// # Errors
/// All of [`StudyError`] that concern a scene and an output.
pub fn run(args: &CompareArgs) -> Result<(), StudyError> {
    let output = PictureOutput::open(&args.output, None)?;
    if output.file_type().is_linear() {
        return Err(PictureError::NotLinear(output.file_type()).into());
    }
    let scenes = args.scenes.iter().map(|path| SceneFile::open_as(path, args.tracing.reading.into()));
    let scenes = scenes.collect::<Result<Vec<_>, _>>()?;
    let mut inputs = Inputs::default();
    scenes.iter().for_each(|scene| inputs.add(&scene.inputs));
    let (file_type, output) = (output.file_type(), output.beside(&inputs)?);
    let (pool, stop) = (bands::pool(args.tracing.threads)?, interrupt::watch());
    let blocks = scenes.iter().map(|scene| block(args, scene, &pool, stop));
    let sheet = displayed(&stacked(&blocks.collect::<Result<Vec<_>, _>>()?))?;
    let titles: Vec<_> = scenes.iter().map(|scene| scene.title.as_str()).collect();
    let settings = if args.devices.is_empty() {
        format!("models {}", args.models.0.iter().map(|model| model.name()).collect::<Vec<_>>().join(", "))
    } else {
        format!("devices {}", args.devices.iter().map(ToString::to_string).collect::<Vec<_>>().join(", "))
    };
    let caption = Caption { title: titles.join(", "), settings };
    output.fill(|out| sheet.write(file_type, &caption, out).map_err(Failure::<StudyError>::Write))?;
    Ok(())
}

/// Returns the part of the sheet that is one scene's, below a line about it.
fn block(
    args: &CompareArgs,
    scene: &SceneFile,
    pool: &ThreadPool,
    stop: &AtomicBool,
) -> Result<Frame, StudyError> {
    let request = Request::of_scene(&args.tracing, Target::None, scene)?;
    let cells = if args.devices.is_empty() {
        cells(&args.models.0, &request, scene, pool, stop)?
    } else {
        let shown = args.devices.iter().map(|&target| {
            let request = Request::of_scene(&args.tracing, target, scene)?;
            shown(&request, scene, pool, stop)
        });
        shown.collect::<Result<_, StudyError>>()?
    };
    let lines: Vec<_> = cells.chunks(ACROSS).map(beside).collect();
    let width = lines.first().map_or(0, |line| line.width);
    let words = format!("{}, format {}, depth {}", scene.title, request.format, request.depth);
    Ok(stacked(&[vec![title(width, &words)], lines].concat()))
}

/// Returns the picture of a scene as a display shows it, above the display's name.
fn shown(
    request: &Request,
    scene: &SceneFile,
    pool: &ThreadPool,
    stop: &AtomicBool,
) -> Result<Frame, StudyError> {
    let traced = Traced::new(request, scene, pool, stop)?;
    let shape = (traced.size, traced.aspect);
    match request.target {
        Target::On(device) => {
            let picture = traced.displayed(device, request.coloring)?;
            Ok(cell(shape, &picture.colors(), &device.to_string()))
        }
        Target::None => Ok(cell(shape, &traced.reference, "no device")),
    }
}

/// Returns the picture of a scene by each model, above the model's name and year.
///
/// # Errors
/// Those of [`Traced::new`].
pub(super) fn cells(
    models: &[Model],
    request: &Request,
    scene: &SceneFile,
    pool: &ThreadPool,
    stop: &AtomicBool,
) -> Result<Vec<Frame>, StudyError> {
    let picture = |&model: &Model| {
        let request = Request { model, ..request.clone() };
        let Traced { size, aspect, reference, .. } = Traced::new(&request, scene, pool, stop)?;
        let facts = model.facts();
        let name = [model.name(), facts.year].join(" ");
        Ok(cell((size, aspect), &reference, name.trim()))
    };
    models.iter().map(picture).collect()
}
