//! An emulated VGA: the register file as a state machine, 64 KiB of its memory, and what a monitor would show.
//!
//! Every register of the sequencer, the CRT controller, the graphics controller and the attribute controller keeps
//! what is written to it. These work as on a VGA:
//!
//! - the flip-flop of the attribute controller and its reset by 3DAh;
//! - the lock of the palette while the picture is shown, and the write protection of the CRT controller;
//! - the DAC's indices, its sequence of red, green and blue, its 6-bit levels, and the pel mask;
//! - the bits that open the window at A0000h: memory enable, memory map, chain 4, map mask.
//!
//! Two things are not modelled: the planar modes, whose window reads FFh and drops what is written, and time. The
//! vertical retrace comes at every [`RETRACE_PERIOD`]th read of 3DAh instead.

mod dac;
mod monitor;

use super::registers as reg;
use crate::bus::{Memory, Ports, ShortMemory, read_clipped, write_clipped};
use dac::Dac;

pub use monitor::{Monitor, NotMode13h};

/// Reads of 3DAh from one vertical retrace to the next. One read of each period sees the retrace.
pub const RETRACE_PERIOD: u8 = 8;

/// Bytes of the window at A0000h: 64 KiB.
pub const MEMORY_SIZE: usize = 0x1_0000;

/// An emulated VGA whose video memory is lent by the caller; it takes 850 bytes at most itself.
#[derive(Clone, Debug)]
pub struct Vga<M> {
    memory: M,
    misc: u8,
    sequencer: Indexed<5>,
    crtc: Indexed<25>,
    graphics: Indexed<9>,
    attribute: Indexed<21>,
    /// The flip-flop of the attribute controller: the next write to 3C0h is data, not an index.
    attribute_data: bool,
    dac: Dac,
    /// Reads of 3DAh since the last vertical retrace.
    status_reads: u8,
}

/// Registers behind one data port, selected by an index.
#[derive(Clone, Debug)]
struct Indexed<const N: usize> {
    index: u8,
    values: [u8; N],
}

impl<const N: usize> Indexed<N> {
    const RESET: Self = Self { index: 0, values: [0; N] };

    /// Returns the value of register `index`; FFh where there is none.
    fn value(&self, index: u8) -> u8 {
        self.values.get(usize::from(index)).copied().unwrap_or(0xFF)
    }

    /// Returns the value of the selected register; FFh where there is none.
    fn read(&self) -> u8 {
        self.value(self.index)
    }

