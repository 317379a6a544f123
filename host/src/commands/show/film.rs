//! What is shown: one picture, or the frames of a film. Each is traced once and kept; then the film is shown again and again.

use core::time::Duration;
use std::sync::Arc;
use std::time::Instant;

use rayon::ThreadPool;

use super::pointer::Pointer;
use super::shown::Shown;
use super::source::Source;
use super::tracing::{Asked, Part, Tracing};
use crate::args::FilmArgs;
use crate::engine::Engine;
use crate::error::Error;
use crate::picture::device::Target;
use crate::picture::error::PictureError;
use crate::request::Request;
use crate::request::sampler::with_samples;

/// The most bytes of frames that are kept: a quarter of an hour of mode 13h, or some seconds of a whole screen of today.
const MOST: u64 = 2 << 30;

/// A picture, or the frames of a film one after the other.
pub struct Film {
    source: Source,
    asked: FilmArgs,
    pool: Arc<ThreadPool>,
    first: Shown,
    /// The frames after the first one.
    others: Vec<Shown>,
    /// How many frames are there. One more is being traced, if any is.
    complete: u32,
    tracing: Option<Tracing>,
    /// The tracer of the frame that is being traced.
    engine: Option<Arc<Engine>>,
    /// Time that the frames took.
    took: Duration,
    /// Why there are no more frames, unless it was told already.
    failure: Option<Error>,
    /// The number of the frame that is seen.
    seen: u32,
    /// When it took its place.
    since: Instant,
    is_paused: bool,
    pointer: Pointer,
}

impl Film {
    /// Begins to trace the first frame.
    ///
    /// # Errors
    /// Those of [`Source::first_engine`], [`PictureError::Display`], [`PictureError::Memory`] and [`PictureError::Film`].
    pub fn begin(source: Source, asked: FilmArgs, pool: Arc<ThreadPool>) -> Result<Self, Error> {
        check_memory(&source)?;
        let engine = Arc::new(source.first_engine()?);
        let mut pointer = Pointer::default();
        pointer.take(0, Arc::clone(&engine));
        let first = Shown::new(source.request(), None)?;
        let mut film = Self {
            source,
            asked,
            pool,
            first,
            others: Vec::new(),
            complete: 0,
            tracing: None,
            engine: None,
            took: Duration::ZERO,
            failure: None,
            seen: 0,
            since: Instant::now(),
            is_paused: false,
            pointer,
        };
        film.trace(0, Some(engine))?;
        Ok(film)
    }

    /// Begins to trace a frame, which its device is ready for.
    fn trace(&mut self, number: u32, engine: Option<Arc<Engine>>) -> Result<(), Error> {
        let table = match (self.asked.one_table, number) {
            (false, _) => number..number + 1,
            (true, 0) => 0..self.source.frames(),
            (true, _) => 0..0,
        };
        let request = self.source.request();
        let asked = Asked::of(request, number, table)?;
        let asked = if self.is_film() { asked } else { asked.in_passes(request) };
        self.tracing = Some(Tracing::begin(self.source.clone(), engine, asked, Arc::clone(&self.pool)));
        Ok(())
    }

    /// Takes what has been traced, for about as long as `budget`, and lets the film go on. Returns whether something else is seen now.
    ///
    /// # Errors
    /// [`PictureError::Display`] if the device refuses it, and [`PictureError::Memory`].
    pub fn advance(&mut self, budget: Duration) -> Result<bool, Error> {
        let begin = Instant::now();
        let mut is_new = false;
        while let Some(part) = self.tracing.as_ref().and_then(Tracing::next) {
            is_new |= self.take(part)?;
            if begin.elapsed() >= budget {
                break;
            }
        }
        Ok(self.play() || is_new)
    }

    /// Takes a part of the frame that is being traced. Returns whether something else is seen now.
    fn take(&mut self, part: Part) -> Result<bool, Error> {
        match part {
            Part::Ready(engine) => {
                self.engine = Some(engine);
                return Ok(false);
            }
            Part::Failed(error) => {
                (self.tracing, self.failure, self.since) = (None, Some(*error), Instant::now());
                self.others.truncate(self.complete.saturating_sub(1) as usize);
            }
            Part::Complete(took) => {
                self.took += took;
                self.keep()?;
            }
            part => {
                self.others.last_mut().unwrap_or(&mut self.first).put(part)?;
                return Ok(self.complete == 0);
            }
        }
        Ok(true)
    }

    /// Keeps the frame that is complete, and begins with the next one: on the same screen, if the colour table is that of all frames.
    fn keep(&mut self) -> Result<(), Error> {
        let screen = self.others.last_mut().unwrap_or(&mut self.first).finish()?;
        (self.tracing, self.since) = (None, Instant::now());
        let number = self.complete;
        self.complete += 1;
        if !self.is_paused {
            self.seen = number;
            if let Some(engine) = self.engine.take() {
                self.pointer.take(number, engine);
            }
        }
        if !self.is_complete() {
            let request = self.source.request();
            let next = Shown::new(request, screen.filter(|_| self.asked.one_table))?;
            self.others.try_reserve(1).map_err(|_| PictureError::Memory(next.picture().size))?;
            self.others.push(next);
            self.trace(self.complete, None)?;
        }
        Ok(())
    }

