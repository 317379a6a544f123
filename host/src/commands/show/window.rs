//! The window of `rta show`, and what it does where there is none.

use core::sync::atomic::{AtomicBool, Ordering};
use core::time::Duration;
use std::io::{self, Write};
use std::sync::mpsc;
use std::time::Instant;

use minifb::{MouseMode, ScaleMode, Window, WindowOptions};

use rta_scenes::shipped;

use crate::args::{DrawingArgs, ShowArgs};
use crate::commands::render::{Film, Goal, Work, tempo, trace};
use crate::commands::show::Show;
use crate::commands::show::desktop::{self, Desktop};
use crate::commands::show::keys::{Keyboard, Press};
use crate::commands::show::note::Note;
use crate::commands::show::overlay::{self, Overlay};
use crate::commands::show::reload::Watch;
use crate::engine::bands::BandsError;
use crate::engine::interrupt;
use crate::error::Error;
use crate::picture::FileType;
use crate::picture::error::PictureError;
use crate::picture::frame::{Frame, Place};
use crate::picture::output::{self, Failure, Inputs};
use crate::picture::raster::Size;
use crate::request::Request;
use crate::request::sampler::with_samples;
use crate::request::scene_file::SceneFile;

/// Frames a second.
const RATE: usize = 60;

/// Time of a frame that may be spent on drawing on the device; the rest is for the window.
const BUDGET: Duration = Duration::from_millis(8);

/// The window is drawn at least this often even if nothing has changed, since it may have been covered.
const REFRESH: Duration = Duration::from_millis(100);

/// Time for which the keys are told when the window opens, unless one is pressed.
const WELCOME: Duration = Duration::from_secs(4);

/// The room for the window where the size of the screen is not known.
const ROOM: (usize, usize) = (1152, 900);

/// A picture that is smaller is enlarged up to this size, and a larger one up to its own.
const ENLARGED: (usize, usize) = (1152, 1024);

/// The window is at least this large if the screen is, so that text can be read in it.
const SMALLEST: (usize, usize) = (640, 480);

/// Runs `rta show`.
///
/// # Errors
/// All of [`Error`] that concern a scene, a device or a file in the current folder.
pub fn run(args: &ShowArgs) -> Result<(), Error> {
    Request::of(&args.tracing, args.device).raster()?;
    let path = args.scene.as_deref();
    let reading = args.tracing.reading.into();
    let watch = path.map(|path| Watch::new(path, reading));
    let scene = match (path, args.film.frames) {
        (Some(path), _) => SceneFile::open_as(path, reading)?,
        (None, None) => SceneFile::juggler()?,
        // The figure that stands still, juggling.
        (None, Some(_)) => SceneFile::of_text("juggler", shipped::JUGGLING, reading)?,
    };
    let request = Request::of_scene(&args.tracing, args.device, &scene)?;
    let request = request.until(args.until, &args.tracing, &scene)?;
    let (size, aspect) = request.raster()?;
    let stop = interrupt::watch();
    let reason = match open(size, aspect) {
        Ok(window) => {
            let show = Show::new(scene, watch, (request, args.film), args.tracing.threads)?;
            return run_in(window, show, stop);
        }
        Err(reason) => reason,
    };
    let stem = format!("rta-{}-{}", scene.title, args.device);
    let (what, content) = match written(args, &request, &scene, stop) {
        Ok(written) => written,
        Err(Failure::Write(source)) => return Err(PictureError::write(stem.as_ref(), source).into()),
        Err(Failure::Other(error)) => return Err(error),
    };
    let name = output::write_new(&stem, &content)?;
    say(&format!("rta: {reason}, so the {what} is in ./{}", name.display()))
}

/// Returns the picture as a PNG, or the film as an animated one, and which of them it is.
fn written(
    args: &ShowArgs,
    request: &Request,
    scene: &SceneFile,
    stop: &AtomicBool,
) -> Result<(&'static str, Vec<u8>), Failure<Error>> {
    let ShowArgs { device, film, tracing, .. } = args;
    let (mut content, mut caption) = (Vec::new(), request.caption(scene));
    if let Some(end) = request.until {
        let (engine, shape) = (request.engine(scene)?, request.raster()?);
        let traced = trace(&engine, shape.0, Goal::Until(end, false), (tracing.threads, false))?;
        let sampling = with_samples(request.sampling, traced.samples());
        caption = Request { sampling, ..request.clone() }.caption(scene);
        let work = Work::of(traced, (request.target, request.coloring), shape, tracing.threads, stop)?;
        work.displayed()?.write_png(&caption, &mut content)?;
        return Ok(("picture", content));
    }
    let Some(frames) = film.frames else {
        let work = Work::new(request, scene, tracing.threads, stop)?;
        work.displayed()?.write_png(&caption, &mut content)?;
        return Ok(("picture", content));
    };
    caption.settings += &tempo(frames, film.rate);
    let (tracing, output) = (tracing.clone(), "-".into());
    let args = &DrawingArgs { output, device: *device, file_type: None, quiet: false, film: *film, tracing };
    Film { request, scene, args, frames }.write(FileType::Png, &caption, &mut content)?;
    Ok(("film", content))
}

