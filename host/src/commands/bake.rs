//! `rta bake`: a scene file into Rust source, for a firmware's flash.

use rta_scenes::bake::{self, BakeError, Recipe};

use crate::args::BakeArgs;
use crate::engine::{Format, Model};
use crate::error::Error;
use crate::picture::output;
use crate::request::fit::Fit;
use crate::request::scene_file::SceneFile;

/// Writes the source of a scene, or says why the number format does not take it.
///
/// # Errors
/// What keeps the scene from being read or the source from being written, and [`Error::Refused`].
pub fn run(args: &BakeArgs) -> Result<(), Error> {
    let scene = SceneFile::open(&args.scene)?;
    let aspect = args.aspect.ratio();
    let format = match args.format {
        Format::F32 => bake::Format::F32,
        Format::F64 => bake::Format::F64,
        Format::Q16 => bake::Format::Q16,
        Format::Q20 => bake::Format::Q20,
    };
    let asked = args.model.unwrap_or(scene.description.model.into());
    let model = match asked {
        Model::Rta => bake::Model::Rta,
        Model::Whitted | Model::Phong => bake::Model::Whitted,
    };
    let fit = Fit { format: args.format, aspect, model: Some(asked), asked: args.fit };
    let description = fit.scaled(&scene);
    let source = match bake::module(&description, &scene.title, &Recipe { format, aspect, model }) {
        Ok(source) => source,
        Err(BakeError::Narrow(error)) => return Err(fit.refused(&scene, error.into())),
        Err(BakeError::Range(error)) => return Err(fit.refused(&scene, error.into())),
        Err(error) => return Err(Error::Report(Box::new(error))),
    };
    output::write_text(&args.output, &source)
}
