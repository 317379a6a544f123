//! Pictures: their size, the emulated devices that show them, the files that they are written into, and how they are scaled and labelled.

pub mod coloring;
pub mod error;
pub mod file;
pub mod frame;
pub mod output;
pub mod part;
pub mod screen;
pub mod text;

pub use rta_args::value::{device, raster};

pub use file::{Caption, Displayed, FileType, Pixels};
