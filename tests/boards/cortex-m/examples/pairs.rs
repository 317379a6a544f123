//! What the pairs of numbers cost that rays are spread by: reports the instructions of a pair, its sequence included, and of a further pair
//! of the same sequence, with the loops and calls around them.

#![no_std]
#![no_main]

#[path = "../src/host.rs"]
mod host;
#[path = "../src/ticks.rs"]
mod ticks;

use core::hint::black_box;
use core::panic::PanicInfo;
use core::ptr;

use cortex_m_rt::entry;
use rta_core::sampling::pairs::Pairs;
use ticks::Ticks;

/// Pairs that are counted: a tick is up to 80 instructions.
const COUNT: u32 = 4096;

/// Writes a character, whose address is passed, to the host's console.
const SYS_WRITEC: usize = 0x03;

/// Writes `byte` to the console.
fn put(byte: u8) {
    // SAFETY: SYS_WRITEC reads the byte.
    unsafe { host::call(SYS_WRITEC, ptr::from_ref(&byte).cast()) };
}

/// Returns the instructions of one turn of a loop, to the nearest.
fn counted(mut turn: impl FnMut(u32)) -> u64 {
    let mut ticks = Ticks::start();
    for number in 0..COUNT {
        turn(number);
    }
    ticks.read();
    (ticks.instructions() + u64::from(COUNT) / 2) / u64::from(COUNT)
}

/// Returns a pair of a sequence that is made for it.
#[inline(never)]
fn pair(x: u32, y: u32, tag: u32, number: u32) -> [u32; 2] {
    Pairs::new(x, y, tag, 1).words(number)
}

/// Returns a pair of a sequence.
#[inline(never)]
fn further(pairs: &Pairs, number: u32) -> [u32; 2] {
    pairs.words(number)
}

#[entry]
fn main() -> ! {
    let first = counted(|number| {
        black_box(pair(number, 20, 4, 3));
    });
    let pairs = Pairs::new(10, 20, 4, 1);
    let further = counted(|number| {
        black_box(further(&pairs, number));
    });
    for (name, instructions) in [("pair", first), ("further", further)] {
        picture::report(name, instructions, put);
    }
    host::exit(0)
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    host::exit(101)
}
