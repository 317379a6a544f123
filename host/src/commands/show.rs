//! `rta show` without its window: the picture that fills in, and what each key does to it.

pub mod frame;
pub mod window;

use core::sync::atomic::{AtomicBool, Ordering};
use core::time::Duration;
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, TryRecvError};
use std::time::Instant;

use rayon::ThreadPool;
use rta_core::color::Rgb;

use crate::engine::MAX_DEPTH;
use crate::engine::bands::{self, BandsError};
use crate::error::Error;
use crate::picture::device::{Device, Target};
use crate::picture::error::PictureError;
use crate::picture::file::Displayed;
use crate::picture::output;
use crate::picture::screen::Screen;
use crate::request::Request;
use crate::request::scene_file::SceneFile;

/// A change that a key asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// The next device, with its whole raster.
    Device,
    /// The next illumination model.
    Model,
    /// The next number format.
    Format,
    /// The next colour table.
    Table,
    /// One reflection more.
    Deeper,
    /// One reflection fewer.
    Shallower,
    /// The picture traced again.
    Restart,
    /// A PNG of what the device shows now.
    Save,
}

/// A picture on a screen, and the threads that trace it.
pub struct Show {
    scene: SceneFile,
    request: Request,
    device: Device,
    screen: Screen,
    pool: Arc<ThreadPool>,
    tracing: Tracing,
    /// The result of the last key, for the title.
    note: Option<String>,
}

/// The threads that trace a picture. They stop within a band when this is dropped.
struct Tracing {
    bands: Receiver<(u32, Vec<Rgb<u8>>)>,
    stop: Arc<AtomicBool>,
    began: Instant,
    /// Time that the picture took, once it is complete.
    took: Option<Duration>,
    /// Rows that are on the screen.
    rows: u32,
}

impl Drop for Tracing {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}

impl Show {
    /// Begins to trace `scene` for the screen of `device`.
    ///
    /// # Errors
    /// Those of [`Request::engine`], [`BandsError::Threads`] and [`PictureError::Display`].
    pub fn new(
        scene: SceneFile,
        device: Device,
        request: Request,
        threads: Option<u16>,
    ) -> Result<Self, Error> {
        let pool = Arc::new(bands::pool(threads)?);
        let request = Request { target: Target::On(device), ..request };
        let (screen, tracing) = begin(&scene, device, &request, &pool)?;
        Ok(Self { scene, request, device, screen, pool, tracing, note: None })
    }

    /// The device whose screen is shown.
    #[must_use]
    pub const fn device(&self) -> Device {
        self.device
    }

    /// The picture that is asked for now.
    #[must_use]
    pub const fn request(&self) -> &Request {
        &self.request
    }

