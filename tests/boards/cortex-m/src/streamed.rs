//! The picture, streamed to the host by semihosting.

use core::ptr;

use picture::stream::{Host, Stream};

use crate::ticks::Ticks;
use crate::{host, stack};

/// Writes a character, whose address is passed, to the host's console.
const SYS_WRITEC: usize = 0x03;

/// Semihosting of ARM's M profile.
struct Semihosting;

impl Host for Semihosting {
    unsafe fn call(&mut self, operation: usize, block: &[usize; 3]) -> usize {
        // SAFETY: the caller's promise.
        unsafe { host::call(operation, block.as_ptr().cast()) }
    }
}

/// Writes `byte` to the console.
fn put(byte: u8) {
    // SAFETY: SYS_WRITEC reads the byte.
    unsafe { host::call(SYS_WRITEC, ptr::from_ref(&byte).cast()) };
}

/// Draws the picture, reports, and ends the program.
pub fn run() -> ! {
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
    picture::report("stack", stack::high_water(), put);
    picture::report("before", before.unwrap_or(0), put);
    picture::report("instructions", ticks.instructions(), put);
    host::exit(0)
}
