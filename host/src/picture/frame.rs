//! A picture scaled to a window, in the shape of its screen.

use core::ops::Range;

use rta_core::color::Rgb;

use crate::picture::raster::Size;

/// The pixels of a window, each 0RGB with 8 bits a register, as minifb takes them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Frame {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Row by row from the top.
    pub pixels: Vec<u32>,
}

/// The rectangle of a window that a picture fills.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    size: Size,
    /// Columns of the window to the left of the picture.
    pub left: usize,
    /// Rows of the window above it.
    pub top: usize,
    /// Columns that the picture fills.
    pub width: usize,
    /// Rows that it fills.
    pub height: usize,
}

/// Returns the largest rectangle of shape `aspect` within `width` x `height`, at least one pixel each way.
fn fit(aspect: f64, width: usize, height: usize) -> (usize, usize) {
    let (full_width, full_height) = (real(width), real(height));
    if full_width > full_height * aspect {
        (whole(full_height * aspect), height.max(1))
    } else {
        (width.max(1), whole(full_width / aspect))
    }
}

#[expect(clippy::cast_precision_loss, reason = "windows have far fewer than 2^53 pixels")]
const fn real(pixels: usize) -> f64 {
    pixels as f64
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "rounded values within the window"
)]
fn whole(pixels: f64) -> usize {
    pixels.round().max(1.0) as usize
}

impl Place {
    /// Places a picture of `size` pixels that fills a screen of shape `aspect` in the middle of a window of `width` x `height`, as
    /// large as it fits.
    ///
    /// A picture that is enlarged is enlarged by a whole number along the shorter side of its pixels, and along the other one as
    /// the shape of the screen demands: all columns of mode 13h are three pixels wide, and its rows three or four high. A
    /// picture that is reduced fills the window.
    #[must_use]
    pub fn new(size: Size, aspect: f64, width: usize, height: usize) -> Self {
        let (mut across, mut down) = fit(aspect, width, height);
        let (columns, rows) = (size.columns(), size.height() as usize);
        if across >= columns && down >= rows {
            // The shape is a rounded number, so that a whole number may come out a little less.
            let times = |pixels: f64, of: usize| ((pixels / real(of) + 1e-9).floor()).max(1.0) * real(of);
            let (width, height) = (real(width), real(height));
            let fitted = if aspect <= size.ratio() {
                let across = times(width.min(height * aspect), columns);
                (across, across / aspect)
            } else {
                let down = times(height.min(width / aspect), rows);
                (down * aspect, down)
            };
            (across, down) = (whole(fitted.0), whole(fitted.1));
        }
        let (across, down) = (across.min(width), down.min(height));
        let (left, top) = ((width - across) / 2, (height - down) / 2);
        Self { size, left, top, width: across, height: down }
    }

    /// Returns column and row of the picture's pixel at the place `x`, `y` of the window, if there is one; of those that share
    /// the place the first.
    #[must_use]
    pub fn pixel(&self, x: usize, y: usize) -> Option<(u32, u32)> {
        let within = |at: usize, from: usize, length: usize, pixels: u32| {
            let at = at.checked_sub(from).filter(|at| *at < length)?;
            u32::try_from(at * pixels as usize / length).ok()
        };
        let column = within(x, self.left, self.width, self.size.width())?;
        Some((column, within(y, self.top, self.height, self.size.height())?))
    }

    /// Returns the rectangle of the window that a pixel of the picture fills: columns and rows, empty if it shares its place.
    #[must_use]
    pub fn area(&self, x: u32, y: u32) -> (Range<usize>, Range<usize>) {
        let along = |at: u32, from: usize, length: usize, pixels: u32| {
            let start = |at: usize| from + (at * length).div_ceil(pixels as usize);
            start(at as usize)..start(at as usize + 1)
        };
        let columns = along(x, self.left, self.width, self.size.width());
        (columns, along(y, self.top, self.height, self.size.height()))
    }
}

