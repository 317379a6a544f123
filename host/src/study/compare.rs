//! `rta compare`: one scene by several illumination models, side by side.

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
use crate::picture::output::{Failure, PictureOutput};
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
    let scene = SceneFile::open_as(&args.scene, args.tracing.reading.into())?;
    let (file_type, output) = (output.file_type(), output.beside(&scene.inputs)?);
    let request = Request::of_scene(&args.tracing, Target::None, &scene)?;
    let (pool, stop) = (bands::pool(args.tracing.threads)?, interrupt::watch());
    let cells = cells(&args.models.0, &request, &scene, &pool, stop)?;
    let lines: Vec<_> = cells.chunks(ACROSS).map(beside).collect();
    let width = lines.first().map_or(0, |line| line.width);
    let caption = request.caption(&scene);
    let head =
        title(width, &format!("{}, format {}, depth {}", caption.title, request.format, request.depth));
    let sheet = displayed(&stacked(&[vec![head], lines].concat()))?;
    let settings =
        format!("models {}", args.models.0.iter().map(|model| model.name()).collect::<Vec<_>>().join(", "));
    let caption = Caption { title: caption.title, settings };
    output.fill(|out| sheet.write(file_type, &caption, out).map_err(Failure::<StudyError>::Write))?;
    Ok(())
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
