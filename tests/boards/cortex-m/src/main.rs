//! Draws the picture on a Cortex-M board: streams it to the host, then reports stack and instructions.
//!
//! Exit codes: 0, 2 for a display error, 99 for a fault, 101 for a panic. None of them prints: `core::fmt`
//! would take more flash memory than all of this.

#![no_std]
#![no_main]

mod host;
mod stack;
mod ticks;

use core::panic::PanicInfo;

use cortex_m_rt::{entry, exception};
use picture::stream::Stream;

use crate::host::Semihosting;
use crate::ticks::Ticks;

#[entry]
fn main() -> ! {
    let Ok(display) = Stream::open(Semihosting) else {
        host::exit(2);
    };
    let table = picture::table();
    let mut ticks = Ticks::start();
    let mut before = None;
    let drawn = picture::draw(display, table, (0, 0), || {
        ticks.read();
        before.get_or_insert(ticks.instructions());
    });
    ticks.read();
    if drawn.is_err() {
        host::exit(2);
    }
    picture::report("stack", stack::high_water(), host::put);
    picture::report("before", before.unwrap_or(0), host::put);
    picture::report("instructions", ticks.instructions(), host::put);
    host::exit(0)
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
