! From reset to board_main: the processor's state, .data, .bss, and the paint of the stack (stack.rs).
  .text
  .globl start
start:
  set 0x1fc0, %g1                ! FPU on, interrupts masked, supervisor, traps off, window 0
  wr %g1, %g0, %psr
  nop
  nop
  nop
  sta %g0, [%g0] 4               ! MMU off, boot mode off: from here an address is a physical one
  nop
  nop
  nop
  set trap_table, %g1
  wr %g1, %g0, %tbr
  set initialise, %g4

! Goes on at %g4 with the stack empty, window 0 in use, window 1 the invalid one, and traps on.
  .globl reset_windows
reset_windows:
  set 0x1fc0, %g1
  wr %g1, %g0, %psr
  nop
  nop
  nop
  wr %g0, 2, %wim
  nop
  nop
  nop
  set __stack_high - 96, %sp     ! the frame that every callee may use: 16 words of window, 8 of arguments
  clr %fp
  set 0x1fe0, %g1                ! the same with traps on
  wr %g1, %g0, %psr
  nop
  nop
  nop
  jmp %g4
  nop

initialise:
  set zero, %g1
  ld [%g1], %fsr                 ! round to nearest, no floating-point traps
  set __data_start, %g1
  set __data_end, %g2
  set __data_load, %g3
1:
  cmp %g1, %g2
  bgeu 2f
  nop
  ld [%g3], %g4
  st %g4, [%g1]
  add %g1, 4, %g1
  ba 1b
  add %g3, 4, %g3
2:
  set __bss_start, %g1
  set __bss_end, %g2
3:
  cmp %g1, %g2
  bgeu 4f
  nop
  st %g0, [%g1]
  ba 3b
  add %g1, 4, %g1
4:
  set __stack_low, %g1
  set __stack_high - 96, %g2
  set 0xcccccccc, %g3
5:
  cmp %g1, %g2
  bgeu 6f
  nop
  st %g3, [%g1]
  ba 5b
  add %g1, 4, %g1
6:
  call board_main                ! does not return
  nop
  .align 8
zero:
  .word 0
