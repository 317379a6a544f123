//! What is drawn over the picture: help, palette, the pixel under the mouse, and messages.

use super::keys::KEYS;
use super::{Show, palette};
use crate::error::Error;
use crate::picture::frame::{Frame, Place};
use crate::picture::text::{Anchor, Letters};

/// The frame around the pixel under the mouse.
const MARK: u32 = 0xff_ff_ff;

/// What is to be seen over the picture.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Overlay {
    /// Whether the keys are told.
    pub help: bool,
    /// Whether the palette is shown.
    pub palette: bool,
    /// Column and row of the pixel under the mouse, if it is told.
    pub pixel: Option<(u32, u32)>,
    /// A message.
    pub note: Option<String>,
}

/// Draws a window of `width` x `height`: the picture as far as it is there, and what lies over it.
///
/// # Errors
/// Those of reading the picture back from its device.
pub fn draw(show: &mut Show, overlay: &Overlay, width: usize, height: usize) -> Result<Frame, Error> {
    let (place, colors) = (show.place(width, height), show.colors());
    let shown = show.shown()?;
    let mut frame = Frame::new(place, width, height, |x, y| shown.color(x, y));
    if overlay.palette {
        let marked = overlay.pixel.and_then(|(x, y)| shown.index(x, y));
        palette::draw(&mut frame, shown.picture(), colors, marked);
    }
    if let Some(pixel) = overlay.pixel {
        let lines = show.describe(pixel.0, pixel.1);
        mark(&mut frame, &place, pixel);
        let (_, rows) = place.area(pixel.0, pixel.1);
        // Not over the pixel itself.
        let is_low = rows.end > height - height / 4;
        boxed(&mut frame, &lines, 10, if is_low { Anchor::TopLeft } else { Anchor::BottomLeft });
    }
    if overlay.help {
        let lines: Vec<_> = KEYS.lines().map(String::from).collect();
        boxed(&mut frame, &lines, lines.len(), Anchor::Middle);
    }
    if let Some(note) = &overlay.note {
        let lines = wrapped(note, 72);
        boxed(&mut frame, &lines, 10, Anchor::Top);
    }
    Ok(frame)
}

/// Draws a box with text as large as it fits the window, where `lines` lines would have to.
fn boxed(frame: &mut Frame, text: &[String], lines: usize, anchor: Anchor) {
    let longest = text.iter().map(|line| line.chars().count()).max().unwrap_or(0);
    let letters = Letters::fitting(longest, lines.max(text.len()), frame.width, frame.height);
    if let Some(letters) = letters {
        letters.boxed(frame, text, (0, 0), anchor);
    }
}

/// Draws the outline of a pixel that is enlarged so far that there is an inside.
fn mark(frame: &mut Frame, place: &Place, (x, y): (u32, u32)) {
    let (columns, rows) = place.area(x, y);
    if columns.len() < 3 || rows.len() < 3 {
        return;
    }
    for edge in [rows.start, rows.end - 1] {
        frame.blend(columns.clone(), edge..edge + 1, MARK, 255);
    }
    for edge in [columns.start, columns.end - 1] {
        frame.blend(edge..edge + 1, rows.start + 1..rows.end - 1, MARK, 255);
    }
}

/// Breaks a text into lines of at most `most` letters, between words where there are some.
fn wrapped(text: &str, most: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let letters: Vec<char> = word.chars().collect();
        for (part, number) in letters.chunks(most).zip(0..) {
            let Some(line) = lines.last_mut() else { continue };
            let length = line.chars().count();
            let is_first = length == 0;
            if is_first || (number == 0 && length + 1 + part.len() <= most) {
                line.extend((!is_first).then_some(' '));
                line.extend(part);
            } else {
                lines.push(part.iter().collect());
            }
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::wrapped;

    #[test]
    fn long_messages_are_broken_between_words() {
        assert_eq!(wrapped("saved it", 20), ["saved it"]);
        assert_eq!(wrapped("the sphere in line 12 is short", 12), ["the sphere", "in line 12", "is short"]);
        assert_eq!(wrapped("/a/very/long/name is missing", 8), ["/a/very/", "long/nam", "e is", "missing"]);
        assert_eq!(wrapped("", 8), [""]);
    }
}
