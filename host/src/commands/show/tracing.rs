//! The threads behind the window: first coarse previews of the picture, each finer than the one before, then the picture itself.

use core::ops::Range;
use core::sync::atomic::{AtomicBool, Ordering};
use core::time::Duration;
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver};
use std::time::Instant;

use rayon::ThreadPool;
use rta_core::color::Rgb;
use rta_core::raster::lattice::Lattice;

use super::passing::Passing;
use super::source::Source;
use crate::engine::Engine;
use crate::engine::bands::{self, BandsError};
use crate::error::Error;
use crate::picture::raster::Size;
use crate::picture::screen::lattice;
use crate::request::Request;

/// The first preview has about this many pixels along its longer side: it is there at once.
const COARSEST: u32 = 40;
/// The side of the blocks of the last preview, in pixels of the picture. All previews together then take at most
/// 1/16 + 1/64 + ... = 1/12 of the picture's primary rays; one with blocks of 2 would take four times as many.
const FINEST: u32 = 4;
/// A preview with more pixels would be finer than most windows.
const MOST: usize = 1 << 20;

/// Something that has been traced.
pub enum Part {
    /// The scene is ready to be traced. It comes first.
    Ready(Arc<Engine>),
    /// Whole rows of a preview or, with the size of the picture, of the picture itself, from the top down.
    Rows {
        /// Pixels of the preview or picture.
        size: Size,
        /// The first row.
        first: u32,
        /// Levels: of a preview 0..=255; of the picture those that its device takes.
        levels: Vec<Rgb<u8>>,
    },
    /// The pixels of which the device's colour table is to be made. They come before the first row of the picture, and none come for a
    /// table that is not made from the picture, or is there already.
    Samples {
        /// Their colours, 8 bits a gun.
        light: Vec<Rgb<u8>>,
        /// Columns of the grid that they are the pixels of.
        width: u32,
    },
    /// All rows of the picture, with the samples that it has after a pass. It takes the place of the pass before.
    Pass {
        /// Samples of a pixel.
        samples: u32,
        /// The estimated error.
        error: f64,
        /// Levels that the device takes.
        levels: Vec<Rgb<u8>>,
    },
    /// The picture is complete. It has taken this long, without its previews.
    Complete(Duration),
    /// The scene cannot be traced. Nothing comes after it.
    Failed(Box<Error>),
}

/// The threads that trace a picture. They stop within a band when this is dropped.
#[derive(Debug)]
pub struct Tracing {
    parts: Receiver<Part>,
    stop: Arc<AtomicBool>,
}

impl Drop for Tracing {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}

/// What is to be traced.
#[derive(Clone, Debug)]
pub struct Asked {
    /// Pixels of the picture.
    size: Size,
    /// The highest level of its light.
    light_max: u8,
    /// The grid whose pixels are needed before the first row, and the frames that they are needed of.
    samples: Option<(Lattice, Range<u32>)>,
    /// The frame.
    number: u32,
    /// How the picture is traced in passes, if it is.
    passes: Option<Passing>,
}

impl Asked {
    /// Returns what is asked of a frame whose colour table is made of some frames: of none if it is there already.
    ///
    /// # Errors
    /// Those of [`Request::raster`].
    pub fn of(request: &Request, number: u32, table: Range<u32>) -> Result<Self, Error> {
        let (Request { coloring, .. }, (size, _)) = (request, request.raster()?);
        let device = request.target.device();
        let light_max = device.map_or(u8::MAX, |device| coloring.light_max(device.capabilities()));
        let is_sampled = device.is_some() && coloring.samples() > 0 && !table.is_empty();
        let frames = u32::try_from(table.len()).unwrap_or(u32::MAX);
        let lattice = if is_sampled { Some(lattice(*coloring, size, frames)?) } else { None };
        let samples = lattice.map(|lattice| (lattice, table));
        Ok(Self { size, light_max, samples, number, passes: None })
    }

    /// Returns it as a picture in passes, where its rays are spread or it has an end; frames of a film are traced at once.
    #[must_use]
    pub fn in_passes(mut self, request: &Request) -> Self {
        self.passes = Passing::of(request);
        self
    }
}

