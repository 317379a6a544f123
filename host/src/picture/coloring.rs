//! How a device's few colours stand for a picture's many: the kind of colour table, and the dithering.

use core::fmt;

use rta_core::color::Rgb;
use rta_core::raster::lattice::Lattice;
use rta_drivers::display::Capabilities;
use rta_drivers::dither::{Cell, Damped, Diffusion, Dither, FloydSteinberg, Ordered, Plain};
use rta_drivers::quantize::{Adaptive, ColorTable, MAX_SAMPLES, TableError, Uniform, refined, variance_cut};

use super::device::Device;
use super::raster::Size;
pub use rta_args::value::coloring::{DitherKind, SAMPLES, TableKind};

/// The colour table of a picture on a device, and its dithering.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Coloring {
    /// The kind of table.
    pub table: TableKind,
    /// The dithering.
    pub dither: DitherKind,
    /// The most samples of which a [`TableKind::Sampled`] is made, each 3 bytes of memory while it is.
    pub samples: u32,
}

impl Coloring {
    /// Returns what looks best on a device at the distance from which it was looked at: a table made for the picture, and diffusion where
    /// the pixels are fine. `rta palette` measures it.
    #[must_use]
    pub const fn of(device: Device) -> Self {
        let is_fine = device.capabilities().has_fine_pixels();
        let dither = if is_fine { DitherKind::Fs } else { DitherKind::None };
        Self { table: TableKind::Sampled, dither, samples: SAMPLES }
    }

    /// Returns the highest level of the light that pixels are given as: the guns', where a table that is looked up in their levels is not
    /// dithered.
    #[must_use]
    pub fn light_max(self, device: Capabilities) -> u8 {
        match (self.table, self.dither) {
            (TableKind::Tolerant | TableKind::Adaptive | TableKind::Uniform, DitherKind::None) => {
                device.gun_max
            }
            _ => u8::MAX,
        }
    }

    /// Returns how many of the picture's pixels have to be known, at most, before it is drawn.
    #[must_use]
    pub const fn samples(self) -> usize {
        match self.table {
            TableKind::Sampled => self.samples as usize,
            TableKind::Baked | TableKind::Frame => MAX_SAMPLES,
            TableKind::Tolerant | TableKind::Adaptive | TableKind::Uniform => 0,
        }
    }

    /// Returns the table for a device. `samples` are the colours, 8 bits a gun, of the pixels of a grid that is `width` of them wide; it
    /// may be empty if [`Coloring::samples`] is 0.
    ///
    /// # Errors
    /// [`TableError`] if the device has too few colours or levels for this kind.
    pub fn table(
        self,
        device: Capabilities,
        samples: &[Rgb<u8>],
        width: u32,
    ) -> Result<Box<dyn ColorTable + Send>, TableError> {
        let Capabilities { colors, gun_max, .. } = device;
        let mut memory = vec![Rgb::default(); samples.len()];
        let light = || samples.iter().copied();
        let mut cut = || variance_cut(&mut memory, light(), width, colors, gun_max);
        Ok(match self.table {
            TableKind::Sampled | TableKind::Baked => Box::new(cut()?),
            TableKind::Frame => {
                let begin = cut()?;
                Box::new(refined(begin, &mut memory, light(), width, gun_max)?)
            }
            TableKind::Tolerant => Box::new(Adaptive::tolerant(colors, gun_max)?),
            TableKind::Adaptive => Box::new(Adaptive::new(colors)?),
            TableKind::Uniform => Box::new(Uniform::new(colors, gun_max)?),
        })
    }

    /// Returns the dithering of rows of `width` pixels.
    ///
    /// # Errors
    /// [`TableError`] if the device has too few colours or levels to be dithered.
    pub fn dithering(self, device: Capabilities, width: usize) -> Result<Dithering, TableError> {
        let cells = || vec![Cell::default(); width];
        Ok(match self.dither {
            DitherKind::None => Dithering::Plain(Plain),
            DitherKind::Fs => {
                Diffusion::new(cells(), width).map_or(Dithering::Plain(Plain), Dithering::Damped)
            }
            DitherKind::Fs7351 => {
                Diffusion::new(cells(), width).map_or(Dithering::Plain(Plain), Dithering::FloydSteinberg)
            }
            // A table that is not a cube is dithered as a cube of as many colours.
            DitherKind::Bayer => {
                Dithering::Ordered(Ordered::uniform(&Uniform::new(device.colors, device.gun_max)?))
            }
        })
    }
}

