//! The integration tests of the crate, in one program because each program is linked separately.
//!
//! One module a theme: what every display must do, the colour tables, displays without one, and each device by its registers,
//! calls or operations.
#![allow(clippy::indexing_slicing, reason = "a test that indexes out of bounds fails, as it should")]

mod cgthree;
mod conformance;
mod direct;
mod dither;
mod graphigs;
mod palette;
mod pixrect;
mod quantize;
mod ssd0323;
mod target;
mod vga13h;

use rta_core::color::Rgb;

/// Pseudo-random colours with levels of 0..=`max`: a linear congruential generator with a fixed seed.
fn scattered(count: usize, max: u8) -> Vec<Rgb<u8>> {
    let mut state = 12345_u32;
    let mut next = move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        u8::try_from((state >> 16) % (u32::from(max) + 1)).unwrap()
    };
    (0..count).map(|_| Rgb::new(next(), next(), next())).collect()
}
