//! Text over a picture: lines of letters of one width, in a dark box that lets the picture shine through.

use core::ops::Range;

use ab_glyph::{Font, FontRef, PxScale, ScaleFont};

use super::frame::Frame;

/// Letters are this high where there is room, in pixels.
const TALL: f32 = 18.0;
/// Letters that are smaller cannot be read.
const SMALL: f32 = 7.0;
/// Height of a line over the height of letters.
const LEADING: f32 = 1.25;
/// The colour of letters: a warm white.
const INK: u32 = 0xff_f8_e8;
/// The colour of boxes.
const BOX: u32 = 0x10_10_18;
/// The part of a box's colour that is used, of 255.
const OPACITY: u8 = 216;

/// Where a box lies in the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// In the middle.
    Middle,
    /// In the middle of the upper edge.
    Top,
    /// In the lower left corner.
    BottomLeft,
    /// In the upper left corner.
    TopLeft,
    /// In the upper right corner.
    TopRight,
}

/// Letters of one size.
#[derive(Clone, Debug)]
pub struct Letters {
    font: FontRef<'static>,
    scale: PxScale,
    /// Distance of two letters, in pixels.
    advance: f32,
    /// Distance of two lines, in pixels.
    line: f32,
}

impl Letters {
    /// Returns letters so large that `lines` of up to `columns` letters fit a window of `width` x `height`, as far as they
    /// can still be read. None if the font, which is part of the program, is damaged.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "windows and texts are far smaller than 2^24")]
    pub fn fitting(columns: usize, lines: usize, width: usize, height: usize) -> Option<Self> {
        let font = FontRef::try_from_slice(epaint_default_fonts::HACK_REGULAR).ok()?;
        let wide = font.as_scaled(PxScale::from(1.0)).h_advance(font.glyph_id('0'));
        // The box is two letters wider and a line higher than its text.
        let across = width as f32 / ((columns + 2) as f32 * wide);
        let down = height as f32 / ((lines + 1) as f32 * LEADING);
        let size = across.min(down).clamp(SMALL, TALL).floor();
        let scale = PxScale::from(size);
        let advance = font.as_scaled(scale).h_advance(font.glyph_id('0'));
        Some(Self { font, scale, advance, line: (size * LEADING).round() })
    }

    /// Returns the distance of two lines, in pixels.
    #[must_use]
    pub fn line(&self) -> usize {
        whole(self.line)
    }

    /// Draws a box with `lines` of text and, below them, room for something of `across` x `down` pixels. Returns the columns and rows of
    /// the window that this room takes; it may be wider.
    pub fn boxed(
        &self,
        frame: &mut Frame,
        lines: &[String],
        (across, down): (usize, usize),
        anchor: Anchor,
    ) -> (Range<usize>, Range<usize>) {
        let longest = lines.iter().map(|line| line.chars().count()).max().unwrap_or(0);
        let margin = whole(self.line / 2.0);
        let width = whole(self.letters(longest)).max(across) + 2 * margin;
        let height = lines.len() * self.line() + down + 2 * margin;
        let (right, bottom) = (frame.width.saturating_sub(width), frame.height.saturating_sub(height));
        let (left, top) = match anchor {
            Anchor::Middle => (right / 2, bottom / 2),
            Anchor::Top => (right / 2, 0),
            Anchor::BottomLeft => (0, bottom),
            Anchor::TopLeft => (0, 0),
            Anchor::TopRight => (right, 0),
        };
        frame.blend(left..left + width, top..top + height, BOX, OPACITY);
        for (line, number) in lines.iter().zip(0..) {
            self.write(frame, line, left + margin, top + margin + number * self.line());
        }
        let below = top + margin + lines.len() * self.line();
        (left + margin..left + width - margin, below..below + down)
    }

    #[expect(clippy::cast_precision_loss, reason = "lines have far fewer than 2^24 letters")]
    fn letters(&self, count: usize) -> f32 {
        self.advance * count as f32
    }

