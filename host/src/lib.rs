//! The desktop program: scenes onto the emulated displays of 1990, into a window or into picture files.
//!
//! # The way of a picture
//!
//! | step | where |
//! | --- | --- |
//! | what is asked for | [`args`], [`request`], [`raster`] |
//! | the scene file | [`scene`], [`mod@fit`] |
//! | the tracer, in one number format and with one model | [`engine`] |
//! | bands of rows on all cores, delivered in order | [`bands`], [`progress`], [`interrupt`] |
//! | the emulated device with its colour table, and what is read back from it | [`device`], [`screen`] |
//! | a picture file, complete or not there at all | [`picture`], [`output`] |
//! | the commands | [`check`]; [`render`] into a file; [`show`], [`frame`] and [`window`] |
//! | what it costs | [`mod@bench`]; instructions by [`callgrind`] |
//!
//! Light is linear all the way and no gamma is applied anywhere: 1 is the brightest level of a gun, which is 255
//! in a picture file with 8 bits a register.
#![forbid(unsafe_code)]

pub mod args;
pub mod commands;
pub mod engine;
pub mod error;
pub mod picture;
pub mod request;
pub mod study;

pub use commands::{render, show};
pub use engine::bands;
pub use picture::{device, raster, screen};
pub use request::sampling;
pub use study::{bench, paired, report, stability};

/// Scene files, and those that the program carries in itself.
pub mod scene {
    pub use crate::request::scene_file::SceneFile as Scene;
}

/// The code of the README, compiled and run with the other examples.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
