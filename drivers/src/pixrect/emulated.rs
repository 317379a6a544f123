//! An emulated cgthree: the Bt458 as a state machine, the frame buffer, and what a monitor would show.
//!
//! Obeyed are the address register and its auto-increment, the red-green-blue sequence in bytes and in
//! words, read mask and RAM enable of the Bt458, and the board's video enable. Kept but not shown: blinking
//! and overlays. The colormap is not read back (it reads 0, as QEMU's board does).

use core::fmt;

use rta_core::color::Rgb;

use super::CAPABILITIES;
use super::cgthree::registers as reg;
use crate::bus::{Memory, Registers, ShortMemory, read_clipped, write_clipped};

/// Bytes of the frame buffer that are shown: 1152 x 900.
pub const MEMORY_SIZE: usize = 1152 * 900;

/// An emulated cgthree with lent memory for its frame buffer. Takes about 800 bytes besides.
#[derive(Clone, Debug)]
pub struct Board<M> {
    memory: M,
    colormap: [Rgb<u8>; 256],
    address: u8,
    /// Which of red, green and blue is next: 0, 1, 2.
    gun: u8,
    /// Red and green wait here for blue.
    latch: Rgb<u8>,
    /// Bt458 registers 4 to 7.
    bt458: [u8; 4],
    /// Registers 10h to 1Fh of the board.
    control: [u8; 16],
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Board<M> {
    /// A board after reset: video off, registers 0, `memory` as it is.
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

    /// Plugs a monitor in.
    ///
    /// # Errors
    /// [`Blank`] if video or the colormap is off.
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
            // The address is the low byte of its word.
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

/// A monitor on an emulated cgthree whose video is on.
#[derive(Clone, Copy, Debug)]
pub struct Monitor<'a> {
    memory: &'a [u8],
    colormap: &'a [Rgb<u8>; 256],
    read_mask: u8,
}

impl Monitor<'_> {
    /// What the guns show at a pixel, 0..=255 each. `None` outside the screen.
    pub fn pixel(&self, x: u32, y: u32) -> Option<Rgb<u8>> {
        CAPABILITIES.check_pixels::<()>(x, y, 1).ok()?;
        let index = self.memory.get(usize::try_from(y * CAPABILITIES.width + x).ok()?)?;
        self.colormap.get(usize::from(index & self.read_mask)).copied()
    }
}

/// Why the screen is blank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Blank {
    /// Video enable, bit 6 of register 10h, is 0.
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
