//! The host, by semihosting.

use core::arch::asm;

/// Ends the program: reason, exit code.
const SYS_EXIT_EXTENDED: usize = 0x20;
/// Reason of `SYS_EXIT_EXTENDED`: `ADP_Stopped_ApplicationExit`, the one that has a code.
const APPLICATION_EXIT: usize = 0x2_0026;

/// Ends the emulator with `code`.
pub fn exit(code: usize) -> ! {
    let block = [APPLICATION_EXIT, code];
    // SAFETY: the block of SYS_EXIT_EXTENDED.
    unsafe { call(SYS_EXIT_EXTENDED, block.as_ptr().cast()) };
    // A debugger may let the program go on.
    loop {
        cortex_m::asm::wfi();
    }
}

/// The breakpoint that the host takes for a call.
///
/// # Safety
/// `argument` must be what `operation` expects.
pub unsafe fn call(operation: usize, argument: *const ()) -> usize {
    let answer;
    // SAFETY: the host changes r0 and the memory that the caller lets it change.
    unsafe {
        asm!("bkpt 0xab", inout("r0") operation => answer, in("r1") argument, options(nostack, preserves_flags));
    }
    answer
}
