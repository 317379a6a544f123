//! A DOS program: draws one of several baked scenes in mode 13h, writes it as RTA.PCX, waits for a key and returns to the
//! prompt. It runs in protected mode and goes to real mode for each call of DOS and of the BIOS.

mod arguments;
mod pcx;
mod scenes;
mod system;
mod until_key;

use core::arch::global_asm;
use core::ffi::CStr;
use core::panic::PanicInfo;
use core::sync::atomic::{AtomicU32, Ordering};

use arguments::Wish;
use picture::DrawError;
use rta_core::color::Rgb;
use rta_drivers::display::ReadBack;
use rta_drivers::vga13h::{CAPABILITIES, Mode13h};
use system::{File, FileError, System};
use until_key::{Refused, UntilKey};

use crate::vga::Vga;

global_asm!(include_str!("dos/start.s"));

/// The program's errorlevel. Three more are start.s's: 4, the processor is not in real mode; 5, there is too little memory;
/// 6, the processor is older than an i486.
#[repr(u8)]
#[derive(Clone, Copy)]
enum Exit {
    /// The picture was drawn and written.
    Done = 0,
    /// A key was pressed before it was complete.
    Stopped = 1,
    /// The command line names no scene.
    Usage = 2,
    /// The file cannot be written.
    File = 3,
    /// The tracer or the display refused something.
    Refused = 7,
    /// The program panicked.
    Panic = 8,
}

/// The file that the picture is written to, in the current folder.
const NAME: &CStr = c"RTA.PCX";

/// The screen's mode of 320 x 200 pixels and 256 colours.
const MODE_13H: u8 = 0x13;

/// The text mode of 80 columns, which a program that panicked leaves.
const MODE_TEXT: u8 = 0x03;

/// Linear address of the program's segment, for a panic.
static BASE: AtomicU32 = AtomicU32::new(0);

/// Called by start.s in protected mode with the linear address of the program's segment: .bss is clear, interrupts are off.
#[unsafe(no_mangle)]
extern "C" fn dos_main(base: u32) -> ! {
    BASE.store(base, Ordering::Relaxed);
    // SAFETY: start.s has seen to DOS and to the mode, and this is the only caller but for a panic.
    let system = unsafe { System::open(base) };
    let scene = match arguments::wish(system.command_tail(), &scenes::NAMES) {
        Wish::Scene(scene) => scene,
        wish => {
            tell_usage(system, wish);
            system.exit(Exit::Usage as u8);
        }
    };
    system.keep_control();
    let before = system.mode();
    // Keys of the time before the picture do not stop it.
    while system.take_key() {}
    system.set_mode(MODE_13H);
    // SAFETY: this is a PC in mode 13h and the program has it to itself.
    let vga = unsafe { Vga::open(base) };
    let display = UntilKey { display: Mode13h::after_bios(vga), system };
    let drawn = scenes::draw(scene, display, picture::adaptive(CAPABILITIES.gun_max));
    let written = drawn.map(|UntilKey { mut display, .. }| save(system, &mut display));
    if let Ok(Ok(())) = written {
        system.wait_key();
    }
    system.set_mode(before);
    let (words, exit): (&[u8], _) = match written {
        Ok(Ok(())) => (b"", Exit::Done),
        Ok(Err(FileError::Create)) => (b"rta: RTA.PCX cannot be made here\r\n", Exit::File),
        Ok(Err(FileError::Write)) => (b"rta: no room on the disk for RTA.PCX\r\n", Exit::File),
        Err(DrawError::Display(Refused::Key)) => (b"rta: stopped, no file written\r\n", Exit::Stopped),
        Err(_) => (b"rta: the scene cannot be drawn\r\n", Exit::Refused),
    };
    system.say(words);
    system.exit(exit as u8)
}

/// Says what is wrong with the command line, and how it is used.
fn tell_usage(system: System, wish: Wish<'_>) {
    if let Wish::Unknown(word) = wish {
        system.say(b"rta: there is no scene ");
        system.say(word);
        system.say(b"\r\n");
    }
    system.say(b"RTA [SCENE] draws a scene and writes RTA.PCX; a key stops it. Scenes: ");
    for (number, name) in scenes::NAMES.iter().enumerate() {
        if number > 0 {
            system.say(b", ");
        }
        system.say(name.as_bytes());
    }
    system.say(b"\r\n");
}

/// Writes what the screen shows as a PCX file; leaves no file where that fails.
fn save<D: ReadBack>(system: System, display: &mut D) -> Result<(), FileError> {
    let file = system.create(NAME)?;
    let written = write(system, file, display);
    let closed = system.close(file);
    let saved = written.and(closed);
    if saved.is_err() {
        system.delete(NAME);
    }
    saved
}

fn write<D: ReadBack>(system: System, file: File, display: &mut D) -> Result<(), FileError> {
    // What the driver itself has drawn, it can read.
    let unread = |_| FileError::Write;
    system.write(file, &pcx::header(WIDTH as u16, HEIGHT as u16))?;
    let mut bytes = Bytes::new();
    for y in 0..HEIGHT {
        let mut row = [0; WIDTH as usize];
        display.read_pixels(0, y, &mut row).map_err(unread)?;
        pcx::row(&row, |byte| bytes.put(byte));
        system.write(file, bytes.take())?;
    }
    let mut colors = [Rgb::new(0, 0, 0); 256];
    display.read_colors(0, &mut colors).map_err(unread)?;
    pcx::table(&colors, CAPABILITIES.gun_max, |byte| bytes.put(byte));
    system.write(file, bytes.take())
}

/// The raster of the screen.
const WIDTH: u32 = CAPABILITIES.width;
const HEIGHT: u32 = CAPABILITIES.height;

/// Bytes that are written at once: a row at its longest, or the colour table.
struct Bytes {
    bytes: [u8; 770],
    used: usize,
}

impl Bytes {
    const fn new() -> Self {
        Self { bytes: [0; 770], used: 0 }
    }

    fn put(&mut self, byte: u8) {
        if let Some(place) = self.bytes.get_mut(self.used) {
            *place = byte;
            self.used += 1;
        }
    }

    /// Returns what was put since the last call.
    fn take(&mut self) -> &[u8] {
        let used = core::mem::take(&mut self.used);
        self.bytes.get(..used).unwrap_or(&[])
    }
}

/// Says the place, as a file's name and a line, in text mode.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    // SAFETY: as in `dos_main`, which will not run again.
    let system = unsafe { System::open(BASE.load(Ordering::Relaxed)) };
    system.set_mode(MODE_TEXT);
    system.say(b"rta: panic at ");
    if let Some(place) = info.location() {
        picture::report(place.file(), u64::from(place.line()), |byte| system.say(&[byte]));
    }
    system.exit(Exit::Panic as u8)
}
