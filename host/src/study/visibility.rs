//! `rta visibility`: the algorithms by which programs find what is seen, side by side on one scene (chapter 1 of the thesis).
//!
//! | step | where |
//! | --- | --- |
//! | a scene as triangles | [`faces`] |
//! | in the eye's frame, clipped, scaled, snapped to integers | [`eye`] |
//! | rays, insides and depths by integers alone | [`integer`] |
//! | the algorithms, one file each | [`zbuffer`], [`casting`], [`painter`], [`scanline`], [`subdivision`], [`scanplane`], all in [`algorithm`] |
//! | what comes of each: ids, counts, bytes | [`outcome`] |
//! | rta's own tracer in `f64` on the same triangles | [`tracer`] |
//! | all of them on one view, compared | [`mod@comparison`] |
//! | costs as faces grow, beside those of 1974 | [`growth`] |
//! | what is printed | [`page`] |
//!
//! Every comparison of the exact ones is one of integers, of equal depths the lower number is seen, and a ray on an edge is of one side only: so each must
//! come to the same id at each pixel. To add an algorithm: a file, and a line in [`algorithm::ALL`].

use rta_core::color::Rgb;

use crate::args::{TracingArgs, VisibilityArgs};
use crate::picture::device::Target;
use crate::picture::error::PictureError;
use crate::picture::file::{Caption, Displayed, Pixels};
use crate::picture::output::{self, Failure, Inputs, PictureOutput};
use crate::picture::raster::Size;
use crate::request::Request;
use crate::request::scene_file::SceneFile;
use crate::study::error::StudyError;

pub mod algorithm;
pub mod casting;
pub mod comparison;
pub mod eye;
pub mod faces;
pub mod growth;
pub mod integer;
pub mod outcome;
pub mod page;
pub mod painter;
#[cfg(test)]
mod samples;
pub mod scanline;
pub mod scanplane;
pub mod subdivision;
#[cfg(test)]
mod tests;
pub mod tracer;
pub mod zbuffer;

use comparison::Comparison;
use eye::Seen;
use faces::Faces;
use growth::Cost;

/// Bands of a sphere where the command does not say it.
const ROWS: u32 = 8;

/// The most faces that a scene is cut into.
const MOST_FACES: usize = 1 << 21;

/// Runs `rta visibility`: prints the tables, and writes the picture of ids.
///
/// # Errors
/// Those of reading the scene and of writing, [`StudyError::PictureToStdout`], [`StudyError::Raster`], [`StudyError::Visibility`], and [`StudyError::IdsDiffer`] once all is
/// printed and written.
pub fn run(args: &VisibilityArgs) -> Result<(), StudyError> {
    compare(args, |text, inputs| Ok(output::print(text, inputs)?))
}

/// Writes the picture of ids alone.
///
/// # Errors
/// Those of [`run`].
pub fn picture(args: &VisibilityArgs) -> Result<(), StudyError> {
    compare(args, |_, _| Ok(()))
}

/// Compares the algorithms, hands over the tables, and writes the picture.
fn compare(
    args: &VisibilityArgs,
    tell: impl FnOnce(&str, &Inputs) -> Result<(), StudyError>,
) -> Result<(), StudyError> {
    let picture = args.output.as_deref().map(|path| PictureOutput::open(path, None)).transpose()?;
    if picture.as_ref().is_some_and(PictureOutput::is_stdout) {
        return Err(StudyError::PictureToStdout);
    }
    if let Some(picture) = picture.as_ref().filter(|picture| picture.file_type().is_linear()) {
        return Err(PictureError::NotLinear(picture.file_type()).into());
    }
    let mut reading = args.reading;
    let rows = reading.tessellate.take().unwrap_or(ROWS);
    let scene = SceneFile::open_as(&args.scene, reading.into())?;
    let picture =
        picture.map(|output| Ok::<_, PictureError>((output.file_type(), output.beside(&scene.inputs)?)));
    let picture = picture.transpose()?;
    let tracing = TracingArgs { size: args.size, aspect: args.aspect, ..TracingArgs::default() };
    let raster = Request::of(&tracing, Target::None).for_scene(None, &scene)?.raster()?;

    let study = |rows: u32| {
        let faces = Faces::new(&scene.description, rows);
        if faces.all.len() > MOST_FACES {
            let text = format!("{} faces are more than 2^21", faces.all.len());
            return Err(StudyError::Visibility(text.into()));
        }
        let hither = scene.description.optics.hither.unwrap_or(0.0);
        let seen = Seen::new(&faces.all, &scene.description.camera, raster, hither)?;
        let comparison = Comparison::new(&seen.view);
        Ok((faces, seen, comparison))
    };
    let (faces, seen, compared) = study(rows)?;
    let mut text = page::head(&scene.title, rows, &faces, &seen) + "\n" + &page::comparison(&compared);
    let mut is_equal = compared.is_equal();
    let mut costs = Vec::new();
    for &count in &args.faces {
        let rows = rows_for(&scene, count);
        let (faces, seen, compared) = study(rows)?;
        is_equal &= compared.is_equal();
        costs.push(Cost::new((rows, faces.all.len(), seen.view.triangles.len()), &compared));
    }
    if !costs.is_empty() {
        text += &("\n".to_owned() + &page::growth(&costs, &growth::crossings(&costs)));
        text += if is_equal { "all ids of all of them are equal\n" } else { "ids DIFFER\n" };
    }
    tell(&text, &scene.inputs)?;
    if let Some((file_type, output)) = picture {
        let displayed = colored(&compared.ids, raster)?;
        let settings = format!("visible triangles, tessellate {rows}");
        let caption = Caption { title: scene.title.clone(), settings };
        output.fill(|out| displayed.write(file_type, &caption, out).map_err(Failure::<StudyError>::Write))?;
    }
    if is_equal { Ok(()) } else { Err(StudyError::IdsDiffer) }
}

/// Returns the bands of a sphere with which a scene has the number of faces that is nearest to `count`.
fn rows_for(scene: &SceneFile, count: usize) -> u32 {
    let faces = |rows: u32| Faces::new(&scene.description, rows).all.len();
    // Faces grow with the rows: the last that is not above the count, or the one after it.
    let (mut low, mut high) = (2_u32, 3);
    while faces(high) < count && faces(high) > faces(low) && high < 4096 {
        (low, high) = (high, high * 2);
    }
    while high - low > 1 {
        let middle = u32::midpoint(low, high);
        if faces(middle) < count { low = middle } else { high = middle }
    }
    if faces(high).abs_diff(count) < faces(low).abs_diff(count) { high } else { low }
}

/// Returns the picture of ids: nothing is black, and each triangle has a colour of its own.
fn colored(ids: &[u32], (size, aspect): (Size, f64)) -> Result<Displayed, StudyError> {
    let color = |id: &u32| {
        // Bits of neighbouring numbers far apart: the fractional part of the golden ratio, times 2^32.
        let [r, g, b, _] =
            id.wrapping_mul(0x9E37_79B9).rotate_left(7).wrapping_mul(0x85EB_CA6B).to_be_bytes();
        if *id == 0 { Rgb::new(0, 0, 0) } else { Rgb::new(64 | r, 64 | g, 64 | b) }
    };
    Ok(Displayed { size, aspect, pixels: Pixels::Direct(ids.iter().map(color).collect()) })
}
