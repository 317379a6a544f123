//! Draws the picture on a Cortex-M board: streams it to the host, or shows it on the board's OLED, and reports stack and instructions.
//!
//! Exit codes: 0, 2 for a display error, 99 for a fault, 101 for a panic. None of them prints: `core::fmt`
//! would take more flash memory than all of this.

#![no_std]
#![no_main]

mod host;
#[cfg(feature = "lm3s6965evb-oled")]
mod panel;
mod stack;
#[cfg(not(feature = "lm3s6965evb-oled"))]
mod streamed;
mod ticks;

use core::panic::PanicInfo;

use cortex_m_rt::{entry, exception};
#[cfg(feature = "lm3s6965evb-oled")]
use panel::run;
#[cfg(not(feature = "lm3s6965evb-oled"))]
use streamed::run;

#[entry]
fn main() -> ! {
    run()
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    host::exit(101)
}

/// All faults end here: those with a handler of their own are not enabled.
#[exception(trampoline = false)]
unsafe fn HardFault() -> ! {
    host::exit(99)
}
