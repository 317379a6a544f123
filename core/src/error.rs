//! Errors. They occur only before a picture is drawn, never while it is drawn.

use core::fmt;

use crate::range::RangeError;

/// An error of the core.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// The scene does not fit the number format.
    Range(RangeError),
    /// The recursion depth exceeds the capacity of the ray stack, or the weight of a ray may not fit the number format there.
    Depth {
        /// The depth that was asked for.
        depth: u32,
        /// The greatest depth for which there is room, and at which weights fit.
        capacity: usize,
    },
    /// A side of the raster is 0 or too long.
    Raster {
        /// Pixels in a row.
        width: u32,
        /// Rows.
        height: u32,
    },
}

impl From<RangeError> for Error {
    fn from(error: RangeError) -> Self {
        Self::Range(error)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range(error) => error.fmt(f),
            Self::Depth { depth, capacity } => {
                write!(
                    f,
                    "a recursion depth of {depth} exceeds {capacity}, the deepest for this stack and this scene"
                )
            }
            Self::Raster { width, height } => {
                let most = u16::MAX;
                write!(f, "a raster of {width} x {height} pixels: each side must be 1 to {most}")
            }
        }
    }
}

impl core::error::Error for Error {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Range(error) => Some(error),
            _ => None,
        }
    }
}
