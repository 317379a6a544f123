//! The picture that a board must draw: the engine's, through the board's colour table.

use std::path::Path;

use rta::coloring::{Coloring, DitherKind, Table as Any, TableKind};
use rta::device::Device;
use rta::engine::{Engine, Format, Settings};
use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_core::raster::lattice::Lattice;
use rta_drivers::checksum::{Checksum, Unseen};
use rta_drivers::direct::DirectPainter;
use rta_drivers::display::{Capabilities, Display, DriverError};
use rta_drivers::dither::{Diffusion, DirectCell, FloydSteinberg};
use rta_drivers::guns::One;
use rta_drivers::painter::Painter;
use rta_drivers::quantize::{Adaptive, ColorTable, Uniform};
use rta_drivers::ssd0323::Ssd0323;
use rta_drivers::ssd0323::emulated::{MEMORY_SIZE, Oled};
use rta_scenes::bake::{self, TEXELS};
use rta_scenes::description::Description;
use rta_scenes::sampler::{Sampler, Spreading};

use super::Failure;
use super::antialiased::{self, Rows};
use super::board::Output;
use super::picture::{Colors, Picture};

/// A picture as indices into a colour table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Indexed {
    /// The colour table, in levels of the display's guns.
    pub colors: Vec<Rgb<u8>>,
    /// An index for each pixel, row by row.
    pub pixels: Vec<u8>,
}

impl Indexed {
    /// Returns the hash that `rta hash` prints for this picture.
    ///
    /// # Errors
    /// The colour table has more than 256 entries.
    pub fn hash(&self, (width, height): (u32, u32)) -> Result<u64, Failure> {
        let capabilities = Capabilities { width, height, colors: 256, gun_max: u8::MAX, aspect: (4, 3) };
        let mut sum = Checksum::new(Unseen(capabilities));
        sum.set_colors(0, &self.colors)?;
        for (y, row) in (0..height).zip(self.pixels.chunks(width as usize)) {
            sum.put_pixels(0, y, row)?;
        }
        Ok(sum.value())
    }
}

/// A display that keeps what is sent to it.
struct Paper {
    capabilities: Capabilities,
    shown: Indexed,
}

impl Display for Paper {
    type Error = DriverError<core::convert::Infallible>;

    fn capabilities(&self) -> Capabilities {
        self.capabilities
    }

    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error> {
        self.shown.colors.truncate(first.into());
        self.shown.colors.extend_from_slice(colors);
        Ok(())
    }

    fn put_pixels(&mut self, _x: u32, _y: u32, indices: &[u8]) -> Result<(), Self::Error> {
        self.shown.pixels.extend_from_slice(indices);
        Ok(())
    }
}

/// The most samples of which a board makes a palette.
const SAMPLES: u32 = 1024;

/// Returns the scene of a picture.
fn scene(picture: &Picture) -> Result<Description, Failure> {
    let text = std::fs::read(&picture.file)?;
    let mut scene = rta_scenes::read(&text, &picture.file.display().to_string())?;
    scene.load_pictures(picture.file.parent().unwrap_or_else(|| Path::new("")), TEXELS)?;
    if picture.solves {
        scene = scene.unsolved();
    }
    Ok(scene)
}

/// Returns the engine for a picture.
fn engine(picture: &Picture, (width, height): (u32, u32)) -> Result<Engine, Failure> {
    let scene = scene(picture)?;
    let format: Format = picture.format;
    let model = picture.model.unwrap_or(scene.model);
    let sampling =
        Spreading::of(&scene, picture.lamps, bake::SAMPLES).map_or(Sampler::CENTER, Sampler::Sobol);
    Ok(Engine::new(&scene, &Settings { width, height, format, model, sampling, ..Settings::default() })?)
}

/// Returns the rows of a picture as a board draws them.
fn rows(picture: &Picture, size: (u32, u32)) -> Result<Rows, Failure> {
    if let Some(adaptive) = picture.antialiased {
        return antialiased::rows((picture, &scene(picture)?), size, adaptive);
    }
    let engine = engine(picture, size)?;
    Ok(Box::new(move |y, most, row| engine.level_rows(y, most, row)))
}

