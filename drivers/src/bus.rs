//! How a driver reaches the hardware: small traits, [`Ports`], [`Memory`], [`Registers`] and [`CommandData`].
//!
//! # For driver authors
//!
//! Be generic over the bus, and ask for no more traits than the device needs: the VGA driver asks for
//! `B: Ports + Memory`, the Sun cgthree for `B: Registers + Memory`, the SSD0323 for `B: CommandData`. Offsets count from the start of the device, so the
//! addresses at which a machine has it do not concern the driver.
//!
//! # For bus authors
//!
//! Implement the traits on the type of your firmware that owns the device. This is the one place where `unsafe`
//! belongs: the `in` and `out` instructions of a PC, volatile accesses at A0000h or 50800000h. An implementation has
//! three duties: accesses reach the device in the order in which they are made, none is left out or merged with
//! another, and an offset outside the device touches nothing. The head of the crate has an example.
//!
//! The emulated devices ([`crate::vga13h::emulated`], [`crate::pixrect::emulated`], [`crate::ssd0323::emulated`]) implement the same
//! traits, so one driver serves both.
//!
//! No call returns an error, because the hardware reports none: a port that nobody answers reads as FFh.

use core::fmt;

/// The 8-bit I/O ports of a PC.
pub trait Ports {
    /// Writes `value` to `port` (the instruction `out dx, al`).
    fn out8(&mut self, port: u16, value: u8);
    /// Reads `port` (the instruction `in al, dx`). A port that nobody answers reads FFh.
    fn in8(&mut self, port: u16) -> u8;
}

/// A window of video memory, one byte an address: the 64 KiB at A0000h of a VGA, the frame buffer of a cgthree.
///
/// Offsets count bytes from the start of the window. Bytes beyond its end are not written and read as FFh.
pub trait Memory {
    /// Writes `bytes` to `offset` and the addresses after it.
    fn write(&mut self, offset: u32, bytes: &[u8]);
    /// Fills `bytes` from `offset` and the addresses after it.
    fn read(&mut self, offset: u32, bytes: &mut [u8]);
}

/// The memory-mapped registers of a board, accessed as bytes or as big-endian words of 32 bits.
///
/// Offsets count bytes from the board's first register; those of words are multiples of 4.
pub trait Registers {
    /// Writes one byte to the register at `offset`.
    fn write8(&mut self, offset: u32, value: u8);
    /// Reads one byte from the register at `offset`.
    fn read8(&mut self, offset: u32) -> u8;
    /// Writes one word of 32 bits in a single access. Its most significant byte has the lowest address.
    fn write32(&mut self, offset: u32, value: u32);
}

/// A serial bus to a display controller, which is written only. A line beside it, D/C, tells commands from what is for the controller's
/// graphic memory.
pub trait CommandData {
    /// Sends the bytes of commands and their arguments.
    fn command(&mut self, bytes: &[u8]);
    /// Sends bytes for the graphic memory.
    fn data(&mut self, bytes: &[u8]);
}

impl<T: CommandData + ?Sized> CommandData for &mut T {
    fn command(&mut self, bytes: &[u8]) {
        T::command(self, bytes);
    }
    fn data(&mut self, bytes: &[u8]) {
        T::data(self, bytes);
    }
}

impl<T: Ports + ?Sized> Ports for &mut T {
    fn out8(&mut self, port: u16, value: u8) {
        T::out8(self, port, value);
    }
    fn in8(&mut self, port: u16) -> u8 {
        T::in8(self, port)
    }
}

impl<T: Memory + ?Sized> Memory for &mut T {
    fn write(&mut self, offset: u32, bytes: &[u8]) {
        T::write(self, offset, bytes);
    }
    fn read(&mut self, offset: u32, bytes: &mut [u8]) {
        T::read(self, offset, bytes);
    }
}

impl<T: Registers + ?Sized> Registers for &mut T {
    fn write8(&mut self, offset: u32, value: u8) {
        T::write8(self, offset, value);
    }
    fn read8(&mut self, offset: u32) -> u8 {
        T::read8(self, offset)
    }
    fn write32(&mut self, offset: u32, value: u32) {
        T::write32(self, offset, value);
    }
}

/// The error that the memory lent to an emulated device is smaller than the device's own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShortMemory {
    /// Bytes of memory that the device has.
    pub needed: usize,
    /// Bytes of memory that were lent.
    pub found: usize,
}

impl fmt::Display for ShortMemory {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the device has {} bytes of memory, {} were lent", self.needed, self.found)
    }
}

impl core::error::Error for ShortMemory {}

/// Writes `bytes` into `memory` from `offset` up; bytes beyond its end are dropped.
pub(crate) fn write_clipped(memory: &mut [u8], offset: u32, bytes: &[u8]) {
    let start = usize::try_from(offset).unwrap_or(usize::MAX);
    for (to, &from) in memory.iter_mut().skip(start).zip(bytes) {
        *to = from;
    }
}

/// Fills `bytes` from `memory` from `offset` up; beyond its end they read as FFh.
pub(crate) fn read_clipped(memory: &[u8], offset: u32, bytes: &mut [u8]) {
    let start = usize::try_from(offset).unwrap_or(usize::MAX);
    let mut source = memory.get(start..).unwrap_or(&[]).iter();
    for to in bytes {
        *to = source.next().copied().unwrap_or(0xFF);
    }
}
