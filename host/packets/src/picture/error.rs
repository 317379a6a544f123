//! What keeps a scene from being drawn.

use core::fmt;

use rta_core::Error;
use rta_scenes::narrow::NarrowError;

/// Why a scene cannot be drawn with some settings.
#[derive(Clone, Debug, PartialEq)]
pub enum PictureError {
    /// A number of the scene does not fit the number format.
    Narrow(NarrowError),
    /// Raster, depth, or what the core's own range check finds.
    Core(Error),
    /// The quads, for whose radiosity is to be solved.
    Radiosity(rta_core::radiosity::Error),
    /// What is asked of a picture by cones, and they do not know.
    Cones(&'static str),
}

impl fmt::Display for PictureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Narrow(error) => error.fmt(f),
            Self::Core(error) => error.fmt(f),
            Self::Radiosity(error) => error.fmt(f),
            Self::Cones(what) => write!(f, "--integrator cones does not know {what}"),
        }
    }
}

impl core::error::Error for PictureError {}

impl From<NarrowError> for PictureError {
    fn from(error: NarrowError) -> Self {
        Self::Narrow(error)
    }
}

impl From<Error> for PictureError {
    fn from(error: Error) -> Self {
        Self::Core(error)
    }
}

impl From<rta_core::radiosity::Error> for PictureError {
    fn from(error: rta_core::radiosity::Error) -> Self {
        Self::Radiosity(error)
    }
}