    /// Sets the selected register, if there is one.
    fn write(&mut self, value: u8) {
        if let Some(register) = self.values.get_mut(usize::from(self.index)) {
            *register = value;
        }
    }
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Vga<M> {
    /// Makes a VGA after reset: no mode is set, the screen is blank, `memory` is left as it is.
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
            misc: 0,
            sequencer: Indexed::RESET,
            crtc: Indexed::RESET,
            graphics: Indexed::RESET,
            attribute: Indexed::RESET,
            attribute_data: false,
            dac: Dac::RESET,
            status_reads: 0,
        })
    }

    /// Does what the BIOS does on int 10h with AX = 0013h: sets the registers and the pel mask, clears the memory.
    pub fn bios_mode_13h(&mut self) {
        self.misc = reg::MISC;
        self.sequencer.values = reg::SEQUENCER_VALUES;
        self.crtc.values = reg::CRTC_VALUES;
        self.graphics.values = reg::GRAPHICS_VALUES;
        self.attribute = Indexed { index: reg::PALETTE_ADDRESS_SOURCE, values: reg::ATTRIBUTE_VALUES };
        self.attribute_data = false;
        self.dac.mask = 0xFF;
        self.memory.as_mut().fill(0);
    }

    /// Tells whether the 64 KiB at A0000h answer as one linear window: the memory is enabled (bit 1 of the
    /// miscellaneous output), mapped there (bits 2 and 3 of graphics register 6 are 01) and its four planes are chained
    /// (bit 3 of sequencer register 4).
    fn window_is_open(&self) -> bool {
        self.misc & 0x02 != 0 && self.graphics.value(6) & 0x0C == 0x04 && self.sequencer.value(4) & 0x08 != 0
    }

    /// A write to 3C0h: an index or data, by the flip-flop. The upper two bits of an index and of a palette register
    /// do not exist.
    fn write_attribute(&mut self, value: u8) {
        let index = self.attribute.index & 0x1F;
        let palette = index < 0x10;
        let locked = palette && self.attribute.index & reg::PALETTE_ADDRESS_SOURCE != 0;
        if !self.attribute_data {
            self.attribute.index = value & 0x3F;
        } else if let Some(register) = self.attribute.values.get_mut(usize::from(index))
            && !locked
        {
            *register = if palette { value & 0x3F } else { value };
        }
        self.attribute_data = !self.attribute_data;
    }

    /// A write to the data port of the CRT controller.
    fn write_crtc(&mut self, value: u8) {
        let locked = self.crtc.value(reg::CRTC_PROTECT_INDEX) & reg::CRTC_PROTECT != 0;
        match self.crtc.index {
            // Bit 4 of register 7 belongs to the line compare and is never locked.
            7 if locked => self.crtc.write(self.crtc.read() & !0x10 | value & 0x10),
            0..=7 if locked => {}
            _ => self.crtc.write(value),
        }
    }

    /// Returns the offset of `port` from 3D0h, or from 3B0h where bit 0 of the miscellaneous output is 0
    /// (monochrome): the CRT controller and the input status register move with that bit. `None` for other ports.
    fn crtc_port(&self, port: u16) -> Option<u16> {
        let base = if self.misc & 0x01 != 0 { 0x3D0 } else { 0x3B0 };
        port.checked_sub(base).filter(|&offset| offset < 0x10)
    }
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Ports for Vga<M> {
    fn out8(&mut self, port: u16, value: u8) {
        match port {
            reg::ATTRIBUTE => self.write_attribute(value),
            reg::MISC_WRITE => self.misc = value,
            reg::SEQUENCER => self.sequencer.index = value & 0x07,
            0x3C5 => self.sequencer.write(value),
            reg::PEL_MASK => self.dac.mask = value,
            reg::DAC_READ_INDEX => self.dac.start(value, true),
            reg::DAC_WRITE_INDEX => self.dac.start(value, false),
            reg::DAC_DATA => self.dac.write(value),
            reg::GRAPHICS => self.graphics.index = value & 0x0F,
            0x3CF => self.graphics.write(value),
            _ => match self.crtc_port(port) {
                Some(4) => self.crtc.index = value & 0x1F,
                Some(5) => self.write_crtc(value),
                _ => {}
            },
        }
    }

    fn in8(&mut self, port: u16) -> u8 {
        match port {
            reg::ATTRIBUTE => self.attribute.index,
            0x3C1 => self.attribute.value(self.attribute.index & 0x1F),
            reg::SEQUENCER => self.sequencer.index,
            0x3C5 => self.sequencer.read(),
            reg::PEL_MASK => self.dac.mask,
            reg::DAC_READ_INDEX => {
                if self.dac.reading {
                    3
                } else {
                    0
                }
            }
            reg::DAC_WRITE_INDEX => self.dac.write_index,
            reg::DAC_DATA => self.dac.read(),
            reg::MISC_READ => self.misc,
            reg::GRAPHICS => self.graphics.index,
            0x3CF => self.graphics.read(),
            _ => match self.crtc_port(port) {
                Some(4) => self.crtc.index,
                Some(5) => self.crtc.read(),
                Some(10) => {
                    self.attribute_data = false;
                    self.status_reads = (self.status_reads + 1) % RETRACE_PERIOD;
                    if self.status_reads == 0 { reg::VERTICAL_RETRACE | reg::DISPLAY_DISABLED } else { 0 }
                }
                _ => 0xFF,
            },
        }
    }
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Memory for Vga<M> {
    fn write(&mut self, offset: u32, bytes: &[u8]) {
        if !self.window_is_open() {
            return;
        }
        let map_mask = self.sequencer.value(2);
        let Some(memory) = self.memory.as_mut().get_mut(..MEMORY_SIZE) else { return };
        if map_mask & 0x0F == 0x0F {
            write_clipped(memory, offset, bytes);
            return;
        }
        // With chain 4 the two low bits of the address choose the plane, and the map mask has a bit for each plane.
        for (at, byte) in (offset..=u32::MAX).zip(bytes) {
            if map_mask >> (at & 3) & 1 != 0 {
                write_clipped(memory, at, core::slice::from_ref(byte));
            }
        }
    }

    fn read(&mut self, offset: u32, bytes: &mut [u8]) {
        let window = if self.window_is_open() { self.memory.as_ref().get(..MEMORY_SIZE) } else { None };
        read_clipped(window.unwrap_or(&[]), offset, bytes);
    }
}
