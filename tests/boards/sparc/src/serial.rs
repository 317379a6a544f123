//! ttya: channel A of a Zilog 8530, polled.

use picture::console::Serial;

/// Register 0 when read: the status. When written: first a register's number, then its value.
const CONTROL: *mut u8 = 0x7110_0004 as *mut u8;
const DATA: *mut u8 = 0x7110_0006 as *mut u8;

/// Bits of the status.
const RECEIVED: u8 = 0x01;
const MAY_SEND: u8 = 0x04;

/// Registers and values: clock x16 and 1 stop bit, no parity; receiver on, 8 bits; transmitter on, 8 bits.
/// The baud rate stays as it is: an emulator has none.
const SETUP: [(u8, u8); 3] = [(4, 0x44), (3, 0xC1), (5, 0x68)];

/// The port, set up.
pub(crate) struct Ttya(());

impl Ttya {
    /// Sets the port up.
    ///
    /// # Safety
    /// On a SPARCstation 5 with the MMU off only, and nobody else may use ttya from here on.
    pub(crate) unsafe fn open() -> Self {
        for (register, value) in SETUP {
            // SAFETY: a device's register; it touches no memory.
            unsafe {
                CONTROL.write_volatile(register);
                CONTROL.write_volatile(value);
            }
        }
        Self(())
    }

    /// Waits until a bit of the status is set.
    fn wait(&self, bit: u8) {
        // SAFETY: as in `open`.
        while unsafe { CONTROL.read_volatile() } & bit == 0 {}
    }
}

impl Serial for Ttya {
    fn put(&mut self, byte: u8) {
        self.wait(MAY_SEND);
        // SAFETY: as in `open`.
        unsafe { DATA.write_volatile(byte) };
    }

    fn get(&mut self) -> u8 {
        self.wait(RECEIVED);
        // SAFETY: as in `open`.
        unsafe { DATA.read_volatile() }
    }
}
