//! Golden-picture tests: what is drawn today is compared with a picture that somebody has looked at and found right.
//!
//! In fixed point rta draws the same bytes on every machine, so a test need not allow for anything: one pixel that is another
//! one is a failure. With this crate such a test takes five lines:
//!
//! ```
//! use rta_golden::{Mismatch, Render};
//!
//! # /*
//! #[test]
//! # */
//! fn the_ball_is_drawn_as_ever() -> Result<(), Mismatch> {
//!     let picture = Render::default().file("tests/ball.dat")?;
//!     picture.has_hash(0x1f55_58be_ac22_b270)?;
//!     picture.is_golden("tests/golden/ball.png")
//! }
//! # the_ball_is_drawn_as_ever().unwrap();
//! ```
//!
//! Paths are relative to the folder of the package, in which `cargo test` runs its tests.
//!
//! # A picture
//!
//! | what is tested | how it becomes a [`Picture`] |
//! | --- | --- |
//! | a scene file | [`Render::file`]; [`Render::scene`] takes a scene that was read or made otherwise |
//! | a scene, model, primitive or accelerator of one's own, a baked scene | [`Screen::trace`] with the tracer that the firmware has |
//! | a drawing routine of one's own, or levels from elsewhere | [`Screen::paint`], through a colour table of rta |
//! | firmware that is generic over its display | [`Paper`], a display that keeps what it is sent |
//! | the frame buffer of a port or of a driver | [`Picture::indexed`] with its colour table, [`Picture::direct`] without one |
//!
//! # What it is compared with
//!
//! [`Picture::has_hash`] compares 64 bits, the number that `rta hash` prints and that
//! [`Checksum`](rta_drivers::checksum::Checksum) computes on a board. [`Picture::is_golden`] compares every pixel with a PNG; if
//! one differs, the error says how many do, by how much and where, and two files show it. `RTA_BLESS=1 cargo test` writes golden
//! pictures anew.
//!
//! Neither of them panics. Errors print alike with `{}` and `{:?}`, so that `?` and `unwrap` in a test tell all there is to tell.
#![forbid(unsafe_code)]

mod compare;
mod error;
mod file;
mod kept;
mod paper;
mod picture;
mod render;
mod screen;

pub use compare::BLESS;
pub use error::{Difference, DrawError, Mismatch};
pub use kept::Kept;
pub use paper::Paper;
pub use picture::Picture;
pub use render::Render;
pub use screen::{Screen, Table};

pub use rta_core::color::Rgb;
pub use rta_drivers::display::Capabilities;
pub use rta_scenes::{Format, Model};

/// The code of the README, compiled with the other examples.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
