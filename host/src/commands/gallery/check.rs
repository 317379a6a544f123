//! Whether the pictures in the repository are those that the program draws.

use core::fmt::Write;
use std::fs;
use std::path::Path;

use super::draw;
use super::list::{self, Picture};
use crate::error::Error;
use crate::picture::error::{PictureError, reason};
use crate::picture::file::reading::ReadPicture;
use crate::picture::output::{self, Inputs};

/// Prints which pictures in a clone of the repository are not those that the program draws.
///
/// # Errors
/// [`Error::PicturesDiffer`], and those of [`draw`].
pub fn run(repository: &Path) -> Result<(), Error> {
    let mut pictures = list::all();
    pictures.retain(|picture| !picture.is_measured());
    let folder = tempfile::tempdir().map_err(|source| PictureError::write(&std::env::temp_dir(), source))?;
    draw(&pictures, folder.path())?;
    let (mut told, mut count) = (String::new(), 0_usize);
    for picture in &pictures {
        if let Some(difference) = difference(picture, folder.path(), repository) {
            // Writing to a string does not fail.
            let _ = writeln!(told, "{}: {difference}", picture.file);
            count += 1;
        }
    }
    let _ = writeln!(told, "{} pictures, of which {count} differ", pictures.len());
    output::print(&told, Inputs::NONE)?;
    if count == 0 { Ok(()) } else { Err(Error::PicturesDiffer) }
}

/// Returns how a picture in a repository differs from the one that its command has left in `folder`, if it does. Of a PNG, sizes, shapes
/// and colours are compared, of other files all bytes.
#[must_use]
pub fn difference(picture: &Picture, folder: &Path, repository: &Path) -> Option<String> {
    let [drawn, kept] = [folder.join(&picture.made), repository.join(&picture.file)];
    if drawn.extension().is_some_and(|extension| extension == "png") {
        match (ReadPicture::open(&drawn), ReadPicture::open(&kept)) {
            (Ok(drawn), Ok(kept)) => of_pictures(&drawn, &kept),
            (Err(error), _) | (_, Err(error)) => Some(error.to_string()),
        }
    } else {
        match (fs::read(&drawn), fs::read(&kept)) {
            (Ok(drawn), Ok(kept)) => (drawn != kept).then(|| "its bytes differ".to_owned()),
            (Err(error), _) | (_, Err(error)) => Some(reason(&error)),
        }
    }
}

fn of_pictures(drawn: &ReadPicture, kept: &ReadPicture) -> Option<String> {
    if (drawn.size, drawn.aspect.to_bits()) != (kept.size, kept.aspect.to_bits()) {
        let shape = |picture: &ReadPicture| format!("{} on a screen of {:.3}", picture.size, picture.aspect);
        return Some(format!("{}, where {} is drawn", shape(kept), shape(drawn)));
    }
    let pairs = drawn.pixels.iter().zip(&kept.pixels);
    let count = pairs.filter(|(drawn, kept)| drawn != kept).count();
    (count > 0).then(|| format!("{count} of {} pixels differ", drawn.pixels.len()))
}
