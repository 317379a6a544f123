//! The palette view: every entry of the device's colour table, and how many of them the picture uses.

use rta_core::color::Rgb;

use crate::picture::file::{Displayed, Pixels};
use crate::picture::frame::{Frame, packed};
use crate::picture::text::{Anchor, Letters};

/// Entries side by side.
const COLUMNS: usize = 16;
/// The frame around the entry of the pixel under the mouse.
const MARK: u32 = 0xff_ff_ff;
/// What is drawn across entries that no pixel uses.
const UNUSED: u32 = 0x80_80_80;
/// The greatest size of an entry, in pixels of the window.
const LARGEST: usize = 22;

/// Draws the palette of `picture` into the upper right corner of the window, with a mark around the entry `marked`.
///
/// The entries are in the order of their indices, sixteen in a row. One that no pixel uses is crossed out; the places of a
/// table that has fewer entries than the device has colours stay empty.
pub fn draw(frame: &mut Frame, picture: &Displayed, colors: usize, marked: Option<u8>) {
    let (lines, palette, used) = match &picture.pixels {
        Pixels::Direct(pixels) => (vec!["no colour table".into(), distinct(pixels)], &[][..], [false; 256]),
        Pixels::Indexed { palette, indices } => {
            let mut used = [false; 256];
            for index in indices {
                if let Some(used) = used.get_mut(usize::from(*index)) {
                    *used = true;
                }
            }
            let count = used.iter().filter(|used| **used).count();
            let words = format!("{} of {colors} entries, {count} used", palette.len());
            (vec![words], &palette[..], used)
        }
    };
    let words = lines.iter().map(|line| line.chars().count()).max().unwrap_or(0);
    let rows = palette.len().div_ceil(COLUMNS);
    let side = (frame.width.min(frame.height) / (2 * COLUMNS)).clamp(4, LARGEST);
    let Some(letters) = Letters::fitting(words, lines.len() + 12, frame.width, frame.height) else { return };
    let across = if palette.is_empty() { 0 } else { COLUMNS * side };
    let (columns, below) = letters.boxed(frame, &lines, (across, rows * side), Anchor::TopRight);
    let left = columns.start + columns.len().saturating_sub(COLUMNS * side) / 2;
    for ((index, color), used) in (0..).zip(palette).zip(used) {
        let (x, y) = (left + index % COLUMNS * side, below.start + index / COLUMNS * side);
        if marked.map(usize::from) == Some(index) {
            frame.blend(x..x + side, y..y + side, MARK, 255);
        }
        // A gap of two pixels keeps neighbours apart and has room for the mark.
        frame.blend(x + 1..x + side - 1, y + 1..y + side - 1, packed(*color), 255);
        if !used {
            for step in 1..side - 1 {
                frame.blend(x + step..x + step + 1, y + step..y + step + 1, UNUSED, 255);
            }
        }
    }
}

/// Returns how many colours the pixels have.
fn distinct(pixels: &[Rgb<u8>]) -> String {
    let mut seen = vec![0_u64; 1 << 18];
    for pixel in pixels {
        let color = packed(*pixel);
        if let Some(word) = seen.get_mut(color as usize / 64) {
            *word |= 1 << (color % 64);
        }
    }
    let count: u32 = seen.into_iter().map(u64::count_ones).sum();
    format!("{count} colours used")
}

#[cfg(test)]
mod tests {
    use rta_core::color::Rgb;

    use super::{distinct, draw};
    use crate::picture::file::{Displayed, Pixels};
    use crate::picture::frame::Frame;
    use crate::picture::raster::Size;

    #[test]
    fn colours_are_counted_once() {
        let colors = [(0, 0, 0), (255, 255, 255), (0, 0, 1), (0, 0, 0), (255, 255, 255)];
        let pixels = colors.map(|(r, g, b)| Rgb::new(r, g, b));
        assert_eq!(distinct(&pixels), "3 colours used");
    }

    #[test]
    fn every_entry_is_drawn_and_the_one_of_the_mouse_is_marked() {
        let palette: Vec<_> = (0..40).map(|level| Rgb::new(level, 255 - level, 7)).collect();
        let indices = vec![0, 1, 39, 39];
        let pixels = Pixels::Indexed { palette: palette.clone(), indices };
        let picture = Displayed { size: Size::new(4, 1).expect("small"), aspect: 4.0, pixels };
        let empty = || Frame { width: 640, height: 480, pixels: vec![0; 640 * 480] };
        let (mut plain, mut marked) = (empty(), empty());
        draw(&mut plain, &picture, 256, None);
        draw(&mut marked, &picture, 256, Some(39));
        for color in palette {
            let color = super::packed(color);
            let count = plain.pixels.iter().filter(|pixel| **pixel == color).count();
            // Those that no pixel uses are crossed out by a line from corner to corner.
            assert!([13 * 13, 13 * 13 - 13].contains(&count), "{color:06x}: {count} pixels");
        }
        let changed = plain.pixels.iter().zip(&marked.pixels).filter(|(a, b)| a != b);
        assert!(changed.clone().all(|(_, marked)| *marked == super::MARK));
        assert_eq!(changed.count(), 4 * (15 - 1), "an outline of 15 x 15");
    }
}
