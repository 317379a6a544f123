//! Displays with direct colour: each pixel holds its levels itself, and there is no colour table.
//!
//! A pixel is a [`DirectColor`], which says how many guns the display has and the highest level of each: 31, 63 and 31 with 16 bits a
//! pixel, 15 on a display of 16 greys. Light comes with 8 bits a gun, and [`DirectPainter`] rounds it, dithered or not; grey is the
//! [luma](crate::guns::luma) of light.
//!
//! | dithering | memory | |
//! | --- | --- | --- |
//! | [`Plain`] | none | each level is the nearest one |
//! | [`Bayer`](crate::dither::Bayer) | none | a fixed pattern, a step of each gun wide |
//! | [`Diffusion`](crate::dither::Diffusion) | 6 bytes a column, 2 for one gun ([`DirectCell`](crate::dither::DirectCell)) | the error of a pixel goes to its neighbours that are drawn later |
//!
//! There is no memory for a picture, and none for a row but that of diffusion: a display is handed an iterator over the pixels of a row, and
//! taking a pixel from it is what traces it. Only the rows that diffusion takes from right to left are traced before they are sent.
//!
//! ```
//! use rta_core::color::Rgb;
//! use rta_drivers::direct::{DirectDisplay, DirectPainter, Gray};
//! use rta_drivers::display::{DriverError, check_row};
//! use rta_drivers::dither::{Diffusion, DirectCell, FloydSteinberg};
//! use rta_drivers::guns::One;
//! # use core::convert::Infallible;
//!
//! /// A screen of 8 x 2 pixels in four greys.
//! #[derive(Default)]
//! struct Handheld([[u8; 8]; 2]);
//!
//! impl DirectDisplay for Handheld {
//!     type Color = Gray<3>;
//!     type Error = DriverError<Infallible>;
//!
//!     fn size(&self) -> (u32, u32) {
//!         (8, 2)
//!     }
//!
//!     fn put_row(
//!         &mut self,
//!         x: u32,
//!         y: u32,
//!         colors: impl ExactSizeIterator<Item = Gray<3>>,
//!     ) -> Result<(), Self::Error> {
//!         check_row(self.size(), x, y, colors.len())?;
//!         self.0[y as usize][x as usize..].iter_mut().zip(colors).for_each(|(pixel, Gray(level))| *pixel = level);
//!         Ok(())
//!     }
//! }
//!
//! let light = [Rgb::new(128, 128, 128); 8]; // 1.5 of 3
//! let mut painter = DirectPainter::new(Handheld::default());
//! painter.put_row(0, 0, light)?;
//! assert_eq!(painter.into_display().0[0], [2; 8]);
//!
//! let mut cells = [DirectCell::<One>::default(); 8];
//! let diffusion = Diffusion::<FloydSteinberg, _, One>::new(&mut cells[..], 8)?;
//! let mut painter = DirectPainter::dithered(Handheld::default(), diffusion);
//! painter.put_row(0, 0, light)?;
//! painter.put_row(0, 1, light)?;
//! assert_eq!(painter.into_display().0, [[2, 1, 2, 1, 2, 1, 2, 1], [1, 2, 1, 2, 1, 2, 1, 2]]);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use rta_core::color::Rgb;

use crate::dither::{DirectDither, Plain};
use crate::guns::{Guns, One, Three};

/// A colour as a pixel of a display with direct colour holds it.
pub trait DirectColor: Copy {
    /// How many guns the display has.
    type Guns: Guns;

    /// The highest level of each gun, 1..=255. The lowest is 0; levels are linear.
    const MAX: <Self::Guns as Guns>::Each<u8>;

    /// Returns the colour of the given level of each gun, 0..=[`MAX`](DirectColor::MAX).
    fn from_levels(levels: <Self::Guns as Guns>::Each<u8>) -> Self;
}

/// A colour as levels of red, green and blue, of which `R`, `G` and `B` are the highest: `Levels<31, 63, 31>` has 16 bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Levels<const R: u8, const G: u8, const B: u8>(pub Rgb<u8>);

impl<const R: u8, const G: u8, const B: u8> DirectColor for Levels<R, G, B> {
    type Guns = Three;
    const MAX: Rgb<u8> = Rgb::new(R, G, B);
    fn from_levels(levels: Rgb<u8>) -> Self {
        Self(levels)
    }
}

/// A grey, of whose levels `MAX` is the highest: 15 for 16 greys, 1 for black and white.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gray<const MAX: u8>(pub u8);

