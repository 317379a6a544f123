//! A display that keeps what it is sent.

use core::convert::Infallible;

use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_drivers::display::{Capabilities, Display, DriverError};

use crate::error::DrawError;
use crate::picture::Picture;

/// A display that keeps what it is sent, for firmware that is generic over its [`Display`]: give it this one in a test, and
/// compare the picture.
#[derive(Clone, Debug)]
pub struct Paper {
    capabilities: Capabilities,
    colors: Vec<Rgb<u8>>,
    indices: Vec<u8>,
}

impl Paper {
    /// Returns a display with these capabilities on which all pixels have index 0 and no entry of the colour table is loaded.
    ///
    /// # Errors
    /// [`DrawError::Tracer`] for a side that is 0 or longer than 65535.
    pub fn new(capabilities: Capabilities) -> Result<Self, DrawError> {
        let raster = Raster::new(capabilities.width, capabilities.height)?;
        let pixels = raster.width() as usize * raster.height() as usize;
        Ok(Self { capabilities, colors: Vec::new(), indices: vec![0; pixels] })
    }

    /// Returns the whole screen, with the entries of the colour table up to the last that was loaded.
    ///
    /// # Errors
    /// [`DrawError::Display`] if a pixel has an index whose entry was never loaded, and [`DrawError::Table`] for guns
    /// without levels.
    pub fn into_picture(self) -> Result<Picture, DrawError> {
        let Capabilities { width, height, gun_max, .. } = self.capabilities;
        Picture::indexed((width, height), gun_max, self.colors, self.indices)
    }
}

impl Display for Paper {
    type Error = DriverError<Infallible>;

    fn capabilities(&self) -> Capabilities {
        self.capabilities
    }

    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error> {
        self.capabilities.check_colors(first, colors)?;
        let first = usize::from(first);
        if self.colors.len() < first + colors.len() {
            self.colors.resize(first + colors.len(), Rgb::default());
        }
        self.colors.iter_mut().skip(first).zip(colors).for_each(|(entry, &color)| *entry = color);
        Ok(())
    }

    fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error> {
        self.capabilities.check_pixels(x, y, indices.len())?;
        self.capabilities.check_indices(indices)?;
        let first = y as usize * self.capabilities.width as usize + x as usize;
        self.indices.iter_mut().skip(first).zip(indices).for_each(|(pixel, &index)| *pixel = index);
        Ok(())
    }
}
