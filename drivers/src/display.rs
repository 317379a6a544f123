//! A display as its user sees it: a colour table, and a raster of indices into it.
//!
//! To drive another display implement [`Display`], which has four methods, one of them with a default. If the device
//! can be read, implement [`ReadBack`] too: then pictures can be saved from the device itself, and the tests that
//! every driver of this crate passes (`tests/drivers/conformance.rs`) can be run on yours.

use core::fmt;

use rta_core::color::Rgb;

/// What a display can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capabilities {
    /// Pixels of a row.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
    /// Entries of the colour table, 1..=256: how many colours are shown at once.
    pub colors: u16,
    /// The highest level of each gun (red, green, blue): 63 for a DAC of 6 bits. The lowest is 0; levels are linear.
    pub gun_max: u8,
    /// Shape of the screen as width to height, (4, 3) for example. Where it differs from `width` to `height`, pixels
    /// are not square.
    pub aspect: (u32, u32),
}

impl Capabilities {
    /// Returns whether the pixels are so fine, at the distance at which one sits before a screen, that the eye mixes neighbours: then
    /// error diffusion looks better than none. It holds for the workstations' screens of 1000 columns, 35 pixels a degree or more, and not
    /// for the 320 of mode 13h, which are 13.
    pub const fn has_fine_pixels(&self) -> bool {
        self.width >= 640
    }

    /// Checks that `len` pixels from (`x`, `y`) to the right lie on the screen.
    ///
    /// # Errors
    /// [`DriverError::OutOfBounds`] if one does not.
    pub fn check_pixels<E>(&self, x: u32, y: u32, len: usize) -> Result<(), DriverError<E>> {
        check_row((self.width, self.height), x, y, len)
    }

    /// Checks that the colour table has `len` entries from `first` up.
    ///
    /// # Errors
    /// [`DriverError::ColorTable`] if one is missing.
    pub fn check_entries<E>(&self, first: u8, len: usize) -> Result<(), DriverError<E>> {
        let room = usize::from(self.colors.saturating_sub(u16::from(first)));
        if len <= room { Ok(()) } else { Err(DriverError::ColorTable { first, len }) }
    }

    /// Checks that the colour table has an entry for each of `colors` from `first` up and that their levels are at
    /// most `gun_max`.
    ///
    /// # Errors
    /// [`DriverError::ColorTable`] for a missing entry, else [`DriverError::Level`] for the first level that is too
    /// high.
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
    /// [`DriverError::Index`] for the first that does not.
    pub fn check_indices<E>(&self, indices: &[u8]) -> Result<(), DriverError<E>> {
        match indices.iter().find(|&&index| u16::from(index) >= self.colors) {
            None => Ok(()),
            Some(&index) => Err(DriverError::Index { index }),
        }
    }
}

/// Checks that `len` pixels from (`x`, `y`) to the right lie on a screen of the given width and height.
///
/// # Errors
/// [`DriverError::OutOfBounds`] if one does not.
pub fn check_row<E>((width, height): (u32, u32), x: u32, y: u32, len: usize) -> Result<(), DriverError<E>> {
    let room = width.checked_sub(x).and_then(|room| usize::try_from(room).ok());
    match room {
        Some(room) if y < height && len <= room => Ok(()),
        _ => Err(DriverError::OutOfBounds { x, y, len }),
    }
}

/// A display with a colour table.
pub trait Display {
    /// The error of all methods. The drivers of this crate use [`DriverError`].
    type Error: core::error::Error;

    /// Returns what the display can show. The answer never changes during the life of the value.
    fn capabilities(&self) -> Capabilities;

    /// Loads `colors` into the colour table, from entry `first` up. Levels are 0..=`gun_max` of the capabilities.
    ///
    /// # Errors
    /// Fails for entries beyond the table, levels beyond the guns, and what the device reports. In the first two cases
    /// nothing is loaded.
    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error>;

    /// Writes `indices` into row `y`, from column `x` to the right. (0, 0) is the upper left pixel.
    ///
    /// # Errors
    /// Fails for pixels outside the screen, indices beyond the colour table, and what the device reports. In the first
    /// two cases nothing is written.
    fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error>;

    /// Makes visible all colours and pixels sent so far. A device that shows them at once keeps the default, which does
    /// nothing.
    ///
    /// # Errors
    /// Fails where the device reports an error.
    fn update(&mut self) -> Result<(), Self::Error> {
        Ok(())
    }
}

/// A display whose colour table and pixels can be read.
pub trait ReadBack: Display {
    /// Reads as many entries of the colour table as `colors` is long, from `first` up.
    ///
    /// # Errors
    /// Fails for entries beyond the table and for what the device reports.
    fn read_colors(&mut self, first: u8, colors: &mut [Rgb<u8>]) -> Result<(), Self::Error>;

    /// Reads as many indices of row `y` as `indices` is long, from column `x` to the right.
    ///
    /// # Errors
    /// Fails for pixels outside the screen and for what the device reports.
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

/// The error of a driver: what it refuses itself, or what its device reports (`E`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DriverError<E> {
    /// Pixels outside the screen were asked for.
    OutOfBounds {
        /// Column of the first pixel.
        x: u32,
        /// Row of the pixels.
        y: u32,
        /// Number of pixels.
        len: usize,
    },
    /// Entries beyond the colour table were asked for.
    ColorTable {
        /// First entry.
        first: u8,
        /// Number of entries.
        len: usize,
    },
    /// A colour has a level that the guns do not have.
    Level {
        /// The level asked for.
        level: u8,
        /// The highest level of the guns.
        max: u8,
    },
    /// The index of a pixel names no entry of the colour table.
    Index {
        /// The index asked for.
        index: u8,
    },
    /// The error that the device reports.
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

/// Converts `level`, 0..=`max`, of a gun to the nearest of the levels 0..=255, for picture files with 8 bits a
/// register. The scale is linear, as that of a DAC. Levels of `max` and above give 255; `max` is at least 1.
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

/// Converts `level`, 0..=255, to the nearest of the levels 0..=`max` of a gun. It undoes [`expand`]; `max` is at least 1.
///
/// ```
/// use rta_drivers::display::{expand, reduce};
/// assert_eq!([reduce(0, 63), reduce(2, 63), reduce(3, 63), reduce(255, 63)], [0, 0, 1, 63]);
/// assert!((0..=63).all(|level| reduce(expand(level, 63), 63) == level));
/// ```
pub const fn reduce(level: u8, max: u8) -> u8 {
    // At most (2 * 255 * max + 255) / 510 = max.
    ((2 * level as u32 * max as u32 + 255) / 510).to_le_bytes()[0]
}
