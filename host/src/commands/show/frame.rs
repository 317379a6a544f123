//! A picture scaled to a window, in the shape of its screen.

use crate::picture::file::{Displayed, Pixels};

/// The pixels of a window, each 0RGB with 8 bits a register, as minifb takes them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Row by row from the top.
    pub pixels: Vec<u32>,
}

/// Returns the largest rectangle of shape `aspect` within `width` x `height`, at least one pixel each way.
#[must_use]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "rounded values within the window"
)]
#[expect(clippy::cast_precision_loss, reason = "windows have far fewer than 2^53 pixels")]
pub fn fit(aspect: f64, width: usize, height: usize) -> (usize, usize) {
    let (full_width, full_height) = (width as f64, height as f64);
    let fitted = if full_width > full_height * aspect {
        (full_height * aspect, full_height)
    } else {
        (full_width, full_width / aspect)
    };
    (fitted.0.round().max(1.0) as usize, fitted.1.round().max(1.0) as usize)
}

impl Frame {
    /// Draws `picture` as large as it fits a window of `width` x `height` and in its shape, black around it.
    ///
    /// Pixels are enlarged as squares (or rather as the rectangles they are on the screen); where several of them
    /// share one of the window, their colours are averaged, so that no row or column goes missing.
    #[must_use]
    pub fn new(picture: &Displayed, width: usize, height: usize) -> Self {
        let (across, down) = fit(picture.aspect, width, height);
        let (across, down) = (across.min(width), down.min(height));
        let (left, top) = ((width - across) / 2, (height - down) / 2);
        let columns = spans(picture.size.width() as usize, across);
        let rows = spans(picture.size.height() as usize, down);
        let colors = colors(picture);
        let mut pixels = vec![0; width * height];
        let lines = pixels.chunks_mut(width.max(1)).skip(top);
        let mut done: Option<(core::ops::Range<usize>, Vec<u32>)> = None;
        for (line, rows) in lines.zip(rows) {
            let scaled = match done.take() {
                Some((same, scaled)) if same == rows => scaled,
                _ => {
                    columns.iter().map(|span| average(&colors, picture.size.columns(), span, &rows)).collect()
                }
            };
            for (pixel, color) in line.iter_mut().skip(left).zip(&scaled) {
                *pixel = *color;
            }
            done = Some((rows, scaled));
        }
        Self { width, height, pixels }
    }
}

/// Returns which of `from` source pixels fall on each of `to` pixels of the window: at least one on each.
fn spans(from: usize, to: usize) -> Vec<core::ops::Range<usize>> {
    let start = |place: usize| place * from / to.max(1);
    (0..to).map(|place| start(place)..start(place + 1).max(start(place) + 1)).collect()
}

fn colors(picture: &Displayed) -> Vec<[u8; 3]> {
    let parts = |color: rta_core::color::Rgb<u8>| [color.r, color.g, color.b];
    match &picture.pixels {
        Pixels::Direct(pixels) => pixels.iter().copied().map(parts).collect(),
        Pixels::Indexed { palette, indices } => {
            let color = |index: &u8| palette.get(usize::from(*index)).copied().unwrap_or_default();
            indices.iter().map(color).map(parts).collect()
        }
    }
}

fn average(
    colors: &[[u8; 3]],
    stride: usize,
    columns: &core::ops::Range<usize>,
    rows: &core::ops::Range<usize>,
) -> u32 {
    let (mut sum, mut count) = ([0_u32; 3], 0_u32);
    for row in rows.clone() {
        let start = row * stride;
        for color in colors.get(start + columns.start..start + columns.end).unwrap_or(&[]) {
            for (total, part) in sum.iter_mut().zip(color) {
                *total += u32::from(*part);
            }
            count += 1;
        }
    }
    let [r, g, b] = sum.map(|total| (total + count / 2) / count.max(1));
    r << 16 | g << 8 | b
}

#[cfg(test)]
mod tests {
    use rta_core::color::Rgb;

    use super::{Frame, fit, spans};
    use crate::picture::file::{Displayed, Pixels};
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
        let pixels = Pixels::Direct(vec![Rgb::new(255, 0, 0), Rgb::new(0, 0, 100)]);
        let picture = Displayed { size: Size::new(2, 1).expect("small"), aspect: 2.0, pixels };
        let frame = Frame::new(&picture, 4, 4);
        let row = [0xff_0000, 0xff_0000, 0x64, 0x64];
        assert_eq!(frame.pixels, [[0; 4], row, row, [0; 4]].concat());
        let small = Frame::new(&Displayed { aspect: 1.0, ..picture }, 1, 1);
        assert_eq!(small.pixels, [0x80_0032]);
    }
}
