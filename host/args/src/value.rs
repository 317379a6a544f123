//! Values of options, as they are read and told.

pub mod coloring;
pub mod cutoff;
pub mod degrees;
pub mod device;
pub mod file_type;
pub mod raster;
pub mod rows;
pub mod sampling;
pub mod until;
