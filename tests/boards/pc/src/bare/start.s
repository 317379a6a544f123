# First instructions in flat protected mode: clears .bss, paints the stack (stack.rs), calls board_main.
# Nothing here may use the stack before it is painted.
  .section .start,"ax"
  .code32
  .globl _start
_start:
  cld
  mov edi, offset __bss_start
  mov ecx, offset __bss_end
  sub ecx, edi
  xor eax, eax
  rep stosb
  mov edi, offset __stack_low
  mov ecx, offset __stack_high
  mov esp, ecx
  sub ecx, edi
  shr ecx, 2
  mov eax, 0xcccccccc
  rep stosd
  call board_main              # does not return
