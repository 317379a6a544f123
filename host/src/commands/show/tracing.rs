//! The threads behind the window: first coarse previews of the picture, each finer than the one before, then the picture itself.

use core::sync::atomic::{AtomicBool, Ordering};
use core::time::Duration;
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver};
use std::time::Instant;

use rayon::ThreadPool;
use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::raster::lattice::Lattice;

use crate::engine::Engine;
use crate::engine::bands::{self, BandsError};
use crate::picture::raster::Size;
use crate::request::Request;

/// The first preview has about this many pixels along its longer side: it is there at once.
const COARSEST: u32 = 40;
/// The side of the blocks of the last preview, in pixels of the picture. All previews together then take at most
/// 1/16 + 1/64 + ... = 1/12 of the picture's primary rays; one with blocks of 2 would take four times as many.
const FINEST: u32 = 4;
/// A preview with more pixels would be finer than most windows.
const MOST: usize = 1 << 20;

/// Something that has been traced.
#[derive(Debug)]
pub enum Part {
    /// Whole rows of a preview or, with the size of the picture, of the picture itself, from the top down.
    Rows {
        /// Pixels of the preview or picture.
        size: Size,
        /// The first row.
        first: u32,
        /// Levels: of a preview 0..=255; of the picture those that its device takes.
        levels: Vec<Rgb<u8>>,
    },
    /// The pixels of a grid, 8 bits a gun, of which the device's colour table is to be made. They come before the first row of the
    /// picture, and none come for a table that is not made from the picture.
    Samples(Vec<Rgb<u8>>),
    /// The picture is complete. It has taken this long, without its previews.
    Complete(Duration),
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
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    /// Pixels of the picture.
    size: Size,
    /// The highest level of its light.
    light_max: u8,
    /// The grid whose pixels are needed before the first row.
    samples: Option<Lattice>,
}

impl Asked {
    /// Returns what is to be traced for the picture of `request`, whose size is `size`.
    #[must_use]
    pub fn of(request: &Request, size: Size) -> Self {
        let coloring = request.coloring;
        let device = request.target.device();
        let light_max = device.map_or(u8::MAX, |device| coloring.light_max(device.capabilities()));
        let is_sampled = device.is_some() && coloring.samples() > 0;
        let raster = Raster::new(size.width(), size.height()).ok().filter(|_| is_sampled);
        let samples = raster.map(|raster| Lattice::new(raster, coloring.samples()));
        Self { size, light_max, samples }
    }
}

impl Tracing {
    /// Begins to trace a picture.
    pub fn begin(engine: Arc<Engine>, asked: Asked, pool: Arc<ThreadPool>) -> Self {
        let Asked { size, light_max, samples } = asked;
        let (sender, parts) = mpsc::channel();
        let stop = Arc::new(AtomicBool::new(false));
        let stopped = Arc::clone(&stop);
        std::thread::spawn(move || {
            let work = || -> Result<(), BandsError> {
                let send = |part| sender.send(part).map_err(|_| BandsError::Interrupted);
                for size in previews(size) {
                    // The tracer has a raster of every size that is smaller than the picture's.
                    let trace = |first, levels: &mut [_]| {
                        let _ = engine.preview_rows(size, first, u8::MAX, levels);
                    };
                    let deliver = |first, levels| send(Part::Rows { size, first, levels });
                    bands::bands(size, &pool, &stopped, trace, deliver)?;
                }
                let began = Instant::now();
                if let Some(lattice) = samples {
                    send(Part::Samples(engine.on_grid(lattice, &pool, &stopped)?))?;
                }
                let trace = |first, levels: &mut [_]| engine.level_rows(first, light_max, levels);
                let deliver = |first, levels| send(Part::Rows { size, first, levels });
                bands::bands(size, &pool, &stopped, trace, deliver)?;
                send(Part::Complete(began.elapsed()))
            };
            // It ends early only if nobody waits for the rest.
            let _ = work();
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
