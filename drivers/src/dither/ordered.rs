//! Ordered dithering: thresholds in a fixed pattern.

use rta_core::color::Rgb;

use super::{DirectDither, Dither, entry};
use crate::guns::Guns;
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
/// For a display without a colour table, use [`Bayer`].
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

/// Ordered dithering for displays with direct colour: of 64 pixels that are given one light, as many get the level above it as it is 64ths
/// of a step above the level below. It needs no memory, and pixels may be drawn in any order. A gun that has all 256 levels is left as it is.
///
/// ```
/// use rta_core::color::Rgb;
/// use rta_drivers::dither::{Bayer, DirectDither};
/// use rta_drivers::guns::Three;
///
/// let gray = Rgb::new(100, 100, 100); // 12.157 of 31
/// let level = |i: u32| DirectDither::<Three>::levels(&mut Bayer, Rgb::new(31, 63, 31), (i % 8, i / 8), gray).r;
/// assert_eq!((0..64).map(|i| u32::from(level(i))).sum::<u32>(), 778); // 12.156 on average
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Bayer;

impl<G: Guns> DirectDither<G> for Bayer {
    fn levels(&mut self, gun_max: G::Each<u8>, (x, y): (u32, u32), light: G::Each<u8>) -> G::Each<u8> {
        // (order + 1/2) / 64, in 1/128.
        let threshold = 2 * u32::from(bayer(x, y)) + 1;
        G::zip(light, gun_max, |level, most| {
            // level * most / 255 + threshold / 128, rounded down: at most `most`, as the threshold is below 1.
            ((128 * u32::from(level) * u32::from(most) + 255 * threshold) / (255 * 128)).to_le_bytes()[0]
        })
    }
}
