//! `rta gallery`: every picture of the documents, drawn anew by the commands of one list.
//!
//! | step | where |
//! | --- | --- |
//! | the pictures, each with its command | [`list`] |
//! | the page | [`page`] |
//! | the comparison with the pictures in the repository | [`check`] |

use std::path::Path;

use clap::Parser;
use rta_scenes::shipped;

use crate::args::{Cli, Command, DrawingArgs, GalleryArgs};
use crate::commands::render;
use crate::engine::progress::Progress;
use crate::error::Error;
use crate::picture::output::{self, Inputs, Output};
use crate::study::{compare, figures, report, visibility};

pub mod check;
pub mod list;
pub mod page;

use list::Picture;

/// Runs `rta gallery`.
///
/// # Errors
/// [`Error::Gallery`], [`Error::PicturesDiffer`], and those of the page.
pub fn run(args: &GalleryArgs) -> Result<(), Error> {
    if let Some(repository) = &args.check {
        return check::run(repository);
    }
    args.output.as_deref().map_or(Ok(()), |folder| {
        let mut pictures = list::all();
        pictures.retain(|picture| !(args.no_report && picture.is_measured()));
        output::make_folder(folder)?;
        let page = Output::open(&folder.join("index.html"), Inputs::NONE)?;
        draw(&pictures, folder)?;
        Ok(page.write(page::html(&pictures, folder)?.as_bytes())?)
    })
}

/// Draws pictures in a folder, after the scenes that their commands read there.
///
/// # Errors
/// [`Error::Gallery`], which names the command, and those of writing the scenes.
pub fn draw(pictures: &[Picture], folder: &Path) -> Result<(), Error> {
    let scenes = folder.join("scenes");
    output::make_folder(&scenes)?;
    let texts = shipped::FILES.iter().map(|&(name, text)| (name, text.as_bytes()));
    for (name, content) in texts.chain(shipped::PICTURES) {
        Output::open(&scenes.join(name), Inputs::NONE)?.write(content)?;
    }
    let mut commands: Vec<&'static str> = Vec::new();
    for picture in pictures {
        // One command may draw several.
        if !commands.contains(&picture.command) {
            commands.push(picture.command);
        }
    }
    let count = u32::try_from(commands.len()).unwrap_or(u32::MAX);
    let mut progress = Some(Progress::new(count));
    for (done, command) in (1..).zip(commands) {
        let in_gallery = |source| Error::Gallery { command, source: Box::new(source) };
        run_in(folder, command, &mut progress).map_err(in_gallery)?;
        if let Some(progress) = &mut progress {
            progress.reached(done);
        }
    }
    Ok(())
}

/// Runs a command as it would run in `folder`, without a word about the picture. Those that draw many pictures have a progress bar of
/// their own, which takes the place of this one.
fn run_in(folder: &Path, command: &str, progress: &mut Option<Progress>) -> Result<(), Error> {
    let silent =
        |drawing: DrawingArgs| DrawingArgs { output: folder.join(&drawing.output), quiet: true, ..drawing };
    let cli = Cli::try_parse_from(command.split(' ')).ok();
    match cli.and_then(|cli| cli.command).ok_or(Error::NoPictures)? {
        Command::Render(mut args) => {
            args.scene = folder.join(&args.scene);
            args.drawing = silent(args.drawing);
            render::run(&args)
        }
        Command::Juggle(mut args) => {
            args.drawing = silent(args.drawing);
            render::juggle(&args)
        }
        Command::Compare(mut args) => {
            args.scenes.iter_mut().for_each(|scene| *scene = folder.join(&*scene));
            args.output = folder.join(&args.output);
            Ok(compare::run(&args)?)
        }
        Command::Figures(mut args) => {
            *progress = None;
            args.output = folder.join(&args.output);
            Ok(figures::run(&args)?)
        }
        Command::Visibility(mut args) => {
            args.scene = folder.join(&args.scene);
            args.output = args.output.map(|output| folder.join(output));
            Ok(visibility::picture(&args)?)
        }
        Command::Report(mut args) => {
            *progress = None;
            args.scenes.iter_mut().for_each(|scene| *scene = folder.join(&*scene));
            args.output = folder.join(&args.output);
            Ok(report::run(&args)?)
        }
        _ => Err(Error::NoPictures),
    }
}
