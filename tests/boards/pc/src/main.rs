//! A PC with a VGA: draws a picture in mode 13h.
//!
//! Three ways to come up, one feature each. Without an operating system ([`bare`]): `multiboot` is an ELF for a multiboot
//! loader and sets the mode by the VGA's registers; `floppy` brings a boot sector and leaves the mode to the BIOS. With one:
//! `dos` is a DOS program ([`dos`]) of several scenes.

#![no_std]
#![no_main]

#[cfg(not(feature = "dos"))]
mod bare;
#[cfg(feature = "dos")]
mod dos;
mod port;
mod vga;

#[cfg(any(
    all(feature = "floppy", feature = "multiboot"),
    all(feature = "floppy", feature = "dos"),
    all(feature = "multiboot", feature = "dos")
))]
compile_error!("features `floppy`, `multiboot` and `dos` exclude each other");
#[cfg(not(any(feature = "floppy", feature = "multiboot", feature = "dos")))]
compile_error!("choose how to boot: feature `floppy`, `multiboot` or `dos`");
