//! Calls of DOS and of the BIOS, which are made in real mode.

use core::ffi::CStr;
use core::ptr;

/// The registers that an interrupt is called with and that it returns.
#[repr(C)]
#[derive(Clone, Copy, Default)]
struct Registers {
    ax: u16,
    bx: u16,
    cx: u16,
    dx: u16,
    ds: u16,
    flags: u16,
}

/// Flags: the carry, which DOS sets where a function failed, and zero.
const CARRY: u16 = 0x01;
const ZERO: u16 = 0x40;

/// Interrupts: screen, keyboard, DOS.
const SCREEN: u32 = 0x10;
const KEYBOARD: u32 = 0x16;
const DOS: u32 = 0x21;

/// Handle of the standard output.
const STANDARD_OUTPUT: u16 = 1;

unsafe extern "C" {
    /// Calls an interrupt in real mode; start.s has it.
    fn real_interrupt(registers: *mut Registers, number: u32);
    /// Handlers of Ctrl-Break and of critical errors, code of real mode in start.s.
    static ignore_break: u8;
    static fail_critical: u8;
}

/// DOS and the BIOS below it.
#[derive(Clone, Copy)]
pub(crate) struct System {
    /// The program's segment.
    segment: u16,
}

/// What DOS refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FileError {
    /// The file cannot be made.
    Create,
    /// Not all of it can be written.
    Write,
}

/// An open file.
#[derive(Clone, Copy)]
pub(crate) struct File(u16);

impl System {
    /// Takes DOS; `base` is the linear address of the program's segment.
    ///
    /// # Safety
    /// On DOS only, in the protected mode of start.s with this base; one caller at a time may use it.
    pub(crate) unsafe fn open(base: u32) -> Self {
        let [low, high, ..] = (base >> 4).to_le_bytes();
        Self { segment: u16::from_le_bytes([low, high]) }
    }

    fn call(self, number: u32, mut registers: Registers) -> Registers {
        // SAFETY: `open` promises that this is DOS; the callers below name functions that write no memory of the program.
        unsafe { real_interrupt(&raw mut registers, number) };
        registers
    }

    /// Returns segment and offset of something in the program, for real mode.
    fn far<T: ?Sized>(self, at: *const T) -> (u16, u16) {
        // All of the program lies below 640 KiB, so that the paragraph is below A000h.
        let [low, high, third, _] = at.cast::<u8>().expose_provenance().to_le_bytes();
        let paragraph = u16::from_le_bytes([low, high]) >> 4 | u16::from(third) << 12;
        (self.segment.wrapping_add(paragraph), u16::from(low & 15))
    }

    /// Lets neither Ctrl-Break nor a drive that is not ready end the program or write on its picture. DOS restores both
    /// handlers when the program ends.
    pub(crate) fn keep_control(self) {
        for (function, handler) in [(0x2523, &raw const ignore_break), (0x2524, &raw const fail_critical)] {
            // They lie in the first 64 KiB: their code is of real mode.
            let [low, high, ..] = handler.addr().to_le_bytes();
            let dx = u16::from_le_bytes([low, high]);
            self.call(DOS, Registers { ax: function, dx, ds: self.segment, ..Registers::default() });
        }
    }

    /// Returns the screen's mode.
    pub(crate) fn mode(self) -> u8 {
        let [mode, _] = self.call(SCREEN, Registers { ax: 0x0F00, ..Registers::default() }).ax.to_le_bytes();
        mode & 0x7F
    }

    /// Sets the screen's mode and clears it.
    pub(crate) fn set_mode(self, mode: u8) {
        self.call(SCREEN, Registers { ax: mode.into(), ..Registers::default() });
    }

    /// Takes a key out of the keyboard's buffer, if there is one.
    pub(crate) fn take_key(self) -> bool {
        let waits = self.call(KEYBOARD, Registers { ax: 0x0100, ..Registers::default() }).flags & ZERO == 0;
        if waits {
            self.wait_key();
        }
        waits
    }

    /// Waits for a key and takes it.
    pub(crate) fn wait_key(self) {
        self.call(KEYBOARD, Registers::default());
    }

    /// Writes to the standard output.
    pub(crate) fn say(self, words: &[u8]) {
        // Nobody could be told of a failure.
        let _ = self.write(File(STANDARD_OUTPUT), words);
    }

    /// Makes an empty file, in the place of one of this name if there is one.
    ///
    /// # Errors
    /// [`FileError::Create`]: the file or the disk is read-only, or the folder is full.
    pub(crate) fn create(self, name: &CStr) -> Result<File, FileError> {
        let (ds, dx) = self.far(name.as_ptr());
        let made = self.call(DOS, Registers { ax: 0x3C00, dx, ds, ..Registers::default() });
        if made.flags & CARRY == 0 { Ok(File(made.ax)) } else { Err(FileError::Create) }
    }

    /// Writes at the end of a file, at most 32 KiB at a time.
    ///
    /// # Errors
    /// [`FileError::Write`]: the disk has no room for all of it, or fails.
    pub(crate) fn write(self, file: File, bytes: &[u8]) -> Result<(), FileError> {
        for part in bytes.chunks(0x8000) {
            let (ds, dx) = self.far(part.as_ptr());
            let [low, high, ..] = part.len().to_le_bytes();
            let cx = u16::from_le_bytes([low, high]);
            let wrote = self.call(DOS, Registers { ax: 0x4000, bx: file.0, cx, dx, ds, flags: 0 });
            // Where the disk is full, DOS writes less than it was asked to and calls it no error.
            if wrote.flags & CARRY != 0 || wrote.ax != cx {
                return Err(FileError::Write);
            }
        }
        Ok(())
    }

    /// Closes a file.
    ///
    /// # Errors
    /// [`FileError::Write`]: what was written before cannot be kept.
    pub(crate) fn close(self, file: File) -> Result<(), FileError> {
        let closed = self.call(DOS, Registers { ax: 0x3E00, bx: file.0, ..Registers::default() });
        if closed.flags & CARRY == 0 { Ok(()) } else { Err(FileError::Write) }
    }

    /// Deletes a file.
    pub(crate) fn delete(self, name: &CStr) {
        let (ds, dx) = self.far(name.as_ptr());
        self.call(DOS, Registers { ax: 0x4100, dx, ds, ..Registers::default() });
    }

    /// Returns what stands on the command line after the program's name.
    pub(crate) fn command_tail(self) -> &'static [u8] {
        // SAFETY: DOS has written the length, below 128, at offset 80h of the program's segment and the text after it, and
        // nothing writes there.
        unsafe {
            let length = ptr::with_exposed_provenance::<u8>(0x80).read();
            core::slice::from_raw_parts(ptr::with_exposed_provenance(0x81), usize::from(length & 0x7F))
        }
    }

    /// Ends the program; the batch file that called it sees the errorlevel.
    pub(crate) fn exit(self, errorlevel: u8) -> ! {
        self.call(DOS, Registers { ax: 0x4C00 | u16::from(errorlevel), ..Registers::default() });
        loop {
            core::hint::spin_loop();
        }
    }
}