/// Opens a window for a picture of `size` pixels on a screen of shape `aspect`, or says why there is none.
fn open(size: Size, aspect: f64) -> Result<Window, String> {
    let named = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    let unix = cfg!(all(unix, not(target_os = "macos")));
    if unix && !named("DISPLAY") && !named("WAYLAND_DISPLAY") {
        return Err("no display here (neither DISPLAY nor WAYLAND_DISPLAY is set)".into());
    }
    let (width, height) = extent(size, aspect, desktop::screen());
    let options =
        WindowOptions { resize: true, scale_mode: ScaleMode::UpperLeft, ..WindowOptions::default() };
    let window = Window::new("rta", width, height, options);
    let mut window = window.map_err(|error| format!("no window to be had ({error})"))?;
    window.set_target_fps(RATE);
    Ok(window)
}

/// Returns width and height of the window for a picture: never larger than the screen.
fn extent(size: Size, aspect: f64, screen: Option<(usize, usize)>) -> (usize, usize) {
    // Title bar, borders and panels take up to a tenth of the screen.
    let room = screen.map_or(ROOM, |(width, height)| (width - width / 10, height - height / 10));
    let most = (ENLARGED.0.max(size.columns()), ENLARGED.1.max(size.height() as usize));
    let place = Place::new(size, aspect, most.0.min(room.0), most.1.min(room.1));
    (place.width.max(SMALLEST.0.min(room.0)), place.height.max(SMALLEST.1.min(room.1)))
}

/// Shows the picture until the window is closed.
fn run_in(mut window: Window, mut show: Show, stop: &AtomicBool) -> Result<(), Error> {
    let (sender, presses) = mpsc::channel();
    window.set_input_callback(Box::new(Keyboard(sender)));
    let mut desktop = Desktop::of(&window);
    let mut wishes = Wishes { help: true, palette: false, probe: true, welcome: Some(Instant::now()) };
    let mut drawn = Drawn::default();
    while window.is_open() {
        if stop.load(Ordering::Relaxed) {
            return Err(BandsError::Interrupted.into());
        }
        for press in presses.try_iter() {
            wishes.greeted(press);
            match press {
                Press::Do(command) => show.obey(command),
                Press::Help => wishes.help = !wishes.help,
                Press::Palette => wishes.palette = !wishes.palette,
                Press::Probe => wishes.probe = !wishes.probe,
                Press::FullScreen => {
                    show.note(desktop.toggle_full_screen().err().map(|error| Note::error(error.to_string())));
                }
                Press::Leave => {
                    drop(window);
                    return leave(show, stop);
                }
            }
            // The next key may take the note's place.
            tell_news(&mut show)?;
            drawn.is_stale = true;
        }
        show.follow_file();
        drawn.is_stale |= show.advance(BUDGET)?;
        tell_news(&mut show)?;
        let overlay = wishes.overlay(&window, &show);
        drawn.draw(&mut window, &mut show, overlay)?;
    }
    drop(window);
    leave(show, stop)
}

/// Waits for a picture that is to be saved, if there is one. The window is closed already.
fn leave(mut show: Show, stop: &AtomicBool) -> Result<(), Error> {
    if show.is_saving() {
        tell(&Note::message("the picture is saved once it is complete; Ctrl-C leaves at once".into()))?;
    }
    while show.is_saving() {
        if stop.load(Ordering::Relaxed) {
            return Err(BandsError::Interrupted.into());
        }
        show.advance(BUDGET)?;
        std::thread::sleep(BUDGET);
    }
    tell_news(&mut show)
}

/// What the user wants to see over the picture.
struct Wishes {
    help: bool,
    palette: bool,
    probe: bool,
    /// When the help came by itself.
    welcome: Option<Instant>,
}

