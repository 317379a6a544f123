//! Retired instructions that turn a pixel's light into an index of the colour table, counted by [`callgrind`].

use core::convert::Infallible;
use core::sync::atomic::AtomicBool;
use std::io::{self, Read};

use clap::ValueEnum;
use rta_core::color::Rgb;
use rta_drivers::checksum::Unseen;
use rta_drivers::display::DriverError;
use rta_drivers::painter::Painter;

use super::traced::{Traced, levels};
use crate::args::IndexingArgs;
use crate::engine::callgrind::{self, CountError};
use crate::picture::coloring::{Coloring, DitherKind, Dithering, Table, TableKind, on_grid};
use crate::picture::device::Device;
use crate::picture::error::PictureError;
use crate::picture::file::write_light;
use crate::picture::raster::Size;
use crate::picture::screen::parts;
use crate::study::error::StudyError;

/// The function that is counted, as callgrind is told.
const COUNTED: [&str; 1] = ["*indexed_picture"];

/// About so many pixels are counted, in whole rows at equal distances, so that it takes seconds.
const PIXELS: usize = 1 << 14;

/// The child: turns the picture on standard input into indices by every combination in the order of
/// [`colorings`](super::colorings), and prints nothing.
///
/// # Errors
/// [`StudyError::Palette`] for light that does not fill the picture, and [`PictureError::Display`].
pub fn run(args: &IndexingArgs) -> Result<(), StudyError> {
    let light = read(args.size)?;
    let (device, size) = (args.device, args.size);
    let all = levels(&light, u8::MAX);
    for &table in TableKind::value_variants() {
        // What is made of the picture does not change while it is drawn, and is made once.
        let mut made = None;
        for &dither in DitherKind::value_variants() {
            let coloring = Coloring { table, dither, samples: args.table_samples };
            let (table, dithering) = match made.take() {
                Some(table) => (
                    table,
                    coloring
                        .dithering(device.capabilities(), size.columns())
                        .map_err(PictureError::display)?,
                ),
                None => parts(device, coloring, size, |lattice| {
                    Ok::<_, StudyError>(on_grid(&all, size, lattice))
                })?,
            };
            let sent = levels(&light, coloring.light_max(device.capabilities()));
            let unseen = Unseen(device.capabilities());
            let mut painter = Painter::dithered(unseen, table, dithering).map_err(PictureError::display)?;
            indexed_picture(&mut painter, &sent, size.columns()).map_err(PictureError::display)?;
            made = (coloring.samples() > 0).then(|| painter.into_parts().1);
        }
    }
    Ok(())
}

/// Draws a picture on a display that nobody sees.
#[inline(never)] // It is counted by its name.
fn indexed_picture(
    painter: &mut Painter<Unseen, Table, Dithering>,
    light: &[Rgb<u8>],
    columns: usize,
) -> Result<(), DriverError<Infallible>> {
    (0..).zip(light.chunks(columns)).try_for_each(|(y, row)| painter.put_row(0, y, row.iter().copied()))
}

/// Reads the light of a picture from standard input.
fn read(size: Size) -> Result<Vec<Rgb<f32>>, StudyError> {
    let mut bytes = Vec::new();
    io::stdin().lock().read_to_end(&mut bytes).map_err(StudyError::palette)?;
    let floats: Vec<_> = bytes.as_chunks().0.iter().copied().map(f32::from_le_bytes).collect();
    let light: Vec<_> = floats.as_chunks().0.iter().map(|&[r, g, b]| Rgb::new(r, g, b)).collect();
    if light.len() == size.pixels() {
        Ok(light)
    } else {
        Err(StudyError::palette(io::Error::from(io::ErrorKind::UnexpectedEof)))
    }
}

/// Returns the instructions a pixel of every combination in the order of [`colorings`](super::colorings), on a part of the picture's rows.
///
/// # Errors
/// All of [`CountError`].
pub fn count(
    device: Device,
    samples: u32,
    traced: &Traced,
    stop: &AtomicBool,
) -> Result<Vec<f64>, CountError> {
    let columns = traced.size.columns();
    let step = traced.size.pixels().div_ceil(PIXELS);
    let rows: Vec<_> = traced.light.chunks(columns).step_by(step).collect();
    let mut input = Vec::new();
    write_light(&rows.concat(), &mut input)?;
    let (size, samples) = (format!("{columns}x{}", rows.len()), samples.to_string());
    let device = device.to_string();
    let args = ["indexing", "--device", &device, "--size", &size, "--table-samples", &samples];
    let expected = super::colorings(0).len();
    let counts = callgrind::count(&std::env::current_exe()?, &args, &input, &COUNTED, expected, stop)?;
    Ok(counts.into_iter().map(|count| ratio(count, columns * rows.len())).collect())
}

#[expect(clippy::cast_precision_loss, reason = "below 2^53")]
fn ratio(count: u64, pixels: usize) -> f64 {
    count as f64 / pixels as f64
}
