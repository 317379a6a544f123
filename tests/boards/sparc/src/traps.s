! The trap table, 256 entries of four instructions, and the two handlers a program cannot do without: the
! register windows are spilled to the stack and filled from it. Any other trap ends the program.
! In a handler: l1 = pc, l2 = npc, l3 as the entry sets it; traps are off.
  .macro FATAL number
  ba fatal_trap
  mov \number, %l3
  nop
  nop
  .endm

  .macro WINDOW handler
  ba \handler
  rd %wim, %l3
  nop
  nop
  .endm

  .section .traps,"ax"
  .align 4096
  .globl trap_table
trap_table:
  sethi %hi(start), %g1          ! 0: reset, the very first instructions
  jmp %g1 + %lo(start)
  nop
  nop
  FATAL 1
  FATAL 2
  FATAL 3
  FATAL 4
  WINDOW window_overflow         ! 5
  WINDOW window_underflow        ! 6
  .set number, 7
  .rept 249
  FATAL number
  .set number, number + 1
  .endr

! save met the invalid window: spill the one beyond it and make that the invalid one. 8 windows.
window_overflow:
  mov %g1, %l7
  srl %l3, 1, %g1
  sll %l3, 7, %l4
  or %l4, %g1, %g1               ! the mask rotated to the right
  save
  wr %g1, %g0, %wim
  nop
  nop
  nop
  std %l0, [%sp + 0]
  std %l2, [%sp + 8]
  std %l4, [%sp + 16]
  std %l6, [%sp + 24]
  std %i0, [%sp + 32]
  std %i2, [%sp + 40]
  std %i4, [%sp + 48]
  std %i6, [%sp + 56]
  restore
  mov %l7, %g1
  jmp %l1
  rett %l2

! restore met the invalid window: fill it and make the one before it the invalid one.
window_underflow:
  sll %l3, 1, %l4
  srl %l3, 7, %l5
  or %l5, %l4, %l5               ! the mask rotated to the left
  wr %l5, %g0, %wim
  nop
  nop
  nop
  restore
  restore
  ldd [%sp + 0], %l0
  ldd [%sp + 8], %l2
  ldd [%sp + 16], %l4
  ldd [%sp + 24], %l6
  ldd [%sp + 32], %i0
  ldd [%sp + 40], %i2
  ldd [%sp + 48], %i4
  ldd [%sp + 56], %i6
  save
  save
  jmp %l1
  rett %l2

! board_trap(number, pc), on a stack of its own making: the top of the stack, all windows free, traps on,
! for the handler's calls may well spill. Nobody returns to the trapped program.
fatal_trap:
  mov %l3, %g2
  mov %l1, %g3
  set fatal, %g4
  ba reset_windows
  nop
fatal:
  mov %g2, %o0
  call board_trap
  mov %g3, %o1
