//! The picture as a WebAssembly module: `draw()`, then read `pixels` and `colors` out of its memory.
//!
//! It imports nothing. A panic traps.

#![no_std]

mod memory;

use core::panic::PanicInfo;

use crate::memory::Memory;

/// The screen. One thread, and no function here calls another of them: never borrowed twice.
static mut SCREEN: Memory = Memory::new();

/// Draws the picture anew: 0, or 2 for a display error.
#[unsafe(no_mangle)]
pub extern "C" fn draw() -> u32 {
    // SAFETY: see `SCREEN`.
    let screen = unsafe { &mut *&raw mut SCREEN };
    screen.clear();
    match picture::draw(screen, picture::table(), (0, 0), || {}) {
        Ok(_) => 0,
        Err(_) => 2,
    }
}

/// Address of what was loaded into the colour table, load after load: first entry, number of colours - 1,
/// and three levels (red, green, blue) for each colour.
#[unsafe(no_mangle)]
pub extern "C" fn colors() -> *const u8 {
    screen().colors().as_ptr()
}

/// Number of bytes at `colors`.
#[unsafe(no_mangle)]
pub extern "C" fn colors_len() -> usize {
    screen().colors().len()
}

/// Address of the pixels' indices, row after row.
#[unsafe(no_mangle)]
pub extern "C" fn pixels() -> *const u8 {
    screen().pixels().as_ptr()
}

/// Number of bytes at `pixels`.
#[unsafe(no_mangle)]
pub extern "C" fn pixels_len() -> usize {
    screen().pixels().len()
}

/// Pixels in a row.
#[unsafe(no_mangle)]
pub extern "C" fn width() -> u32 {
    picture::WIDTH
}

/// Rows.
#[unsafe(no_mangle)]
pub extern "C" fn height() -> u32 {
    picture::HEIGHT
}

/// The screen, to be read.
fn screen() -> &'static Memory {
    // SAFETY: see `SCREEN`; nothing keeps the reference.
    unsafe { &*&raw const SCREEN }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
