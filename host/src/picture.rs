//! Pictures: their size, the emulated devices that show them, and the files that they are written into.

pub mod coloring;
pub mod device;
pub mod error;
pub mod file;
pub mod output;
pub mod raster;
pub mod screen;

pub use file::{Caption, Displayed, FileType, Pixels};
