//! What the pairs of numbers cost that rays are spread by: reports the instructions of a turn of a loop that calls a function that does
//! nothing, one that returns a pair, its sequence included, and one that returns a further pair of a sequence.

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
use rta_core::sampling::pairs::{Pairs, pair};
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

/// What returns a pair.
type First = fn(u32, u32, u32, u32, u32) -> (u32, u32);

/// Returns the instructions of one turn of a loop, to the nearest.
fn counted(mut turn: impl FnMut(u32)) -> u64 {
    let mut ticks = Ticks::start();
    for number in 0..COUNT {
        turn(number);
    }
    ticks.read();
    (ticks.instructions() + u64::from(COUNT) / 2) / u64::from(COUNT)
}

/// Does nothing with what [`first`] takes.
const fn nothing(_x: u32, _y: u32, _tag: u32, _seed: u32, number: u32) -> (u32, u32) {
    (number, number)
}

/// Returns a pair and makes its sequence for it.
fn first(x: u32, y: u32, tag: u32, seed: u32, number: u32) -> (u32, u32) {
    pair(x, y, tag, seed, number).into()
}

/// Returns a pair of a sequence.
fn further(pairs: &Pairs, number: u32) -> (u32, u32) {
    pairs.words(number).into()
}

#[entry]
fn main() -> ! {
    // Behind pointers, so that no part of them is computed once for all turns.
    let [first, nothing] = black_box([first as First, nothing]);
    let further = black_box(further as fn(&Pairs, u32) -> (u32, u32));
    let [y, tag, seed] = black_box([20, 4, 1]);
    let pairs = black_box(Pairs::new(10, y, tag, seed));
    let loops = counted(|number| {
        black_box(nothing(number, y, tag, seed, number));
    });
    let first = counted(|number| {
        black_box(first(number, y, tag, seed, number));
    });
    let further = counted(|number| {
        black_box(further(&pairs, number));
    });
    for (name, instructions) in [("loop", loops), ("pair", first), ("further", further)] {
        picture::report(name, instructions, put);
    }
    host::exit(0)
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    host::exit(101)
}
