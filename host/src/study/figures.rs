//! `rta figures`: the thesis's figures that are curves or pictures, drawn again from the functions that pictures call.
//!
//! | step | where |
//! | --- | --- |
//! | all figures, each with what is to be said of it | `list` |
//! | the points of the curves | `curves` |
//! | the pictures | `pictures` |
//! | a diagram of curves | `chart` |
//! | the scenes of the page about the scene language | `keywords` |
//! | the page | `page` |
//! | a second page: the thesis's table 3.1 and its appendix, run again | [`thesis`] |

use core::sync::atomic::AtomicBool;
use std::path::Path;

use rayon::ThreadPool;

use crate::args::FiguresArgs;
use crate::engine::progress::Progress;
use crate::engine::{bands, interrupt};
use crate::picture::error::PictureError;
use crate::picture::file::{Caption, Displayed};
use crate::picture::output::{self, Failure, Inputs, Output};
use crate::study::error::StudyError;
use crate::study::plot;

pub mod chart;
mod cones;
mod curves;
pub mod keywords;
pub mod list;
pub mod meshes;
mod page;
mod pictures;
#[cfg(test)]
mod tests;
pub mod thesis;

use chart::Chart;
use keywords::examples;
use rta_scenes::shipped;

/// A figure of the book.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// Stem of its files' names, and its place on the page.
    pub name: &'static str,
    /// The thesis's figure or section.
    pub place: &'static str,
    /// What it shows, in a few words.
    pub title: &'static str,
    /// What is to be seen in it, in whole sentences.
    pub caption: &'static str,
    /// The formulas of its curves or of its pictures' models.
    pub formula: &'static str,
    /// Who published them, and where its numbers come from.
    pub source: &'static str,
    /// How it is made.
    pub content: Content,
}

/// How a figure is made.
#[derive(Clone, Copy, Debug)]
pub enum Content {
    /// From curves: a diagram.
    Curves(fn() -> Chart),
    /// As a picture by the tracer.
    Picture(fn(&Tracing) -> Result<Displayed, StudyError>),
}

/// What pictures are traced with.
#[derive(Clone, Copy, Debug)]
pub struct Tracing<'a> {
    /// The threads.
    pub pool: &'a ThreadPool,
    /// Set when the work is to end early.
    pub stop: &'a AtomicBool,
}

/// A figure as it is written to files.
struct Drawn {
    /// The text of an SVG file, of a diagram.
    svg: Option<String>,
    png: Displayed,
}

impl Figure {
    /// Draws the figure.
    fn draw(&self, tracing: &Tracing) -> Result<Drawn, StudyError> {
        let failed =
            |source: plot::DiagramError| StudyError::Figure { name: self.name, source: source.into() };
        match self.content {
            Content::Curves(curves) => {
                let chart = curves();
                let svg = Some(plot::svg(&chart).map_err(failed)?);
                Ok(Drawn { svg, png: plot::displayed(&chart).map_err(failed)? })
            }
            Content::Picture(picture) => Ok(Drawn { svg: None, png: picture(tracing)? }),
        }
    }

    /// Returns whether it is a diagram, which is written as an SVG too.
    const fn is_diagram(&self) -> bool {
        matches!(self.content, Content::Curves(_))
    }
}

/// Runs `rta figures`. The files are written once everything is drawn, but for the pictures that scenes of keywords name.
///
/// # Errors
/// All of [`StudyError`] that concern pictures and outputs.
pub fn run(args: &FiguresArgs) -> Result<(), StudyError> {
    output::make_folder(&args.output)?;
    let files = list::ALL.iter().map(|figure| Files::open(&args.output, figure));
    let files = files.collect::<Result<Vec<_>, _>>()?;
    let page = Output::open(&args.output.join("index.html"), Inputs::NONE)?;
    // The pictures of textures stand beside the scenes' own, where the page's scenes look for them.
    let folder = args.output.join("keywords");
    output::make_folder(&folder)?;
    for (name, bytes) in shipped::PICTURES {
        Output::open(&folder.join(name), Inputs::NONE)?.write(bytes)?;
    }
    let second = thesis::Files::open(&args.output)?;
    let examples = examples(shipped::PAGE);
    let open = |name: &str| Output::open(&folder.join(format!("{name}.png")), Inputs::NONE);
    let keywords = examples.iter().map(|example| open(&example.name)).collect::<Result<Vec<_>, _>>()?;
    let (pool, stop) = (bands::pool(None)?, interrupt::watch());
    let tracing = Tracing { pool: &pool, stop };
    let count = list::ALL.len() + examples.len();
    let mut progress = Progress::new(u32::try_from(count).unwrap_or(u32::MAX));
    let drawn = (1..).zip(list::ALL).map(|(done, figure)| {
        let drawn = figure.draw(&tracing)?;
        progress.reached(done);
        Ok(drawn)
    });
    let drawn = drawn.collect::<Result<Vec<_>, StudyError>>()?;
    let shown = (1..).zip(&examples).map(|(done, example)| {
        let shown = example.picture(&folder, &tracing)?;
        progress.reached(u32::try_from(list::ALL.len()).unwrap_or(u32::MAX).saturating_add(done));
        Ok(shown)
    });
    let shown = shown.collect::<Result<Vec<_>, StudyError>>()?;
    for ((figure, drawn), files) in list::ALL.iter().zip(&drawn).zip(files) {
        files.write(figure, drawn)?;
    }
    for ((example, shown), file) in examples.iter().zip(&shown).zip(keywords) {
        let settings = "format q16, 256 colours".to_owned();
        let caption = Caption { title: example.name.clone(), settings };
        file.fill(|out| shown.write_png(&caption, out).map_err(Failure::<StudyError>::Write))?;
    }
    page.write(page::html(list::ALL, &examples).as_bytes())?;
    // The second page has a bar of its own.
    drop(progress);
    thesis::run(second, thesis::Fineness { coarse: args.coarse }, &tracing)
}

/// The files of a figure, found to be writable.
struct Files {
    svg: Option<Output>,
    png: Output,
}

impl Files {
    fn open(folder: &Path, figure: &Figure) -> Result<Self, PictureError> {
        let open = |kind: &str| Output::open(&folder.join(format!("{}.{kind}", figure.name)), Inputs::NONE);
        Ok(Self { svg: figure.is_diagram().then(|| open("svg")).transpose()?, png: open("png")? })
    }

    fn write(self, figure: &Figure, drawn: &Drawn) -> Result<(), StudyError> {
        if let (Some(file), Some(svg)) = (self.svg, &drawn.svg) {
            file.write(svg.as_bytes())?;
        }
        let caption = Caption { title: figure.title.to_owned(), settings: figure.place.to_owned() };
        self.png.fill(|out| drawn.png.write_png(&caption, out).map_err(Failure::<StudyError>::Write))
    }
}
