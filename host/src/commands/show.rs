//! `rta show` without its window: the picture that fills in, and what each key does to it.

pub mod desktop;
pub mod keys;
pub mod note;
pub mod overlay;
pub mod palette;
pub mod pointer;
pub mod reload;
pub mod shown;
pub mod tracing;
pub mod window;

use core::time::Duration;
use std::sync::Arc;
use std::time::Instant;

use rayon::ThreadPool;

use crate::engine::bands;
use crate::engine::{Engine, MAX_DEPTH};
use crate::error::Error;
use crate::picture::coloring::Coloring;
use crate::picture::device::Target;
use crate::picture::error::PictureError;
use crate::picture::frame::Place;
use crate::picture::output;
use crate::request::Request;
use crate::request::scene_file::SceneFile;
use note::Note;
use pointer::Pointer;
use reload::Watch;
use shown::Shown;
use tracing::{Asked, Part, Tracing};

/// A change that a key asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// The next device, with its whole raster, or none.
    Device,
    /// The next illumination model.
    Model,
    /// The next number format.
    Format,
    /// The next colour table.
    Table,
    /// The next way of dithering.
    Dither,
    /// One reflection more.
    Deeper,
    /// One reflection fewer.
    Shallower,
    /// The scene file read again, and the picture traced again.
    Reload,
    /// A PNG of what the device shows once the picture is complete.
    Save,
}

/// A picture on a screen, and the threads that trace it.
pub struct Show {
    scene: SceneFile,
    /// The file of the scene, if it can be read again.
    watch: Option<Watch>,
    request: Request,
    pool: Arc<ThreadPool>,
    work: Work,
    /// Whether the picture is saved once it is complete.
    is_saving: bool,
    /// The result of the last key, or of a change of the file.
    note: Option<Note>,
}

/// A picture that is being traced.
struct Work {
    engine: Arc<Engine>,
    shown: Shown,
    tracing: Tracing,
    /// Time that the picture took, once it is complete.
    took: Option<Duration>,
    pointer: Pointer,
}

impl Work {
    /// Switches a screen on and starts to trace.
    fn begin(scene: &SceneFile, request: &Request, pool: &Arc<ThreadPool>) -> Result<Self, Error> {
        let (size, _) = request.raster()?;
        let engine = Arc::new(request.engine(scene)?);
        let shown = Shown::new(request)?;
        let tracing = Tracing::begin(Arc::clone(&engine), Asked::of(request, size), Arc::clone(pool));
        Ok(Self { engine, shown, tracing, took: None, pointer: Pointer::default() })
    }
}

impl Show {
    /// Begins to trace `scene`, whose file is watched by `watch` if it is one that can be read again.
    ///
    /// # Errors
    /// Those of [`Request::engine`], [`BandsError::Threads`](bands::BandsError::Threads) and [`PictureError::Display`].
    pub fn new(
        scene: SceneFile,
        watch: Option<Watch>,
        request: Request,
        threads: Option<u16>,
    ) -> Result<Self, Error> {
        let pool = Arc::new(bands::pool(threads)?);
        let work = Work::begin(&scene, &request, &pool)?;
        Ok(Self { scene, watch, request, pool, work, is_saving: false, note: None })
    }

    /// The picture that is asked for now.
    #[must_use]
    pub const fn request(&self) -> &Request {
        &self.request
    }

