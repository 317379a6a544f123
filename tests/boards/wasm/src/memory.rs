//! A display that is memory.

use core::convert::Infallible;

use picture::stream::CAPABILITIES;
use rta_core::color::Rgb;
use rta_drivers::display::{Capabilities, Display, DriverError};

/// Pixels in a row.
const WIDTH: usize = picture::WIDTH as usize;
/// Pixels on the screen.
const AREA: usize = WIDTH * picture::HEIGHT as usize;
/// Room for 256 colours, each loaded once and by itself: first entry, number - 1, three levels.
const COLORS: usize = 256 * 5;

/// The pixels, and a record of all that was loaded into the colour table.
pub struct Memory {
    pixels: [u8; AREA],
    colors: [u8; COLORS],
    /// Bytes of `colors` in use.
    len: usize,
}

impl Memory {
    /// A black screen with an empty colour table.
    pub const fn new() -> Self {
        Self { pixels: [0; AREA], colors: [0; COLORS], len: 0 }
    }

    /// As new.
    pub fn clear(&mut self) {
        self.pixels.fill(0);
        self.len = 0;
    }

    /// The indices, row after row.
    pub fn pixels(&self) -> &[u8] {
        &self.pixels
    }

    /// The loads of the colour table, one after another.
    pub fn colors(&self) -> &[u8] {
        self.colors.get(..self.len).unwrap_or_default()
    }
}

impl Display for Memory {
    type Error = DriverError<Infallible>;

    fn capabilities(&self) -> Capabilities {
        CAPABILITIES
    }

    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error> {
        self.capabilities().check_colors(first, colors)?;
        // At most 256 colours passed the check; no colours leave no trace.
        let Some(Ok(last)) = colors.len().checked_sub(1).map(u8::try_from) else {
            return Ok(());
        };
        let len = self.len + 2 + 3 * colors.len();
        // Full only if colours were loaded again and again, which no table does.
        let Some(load) = self.colors.get_mut(self.len..len) else {
            return Err(DriverError::ColorTable { first, len: colors.len() });
        };
        let bytes = [first, last].into_iter().chain(colors.iter().flat_map(|c| [c.r, c.g, c.b]));
        for (byte, value) in load.iter_mut().zip(bytes) {
            *byte = value;
        }
        self.len = len;
        Ok(())
    }

    fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error> {
        self.capabilities().check_pixels(x, y, indices.len())?;
        // The check keeps this within the screen.
        let start = y as usize * WIDTH + x as usize;
        if let Some(row) = self.pixels.get_mut(start..start + indices.len()) {
            row.copy_from_slice(indices);
        }
        Ok(())
    }
}
