//! The keys of the window.

use std::sync::mpsc::Sender;

use minifb::{InputCallback, Key};

use super::Command;

/// The keys, as they are told in the window: the first ten letters of each line are keys.
pub const KEYS: &str = "\
D         next device: vga, graphigs, pixrect, none
M         next illumination model
F         next number format
T         next colour table: sampled, baked, frame, tolerant, adaptive, uniform
X         next dithering: none, fs, fs7351, bayer
+ -       more or fewer reflections (also up and down)
R         read the scene file again (a change does so by itself)
S         save as a PNG once the picture is complete
Space     pause the film, or go on
, .       the film's frame before or after (also left and right)
P         palette: the device's colour table
I         tell the pixel under the mouse, or not
F11       full screen
H F1 ?    these keys
Esc Q     leave";

/// The meaning of a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Press {
    /// Something about the picture.
    Do(Command),
    /// The help comes or goes.
    Help,
    /// The palette comes or goes.
    Palette,
    /// The pixel under the mouse is told, or not.
    Probe,
    /// The window fills the screen, or no longer.
    FullScreen,
    /// The window is closed.
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
            'x' => Self::Do(Command::Dither),
            // The key of + without the shift, on most keyboards.
            '+' | '=' => Self::Do(Command::Deeper),
            '-' => Self::Do(Command::Shallower),
            'r' => Self::Do(Command::Reload),
            's' => Self::Do(Command::Save),
            ' ' => Self::Do(Command::Pause),
            ',' => Self::Do(Command::Previous),
            '.' => Self::Do(Command::Next),
            'p' => Self::Palette,
            'i' => Self::Probe,
            'h' | '?' => Self::Help,
            'q' => Self::Leave,
            _ => return None,
        })
    }

    /// Returns the meaning of a key that types no character.
    const fn of_key(key: Key) -> Option<Self> {
        match key {
            Key::Up => Some(Self::Do(Command::Deeper)),
            Key::Down => Some(Self::Do(Command::Shallower)),
            Key::Left => Some(Self::Do(Command::Previous)),
            Key::Right => Some(Self::Do(Command::Next)),
            Key::F1 => Some(Self::Help),
            Key::F11 => Some(Self::FullScreen),
            Key::Escape => Some(Self::Leave),
            _ => None,
        }
    }
}

/// Sends each key press as it happens. Asking once a frame which keys are down would miss the short ones.
#[derive(Debug)]
pub struct Keyboard(pub Sender<Press>);

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
                    "F11" => Press::of_key(Key::F11),
                    "Esc" => Press::of_key(Key::Escape),
                    "Space" => Press::of_char(' '),
                    key => key.chars().next().and_then(Press::of_char),
                };
                assert!(known.is_some(), "{key}");
            }
        }
    }
}
