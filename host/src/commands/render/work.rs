//! A picture on its way from its light to a display or a file.

use core::ops::Range;
use core::sync::atomic::AtomicBool;
use std::io::{self, Write};

use rayon::ThreadPool;
use rta_core::color::Rgb;
use rta_core::raster::lattice::Lattice;
use rta_drivers::checksum::{Checksum, Unseen};
use rta_drivers::display::{expand, reduce};
use rta_drivers::painter::Painter;
use rta_drivers::quantize::ColorTable;

use crate::engine::Engine;
use crate::engine::bands::{self, BandsError};
use crate::engine::progress::Progress;
use crate::error::Error;
use crate::picture::coloring::Coloring;
use crate::picture::device::{Device, Target};
use crate::picture::error::PictureError;
#[cfg(feature = "image")]
use crate::picture::file::other::write_hdr;
use crate::picture::file::{
    Caption, Displayed, FileType, Pixels, bytes, flip, write_light, write_pfm_header, write_png_rows,
    write_ppm_header,
};
use crate::picture::output::Failure;
use crate::picture::raster::Size;
use crate::picture::screen::{Screen, parts};
use crate::request::Request;
use crate::request::scene_file::SceneFile;

/// Where the light of a picture comes from: the tracer, or parts that it wrote. Rows may be asked for in any order, from any number of
/// threads.
pub trait Source: Sync {
    /// Fills `out` with linear light, from row `first` on.
    fn linear_rows(&self, first: u32, out: &mut [Rgb<f32>]);

    /// Fills `out` with levels `0..=gun_max`, from row `first` on.
    fn level_rows(&self, first: u32, gun_max: u8, out: &mut [Rgb<u8>]);

    /// Returns the colours, 8 bits a gun, of the picture's pixels on a grid.
    ///
    /// # Errors
    /// [`BandsError::Interrupted`] soon after `stop` becomes true.
    fn on_grid(
        &self,
        lattice: Lattice,
        pool: &ThreadPool,
        stop: &AtomicBool,
    ) -> Result<Vec<Rgb<u8>>, BandsError>;
}

impl Source for Engine {
    fn linear_rows(&self, first: u32, out: &mut [Rgb<f32>]) {
        Self::linear_rows(self, first, out);
    }

    fn level_rows(&self, first: u32, gun_max: u8, out: &mut [Rgb<u8>]) {
        Self::level_rows(self, first, gun_max, out);
    }

    fn on_grid(
        &self,
        lattice: Lattice,
        pool: &ThreadPool,
        stop: &AtomicBool,
    ) -> Result<Vec<Rgb<u8>>, BandsError> {
        Self::on_grid(self, lattice, pool, stop)
    }
}

/// A picture whose light can be had.
pub struct Work<'a, L = Engine> {
    source: L,
    target: Target,
    coloring: Coloring,
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
        request: &Request,
        scene: &SceneFile,
        threads: Option<u16>,
        stop: &'a AtomicBool,
    ) -> Result<Self, Error> {
        let shape = request.raster()?;
        Self::of(request.engine(scene)?, (request.target, request.coloring), shape, threads, stop)
    }

    /// Returns the light of some rows, which `trace` has of the engine.
    pub(super) fn rows<T: Clone + Default + Send>(
        &self,
        rows: &Range<u32>,
        trace: impl Fn(&Engine, u32, &mut [T]) + Sync,
    ) -> Result<Vec<T>, Error> {
        let mut pixels = Vec::new();
        let room = rows.len() * self.size.columns();
        pixels.try_reserve_exact(room).map_err(|_| PictureError::Memory(self.size))?;
        let size = Size::new(self.size.width(), rows.end.saturating_sub(rows.start));
        let trace = |first, out: &mut [T]| trace(&self.source, rows.start + first, out);
        self.trace(size.unwrap_or(self.size), trace, |_, band| {
            pixels.extend(band);
            Ok::<_, Error>(())
        })?;
        Ok(pixels)
    }

    /// Returns the colours, 8 bits a gun, of some rows of a grid of the picture's pixels.
    pub(super) fn grid_rows(&self, lattice: Lattice, rows: &Range<u32>) -> Result<Vec<Rgb<u8>>, Error> {
        let mut pixels = Vec::new();
        if let Ok(size) = Size::new(lattice.grid().width(), rows.end.saturating_sub(rows.start)) {
            let trace = |first, out: &mut [_]| self.source.grid_rows(lattice, rows.start + first, out);
            self.trace(size, trace, |_, band| {
                pixels.extend(band);
                Ok::<_, Error>(())
            })?;
        }
        Ok(pixels)
    }
}

impl<'a, L: Source> Work<'a, L> {
    /// Returns the work on a picture for a display: its size, and width over height of the screen that it fills.
    ///
    /// # Errors
    /// [`BandsError::Threads`].
    pub fn of(
        source: L,
        (target, coloring): (Target, Coloring),
        (size, aspect): (Size, f64),
        threads: Option<u16>,
        stop: &'a AtomicBool,
    ) -> Result<Self, Error> {
        let pool = bands::pool(threads)?;
        Ok(Self { source, target, coloring, size, aspect, pool, stop, quiet: false })
    }

