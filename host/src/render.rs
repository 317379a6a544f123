//! `rta render`: a scene into a picture file.

use core::sync::atomic::AtomicBool;

use rayon::ThreadPool;
use rta_core::color::Rgb;
use rta_drivers::checksum::{Checksum, Unseen};
use rta_drivers::painter::Painter;

use crate::args::RenderArgs;
use crate::bands;
use crate::device::{Device, Target};
use crate::engine::Engine;
use crate::error::Error;
use crate::interrupt;
use crate::output::Output;
use crate::picture::{Displayed, FileType, Pixels, write_pfm};
use crate::progress::Progress;
use crate::raster::Size;
use crate::request::Request;
use crate::scene::Scene;
use crate::screen::{Screen, Table};

/// Does what `rta render` is asked to. Whatever can be wrong is found before the first ray, and the output is
/// only touched once the picture is complete.
///
/// # Errors
/// All of [`Error`].
pub fn run(args: &RenderArgs) -> Result<(), Error> {
    args.tracing.request(args.device).raster()?;
    let output = Output::open(&args.output, args.file_type)?;
    if let (FileType::Pfm, Target::On(device)) = (output.file_type(), args.device) {
        return Err(Error::LinearFromDevice(device));
    }
    let scene = Scene::open(&args.scene)?;
    let request = args.tracing.request_for(args.device, &scene)?;
    let work = Work::new(&request, &scene, args.tracing.threads, interrupt::watch())?;
    let mut content = Vec::new();
    let encoded = match output.file_type() {
        FileType::Png => work.displayed()?.write_png(&request.caption(&scene), &mut content),
        FileType::Ppm => work.displayed()?.write_ppm(&mut content),
        FileType::Pfm => write_pfm(work.size, &work.linear()?, &mut content),
    };
    encoded.map_err(|source| Error::write(&args.output, source))?;
    output.write(&content)
}

/// A picture about to be traced.
pub struct Work<'a> {
    engine: Engine,
    request: &'a Request,
    size: Size,
    aspect: f64,
    pool: ThreadPool,
    stop: &'a AtomicBool,
}

impl<'a> Work<'a> {
    /// Makes everything ready that a picture of `scene` needs.
    ///
    /// # Errors
    /// Those of [`Request::engine`], and [`Error::Threads`].
    pub fn new(
        request: &'a Request,
        scene: &Scene,
        threads: Option<u16>,
        stop: &'a AtomicBool,
    ) -> Result<Self, Error> {
        let (size, aspect) = request.raster()?;
        Ok(Self { engine: request.engine(scene)?, request, size, aspect, pool: bands::pool(threads)?, stop })
    }

    /// Traces the picture as its display shows it.
    ///
    /// # Errors
    /// [`Error::Interrupted`], [`Error::Memory`] and [`Error::Display`].
    pub fn displayed(&self) -> Result<Displayed, Error> {
        match self.request.target {
            Target::On(device) => {
                let mut screen = Screen::new(device, self.request.table, self.size, self.aspect)?;
                let gun_max = device.capabilities().gun_max;
                let trace = |first, levels: &mut [_]| self.engine.level_rows(first, gun_max, levels);
                self.trace(trace, |first, levels| screen.put_rows(first, &levels))?;
                screen.picture()
            }
            Target::None => {
                let trace = |first, levels: &mut [_]| self.engine.level_rows(first, u8::MAX, levels);
                let pixels = Pixels::Direct(self.collect(trace)?);
                Ok(Displayed { size: self.size, aspect: self.aspect, pixels })
            }
        }
    }

    /// Traces the picture onto a device that nobody sees and returns the hash of what the device was sent.
    ///
    /// # Errors
    /// [`Error::Interrupted`], [`Error::Memory`] and [`Error::Display`].
    pub fn checksum(&self, device: Device) -> Result<u64, Error> {
        let capabilities = device.capabilities();
        let table = Table(self.request.table.table(capabilities).map_err(Error::display)?);
        let mut painter = Painter::new(Checksum::new(Unseen(capabilities)), table).map_err(Error::display)?;
        let trace = |first, levels: &mut [_]| self.engine.level_rows(first, capabilities.gun_max, levels);
        self.trace(trace, |first, levels| {
            let rows = (first..).zip(levels.chunks(self.size.columns()));
            rows.into_iter()
                .try_for_each(|(y, row)| painter.put_row(0, y, row.iter().copied()))
                .map_err(Error::display)
        })?;
        Ok(painter.display().value())
    }

    /// Traces the picture as linear light before any display.
    ///
    /// # Errors
    /// [`Error::Interrupted`] and [`Error::Memory`].
    pub fn linear(&self) -> Result<Vec<Rgb<f32>>, Error> {
        self.collect(|first, light: &mut [_]| self.engine.linear_rows(first, light))
    }

    fn collect<T: Clone + Default + Send>(
        &self,
        trace: impl Fn(u32, &mut [T]) + Sync,
    ) -> Result<Vec<T>, Error> {
        let mut pixels = Vec::new();
        pixels.try_reserve_exact(self.size.pixels()).map_err(|_| Error::Memory(self.size))?;
        self.trace(trace, |_, band| {
            pixels.extend(band);
            Ok(())
        })?;
        Ok(pixels)
    }

    fn trace<T: Clone + Default + Send>(
        &self,
        trace: impl Fn(u32, &mut [T]) + Sync,
        mut deliver: impl FnMut(u32, Vec<T>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let mut progress = Progress::new(self.size.height());
        bands::bands(self.size, &self.pool, self.stop, trace, |first, band| {
            deliver(first, band)?;
            progress.reached(first);
            Ok(())
        })
    }
}
