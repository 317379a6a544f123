//! What the board has: a serial line, a way out, an instruction counter and, under an emulator, a host.

use core::arch::asm;
use core::ptr;

use picture::stream::Host;

/// The 16550's transmitter.
const UART_DATA: *mut u8 = ptr::without_provenance_mut(0x1000_0000);
/// The 16550's line status.
const UART_STATUS: *const u8 = ptr::without_provenance(0x1000_0005);
/// Line status: the transmitter takes a byte.
const UART_EMPTY: u8 = 0x20;
/// SiFive's test device: a word written ends the emulator.
const TEST: *mut u32 = ptr::without_provenance_mut(0x0010_0000);
/// The test device's exit code 0.
const TEST_PASS: u32 = 0x5555;
/// The test device's other exit codes: in the upper half of the word.
const TEST_FAIL: u32 = 0x3333;

/// Semihosting of RISC-V.
pub struct Semihosting;

impl Host for Semihosting {
    unsafe fn call(&mut self, operation: usize, block: &[usize; 3]) -> usize {
        let answer;
        // The breakpoint is a call if these two shifts of the zero register, which do nothing, are around
        // it: all uncompressed and in one page of memory, hence aligned.
        // SAFETY: the host changes a0 and the memory that the caller lets it change.
        unsafe {
            asm!(
                ".option push",
                ".option norvc",
                ".balign 16",
                "slli zero, zero, 0x1f",
                "ebreak",
                "srai zero, zero, 7",
                ".option pop",
                inout("a0") operation => answer,
                in("a1") block.as_ptr(),
                options(nostack, preserves_flags),
            );
        }
        answer
    }
}

/// Writes `byte` to the serial line.
pub fn put(byte: u8) {
    // SAFETY: the addresses are the board's.
    unsafe {
        while UART_STATUS.read_volatile() & UART_EMPTY == 0 {}
        UART_DATA.write_volatile(byte);
    }
}

/// Ends the emulator with `code`.
pub fn exit(code: u16) -> ! {
    let word = if code == 0 { TEST_PASS } else { u32::from(code) << 16 | TEST_FAIL };
    // SAFETY: the address is the board's.
    unsafe { TEST.write_volatile(word) };
    loop {}
}

/// Instructions retired since reset. Exact under QEMU's `-icount`.
pub fn instructions() -> u64 {
    loop {
        let (high, low, again): (u32, u32, u32);
        // SAFETY: reads two registers, one of them twice.
        unsafe {
            asm!(
                "csrr {high}, minstreth",
                "csrr {low}, minstret",
                "csrr {again}, minstreth",
                high = out(reg) high,
                low = out(reg) low,
                again = out(reg) again,
                options(nomem, nostack, preserves_flags),
            );
        }
        // Equal unless the lower half has just overflowed.
        if high == again {
            return u64::from(high) << 32 | u64::from(low);
        }
    }
}
