//! A display whose screen is two files of the computer that a debugger, or an emulator, runs on.
//!
//! Semihosting: the board stops with a number and the address of a block of words, the host does what
//! they ask for and lets it go on. Cortex-M and RISC-V boards have the same numbers and blocks and differ
//! in how they stop: that is [`Host`]. No row has to be kept, so a board with 16 KiB of RAM suffices.

use core::ffi::CStr;
use core::fmt;

use rta_core::color::Rgb;
use rta_drivers::display::{Capabilities, Display, DriverError};

/// A screen that has just room for the picture, with a VGA's colours.
pub const CAPABILITIES: Capabilities =
    Capabilities { width: crate::WIDTH, height: crate::HEIGHT, colors: 256, gun_max: 63, aspect: (4, 3) };

/// What was loaded into the colour table, load after load: first entry, number of colours - 1, and three
/// levels (red, green, blue) for each colour.
const COLORS_FILE: &CStr = c"colors.raw";
/// The index of each pixel, row after row.
const PIXELS_FILE: &CStr = c"pixels.raw";

/// Opens a file: address of its name, mode, length of the name. Gives a handle, or all ones.
const SYS_OPEN: usize = 0x01;
/// Writes to a file: handle, address, length. Gives the number of bytes not written.
const SYS_WRITE: usize = 0x05;
/// Mode of `SYS_OPEN`: `fopen`'s "wb".
const WRITE_BINARY: usize = 5;

/// A way to the host.
pub trait Host {
    /// Stops the board with `operation` and the address of `block`; gives what the host answers.
    ///
    /// # Safety
    /// `block` must be what `operation` expects, and the addresses in it must be those of memory that
    /// the host may access.
    unsafe fn call(&mut self, operation: usize, block: &[usize; 3]) -> usize;
}

/// What a stream's host, or the order of a picture, forbids.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StreamError {
    /// The host could not open a file.
    Open,
    /// The host could not write all bytes.
    Write,
    /// A file cannot take a pixel other than the next one.
    Order,
}

impl fmt::Display for StreamError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Open => "the host could not open a file",
            Self::Write => "the host could not write a file",
            Self::Order => "the pixels do not follow those written last",
        })
    }
}

impl core::error::Error for StreamError {}

/// The display: takes pixels from top to bottom and from left to right only.
#[derive(Debug)]
pub struct Stream<H> {
    host: H,
    colors: usize,
    pixels: usize,
    /// Pixels written so far.
    written: u32,
}

impl<H: Host> Stream<H> {
    /// Opens both files; older ones are overwritten. The host closes them when the board's program ends.
    ///
    /// # Errors
    /// [`StreamError::Open`].
    pub fn open(mut host: H) -> Result<Self, StreamError> {
        let colors = open(&mut host, COLORS_FILE)?;
        let pixels = open(&mut host, PIXELS_FILE)?;
        Ok(Self { host, colors, pixels, written: 0 })
    }
}

impl<H: Host> Display for Stream<H> {
    type Error = DriverError<StreamError>;

    fn capabilities(&self) -> Capabilities {
        CAPABILITIES
    }

    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error> {
        self.capabilities().check_colors(first, colors)?;
        // At most 256 colours passed the check; no colours leave no trace.
        let Some(Ok(last)) = colors.len().checked_sub(1).map(u8::try_from) else {
            return Ok(());
        };
        write(&mut self.host, self.colors, &[first, last])?;
        for color in colors {
            write(&mut self.host, self.colors, &[color.r, color.g, color.b])?;
        }
        Ok(())
    }

    fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error> {
        self.capabilities().check_pixels(x, y, indices.len())?;
        if self.written != y * crate::WIDTH + x {
            return Err(StreamError::Order.into());
        }
        write(&mut self.host, self.pixels, indices)?;
        // No more than a row has, by the first check.
        self.written += indices.len() as u32;
        Ok(())
    }
}

/// Opens a file for writing, gives its handle.
fn open(host: &mut impl Host, name: &CStr) -> Result<usize, StreamError> {
    let block = [name.as_ptr().expose_provenance(), WRITE_BINARY, name.count_bytes()];
    // SAFETY: the block of SYS_OPEN, with a name that lives as long as the program.
    let handle = unsafe { host.call(SYS_OPEN, &block) };
    if handle == usize::MAX { Err(StreamError::Open) } else { Ok(handle) }
}

/// Writes `bytes` to the file of `handle`.
fn write(host: &mut impl Host, handle: usize, bytes: &[u8]) -> Result<(), StreamError> {
    let block = [handle, bytes.as_ptr().expose_provenance(), bytes.len()];
    // SAFETY: the block of SYS_WRITE, with the address and the length of borrowed bytes.
    let left = unsafe { host.call(SYS_WRITE, &block) };
    if left == 0 { Ok(()) } else { Err(StreamError::Write) }
}
