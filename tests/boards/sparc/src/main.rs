//! A SPARCstation 5 with a cgthree frame buffer, without an operating system: draws the picture in the
//! middle of the screen, reports on ttya and answers there (see [`picture::console`]).
//!
//! The program takes the place of the boot PROM: see prom.ld.

#![no_std]
#![no_main]
#![feature(asm_experimental_arch)]

mod screen;
mod serial;
mod stack;
mod timer;

use core::arch::global_asm;
use core::panic::PanicInfo;

use picture::console::Serial;
use rta_drivers::display::Display;
use rta_drivers::pixrect::{CAPABILITIES, Cgthree, PixrectDisplay};
use screen::Screen;
use serial::Ttya;

global_asm!(include_str!("traps.s"));
global_asm!(include_str!("start.s"));

/// What the machine says when it ends, in the line `EXIT n`: QEMU's own status is always 0.
#[repr(u8)]
#[derive(Clone, Copy)]
enum Exit {
    /// All went well and `Q` came.
    Done = 0,
    /// The program panicked.
    Panic = 50,
    /// The tracer or the display refused something.
    Refused = 51,
    /// The processor met a trap that it should not meet. (52 is the PC's boot sector's.)
    Trap = 53,
}

/// The picture's upper left pixel: it stands in the middle.
const ORIGIN: (u32, u32) =
    ((CAPABILITIES.width - picture::WIDTH) / 2, (CAPABILITIES.height - picture::HEIGHT) / 2);

/// Set to 1, the machine is switched off.
const POWER: *mut u8 = 0x7191_0000 as *mut u8;

/// Called by start.s: .data and .bss are as they should be, the stack is painted, the MMU is off.
#[unsafe(no_mangle)]
extern "C" fn board_main() -> ! {
    // SAFETY: this is a SPARCstation 5 without MMU and nobody else uses ttya.
    let mut ttya = unsafe { Ttya::open() };
    match run(&mut ttya) {
        Ok(()) => exit(&mut ttya, Exit::Done),
        Err(code) => exit(&mut ttya, code),
    }
}

fn run(ttya: &mut Ttya) -> Result<(), Exit> {
    // SAFETY: this is a SPARCstation 5 with a cgthree, without MMU, and nobody else uses the cgthree.
    let screen = unsafe { Screen::open() };
    let mut display = PixrectDisplay::new(Cgthree::open(screen)).map_err(|_| Exit::Refused)?;
    clear(&mut display).map_err(|_| Exit::Refused)?;
    // SAFETY: this is a SPARCstation 5 without MMU, interrupts are off, and nobody else uses the counter.
    let mut elapsed = unsafe { timer::start() };
    let drawn = picture::draw(display, picture::adaptive(CAPABILITIES.gun_max), ORIGIN, || {
        elapsed.look();
    });
    let ticks = elapsed.look();
    let mut display = drawn.map_err(|_| Exit::Refused)?;
    for (name, value) in picture::facts(picture::table()) {
        picture::report(name, value, |byte| ttya.put(byte));
    }
    picture::report("stack", stack::high_water(), |byte| ttya.put(byte));
    picture::report("nanoseconds", timer::nanoseconds(ticks), |byte| ttya.put(byte));
    picture::console::serve(ttya, &mut display, ORIGIN).map_err(|_| Exit::Refused)
}

/// Index 0, black, all over the screen: a frame buffer holds anything when it is switched on.
fn clear<D: Display>(display: &mut D) -> Result<(), D::Error> {
    for y in 0..CAPABILITIES.height {
        display.put_pixels(0, y, &[0; CAPABILITIES.width as usize])?;
    }
    Ok(())
}

/// Switches the machine off.
fn exit(ttya: &mut Ttya, code: Exit) -> ! {
    let code = code as u8;
    ttya.put_all(b"EXIT ");
    if code >= 10 {
        ttya.put(b'0' + code / 10);
    }
    ttya.put(b'0' + code % 10);
    ttya.put(b'\n');
    // SAFETY: the register of the SPARCstation 5 that has no other use.
    unsafe { POWER.write_volatile(1) };
    loop {
        core::hint::spin_loop();
    }
}

/// Called by traps.s with the trap's number and the address of the instruction.
#[unsafe(no_mangle)]
extern "C" fn board_trap(number: u32, pc: u32) -> ! {
    // SAFETY: as in `board_main`; the one who used ttya will not run again.
    let mut ttya = unsafe { Ttya::open() };
    picture::report("trap", u64::from(number), |byte| ttya.put(byte));
    picture::report("pc", u64::from(pc), |byte| ttya.put(byte));
    exit(&mut ttya, Exit::Trap)
}

/// Reports the place, as a file's name and a line; the message would need `core::fmt`.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    // SAFETY: as in `board_trap`.
    let mut ttya = unsafe { Ttya::open() };
    if let Some(place) = info.location() {
        picture::report(place.file(), u64::from(place.line()), |byte| ttya.put(byte));
    }
    exit(&mut ttya, Exit::Panic)
}
