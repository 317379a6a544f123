//! The system's counter of a sun4m: it counts half microseconds.

use picture::elapsed::Elapsed;

/// Written with 0, the counter does not begin again before all of its bits have gone round.
const LIMIT: *mut u32 = 0x71D1_0000 as *mut u32;
/// The count, from bit 9 on; bit 31 says that the limit was reached.
const COUNTER: *const u32 = 0x71D1_0004 as *const u32;
const BITS: u32 = 22;

/// Starts the counter, which goes round in 2 seconds. What it counts is a number of [ticks](nanoseconds).
///
/// # Safety
/// On a SPARCstation 5 with the MMU off only, with traps by interrupts off, and nobody else may use the counter from here on.
pub(crate) unsafe fn start() -> Elapsed<impl FnMut() -> u32> {
    // SAFETY: a device's register; it touches no memory.
    unsafe { LIMIT.write_volatile(0) };
    // SAFETY: as above.
    Elapsed::new((1 << BITS) - 1, || unsafe { COUNTER.read_volatile() } >> 9)
}

/// Returns the time of so many ticks.
pub(crate) const fn nanoseconds(ticks: u64) -> u64 {
    ticks * 500
}
