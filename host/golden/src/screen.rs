//! The screen that a picture is drawn for: a device, the part of its raster that is drawn, and a colour table.

use rta_core::Scalar;
use rta_core::camera::Camera;
use rta_core::color::Rgb;
use rta_core::raster::lattice::Lattice;
use rta_core::raster::{Pixels, Raster};
use rta_core::trace::Trace;
use rta_drivers::display::Capabilities;
use rta_drivers::dither::{Cell, Damped, Diffusion, Dither, Plain};
use rta_drivers::painter::Painter;
use rta_drivers::quantize::{Adaptive, ColorTable, SAMPLES, Uniform, variance_cut};
use rta_drivers::{graphigs, pixrect, vga13h};

use crate::error::DrawError;
use crate::paper::Paper;
use crate::picture::Picture;

/// How the entries of the colour table are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Table {
    /// Made for the picture before it is drawn, from [`SAMPLES`] of its pixels: [`variance_cut`]. On a device with
    /// [fine pixels](Capabilities::has_fine_pixels) it is dithered by [`Diffusion`] of the weights [`Damped`]. It is
    /// what the program draws unless told otherwise.
    #[default]
    Sampled,
    /// Built while the picture is drawn; what is nearly an entry shares it: [`Adaptive::tolerant`].
    Tolerant,
    /// Built while the picture is drawn: [`Adaptive::new`].
    Adaptive,
    /// Evenly spaced colours, alike for every picture: [`Uniform`].
    Uniform,
    /// No table: each pixel keeps its own levels, as on a display with direct colour.
    None,
}

/// The screen that a picture is drawn for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Screen {
    /// The device.
    pub device: Capabilities,
    /// Width and height of the picture in pixels, at most the device's. A smaller picture is a window in the device's raster and
    /// keeps the shape of its pixels.
    pub size: (u32, u32),
    /// The colour table.
    pub table: Table,
}

impl Default for Screen {
    /// The whole screen of a VGA.
    fn default() -> Self {
        Self::VGA
    }
}

impl Screen {
    /// A VGA in mode 13h: 320 x 200 pixels on a screen of 4 : 3, 256 colours, 64 levels a gun.
    pub const VGA: Self = Self::of(vga13h::CAPABILITIES);
    /// An IBM RT PC with graPHIGS: 1024 x 1024 pixels, 128 colours, 16 levels a gun.
    pub const GRAPHIGS: Self = Self::of(graphigs::CAPABILITIES);
    /// A SPARCstation with PIXRECT: 1152 x 900 pixels, 256 colours, 256 levels a gun.
    pub const PIXRECT: Self = Self::of(pixrect::CAPABILITIES);

    /// Returns the whole screen of a device, with a table made for the picture.
    #[must_use]
    pub const fn of(device: Capabilities) -> Self {
        Self { device, size: (device.width, device.height), table: Table::Sampled }
    }

    /// Returns a window of `width` x `height` pixels on this screen.
    #[must_use]
    pub const fn window(self, width: u32, height: u32) -> Self {
        Self { size: (width, height), ..self }
    }

    /// Returns the screen with another colour table.
    #[must_use]
    pub const fn with(self, table: Table) -> Self {
        Self { table, ..self }
    }

    /// Draws what the tracer sees through the camera. The camera's lens, not the screen, says which shape the picture has.
    ///
    /// # Errors
    /// Those of [`Screen::paint`].
    pub fn trace<S: Scalar>(&self, tracer: &impl Trace<S>, camera: &Camera<S>) -> Result<Picture, DrawError> {
        let (raster, most) = (self.raster()?, self.light_max());
        let samples = || {
            let lattice = self.lattice(raster);
            let light = Pixels::sampled(tracer, camera, lattice.grid(), lattice, 0, u32::MAX);
            light.map(|light| light.levels(u8::MAX)).collect()
        };
        let light: Vec<_> = Pixels::new(tracer, camera, raster).map(|light| light.levels(most)).collect();
        self.draw(&light, samples)
    }

