//! VGA mode 13h (IBM PS/2): 320 x 200, one byte a pixel at A0000h, 256 colours of 262,144.
//!
//! [`Mode13h`] is the driver; [`emulated::Vga`] is an emulated VGA to run it on where there is no real one.
//! Register names and numbers are those of IBM's "PS/2 Hardware Interface Technical Reference, Video Subsystem".

pub mod emulated;
pub mod registers;

use core::convert::Infallible;

use rta_core::color::Rgb;

use crate::bus::{Memory, Ports};
use crate::display::{Capabilities, Display, DriverError, ReadBack};
use registers as reg;

/// What the screen can show: 320 x 200 pixels on a screen of 4:3, 256 colours, 6 bits a gun.
pub const CAPABILITIES: Capabilities =
    Capabilities { width: 320, height: 200, colors: 256, gun_max: 63, aspect: (4, 3) };

/// Driver of mode 13h over any bus that has the VGA's ports and its memory (offset 0 = A0000h).
///
/// Set the mode either by [`Mode13h::program`], on a VGA alone, or by the BIOS and
/// [`Mode13h::after_bios`], on a VGA or an MCGA: the two share the BIOS call, the DAC and the memory,
/// not the other registers.
#[derive(Clone, Debug)]
pub struct Mode13h<B> {
    bus: B,
    /// Reads of 3DAh that a load of the DAC may spend on waiting for the vertical retrace.
    retrace_polls: u32,
}

impl<B: Ports + Memory> Mode13h<B> {
    /// Sets mode 13h by writing every register of a VGA, without a BIOS, and clears the memory as the BIOS would. An
    /// MCGA has other registers and needs [`Mode13h::after_bios`].
    pub fn program(mut bus: B) -> Self {
        bus.out8(reg::MISC_WRITE, reg::MISC);
        load(&mut bus, reg::SEQUENCER, &reg::SEQUENCER_VALUES);
        // Bit 7 of CRTC register 11h write-protects registers 0 to 7, which come first in the table; the table
        // sets the bit again.
        bus.out8(reg::CRTC, reg::CRTC_PROTECT_INDEX);
        let protect = bus.in8(reg::CRTC + 1);
        bus.out8(reg::CRTC + 1, protect & !reg::CRTC_PROTECT);
        load(&mut bus, reg::CRTC, &reg::CRTC_VALUES);
        load(&mut bus, reg::GRAPHICS, &reg::GRAPHICS_VALUES);
        for (index, &value) in (0..).zip(&reg::ATTRIBUTE_VALUES) {
            // Reading 3DAh makes the next write to 3C0h an index, whatever was written before.
            bus.in8(reg::INPUT_STATUS_1);
            bus.out8(reg::ATTRIBUTE, index);
            bus.out8(reg::ATTRIBUTE, value);
        }
        bus.in8(reg::INPUT_STATUS_1);
        bus.out8(reg::ATTRIBUTE, reg::PALETTE_ADDRESS_SOURCE);
        let mut mode = Self::after_bios(bus);
        for offset in (0..0x1_0000).step_by(64) {
            mode.bus.write(offset, &[0; 64]);
        }
        mode
    }

    /// Takes over after the BIOS has set the mode (int 10h, AX = 0013h). Only the pel mask is written, so that all
    /// eight bits of a pixel reach the DAC.
    pub fn after_bios(mut bus: B) -> Self {
        bus.out8(reg::PEL_MASK, 0xFF);
        Self { bus, retrace_polls: 0 }
    }

    /// Lets each load of the DAC wait for the vertical retrace, for at most `polls` reads of 3DAh; 0, the default,
    /// never waits. The DAC of an early VGA shows snow when it is written while it displays. If no retrace begins
    /// within `polls` reads the colours are loaded all the same.
    #[must_use]
    pub fn with_retrace_wait(mut self, polls: u32) -> Self {
        self.retrace_polls = polls;
        self
    }

    /// Waits until a vertical retrace begins, for at most `polls` reads of 3DAh. Returns whether one began.
    pub fn wait_retrace(&mut self, polls: u32) -> bool {
        // A retrace that is under way at the first read may be about to end, so it does not count.
        let mut was = true;
        for _ in 0..polls {
            let is = self.bus.in8(reg::INPUT_STATUS_1) & reg::VERTICAL_RETRACE != 0;
            if is && !was {
                return true;
            }
            was = is;
        }
        false
    }

    /// Borrows the bus, for example to plug a monitor into an emulated VGA.
    pub fn bus(&self) -> &B {
        &self.bus
    }

    /// Gives the bus back. The mode stays set.
    pub fn release(self) -> B {
        self.bus
    }
}

/// Writes indexed registers from 0 up: for each, the index to `port` and the value to the port after it.
fn load(bus: &mut impl Ports, port: u16, values: &[u8]) {
    for (index, &value) in (0..).zip(values) {
        bus.out8(port, index);
        bus.out8(port + 1, value);
    }
}

/// Returns the offset of a pixel from A0000h. The pixel must be on the screen, so the offset is below 64000.
fn offset(x: u32, y: u32) -> u32 {
    y * CAPABILITIES.width + x
}

impl<B: Ports + Memory> Display for Mode13h<B> {
    type Error = DriverError<Infallible>;

    fn capabilities(&self) -> Capabilities {
        CAPABILITIES
    }

    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error> {
        CAPABILITIES.check_colors(first, colors)?;
        if self.retrace_polls > 0 {
            self.wait_retrace(self.retrace_polls);
        }
        // The DAC advances the index by itself after every third write.
        self.bus.out8(reg::DAC_WRITE_INDEX, first);
        for color in colors {
            self.bus.out8(reg::DAC_DATA, color.r);
            self.bus.out8(reg::DAC_DATA, color.g);
            self.bus.out8(reg::DAC_DATA, color.b);
        }
        Ok(())
    }

    fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error> {
        CAPABILITIES.check_pixels(x, y, indices.len())?;
        self.bus.write(offset(x, y), indices);
        Ok(())
    }
}

impl<B: Ports + Memory> ReadBack for Mode13h<B> {
    fn read_colors(&mut self, first: u8, colors: &mut [Rgb<u8>]) -> Result<(), Self::Error> {
        CAPABILITIES.check_entries(first, colors.len())?;
        self.bus.out8(reg::DAC_READ_INDEX, first);
        for color in colors {
            color.r = self.bus.in8(reg::DAC_DATA);
            color.g = self.bus.in8(reg::DAC_DATA);
            color.b = self.bus.in8(reg::DAC_DATA);
        }
        Ok(())
    }

    fn read_pixels(&mut self, x: u32, y: u32, indices: &mut [u8]) -> Result<(), Self::Error> {
        CAPABILITIES.check_pixels(x, y, indices.len())?;
        self.bus.read(offset(x, y), indices);
        Ok(())
    }
}
