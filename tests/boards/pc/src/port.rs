//! The processor's I/O instructions.

use core::arch::asm;

/// Writes `value` to `port`.
///
/// # Safety
/// The device at `port` must not be made to break memory that the program uses.
pub(crate) unsafe fn out8(port: u16, value: u8) {
    // SAFETY: the instruction touches no memory of the program but what the caller answers for.
    // Not `nomem`: a write that sets a mode must stay before the accesses to video memory that follow it.
    unsafe {
        asm!("out dx, al", in("dx") port, in("al") value, options(nostack, preserves_flags));
    }
}

/// Reads `port`; FFh if nobody answers.
///
/// # Safety
/// As [`out8`]: reading, too, may make a device act.
pub(crate) unsafe fn in8(port: u16) -> u8 {
    let value;
    // SAFETY: as in `out8`.
    unsafe {
        asm!("in al, dx", in("dx") port, out("al") value, options(nostack, preserves_flags));
    }
    value
}
