//! The Juggler on two displays of 320 x 240 pixels and 16 bits a pixel, an ILI9341 and an ST7789, over any serial bus.
//!
//! There is no frame buffer: 512 bytes gather the pixels that go over the bus at once, and nothing else is kept of the picture.

#![no_std]
#![forbid(unsafe_code)]

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::pixelcolor::Rgb565;
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiDevice;
use mipidsi::Builder;
use mipidsi::interface::SpiInterface;
use mipidsi::models::{ILI9341Rgb565, ST7789};
use mipidsi::options::{ColorInversion, ColorOrder, Orientation, Rotation};
use rta_core::raster::{Pixels, Raster};
use rta_core::trace::Tracer;
use rta_drivers::direct::{DirectDisplay, DirectPainter};
use rta_drivers::dither::Bayer;
use rta_drivers::target::Target;

/// The scene as the build script has baked it.
mod scene {
    include!(concat!(env!("OUT_DIR"), "/juggler.rs"));
}

/// Depth of the ray tree.
const DEPTH: u8 = 5;

/// Bytes that gather pixels: 256 of them. More is faster, by less and less.
const BUFFER: usize = 512;

/// Why there is no picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The display cannot be set up.
    Setup,
    /// The display is too large, or the tracer refuses the scene.
    Tracer,
    /// The display refuses pixels.
    Display,
}

/// Draws the picture on a display with direct colour, row by row.
///
/// # Errors
/// [`Failure::Tracer`] or [`Failure::Display`].
pub fn draw<D: DirectDisplay>(display: D) -> Result<D, Failure> {
    let (width, height) = display.size();
    let raster = Raster::new(width, height).map_err(|_| Failure::Tracer)?;
    let tracer: Tracer<'_, _, _, scene::Needs, { DEPTH as usize }, _> =
        Tracer::new(&scene::SCENE, scene::model(), DEPTH.into()).map_err(|_| Failure::Tracer)?;
    let mut painter = DirectPainter::dithered(display, Bayer);
    for y in 0..height {
        let light = Pixels::row(&tracer, &scene::CAMERA, raster, y).map(|light| light.levels(u8::MAX));
        painter.put_row(0, y, light).map_err(|_| Failure::Display)?;
    }
    painter.update().map_err(|_| Failure::Display)?;
    Ok(painter.into_display())
}

fn show(display: &mut impl DrawTarget<Color = Rgb565>) -> Result<(), Failure> {
    draw(Target::new(display)).map(drop)
}

/// Turned by a quarter, a panel of 240 x 320 shows 320 x 240.
const LANDSCAPE: Orientation = Orientation::new().rotate(Rotation::Deg90);

/// Sets up an ILI9341 on `spi`, which selects it, with its D/C and reset lines, and draws on it.
///
/// # Errors
/// [`Failure::Setup`] or [`Failure::Display`] where the bus or a line fails.
pub fn ili9341(
    spi: impl SpiDevice,
    dc: impl OutputPin,
    reset: impl OutputPin,
    delay: &mut impl DelayNs,
) -> Result<(), Failure> {
    let mut buffer = [0; BUFFER];
    let display = Builder::new(ILI9341Rgb565, SpiInterface::new(spi, dc, &mut buffer))
        .display_size(240, 320)
        .orientation(LANDSCAPE)
        // Most modules have their filters in this order.
        .color_order(ColorOrder::Bgr)
        .reset_pin(reset)
        .init(delay);
    show(&mut display.map_err(|_| Failure::Setup)?)
}

/// Sets up an ST7789 on `spi`, which selects it, with its D/C and reset lines, and draws on it.
///
/// # Errors
/// [`Failure::Setup`] or [`Failure::Display`] where the bus or a line fails.
pub fn st7789(
    spi: impl SpiDevice,
    dc: impl OutputPin,
    reset: impl OutputPin,
    delay: &mut impl DelayNs,
) -> Result<(), Failure> {
    let mut buffer = [0; BUFFER];
    let display = Builder::new(ST7789, SpiInterface::new(spi, dc, &mut buffer))
        .display_size(240, 320)
        .orientation(LANDSCAPE)
        // Its panels are lit where the liquid crystal is not driven.
        .invert_colors(ColorInversion::Inverted)
        .reset_pin(reset)
        .init(delay);
    show(&mut display.map_err(|_| Failure::Setup)?)
}
