//! What a driver needs of the machine: a bus is a trait.
//!
//! Driver authors: ask for the smallest of the three traits that will do. VGA wants [`Ports`] and
//! [`Memory`], the Sun cgthree wants [`Registers`] and [`Memory`].
//!
//! Board authors: implement the traits on the type that owns the addresses. This is the one place of a
//! machine where `unsafe` belongs: `out`/`in` instructions, volatile accesses at A0000h or 50800000h.
//! The emulated back ends ([`crate::vga13h::emulated`], [`crate::pixrect::emulated`]) implement the same
//! traits, so one driver serves both.
//!
//! None of the calls can fail: a port or an address answers whether or not anybody is there.

use core::fmt;

/// The 8-bit I/O ports of a PC.
pub trait Ports {
    /// Writes `value` to `port` (`out dx, al`).
    fn out8(&mut self, port: u16, value: u8);
    /// Reads `port` (`in al, dx`). A port that nobody answers reads FFh.
    fn in8(&mut self, port: u16) -> u8;
}

/// A window of byte-addressed video memory: A0000h of a VGA, the frame buffer of a cgthree.
///
/// Offsets count bytes from the start of the window. What lies beyond the window is not written and
/// reads FFh.
pub trait Memory {
    /// Writes `bytes` at `offset`, upwards.
    fn write(&mut self, offset: u32, bytes: &[u8]);
    /// Reads into `bytes` from `offset`, upwards.
    fn read(&mut self, offset: u32, bytes: &mut [u8]);
}

/// Memory-mapped registers of a board: bytes and big-endian words.
///
/// Offsets count bytes from the board's first register.
pub trait Registers {
    /// Writes one byte.
    fn write8(&mut self, offset: u32, value: u8);
    /// Reads one byte.
    fn read8(&mut self, offset: u32) -> u8;
    /// Writes one 32-bit word; its most significant byte goes first.
    fn write32(&mut self, offset: u32, value: u32);
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

/// The memory lent to an emulated device is smaller than the device's own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShortMemory {
    /// Bytes the device has.
    pub needed: usize,
    /// Bytes that were lent.
    pub found: usize,
}

impl fmt::Display for ShortMemory {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the device has {} bytes of memory, {} were lent", self.needed, self.found)
    }
}

impl core::error::Error for ShortMemory {}

/// Writes `bytes` into `memory`; what lies beyond it is dropped.
pub(crate) fn write_clipped(memory: &mut [u8], offset: u32, bytes: &[u8]) {
    let start = usize::try_from(offset).unwrap_or(usize::MAX);
    for (to, &from) in memory.iter_mut().skip(start).zip(bytes) {
        *to = from;
    }
}

/// Reads from `memory`; what lies beyond it reads FFh.
pub(crate) fn read_clipped(memory: &[u8], offset: u32, bytes: &mut [u8]) {
    let start = usize::try_from(offset).unwrap_or(usize::MAX);
    let mut source = memory.get(start..).unwrap_or(&[]).iter();
    for to in bytes {
        *to = source.next().copied().unwrap_or(0xFF);
    }
}
