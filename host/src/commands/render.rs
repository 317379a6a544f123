//! `rta render`: a scene into a picture file.

use core::sync::atomic::AtomicBool;
use std::io::{self, Write};
use std::time::Instant;

use rayon::ThreadPool;
use rta_core::color::Rgb;
use rta_core::raster::lattice::Lattice;
use rta_drivers::checksum::{Checksum, Unseen};
use rta_drivers::display::{expand, reduce};
use rta_drivers::painter::Painter;
use rta_drivers::quantize::ColorTable;
use rta_scenes::shipped;

use crate::args::{DrawingArgs, JuggleArgs, RenderArgs};
use crate::engine::Engine;
use crate::engine::bands::{self, BandsError};
use crate::engine::interrupt;
use crate::engine::progress::Progress;
use crate::error::Error;
use crate::picture::device::{Device, Target};
use crate::picture::error::{PictureError, name};
#[cfg(feature = "image")]
use crate::picture::file::other::write_hdr;
use crate::picture::file::{
    Caption, Displayed, FileType, Pixels, bytes, flip, write_light, write_pfm_header, write_png_rows,
    write_ppm_header,
};
use crate::picture::output::{Failure, PictureOutput};
use crate::picture::raster::Size;
use crate::picture::screen::{Screen, parts};
use crate::request::Request;
use crate::request::error::RequestError;
use crate::request::scene_file::SceneFile;
use film::Film;

mod film;

/// Frames of the Juggler's film of 1987, after which it begins anew.
const JUGGLER_FRAMES: u32 = 24;

/// Runs `rta render`.
///
/// # Errors
/// All of [`Error`].
pub fn run(args: &RenderArgs) -> Result<(), Error> {
    let RenderArgs { scene, drawing } = args;
    draw(drawing, || SceneFile::open_as(scene, drawing.tracing.reading.into()))
}

/// Runs `rta juggle`.
///
/// # Errors
/// All of [`Error`].
pub fn juggle(args: &JuggleArgs) -> Result<(), Error> {
    let mut drawing = args.drawing.clone();
    if drawing.tracing.reading.instant.is_none() {
        drawing.film.frames.get_or_insert(JUGGLER_FRAMES);
    }
    draw(&drawing, || SceneFile::of_text("juggler", shipped::JUGGLING, drawing.tracing.reading.into()))
}

/// Draws a scene into a file. Errors of the options, the scene and the output are found before the first ray, and a file is only
/// replaced once the picture is complete.
fn draw(args: &DrawingArgs, scene: impl FnOnce() -> Result<SceneFile, RequestError>) -> Result<(), Error> {
    let began = Instant::now();
    Request::of(&args.tracing, args.device).raster()?;
    let output = PictureOutput::open(&args.output, args.file_type)?;
    let file_type = output.file_type();
    match args.device {
        Target::On(device) if file_type.is_linear() => {
            return Err(PictureError::LinearFromDevice { file_type, device }.into());
        }
        Target::None if file_type.needs_table() => return Err(PictureError::NeedsTable(file_type).into()),
        _ => {}
    }
    if args.film.frames.is_some() && !file_type.holds_films() {
        return Err(PictureError::OnePicture(file_type).into());
    }
    let scene = scene()?;
    let output = output.beside(&scene.inputs)?;
    let request = Request::of_scene(&args.tracing, args.device, &scene)?;
    let (size, aspect) = request.raster()?;
    let mut caption = request.caption(&scene);
    let advise = || {
        if !args.quiet {
            request.fit(aspect).advise(&scene);
        }
    };
    if let Some(frames) = args.film.frames {
        caption.settings += &format!(", {frames} frames, {} in a second", args.film.rate);
        let film = Film::new(&request, &scene, args);
        advise();
        output.fill(|out| film.write(file_type, &caption, out))?;
    } else {
        let work = Work::new(&request, &scene, args.tracing.threads, interrupt::watch())?.quiet(args.quiet);
        advise();
        output.fill(|out| work.write(file_type, &caption, out))?;
    }
    if !args.quiet {
        let (picture, settings) = (name(&args.output), &caption.settings);
        let seconds = began.elapsed().as_secs_f64();
        // Whoever has closed standard error does not want to know.
        let _ = writeln!(io::stderr(), "rta: {picture}: {file_type}, {size}, {settings}; {seconds:.2} s");
    }
    Ok(())
}