impl Wishes {
    /// Any key but that of the help ends the help that came by itself.
    fn greeted(&mut self, press: Press) {
        if self.welcome.take().is_some() && press != Press::Help {
            self.help = false;
        }
    }

    /// Returns what is to be seen over the picture now.
    fn overlay(&mut self, window: &Window, show: &Show) -> Overlay {
        if self.welcome.is_some_and(|since| since.elapsed() > WELCOME) {
            (self.welcome, self.help) = (None, false);
        }
        let (width, height) = window.get_size();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the window")]
        let place = window.get_mouse_pos(MouseMode::Discard).map(|(x, y)| (x as usize, y as usize));
        let pixel = place.filter(|_| self.probe).and_then(|(x, y)| show.place(width, height).pixel(x, y));
        Overlay { help: self.help, palette: self.palette, pixel, note: show.visible_note().map(String::from) }
    }
}

/// What is in the window, and how long it took to draw it.
#[derive(Default)]
struct Drawn {
    frame: Frame,
    title: String,
    overlay: Overlay,
    /// Whether the picture has changed since.
    is_stale: bool,
    /// When the frame was drawn, and how long that took.
    at: Option<Instant>,
    cost: Duration,
    /// When the window was given the frame.
    given: Option<Instant>,
}

impl Drawn {
    /// Draws the window anew where that is due. A picture that fills in is drawn so often that three quarters of the time are left
    /// to the threads that trace it; what the user asks for and frames of a film that are there already are drawn at once.
    fn draw(&mut self, window: &mut Window, show: &mut Show, overlay: Overlay) -> Result<(), Error> {
        if self.title != show.title() {
            self.title = show.title();
            window.set_title(&self.title);
        }
        let (width, height) = window.get_size();
        let is_new = overlay != self.overlay || (width, height) != (self.frame.width, self.frame.height);
        let since = |at: Option<Instant>| at.map_or(Duration::MAX, |at| at.elapsed());
        let pause = if show.film().is_tracing() { 3 * self.cost } else { Duration::ZERO };
        let is_due = is_new || (self.is_stale && since(self.at) >= pause);
        if is_due {
            let begin = Instant::now();
            self.frame = overlay::draw(show, &overlay, width, height)?;
            (self.overlay, self.is_stale) = (overlay, false);
            (self.at, self.cost) = (Some(Instant::now()), begin.elapsed());
        }
        if (is_due || since(self.given) > REFRESH) && width > 0 && height > 0 {
            self.given = Some(Instant::now());
            // What a window refuses once it may take the next time; closing it ends the loop.
            let _ = window.update_with_buffer(&self.frame.pixels, width, height);
        } else {
            window.update();
        }
        Ok(())
    }
}

/// Tells what has not been told yet.
fn tell_news(show: &mut Show) -> Result<(), Error> {
    show.news().map_or(Ok(()), |news| tell(&news))
}

/// Tells a message on standard output, and an error on standard error.
fn tell(note: &Note) -> Result<(), Error> {
    if note.is_error() {
        // If that is closed too there is nobody left to tell.
        let _ = writeln!(io::stderr(), "rta: error: {}", note.text());
        return Ok(());
    }
    say(note.text())
}

/// Writes a line to standard output.
fn say(line: &str) -> Result<(), Error> {
    Ok(output::print(&format!("{line}\n"), Inputs::NONE)?)
}

#[cfg(test)]
mod tests {
    use super::extent;

    #[test]
    fn windows_have_room_on_the_screen() {
        for (size, aspect, screen, want) in [
            ("320x200", 4.0 / 3.0, None, (960, 720)),
            ("320x200", 4.0 / 3.0, Some((1280, 1000)), (960, 720)),
            ("320x200", 4.0 / 3.0, Some((800, 600)), (640, 480)),
            ("1152x900", 1.28, Some((1920, 1080)), (1152, 900)),
            ("1024x1024", 1.0, Some((1280, 1000)), (900, 900)),
            ("4000x3000", 4.0 / 3.0, Some((1280, 1000)), (1152, 864)),
            ("4000x3000", 4.0 / 3.0, Some((3840, 2160)), (2592, 1944)),
            ("8x8", 1.0, Some((1280, 1000)), (896, 896)),
            ("1x100", 0.01, Some((1280, 1000)), (640, 900)),
            ("8x8", 1.0, Some((320, 240)), (288, 216)),
        ] {
            let size = size.parse().expect("a size");
            assert_eq!(extent(size, aspect, screen), want, "{size} on {screen:?}");
        }
    }
}
