//! Contact sheets: pictures beside and below each other, each with its caption.

use rta_core::color::Rgb;

use super::error::StudyError;
use crate::picture::file::{Displayed, Pixels};
use crate::picture::frame::{Frame, Place};
use crate::picture::raster::Size;
use crate::picture::text::{Anchor, Letters};

/// A picture on the sheet is at most so wide. A smaller one is enlarged by a whole number as long as it fits, a larger one reduced.
const WIDTH: usize = 320;

/// Black columns to the right of each picture.
pub(super) const GAP: usize = 4;

/// Letters in a line of a caption, at most.
const LETTERS: usize = 28;

/// Returns a frame as a picture.
///
/// # Errors
/// [`StudyError::Sheet`] if it is too large for a picture file.
pub(super) fn displayed(sheet: &Frame) -> Result<Displayed, StudyError> {
    let side = |pixels: usize| u32::try_from(pixels).unwrap_or(u32::MAX);
    let size = Size::new(side(sheet.width), side(sheet.height))
        .map_err(|source| StudyError::Sheet(Box::new(source)))?;
    let pixels = sheet.pixels.iter().map(|pixel| unpacked(*pixel)).collect();
    Ok(Displayed { size, aspect: size.ratio(), pixels: Pixels::Direct(pixels) })
}

/// Returns a picture above its caption.
pub(super) fn cell((size, aspect): (Size, f64), pixels: &[Rgb<u8>], caption: &str) -> Frame {
    let columns = size.columns();
    let width = if columns > WIDTH { columns / columns.div_ceil(WIDTH) } else { columns * (WIDTH / columns) };
    let height = rows(width, aspect);
    let color = |x, y| pixels.get(y * columns + x).copied().unwrap_or_default();
    let picture = Frame::new(Place::new(size, aspect, width, height), width, height, color);
    stacked(&[picture, title(width, caption)])
}

/// Returns the rows of a picture of `width` columns and the shape `aspect`.
#[expect(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "at most 320 columns, and shapes of 0.01 to 100"
)]
fn rows(width: usize, aspect: f64) -> usize {
    (width as f64 / aspect).round().max(1.0) as usize
}

/// Returns a line of text on a dark ground.
pub(super) fn title(width: usize, words: &str) -> Frame {
    let letters = Letters::fitting(words.chars().count().max(LETTERS), 1, width, WIDTH);
    let height = letters.as_ref().map_or(0, |letters| 2 * letters.line());
    let mut frame = Frame { width, height, pixels: vec![0; width * height] };
    if let Some(letters) = letters {
        letters.boxed(&mut frame, &[words.to_owned()], (0, 0), Anchor::TopLeft);
    }
    frame
}

/// Returns frames one below the other, black to the right of narrow ones.
pub(super) fn stacked(frames: &[Frame]) -> Frame {
    let width = frames.iter().map(|frame| frame.width).max().unwrap_or(0);
    let mut pixels = Vec::new();
    for frame in frames {
        for row in frame.pixels.chunks(frame.width.max(1)) {
            pixels.extend_from_slice(row);
            pixels.resize(pixels.len() + width - row.len(), 0);
        }
    }
    Frame { width, height: frames.iter().map(|frame| frame.height).sum(), pixels }
}

/// Returns frames side by side, each with a gap after it, black below low ones.
pub(super) fn beside(frames: &[Frame]) -> Frame {
    let height = frames.iter().map(|frame| frame.height).max().unwrap_or(0);
    let mut pixels = Vec::new();
    for y in 0..height {
        for frame in frames {
            let row = pixels.len();
            pixels.extend(frame.pixels.iter().skip(y * frame.width).take(frame.width));
            pixels.resize(row + frame.width + GAP, 0);
        }
    }
    Frame { width: frames.iter().map(|frame| frame.width + GAP).sum(), height, pixels }
}

fn unpacked(pixel: u32) -> Rgb<u8> {
    let [_, r, g, b] = pixel.to_be_bytes();
    Rgb::new(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::{Frame, beside, rows, stacked};

    #[test]
    fn frames_lie_beside_and_below_each_other() {
        let frame = |width, height, color| Frame { width, height, pixels: vec![color; width * height] };
        let pair = beside(&[frame(1, 2, 1), frame(2, 2, 2)]);
        let row = [[1, 0, 0, 0, 0].as_slice(), &[2, 2, 0, 0, 0, 0]].concat();
        assert_eq!(pair, Frame { width: 11, height: 2, pixels: row.repeat(2) });
        let low = beside(&[frame(1, 1, 1), frame(2, 2, 2)]);
        let below = [[0; 5].as_slice(), &[2, 2, 0, 0, 0, 0]].concat();
        assert_eq!(low, Frame { width: 11, height: 2, pixels: [row.as_slice(), &below].concat() });
        let all = stacked(&[pair, frame(1, 1, 3)]);
        let last = [[3].as_slice(), &[0; 10]].concat();
        assert_eq!(all, Frame { width: 11, height: 3, pixels: [row.repeat(2), last].concat() });
    }

    #[test]
    fn pictures_keep_their_shape() {
        assert_eq!(
            [rows(320, 4.0 / 3.0), rows(256, 1.0), rows(288, 1.28), rows(1, 100.0)],
            [240, 256, 225, 1]
        );
    }
}
