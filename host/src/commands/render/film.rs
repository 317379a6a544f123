//! Films: the frames of a scene whose things move, one after the other.

use core::ops::Range;
use std::io::Write;

use super::Work;
use crate::args::DrawingArgs;
use crate::engine::interrupt;
use crate::engine::progress::Progress;
use crate::error::Error;
use crate::picture::device::{Device, Target};
use crate::picture::error::PictureError;
use crate::picture::file::film::FilmWriter;
use crate::picture::file::{Caption, Displayed, FileType, Pixels};
use crate::picture::output::Failure;
use crate::picture::screen::{Screen, lattice};
use crate::request::Request;
use crate::request::scene_file::SceneFile;

/// A film that is asked for.
pub struct Film<'a> {
    /// How each frame is traced.
    pub request: &'a Request,
    /// The scene whose things move.
    pub scene: &'a SceneFile,
    /// How many frames there are in a second, whether they have one colour table, and by how many threads they are traced.
    pub args: &'a DrawingArgs,
    /// How many frames there are.
    pub frames: u32,
}

/// Returns what a caption says of a film.
#[must_use]
pub fn tempo(frames: u32, rate: u16) -> String {
    format!(", {frames} frames, {rate} in a second")
}

impl Film<'_> {
    /// Draws the frames and writes them. Where each has a table of its own, no more than one is held in memory.
    ///
    /// # Errors
    /// Those of a frame, as [`Error::Frame`], and those of `out`.
    pub fn write(
        &self,
        file_type: FileType,
        caption: &Caption,
        out: &mut dyn Write,
    ) -> Result<(), Failure<Error>> {
        let (shape, pace) = (self.request.raster()?, (self.frames, self.args.film.rate));
        let progress = (!self.args.quiet).then(|| Progress::new(self.frames));
        match self.request.target {
            Target::On(device) if self.args.film.one_table => {
                let pictures = self.on_one_screen(device, progress)?;
                let table = pictures.last().and_then(|last| match &last.pixels {
                    Pixels::Indexed { palette, .. } => Some(palette.as_slice()),
                    Pixels::Direct(_) => None,
                });
                let mut film = FilmWriter::new(file_type, shape, pace, table, caption, out)?;
                pictures.iter().try_for_each(|picture| film.frame(picture))?;
                Ok(film.finish()?)
            }
            _ => {
                let mut film = FilmWriter::new(file_type, shape, pace, None, caption, out)?;
                self.each(0..self.frames, progress, |work| {
                    Ok::<_, Failure<Error>>(film.frame(&work.displayed()?)?)
                })?;
                Ok(film.finish()?)
            }
        }
    }

    /// Returns the frames as a device shows them whose colour table stays: it is made from samples of all of them. A table that grows
    /// while a picture is drawn goes on growing from frame to frame.
    fn on_one_screen(&self, device: Device, progress: Option<Progress>) -> Result<Vec<Displayed>, Error> {
        let coloring = self.request.coloring;
        let (size, aspect) = self.request.raster()?;
        let lattice = lattice(coloring, size, self.frames)?;
        let mut samples = Vec::new();
        if coloring.samples() > 0 {
            self.each(0..self.frames, None, |work| {
                samples.extend(work.on_grid(lattice)?);
                Ok::<_, Error>(())
            })?;
        }
        let samples = (samples.as_slice(), lattice.grid().width());
        let mut screen = Screen::of_samples((device, coloring), (size, aspect), samples)?;
        let mut pictures = Vec::new();
        self.each(0..self.frames, progress, |work| {
            pictures.try_reserve(1).map_err(|_| PictureError::Memory(size))?;
            pictures.push(work.shown_on(device, &mut screen)?);
            Ok::<_, Error>(())
        })?;
        Ok(pictures)
    }

    /// Calls `draw` with each of some frames, ready to be traced.
    pub(super) fn each<E: From<Error>>(
        &self,
        some: Range<u32>,
        mut progress: Option<Progress>,
        mut draw: impl FnMut(&Work<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        for number in some {
            let instant = f64::from(number) / f64::from(self.frames);
            let still = self.scene.at(instant);
            let work = Work::new(self.request, &still, self.args.tracing.threads, interrupt::watch());
            let in_frame = |source| Error::Frame { number, instant, source: Box::new(source) };
            draw(&work.map_err(in_frame)?.quiet(true))?;
            if let Some(progress) = &mut progress {
                progress.reached(number + 1);
            }
        }
        Ok(())
    }
}
