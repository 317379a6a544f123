//! The bus of a real cgthree, in the SBus slot where a SPARCstation 5 has it.

use rta_drivers::bus::{Memory, Registers};
use rta_drivers::pixrect::CAPABILITIES;

/// The registers of the board.
const REGISTERS: *mut u8 = 0x5040_0000 as *mut u8;
/// Their size in bytes: the Bt458's four words and the frame buffer's controls.
const REGISTERS_LEN: usize = 0x20;
/// The frame buffer, a byte a pixel.
const WINDOW: *mut u8 = 0x5080_0000 as *mut u8;
/// Its size in bytes: the screen's.
const WINDOW_LEN: usize = CAPABILITIES.width as usize * CAPABILITIES.height as usize;

/// A cgthree.
pub(crate) struct Screen(());

impl Screen {
    /// Takes the cgthree.
    ///
    /// # Safety
    /// On a SPARCstation 5 with a cgthree and the MMU off only; nobody else may use it from here on.
    pub(crate) unsafe fn open() -> Self {
        Self(())
    }
}

/// The register at `offset` if the board has one there for `len` bytes.
fn register(offset: u32, len: usize) -> Option<*mut u8> {
    let offset = offset as usize;
    (offset <= REGISTERS_LEN - len).then(|| REGISTERS.wrapping_add(offset))
}

impl Registers for Screen {
    fn write8(&mut self, offset: u32, value: u8) {
        if let Some(register) = register(offset, 1) {
            // SAFETY: a register of the board, which touches no memory of the program.
            unsafe { register.write_volatile(value) };
        }
    }

    fn read8(&mut self, offset: u32) -> u8 {
        // SAFETY: as in `write8`.
        register(offset, 1).map_or(0xFF, |register| unsafe { register.read_volatile() })
    }

    fn write32(&mut self, offset: u32, value: u32) {
        if let Some(register) = register(offset, 4) {
            // SAFETY: as in `write8`; the drivers' words are aligned, as the board wants them. The
            // processor is big-endian as the trait is.
            unsafe { register.cast::<u32>().write_volatile(value) };
        }
    }
}

/// Offsets into the window from `offset` up, and no further than its end.
fn offsets(offset: u32) -> core::ops::Range<usize> {
    offset as usize..WINDOW_LEN
}

impl Memory for Screen {
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
