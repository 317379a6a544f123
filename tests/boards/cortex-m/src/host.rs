//! The host, by semihosting.

use core::arch::asm;
use core::ptr;

use picture::stream::Host;

/// Writes a character, whose address is passed, to the host's console.
const SYS_WRITEC: usize = 0x03;
/// Ends the program: reason, exit code.
const SYS_EXIT_EXTENDED: usize = 0x20;
/// Reason of `SYS_EXIT_EXTENDED`: `ADP_Stopped_ApplicationExit`, the one that has a code.
const APPLICATION_EXIT: usize = 0x2_0026;

/// Semihosting of ARM's M profile.
pub struct Semihosting;

impl Host for Semihosting {
    unsafe fn call(&mut self, operation: usize, block: &[usize; 3]) -> usize {
        // SAFETY: the caller's promise.
        unsafe { call(operation, block.as_ptr().cast()) }
    }
}

/// Writes `byte` to the console.
pub fn put(byte: u8) {
    // SAFETY: SYS_WRITEC reads the byte.
    unsafe { call(SYS_WRITEC, ptr::from_ref(&byte).cast()) };
}

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
unsafe fn call(operation: usize, argument: *const ()) -> usize {
    let answer;
    // SAFETY: the host changes r0 and the memory that the caller lets it change.
    unsafe {
        asm!("bkpt 0xab", inout("r0") operation => answer, in("r1") argument, options(nostack, preserves_flags));
    }
    answer
}
