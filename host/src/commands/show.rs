//! `rta show` without its window: the picture that fills in, and what each key does to it.

pub mod desktop;
pub mod film;
pub mod keys;
pub mod note;
pub mod overlay;
pub mod palette;
mod passing;
pub mod pointer;
pub mod reload;
pub mod shown;
pub mod source;
pub mod tracing;
pub mod window;

use core::time::Duration;
use std::sync::Arc;

use rayon::ThreadPool;

use crate::args::FilmArgs;
use crate::engine::MAX_DEPTH;
use crate::engine::bands;
use crate::error::Error;
use crate::picture::coloring::Coloring;
use crate::picture::device::Target;
use crate::picture::error::PictureError;
use crate::picture::frame::Place;
use crate::picture::output;
use crate::request::Request;
use crate::request::scene_file::SceneFile;
use film::Film;
use note::Note;
use reload::Watch;
use shown::Shown;
use source::Source;

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
    /// The film stands still, or goes on.
    Pause,
    /// The film stands still one frame on.
    Next,
    /// The film stands still one frame back.
    Previous,
}

/// A picture or a film on a screen, and the threads that trace it.
pub struct Show {
    scene: Arc<SceneFile>,
    /// The file of the scene, if it can be read again.
    watch: Option<Watch>,
    request: Request,
    /// The film that is asked for, if one is.
    asked: FilmArgs,
    pool: Arc<ThreadPool>,
    film: Film,
    /// Whether the picture is saved once it is complete.
    is_saving: bool,
    /// The result of the last key, or of a change of the file.
    note: Option<Note>,
}

impl Show {
    /// Begins to trace `scene`, whose file is watched by `watch` if it is one that can be read again: a picture, or a film.
    ///
    /// # Errors
    /// Those of [`Film::begin`], and [`BandsError::Threads`](bands::BandsError::Threads).
    pub fn new(
        scene: SceneFile,
        watch: Option<Watch>,
        (request, asked): (Request, FilmArgs),
        threads: Option<u16>,
    ) -> Result<Self, Error> {
        let (scene, pool) = (Arc::new(scene), Arc::new(bands::pool(threads)?));
        let source = Source::new(Arc::clone(&scene), request.clone(), asked.frames);
        let film = Film::begin(source, asked, Arc::clone(&pool))?;
        Ok(Self { scene, watch, request, asked, pool, film, is_saving: false, note: None })
    }

    /// The picture that is asked for now.
    #[must_use]
    pub const fn request(&self) -> &Request {
        &self.request
    }

    /// The frames that are seen, or the picture.
    #[must_use]
    pub const fn film(&self) -> &Film {
        &self.film
    }

    /// Returns whether all of the picture is there, or all frames.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.film.is_complete()
    }

    /// Returns whether the picture is to be saved and is not complete yet.
    #[must_use]
    pub const fn is_saving(&self) -> bool {
        self.is_saving
    }

    /// Puts the rows that are ready on the screen, for about as long as `budget`, and lets a film go on. Returns whether something else
    /// is to be seen now.
    ///
    /// # Errors
    /// Those of [`Film::advance`].
    pub fn advance(&mut self, budget: Duration) -> Result<bool, Error> {
        let is_new = self.film.advance(budget)?;
        if let Some(error) = self.film.failure() {
            self.note = Some(Note::error(error.to_string()));
            self.is_saving &= self.film.has_picture();
        }
        if self.film.has_picture() && core::mem::take(&mut self.is_saving) {
            self.save();
        }
        Ok(is_new)
    }

    /// Returns what is to be seen of the picture, read back from the device.
    ///
    /// # Errors
    /// [`PictureError::Display`] if it does not answer.
    pub fn shown(&mut self) -> Result<&Shown, Error> {
        self.film.refresh()?;
        Ok(self.film.shown())
    }

    /// Returns where the picture lies in a window of `width` x `height`.
    #[must_use]
    pub fn place(&self, width: usize, height: usize) -> Place {
        let picture = self.film.shown().picture();
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
            Command::Pause | Command::Next | Command::Previous => return self.turn(command),
            Command::Save if self.film.has_picture() => return self.save(),
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
            .and_then(|request| Ok((self.begin(&self.scene, &request)?, request)));
        match begun {
            Ok((film, request)) => {
                self.request = request;
                self.replace(film);
            }
            Err(error) => self.note = Some(Note::error(error.to_string())),
        }
    }

    /// Begins to trace a scene from its first frame.
    fn begin(&self, scene: &Arc<SceneFile>, request: &Request) -> Result<Film, Error> {
        let source = Source::new(Arc::clone(scene), request.clone(), self.asked.frames);
        Film::begin(source, self.asked, Arc::clone(&self.pool))
    }

    /// Lets the film stand still or go on.
    fn turn(&mut self, command: Command) {
        match command {
            _ if !self.film.is_film() => {
                let text = "this is one picture: rta show --frames shows a film".into();
                self.note = Some(Note::message(text));
            }
            Command::Next => self.film.step(1),
            Command::Previous => self.film.step(-1),
            _ => self.film.pause(),
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
            let film = self.begin(&scene, &request)?;
            Ok((scene, request, film))
        });
        match begun {
            Ok((scene, request, film)) => {
                (self.scene, self.request) = (scene, request);
                self.replace(film);
            }
            Err(error) => self.note = Some(Note::error(error.to_string())),
        }
    }

    fn read_again(&mut self) -> Result<(Arc<SceneFile>, Request), Error> {
        let Some(watch) = &mut self.watch else {
            return Ok((Arc::clone(&self.scene), self.request.clone()));
        };
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
        Ok((Arc::new(scene), request))
    }

    fn replace(&mut self, film: Film) {
        self.film = film;
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
        let frame = self.film.number().map(|number| format!("-frame-{number}")).unwrap_or_default();
        let stem = format!("rta-{}-{}{frame}", self.scene.title, self.request.target);
        let caption = self.film.request().caption(&self.scene);
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
        self.film.describe((x, y))
    }

    /// Returns the title: scene, device, format, model, depth, frame and time, and the result of the last key.
    #[must_use]
    pub fn title(&self) -> String {
        let Request { target, coloring, format, model, depth, .. } = &self.request;
        let title = &self.scene.title;
        let note = self.note.as_ref().map(|note| format!(" | {}", note.text())).unwrap_or_default();
        let colors = match target {
            Target::On(_) => format!("{}, dither {}", coloring.table, coloring.dither),
            Target::None => "no colour table".into(),
        };
        format!(
            "rta: {title} | {target} | {format} | {model} | depth {depth} | {colors} | {}{note}",
            self.film.progress()
        )
    }
}
