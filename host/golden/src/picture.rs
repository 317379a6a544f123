//! A picture as it is tested: what a display shows.

use std::io;

use rta_core::color::Rgb;
use rta_core::raster::Raster;
use rta_drivers::checksum::{Checksum, Unseen};
use rta_drivers::display::{Capabilities, Display, expand};
use rta_drivers::quantize::TableError;

use crate::error::DrawError;
use crate::file::{encode, registers};

/// A picture as a display shows it: levels of three guns, with a colour table or without. Pixels go row by row from the upper
/// left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    raster: Raster,
    /// The highest level of a gun, at least 1.
    gun_max: u8,
    pixels: Pixels,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Pixels {
    Indexed { colors: Vec<Rgb<u8>>, indices: Vec<u8> },
    Direct(Vec<Rgb<u8>>),
}

impl Picture {
    /// Returns a picture of `size` (width and height, each 1 to 65535) with a colour table: `colors` are its entries as far as
    /// they are loaded, up to 256, in levels 0..=`gun_max` of the guns, and `indices` has one of them for each pixel.
    ///
    /// ```
    /// use rta_golden::{Picture, Rgb};
    ///
    /// // The frame buffer of a port, and the registers of its DAC.
    /// let picture = Picture::indexed((2, 2), 63, [Rgb::new(0, 0, 0), Rgb::new(63, 0, 0)], [0, 1, 1, 0])?;
    /// assert_eq!(picture.hash(), 0x4193_8414_04d0_cbf5);
    /// # Ok::<(), rta_golden::DrawError>(())
    /// ```
    ///
    /// # Errors
    /// [`DrawError::Tracer`] for a side that is 0 or too long, [`DrawError::Pixels`] for too few or too many pixels,
    /// [`DrawError::Table`] for guns without levels, and [`DrawError::Display`] for a level above `gun_max`, an index without an
    /// entry, or more than 256 entries.
    pub fn indexed(
        size: (u32, u32),
        gun_max: u8,
        colors: impl Into<Vec<Rgb<u8>>>,
        indices: impl Into<Vec<u8>>,
    ) -> Result<Self, DrawError> {
        let (colors, indices) = (colors.into(), indices.into());
        let raster = raster(size, gun_max, indices.len())?;
        let entries = u16::try_from(colors.len()).unwrap_or(u16::MAX).min(256);
        let screen = screen(raster, entries, gun_max);
        screen.check_colors(0, &colors)?;
        screen.check_indices(&indices)?;
        Ok(Self { raster, gun_max, pixels: Pixels::Indexed { colors, indices } })
    }

    /// Returns a picture of `size` (width and height, each 1 to 65535) without a colour table: `levels` has red, green and blue
    /// of each pixel, each 0..=`gun_max`.
    ///
    /// # Errors
    /// [`DrawError::Tracer`] for a side that is 0 or too long, [`DrawError::Pixels`] for too few or too many pixels,
    /// [`DrawError::Table`] for guns without levels, and [`DrawError::Display`] for a level above `gun_max`.
    pub fn direct(size: (u32, u32), gun_max: u8, levels: impl Into<Vec<Rgb<u8>>>) -> Result<Self, DrawError> {
        let levels = levels.into();
        let raster = raster(size, gun_max, levels.len())?;
        let screen = screen(raster, 256, gun_max);
        levels.iter().try_for_each(|color| screen.check_colors(0, core::slice::from_ref(color)))?;
        Ok(Self { raster, gun_max, pixels: Pixels::Direct(levels) })
    }

    /// Returns the number of pixels in a row, and of rows.
    #[must_use]
    pub const fn size(&self) -> (u32, u32) {
        (self.raster.width(), self.raster.height())
    }

    /// Returns the hash of the picture: FNV-1a of 64 bits over the indices and the entries of the colour table, as
    /// [`Checksum`] has it. It is the number that `rta hash` prints for a picture with these. Of a picture without a colour table,
    /// which `rta hash` does not draw, it is that of the levels red, green and blue in place of indices.
    #[must_use]
    pub fn hash(&self) -> u64 {
        // Nothing but bytes in their order goes into the hash, and this screen takes them all.
        let mut sum = Checksum::new(Unseen(screen(self.raster, 256, u8::MAX)));
        let columns = self.raster.width() as usize;
        let (colors, bytes) = match &self.pixels {
            Pixels::Indexed { colors, indices } => (colors.as_slice(), indices),
            Pixels::Direct(levels) => (&[][..], &registers(levels.iter().copied())),
        };
        let sent = bytes.chunks(columns).try_for_each(|row| sum.put_pixels(0, 0, row));
        let sent = sent.and_then(|()| sum.set_colors(0, colors));
        debug_assert!(sent.is_ok(), "a screen of 256 colours takes all");
        sum.value()
    }

    /// Returns the colours that are seen, with 8 bits a gun.
    pub(crate) fn colors(&self) -> Vec<Rgb<u8>> {
        let seen = |levels: &Rgb<u8>| levels.map(|level| expand(level, self.gun_max));
        match &self.pixels {
            Pixels::Indexed { colors, indices } => {
                let color = |index: &u8| colors.get(usize::from(*index)).map(seen).unwrap_or_default();
                indices.iter().map(color).collect()
            }
            Pixels::Direct(levels) => levels.iter().map(seen).collect(),
        }
    }

    /// Returns the picture as a PNG, indexed if it has a colour table.
    pub(crate) fn png(&self) -> io::Result<Vec<u8>> {
        match &self.pixels {
            Pixels::Indexed { colors, indices } => {
                let table = colors.iter().map(|color| color.map(|level| expand(level, self.gun_max)));
                encode(self.size(), Some(registers(table)), indices)
            }
            Pixels::Direct(_) => encode(self.size(), None, &registers(self.colors())),
        }
    }
}

/// Returns the raster of a picture that has `pixels` pixels.
fn raster((width, height): (u32, u32), gun_max: u8, pixels: usize) -> Result<Raster, DrawError> {
    let raster = Raster::new(width, height)?;
    if gun_max == 0 {
        return Err(TableError::Guns.into());
    }
    let wanted = u64::from(width) * u64::from(height);
    if pixels as u64 != wanted {
        return Err(DrawError::Pixels { pixels, width, height });
    }
    Ok(raster)
}

fn screen(raster: Raster, colors: u16, gun_max: u8) -> Capabilities {
    Capabilities { width: raster.width(), height: raster.height(), colors, gun_max, aspect: (1, 1) }
}
