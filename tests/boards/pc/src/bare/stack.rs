//! How much stack was used: start.s paints it, and what has lost its paint was used.

/// The word the stack is painted with.
const PAINT: u32 = 0xCCCC_CCCC;

unsafe extern "C" {
    /// First word of the stack and the first beyond it; symbols of the linker script.
    static __stack_low: u32;
    static __stack_high: u32;
}

/// Bytes from the deepest word used so far up to the top.
pub(crate) fn high_water() -> u64 {
    let mut word = &raw const __stack_low;
    let top = &raw const __stack_high;
    // SAFETY: `word` is inside the stack and aligned; the compiler does not know its contents, so the
    // reads are volatile.
    while word < top && unsafe { word.read_volatile() } == PAINT {
        word = word.wrapping_add(1);
    }
    (top.addr() - word.addr()) as u64
}