impl fmt::Display for Coloring {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { table, dither, samples } = self;
        write!(f, "{table} colour table")?;
        if *table == TableKind::Sampled && *samples != SAMPLES {
            write!(f, " of {samples} samples")?;
        }
        match dither {
            DitherKind::None => Ok(()),
            dither => write!(f, ", dithered {dither}"),
        }
    }
}

/// Returns those of a whole picture's pixels that are on a grid.
pub(crate) fn on_grid(picture: &[Rgb<u8>], size: Size, lattice: Lattice) -> Vec<Rgb<u8>> {
    let pixel = |(x, y): (u32, u32)| picture.get(y as usize * size.columns() + x as usize).copied();
    lattice.pixels().map(|place| pixel(place).unwrap_or_default()).collect()
}

/// A colour table of any kind.
pub struct Table(pub Box<dyn ColorTable + Send>);

impl ColorTable for Table {
    fn light_max(&self, gun_max: u8) -> u8 {
        self.0.light_max(gun_max)
    }

    fn index(&mut self, color: Rgb<u8>) -> u8 {
        self.0.index(color)
    }

    fn index_near(&mut self, pixel: Rgb<u8>, color: Rgb<u8>, gun_max: u8) -> u8 {
        self.0.index_near(pixel, color, gun_max)
    }

    fn entries(&self) -> &[Rgb<u8>] {
        self.0.entries()
    }
}

/// Dithering of any kind.
#[derive(Clone, Debug)]
pub enum Dithering {
    /// None.
    Plain(Plain),
    /// Error diffusion of a part of the error.
    Damped(Diffusion<Damped, Vec<Cell>>),
    /// Error diffusion of all of it.
    FloydSteinberg(Diffusion<FloydSteinberg, Vec<Cell>>),
    /// A fixed pattern.
    Ordered(Ordered),
}

impl Dither for Dithering {
    fn light_max<T: ColorTable + ?Sized>(&self, table: &T, gun_max: u8) -> u8 {
        match self {
            Self::Plain(plain) => plain.light_max(table, gun_max),
            Self::Damped(diffusion) => diffusion.light_max(table, gun_max),
            Self::FloydSteinberg(diffusion) => diffusion.light_max(table, gun_max),
            Self::Ordered(ordered) => ordered.light_max(table, gun_max),
        }
    }

    fn start_row(&mut self, x: u32, y: u32, len: usize) -> bool {
        match self {
            Self::Plain(plain) => plain.start_row(x, y, len),
            Self::Damped(diffusion) => diffusion.start_row(x, y, len),
            Self::FloydSteinberg(diffusion) => diffusion.start_row(x, y, len),
            Self::Ordered(ordered) => ordered.start_row(x, y, len),
        }
    }

    fn index<T: ColorTable + ?Sized>(
        &mut self,
        table: &mut T,
        gun_max: u8,
        place: (u32, u32),
        light: Rgb<u8>,
    ) -> u8 {
        match self {
            Self::Plain(plain) => plain.index(table, gun_max, place, light),
            Self::Damped(diffusion) => diffusion.index(table, gun_max, place, light),
            Self::FloydSteinberg(diffusion) => diffusion.index(table, gun_max, place, light),
            Self::Ordered(ordered) => ordered.index(table, gun_max, place, light),
        }
    }

    fn drawn(&self, x: u32) -> u8 {
        match self {
            Self::Plain(plain) => plain.drawn(x),
            Self::Damped(diffusion) => diffusion.drawn(x),
            Self::FloydSteinberg(diffusion) => diffusion.drawn(x),
            Self::Ordered(ordered) => ordered.drawn(x),
        }
    }
}
