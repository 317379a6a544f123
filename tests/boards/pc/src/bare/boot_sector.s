# Sector 0 of the disk. The BIOS loads it at 7c00h and jumps there in real mode, drive number in dl.
# Sets mode 13h, reads the other sectors to 7e00h and up, and enters flat 32-bit protected mode at _start.
# All is below 1 MiB, so the A20 gate may stay as it is.
  .section .boot_sector,"ax"
  .code16
  .globl boot_sector
boot_sector:
  .byte 0xea                   # jmp 0:normal; some BIOSes come in as 07c0:0000
  .word normal, 0
normal:
  cli
  xor ax, ax
  mov ds, ax
  mov ss, ax
  mov sp, 0x7c00               # the stack grows down from the sector
  sti
  cld
  mov byte ptr [drive], dl
  mov ax, 0x0013
  int 0x10

# One sector a call, each to an address that is a multiple of 512: no read crosses a 64 KiB boundary,
# which the floppy's DMA could not. es advances instead of bx, so the image may be larger than a segment.
  mov ax, 0x07e0
  mov es, ax
  mov si, 1                    # next sector, counted from the start of the disk
  mov di, offset __sectors_to_read
read:
  mov byte ptr [tries], 4      # a real drive that has just been started fails once or twice
again:
  mov ax, si                   # 18 sectors a track, 2 heads
  xor dx, dx
  mov bx, 18
  div bx                       # ax = track over both heads, dx = sector of it from 0
  mov cl, dl
  inc cl                       # sector from 1
  mov dh, al
  and dh, 1                    # head
  shr ax, 1
  mov ch, al                   # cylinder
  mov dl, byte ptr [drive]
  xor bx, bx
  mov ax, 0x0201               # read, one sector, to es:bx
  int 0x13
  jnc next
  xor ah, ah                   # reset the drive
  mov dl, byte ptr [drive]
  int 0x13
  dec byte ptr [tries]
  jnz again
  mov al, 52                   # exit code DISK (main.rs)
  mov dx, 0xf4
  out dx, al
halt:
  hlt
  jmp halt
next:
  mov ax, es
  add ax, 0x20
  mov es, ax
  inc si
  dec di
  jnz read

  mov dx, 0x3f2                # motors off: the BIOS's timer, which would do it, stops with the cli
  xor al, al
  out dx, al
  cli
  lgdt [gdt_pointer]
  mov eax, cr0
  or al, 1
  mov cr0, eax
  .byte 0xea                   # jmp 8:protected
  .word protected, 8

drive:
  .byte 0
tries:
  .byte 0
  .align 8
gdt:                           # none; code and data, both flat: base 0, 4 GiB, 32-bit
  .quad 0, 0x00cf9a000000ffff, 0x00cf92000000ffff
gdt_pointer:
  .word 23
  .long gdt

  .code32
protected:
  mov ax, 16
  mov ds, ax
  mov es, ax
  mov ss, ax
  mov fs, ax
  mov gs, ax
  jmp _start
  .org 510
  .word 0xaa55                 # what the BIOS knows a boot sector by
