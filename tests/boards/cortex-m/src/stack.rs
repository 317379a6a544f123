//! How far down the stack has grown.

use cortex_m_rt::STACK_PAINT_VALUE;

unsafe extern "C" {
    /// First word above the stack (the linker's).
    static _stack_start: u32;
    /// Lowest word that the stack may use (the linker's).
    static _stack_end: u32;
}

/// Bytes from the top of the stack to the lowest word ever written. The start-up code has painted them all.
pub fn high_water() -> u64 {
    let top = &raw const _stack_start;
    let mut word = &raw const _stack_end;
    // SAFETY: all words from `_stack_end` to `_stack_start` are RAM; volatile, as they are no variables.
    while word < top && unsafe { word.read_volatile() } == STACK_PAINT_VALUE {
        word = word.wrapping_add(1);
    }
    (top.addr() - word.addr()) as u64
}