    /// Writes one line whose upper left corner is at `left`, `top`.
    #[expect(clippy::cast_precision_loss, reason = "windows have far fewer than 2^24 columns")]
    fn write(&self, frame: &mut Frame, line: &str, left: usize, top: usize) {
        let font = self.font.as_scaled(self.scale);
        for (letter, number) in line.chars().zip(0..) {
            let mut glyph = font.scaled_glyph(letter);
            // On whole pixels letters are sharper.
            let x = left as f32 + self.letters(number).round();
            glyph.position = ab_glyph::point(x, top as f32 + font.ascent().round());
            let Some(outline) = font.outline_glyph(glyph) else { continue };
            let bounds = outline.px_bounds();
            let (left, top) = (whole(bounds.min.x), whole(bounds.min.y));
            outline.draw(|x, y, coverage| {
                let (x, y) = (left + x as usize, top + y as usize);
                frame.blend(x..x + 1, y..y + 1, INK, part(coverage));
            });
        }
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place in a window")]
const fn whole(pixels: f32) -> usize {
    pixels.max(0.0).round() as usize
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
const fn part(coverage: f32) -> u8 {
    (coverage.clamp(0.0, 1.0) * 255.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::{Anchor, Letters, OPACITY, SMALL, TALL};
    use crate::picture::frame::Frame;

    fn frame(width: usize, height: usize) -> Frame {
        Frame { width, height, pixels: vec![0xff_ffff; width * height] }
    }

    #[test]
    fn letters_are_as_large_as_they_fit() {
        for (columns, lines, width, height, size) in [
            (40, 12, 960, 720, TALL),
            (40, 12, 320, 240, 14.0),
            (10, 20, 960, 210, 8.0),
            (40, 12, 20, 20, SMALL),
            (0, 0, 0, 0, SMALL),
        ] {
            let letters = Letters::fitting(columns, lines, width, height).expect("the font is sound");
            assert!((letters.scale.y - size).abs() < 0.5, "{width}x{height}: {:?}", letters.scale);
        }
    }

    #[test]
    fn a_box_is_dark_where_its_anchor_says_and_its_text_is_light() {
        for (anchor, corners) in [
            (Anchor::TopLeft, [true, false, false, false]),
            (Anchor::TopRight, [false, true, false, false]),
            (Anchor::BottomLeft, [false, false, true, false]),
            (Anchor::Middle, [false; 4]),
            (Anchor::Top, [false; 4]),
        ] {
            let letters = Letters::fitting(20, 4, 400, 300).expect("the font is sound");
            let mut frame = frame(400, 300);
            let (columns, rows) = letters.boxed(&mut frame, &["Mode 13h".into()], (0, 10), anchor);
            assert_eq!(rows.len(), 10);
            let pixel = |x: usize, y: usize| frame.pixels.get(y * 400 + x).copied().expect("inside");
            let dark = [(0, 0), (399, 0), (0, 299), (399, 299)].map(|(x, y)| pixel(x, y) != 0xff_ffff);
            assert_eq!(dark, corners, "{anchor:?}");
            let text = rows.start - letters.line()..rows.start;
            let ink = text.flat_map(|y| columns.clone().map(move |x| (x, y)));
            let light = ink.filter(|(x, y)| pixel(*x, *y) & 255 > 200).count();
            assert!((100..1500).contains(&light), "{light} pixels of ink");
        }
        const { assert!(OPACITY < 255, "the picture shines through") };
    }

    #[test]
    fn a_window_that_is_too_small_cuts_the_text() {
        for (width, height) in [(0, 0), (1, 1), (5, 400), (400, 5)] {
            let letters = Letters::fitting(20, 4, width, height).expect("the font is sound");
            let mut frame = frame(width, height);
            for anchor in [Anchor::Middle, Anchor::TopRight, Anchor::BottomLeft] {
                letters.boxed(&mut frame, &["Mode 13h \u{3b1}\u{1f980}".into()], (30, 10), anchor);
            }
            assert_eq!(frame.pixels.len(), width * height);
        }
    }
}