    /// Returns whether all rows are on the screen.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.tracing.took.is_some()
    }

    /// Puts the rows that are ready on the screen, for about as long as `budget`. Returns whether there were any.
    ///
    /// # Errors
    /// [`PictureError::Display`] if the device refuses them.
    pub fn advance(&mut self, budget: Duration) -> Result<bool, Error> {
        let until = Instant::now() + budget;
        let mut any = false;
        while self.tracing.took.is_none() {
            match self.tracing.bands.try_recv() {
                Ok((first, levels)) => {
                    self.screen.put_rows(first, &levels)?;
                    let (size, _) = self.request.raster()?;
                    self.tracing.rows = first + (levels.len() / size.columns()).try_into().unwrap_or(0);
                    if self.tracing.rows == size.height() {
                        self.tracing.took = Some(self.tracing.began.elapsed());
                    }
                    any = true;
                }
                Err(TryRecvError::Empty | TryRecvError::Disconnected) => break,
            }
            if Instant::now() >= until {
                break;
            }
        }
        Ok(any)
    }

    /// Returns the picture that the device shows now.
    ///
    /// # Errors
    /// [`PictureError::Display`] if it does not answer.
    pub fn picture(&mut self) -> Result<Displayed, Error> {
        Ok(self.screen.picture()?)
    }

    /// Carries out what a key asks for, and returns the name of the file that was saved, if any. On an error the title tells it,
    /// and everything stays as it was.
    pub fn obey(&mut self, command: Command) -> Option<String> {
        self.note = None;
        let mut request = self.request.clone();
        let mut device = self.device;
        match command {
            Command::Device => {
                device = device.next();
                request = Request { target: Target::On(device), size: None, aspect: None, ..request };
            }
            Command::Model => request.model = request.model.next(),
            Command::Format => request.format = request.format.next(),
            Command::Table => request.table = request.table.next(),
            Command::Deeper if request.depth < MAX_DEPTH => request.depth += 1,
            Command::Shallower if request.depth > 0 => request.depth -= 1,
            Command::Deeper | Command::Shallower => return None,
            Command::Restart => {}
            Command::Save => {
                let saved = self.save();
                self.note = Some(match &saved {
                    Ok(name) => format!("saved {name}"),
                    Err(error) => error.to_string(),
                });
                return saved.ok();
            }
        }
        match begin(&self.scene, device, &request, &self.pool) {
            Ok((screen, tracing)) => {
                (self.screen, self.tracing) = (screen, tracing);
                (self.device, self.request) = (device, request);
            }
            Err(error) => self.note = Some(error.to_string()),
        }
        None
    }

    /// Saves what the device shows now as a new PNG in the current folder. Returns its name.
    ///
    /// # Errors
    /// [`PictureError::Write`] and [`PictureError::Display`].
    pub fn save(&mut self) -> Result<String, Error> {
        let mut content = Vec::new();
        let stem = format!("rta-{}-{}", self.scene.title, self.device);
        let encoded = self.picture()?.write_png(&self.request.caption(&self.scene), &mut content);
        encoded.map_err(|source| PictureError::write(stem.as_ref(), source))?;
        Ok(output::write_new(&stem, &content)?.display().to_string())
    }

    /// Returns the title: scene, device, format, model, depth and time, and the result of the last key.
    #[must_use]
    pub fn title(&self) -> String {
        let Request { table, format, model, depth, .. } = &self.request;
        let (title, device) = (&self.scene.title, self.device);
        let time = match self.tracing.took {
            Some(took) => format!("{:.2} s", took.as_secs_f64()),
            None => {
                let rows = self.request.raster().map_or(1, |(size, _)| size.height());
                format!("{} %", u64::from(self.tracing.rows) * 100 / u64::from(rows))
            }
        };
        let note = self.note.as_ref().map(|note| format!(" | {note}")).unwrap_or_default();
        format!("rta: {title} | {device} | {format} | {model} | depth {depth} | {table} | {time}{note}")
    }
}

/// Switches a screen on and starts to trace.
fn begin(
    scene: &SceneFile,
    device: Device,
    request: &Request,
    pool: &Arc<ThreadPool>,
) -> Result<(Screen, Tracing), Error> {
    let (size, aspect) = request.raster()?;
    let engine = request.engine(scene)?;
    let screen = Screen::new(device, request.table, size, aspect)?;
    let gun_max = device.capabilities().gun_max;
    let (sender, bands) = mpsc::channel();
    let stop = Arc::new(AtomicBool::new(false));
    let (threads, stopped) = (Arc::clone(pool), Arc::clone(&stop));
    std::thread::spawn(move || {
        let trace = |first, levels: &mut [_]| engine.level_rows(first, gun_max, levels);
        let deliver = |first, levels| sender.send((first, levels)).map_err(|_| BandsError::Interrupted);
        // It ends early only if nobody waits for the rest.
        let _ = bands::bands(size, &threads, &stopped, trace, deliver);
    });
    Ok((screen, Tracing { bands, stop, began: Instant::now(), took: None, rows: 0 }))
}
