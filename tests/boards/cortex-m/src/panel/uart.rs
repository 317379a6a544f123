//! UART0, on PA0 and PA1: a PL011, polled.

use picture::console::Serial;

use super::{ALTERNATE, DIGITAL, PORT_A, RCGC1, RCGC2, register, set};

/// Registers (LM3S6965 data sheet, "Universal Asynchronous Receivers/Transmitters").
const BASE: usize = 0x4000_C000;
const DATA: *mut u32 = register(BASE);
const FLAGS: *mut u32 = register(BASE + 0x18);
const DIVISOR: *mut u32 = register(BASE + 0x24);
const FRACTION: *mut u32 = register(BASE + 0x28);
const LINE_CONTROL: *mut u32 = register(BASE + 0x2C);
const CONTROL: *mut u32 = register(BASE + 0x30);

/// Bits of [`FLAGS`].
const NOTHING_RECEIVED: u32 = 0x10;
const FULL: u32 = 0x20;

/// 115,200 baud of 12.5 MHz: 6.78 = 6 + 50/64.
const BAUD: (u32, u32) = (6, 50);
/// 8 data bits, no parity, 1 stop bit, with FIFOs.
const EIGHT_BITS: u32 = 0x70;
/// Sends and receives.
const ENABLED: u32 = 0x301;
/// The pins.
const PINS: u32 = 1 << 0 | 1 << 1;

/// The line, set up.
pub struct Uart(());

impl Uart {
    /// Sets the line up.
    ///
    /// # Safety
    /// On the evaluation board only, and nobody else may use UART0, PA0 and PA1 from here on.
    pub unsafe fn open() -> Self {
        // SAFETY: these registers touch no memory.
        unsafe {
            set(RCGC1, 1 << 0);
            set(RCGC2, 1 << 0);
            set(register(PORT_A + ALTERNATE), PINS);
            set(register(PORT_A + DIGITAL), PINS);
            CONTROL.write_volatile(0);
            DIVISOR.write_volatile(BAUD.0);
            FRACTION.write_volatile(BAUD.1);
            LINE_CONTROL.write_volatile(EIGHT_BITS);
            CONTROL.write_volatile(ENABLED);
        }
        Self(())
    }
}

impl Serial for Uart {
    fn put(&mut self, byte: u8) {
        // SAFETY: as in `open`.
        unsafe {
            while FLAGS.read_volatile() & FULL != 0 {}
            DATA.write_volatile(byte.into());
        }
    }

    fn get(&mut self) -> u8 {
        // SAFETY: as in `open`.
        unsafe {
            while FLAGS.read_volatile() & NOTHING_RECEIVED != 0 {}
            // The upper bits tell errors of the line.
            DATA.read_volatile().to_le_bytes()[0]
        }
    }
}
