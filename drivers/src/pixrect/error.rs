//! What the operations of a pixrect refuse.

use core::fmt;

/// Why an operation was refused. The library itself returns PIX_ERR without a reason.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PixrectError {
    /// A pixel outside the pixrect, or an operation with PIX_DONTCLIP that needs clipping.
    OutOfBounds,
    /// Two depths that cannot be combined, or a depth other than 1 and 8.
    Depth,
    /// Entries beyond the colormap, or arrays of different lengths for the three guns.
    Colormap,
    /// The pixrect has no colormap.
    NoColormap,
    /// The memory lent is too small for the pixrect, or a side is above `i32::MAX`.
    Memory,
}

impl fmt::Display for PixrectError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::OutOfBounds => "outside the pixrect",
            Self::Depth => "depths cannot be combined",
            Self::Colormap => "entries leave the colormap, or the guns differ in count",
            Self::NoColormap => "the pixrect has no colormap",
            Self::Memory => "memory too small for the size of the pixrect",
        })
    }
}

impl core::error::Error for PixrectError {}