impl Frame {
    /// Draws a picture at `place` in a window of `width` x `height`, black around it. `color` is the colour of the pixel in a
    /// column of a row.
    ///
    /// Where several pixels share one of the window, their colours are averaged, so that no row or column goes missing.
    #[must_use]
    pub fn new(place: Place, width: usize, height: usize, color: impl Fn(usize, usize) -> Rgb<u8>) -> Self {
        let columns = spans(place.size.columns(), place.width);
        let rows = spans(place.size.height() as usize, place.height);
        let mut pixels = vec![0; width * height];
        let lines = pixels.chunks_mut(width.max(1)).skip(place.top);
        let mut done: Option<(Range<usize>, Vec<u32>)> = None;
        for (line, rows) in lines.zip(rows) {
            let scaled = match done.take() {
                Some((same, scaled)) if same == rows => scaled,
                _ => columns.iter().map(|columns| average(&color, columns, &rows)).collect(),
            };
            for (pixel, color) in line.iter_mut().skip(place.left).zip(&scaled) {
                *pixel = *color;
            }
            done = Some((rows, scaled));
        }
        Self { width, height, pixels }
    }

    /// Fills the part of a rectangle that lies in the window, mixing the colours that are there with `color`, of which `part` of
    /// 255 is used.
    pub fn blend(&mut self, columns: Range<usize>, rows: Range<usize>, color: u32, part: u8) {
        let (start, end) = (columns.start.min(self.width), columns.end.min(self.width));
        let lines = self.pixels.chunks_mut(self.width.max(1));
        for line in lines.take(rows.end).skip(rows.start) {
            for pixel in line.get_mut(start..end).unwrap_or_default() {
                *pixel = mix(*pixel, color, part);
            }
        }
    }
}

fn mix(below: u32, above: u32, part: u8) -> u32 {
    let part = u32::from(part);
    let register = |shift: u32| {
        let (below, above) = (below >> shift & 255, above >> shift & 255);
        ((below * (255 - part) + above * part + 127) / 255) << shift
    };
    register(16) | register(8) | register(0)
}

/// Returns which of `from` source pixels fall on each of `to` pixels of the window: at least one on each.
fn spans(from: usize, to: usize) -> Vec<Range<usize>> {
    let start = |place: usize| place * from / to.max(1);
    (0..to).map(|place| start(place)..start(place + 1).max(start(place) + 1)).collect()
}

fn average(color: impl Fn(usize, usize) -> Rgb<u8>, columns: &Range<usize>, rows: &Range<usize>) -> u32 {
    let (mut sum, mut count) = (Rgb::new(0_u64, 0, 0), 0);
    for y in rows.clone() {
        for x in columns.clone() {
            let Rgb { r, g, b } = color(x, y).map(u64::from);
            sum = Rgb::new(sum.r + r, sum.g + g, sum.b + b);
            count += 1;
        }
    }
    let mean = sum.map(|total| u8::try_from((total + count / 2) / count.max(1)).unwrap_or(u8::MAX));
    packed(mean)
}

/// Returns a colour as a pixel of a window.
#[must_use]
pub fn packed(color: Rgb<u8>) -> u32 {
    u32::from(color.r) << 16 | u32::from(color.g) << 8 | u32::from(color.b)
}

#[cfg(test)]
mod tests {
    use rta_core::color::Rgb;

    use super::{Frame, Place, fit, spans};
    use crate::picture::raster::Size;

    #[test]
    fn screens_fit_windows_in_their_shape() {
        assert_eq!(fit(4.0 / 3.0, 960, 720), (960, 720));
        assert_eq!(fit(4.0 / 3.0, 1000, 720), (960, 720));
        assert_eq!(fit(1.0, 960, 720), (720, 720));
        assert_eq!(fit(1.28, 960, 960), (960, 750));
        assert_eq!(fit(100.0, 10, 10), (10, 1));
    }

