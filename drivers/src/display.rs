//! A display as the tracer's user sees it: a colour table and a raster of indices.
//!
//! To drive another display implement [`Display`]: four methods, one of them with a default. If the
//! device can be read, implement [`ReadBack`] too: pictures can then be saved from the device itself,
//! and the tests that every driver here passes can be run on yours.

use core::fmt;

use rta_core::color::Rgb;

/// What a display can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capabilities {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Entries of the colour table, 1..=256: the colours shown at once.
    pub colors: u16,
    /// The highest level of a gun: 63 for a 6-bit DAC. The lowest is 0; levels are linear.
    pub gun_max: u8,
    /// Shape of the screen, width to height. Pixels are not square where it differs from the raster's.
    pub aspect: (u32, u32),
}

impl Capabilities {
    /// Checks that `len` pixels from (`x`, `y`) to the right lie on the screen.
    ///
    /// # Errors
    /// [`DriverError::OutOfBounds`].
    pub fn check_pixels<E>(&self, x: u32, y: u32, len: usize) -> Result<(), DriverError<E>> {
        let room = self.width.checked_sub(x).and_then(|room| usize::try_from(room).ok());
        match room {
            Some(room) if y < self.height && len <= room => Ok(()),
            _ => Err(DriverError::OutOfBounds { x, y, len }),
        }
    }

    /// Checks that `len` entries from `first` up are in the colour table.
    ///
    /// # Errors
    /// [`DriverError::ColorTable`].
    pub fn check_entries<E>(&self, first: u8, len: usize) -> Result<(), DriverError<E>> {
        let room = usize::from(self.colors.saturating_sub(u16::from(first)));
        if len <= room { Ok(()) } else { Err(DriverError::ColorTable { first, len }) }
    }

    /// Checks that `colors` fit the table from `first` up and that their levels fit the guns.
    ///
    /// # Errors
    /// [`DriverError::ColorTable`], [`DriverError::Level`].
    pub fn check_colors<E>(&self, first: u8, colors: &[Rgb<u8>]) -> Result<(), DriverError<E>> {
        self.check_entries(first, colors.len())?;
        match colors.iter().flat_map(|c| [c.r, c.g, c.b]).find(|&level| level > self.gun_max) {
            None => Ok(()),
            Some(level) => Err(DriverError::Level { level, max: self.gun_max }),
        }
    }

    /// Checks that every index names an entry of the colour table.
    ///
    /// # Errors
    /// [`DriverError::Index`].
    pub fn check_indices<E>(&self, indices: &[u8]) -> Result<(), DriverError<E>> {
        match indices.iter().find(|&&index| u16::from(index) >= self.colors) {
            None => Ok(()),
            Some(&index) => Err(DriverError::Index { index }),
        }
    }
}

/// A display with a colour table.
pub trait Display {
    /// What can go wrong. The drivers of this crate use [`DriverError`].
    type Error: core::error::Error;

    /// What the display can show. Constant for the life of the value.
    fn capabilities(&self) -> Capabilities;

    /// Loads `colors` into the colour table, from entry `first` up.
    ///
    /// # Errors
    /// Entries beyond the table or levels beyond the guns; nothing is loaded then.
    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error>;

    /// Writes `indices` into one row, from column `x` to the right. (0, 0) is the upper left pixel.
    ///
    /// # Errors
    /// Pixels outside the screen, or indices beyond the colour table; nothing is written then.
    fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error>;

    /// Makes visible all that was set and put so far. Devices that show at once need not implement it.
    ///
    /// # Errors
    /// Those of the device.
    fn update(&mut self) -> Result<(), Self::Error> {
        Ok(())
    }
}

/// A display that can tell what it holds.
pub trait ReadBack: Display {
    /// Reads entries of the colour table, from `first` up.
    ///
    /// # Errors
    /// Entries beyond the table.
    fn read_colors(&mut self, first: u8, colors: &mut [Rgb<u8>]) -> Result<(), Self::Error>;

    /// Reads the indices of one row, from column `x` to the right.
    ///
    /// # Errors
    /// Pixels outside the screen.
    fn read_pixels(&mut self, x: u32, y: u32, indices: &mut [u8]) -> Result<(), Self::Error>;
}

impl<D: Display + ?Sized> Display for &mut D {
    type Error = D::Error;
    fn capabilities(&self) -> Capabilities {
        D::capabilities(self)
    }
    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error> {
        D::set_colors(self, first, colors)
    }
    fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error> {
        D::put_pixels(self, x, y, indices)
    }
    fn update(&mut self) -> Result<(), Self::Error> {
        D::update(self)
    }
}

impl<D: ReadBack + ?Sized> ReadBack for &mut D {
    fn read_colors(&mut self, first: u8, colors: &mut [Rgb<u8>]) -> Result<(), Self::Error> {
        D::read_colors(self, first, colors)
    }
    fn read_pixels(&mut self, x: u32, y: u32, indices: &mut [u8]) -> Result<(), Self::Error> {
        D::read_pixels(self, x, y, indices)
    }
}

/// What the drivers refuse, and what their device reports (`E`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DriverError<E> {
    /// Pixels outside the screen.
    OutOfBounds {
        /// First column.
        x: u32,
        /// Row.
        y: u32,
        /// Number of pixels.
        len: usize,
    },
    /// Entries beyond the colour table.
    ColorTable {
        /// First entry.
        first: u8,
        /// Number of entries.
        len: usize,
    },
    /// A level that the guns do not have.
    Level {
        /// The level asked for.
        level: u8,
        /// The highest there is.
        max: u8,
    },
    /// A pixel's index that the colour table does not have.
    Index {
        /// The index asked for.
        index: u8,
    },
    /// The device's own error.
    Device(E),
}

impl<E: fmt::Display> fmt::Display for DriverError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfBounds { x, y, len } => write!(f, "{len} pixels at ({x}, {y}) leave the screen"),
            Self::ColorTable { first, len } => {
                write!(f, "{len} colours from entry {first} leave the colour table")
            }
            Self::Level { level, max } => write!(f, "gun level {level} is above {max}"),
            Self::Index { index } => write!(f, "the colour table has no entry {index}"),
            Self::Device(e) => e.fmt(f),
        }
    }
}

impl<E: core::error::Error + 'static> core::error::Error for DriverError<E> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Device(e) => Some(e),
            _ => None,
        }
    }
}

impl<E> From<E> for DriverError<E> {
    fn from(e: E) -> Self {
        Self::Device(e)
    }
}

/// The 8-bit level nearest to `level` of a gun whose highest level is `max`: what a linear (analogue)
/// DAC shows, for pictures with 8 bits a register. `max` must not be 0; levels above it give 255.
///
/// ```
/// use rta_drivers::display::expand;
/// assert_eq!([expand(0, 63), expand(1, 63), expand(32, 63), expand(63, 63)], [0, 4, 130, 255]);
/// ```
pub const fn expand(level: u8, max: u8) -> u8 {
    if level >= max {
        return 255;
    }
    let (level, max) = (level as u32, max as u32);
    // At most (2 * 254 * 255 + 255) / (2 * 255) = 254 for level < max.
    ((2 * 255 * level + max) / (2 * max)).to_le_bytes()[0]
}
