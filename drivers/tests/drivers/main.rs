//! The integration tests of the crate, in one program because each program is linked separately.
//!
//! One module a theme: what every display must do, the colour tables, and each of the three devices by its
//! registers, calls or operations.
#![allow(clippy::indexing_slicing, reason = "a test that indexes out of bounds fails, as it should")]

mod cgthree;
mod conformance;
mod graphigs;
mod pixrect;
mod quantize;
mod vga13h;
