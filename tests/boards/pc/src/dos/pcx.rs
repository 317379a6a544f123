//! PCX files of 256 colours: a header, rows of runs, and the colour table at the end.
//!
//! A byte below C0h is a pixel; one above is a run, C0h + 1 to 63 pixels, and the byte after it the pixel. No run goes
//! beyond the end of its row.

use rta_core::color::Rgb;
use rta_drivers::display::expand;

/// Marks a run; pixels from here up are written as runs of one.
const RUN: u8 = 0xC0;

/// The longest run.
const LONGEST: usize = 63;

/// The byte that announces the colour table.
const TABLE: u8 = 12;

/// Returns the header of a picture of `width` x `height` pixels, both at least 1.
pub(crate) fn header(width: u16, height: u16) -> [u8; 128] {
    let [width_low, width_high] = width.to_le_bytes();
    let [height_low, height_high] = height.to_le_bytes();
    let [right_low, right_high] = width.saturating_sub(1).to_le_bytes();
    let [bottom_low, bottom_high] = height.saturating_sub(1).to_le_bytes();
    // Bytes of a row: an even number.
    let [row_low, row_high] = width.saturating_add(width % 2).to_le_bytes();
    let mut header = [0; 128];
    // ZSoft's mark, version 3.0, runs, 8 bits a pixel; the first column and row, the last ones, the raster.
    let start = [
        10,
        5,
        1,
        8,
        0,
        0,
        0,
        0,
        right_low,
        right_high,
        bottom_low,
        bottom_high,
        width_low,
        width_high,
        height_low,
        height_high,
    ];
    // One plane, the bytes of a row, and that the table has colours.
    let rest = [1, row_low, row_high, 1, 0];
    header.iter_mut().zip(start).for_each(|(to, byte)| *to = byte);
    header.iter_mut().skip(65).zip(rest).for_each(|(to, byte)| *to = byte);
    header
}

/// Writes a row: at most twice as many bytes as it has pixels, and two more where their number is odd.
pub(crate) fn row(indices: &[u8], mut put: impl FnMut(u8)) {
    for run in indices.chunk_by(|a, b| a == b).flat_map(|run| run.chunks(LONGEST)) {
        if let &[first, ..] = run {
            if run.len() > 1 || first >= RUN {
                // At most 63.
                put(RUN | run.len().to_le_bytes()[0]);
            }
            put(first);
        }
    }
    if indices.len() % 2 == 1 {
        put(0);
    }
}

/// Writes the colour table, whose levels are 0..=`gun_max`.
pub(crate) fn table(colors: &[Rgb<u8>; 256], gun_max: u8, mut put: impl FnMut(u8)) {
    put(TABLE);
    for color in colors {
        for level in [color.r, color.g, color.b] {
            put(expand(level, gun_max));
        }
    }
}