/// Draws a picture of the engine's on a display of 256 colours, with `table` unless a palette is made for it.
fn paint(
    picture: &Picture,
    (width, height): (u32, u32),
    gun_max: u8,
    table: impl ColorTable + Send + 'static,
) -> Result<Indexed, Failure> {
    let mut rows = rows(picture, (width, height))?;
    let capabilities = Capabilities { width, height, colors: 256, gun_max, aspect: (4, 3) };
    let dither = if picture.colors == Colors::Dithered { DitherKind::Fs } else { DitherKind::None };
    let coloring = Coloring { table: TableKind::Sampled, dither, samples: SAMPLES };
    let table: Box<dyn ColorTable + Send> = match picture.colors {
        Colors::Standard => Box::new(table),
        Colors::Sampled | Colors::Dithered => {
            let engine = engine(picture, (width, height))?;
            let lattice = Lattice::new(Raster::new(width, height)?, coloring.samples());
            let (columns, rows) = (lattice.grid().width(), lattice.grid().height());
            let mut samples = vec![Rgb::new(0, 0, 0); columns as usize * rows as usize];
            engine.grid_rows(lattice, 0, &mut samples);
            coloring.table(capabilities, &samples, columns)?
        }
    };
    let shown = Indexed { colors: Vec::new(), pixels: Vec::new() };
    let dithering = coloring.dithering(capabilities, width as usize)?;
    let mut painter = Painter::dithered(Paper { capabilities, shown }, Any(table), dithering)?;
    let mut row = vec![Rgb::new(0, 0, 0); width as usize];
    for y in 0..height {
        rows(y, painter.light_max(), &mut row);
        painter.put_row(0, y, row.iter().copied())?;
    }
    Ok(painter.into_parts().0.shown)
}

/// Returns the picture that a board streams: 64 levels a gun, as a VGA has, in the uniform colour table unless a palette is made.
///
/// # Errors
/// The scene does not fit the number format.
pub fn streamed(picture: &Picture, size: (u32, u32)) -> Result<Indexed, Failure> {
    let gun_max = Device::Vga.capabilities().gun_max;
    paint(picture, size, gun_max, Uniform::new(256, gun_max)?)
}

/// The levels of an emulated panel, as its screendump shows them.
pub(crate) fn greys() -> Vec<Rgb<u8>> {
    (0..16).map(|level| Rgb::new(17 * level, 17 * level, 17 * level)).collect()
}

/// Returns the picture that a panel shows: the engine's, through the driver onto the emulated controller.
fn paneled(picture: &Picture) -> Result<Indexed, Failure> {
    let (width, height) = picture.size;
    let engine = engine(picture, picture.size)?;
    let panel = Ssd0323::program(Oled::new(vec![0; MEMORY_SIZE])?);
    let cells = vec![DirectCell::<One>::default(); width as usize];
    let dithering = Diffusion::<FloydSteinberg, _, One>::new(cells, width as usize)?;
    let mut painter = DirectPainter::dithered(panel, dithering);
    let mut row = vec![Rgb::new(0, 0, 0); width as usize];
    for y in 0..height {
        engine.level_rows(y, u8::MAX, &mut row);
        painter.put_row(0, y, row.iter().copied())?;
    }
    let oled = painter.into_display().release();
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    Ok(Indexed { colors: greys(), pixels: places.map(|(x, y)| oled.shown(x, y)).collect() })
}

/// Returns the picture that a board shows: with the tolerant adaptive colour table on a screen, unless a palette is made; on a panel in its
/// greys; else as it is streamed.
///
/// # Errors
/// The scene does not fit the number format.
pub fn shown(picture: &Picture, output: Output) -> Result<Indexed, Failure> {
    match output {
        Output::Screen { screen: (_, _, gun_max), .. } | Output::File { screen: (_, _, gun_max) } => {
            paint(picture, picture.size, gun_max, Adaptive::tolerant(256, gun_max)?)
        }
        Output::Panel { .. } => paneled(picture),
        Output::Semihosting | Output::Module => streamed(picture, picture.size),
    }
}
