# The header that a multiboot (version 1) loader looks for: magic number, no wishes, checksum.
# The loader enters _start in flat 32-bit protected mode, interrupts off.
  .section .multiboot,"a"
  .align 4
  .long 0x1badb002, 0, -0x1badb002
