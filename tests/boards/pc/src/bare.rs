//! The program without an operating system: draws the picture, reports on COM1 and answers there (see
//! [`picture::console`]).

mod serial;
mod stack;
mod timer;

use core::arch::global_asm;
use core::panic::PanicInfo;

use picture::console::Serial;
use rta_drivers::vga13h::{CAPABILITIES, Mode13h};
use serial::Com1;

use crate::port;
use crate::vga::Vga;

#[cfg(feature = "multiboot")]
global_asm!(include_str!("bare/multiboot.s"));
#[cfg(feature = "floppy")]
global_asm!(include_str!("bare/boot_sector.s"));
global_asm!(include_str!("bare/start.s"));

/// The picture's upper left pixel: it stands in the middle.
const ORIGIN: (u32, u32) =
    ((CAPABILITIES.width - picture::WIDTH) / 2, (CAPABILITIES.height - picture::HEIGHT) / 2);

/// What the machine says when it ends; QEMU's isa-debug-exit makes it the status `2 * code + 1`.
#[repr(u8)]
#[derive(Clone, Copy)]
enum Exit {
    /// All went well and `Q` came.
    Done = 0,
    /// The program panicked.
    Panic = 50,
    /// The tracer or the display refused something. (52 is the boot sector's: the disk cannot be read.)
    Refused = 51,
}

/// Called by start.s: .bss is clear, the stack is painted, interrupts are off.
#[unsafe(no_mangle)]
extern "C" fn board_main() -> ! {
    // SAFETY: this is a PC and nobody else uses COM1; an earlier panic has not returned.
    let mut com1 = unsafe { Com1::open() };
    match run(&mut com1) {
        Ok(()) => exit(Exit::Done),
        Err(code) => exit(code),
    }
}

fn run(com1: &mut Com1) -> Result<(), Exit> {
    // SAFETY: this is a PC with a VGA, in flat memory, and nobody else uses the VGA.
    let vga = unsafe { Vga::open(0) };
    let display = if cfg!(feature = "floppy") {
        // The boot sector has asked the BIOS for the mode.
        Mode13h::after_bios(vga)
    } else {
        Mode13h::program(vga)
    };
    // SAFETY: this is a PC, interrupts are off, and nobody else uses the timer.
    let mut elapsed = unsafe { timer::start() };
    let drawn = picture::draw(display, picture::adaptive(CAPABILITIES.gun_max), ORIGIN, || {
        elapsed.look();
    });
    let ticks = elapsed.look();
    let mut display = drawn.map_err(|_| Exit::Refused)?;
    for (name, value) in picture::facts(picture::table()) {
        picture::report(name, value, |byte| com1.put(byte));
    }
    picture::report("stack", stack::high_water(), |byte| com1.put(byte));
    picture::report("nanoseconds", timer::nanoseconds(ticks), |byte| com1.put(byte));
    picture::console::serve(com1, &mut display, ORIGIN).map_err(|_| Exit::Refused)
}

/// Ends the machine, or where there is no isa-debug-exit leaves it standing with the picture shown.
fn exit(code: Exit) -> ! {
    // SAFETY: port F4h is isa-debug-exit; nobody answers there on a machine without it.
    unsafe { port::out8(0xF4, code as u8) };
    loop {
        core::hint::spin_loop();
    }
}

/// Reports the place, as a file's name and a line; the message would need `core::fmt`.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    // SAFETY: this is a PC; the one who used COM1 will not run again.
    let mut com1 = unsafe { Com1::open() };
    if let Some(place) = info.location() {
        picture::report(place.file(), u64::from(place.line()), |byte| com1.put(byte));
    }
    exit(Exit::Panic)
}
