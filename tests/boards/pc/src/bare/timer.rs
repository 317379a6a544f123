//! Channel 0 of the 8254, the timer of every PC.

use crate::port;
use picture::elapsed::Elapsed;

const COUNTER: u16 = 0x40;
const CONTROL: u16 = 0x43;
/// Channel 0, low and then high byte, mode 2 (down by one with each tick, again and again), binary.
const RATE: u8 = 0x34;
/// Channel 0: keep what it is at for the next two reads.
const LATCH: u8 = 0x00;
/// Ticks a second.
const FREQUENCY: u64 = 1_193_182;

/// Starts the timer, which goes round in 55 ms. What it counts is a number of [ticks](nanoseconds).
///
/// # Safety
/// On a PC only, with interrupts off, and nobody else may use channel 0 from here on.
pub(crate) unsafe fn start() -> Elapsed<impl FnMut() -> u32> {
    for (port, value) in [(CONTROL, RATE), (COUNTER, 0), (COUNTER, 0)] {
        // SAFETY: a timer touches no memory.
        unsafe { port::out8(port, value) };
    }
    Elapsed::new(0xFFFF, || {
        // SAFETY: as above.
        let [low, high] = unsafe {
            port::out8(CONTROL, LATCH);
            [port::in8(COUNTER), port::in8(COUNTER)]
        };
        // It counts down.
        !u32::from(u16::from_le_bytes([low, high]))
    })
}

/// Returns the time of so many ticks.
pub(crate) const fn nanoseconds(ticks: u64) -> u64 {
    ticks * 1_000_000 / (FREQUENCY / 1000)
}
