//! The picture with adaptive antialiasing: a row of corners, or three of first samples, packed to three bytes a pixel, and a row of
//! pixels, all on the stack.

use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::raster::contrast::Contrasts;
use rta_core::raster::corners::{Corners, Packed};
use rta_core::trace::Trace;
use rta_drivers::display::Display;
use rta_drivers::dither::Dither;
use rta_drivers::painter::Painter;
use rta_drivers::quantize::ColorTable;

use crate::{DrawError, Light, ROW, scene};

/// Light in a row of memory.
type Kept = Packed<{ u8::MAX }>;

/// Room for the light within a pixel.
const PLACES: usize = match scene::CUTTING {
    Some(cutting) => cutting.places(),
    None => 1,
};

/// Pictures with another seed have their samples at other places; the engine's have this one.
const SEED: u32 = 0;

/// A row of pixels.
type Levels = [Rgb<u8>; ROW];

/// Puts all rows of a picture, calling `row` after each.
pub(crate) fn put_rows<D: Display, T: ColorTable, H: Dither>(
    tracer: &impl Trace<scene::Number>,
    raster: Raster,
    painter: &mut Painter<D, T, H>,
    origin: (u32, u32),
    row: impl FnMut(),
) -> Result<(), DrawError<D::Error>> {
    let (most, width, view) = (painter.light_max(), raster.width() as usize, (&scene::CAMERA, raster));
    // The memory is as long as the rows, so that there are some.
    if let Some(cutting) = scene::CUTTING {
        let mut above = [Kept::default(); ROW + 1];
        let above = above.get_mut(..=width).unwrap_or_default();
        let rows = Corners::<_, _, PLACES, _>::new(tracer, view, cutting, above, 0);
        return rows.map_or(Ok(()), |mut rows| {
            put_all(painter, (origin, width), row, |levels| rows.next_row(taken(levels, most)))
        });
    }
    let mut memory = [Kept::default(); 3 * ROW];
    let memory = memory.get_mut(..3 * width).unwrap_or_default();
    let rows = Contrasts::new(tracer, view, SEED, memory, 0);
    rows.map_or(Ok(()), |mut rows| {
        put_all(painter, (origin, width), row, |levels| rows.next_row(taken(levels, most)))
    })
}

/// Returns what takes the light of a row, pixel by pixel, in `most` levels.
fn taken(levels: &mut Levels, most: u8) -> impl FnMut(Rgb<Light>) {
    let mut pixels = levels.iter_mut();
    move |light| {
        if let Some(pixel) = pixels.next() {
            *pixel = light.levels(most);
        }
    }
}

/// Puts the rows that `next` fills, as long as there are any.
fn put_all<D: Display, T: ColorTable, H: Dither>(
    painter: &mut Painter<D, T, H>,
    ((left, top), width): ((u32, u32), usize),
    mut row: impl FnMut(),
    mut next: impl FnMut(&mut Levels) -> bool,
) -> Result<(), DrawError<D::Error>> {
    let (mut levels, mut y) = ([Rgb::new(0, 0, 0); ROW], top);
    while next(&mut levels) {
        let pixels = levels.iter().copied().take(width);
        painter.put_row(left, y, pixels).map_err(DrawError::Display)?;
        y += 1;
        row();
    }
    Ok(())
}
