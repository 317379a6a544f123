//! A display that refuses pixels once a key is pressed, so that a picture can be stopped in the middle.

use core::fmt;

use rta_core::color::Rgb;
use rta_drivers::display::{Capabilities, Display};

use super::system::System;

/// The display, and whom to ask for keys.
///
/// The BIOS itself takes them from the keyboard's controller: each question goes to real mode for a moment with interrupts
/// enabled. So shift keys, the clock and the motor of the floppy drive are left as the BIOS knows them.
pub(crate) struct UntilKey<D> {
    pub(crate) display: D,
    pub(crate) system: System,
}

/// Why pixels are refused.
#[derive(Debug)]
pub(crate) enum Refused<E> {
    /// A key was pressed; it is taken.
    Key,
    /// By the display.
    Display(E),
}

impl<E: fmt::Display> fmt::Display for Refused<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Key => f.write_str("a key was pressed"),
            Self::Display(why) => why.fmt(f),
        }
    }
}

impl<E: core::error::Error> core::error::Error for Refused<E> {}

impl<D: Display> Display for UntilKey<D> {
    type Error = Refused<D::Error>;

    fn capabilities(&self) -> Capabilities {
        self.display.capabilities()
    }

    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error> {
        self.display.set_colors(first, colors).map_err(Refused::Display)
    }

    fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error> {
        if self.system.take_key() {
            return Err(Refused::Key);
        }
        self.display.put_pixels(x, y, indices).map_err(Refused::Display)
    }

    fn update(&mut self) -> Result<(), Self::Error> {
        self.display.update().map_err(Refused::Display)
    }
}