    /// Returns the highest level of the light that [`Screen::paint`] takes: 255 if the table is made for the picture, else that of the
    /// device's guns.
    #[must_use]
    pub fn light_max(&self) -> u8 {
        if self.table == Table::Sampled { u8::MAX } else { self.device.gun_max }
    }

    /// Draws light as levels 0..=[`light_max`](Screen::light_max), row by row from the upper left, through the colour table.
    ///
    /// # Errors
    /// [`DrawError::Larger`] for a picture larger than its device, [`DrawError::Tracer`] for a side that is 0 or longer than 65535,
    /// [`DrawError::Pixels`] for too few or too many levels, [`DrawError::Table`] if the device has too few colours for the
    /// table, and [`DrawError::Display`] for a level that its guns do not have.
    pub fn paint(&self, light: impl Into<Vec<Rgb<u8>>>) -> Result<Picture, DrawError> {
        let (light, lattice) = (light.into(), self.lattice(self.raster()?));
        let width = self.size.0 as usize;
        let pixel = |(x, y): (u32, u32)| light.get(y as usize * width + x as usize).copied();
        let samples = || lattice.pixels().filter_map(pixel).collect();
        self.draw(&light, samples)
    }

    /// Returns the pixels of which a colour table is made.
    fn lattice(&self, raster: Raster) -> Lattice {
        Lattice::new(raster, SAMPLES)
    }

    fn draw(&self, light: &[Rgb<u8>], samples: impl FnOnce() -> Vec<Rgb<u8>>) -> Result<Picture, DrawError> {
        let raster = self.raster()?;
        let (width, height) = self.size;
        let pixels = light.len();
        if pixels as u64 != u64::from(width) * u64::from(height) {
            return Err(DrawError::Pixels { pixels, width, height });
        }
        let Capabilities { colors, gun_max, .. } = self.device;
        match self.table {
            Table::None => Picture::direct(self.size, gun_max, light),
            Table::Tolerant => self.through(Adaptive::tolerant(colors, gun_max)?, Plain, light),
            Table::Adaptive => self.through(Adaptive::new(colors)?, Plain, light),
            Table::Uniform => self.through(Uniform::new(colors, gun_max)?, Plain, light),
            Table::Sampled => {
                let samples = samples();
                let mut memory = vec![Rgb::default(); samples.len()];
                let grid = self.lattice(raster).grid().width();
                let table = variance_cut(&mut memory, samples, grid, colors, gun_max)?;
                let columns = raster.width() as usize;
                match Diffusion::<Damped, _>::new(vec![Cell::default(); columns], columns) {
                    Ok(diffusion) if self.device.has_fine_pixels() => self.through(table, diffusion, light),
                    _ => self.through(table, Plain, light),
                }
            }
        }
    }

    fn through(
        &self,
        table: impl ColorTable,
        dither: impl Dither,
        light: &[Rgb<u8>],
    ) -> Result<Picture, DrawError> {
        let (width, height) = self.size;
        let paper = Paper::new(Capabilities { width, height, ..self.device })?;
        let mut painter = Painter::dithered(paper, table, dither)?;
        for (y, row) in (0..).zip(light.chunks(width as usize)) {
            painter.put_row(0, y, row.iter().copied())?;
        }
        painter.into_parts().0.into_picture()
    }

    /// Returns the raster of the picture.
    fn raster(&self) -> Result<Raster, DrawError> {
        let ((width, height), device) = (self.size, self.device);
        if width > device.width || height > device.height {
            return Err(DrawError::Larger { width, height, device });
        }
        Ok(Raster::new(width, height)?)
    }

    /// Returns the shape of the part of the screen that the picture fills, width over height.
    ///
    /// # Errors
    /// Those of [`Screen::raster`], and [`DrawError::Shape`].
    pub(crate) fn aspect(&self) -> Result<f64, DrawError> {
        self.raster()?;
        let ratio = |(width, height): (u32, u32)| f64::from(width) / f64::from(height);
        let whole = ratio((self.device.width, self.device.height));
        let aspect = ratio(self.size) / whole * ratio(self.device.aspect);
        // The shapes that the program admits.
        if (0.01..=100.0).contains(&aspect) { Ok(aspect) } else { Err(DrawError::Shape { aspect }) }
    }
}