    /// Goes on to the frame that is due once all that there will be are there. Returns whether it is another.
    fn play(&mut self) -> bool {
        if !self.is_playing() {
            return false;
        }
        let steps = self.since.elapsed().as_nanos() / self.pace().as_nanos().max(1);
        if steps == 0 {
            return false;
        }
        let steps = u32::try_from(steps).unwrap_or(u32::MAX);
        let before = self.seen;
        self.since += self.pace() * steps;
        self.turn(i64::from(steps));
        self.seen != before
    }

    /// Goes so many frames on, or back: from the last one to the first, and round again.
    fn turn(&mut self, by: i64) {
        let place = (i64::from(self.seen) + by).rem_euclid(i64::from(self.complete.max(1)));
        self.seen = u32::try_from(place).unwrap_or(0);
    }

    /// Returns the time for which a frame is seen.
    fn pace(&self) -> Duration {
        Duration::from_secs(1) / u32::from(self.asked.rate.max(1))
    }

    /// Lets the film stand still, or go on.
    pub fn pause(&mut self) {
        (self.is_paused, self.since) = (!self.is_paused, Instant::now());
        if !self.is_paused && self.is_tracing() {
            self.seen = self.complete.saturating_sub(1);
        }
    }

    /// Lets the film stand still, so many frames on or back.
    pub fn step(&mut self, by: i64) {
        self.is_paused = true;
        self.turn(by);
    }

    /// Returns whether it is a film, and not one picture.
    #[must_use]
    pub const fn is_film(&self) -> bool {
        self.asked.frames.is_some()
    }

    /// Returns whether a frame is still being traced.
    #[must_use]
    pub const fn is_tracing(&self) -> bool {
        self.tracing.is_some()
    }

    /// Returns whether frames are shown one after the other from memory.
    #[must_use]
    pub const fn is_playing(&self) -> bool {
        self.complete > 1 && !self.is_paused && !self.is_tracing()
    }

    /// Returns whether the picture is there, or the first frame.
    #[must_use]
    pub const fn has_picture(&self) -> bool {
        self.complete > 0
    }

    /// Returns whether all frames are there.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.complete == self.source.frames()
    }

    /// Returns the number of the frame that is seen, if it is a film.
    #[must_use]
    pub fn number(&self) -> Option<u32> {
        self.is_film().then_some(self.seen)
    }

    /// Returns why there are no more frames, once.
    pub const fn failure(&mut self) -> Option<Error> {
        self.failure.take()
    }

    /// Returns the request of what is seen: with the samples of the last pass, if it has passes.
    #[must_use]
    pub fn request(&self) -> Request {
        let request = self.source.request().clone();
        match self.first.pass() {
            Some((samples, _)) => Request { sampling: with_samples(request.sampling, samples), ..request },
            None => request,
        }
    }

    /// Reads back from the device what is to be seen.
    ///
    /// # Errors
    /// [`PictureError::Display`] if it does not answer.
    pub fn refresh(&mut self) -> Result<(), Error> {
        // The others are seen once they are complete.
        self.first.refresh()
    }

    /// Returns what is to be seen, as it was read back last: a frame, or the first one as far as it has been traced.
    #[must_use]
    pub fn shown(&self) -> &Shown {
        frame(&self.first, &self.others, self.seen)
    }

    /// Returns two lines about a pixel of the frame that is seen.
    #[must_use]
    pub fn describe(&mut self, pixel: (u32, u32)) -> Vec<String> {
        let moment = self.is_playing().then(|| self.pace());
        let shown = frame(&self.first, &self.others, self.seen);
        self.pointer.describe((&self.source, self.seen), shown, pixel, moment)
    }

    /// Returns which frame is seen, and how far the tracing is, or what time it took.
    #[must_use]
    pub fn progress(&self) -> String {
        let (complete, seen) = (self.complete, self.seen);
        let took = self.took.as_secs_f64();
        let progress = match (self.is_complete(), complete, self.is_tracing()) {
            (is_done, ..) if let Some((samples, error)) = self.first.pass() => {
                let end = if is_done { format!(" | {took:.2} s") } else { String::new() };
                format!("{samples} samples, error {error:.2e}{end}")
            }
            (true, ..) => format!("{took:.2} s"),
            (_, 0, _) => {
                let rows = self.first.picture().size.height();
                format!("{} %", u64::from(self.first.rows()) * 100 / u64::from(rows))
            }
            (_, _, true) => format!("tracing {complete}"),
            (_, _, false) => format!("there is no frame {complete}"),
        };
        let Some(frames) = self.asked.frames else { return progress };
        let pause = if self.is_paused { ", paused" } else { "" };
        format!("frame {seen}/{frames}{pause} | {progress}")
    }
}

/// Returns a frame by its number.
fn frame<'a>(first: &'a Shown, others: &'a [Shown], number: u32) -> &'a Shown {
    number.checked_sub(1).and_then(|place| others.get(place as usize)).unwrap_or(first)
}

/// Checks that the frames of a film are not too much for memory.
fn check_memory(source: &Source) -> Result<(), PictureError> {
    let (Request { target, .. }, frames) = (source.request(), source.frames());
    let Ok((size, _)) = source.request().raster() else { return Ok(()) };
    let depth = if *target == Target::None { 3 } else { 1 };
    let bytes = depth * u64::from(frames) * u64::from(size.width()) * u64::from(size.height());
    if frames > 1 && bytes > MOST {
        return Err(PictureError::Film { frames, size, bytes, most: MOST });
    }
    Ok(())
}
