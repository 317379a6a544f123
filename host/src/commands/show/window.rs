//! The window of `rta show`, and what it does where there is none.

use core::sync::atomic::{AtomicBool, Ordering};
use core::time::Duration;
use std::sync::mpsc::{self, Sender};
use std::time::Instant;

use minifb::{InputCallback, Key, ScaleMode, Window, WindowOptions};

use crate::args::ShowArgs;
use crate::commands::render::Work;
use crate::commands::show::frame::{Frame, fit};
use crate::commands::show::{Command, Show};
use crate::engine::bands::BandsError;
use crate::engine::interrupt;
use crate::error::Error;
use crate::picture::device::{Device, Target};
use crate::picture::error::PictureError;
use crate::picture::output;
use crate::request::scene_file::SceneFile;

/// The keys, for the terminal.
pub const KEYS: &str = "\
D         next device: vga, graphigs, pixrect
M         next illumination model
F         next number format
T         next colour table: adaptive, tolerant, uniform
+ -       more or fewer reflections (also up and down)
R         trace again
S         save what the device shows as a PNG in the current folder
H  F1     these keys
Esc  Q    leave";

/// Frames a second.
const RATE: usize = 60;

/// Time of a frame that may be spent on drawing on the device; the rest is for the window.
const BUDGET: Duration = Duration::from_millis(8);

/// The window is drawn at least this often even if nothing has changed, since it may have been covered.
const REFRESH: Duration = Duration::from_millis(100);

/// Runs `rta show`.
///
/// # Errors
/// All of [`Error`] that concern a scene, a device or a file in the current folder.
pub fn run(args: &ShowArgs) -> Result<(), Error> {
    let target = Target::On(args.device);
    args.tracing.request(target).raster()?;
    let scene = match &args.scene {
        Some(path) => SceneFile::open_as(path, args.tracing.reading.into())?,
        None => SceneFile::juggler()?,
    };
    let request = args.tracing.request_for(target, &scene)?;
    let stop = interrupt::watch();
    if let Some(window) = open(args.device) {
        let show = Show::new(scene, args.device, request, args.tracing.threads)?;
        return watch(window, show, stop);
    }
    let work = Work::new(&request, &scene, args.tracing.threads, stop)?;
    let mut content = Vec::new();
    let stem = format!("rta-{}-{}", scene.title, args.device);
    let encoded = work.displayed()?.write_png(&request.caption(&scene), &mut content);
    encoded.map_err(|source| PictureError::write(stem.as_ref(), source))?;
    let name = output::write_new(&stem, &content)?;
    say(&format!("rta: no display here, so the picture is in ./{}", name.display()))
}

/// Opens a window for the screen of `device`; none if there is no display.
fn open(device: Device) -> Option<Window> {
    let named = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    let unix = cfg!(all(unix, not(target_os = "macos")));
    if unix && !named("DISPLAY") && !named("WAYLAND_DISPLAY") {
        return None;
    }
    // Mode 13h three times as wide; the large rasters as they are where most screens have room for them.
    let (width, height) = match device {
        Device::Vga => fit(device.aspect(), 960, 720),
        Device::Graphigs | Device::Pixrect => fit(device.aspect(), 1152, 900),
    };
    let options =
        WindowOptions { resize: true, scale_mode: ScaleMode::UpperLeft, ..WindowOptions::default() };
    let mut window = Window::new("rta", width, height, options).ok()?;
    window.set_target_fps(RATE);
    Some(window)
}

/// Shows the picture until the window is closed.
fn watch(mut window: Window, mut show: Show, stop: &AtomicBool) -> Result<(), Error> {
    let (sender, presses) = mpsc::channel();
    window.set_input_callback(Box::new(Keyboard(sender)));
    let (mut title, mut drawn, mut stale) = (String::new(), Instant::now(), true);
    let mut frame = Frame { width: 0, height: 0, pixels: Vec::new() };
    while window.is_open() {
        if stop.load(Ordering::Relaxed) {
            return Err(BandsError::Interrupted.into());
        }
        for press in presses.try_iter() {
            match press {
                Press::Leave => return Ok(()),
                Press::Help => say(KEYS)?,
                Press::Do(command) => {
                    if let Some(name) = show.obey(command) {
                        say(&format!("saved {name}"))?;
                    }
                    stale = true;
                }
            }
        }
        stale |= show.advance(BUDGET)?;
        let (width, height) = window.get_size();
        stale |= (width, height) != (frame.width, frame.height);
        if stale {
            frame = Frame::new(&show.picture()?, width, height);
        }
        if title != show.title() {
            title = show.title();
            window.set_title(&title);
        }
        let due = stale || drawn.elapsed() > REFRESH;
        if due && width > 0 && height > 0 {
            (stale, drawn) = (false, Instant::now());
            // What a window refuses once it may take the next time; closing it ends the loop.
            let _ = window.update_with_buffer(&frame.pixels, width, height);
        } else {
            window.update();
        }
    }
    Ok(())
}

/// The meaning of a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Press {
    Do(Command),
    Help,
    Leave,
}

impl Press {
    /// Returns the meaning of a character, so that in every keyboard layout the key is the one that bears it.
    fn of_char(typed: char) -> Option<Self> {
        Some(match typed.to_ascii_lowercase() {
            'd' => Self::Do(Command::Device),
            'm' => Self::Do(Command::Model),
            'f' => Self::Do(Command::Format),
            't' => Self::Do(Command::Table),
            // The key of + without the shift, on most keyboards.
            '+' | '=' => Self::Do(Command::Deeper),
            '-' => Self::Do(Command::Shallower),
            'r' => Self::Do(Command::Restart),
            's' => Self::Do(Command::Save),
            'h' => Self::Help,
            'q' => Self::Leave,
            _ => return None,
        })
    }

    /// Returns the meaning of a key that types no character.
    const fn of_key(key: Key) -> Option<Self> {
        match key {
            Key::Up => Some(Self::Do(Command::Deeper)),
            Key::Down => Some(Self::Do(Command::Shallower)),
            Key::F1 => Some(Self::Help),
            Key::Escape => Some(Self::Leave),
            _ => None,
        }
    }
}

/// Sends each key press as it happens. Asking once a frame which keys are down would miss the short ones.
struct Keyboard(Sender<Press>);

impl Keyboard {
    fn send(&self, press: Option<Press>) {
        // Without a receiver the window is closing.
        let _ = press.map(|press| self.0.send(press));
    }
}

impl InputCallback for Keyboard {
    fn add_char(&mut self, typed: u32) {
        self.send(char::from_u32(typed).and_then(Press::of_char));
    }

    fn set_key_state(&mut self, key: Key, down: bool) {
        if down {
            self.send(Press::of_key(key));
        }
    }
}

/// Writes a line to standard output.
fn say(line: &str) -> Result<(), Error> {
    Ok(output::print(&format!("{line}\n"))?)
}

#[cfg(test)]
mod tests {
    use minifb::Key;

    use super::{KEYS, Press};

    #[test]
    fn every_key_that_is_told_does_something() {
        for line in KEYS.lines() {
            let keys = line.get(..10).expect("a column of keys");
            for key in keys.split_whitespace() {
                let known = match key {
                    "F1" => Press::of_key(Key::F1),
                    "Esc" => Press::of_key(Key::Escape),
                    key => key.chars().next().and_then(Press::of_char),
                };
                assert!(known.is_some(), "{key}");
            }
        }
    }
}
