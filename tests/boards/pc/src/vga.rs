//! The bus of a real VGA: the processor's ports and the 64 KiB at A0000h.

use rta_drivers::bus::{Memory, Ports};

use crate::port;

/// Where video memory is, as mode 13h shows it.
const WINDOW: usize = 0xA_0000;
/// Its size in bytes.
const WINDOW_LEN: usize = 0x1_0000;

/// A VGA, and its memory as the program addresses it.
pub(crate) struct Vga(*mut u8);

impl Vga {
    /// Takes the VGA. `base` is the linear address at which the program's segments begin: 0 in flat memory.
    ///
    /// # Safety
    /// On a PC only, with segments of 4 GiB that begin at `base`, without paging; nobody else may use the VGA from here on.
    pub(crate) unsafe fn open(base: u32) -> Self {
        Self(core::ptr::with_exposed_provenance_mut(WINDOW - base as usize))
    }
}

impl Ports for Vga {
    fn out8(&mut self, port: u16, value: u8) {
        // SAFETY: the driver asks for the ports of the VGA only, and a VGA touches no memory but its own.
        unsafe { port::out8(port, value) }
    }

    fn in8(&mut self, port: u16) -> u8 {
        // SAFETY: as in `out8`.
        unsafe { port::in8(port) }
    }
}

/// Offsets into the window from `offset` up, and no further than its end.
fn offsets(offset: u32) -> core::ops::Range<usize> {
    offset as usize..WINDOW_LEN
}

impl Memory for Vga {
    fn write(&mut self, offset: u32, bytes: &[u8]) {
        for (at, &byte) in offsets(offset).zip(bytes) {
            // SAFETY: `at` is inside the window, which holds no object of the program.
            unsafe { self.0.add(at).write_volatile(byte) };
        }
    }

    fn read(&mut self, offset: u32, bytes: &mut [u8]) {
        let mut at = offsets(offset);
        for byte in bytes {
            // SAFETY: as in `write`.
            *byte = at.next().map_or(0xFF, |at| unsafe { self.0.add(at).read_volatile() });
        }
    }
}
