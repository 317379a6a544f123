//! The desktop program: traces scenes for the emulated displays of 1990, in a window or into picture files.
//!
//! # From the command line to the picture
//!
//! | step | where |
//! | --- | --- |
//! | the command line: values alone, nothing is done with them | [`args`] |
//! | the scene file, the picture that is asked for, a scene that is scaled to fit | [`request`] |
//! | the tracer in one number format with one model, on all cores | [`engine`] |
//! | the emulated device with its colour table, the picture file | [`picture`] |
//! | the commands | [`commands`] |
//! | studies of errors, costs and number formats | [`study`] |
//!
//! `picture` knows none of the others, `engine` knows `picture`, and `request` knows both; commands and studies know all three. Each
//! has its own error type; [`error`] gathers them.
//!
//! Light is linear all the way and no gamma is applied anywhere: 1 is the brightest level of a gun, which is 255
//! in a picture file with 8 bits a register.
#![forbid(unsafe_code)]

pub mod commands;
pub mod engine;
pub mod error;
pub mod picture;
pub mod request;
pub mod study;

pub use rta_args as args;

// Short paths to what tests and benchmarks use.
pub use commands::{render, show};
pub use engine::bands;
pub use picture::{coloring, device, raster, screen};
pub use request::sampling;
pub use study::{bench, report, stability, trail, values};

/// Scene files, by the name that the tests know them by.
pub mod scene {
    pub use crate::request::scene_file::SceneFile as Scene;
}
