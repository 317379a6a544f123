//! The screen that a picture is drawn for: a device, the part of its raster that is drawn, and a colour table.

use rta_core::Scalar;
use rta_core::accelerator::Accelerator;
use rta_core::camera::Camera;
use rta_core::color::Rgb;
use rta_core::illumination::Illumination;
use rta_core::needs::Needs;
use rta_core::raster::{Pixels, Raster};
use rta_core::trace::Tracer;
use rta_drivers::display::Capabilities;
use rta_drivers::painter::Painter;
use rta_drivers::quantize::{Adaptive, ColorTable, Uniform};
use rta_drivers::{graphigs, pixrect, vga13h};

use crate::error::DrawError;
use crate::paper::Paper;
use crate::picture::Picture;

/// How the entries of the colour table are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Table {
    /// Built while the picture is drawn; what is nearly an entry shares it: [`Adaptive::tolerant`].
    #[default]
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
    /// A VGA in mode 13h: 320 x 200 pixels on a screen of 4 : 3, 256 colours, 64 levels a gun, the tolerant table.
    pub const VGA: Self = Self::of(vga13h::CAPABILITIES);
    /// An IBM RT PC with graPHIGS: 1024 x 1024 pixels, 128 colours, 16 levels a gun, the tolerant table.
    pub const GRAPHIGS: Self = Self::of(graphigs::CAPABILITIES);
    /// A SPARCstation with PIXRECT: 1152 x 900 pixels, 256 colours, 256 levels a gun, the tolerant table.
    pub const PIXRECT: Self = Self::of(pixrect::CAPABILITIES);

    /// Returns the whole screen of a device, with the tolerant table.
    #[must_use]
    pub const fn of(device: Capabilities) -> Self {
        Self { device, size: (device.width, device.height), table: Table::Tolerant }
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
    pub fn trace<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>>(
        &self,
        tracer: &Tracer<'_, S, M, N, STACK, A>,
        camera: &Camera<S>,
    ) -> Result<Picture, DrawError> {
        let raster = self.raster()?;
        let levels = Pixels::new(tracer, camera, raster).map(|light| light.levels(self.device.gun_max));
        self.paint(levels.collect::<Vec<_>>())
    }

    /// Draws levels 0..=`gun_max` of the device's guns, row by row from the upper left, through the colour table.
    ///
    /// # Errors
    /// [`DrawError::Larger`] for a picture larger than its device, [`DrawError::Tracer`] for a side that is 0 or longer than 65535,
    /// [`DrawError::Pixels`] for too few or too many levels, [`DrawError::Table`] if the device has too few colours for the
    /// table, and [`DrawError::Display`] for a level that its guns do not have.
    pub fn paint(&self, levels: impl Into<Vec<Rgb<u8>>>) -> Result<Picture, DrawError> {
        let (levels, raster) = (levels.into(), self.raster()?);
        let (width, height) = self.size;
        let Capabilities { colors, gun_max, .. } = self.device;
        let mut table: Box<dyn ColorTable> = match self.table {
            Table::None => return Picture::direct(self.size, gun_max, levels),
            Table::Tolerant => Box::new(Adaptive::tolerant(colors, gun_max)?),
            Table::Adaptive => Box::new(Adaptive::new(colors)?),
            Table::Uniform => Box::new(Uniform::new(colors, gun_max)?),
        };
        let pixels = levels.len();
        if pixels as u64 != u64::from(width) * u64::from(height) {
            return Err(DrawError::Pixels { pixels, width, height });
        }
        let paper = Paper::new(Capabilities { width, height, ..self.device })?;
        let mut painter = Painter::new(paper, &mut *table)?;
        for (y, row) in (0..).zip(levels.chunks(raster.width() as usize)) {
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
