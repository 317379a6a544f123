//! Draws the picture on QEMU's RISC-V board `virt`: streams it to the host, then reports stack and instructions.
//!
//! Exit codes: 0, 2 for a display error, 99 for a trap, 101 for a panic. None of them prints: `core::fmt`
//! would take more memory than all of this.

#![no_std]
#![no_main]

mod board;
mod start;

use core::panic::PanicInfo;

use picture::stream::Stream;

use crate::board::Semihosting;

/// Called by the start-up code, with an empty stack.
#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    let Ok(display) = Stream::open(Semihosting) else {
        board::exit(2);
    };
    let table = picture::table();
    let start = board::instructions();
    let mut before = None;
    let drawn = picture::draw(display, table, (0, 0), || {
        before.get_or_insert_with(|| board::instructions() - start);
    });
    let end = board::instructions();
    if drawn.is_err() {
        board::exit(2);
    }
    picture::report("stack", start::stack_high_water(), board::put);
    picture::report("before", before.unwrap_or(0), board::put);
    picture::report("instructions", end - start, board::put);
    board::exit(0)
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    board::exit(101)
}