impl<T> From<T> for Failure<Error>
where
    Error: From<T>,
{
    fn from(error: T) -> Self {
        Self::Other(error.into())
    }
}

/// A picture that is ready to be traced.
pub struct Work<'a> {
    engine: Engine,
    request: &'a Request,
    size: Size,
    aspect: f64,
    pool: ThreadPool,
    stop: &'a AtomicBool,
    quiet: bool,
}

impl<'a> Work<'a> {
    /// Makes the scene ready and starts the threads.
    ///
    /// # Errors
    /// Those of [`Request::engine`], and [`BandsError::Threads`].
    pub fn new(
        request: &'a Request,
        scene: &SceneFile,
        threads: Option<u16>,
        stop: &'a AtomicBool,
    ) -> Result<Self, Error> {
        let (size, aspect) = request.raster()?;
        Ok(Self {
            engine: request.engine(scene)?,
            request,
            size,
            aspect,
            pool: bands::pool(threads)?,
            stop,
            quiet: false,
        })
    }

    /// Returns the work without a progress bar if it is to be `quiet`.
    #[must_use]
    pub fn quiet(mut self, quiet: bool) -> Self {
        self.quiet = quiet;
        self
    }

    /// Traces the picture and writes it. Of a PNG, PPM or PFM without a device only some bands of rows are held in memory.
    fn write(
        &self,
        file_type: FileType,
        caption: &Caption,
        out: &mut dyn Write,
    ) -> Result<(), Failure<Error>> {
        match (file_type, self.request.target) {
            (FileType::Pfm, _) => {
                write_pfm_header(self.size, out)?;
                // From the bottom to the top, as the format has it.
                let trace = |first, light: &mut [_]| {
                    let rows = u32::try_from(light.len() / self.size.columns()).unwrap_or(u32::MAX);
                    self.engine.linear_rows(self.size.height() - first - rows, light);
                    flip(light, self.size.columns());
                };
                self.trace(trace, |_, light| Ok(write_light(&light, out)?))
            }
            (FileType::Png, Target::None) => write_png_rows(self.size, self.aspect, caption, out, |rows| {
                self.direct(|pixels| rows.write_all(&bytes(pixels)))
            }),
            (FileType::Ppm, Target::None) => {
                write_ppm_header(self.size, out)?;
                self.direct(|pixels| out.write_all(&bytes(pixels)))
            }
            #[cfg(feature = "image")]
            (FileType::Hdr, _) => Ok(write_hdr(self.size, &self.linear()?, out)?),
            (file_type, _) => Ok(self.displayed()?.write(file_type, caption, out)?),
        }
    }

    /// Traces the picture with 8 bits a gun and hands it over in bands.
    fn direct(&self, mut deliver: impl FnMut(&[Rgb<u8>]) -> io::Result<()>) -> Result<(), Failure<Error>> {
        let trace = |first, levels: &mut [_]| self.engine.level_rows(first, u8::MAX, levels);
        self.trace(trace, |_, levels| Ok(deliver(&levels)?))
    }

    /// Traces the picture as its display shows it.
    ///
    /// # Errors
    /// [`BandsError::Interrupted`], [`PictureError::Memory`] and [`PictureError::Display`].
    pub fn displayed(&self) -> Result<Displayed, Error> {
        match self.request.target {
            Target::On(device) => {
                let (coloring, shape) = (self.request.coloring, (self.size, self.aspect));
                let mut screen = Screen::new((device, coloring), shape, |lattice| self.on_grid(lattice))?;
                self.shown_on(device, &mut screen)
            }
            Target::None => {
                let trace = |first, levels: &mut [_]| self.engine.level_rows(first, u8::MAX, levels);
                let pixels = Pixels::Direct(self.collect(trace)?);
                Ok(Displayed { size: self.size, aspect: self.aspect, pixels })
            }
        }
    }