    #[test]
    fn pictures_are_enlarged_by_whole_numbers_and_keep_the_shape_of_their_screen() {
        for (size, aspect, window, want) in [
            ("320x200", 4.0 / 3.0, (960, 720), (0, 0, 960, 720)),
            ("320x200", 4.0 / 3.0, (1000, 760), (20, 20, 960, 720)),
            ("320x200", 4.0 / 3.0, (1600, 1200), (0, 0, 1600, 1200)),
            ("320x200", 4.0 / 3.0, (1920, 1080), (320, 60, 1280, 960)),
            ("320x200", 4.0 / 3.0, (300, 300), (0, 37, 300, 225)),
            ("1152x900", 1.28, (1200, 1000), (24, 50, 1152, 900)),
            ("1152x900", 1.28, (1000, 1000), (0, 109, 1000, 781)),
            ("8x8", 1.0, (640, 485), (80, 2, 480, 480)),
            ("8x8", 2.0, (640, 485), (0, 82, 640, 320)),
            ("4000x3000", 4.0 / 3.0, (1000, 1000), (0, 125, 1000, 750)),
            ("1x100", 0.01, (640, 480), (318, 40, 4, 400)),
            ("3x3", 1.0, (1, 1), (0, 0, 1, 1)),
            ("3x3", 1.0, (0, 0), (0, 0, 0, 0)),
        ] {
            let size: Size = size.parse().expect("a size");
            let place = Place::new(size, aspect, window.0, window.1);
            assert_eq!(
                (place.left, place.top, place.width, place.height),
                want,
                "{size} {aspect} {window:?}"
            );
        }
    }

    #[test]
    fn places_of_the_window_are_pixels_of_the_picture() {
        let place = Place::new(Size::new(320, 200).expect("small"), 4.0 / 3.0, 1000, 760);
        assert_eq!(place.pixel(20, 20), Some((0, 0)));
        assert_eq!(place.pixel(979, 739), Some((319, 199)));
        for outside in [(19, 20), (20, 19), (980, 20), (20, 740)] {
            assert_eq!(place.pixel(outside.0, outside.1), None);
        }
        for (x, y) in [(0, 0), (160, 100), (319, 199), (7, 13)] {
            let (columns, rows) = place.area(x, y);
            assert_eq!(columns.len(), 3);
            assert!((3..=4).contains(&rows.len()));
            for (column, row) in [(columns.start, rows.start), (columns.end - 1, rows.end - 1)] {
                assert_eq!(place.pixel(column, row), Some((x, y)));
            }
        }
    }

    #[test]
    fn every_source_pixel_falls_somewhere() {
        for (from, to) in [(200, 720), (1024, 720), (1, 5), (5, 1), (7, 7)] {
            let spans = spans(from, to);
            assert_eq!(spans.len(), to);
            for source in 0..from {
                assert!(spans.iter().any(|span| span.contains(&source)), "{from} to {to}: {source}");
            }
        }
    }

    #[test]
    fn pixels_are_enlarged_averaged_and_centred() {
        let color = |x: usize, _| if x == 0 { Rgb::new(255, 0, 0) } else { Rgb::new(0, 0, 100) };
        let size = Size::new(2, 1).expect("small");
        let frame = Frame::new(Place::new(size, 2.0, 4, 4), 4, 4, color);
        let row = [0xff_0000, 0xff_0000, 0x64, 0x64];
        assert_eq!(frame.pixels, [[0; 4], row, row, [0; 4]].concat());
        let small = Frame::new(Place::new(size, 1.0, 1, 1), 1, 1, color);
        assert_eq!(small.pixels, [0x80_0032]);
    }

    #[test]
    fn what_lies_outside_of_the_window_is_not_drawn() {
        let mut frame = Frame { width: 2, height: 2, pixels: vec![0xff; 4] };
        frame.blend(1..9, 1..9, 0xff_0000, 255);
        assert_eq!(frame.pixels, [0xff, 0xff, 0xff, 0xff_0000]);
        frame.blend(5..9, 0..1, 0xff_0000, 255);
        frame.blend(0..1, 0..1, 0xff_0000, 51);
        assert_eq!(frame.pixels, [0x33_00cc, 0xff, 0xff, 0xff_0000]);
    }
}
