//! Dithering: what rounding to the colour table loses of a pixel is made up for by the pixels around it, so that from a distance many
//! colours seem to be more.
//!
//! | dithering | memory | |
//! | --- | --- | --- |
//! | [`Plain`] | none | none: each pixel gets its nearest entry |
//! | [`Diffusion`] | 4 bytes for each pixel of a row | the error of a pixel goes to its neighbours that are drawn later |
//! | [`Ordered`] | none | a fixed pattern of thresholds |
//!
//! Displays without a colour table have their own trait, [`DirectDither`], and the same three ways; there the pattern is [`Bayer`].
//!
//! Which is best depends on the table and on how large the pixels are to the eye. With a table made for the picture
//! ([`crate::quantize::variance_cut`]), none is best on mode 13h at its own distance, where each pixel is seen, and diffusion on screens
//! with finer pixels and few levels of the guns. With a uniform table, ordered dithering or diffusion of all of the error is far better
//! than none on fine pixels. Ordered dithering with an irregular table is always worse than none.
//!
//! All of it is integers, so every processor draws the same picture.

mod diffusion;
mod ordered;

use rta_core::color::Rgb;

use crate::display::{expand, reduce};
use crate::guns::Guns;
use crate::quantize::ColorTable;

pub use diffusion::{Cell, Column, Damped, Diffusion, DirectCell, DitherError, FloydSteinberg, Weights};
pub use ordered::{Bayer, Ordered, bayer, ordered};

/// A way of dithering, as [`Painter`](crate::painter::Painter) uses it.
pub trait Dither {
    /// Returns the highest level of the light that a pixel is given as, for a table and a display's guns with levels 0..=`gun_max`.
    fn light_max<T: ColorTable + ?Sized>(&self, table: &T, gun_max: u8) -> u8 {
        let _ = (table, gun_max);
        u8::MAX
    }

    /// Begins a row of `len` pixels from column `x` of row `y`. Returns whether its pixels are to come from right to left; then
    /// [`Dither::drawn`] tells their entries after the last one.
    fn start_row(&mut self, x: u32, y: u32, len: usize) -> bool {
        let _ = (x, y, len);
        false
    }

    /// Returns the entry for the next pixel of the row, which is at column `x` of row `y`.
    fn index<T: ColorTable + ?Sized>(
        &mut self,
        table: &mut T,
        gun_max: u8,
        place: (u32, u32),
        light: Rgb<u8>,
    ) -> u8;

    /// Returns the entry of the pixel at column `x` of a row that came from right to left.
    fn drawn(&self, x: u32) -> u8 {
        let _ = x;
        0
    }
}

/// A way of dithering for a display with direct colour, as [`DirectPainter`](crate::direct::DirectPainter) uses it.
pub trait DirectDither<G: Guns> {
    /// Begins a row of `len` pixels from column `x` of row `y`. Returns whether its pixels are to come from right to left; then
    /// [`DirectDither::drawn`] tells their levels after the last one.
    fn start_row(&mut self, x: u32, y: u32, len: usize) -> bool {
        let _ = (x, y, len);
        false
    }

    /// Returns the levels, 0..=`gun_max` of each gun, for the next pixel of the row, which is at column `x` of row `y`. `light` has 8 bits
    /// a gun.
    fn levels(&mut self, gun_max: G::Each<u8>, place: (u32, u32), light: G::Each<u8>) -> G::Each<u8>;

    /// Returns the levels of the pixel at column `x` of a row that came from right to left.
    fn drawn(&self, x: u32) -> G::Each<u8> {
        let _ = x;
        G::Each::default()
    }
}

/// No dithering: each pixel gets the entry, or the levels, nearest to it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Plain;

impl Dither for Plain {
    fn light_max<T: ColorTable + ?Sized>(&self, table: &T, gun_max: u8) -> u8 {
        table.light_max(gun_max)
    }

    fn index<T: ColorTable + ?Sized>(
        &mut self,
        table: &mut T,
        _gun_max: u8,
        _place: (u32, u32),
        light: Rgb<u8>,
    ) -> u8 {
        table.index(light)
    }
}

impl<G: Guns> DirectDither<G> for Plain {
    fn levels(&mut self, gun_max: G::Each<u8>, _place: (u32, u32), light: G::Each<u8>) -> G::Each<u8> {
        G::zip(light, gun_max, reduce)
    }
}

/// Returns the index of the entry nearest to `wanted` and that entry, both colours in 8 bits a gun, for a pixel whose own colour is
/// `pixel`.
fn entry<T: ColorTable + ?Sized>(
    table: &mut T,
    gun_max: u8,
    pixel: Rgb<u8>,
    wanted: Rgb<u8>,
) -> (u8, Rgb<u8>) {
    let index = table.index_near(pixel, wanted, gun_max);
    let entry = table.entries().get(usize::from(index)).copied().unwrap_or_default();
    let most = table.light_max(gun_max);
    (index, if most == u8::MAX { entry } else { entry.map(|level| expand(level, most)) })
}
