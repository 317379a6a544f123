//! A checksum of a picture, by which the port to another machine is tested.
//!
//! [`Checksum`] is a display that wraps another one and hashes what is sent to it. Run the port with it and compare the
//! value with the one that `rta hash` prints on a desktop for the same scene, number format, device and colour table:
//! in fixed point they must be equal.
//!
//! ```
//! use rta_core::color::Rgb;
//! use rta_drivers::checksum::{Checksum, Unseen};
//! use rta_drivers::painter::Painter;
//! use rta_drivers::quantize::Adaptive;
//! use rta_drivers::vga13h;
//!
//! let screen = Checksum::new(Unseen(vga13h::CAPABILITIES));
//! let mut painter = Painter::new(screen, Adaptive::new(256)?)?;
//! painter.put_row(0, 0, [Rgb::new(63, 0, 0); 320])?;
//! assert_eq!(painter.display().value(), 0x66a8_9e77_a2b2_5a97);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

use core::convert::Infallible;

use rta_core::color::Rgb;

use crate::display::{Capabilities, Display, DriverError};

/// The state of the hash function FNV-1a of 64 bits (Fowler, Noll, Vo; RFC 9923).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fnv(u64);

impl Fnv {
    /// The hash of no bytes: the offset basis of the RFC.
    pub const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);
    /// The prime of the RFC, 2^40 + 2^8 + B3h.
    const PRIME: u64 = 0x0000_0100_0000_01b3;

    /// Returns the hash.
    pub const fn value(self) -> u64 {
        self.0
    }

    /// Adds a byte to what was hashed.
    pub const fn add(&mut self, byte: u8) {
        self.0 = (self.0 ^ byte as u64).wrapping_mul(Self::PRIME);
    }
}

/// A display that hashes what is sent to it and passes it on.
///
/// The hash covers all indices in the order in which they are put, and after them all colours in the order in which
/// they are loaded, each as red, green, blue. So pictures compare equal only if their pixels are drawn in one order,
/// by convention from the upper left to the lower right. The coordinates of the pixels, and how many are put by one
/// call, make no difference.
#[derive(Clone, Debug)]
pub struct Checksum<D> {
    display: D,
    /// The hash of the indices.
    pixels: Fnv,
    /// The hash of the colours: apart, because they are loaded between the pixels.
    colors: Fnv,
}

impl<D: Display> Checksum<D> {
    /// Wraps a display; nothing was sent so far.
    pub const fn new(display: D) -> Self {
        Self { display, pixels: Fnv::EMPTY, colors: Fnv::EMPTY }
    }

    /// Returns the hash of what was sent so far.
    pub fn value(&self) -> u64 {
        let mut sum = self.pixels;
        for byte in self.colors.0.to_le_bytes() {
            sum.add(byte);
        }
        sum.0
    }

    /// Gives the display back.
    pub fn into_inner(self) -> D {
        self.display
    }
}

impl<D: Display> Display for Checksum<D> {
    type Error = D::Error;

    fn capabilities(&self) -> Capabilities {
        self.display.capabilities()
    }

    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error> {
        self.display.set_colors(first, colors)?;
        for color in colors {
            [color.r, color.g, color.b].into_iter().for_each(|level| self.colors.add(level));
        }
        Ok(())
    }

    fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error> {
        self.display.put_pixels(x, y, indices)?;
        indices.iter().for_each(|&index| self.pixels.add(index));
        Ok(())
    }

    fn update(&mut self) -> Result<(), Self::Error> {
        self.display.update()
    }
}

/// A display without a screen, which checks what is sent to it against the given capabilities and drops it.
#[derive(Clone, Copy, Debug)]
pub struct Unseen(pub Capabilities);

impl Display for Unseen {
    type Error = DriverError<Infallible>;

    fn capabilities(&self) -> Capabilities {
        self.0
    }

    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error> {
        self.0.check_colors(first, colors)
    }

    fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error> {
        self.0.check_pixels(x, y, indices.len())?;
        self.0.check_indices(indices)
    }
}
