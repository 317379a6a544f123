//! SSI0, the serial bus of the OLED: PA2 is its clock, PA5 its data, PA3 selects the controller, PC7 is D/C, and PC6 switches the panel's supply
//! on.

use rta_drivers::bus::CommandData;

use super::{ALTERNATE, DIGITAL, DIRECTION, PORT_A, PORT_C, RCGC1, RCGC2, register, set};

/// Registers of SSI0 (LM3S6965 data sheet, "Synchronous Serial Interface").
const BASE: usize = 0x4000_8000;
const CONTROL_0: *mut u32 = register(BASE);
const CONTROL_1: *mut u32 = register(BASE + 0x04);
const DATA: *mut u32 = register(BASE + 0x08);
const STATUS: *mut u32 = register(BASE + 0x0C);
const PRESCALE: *mut u32 = register(BASE + 0x10);

/// Bits of [`STATUS`].
const MAY_SEND: u32 = 0x02;
const RECEIVED: u32 = 0x04;
const BUSY: u32 = 0x10;

/// Frames of 8 bits, sampled at the rising edge of a clock that is low in between, as the SSD0323's data sheet has it.
const EIGHT_BITS: u32 = 0x07;
/// Bit of [`CONTROL_1`].
const ENABLED: u32 = 0x02;
/// The clock is divided by it: 3.1 of 12.5 MHz, where the SSD0323 allows 4.
const DIVISOR: u32 = 4;

/// Pins, as bits of their ports.
const SERIAL: u32 = 1 << 2 | 1 << 4 | 1 << 5;
const SELECT: u32 = 1 << 3;
const DC: u32 = 1 << 7;
const SUPPLY: u32 = 1 << 6;

/// Returns the register by which just these pins of a port are written.
const fn pins(port: usize, pins: u32) -> *mut u32 {
    register(port + ((pins as usize) << 2))
}

/// The bus, set up, with the controller selected.
pub struct Ssi(());

impl Ssi {
    /// Sets the bus up.
    ///
    /// # Safety
    /// On the evaluation board only, and nobody else may use SSI0, PA2 to PA5, PC6 and PC7 from here on.
    pub unsafe fn open() -> Self {
        // SAFETY: these registers touch no memory.
        unsafe {
            set(RCGC1, 1 << 4);
            set(RCGC2, 1 << 0 | 1 << 2);
            set(register(PORT_A + ALTERNATE), SERIAL);
            set(register(PORT_A + DIRECTION), SELECT);
            set(register(PORT_A + DIGITAL), SERIAL | SELECT);
            set(register(PORT_C + DIRECTION), DC | SUPPLY);
            set(register(PORT_C + DIGITAL), DC | SUPPLY);
            pins(PORT_A, SELECT).write_volatile(0);
            pins(PORT_C, SUPPLY).write_volatile(SUPPLY);
            CONTROL_1.write_volatile(0);
            PRESCALE.write_volatile(DIVISOR);
            CONTROL_0.write_volatile(EIGHT_BITS);
            CONTROL_1.write_volatile(ENABLED);
        }
        Self(())
    }

    /// Sends bytes with D/C as given, and waits until the last is sent: D/C must not change before.
    fn send(&mut self, dc: u32, bytes: &[u8]) {
        // SAFETY: as in `open`.
        unsafe {
            pins(PORT_C, DC).write_volatile(dc);
            for &byte in bytes {
                while STATUS.read_volatile() & MAY_SEND == 0 {}
                DATA.write_volatile(byte.into());
                // For each byte sent one is received.
                while STATUS.read_volatile() & RECEIVED != 0 {
                    DATA.read_volatile();
                }
            }
            while STATUS.read_volatile() & BUSY != 0 {}
        }
    }
}

impl CommandData for Ssi {
    fn command(&mut self, bytes: &[u8]) {
        self.send(0, bytes);
    }

    fn data(&mut self, bytes: &[u8]) {
        self.send(DC, bytes);
    }
}
