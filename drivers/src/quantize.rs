//! Quantisation: from the levels of three guns to an index of the colour table.
//!
//! There are three kinds of colour tables:
//!
//! | table | its entries | when they are known |
//! | --- | --- | --- |
//! | [`Uniform`] | a cube of evenly spaced levels | before any picture |
//! | [`Palette`] | means of the picture's colours, by [`variance_cut`] | before the picture is drawn: from samples of it, or from an earlier run, in flash; from all of its pixels by [`refined`], the best, where there is memory for them |
//! | [`Adaptive`], the thesis's | colours of the picture in the order in which they come | as the picture is drawn |
//!
//! Entry 0 is black in all of them. It is the background of a graPHIGS workstation, the border of a VGA screen (attribute
//! register 11h, overscan, is 0) and what cleared memory shows on all three devices. A table that put the first
//! colour of the picture there would tint all that is not drawn yet.
//!
//! The distance of two colours is the squared Euclidean one in levels, at most 3 * 255^2. Of equally near entries
//! the one of the lowest index is taken, so a picture always gives the same indices.
//!
//! A table says in which levels it takes light: [`ColorTable::light_max`]. The uniform table and the thesis's look a colour up as the
//! guns would show it; a palette takes all 8 bits, and so does everything that is [dithered](crate::dither).

mod adaptive;
mod cut;
mod k_means;
mod palette;
mod uniform;

use core::fmt;

use rta_core::color::Rgb;

pub use adaptive::Adaptive;
pub use cut::{BOXES_SIZE, MAX_SAMPLES, to_guns, variance_cut};
pub use k_means::refined;
pub use palette::Palette;
pub use uniform::Uniform;

/// The most entries that a table can have, because an index is one byte.
pub const MAX_COLORS: u16 = 256;

/// The samples of a picture that [`variance_cut`] needs for a palette within a few per cent of the best: 12 KiB of them. More make none
/// that the eye could tell.
pub const SAMPLES: usize = 4096;

/// Black, which is entry 0 of every table of this module.
pub const BACKGROUND: Rgb<u8> = Rgb::new(0, 0, 0);

/// A colour table that finds an entry for every colour. Colours are levels of 0..=[`light_max`](ColorTable::light_max).
pub trait ColorTable {
    /// Returns the highest level of the colours that this table takes and has, on a display whose guns have the levels
    /// 0..=`gun_max`: that one, or 255.
    fn light_max(&self, gun_max: u8) -> u8 {
        gun_max
    }

    /// Returns the index of the entry that stands for a colour of the picture. The table may append entries to do so; it never
    /// changes or removes one.
    fn index(&mut self, color: Rgb<u8>) -> u8;

    /// Returns the index of the entry nearest to a colour that the picture need not have, because dithering has changed it. A table that
    /// grows with the picture appends an entry for `pixel`, the picture's own colour, first, as [`ColorTable::index`] does.
    ///
    /// Both colours have 8 bits a gun, whatever [`ColorTable::light_max`] says: dithering loses its thresholds where they are rounded to
    /// few levels.
    fn index_near(&mut self, pixel: Rgb<u8>, color: Rgb<u8>, gun_max: u8) -> u8;

    /// Returns the entries so far, at least one and at most [`MAX_COLORS`]. They only grow in number, so the entries
    /// beyond the last length are the new ones; [`crate::painter::Painter`] loads those while the picture is drawn.
    fn entries(&self) -> &[Rgb<u8>];
}

impl<T: ColorTable + ?Sized> ColorTable for &mut T {
    fn light_max(&self, gun_max: u8) -> u8 {
        T::light_max(self, gun_max)
    }
    fn index(&mut self, color: Rgb<u8>) -> u8 {
        T::index(self, color)
    }
    fn index_near(&mut self, pixel: Rgb<u8>, color: Rgb<u8>, gun_max: u8) -> u8 {
        T::index_near(self, pixel, color, gun_max)
    }
    fn entries(&self) -> &[Rgb<u8>] {
        T::entries(self)
    }
}

/// Why a colour table cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TableError {
    /// The number of colours is outside the table's range.
    Colors {
        /// The number asked for.
        colors: u16,
        /// The fewest the table can have; the most is [`MAX_COLORS`].
        min: u16,
    },
    /// The guns have no level but 0.
    Guns,
    /// A colour table is to be made from so many samples: from 1 to [`MAX_SAMPLES`] are possible.
    Samples {
        /// The number of samples.
        samples: usize,
    },
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Colors { colors, min } => {
                write!(f, "a table of {colors} colours: from {min} to {MAX_COLORS} are possible")
            }
            Self::Guns => write!(f, "the guns have no level above 0"),
            Self::Samples { samples } => {
                write!(f, "a colour table of {samples} samples: from 1 to {MAX_SAMPLES} are possible")
            }
        }
    }
}

impl core::error::Error for TableError {}

/// Returns the squared distance of two colours in squared levels, 0..=195075.
pub fn distance(a: Rgb<u8>, b: Rgb<u8>) -> u32 {
    let square = |a: u8, b: u8| {
        let d = i32::from(a) - i32::from(b);
        (d * d).cast_unsigned()
    };
    square(a.r, b.r) + square(a.g, b.g) + square(a.b, b.b)
}

/// Returns the index of the entry nearest to `levels` and its squared distance (see [`distance`]). Of equally near
/// entries the one of the lowest index is taken. Only the first 256 entries are searched; if there are none the
/// answer is index 0 at a distance of [`u32::MAX`].
pub fn nearest(entries: &[Rgb<u8>], levels: Rgb<u8>) -> (u8, u32) {
    let mut best = (0, u32::MAX);
    for (index, &entry) in (0..=u8::MAX).zip(entries) {
        let d = distance(entry, levels);
        if d < best.1 {
            best = (index, d);
        }
    }
    best
}
