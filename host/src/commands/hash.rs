//! `rta hash`: the hash of a picture, by which a port of the tracer shows that it draws the right bytes.

use crate::args::HashArgs;
use crate::commands::render::Work;
use crate::engine::interrupt;
use crate::error::Error;
use crate::picture::device::Target;
use crate::picture::output;
use crate::request::Request;
use crate::request::scene_file::SceneFile;

/// Runs `rta hash`: prints the hash of a scene's picture on a device, with the settings of the picture.
///
/// # Errors
/// All of [`Error`] that concern a scene, a device or standard output.
pub fn run(args: &HashArgs) -> Result<(), Error> {
    let target = Target::On(args.device);
    Request::of(&args.tracing, target).raster()?;
    let scene = SceneFile::open_as(&args.scene, args.tracing.reading.into())?;
    let request = Request::of_scene(&args.tracing, target, &scene)?;
    let (size, _) = request.raster()?;
    let hash =
        Work::new(&request, &scene, args.tracing.threads, interrupt::watch())?.checksum(args.device)?;
    let caption = request.caption(&scene);
    let line = format!("{hash:016x}  {}, {size}, {}\n", caption.title, caption.settings);
    Ok(output::print(&line, &scene.inputs)?)
}
