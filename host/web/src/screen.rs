//! The three displays, emulated from their registers or calls up, with a picture in the upper left corner.

use core::fmt;

use rta_core::color::Rgb;
use rta_drivers::display::{Capabilities, ReadBack, expand};
use rta_drivers::dither::{Cell, Damped, Diffusion, Dither, FloydSteinberg, Ordered, Plain};
use rta_drivers::graphigs::{self, GraphigsDisplay, emulated::Workstation};
use rta_drivers::painter::Painter;
use rta_drivers::pixrect::{self, Cgthree, PixrectDisplay, emulated::Board};
use rta_drivers::quantize::{ColorTable, Uniform};
use rta_drivers::vga13h::{self, Mode13h, emulated::Vga};

use crate::coloring::{DitherKind, Table};
use crate::failure::Failure;

/// A display.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Device {
    /// IBM PS/2, mode 13h.
    Vga,
    /// IBM RT PC with graPHIGS.
    Graphigs,
    /// SUN SPARCstation with PIXRECT.
    Pixrect,
}

impl Device {
    /// All displays with their names.
    pub(crate) const ALL: [(&str, Self); 3] =
        [("vga", Self::Vga), ("graphigs", Self::Graphigs), ("pixrect", Self::Pixrect)];

    /// Returns what its driver states of it.
    pub(crate) const fn capabilities(self) -> Capabilities {
        match self {
            Self::Vga => vga13h::CAPABILITIES,
            Self::Graphigs => graphigs::CAPABILITIES,
            Self::Pixrect => pixrect::CAPABILITIES,
        }
    }
}

/// A painter on any of the displays with any dithering.
trait Canvas {
    fn light_max(&self) -> u8;
    fn put_row(&mut self, y: u32, light: &[Rgb<u8>]) -> Result<(), Failure>;
    /// Returns the entries of the colour table so far, as levels of the guns.
    fn colors(&mut self) -> Result<Vec<Rgb<u8>>, Failure>;
    fn read_row(&mut self, y: u32, indices: &mut [u8]) -> Result<(), Failure>;
}

impl<D: ReadBack<Error: fmt::Display>, H: Dither> Canvas for Painter<D, Table, H> {
    fn light_max(&self) -> u8 {
        Painter::light_max(self)
    }

    fn put_row(&mut self, y: u32, light: &[Rgb<u8>]) -> Result<(), Failure> {
        Painter::put_row(self, 0, y, light.iter().copied()).map_err(Failure::plain)?;
        self.update().map_err(Failure::plain)
    }

    fn colors(&mut self) -> Result<Vec<Rgb<u8>>, Failure> {
        let mut colors = vec![Rgb::default(); self.table().entries().len()];
        self.display_mut().read_colors(0, &mut colors).map_err(Failure::plain)?;
        Ok(colors)
    }

    fn read_row(&mut self, y: u32, indices: &mut [u8]) -> Result<(), Failure> {
        self.display_mut().read_pixels(0, y, indices).map_err(Failure::plain)
    }
}

/// A display that is switched on, with a colour table and dithering.
pub(crate) struct Screen {
    canvas: Box<dyn Canvas>,
    gun_max: u8,
}

impl Screen {
    /// Switches a display on, for rows of `width` pixels.
    ///
    /// # Errors
    /// The display refuses the table, or has too few colours to be dithered.
    pub(crate) fn new(
        device: Device,
        table: Table,
        dither: DitherKind,
        width: usize,
    ) -> Result<Self, Failure> {
        let capabilities = device.capabilities();
        let canvas = match device {
            Device::Vga => {
                let board = Vga::new(vec![0; vga13h::emulated::MEMORY_SIZE]).map_err(Failure::plain)?;
                dithered(Mode13h::program(board), table, dither, width)
            }
            Device::Graphigs => {
                let workstation = Workstation::new(vec![0; graphigs::emulated::MEMORY_SIZE]);
                let kind = graphigs::emulated::WORKSTATION_TYPE;
                let display = GraphigsDisplay::open(workstation, "IBM5081", kind).map_err(Failure::plain)?;
                dithered(display, table, dither, width)
            }
            Device::Pixrect => {
                let board = Board::new(vec![0; pixrect::emulated::MEMORY_SIZE]).map_err(Failure::plain)?;
                dithered(
                    PixrectDisplay::new(Cgthree::open(board)).map_err(Failure::plain)?,
                    table,
                    dither,
                    width,
                )
            }
        };
        Ok(Self { canvas: canvas?, gun_max: capabilities.gun_max })
    }

    /// Returns the highest level of the light that [`Screen::put_row`] takes.
    pub(crate) fn light_max(&self) -> u8 {
        self.canvas.light_max()
    }

    /// Draws a row.
    ///
    /// # Errors
    /// The display has no such row or no such level.
    pub(crate) fn put_row(&mut self, y: u32, light: &[Rgb<u8>]) -> Result<(), Failure> {
        self.canvas.put_row(y, light)
    }

    /// Returns the entries of the colour table so far, with 8 bits a gun.
    ///
    /// # Errors
    /// The display does not answer.
    pub(crate) fn colors(&mut self) -> Result<Vec<Rgb<u8>>, Failure> {
        let gun_max = self.gun_max;
        let colors = self.canvas.colors()?;
        Ok(colors.into_iter().map(|color| color.map(|level| expand(level, gun_max))).collect())
    }

    /// Returns the indices of the first `width` pixels of a row.
    ///
    /// # Errors
    /// The display has no such row.
    pub(crate) fn indices(&mut self, y: u32, width: usize) -> Result<Vec<u8>, Failure> {
        let mut indices = vec![0; width];
        self.canvas.read_row(y, &mut indices)?;
        Ok(indices)
    }
}

/// Returns a painter on a display, dithered for rows of `width` pixels.
fn dithered(
    display: impl ReadBack<Error: fmt::Display> + 'static,
    table: Table,
    dither: DitherKind,
    width: usize,
) -> Result<Box<dyn Canvas>, Failure> {
    fn painter<D: ReadBack<Error: fmt::Display> + 'static, H: Dither + 'static>(
        display: D,
        table: Table,
        dither: H,
    ) -> Result<Box<dyn Canvas>, Failure> {
        Ok(Box::new(Painter::dithered(display, table, dither).map_err(Failure::plain)?))
    }
    let cells = || vec![Cell::default(); width];
    match dither {
        DitherKind::None => painter(display, table, Plain),
        DitherKind::Fs => {
            let damped = Diffusion::<Damped, _>::new(cells(), width).map_err(Failure::plain)?;
            painter(display, table, damped)
        }
        DitherKind::Fs7351 => {
            let whole = Diffusion::<FloydSteinberg, _>::new(cells(), width).map_err(Failure::plain)?;
            painter(display, table, whole)
        }
        // A table that is not a cube is dithered as a cube of as many colours.
        DitherKind::Bayer => {
            let Capabilities { colors, gun_max, .. } = display.capabilities();
            let cube = Uniform::new(colors, gun_max).map_err(Failure::plain)?;
            painter(display, table, Ordered::uniform(&cube))
        }
    }
}
