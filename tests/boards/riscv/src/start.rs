//! From reset to `main`: pointers, cleared memory, painted stack, trap vector.

use core::arch::global_asm;

/// What the stack is painted with.
const PAINT: u32 = 0xcccc_cccc;

unsafe extern "C" {
    /// Lowest word of the stack (link.ld).
    static __stack_low: u32;
    /// First word above the stack (link.ld).
    static __stack_high: u32;
}

global_asm!(
    r#"
    .section .init, "ax"
    .globl _start
_start:
    # Without relaxation: it would turn this into "mv gp, gp".
    .option push
    .option norelax
    la      gp, __global_pointer$
    .option pop
    la      sp, __stack_high
    la      t0, 5f
    csrw    mtvec, t0

    la      t0, __bss_start
    la      t1, __bss_end
1:  bgeu    t0, t1, 2f
    sw      zero, 0(t0)
    addi    t0, t0, 4
    j       1b

2:  la      t0, __stack_low
    li      t1, {paint}
3:  bgeu    t0, sp, 4f
    sw      t1, 0(t0)
    addi    t0, t0, 4
    j       3b

4:  tail    main

    # The two low bits of mtvec are not part of the address.
    .balign 4
5:  tail    {trap}
"#,
    trap = sym trap,
    paint = const PAINT,
);

/// Any trap: interrupts are off and no exception is expected.
extern "C" fn trap() -> ! {
    crate::board::exit(99)
}

/// Bytes from the top of the stack to the lowest word ever written.
pub fn stack_high_water() -> u64 {
    let top = &raw const __stack_high;
    let mut word = &raw const __stack_low;
    // SAFETY: all words from `__stack_low` to `__stack_high` are RAM; volatile, as they are no variables.
    while word < top && unsafe { word.read_volatile() } == PAINT {
        word = word.wrapping_add(1);
    }
    (top.addr() - word.addr()) as u64
}
