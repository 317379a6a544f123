//! COM1: a 16550 at 3F8h, polled.

use crate::port;
use picture::console::Serial;

/// First port. With bit 7 of [`LINE_CONTROL`] set, it and the next one hold the divisor of the clock.
const BASE: u16 = 0x3F8;
const DATA: u16 = BASE;
const INTERRUPT_ENABLE: u16 = BASE + 1;
const FIFO_CONTROL: u16 = BASE + 2;
const LINE_CONTROL: u16 = BASE + 3;
const MODEM_CONTROL: u16 = BASE + 4;
const LINE_STATUS: u16 = BASE + 5;

/// Bits of [`LINE_STATUS`].
const RECEIVED: u8 = 0x01;
const MAY_SEND: u8 = 0x20;

/// 115,200 baud, 8 data bits, no parity, 1 stop bit; no interrupts, FIFOs on and emptied, DTR and RTS set.
const SETUP: [(u16, u8); 7] = [
    (INTERRUPT_ENABLE, 0),
    (LINE_CONTROL, 0x80),
    (DATA, 1),
    (INTERRUPT_ENABLE, 0),
    (LINE_CONTROL, 0x03),
    (FIFO_CONTROL, 0x07),
    (MODEM_CONTROL, 0x03),
];

/// The port, set up.
pub(crate) struct Com1(());

impl Com1 {
    /// Sets the port up.
    ///
    /// # Safety
    /// On a PC only, and nobody else may use COM1 from here on.
    pub(crate) unsafe fn open() -> Self {
        for (port, value) in SETUP {
            // SAFETY: a 16550 without DMA touches no memory.
            unsafe { port::out8(port, value) };
        }
        Self(())
    }

    /// Waits until a bit of the line status is set.
    fn wait(&self, bit: u8) {
        // SAFETY: reading the status has no effect.
        while unsafe { port::in8(LINE_STATUS) } & bit == 0 {}
    }
}

impl Serial for Com1 {
    fn put(&mut self, byte: u8) {
        self.wait(MAY_SEND);
        // SAFETY: as in `open`.
        unsafe { port::out8(DATA, byte) };
    }

    fn get(&mut self) -> u8 {
        self.wait(RECEIVED);
        // SAFETY: as in `open`.
        unsafe { port::in8(DATA) }
    }
}