    /// Traces the picture onto the screen of a device, and returns what it shows then.
    ///
    /// # Errors
    /// [`BandsError::Interrupted`] and [`PictureError::Display`].
    pub(super) fn shown_on(&self, device: Device, screen: &mut Screen) -> Result<Displayed, Error> {
        let most = self.request.coloring.light_max(device.capabilities());
        let trace = |first, light: &mut [_]| self.engine.level_rows(first, most, light);
        self.trace(trace, |first, light| Ok::<_, Error>(screen.put_rows(first, &light)?))?;
        Ok(screen.picture()?)
    }

    /// Traces the picture onto a device that nobody sees and returns the hash of what the device was sent.
    ///
    /// # Errors
    /// [`BandsError::Interrupted`], [`PictureError::Memory`] and [`PictureError::Display`].
    pub fn checksum(&self, device: Device) -> Result<u64, Error> {
        let capabilities = device.capabilities();
        let (table, dithering) =
            parts(device, self.request.coloring, self.size, |lattice| self.on_grid(lattice))?;
        let unseen = Checksum::new(Unseen(capabilities));
        let mut painter = Painter::dithered(unseen, table, dithering).map_err(PictureError::display)?;
        let most = painter.light_max();
        let trace = |first, light: &mut [_]| self.engine.level_rows(first, most, light);
        self.trace(trace, |first, levels| {
            let rows = (first..).zip(levels.chunks(self.size.columns()));
            rows.into_iter()
                .try_for_each(|(y, row)| painter.put_row(0, y, row.iter().copied()))
                .map_err(|error| Error::from(PictureError::display(error)))
        })?;
        Ok(painter.display().value())
    }

    /// Returns the entries of the colour table that is made for the picture on a device before it is drawn, as levels of its guns.
    ///
    /// # Errors
    /// Those of [`Work::checksum`].
    pub fn palette(&self, device: Device) -> Result<Vec<Rgb<u8>>, Error> {
        let (table, _) = parts(device, self.request.coloring, self.size, |lattice| self.on_grid(lattice))?;
        let gun_max = device.capabilities().gun_max;
        let most = table.light_max(gun_max);
        let level = |level| reduce(expand(level, most), gun_max);
        Ok(table.entries().iter().map(|entry| entry.map(level)).collect())
    }

    /// Traces the pixels of a grid, of which a colour table is made.
    pub(super) fn on_grid(&self, lattice: Lattice) -> Result<Vec<Rgb<u8>>, Error> {
        Ok(self.engine.on_grid(lattice, &self.pool, self.stop)?)
    }

    /// Traces the picture as linear light before any display.
    ///
    /// # Errors
    /// [`BandsError::Interrupted`] and [`PictureError::Memory`].
    pub fn linear(&self) -> Result<Vec<Rgb<f32>>, Error> {
        self.collect(|first, light: &mut [_]| self.engine.linear_rows(first, light))
    }

    fn collect<T: Clone + Default + Send>(
        &self,
        trace: impl Fn(u32, &mut [T]) + Sync,
    ) -> Result<Vec<T>, Error> {
        let mut pixels = Vec::new();
        pixels.try_reserve_exact(self.size.pixels()).map_err(|_| PictureError::Memory(self.size))?;
        self.trace(trace, |_, band| {
            pixels.extend(band);
            Ok::<_, Error>(())
        })?;
        Ok(pixels)
    }

    fn trace<T: Clone + Default + Send, E: From<BandsError>>(
        &self,
        trace: impl Fn(u32, &mut [T]) + Sync,
        mut deliver: impl FnMut(u32, Vec<T>) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut progress = (!self.quiet).then(|| Progress::new(self.size.height()));
        bands::bands(self.size, &self.pool, self.stop, trace, |first, band| {
            deliver(first, band)?;
            if let Some(progress) = &mut progress {
                progress.reached(first);
            }
            Ok(())
        })
    }
}
