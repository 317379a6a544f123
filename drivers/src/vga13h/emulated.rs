//! An emulated VGA: the register file as a state machine, 64 KiB of its memory, and what a monitor on it
//! would show.
//!
//! Every register of the sequencer, CRTC, graphics and attribute controllers is kept. Obeyed are: the
//! attribute flip-flop and its reset by 3DAh, the lock of the palette while it goes to the screen, the
//! CRTC's write protection, the DAC's indices, three-byte sequences and 6-bit latches, the pel mask, and
//! what opens the window at A0000h (memory enable, memory map, chain 4, map mask). Not modelled: the
//! planar modes (their window reads FFh and drops what is written) and time (the retrace comes every
//! [`RETRACE_PERIOD`] reads of 3DAh).

use core::fmt;

use rta_core::color::Rgb;

use super::registers as reg;
use super::{CAPABILITIES, offset};
use crate::bus::{Memory, Ports, ShortMemory, read_clipped, write_clipped};

/// Reads of 3DAh from one vertical retrace to the next; the last of them sees it.
pub const RETRACE_PERIOD: u8 = 8;

/// Bytes of the window at A0000h.
pub const MEMORY_SIZE: usize = 0x1_0000;

/// An emulated VGA with borrowed (or otherwise lent) memory. Takes about 850 bytes besides.
#[derive(Clone, Debug)]
pub struct Vga<M> {
    memory: M,
    misc: u8,
    sequencer: Indexed<5>,
    crtc: Indexed<25>,
    graphics: Indexed<9>,
    attribute: Indexed<21>,
    /// The next write to 3C0h is data.
    attribute_data: bool,
    dac: Dac,
    status_reads: u8,
}

/// Registers behind an index.
#[derive(Clone, Debug)]
struct Indexed<const N: usize> {
    index: u8,
    values: [u8; N],
}

impl<const N: usize> Indexed<N> {
    const RESET: Self = Self { index: 0, values: [0; N] };

    /// The value of register `index`; FFh where there is none.
    fn value(&self, index: u8) -> u8 {
        self.values.get(usize::from(index)).copied().unwrap_or(0xFF)
    }

    fn read(&self) -> u8 {
        self.value(self.index)
    }

    fn write(&mut self, value: u8) {
        if let Some(register) = self.values.get_mut(usize::from(self.index)) {
            *register = value;
        }
    }
}

#[derive(Clone, Debug)]
struct Dac {
    colors: [Rgb<u8>; 256],
    mask: u8,
    reading: bool,
    write_index: u8,
    read_index: u8,
    /// Red and green wait here for blue.
    latch: Rgb<u8>,
    /// Which of red, green and blue is next: 0, 1, 2.
    gun: u8,
}

impl Dac {
    fn color(&self, index: u8) -> Rgb<u8> {
        self.colors.get(usize::from(index)).copied().unwrap_or_default()
    }

    fn start(&mut self, index: u8, reading: bool) {
        *(if reading { &mut self.read_index } else { &mut self.write_index }) = index;
        self.reading = reading;
        self.gun = 0;
    }

    fn write(&mut self, value: u8) {
        let value = value & CAPABILITIES.gun_max;
        match self.gun {
            0 => self.latch.r = value,
            1 => self.latch.g = value,
            _ => {
                self.latch.b = value;
                if let Some(color) = self.colors.get_mut(usize::from(self.write_index)) {
                    *color = self.latch;
                }
                self.write_index = self.write_index.wrapping_add(1);
            }
        }
        self.gun = (self.gun + 1) % 3;
    }

    fn read(&mut self) -> u8 {
        let color = self.color(self.read_index);
        let value = match self.gun {
            0 => color.r,
            1 => color.g,
            _ => {
                self.read_index = self.read_index.wrapping_add(1);
                color.b
            }
        };
        self.gun = (self.gun + 1) % 3;
        value
    }
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Vga<M> {
    /// A VGA after reset: no mode set, screen blank, `memory` as it is.
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
            dac: Dac {
                colors: [Rgb::new(0, 0, 0); 256],
                mask: 0,
                reading: false,
                write_index: 0,
                read_index: 0,
                latch: Rgb::new(0, 0, 0),
                gun: 0,
            },
            status_reads: 0,
        })
    }

    /// What the BIOS does on int 10h with AX = 0013h: registers, pel mask, memory cleared.
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

    /// Plugs a monitor in.
    ///
    /// # Errors
    /// [`NotMode13h`], which names the first register that does not stand as mode 13h has it.
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
                0x0A | 0x0B | 0x0E | 0x0F => 0,                // the text cursor
                reg::CRTC_PROTECT_INDEX => !reg::CRTC_PROTECT, // a lock, not a timing
                _ => 0xFF,
            };
            check(reg::CRTC, Some(index), self.crtc.value(index), wanted, mask)?;
        }
        for (index, &wanted) in (0..).zip(&reg::GRAPHICS_VALUES) {
            check(reg::GRAPHICS, Some(index), self.graphics.value(index), wanted, 0xFF)?;
        }
        for (index, &wanted) in (0..).zip(&reg::ATTRIBUTE_VALUES) {
            let mask = if index == 0x11 { 0 } else { 0xFF }; // 11h is the colour of the border
            check(reg::ATTRIBUTE, Some(index), self.attribute.value(index), wanted, mask)?;
        }
        let source = reg::PALETTE_ADDRESS_SOURCE;
        check(reg::ATTRIBUTE, None, self.attribute.index, source, source)?;
        Ok(Monitor { memory: self.memory.as_ref(), dac: &self.dac })
    }

    /// The window at A0000h is there: memory enabled, 64 KiB at A0000h, the four planes chained.
    fn window_is_open(&self) -> bool {
        self.misc & 0x02 != 0 && self.graphics.value(6) & 0x0C == 0x04 && self.sequencer.value(4) & 0x08 != 0
    }

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

    fn write_crtc(&mut self, value: u8) {
        let locked = self.crtc.value(reg::CRTC_PROTECT_INDEX) & reg::CRTC_PROTECT != 0;
        match self.crtc.index {
            // Bit 4 of register 7 belongs to the line compare and is never locked.
            7 if locked => self.crtc.write(self.crtc.read() & !0x10 | value & 0x10),
            0..=7 if locked => {}
            _ => self.crtc.write(value),
        }
    }

    /// CRTC and input status answer at 3Dxh (colour) or 3Bxh (monochrome). The offset in that range.
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
        // Chained, the two low bits of the address choose the plane.
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

/// A monitor on an emulated VGA that is in mode 13h.
#[derive(Clone, Copy, Debug)]
pub struct Monitor<'a> {
    memory: &'a [u8],
    dac: &'a Dac,
}

impl Monitor<'_> {
    /// What the guns show at a pixel, 0..=63 each: the index in memory, masked, through the DAC. `None`
    /// outside the screen.
    pub fn pixel(&self, x: u32, y: u32) -> Option<Rgb<u8>> {
        CAPABILITIES.check_pixels::<()>(x, y, 1).ok()?;
        let index = self.memory.get(usize::try_from(offset(x, y)).ok()?)?;
        Some(self.dac.color(index & self.dac.mask))
    }
}

/// A register does not stand as mode 13h has it: the monitor would show nothing, or something else.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotMode13h {
    /// The port of the register, or of its index.
    pub port: u16,
    /// Its index, if it has one.
    pub index: Option<u8>,
    /// What it holds.
    pub found: u8,
    /// What mode 13h wants.
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
