//! An emulated cgthree: the Bt458 as a state machine, the frame buffer, and what a monitor would show.
//!
//! These work as on the board: the address register and its auto-increment, the sequence of red, green and blue in
//! bytes and in words, the read mask and the RAM enable of the Bt458, and the board's video enable. The registers
//! for blinking, overlays and tests keep what is written to them and have no effect. The colormap cannot be read
//! back: it reads 0, as on QEMU's board.

use core::fmt;

use rta_core::color::Rgb;

use super::CAPABILITIES;
use super::cgthree::registers as reg;
use crate::bus::{Memory, Registers, ShortMemory, read_clipped, write_clipped};

/// Bytes of the frame buffer that are shown: 1152 x 900.
pub const MEMORY_SIZE: usize = 1152 * 900;

/// An emulated cgthree whose frame buffer is memory that the caller lends; it takes 800 bytes at most itself.
#[derive(Clone, Debug)]
pub struct Board<M> {
    memory: M,
    colormap: [Rgb<u8>; 256],
    address: u8,
    /// The gun whose level is expected next: 0 for red, 1 for green, 2 for blue.
    gun: u8,
    /// Levels received so far; the colormap takes all three together when blue arrives.
    latch: Rgb<u8>,
    /// Bt458 registers 4 to 7: read mask, blink mask, command, test.
    bt458: [u8; 4],
    /// The board's registers at offsets 10h to 1Fh; the first is the control register.
    control: [u8; 16],
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Board<M> {
    /// Makes a board after reset: the video is off, registers and colormap are 0, `memory` is left as it is.
    ///
    /// # Errors
    /// [`ShortMemory`] if `memory` has less than [`MEMORY_SIZE`] bytes.
    pub fn new(memory: M) -> Result<Self, ShortMemory> {
        let found = memory.as_ref().len();
        if found < MEMORY_SIZE {
            return Err(ShortMemory { needed: MEMORY_SIZE, found });
        }
        Ok(Self {
            memory,
            colormap: [Rgb::new(0, 0, 0); 256],
            address: 0,
            gun: 0,
            latch: Rgb::new(0, 0, 0),
            bt458: [0; 4],
            control: [0; 16],
        })
    }

    /// Plugs a monitor in, which shows what the frame buffer and the colormap hold now.
    ///
    /// # Errors
    /// [`Blank`] if the video or the colormap is switched off.
    pub fn monitor(&self) -> Result<Monitor<'_>, Blank> {
        let [video, ..] = self.control;
        let [read_mask, _, command, _] = self.bt458;
        if video & reg::VIDEO_ENABLE == 0 {
            return Err(Blank::VideoOff);
        }
        if command & reg::RAM_ENABLE == 0 {
            return Err(Blank::RamOff);
        }
        Ok(Monitor { memory: self.memory.as_ref(), colormap: &self.colormap, read_mask })
    }

    /// One byte written to the colormap: the level of the gun that is next.
    fn write_colormap(&mut self, value: u8) {
        match self.gun {
            0 => self.latch.r = value,
            1 => self.latch.g = value,
            _ => {
                self.latch.b = value;
                if let Some(entry) = self.colormap.get_mut(usize::from(self.address)) {
                    *entry = self.latch;
                }
                self.address = self.address.wrapping_add(1);
            }
        }
        self.gun = (self.gun + 1) % 3;
    }

    /// The register that keeps what is written at `offset`; for the Bt458's controls, the one that the address
    /// names.
    fn register(&mut self, offset: u32) -> Option<&mut u8> {
        match offset {
            reg::BT458_CONTROL => self.bt458.get_mut(usize::from(self.address.checked_sub(4)?)),
            _ => self.control.get_mut(usize::try_from(offset.checked_sub(reg::CONTROL)?).ok()?),
        }
    }
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Registers for Board<M> {
    fn write8(&mut self, offset: u32, value: u8) {
        match offset {
            reg::BT458_ADDRESS => {
                self.address = value;
                self.gun = 0;
            }
            reg::BT458_COLORMAP => self.write_colormap(value),
            _ => {
                if let Some(register) = self.register(offset) {
                    *register = value;
                }
            }
        }
    }

    fn read8(&mut self, offset: u32) -> u8 {
        self.register(offset).map_or(0, |register| *register)
    }

    fn write32(&mut self, offset: u32, value: u32) {
        match offset {
            reg::BT458_COLORMAP => value.to_be_bytes().into_iter().for_each(|byte| self.write_colormap(byte)),
            // A byte-wide register takes the low byte of the word.
            _ => self.write8(offset, value.to_le_bytes()[0]),
        }
    }
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Memory for Board<M> {
    fn write(&mut self, offset: u32, bytes: &[u8]) {
        write_clipped(self.memory.as_mut(), offset, bytes);
    }

    fn read(&mut self, offset: u32, bytes: &mut [u8]) {
        read_clipped(self.memory.as_ref(), offset, bytes);
    }
}

/// A monitor plugged into an emulated cgthree whose video is on.
#[derive(Clone, Copy, Debug)]
pub struct Monitor<'a> {
    memory: &'a [u8],
    colormap: &'a [Rgb<u8>; 256],
    read_mask: u8,
}

impl Monitor<'_> {
    /// Returns the levels of the guns, 0..=255 each, at the pixel in column `x` and row `y` from the upper left;
    /// `None` outside the screen.
    pub fn pixel(&self, x: u32, y: u32) -> Option<Rgb<u8>> {
        CAPABILITIES.check_pixels::<()>(x, y, 1).ok()?;
        let index = self.memory.get(usize::try_from(y * CAPABILITIES.width + x).ok()?)?;
        self.colormap.get(usize::from(index & self.read_mask)).copied()
    }
}

/// Why the screen of an emulated cgthree is blank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Blank {
    /// Video enable, bit 6 of the board's control register at 10h, is 0.
    VideoOff,
    /// RAM enable, bit 6 of the Bt458's command register, is 0.
    RamOff,
}

impl fmt::Display for Blank {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::VideoOff => "blank: video enable (register 10h, bit 6) is 0",
            Self::RamOff => "blank: RAM enable (Bt458 command register, bit 6) is 0",
        })
    }
}

impl core::error::Error for Blank {}
