//! `rta bake`: a scene file into Rust source, for a firmware's flash.

use rta_scenes::bake::{self, BakeError, Recipe};

use crate::args::BakeArgs;
use crate::engine::interrupt;
use crate::error::Error;
use crate::picture::output;
use crate::request::fit::Fit;
use crate::request::scene_file::SceneFile;

/// Runs `rta bake`: writes the source of a scene.
///
/// # Errors
/// Those of reading the scene and of writing the source, and [`RequestError::Refused`](crate::request::error::RequestError::Refused).
pub fn run(args: &BakeArgs) -> Result<(), Error> {
    let scene = SceneFile::open(&args.scene)?;
    let aspect = args.aspect.ratio();
    let model = args.model.unwrap_or(scene.description.model.into());
    let fit = Fit { format: args.format, aspect, model: Some(model), depth: 0, asked: args.fit };
    let description = fit.scaled(&scene);
    let recipe = Recipe { format: args.format, aspect, model };
    let source = match bake::module(&description, &scene.title, &recipe) {
        Ok(source) => source,
        Err(BakeError::Narrow(error)) => return Err(fit.refused(&scene, error.into()).into()),
        Err(BakeError::Range(error)) => return Err(fit.refused(&scene, error.into()).into()),
        Err(error) => return Err(error.into()),
    };
    // From here on a signal waits for the file, which is soon complete.
    interrupt::watch();
    Ok(output::write_text(&args.output, &source, &scene.inputs)?)
}
