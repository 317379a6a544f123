//! A picture that grows better pass by pass.

use core::sync::atomic::AtomicBool;
use core::time::Duration;
use std::time::Instant;

use rayon::ThreadPool;
use rta_args::value::until::Until;
use rta_core::color::Rgb;
use rta_core::raster::Places;
use rta_core::sampling::Sobol;

use crate::engine::Engine;
use crate::engine::bands::BandsError;
use crate::engine::passes::Ended;
use crate::error::Error;
use crate::picture::error::PictureError;
use crate::picture::raster::Size;
use crate::request::Request;

/// Where the passes of a picture end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passing {
    /// The most samples of a pixel.
    most: u32,
    /// The error that is small enough.
    error: f64,
    /// The time that they may take.
    time: Option<Duration>,
}

impl Passing {
    /// Returns where the passes of a picture end: as it is asked for, else with its samples where its rays are spread; `None` where they
    /// are not.
    pub(super) fn of(request: &Request) -> Option<Self> {
        let all = Self { most: Sobol::MAX_SAMPLES, error: 0.0, time: None };
        Some(match request.until {
            Some(Until::Error(error)) => Self { error, ..all },
            Some(Until::Time(time)) => Self { time: Some(time), ..all },
            None => Self { most: request.sampling.spreading()?.samples.samples(), ..all },
        })
    }

    /// Adds passes to a picture; after each, `send` takes the samples of a pixel, the estimated error, and the picture in levels of
    /// `0..=light_max`.
    pub(super) fn trace(
        self,
        engine: &Engine,
        (size, light_max): (Size, u8),
        pool: &ThreadPool,
        stop: &AtomicBool,
        send: &dyn Fn(u32, f64, Vec<Rgb<u8>>) -> Result<(), BandsError>,
    ) -> Result<(), Error> {
        let deadline = self.time.and_then(|time| Instant::now().checked_add(time));
        let mut passes = engine.passes().ok_or(PictureError::Memory(size))?;
        while passes.goes_on(self.most, self.error) {
            match passes.pass(self.most, pool, stop, deadline, &|_| {}) {
                Ok(()) => {}
                Err(Ended::Late) => break,
                Err(Ended::Interrupted) => return Err(BandsError::Interrupted.into()),
            }
            let mut levels = Vec::new();
            levels.try_reserve_exact(size.pixels()).map_err(|_| PictureError::Memory(size))?;
            levels.resize(size.pixels(), Rgb::default());
            passes.level_rows(0, light_max, &mut levels);
            send(passes.samples(), passes.error(), levels)?;
        }
        Ok(())
    }
}
