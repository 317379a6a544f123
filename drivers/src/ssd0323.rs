//! SSD0323 (Solomon Systech): controller of an OLED panel of 128 x 64 pixels in 16 greys, on a serial bus.
//!
//! [`Ssd0323`] is the driver; [`emulated::Oled`] is an emulated controller and panel to run it on where there is no real one. [`commands`]
//! has the commands. The panel is OSRAM's Pictiva, as on the evaluation board of Texas Instruments' Stellaris LM3S6965.
//!
//! ```
//! use rta_core::color::Rgb;
//! use rta_drivers::direct::DirectPainter;
//! use rta_drivers::dither::{DirectCell, Diffusion, FloydSteinberg};
//! use rta_drivers::guns::One;
//! use rta_drivers::ssd0323::{Ssd0323, emulated::{MEMORY_SIZE, Oled}};
//!
//! let mut memory = [0x55; MEMORY_SIZE]; // what is in it when the power comes on is not known
//! let panel = Ssd0323::program(Oled::new(&mut memory[..])?); // on a real machine: your own bus instead of `Oled`
//! let mut cells = [DirectCell::<One>::default(); 128];
//! let diffusion = Diffusion::<FloydSteinberg, _, One>::new(&mut cells[..], 128)?;
//! let mut painter = DirectPainter::dithered(panel, diffusion);
//! for y in 0..64 {
//!     painter.put_row(0, y, [Rgb::new(0, 255, 0); 128])?; // luma 149, which is 8.76 of 15
//! }
//! let oled = painter.into_display().release();
//! let sum: u32 = (0..64 * 128).map(|i| u32::from(oled.shown(i % 128, i / 128))).sum();
//! assert_eq!(sum, 71822); // 8.77 on average
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```

pub mod commands;
pub mod emulated;

use core::fmt;

use crate::bus::CommandData;
use crate::direct::{DirectDisplay, Gray};
use crate::display::{DriverError, check_row};

/// Pixels of a row.
pub const WIDTH: u32 = 128;
/// Rows of the panel.
pub const HEIGHT: u32 = 64;

/// Driver of the controller over any bus.
///
/// A byte of its memory is two pixels, and a serial bus cannot read it: rows begin at an even column and have an even number of pixels,
/// unless they are [`HalfByte`]s.
#[derive(Clone, Debug)]
pub struct Ssd0323<B> {
    bus: B,
}

/// A row of pixels begins or ends within a byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HalfByte;

impl fmt::Display for HalfByte {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the pixels begin or end within a byte of two")
    }
}

impl core::error::Error for HalfByte {}

impl<B: CommandData> Ssd0323<B> {
    /// Sets the controller up, clears the panel and switches it on.
    pub fn program(mut bus: B) -> Self {
        bus.command(&commands::SETUP);
        // All of the memory, whose window is all of it from here on.
        bus.command(&commands::window((0, commands::COLUMNS - 1), (0, commands::ROWS - 1)));
        for _ in 0..commands::ROWS {
            bus.data(&[0; commands::COLUMNS as usize]);
        }
        bus.command(&[commands::ON]);
        Self { bus }
    }

    /// Sets the current of all pixels, 0..=127; more is 127. It is 50 at first.
    pub fn set_contrast(&mut self, contrast: u8) {
        self.bus.command(&[commands::CONTRAST, contrast.min(127)]);
    }

    /// Borrows the bus.
    pub fn bus(&self) -> &B {
        &self.bus
    }

    /// Gives the bus back. The panel stays on.
    pub fn release(self) -> B {
        self.bus
    }
}

impl<B: CommandData> DirectDisplay for Ssd0323<B> {
    type Color = Gray<15>;
    type Error = DriverError<HalfByte>;

    fn size(&self) -> (u32, u32) {
        (WIDTH, HEIGHT)
    }

    fn put_row(
        &mut self,
        x: u32,
        y: u32,
        mut colors: impl ExactSizeIterator<Item = Gray<15>>,
    ) -> Result<(), Self::Error> {
        let len = colors.len();
        check_row((WIDTH, HEIGHT), x, y, len)?;
        if !x.is_multiple_of(2) || !len.is_multiple_of(2) {
            return Err(HalfByte.into());
        }
        // All below 128, by the check.
        let byte = |place: usize| place.to_le_bytes()[0];
        let (first, row) = (byte(x as usize / 2), byte(y as usize));
        let Some(more) = (len / 2).checked_sub(1) else { return Ok(()) };
        self.bus.command(&commands::window((first, byte(x as usize / 2 + more)), (row, row)));
        while let (Some(Gray(left)), Some(Gray(right))) = (colors.next(), colors.next()) {
            self.bus.data(&[left.min(15) << 4 | right.min(15)]);
        }
        Ok(())
    }
}
