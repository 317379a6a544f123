//! The page of all pictures, in HTML.

use core::fmt::Write;
use std::path::Path;

use clap::Parser;

use super::list::Picture;
use crate::args::{Cli, Command};
use crate::error::Error;
use crate::picture::file::FileType;
use crate::picture::file::reading::ReadPicture;
use crate::picture::raster::Size;
use crate::request::Request;
use crate::study::html::{escaped, page};

const INTRODUCTION: &str = "\
<p>Every picture of the documents, above the command that draws it. The commands are to be run in the folder of this page, where the
scenes are that they read.</p>
";

const WORDS: &str = "\
<h2>The words of the scene language</h2>
<p>Each scene needs nothing but its lines. One command draws all of them, and the figures of <a href=\"figures/index.html\">the book of
figures</a>.</p>
";

/// Returns the page of pictures that lie in `folder`.
///
/// # Errors
/// [`PictureError::Read`](crate::picture::error::PictureError::Read).
pub fn html(pictures: &[Picture], folder: &Path) -> Result<String, Error> {
    let mut body = INTRODUCTION.to_owned();
    let is_word = |picture: &&Picture| picture.scene.is_some();
    for picture in pictures.iter().filter(|picture| !is_word(picture)) {
        body += &figure(picture, folder)?;
    }
    body += WORDS;
    for picture in pictures.iter().filter(is_word) {
        body += &figure(picture, folder)?;
    }
    Ok(page("The pictures of rta", &body))
}

/// Returns the part of the page that shows one picture.
fn figure(picture: &Picture, folder: &Path) -> Result<String, Error> {
    let (size, aspect) = shape(picture, folder)?;
    let (width, height) = (size.width(), (f64::from(size.width()) / aspect).round());
    let [file, alt, command, made] =
        [&picture.file, &picture.alt, picture.command, &picture.made].map(escaped);
    let id = escaped(&Path::new(&picture.file).file_stem().unwrap_or_default().to_string_lossy());
    // The shape counts that the device gives the picture; by itself it would be shown with square pixels.
    let mut text = format!(
        "<figure id=\"{id}\">\n<img src=\"{made}\" alt=\"{alt}\" width=\"{width}\" height=\"{height}\" \
         style=\"aspect-ratio: {width} / {height}\">\n<figcaption>\n<p>{alt}</p>\n"
    );
    // Writing to a string does not fail.
    if let Some(scene) = &picture.scene {
        let _ = writeln!(text, "<pre>{}</pre>", escaped(scene));
    }
    let _ = writeln!(text, "<pre><code>{command}</code></pre>");
    // Of a picture that its command does not name.
    if made != file {
        let note =
            if picture.is_measured() { "; its costs are those of this machine and this build" } else { "" };
        let _ = writeln!(text, "<p class=\"source\">{made}; in the repository {file}{note}</p>");
    }
    text += "</figcaption>\n</figure>\n";
    Ok(text)
}

/// Returns the pixels of a picture, and width over height of the screen that it fills. A PNG says both; a GIF, which does not say how its
/// pixels are shaped, has what its command asks for.
fn shape(picture: &Picture, folder: &Path) -> Result<(Size, f64), Error> {
    if FileType::of_extension(picture.made.rsplit('.').next().unwrap_or_default()) == Some(FileType::Png) {
        let ReadPicture { size, aspect, .. } = ReadPicture::open(&folder.join(&picture.made))?;
        return Ok((size, aspect));
    }
    let drawing = match Cli::try_parse_from(picture.command.split(' ')).ok().and_then(|cli| cli.command) {
        Some(Command::Juggle(args)) => args.drawing,
        Some(Command::Render(args)) => args.drawing,
        _ => return Err(Error::NoPictures),
    };
    Ok(Request::of(&drawing.tracing, drawing.device).raster()?)
}