    /// Returns the work without a progress bar if it is to be `quiet`.
    #[must_use]
    pub fn quiet(mut self, quiet: bool) -> Self {
        self.quiet = quiet;
        self
    }

    /// Traces the picture and writes it. Of a PNG, PPM or PFM without a device only some bands of rows are held in memory.
    ///
    /// # Errors
    /// [`BandsError::Interrupted`], [`PictureError::Memory`], [`PictureError::Display`], and those of `out`.
    pub fn write(
        &self,
        file_type: FileType,
        caption: &Caption,
        out: &mut dyn Write,
    ) -> Result<(), Failure<Error>> {
        match (file_type, self.target) {
            (FileType::Pfm, _) => {
                write_pfm_header(self.size, out)?;
                // From the bottom to the top, as the format has it.
                let trace = |first, light: &mut [_]| {
                    let rows = u32::try_from(light.len() / self.size.columns()).unwrap_or(u32::MAX);
                    self.source.linear_rows(self.size.height() - first - rows, light);
                    flip(light, self.size.columns());
                };
                self.trace(self.size, trace, |_, light| Ok(write_light(&light, out)?))
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
        let trace = |first, levels: &mut [_]| self.source.level_rows(first, u8::MAX, levels);
        self.trace(self.size, trace, |_, levels| Ok(deliver(&levels)?))
    }

    /// Traces the picture as its display shows it.
    ///
    /// # Errors
    /// [`BandsError::Interrupted`], [`PictureError::Memory`] and [`PictureError::Display`].
    pub fn displayed(&self) -> Result<Displayed, Error> {
        match self.target {
            Target::On(device) => {
                let (coloring, shape) = (self.coloring, (self.size, self.aspect));
                let mut screen = Screen::new((device, coloring), shape, |lattice| self.on_grid(lattice))?;
                self.shown_on(device, &mut screen)
            }
            Target::None => {
                let trace = |first, levels: &mut [_]| self.source.level_rows(first, u8::MAX, levels);
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
        let most = self.coloring.light_max(device.capabilities());
        let trace = |first, light: &mut [_]| self.source.level_rows(first, most, light);
        self.trace(self.size, trace, |first, light| Ok::<_, Error>(screen.put_rows(first, &light)?))?;
        Ok(screen.picture()?)
    }

    /// Traces the picture onto a device that nobody sees and returns the hash of what the device was sent.
    ///
    /// # Errors
    /// [`BandsError::Interrupted`], [`PictureError::Memory`] and [`PictureError::Display`].
    pub fn checksum(&self, device: Device) -> Result<u64, Error> {
        let capabilities = device.capabilities();
        let (table, dithering) = parts(device, self.coloring, self.size, |lattice| self.on_grid(lattice))?;
        let unseen = Checksum::new(Unseen(capabilities));
        let mut painter = Painter::dithered(unseen, table, dithering).map_err(PictureError::display)?;
        let most = painter.light_max();
        let trace = |first, light: &mut [_]| self.source.level_rows(first, most, light);
        self.trace(self.size, trace, |first, levels| {
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
        let (table, _) = parts(device, self.coloring, self.size, |lattice| self.on_grid(lattice))?;
        let gun_max = device.capabilities().gun_max;
        let most = table.light_max(gun_max);
        let level = |level| reduce(expand(level, most), gun_max);
        Ok(table.entries().iter().map(|entry| entry.map(level)).collect())
    }

    /// Traces the pixels of a grid, of which a colour table is made.
    pub(super) fn on_grid(&self, lattice: Lattice) -> Result<Vec<Rgb<u8>>, Error> {
        Ok(self.source.on_grid(lattice, &self.pool, self.stop)?)
    }

    /// Traces the picture as linear light before any display.
    ///
    /// # Errors
    /// [`BandsError::Interrupted`] and [`PictureError::Memory`].
    pub fn linear(&self) -> Result<Vec<Rgb<f32>>, Error> {
        self.collect(|first, light: &mut [_]| self.source.linear_rows(first, light))
    }

    fn collect<T: Clone + Default + Send>(
        &self,
        trace: impl Fn(u32, &mut [T]) + Sync,
    ) -> Result<Vec<T>, Error> {
        let mut pixels = Vec::new();
        pixels.try_reserve_exact(self.size.pixels()).map_err(|_| PictureError::Memory(self.size))?;
        self.trace(self.size, trace, |_, band| {
            pixels.extend(band);
            Ok::<_, Error>(())
        })?;
        Ok(pixels)
    }

    fn trace<T: Clone + Default + Send, E: From<BandsError>>(
        &self,
        size: Size,
        trace: impl Fn(u32, &mut [T]) + Sync,
        mut deliver: impl FnMut(u32, Vec<T>) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut progress = (!self.quiet).then(|| Progress::new(size.height()));
        bands::bands(size, &self.pool, self.stop, trace, |first, band| {
            deliver(first, band)?;
            if let Some(progress) = &mut progress {
                progress.reached(first);
            }
            Ok(())
        })
    }
}
