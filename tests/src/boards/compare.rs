//! Comparison of a board's picture with the one that the engine draws.

use rta_core::color::Rgb;

use super::Failure;
use super::expected::Indexed;
use super::machine::Screendump;

/// Compares what a board drew with what it must draw.
///
/// # Errors
/// How they differ, in words.
pub fn picture(got: &Indexed, want: &Indexed) -> Result<(), Failure> {
    let used = want.colors.len();
    if got.colors.get(..used) != Some(want.colors.as_slice()) {
        return Err("its colour table differs".into());
    }
    if got.pixels.len() != want.pixels.len() {
        return Err(format!("{} pixels, not {}", got.pixels.len(), want.pixels.len()).into());
    }
    match got.pixels.iter().zip(&want.pixels).filter(|(got, want)| got != want).count() {
        0 => Ok(()),
        wrong => Err(format!("{wrong} of {} pixels differ", want.pixels.len()).into()),
    }
}

/// Compares what the screen shows with the picture: in its middle where the picture is smaller, black around it.
///
/// # Errors
/// How they differ, in words.
pub fn screen(
    dump: &Screendump,
    want: &Indexed,
    (width, height): (u32, u32),
    (across, down, gun_max): (u32, u32, u8),
    zoom: usize,
) -> Result<(), Failure> {
    let (across, down) = (across as usize, down as usize);
    if dump.size != (across * zoom, down * zoom) {
        return Err(format!("the screendump has {:?} pixels", dump.size).into());
    }
    let (width, height) = (width as usize, height as usize);
    let (left, top) = ((across - width) / 2, (down - height) / 2);
    // QEMU's DAC of 6 bits: the lowest bit fills both that are missing.
    let light = |level: u8| if gun_max == 63 { level << 2 | (level & 1) << 1 | level & 1 } else { level };
    let shown = |x: usize, y: usize| {
        let inside = x >= left && y >= top && x < left + width && y < top + height;
        let index = if inside { want.pixels.get((y - top) * width + x - left) } else { Some(&0) };
        let color = index.and_then(|&index| want.colors.get(usize::from(index))).copied().unwrap_or_default();
        let Rgb { r, g, b } = color.map(light);
        [r, g, b]
    };
    let rows = dump.pixels.chunks(across * zoom).enumerate();
    let places = rows.flat_map(|(y, row)| row.iter().enumerate().map(move |(x, pixel)| (x, y, pixel)));
    match places.filter(|&(x, y, pixel)| *pixel != shown(x / zoom, y / zoom)).count() {
        0 => Ok(()),
        wrong => Err(format!("{wrong} pixels of the screendump differ").into()),
    }
}
