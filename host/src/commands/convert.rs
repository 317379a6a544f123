//! `rta convert`: a scene in another format; and `rta help scene`, what the language of scenes is.

use rta_scenes::{Reading, rta};

use crate::args::ConvertArgs;
use crate::error::Error;
use crate::picture::output::{self, Inputs};
use crate::request::error::RequestError;
use crate::request::scene_file::SceneFile;

/// Runs `rta convert`: writes the scene in the format that the name of the output says.
///
/// # Errors
/// Those of reading the scene and of writing the other one, [`RequestError::SceneType`] and [`RequestError::Unsayable`].
pub fn run(args: &ConvertArgs) -> Result<(), Error> {
    let extension = args.output.extension().map(|extension| extension.to_ascii_lowercase());
    let is = |other: &str| extension.as_ref().is_some_and(|extension| extension == other);
    let is_stdout = args.output.as_os_str() == "-";
    if !(is("rta") || is("dat") || is_stdout) {
        return Err(RequestError::SceneType { name: args.output.display().to_string() }.into());
    }
    // The pictures stay where they are.
    let reading = Reading { texels: Some(0), ..args.reading.into() };
    let scene = SceneFile::open_as(&args.scene, reading)?;
    let text = if is("dat") {
        let unsayable = || RequestError::Unsayable { name: scene.source.clone() };
        scene.description.to_dat().ok_or_else(unsayable)?
    } else {
        scene.description.to_rta()
    };
    Ok(output::write_text(&args.output, &text, &scene.inputs)?)
}

/// Runs `rta help scene`: prints the language of scenes.
///
/// # Errors
/// Those of writing to standard output.
pub fn language() -> Result<(), Error> {
    Ok(output::print(&rta::help(), Inputs::NONE)?)
}
