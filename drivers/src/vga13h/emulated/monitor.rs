//! The monitor on an emulated VGA: what the registers, the memory and the DAC put on the screen.

use core::fmt;

use rta_core::color::Rgb;

use super::{Dac, Vga};
use crate::vga13h::{CAPABILITIES, offset, registers as reg};

impl<M: AsRef<[u8]> + AsMut<[u8]>> Vga<M> {
    /// Plugs a monitor in, which shows what the memory and the DAC hold now.
    ///
    /// # Errors
    /// [`NotMode13h`], which names the first register whose value is not that of mode 13h.
    pub fn monitor(&self) -> Result<Monitor<'_>, NotMode13h> {
        let check = |port, index, found: u8, wanted: u8, mask: u8| {
            if (found ^ wanted) & mask == 0 { Ok(()) } else { Err(NotMode13h { port, index, found, wanted }) }
        };
        check(reg::MISC_WRITE, None, self.misc, reg::MISC, 0xFF)?;
        for (index, &wanted) in (0..).zip(&reg::SEQUENCER_VALUES) {
            check(reg::SEQUENCER, Some(index), self.sequencer.value(index), wanted, 0xFF)?;
        }
        for (index, &wanted) in (0..).zip(&reg::CRTC_VALUES) {
            let mask = match index {
                0x0A | 0x0B | 0x0E | 0x0F => 0, // the text cursor, which mode 13h does not show
                reg::CRTC_PROTECT_INDEX => !reg::CRTC_PROTECT, // a lock, without effect on the picture
                _ => 0xFF,
            };
            check(reg::CRTC, Some(index), self.crtc.value(index), wanted, mask)?;
        }
        for (index, &wanted) in (0..).zip(&reg::GRAPHICS_VALUES) {
            check(reg::GRAPHICS, Some(index), self.graphics.value(index), wanted, 0xFF)?;
        }
        for (index, &wanted) in (0..).zip(&reg::ATTRIBUTE_VALUES) {
            let mask = if index == 0x11 { 0 } else { 0xFF }; // the border may have any colour
            check(reg::ATTRIBUTE, Some(index), self.attribute.value(index), wanted, mask)?;
        }
        let source = reg::PALETTE_ADDRESS_SOURCE;
        check(reg::ATTRIBUTE, None, self.attribute.index, source, source)?;
        Ok(Monitor { memory: self.memory.as_ref(), dac: &self.dac })
    }
}

/// A monitor plugged into an emulated VGA that is in mode 13h.
#[derive(Clone, Copy, Debug)]
pub struct Monitor<'a> {
    memory: &'a [u8],
    dac: &'a Dac,
}

impl Monitor<'_> {
    /// Returns the levels of the guns, 0..=63 each, at the pixel in column `x` and row `y` from the upper left: the
    /// colour that the DAC has for the index in memory ANDed with the pel mask. `None` outside the screen.
    pub fn pixel(&self, x: u32, y: u32) -> Option<Rgb<u8>> {
        CAPABILITIES.check_pixels::<()>(x, y, 1).ok()?;
        let index = self.memory.get(usize::try_from(offset(x, y)).ok()?)?;
        Some(self.dac.color(index & self.dac.mask))
    }
}

/// A register whose value is not that of mode 13h, so that a monitor would show another picture or none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotMode13h {
    /// The port of the register, or of the index that selects it.
    pub port: u16,
    /// The index of the register; `None` for one that has a port of its own.
    pub index: Option<u8>,
    /// The value that it holds.
    pub found: u8,
    /// The value that it has in mode 13h.
    pub wanted: u8,
}

impl fmt::Display for NotMode13h {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "not in mode 13h: register {:X}h", self.port)?;
        if let Some(index) = self.index {
            write!(f, " index {index:02X}h")?;
        }
        write!(f, " is {:02X}h, wanted {:02X}h", self.found, self.wanted)
    }
}

impl core::error::Error for NotMode13h {}
