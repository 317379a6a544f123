//! The picture that every board draws, and what it reports of itself.

#![no_std]

pub mod console;
pub mod stream;

use rta_core::illumination::Rta;
use rta_core::raster::{Pixels, Raster};
use rta_core::trace::Tracer;
use rta_drivers::checksum::{Checksum, Unseen};
use rta_drivers::display::{Capabilities, Display};
use rta_drivers::painter::Painter;
use rta_drivers::quantize::{Adaptive, ColorTable, Uniform};

include!(concat!(env!("OUT_DIR"), "/choice.rs"));

/// Recursion depth.
const DEPTH: u8 = 5;

/// The colour table of boards that stream their picture: in flash, and it costs no RAM.
static TABLE: Uniform = match Uniform::new(256, 63) {
    Ok(table) => table,
    Err(_) => panic!("256 colours and 64 levels are enough for a cube"),
};

/// The colour table of boards that stream their picture.
pub fn table() -> &'static Uniform {
    &TABLE
}

/// The colour table of boards with a screen: made while the picture is drawn.
pub const fn adaptive(gun_max: u8) -> Adaptive {
    match Adaptive::tolerant(256, gun_max) {
        Ok(table) => table,
        Err(_) => panic!("256 colours are a table"),
    }
}

/// Why there is no picture.
#[derive(Debug)]
pub enum DrawError<E> {
    /// The tracer refuses raster or depth.
    Tracer(rta_core::Error),
    /// The display's own.
    Display(E),
}

/// Draws the picture, `WIDTH` x `HEIGHT` from (`left`, `top`); calls `row` after each row.
///
/// # Errors
/// Those of the display.
pub fn draw<D: Display, T: ColorTable>(
    display: D,
    table: T,
    origin: (u32, u32),
    row: impl FnMut(),
) -> Result<(D, T), DrawError<D::Error>> {
    draw_sized(display, table, origin, (WIDTH, HEIGHT), row)
}

/// What a board with a screen tells of the picture: its raster, and [`checksum`].
///
/// It is generic, as [`checksum`] is, for the sake of boards that do not call it: no tracer is compiled for it there, and
/// theirs is not optimised with another caller in view.
pub fn facts<T: ColorTable>(table: T) -> [(&'static str, u64); 3] {
    [("width", WIDTH.into()), ("height", HEIGHT.into()), ("hash", checksum(table))]
}

/// The hash of the picture as boards without a screen stream it, in 160 x 100 pixels of 64 levels, with [`table`]. It is the same on all
/// boards, whatever their own screens are like.
pub fn checksum<T: ColorTable>(table: T) -> u64 {
    let (width, height) = (160, 100);
    let unseen = Unseen(Capabilities { width, height, colors: 256, gun_max: 63, aspect: (4, 3) });
    match draw_sized(Checksum::new(unseen), table, (0, 0), (width, height), || ()) {
        Ok((sum, _)) => sum.value(),
        Err(_) => 0,
    }
}

fn draw_sized<D: Display, T: ColorTable>(
    display: D,
    table: T,
    (left, top): (u32, u32),
    (width, height): (u32, u32),
    mut row: impl FnMut(),
) -> Result<(D, T), DrawError<D::Error>> {
    let gun_max = display.capabilities().gun_max;
    let raster = Raster::new(width, height).map_err(DrawError::Tracer)?;
    let scene = if BAKED { &scene::SCENE } else { core::hint::black_box(&scene::SCENE) };
    let tracer: Tracer<_, _, Needs, { DEPTH as usize }, _> =
        Tracer::new(scene, Rta, DEPTH.into()).map_err(DrawError::Tracer)?;
    let mut painter = Painter::new(display, table).map_err(DrawError::Display)?;
    for y in 0..height {
        let levels = Pixels::row(&tracer, &scene::CAMERA, raster, y).map(|light| light.levels(gun_max));
        painter.put_row(left, top + y, levels).map_err(DrawError::Display)?;
        row();
    }
    painter.update().map_err(DrawError::Display)?;
    Ok(painter.into_parts())
}

/// `name`, a blank, `value` in sixteen hexadecimal digits, and the end of the line: a report without `core::fmt`.
pub fn report(name: &str, value: u64, mut put: impl FnMut(u8)) {
    for byte in name.bytes() {
        put(byte);
    }
    put(b' ');
    for digit in (0..16).rev() {
        let nibble = (value >> (4 * digit)).to_le_bytes()[0] & 15;
        put(if nibble < 10 { b'0' + nibble } else { b'a' + nibble - 10 });
    }
    put(b'\n');
}
