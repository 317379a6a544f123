//! The picture on the board's OLED. Reports go to UART0, and a terminal there ends the program.

mod ssi;
mod uart;

use picture::console::Serial;
use rta_drivers::ssd0323::Ssd0323;

use crate::ticks::Ticks;
use crate::{host, stack};
use ssi::Ssi;
use uart::Uart;

/// Draws the picture, reports, says `READY`, waits for `Q`, and ends the program.
pub fn run() -> ! {
    // SAFETY: this is the evaluation board, `main` calls this once, and nobody else uses the peripherals.
    let (ssi, mut uart) = unsafe { (Ssi::open(), Uart::open()) };
    let panel = Ssd0323::program(ssi);
    let mut ticks = Ticks::start();
    let mut before = None;
    let drawn = picture::direct::draw(panel, || {
        ticks.read();
        before.get_or_insert(ticks.instructions());
    });
    ticks.read();
    if drawn.is_err() {
        host::exit(2);
    }
    let reports = [
        ("width", picture::WIDTH.into()),
        ("height", picture::HEIGHT.into()),
        ("stack", stack::high_water()),
        ("before", before.unwrap_or(0)),
        ("instructions", ticks.instructions()),
    ];
    for (name, value) in reports {
        picture::report(name, value, |byte| uart.put(byte));
    }
    uart.put_all(b"READY\n");
    // Anything else is noise of a line that has just been plugged in.
    while uart.get() != b'Q' {}
    host::exit(0)
}

/// Returns the register at an address.
const fn register(address: usize) -> *mut u32 {
    core::ptr::without_provenance_mut(address)
}

/// Clocks of the peripherals (LM3S6965 data sheet, "System Control"): RCGC1 has bit 0 for UART0 and bit 4 for SSI0, RCGC2 bits 0 and 2 for
/// the ports A and C.
const RCGC1: *mut u32 = register(0x400F_E104);
const RCGC2: *mut u32 = register(0x400F_E108);

/// Registers of a port of general-purpose pins, by their offset from its first (data sheet, "GPIO").
const PORT_A: usize = 0x4000_4000;
const PORT_C: usize = 0x4000_6000;
const DIRECTION: usize = 0x400;
const ALTERNATE: usize = 0x420;
const DIGITAL: usize = 0x51C;

/// Sets bits of a register.
///
/// # Safety
/// The register's bits must do no harm to memory.
unsafe fn set(register: *mut u32, bits: u32) {
    // SAFETY: the caller's promise.
    unsafe { register.write_volatile(register.read_volatile() | bits) };
}