impl Tracing {
    /// Begins to trace a frame. The first one has previews; the others are not seen before they are complete.
    pub fn begin(source: Source, engine: Option<Arc<Engine>>, asked: Asked, pool: Arc<ThreadPool>) -> Self {
        let Asked { size, light_max, samples, number, passes } = asked;
        let (sender, parts) = mpsc::channel();
        let stop = Arc::new(AtomicBool::new(false));
        let stopped = Arc::clone(&stop);
        std::thread::spawn(move || {
            let work = || -> Result<(), Error> {
                let send = |part| sender.send(part).map_err(|_| BandsError::Interrupted);
                let engine = engine.map_or_else(|| source.engine(number).map(Arc::new), Ok)?;
                send(Part::Ready(Arc::clone(&engine)))?;
                for size in previews(size).into_iter().filter(|_| number == 0) {
                    // The tracer has a raster of every size that is smaller than the picture's.
                    let trace = |first, levels: &mut [_]| {
                        let _ = engine.preview_rows(size, first, u8::MAX, levels);
                    };
                    let deliver = |first, levels| send(Part::Rows { size, first, levels });
                    bands::bands(size, &pool, &stopped, trace, deliver)?;
                }
                let began = Instant::now();
                if let Some((lattice, frames)) = samples {
                    let mut light = Vec::new();
                    for frame in frames {
                        let grid = if frame == number {
                            engine.on_grid(lattice, &pool, &stopped)
                        } else {
                            source.engine(frame)?.on_grid(lattice, &pool, &stopped)
                        };
                        light.extend(grid?);
                    }
                    send(Part::Samples { light, width: lattice.grid().width() })?;
                }
                if let Some(passes) = passes {
                    let pass = |samples, error, levels| send(Part::Pass { samples, error, levels });
                    passes.trace(&engine, (size, light_max), &pool, &stopped, &pass)?;
                    return Ok(send(Part::Complete(began.elapsed()))?);
                }
                let trace = |first, levels: &mut [_]| engine.level_rows(first, light_max, levels);
                let deliver = |first, levels| send(Part::Rows { size, first, levels });
                bands::bands(size, &pool, &stopped, trace, deliver)?;
                Ok(send(Part::Complete(began.elapsed()))?)
            };
            match work() {
                // Nobody waits for the rest.
                Err(error) if error.is_interruption() => {}
                Err(error) => drop(sender.send(Part::Failed(Box::new(error)))),
                Ok(()) => {}
            }
        });
        Self { parts, stop }
    }

    /// Returns the next part if one is ready.
    #[must_use]
    pub fn next(&self) -> Option<Part> {
        self.parts.try_recv().ok()
    }
}

/// Returns the sizes of the previews of a picture, from coarse to fine: none if the picture is small.
fn previews(size: Size) -> Vec<Size> {
    let longer = size.width().max(size.height());
    let blocks = (0..16).map(|power| 1 << power).skip_while(|block| *block < FINEST);
    let mut sizes: Vec<_> = blocks
        .take_while(|block| longer / block >= COARSEST)
        .filter_map(|block| Size::new(size.width().div_ceil(block), size.height().div_ceil(block)).ok())
        .filter(|preview| preview.pixels() <= MOST)
        .collect();
    sizes.reverse();
    sizes
}

#[cfg(test)]
mod tests {
    use super::previews;

    #[test]
    fn previews_begin_coarse_and_grow_finer() {
        for (picture, want) in [
            ("320x200", &["40x25", "80x50"][..]),
            ("1152x900", &["72x57", "144x113", "288x225"]),
            ("160x1", &["40x1"]),
            ("80x50", &[]),
            ("8x8", &[]),
            ("1x1", &[]),
        ] {
            let sizes = previews(picture.parse().expect("a size"));
            assert_eq!(sizes.iter().map(ToString::to_string).collect::<Vec<_>>(), want, "{picture}");
        }
        let largest = previews("65535x65535".parse().expect("a size"));
        let ends = (largest.first().map(ToString::to_string), largest.last().map(ToString::to_string));
        assert_eq!(ends, (Some("64x64".into()), Some("1024x1024".into())));
    }
}