impl<const MAX: u8> DirectColor for Gray<MAX> {
    type Guns = One;
    const MAX: u8 = MAX;
    fn from_levels(level: u8) -> Self {
        Self(level)
    }
}

/// A display without a colour table, written row by row.
pub trait DirectDisplay {
    /// What a pixel holds.
    type Color: DirectColor;
    /// The error of all methods. The displays of this crate use [`DriverError`](crate::display::DriverError).
    type Error;

    /// Returns pixels of a row and number of rows. The answer never changes during the life of the value.
    fn size(&self) -> (u32, u32);

    /// Writes `colors` into row `y`, from column `x` to the right. (0, 0) is the upper left pixel.
    ///
    /// # Errors
    /// Fails for pixels outside the screen, of which none is written then ([`check_row`](crate::display::check_row)), and for what the device
    /// reports.
    fn put_row(
        &mut self,
        x: u32,
        y: u32,
        colors: impl ExactSizeIterator<Item = Self::Color>,
    ) -> Result<(), Self::Error>;

    /// Makes visible all pixels sent so far. A device that shows them at once keeps the default, which does nothing.
    ///
    /// # Errors
    /// Fails where the device reports an error.
    fn update(&mut self) -> Result<(), Self::Error> {
        Ok(())
    }
}

impl<D: DirectDisplay> DirectDisplay for &mut D {
    type Color = D::Color;
    type Error = D::Error;
    fn size(&self) -> (u32, u32) {
        D::size(self)
    }
    fn put_row(
        &mut self,
        x: u32,
        y: u32,
        colors: impl ExactSizeIterator<Item = Self::Color>,
    ) -> Result<(), Self::Error> {
        D::put_row(self, x, y, colors)
    }
    fn update(&mut self) -> Result<(), Self::Error> {
        D::update(self)
    }
}

/// The guns of a display.
type GunsOf<D> = <<D as DirectDisplay>::Color as DirectColor>::Guns;

/// Puts light on a display with direct colour: rounds it to the display's levels and writes the pixels. The head of the
/// [module](crate::direct) has an example.
#[derive(Clone, Debug)]
pub struct DirectPainter<D, H = Plain> {
    display: D,
    dither: H,
}

impl<D: DirectDisplay> DirectPainter<D> {
    /// Takes a display. Nothing is dithered.
    pub const fn new(display: D) -> Self {
        Self { display, dither: Plain }
    }
}

impl<D: DirectDisplay, H: DirectDither<GunsOf<D>>> DirectPainter<D, H> {
    /// Takes a display and a way of dithering.
    pub const fn dithered(display: D, dither: H) -> Self {
        Self { display, dither }
    }

    /// Draws pixels of row `y` from column `x` to the right, given as light of 8 bits a gun. Any part of a row may be drawn by one call,
    /// unless [`Diffusion`](crate::dither::Diffusion) asks for whole rows in order. The dithering may take the pixels from the end.
    ///
    /// # Errors
    /// Those of [`DirectDisplay::put_row`]; some of the pixels may be drawn then.
    pub fn put_row(
        &mut self,
        x: u32,
        y: u32,
        light: impl IntoIterator<Item = Rgb<u8>, IntoIter: DoubleEndedIterator + ExactSizeIterator>,
    ) -> Result<(), D::Error> {
        let mut light = light.into_iter();
        let len = light.len();
        let drawn = self.dither.start_row(x, y, len);
        if drawn {
            // No screen has a column u32::MAX, so the display refuses a row after saturation.
            let mut column = x.saturating_add(u32::try_from(len).unwrap_or(u32::MAX));
            while let Some(light) = light.next_back() {
                column = column.saturating_sub(1);
                self.dither.levels(D::Color::MAX, (column, y), GunsOf::<D>::of_light(light));
            }
        }
        let dither = &mut self.dither;
        let mut column = x;
        let colors = (0..len).map(|_| {
            let levels = match if drawn { None } else { light.next() } {
                Some(light) => dither.levels(D::Color::MAX, (column, y), GunsOf::<D>::of_light(light)),
                None => dither.drawn(column),
            };
            column = column.saturating_add(1);
            D::Color::from_levels(levels)
        });
        self.display.put_row(x, y, colors)
    }

    /// Makes visible all that was drawn so far.
    ///
    /// # Errors
    /// Those of [`DirectDisplay::update`].
    pub fn update(&mut self) -> Result<(), D::Error> {
        self.display.update()
    }
}

impl<D, H> DirectPainter<D, H> {
    /// Borrows the display.
    pub const fn display(&self) -> &D {
        &self.display
    }

    /// Gives the display back.
    pub fn into_display(self) -> D {
        self.display
    }
}