    /// Returns whether all rows are on the screen.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.work.took.is_some()
    }

    /// Returns whether the picture is to be saved and is not complete yet.
    #[must_use]
    pub const fn is_saving(&self) -> bool {
        self.is_saving
    }

    /// Puts the rows that are ready on the screen, for about as long as `budget`. Returns whether there were any.
    ///
    /// # Errors
    /// [`PictureError::Display`] if the device refuses them.
    pub fn advance(&mut self, budget: Duration) -> Result<bool, Error> {
        let begin = Instant::now();
        let mut any = false;
        while let Some(part) = self.work.tracing.next() {
            if let Part::Complete(took) = part {
                self.work.took = Some(took);
                if core::mem::take(&mut self.is_saving) {
                    self.save();
                }
            }
            self.work.shown.put(part)?;
            any = true;
            if begin.elapsed() >= budget {
                break;
            }
        }
        Ok(any)
    }

    /// Returns what is to be seen of the picture, read back from the device.
    ///
    /// # Errors
    /// [`PictureError::Display`] if it does not answer.
    pub fn shown(&mut self) -> Result<&Shown, Error> {
        self.work.shown.refresh()?;
        Ok(&self.work.shown)
    }

    /// Returns where the picture lies in a window of `width` x `height`.
    #[must_use]
    pub fn place(&self, width: usize, height: usize) -> Place {
        let picture = self.work.shown.picture();
        Place::new(picture.size, picture.aspect, width, height)
    }

    /// Returns how many colours the device can show at once; 0 if there is no device.
    #[must_use]
    pub fn colors(&self) -> usize {
        self.request.target.device().map_or(0, |device| device.capabilities().colors.into())
    }

    /// Carries out what a key asks for. On an error a note tells it, and everything stays as it was.
    pub fn obey(&mut self, command: Command) {
        self.note = None;
        let mut request = self.request.clone();
        match command {
            Command::Device => {
                let target = request.target.next();
                // What looks best on one device does not on another.
                let coloring = target.device().map_or(request.coloring, Coloring::of);
                request = Request { target, coloring, size: None, aspect: None, ..request };
            }
            Command::Model => request.model = request.model.next(),
            Command::Format => request.format = request.format.next(),
            Command::Table => request.coloring.table = request.coloring.table.next(),
            Command::Dither => request.coloring.dither = request.coloring.dither.next(),
            Command::Deeper if request.depth < MAX_DEPTH => request.depth += 1,
            Command::Shallower if request.depth > 0 => request.depth -= 1,
            Command::Deeper | Command::Shallower => return,
            Command::Reload => return self.reload(),
            Command::Save if self.is_complete() => return self.save(),
            Command::Save => {
                self.is_saving = true;
                let text = "the picture is saved once it is complete".into();
                self.note = Some(Note::message(text));
                return;
            }
        }
        let model = request.model;
        let begun = request
            .for_scene(Some(model), &self.scene)
            .map_err(Error::from)
            .and_then(|request| Ok((Work::begin(&self.scene, &request, &self.pool)?, request)));
        match begun {
            Ok((work, request)) => {
                self.request = request;
                self.replace(work);
            }
            Err(error) => self.note = Some(Note::error(error.to_string())),
        }
    }

    /// Reads the scene file again if it has changed on disk.
    pub fn follow_file(&mut self) {
        if self.watch.as_mut().is_some_and(Watch::has_changed) {
            self.note = None;
            self.reload();
        }
    }

    /// Reads the scene again if it is in a file, and traces it. A file that is broken leaves the picture as it was.
    fn reload(&mut self) {
        let begun = self.read_again().and_then(|(scene, request)| {
            let work = Work::begin(&scene, &request, &self.pool)?;
            Ok((scene, request, work))
        });
        match begun {
            Ok((scene, request, work)) => {
                (self.scene, self.request) = (scene, request);
                self.replace(work);
            }
            Err(error) => self.note = Some(Note::error(error.to_string())),
        }
    }

    fn read_again(&mut self) -> Result<(SceneFile, Request), Error> {
        let Some(watch) = &mut self.watch else { return Ok((self.scene.clone(), self.request.clone())) };
        watch.take();
        let scene = SceneFile::open_as(watch.path(), watch.reading())?;
        let mut request = self.request.clone();
        // A size that the scene stated is stated anew.
        let size = request.size.map(|size| [size.width(), size.height()]);
        if request.target == Target::None && size == self.scene.description.raster {
            (request.size, request.aspect) = (None, None);
        }
        let model = request.model;
        let request = request.for_scene(Some(model), &scene)?;
        Ok((scene, request))
    }

    fn replace(&mut self, work: Work) {
        self.work = work;
        if core::mem::take(&mut self.is_saving) {
            let text = "not saved: another picture was begun before that one was complete".into();
            self.note = Some(Note::error(text));
        }
    }

    /// Saves what the device shows as a new PNG in the current folder, and notes its name or what has failed.
    fn save(&mut self) {
        self.note = Some(match self.save_new() {
            Ok(name) => Note::message(format!("saved {name}")),
            Err(error) => Note::error(error.to_string()),
        });
    }

    fn save_new(&mut self) -> Result<String, Error> {
        let mut content = Vec::new();
        let stem = format!("rta-{}-{}", self.scene.title, self.request.target);
        let caption = self.request.caption(&self.scene);
        let encoded = self.shown()?.picture().write_png(&caption, &mut content);
        encoded.map_err(|source| PictureError::write(stem.as_ref(), source))?;
        Ok(output::write_new(&stem, &content)?.display().to_string())
    }

    /// Notes the result of a key; none if there is nothing to say.
    pub fn note(&mut self, note: Option<Note>) {
        self.note = note;
    }

    /// Returns the note if it has not been told on the terminal yet; from now on it has.
    pub fn news(&mut self) -> Option<Note> {
        self.note.as_mut().and_then(Note::tell)
    }

    /// Returns the note as long as it is to be seen in the window.
    #[must_use]
    pub fn visible_note(&self) -> Option<&str> {
        self.note.as_ref().and_then(Note::visible)
    }

    /// Returns two lines about a pixel: its place, colour and entry of the colour table, and the object and rays behind it.
    #[must_use]
    pub fn describe(&mut self, x: u32, y: u32) -> Vec<String> {
        self.work.pointer.describe(&self.work.engine, &self.work.shown, (x, y))
    }

    /// Returns the title: scene, device, format, model, depth and time, and the result of the last key.
    #[must_use]
    pub fn title(&self) -> String {
        let Request { target, coloring, format, model, depth, .. } = &self.request;
        let title = &self.scene.title;
        let time = match self.work.took {
            Some(took) => format!("{:.2} s", took.as_secs_f64()),
            None => {
                let shown = &self.work.shown;
                let rows = shown.picture().size.height();
                format!("{} %", u64::from(shown.rows()) * 100 / u64::from(rows))
            }
        };
        let note = self.note.as_ref().map(|note| format!(" | {}", note.text())).unwrap_or_default();
        let colors = match target {
            Target::On(_) => format!("{}, dither {}", coloring.table, coloring.dither),
            Target::None => "no colour table".into(),
        };
        format!("rta: {title} | {target} | {format} | {model} | depth {depth} | {colors} | {time}{note}")
    }
}
