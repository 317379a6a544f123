//! Ordered dithering: thresholds in a fixed pattern.

use rta_core::color::Rgb;

use super::{Dither, entry};
use crate::display::reduce;
use crate::quantize::{ColorTable, Uniform};

/// Returns the place of a pixel in the order in which an 8 x 8 pattern fills, 0..=63: the matrix of B. Bayer, "An Optimum Method for
/// Two-Level Rendition of Continuous-Tone Pictures", IEEE International Conference on Communications, 1973, repeated over the plane.
pub const fn bayer(x: u32, y: u32) -> u8 {
    // From the lowest bit of the place, which counts most, to the third.
    let (crossed, mut order, mut bit) = (x ^ y, 0, 0);
    while bit < 3 {
        order = 4 * order + 2 * (crossed >> bit & 1) + (y >> bit & 1);
        bit += 1;
    }
    order.to_le_bytes()[0]
}

/// Returns a colour, 8 bits a gun, moved by less than half a `step` up or down by the pattern of [`bayer`]: rounded to levels that are
/// a step apart, a constant colour between two of them becomes a mixture of both.
pub fn ordered(light: Rgb<u8>, x: u32, y: u32, step: Rgb<u8>) -> Rgb<u8> {
    // (order + 1/2) / 64 - 1/2, in 1/128.
    let threshold = 2 * i16::from(bayer(x, y)) + 1 - 64;
    light.zip(step, |level, step| {
        // The product is at most 63 * 255 in size.
        let moved = i16::from(level) + ((threshold * i16::from(step)) >> 7);
        moved.clamp(0, 255).to_le_bytes()[0]
    })
}

/// Ordered dithering for a table of evenly spaced levels. It needs no memory, and pixels may be drawn in any order.
///
/// For a display without a colour table, use [`Ordered::direct`].
#[derive(Clone, Copy, Debug)]
pub struct Ordered {
    /// The distance of neighbouring levels of each gun, 8 bits a gun.
    step: Rgb<u8>,
}

impl Ordered {
    /// Returns the dithering for a table whose levels of each gun are `step` apart, 8 bits a gun.
    pub const fn new(step: Rgb<u8>) -> Self {
        Self { step }
    }

    /// Returns the dithering for a uniform table.
    pub fn uniform(table: &Uniform) -> Self {
        Self::new(table.sides().map(|side| u8::MAX / (side - 1).max(1)))
    }

    /// Returns the levels, 0..=`gun_max` of each gun, for a pixel of a display with direct colour: 31, 63 and 31 for 16 bits a pixel.
    /// `light` is its colour in 8 bits a gun.
    ///
    /// ```
    /// use rta_core::color::Rgb;
    /// use rta_drivers::dither::Ordered;
    ///
    /// let gray = Rgb::new(100, 100, 100); // 12.2 of 31
    /// let levels = (0..64).map(|i| Ordered::direct(gray, i % 8, i / 8, Rgb::new(31, 63, 31)).r);
    /// assert_eq!(levels.map(u32::from).sum::<u32>(), 776); // 12.1 on average
    /// ```
    pub fn direct(light: Rgb<u8>, x: u32, y: u32, gun_max: Rgb<u8>) -> Rgb<u8> {
        let step = gun_max.map(|most| u8::MAX / most.max(1));
        ordered(light, x, y, step).zip(gun_max, reduce)
    }
}

impl Dither for Ordered {
    fn index<T: ColorTable + ?Sized>(
        &mut self,
        table: &mut T,
        gun_max: u8,
        (x, y): (u32, u32),
        light: Rgb<u8>,
    ) -> u8 {
        entry(table, gun_max, light, ordered(light, x, y, self.step)).0
    }
}
