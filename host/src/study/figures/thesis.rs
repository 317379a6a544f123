//! The second page of `rta figures`: the thesis, run again.
//!
//! | step | where |
//! | --- | --- |
//! | its table 3.1: the techniques, each with its paper | [`techniques`] |
//! | a technique, and how it is drawn | [`technique`] |
//! | the one scene of the table, and its variants | [`room`] |
//! | a technique drawn: picture, error against paths, cost | [`drawn`] |
//! | its appendix: machines, compositions, times, and what ours take | [`appendix`] |
//! | what emulated machines take | [`counted`] |
//! | the page | `page` |
//!
//! The page is made of what the project knows of the thesis. What it does not know is told as such.

use core::fmt;
use std::path::Path;

use super::Tracing;
use crate::engine::progress::Progress;
use crate::picture::error::PictureError;
use crate::picture::file::{Caption, Displayed, Pixels};
use crate::picture::output::{self, Failure, Inputs, Output};
use crate::study::error::StudyError;
use crate::study::palette::traced::levels;

pub mod appendix;
pub mod counted;
pub mod drawn;
mod page;
pub mod room;
pub mod technique;
pub mod techniques;

use appendix::{COMPOSITIONS, Composition};
use drawn::{Drawn, References};
use technique::Technique;
use techniques::ALL;

/// The folder of the page's pictures and scenes, beside the page.
const FOLDER: &str = "thesis";

/// The page.
const PAGE: &str = "thesis.html";

/// How fine the pictures of the page are.
#[derive(Clone, Copy, Debug)]
pub struct Fineness {
    /// A side of each picture is so many times shorter than the page is meant to have it, and paths have as many times fewer samples: 1 or
    /// more.
    pub coarse: u32,
}

impl Fineness {
    /// Returns a side of so many pixels, coarser.
    #[must_use]
    pub fn side(self, pixels: u32) -> u32 {
        (pixels / self.coarse.max(1)).max(1)
    }
}

/// The files of the page, found to be writable.
pub(super) struct Files {
    page: Output,
    pictures: Vec<Output>,
    folder: std::path::PathBuf,
}

impl Files {
    /// Opens the files below a folder, and writes the scenes.
    pub(super) fn open(folder: &Path) -> Result<Self, PictureError> {
        let below = folder.join(FOLDER);
        output::make_folder(&below)?;
        let page = Output::open(&folder.join(PAGE), Inputs::NONE)?;
        for variant in room::ALL {
            Output::open(&below.join(format!("{}.rta", variant.name)), Inputs::NONE)?
                .write(variant.text().as_bytes())?;
        }
        let pictures = names().map(|name| Output::open(&below.join(format!("{name}.png")), Inputs::NONE));
        Ok(Self { page, pictures: pictures.collect::<Result<_, _>>()?, folder: below })
    }
}

/// Returns the names of the page's pictures: those of the techniques that are drawn, the reference's, and the compositions'.
pub fn names() -> impl Iterator<Item = &'static str> {
    let drawn = ALL.iter().filter(|technique| technique.is_drawn()).map(|technique| technique.name);
    drawn.chain([drawn::REFERENCE]).chain(COMPOSITIONS.iter().map(|composition| composition.name))
}

/// A technique, and its picture if there is one.
type Row<'a> = (&'a Technique, Option<Drawn>);

/// A composition as a machine's display shows it, and what it takes here.
type Shown = (&'static Composition, appendix::Run);

/// All that is on the page.
struct Content<'a> {
    rows: Vec<Row<'a>>,
    references: References,
    compositions: Vec<Shown>,
}

/// Draws the pictures of the page and writes it.
///
/// # Errors
/// All of [`StudyError`] that concern pictures, radiosity and outputs.
pub(super) fn run(files: Files, fineness: Fineness, tracing: &Tracing) -> Result<(), StudyError> {
    let Files { page, pictures, folder } = files;
    let count = ALL.len() + COMPOSITIONS.len() + 1;
    let mut progress = Progress::new(u32::try_from(count).unwrap_or(u32::MAX));
    let mut done = 0;
    let mut reached = || {
        done += 1;
        progress.reached(done);
    };
    let references = References::new(&folder, fineness, tracing)?;
    reached();
    let mut rows = Vec::new();
    for technique in ALL {
        rows.push((technique, drawn::drawn(technique, &references, (&folder, fineness), tracing)?));
        reached();
    }
    let mut compositions = Vec::new();
    for composition in COMPOSITIONS {
        compositions.push((composition, composition.run(fineness, tracing)?));
        reached();
    }
    let content = Content { rows, references, compositions };
    let shown = content.rows.iter().filter_map(|(technique, drawn)| {
        let drawn = drawn.as_ref()?;
        Some((picture(drawn), technique.title, technique.paper))
    });
    let reference = content.references.whole();
    let shown = shown.chain([(picture(reference), "Paths of light", "the reference")]);
    let compositions = content
        .compositions
        .iter()
        .map(|(composition, run)| (run.shown.clone(), composition.what, composition.machine));
    for ((picture, title, settings), file) in shown.chain(compositions).zip(pictures) {
        let caption = Caption { title: title.to_owned(), settings: settings.to_owned() };
        file.fill(|out| picture.write_png(&caption, out).map_err(Failure::<StudyError>::Write))?;
    }
    Ok(page.write(page::html(&content).as_bytes())?)
}

/// Returns a picture of light as a display without a colour table shows it.
fn picture(Drawn { size, aspect, light, .. }: &Drawn) -> Displayed {
    Displayed { size: *size, aspect: *aspect, pixels: Pixels::Direct(levels(light, u8::MAX)) }
}

/// A number of things, with its thousands apart.
struct Thousands(u64);

impl fmt::Display for Thousands {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = self.0.to_string();
        for (place, digit) in digits.chars().enumerate() {
            if place > 0 && (digits.len() - place).is_multiple_of(3) {
                f.write_str("\u{202f}")?;
            }
            write!(f, "{digit}")?;
        }
        Ok(())
    }
}
