//! The bus of a real VGA: the processor's ports and the 64 KiB at A0000h.

use rta_drivers::bus::{Memory, Ports};

use crate::port;

/// Video memory as mode 13h shows it.
const WINDOW: *mut u8 = 0xA_0000 as *mut u8;
/// Its size in bytes.
const WINDOW_LEN: usize = 0x1_0000;

/// A VGA.
pub(crate) struct Vga(());

impl Vga {
    /// Takes the VGA.
    ///
    /// # Safety
    /// On a PC only, in flat memory without paging; nobody else may use the VGA from here on.
    pub(crate) unsafe fn open() -> Self {
        Self(())
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
            unsafe { WINDOW.add(at).write_volatile(byte) };
        }
    }

    fn read(&mut self, offset: u32, bytes: &mut [u8]) {
        let mut at = offsets(offset);
        for byte in bytes {
            // SAFETY: as in `write`.
            *byte = at.next().map_or(0xFF, |at| unsafe { WINDOW.add(at).read_volatile() });
        }
    }
}
