//! The figures that are pictures, each traced from a scene in the language `.rta`.

use rta_scenes::{Reading, shipped};

use super::Tracing;
use crate::args::TracingArgs;
use crate::engine::Model;
use crate::picture::device::Target;
use crate::picture::file::{Displayed, Pixels};
use crate::request::Request;
use crate::request::scene_file::SceneFile;
use crate::study::compare::cells;
use crate::study::error::StudyError;
use crate::study::palette::traced::Traced;
use crate::study::sheet::{beside, displayed, stacked};

/// Pictures in a row.
const ACROSS: usize = 5;

/// A ball on tiles, whose lamp does not fade, so that it is as bright for every model.
const BALL: &str = "\
rta 1
camera at 0 -6 2.2  to 0 0 .95  angle 30
picture 180 180  screen 1 1  samples 9
sky horizon .75 .82 .92  zenith .2 .35 .65
ambient grey .25
lamp at -5 -6 8  constant
floor .85 .82 .75  .35 .33 .3  tile 1
sphere at 0 0 1  radius 1  color .85 .25 .15  of plastic
";

/// A ball in the light of a lamp on its right.
const HALF: &str = "\
rta 1
camera at 0 -6 0  to 0 0 0  angle 22
picture 300 300  screen 1 1  samples 9
ambient grey .25
lamp at 900 -200 200  constant
sphere at 0 0 0  radius 1  color .95 .95 .95  of matte
";

/// Balls of three solid textures.
const TEXTURES: &str = "\
rta 1
camera at 0 -11 2.6  to 0 0 .95  angle 34
picture 720 280  screen 18 7  samples 9
model phong
sky horizon .75 .82 .92  zenith .2 .35 .65
ambient grey .3
lamp at -5 -8 9  constant
floor grey .62  grey .5  tile 1.5
texture cubes checker .92 .88 .75  .65 .15 .1  scale .5
texture veins marble .95 .93 .9  .2 .25 .35
texture rings wood .8 .55 .3  .45 .25 .12  scale .25
material a like plastic  texture cubes
material b like plastic  texture veins
material c like plastic  texture rings
sphere at -2.3 0 1  radius 1  of a
sphere at 0 0 1  radius 1  of b
sphere at 2.3 0 1  radius 1  of c
";

/// Returns a sheet of a scene by several models.
fn sheet(name: &str, text: &str, models: &[Model], tracing: &Tracing) -> Result<Displayed, StudyError> {
    let scene = SceneFile::of_text(name, text, Reading::default())?;
    let request = Request::of_scene(&TracingArgs::default(), Target::None, &scene)?;
    let cells = cells(models, &request, &scene, tracing.pool, tracing.stop)?;
    displayed(&stacked(&cells.chunks(ACROSS).map(beside).collect::<Vec<_>>()))
}

/// One ball in every model.
pub(super) fn models(tracing: &Tracing) -> Result<Displayed, StudyError> {
    sheet("models", BALL, Model::ALL, tracing)
}

/// A ball with Lambert's terminator and with Bouknight's.
pub(super) fn terminators(tracing: &Tracing) -> Result<Displayed, StudyError> {
    sheet("terminators", HALF, &[Model::Lambert, Model::Bouknight], tracing)
}

/// Checker, marble and wood.
pub(super) fn textures(tracing: &Tracing) -> Result<Displayed, StudyError> {
    whole("textures", TEXTURES, tracing)
}

/// One vase four times.
pub(super) fn mesh(tracing: &Tracing) -> Result<Displayed, StudyError> {
    whole("mesh", shipped::MESH, tracing)
}

/// A prism behind slits.
pub(super) fn prism(tracing: &Tracing) -> Result<Displayed, StudyError> {
    whole("prism", shipped::PRISM, tracing)
}

/// Returns the picture of a scene as its file has it.
fn whole(name: &str, text: &str, tracing: &Tracing) -> Result<Displayed, StudyError> {
    let scene = SceneFile::of_text(name, text, Reading::default())?;
    let request = Request::of_scene(&TracingArgs::default(), Target::None, &scene)?;
    let Traced { size, aspect, reference, .. } = Traced::new(&request, &scene, tracing.pool, tracing.stop)?;
    Ok(Displayed { size, aspect, pixels: Pixels::Direct(reference) })
}
