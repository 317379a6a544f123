# A DOS program's way into protected mode and back. DOS starts it in real mode with all of conventional memory;
# ds and cs are the segment of the program, at whose offset 2 is the first segment that is not the program's own.
#
# Protected mode has segments that begin where the program's real-mode segment does, so that addresses are the same
# in both modes and nothing is relocated.
  .section .dos,"ax"
  .code16
  .globl dos_start
dos_start:
  pushf                        # an i486? The 8086 cannot clear bits 12 to 15 of its flags, the 80286 cannot set them,
  pop bx                       # and the 80386 has no bit 18
  mov ax, bx
  and ah, 0x0f
  push ax
  popf
  pushf
  pop ax
  and ah, 0xf0
  cmp ah, 0xf0
  je too_old
  mov ah, 0x70
  push ax
  popf
  pushf
  pop ax
  push bx
  popf
  test ah, 0x70
  jz too_old
  pushfd
  pop eax
  mov ecx, eax
  xor eax, 0x40000
  push eax
  popfd
  pushfd
  pop eax
  push ecx
  popfd
  xor eax, ecx
  test eax, 0x40000
  jz too_old

  smsw ax                      # a memory manager (EMM386) has the protected mode, and this is its virtual 8086
  mov dx, offset not_real
  mov cl, 4                    # errorlevels: see Exit in dos.rs
  test al, 1
  jnz refuse
  mov ax, cs
  mov dx, offset too_little
  mov cl, 5
  add ax, offset __paragraphs
  jc refuse
  cmp ax, word ptr [2]
  ja refuse

  mov ax, cs
  mov word ptr [real_segment], ax
  add ax, offset __real_stack  # that which DOS gave may lie in the program's own memory
  mov word ptr [real_stack], ax
  mov ss, ax
  mov sp, offset __real_stack_size
  xor eax, eax
  mov ax, cs
  shl eax, 4
  mov dword ptr [base], eax
  mov word ptr [code32 + 2], ax
  mov word ptr [data32 + 2], ax
  mov word ptr [code16 + 2], ax
  mov word ptr [data16 + 2], ax
  mov ebx, eax
  shr ebx, 16
  mov byte ptr [code32 + 4], bl
  mov byte ptr [data32 + 4], bl
  mov byte ptr [code16 + 4], bl
  mov byte ptr [data16 + 4], bl
  add eax, offset gdt
  mov dword ptr [gdt_pointer + 2], eax

enter:                         # ds = cs
  cli
  lgdt [gdt_pointer]
  mov eax, cr0
  or al, 1
  mov cr0, eax
  .byte 0x66, 0xea             # jmp 8:protected, with an offset of 32 bits
  .long protected
  .word 8

too_old:
  mov dx, offset old
  mov cl, 6
refuse:
  mov ah, 9
  int 0x21
  mov al, cl
  mov ah, 0x4c
  int 0x21

  .code32
protected:
  mov ax, 16
  mov ds, ax
  mov es, ax
  mov fs, ax
  mov gs, ax
  mov ss, ax
  mov esp, dword ptr [protected_stack]
  cld
  jmp dword ptr [continue]

begin:
  mov edi, offset __bss_start
  mov ecx, offset __bss_end
  sub ecx, edi
  xor eax, eax
  rep stosb
  push dword ptr [base]
  call dos_main                # does not return

# extern "C" fn(registers: *mut Registers, number: u32): calls an interrupt of DOS or of the BIOS in real mode, with
# interrupts enabled. Those of the hardware that have waited since the last call are served first.
  .globl real_interrupt
real_interrupt:
  pushad
  mov esi, dword ptr [esp + 36]
  mov eax, dword ptr [esp + 40]
  mov byte ptr [number], al
  mov edi, offset registers
  mov ecx, 3
  rep movsd
  mov dword ptr [protected_stack], esp
  mov dword ptr [continue], offset returned
  .byte 0xea                   # jmp 24:narrow
  .long narrow
  .word 24

returned:
  mov esi, offset registers
  mov edi, dword ptr [esp + 36]
  mov ecx, 3
  rep movsd
  popad
  ret

  .code16
narrow:
  mov ax, 32                   # segments of 64 KiB, as real mode must have them
  mov ds, ax
  mov es, ax
  mov fs, ax
  mov gs, ax
  mov ss, ax
  mov eax, cr0
  and al, 0xfe
  mov cr0, eax
  .byte 0xea                   # jmp real_segment:real
  .word real
real_segment:
  .word 0
real:
  mov ax, cs
  mov ds, ax
  mov es, ax
  mov fs, ax
  mov gs, ax
  mov ss, word ptr [real_stack]
  mov sp, offset __real_stack_size
  sti
  nop
  mov ax, word ptr [registers]
  mov bx, word ptr [registers + 2]
  mov cx, word ptr [registers + 4]
  mov dx, word ptr [registers + 6]
  mov ds, word ptr [registers + 8]
  .byte 0xcd                   # int number
number:
  .byte 0
  pushf
  push cs
  pop ds
  mov word ptr [registers], ax
  mov word ptr [registers + 2], bx
  mov word ptr [registers + 4], cx
  mov word ptr [registers + 6], dx
  pop ax
  mov word ptr [registers + 10], ax
  jmp enter

# DOS calls this for Ctrl-Break: nothing happens, so that it does not end the program while the screen shows a picture.
  .globl ignore_break
ignore_break:
  iret

# DOS calls this where a drive is not ready or write-protected: the function that wanted it fails, and nobody is asked.
  .globl fail_critical
fail_critical:
  mov al, 3
  iret

old:
  .ascii "rta: the processor is older than an i486\r\n$"
not_real:
  .ascii "rta: the processor is not in real mode; start DOS without EMM386 or another that has the protected mode\r\n$"
too_little:
  .ascii "rta: too little memory below 640 KiB\r\n$"

  .align 4
base:                          # linear address of the program's segment
  .long 0
continue:                      # where protected mode goes on
  .long begin
protected_stack:
  .long __stack_high
registers:                     # ax, bx, cx, dx, ds, flags
  .word 0, 0, 0, 0, 0, 0
real_stack:                    # its segment
  .word 0
  .align 8
gdt:                           # none; code and data of 4 GiB, 32-bit; code and data of 64 KiB, 16-bit; all from the base on
  .quad 0
code32:
  .quad 0x00cf9a000000ffff
data32:
  .quad 0x00cf92000000ffff
code16:
  .quad 0x00009a000000ffff
data16:
  .quad 0x000092000000ffff
gdt_pointer:
  .word 39
  .long 0
