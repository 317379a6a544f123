//! The errors of the graPHIGS API.

use core::fmt;

/// An error of the graPHIGS API, under the number that [`GpError::number`] returns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum GpError {
    /// The function requires state PHCL: graPHIGS is open already.
    RequiresPhcl,
    /// The function requires state PHOP: graPHIGS is not open, or a workstation is still open.
    RequiresPhop,
    /// The function requires state WSOP: no workstation is open.
    RequiresWsop,
    /// The function requires state NROP: no non-retained structure was begun.
    RequiresNrop,
    /// The workstation type does not exist.
    WorkstationType,
    /// The workstation is open already.
    WorkstationInUse,
    /// The workstation does not exist.
    Workstation,
    /// The colour index exceeds the capacity of the workstation's table.
    ColorIndex,
    /// The workstation does not have the colour model.
    ColorModel,
    /// The nucleus does not exist.
    Nucleus,
    /// The request exceeds the capacity of the nucleus.
    Capacity,
    /// The image board identifier is in use already.
    BoardInUse,
    /// The image board does not exist.
    Board,
    /// The depth of the image board is not supported.
    BoardDepth,
    /// The size of the image board is invalid.
    BoardSize,
    /// The definition of the rectangle is invalid.
    Rectangle,
    /// The number of indexes is less than one.
    NoIndexes,
    /// The first entry asked for, or one after it, exceeds the size of the colour table.
    Start,
}

impl GpError {
    /// Returns the number by which the API reports the error; `None` where the reference gives no number for it.
    pub const fn number(self) -> Option<u16> {
        Some(match self {
            Self::RequiresPhcl => 1,
            Self::RequiresPhop => 2,
            Self::RequiresWsop => 3,
            Self::RequiresNrop => 5,
            Self::WorkstationType => 23,
            Self::Workstation => 25,
            Self::ColorIndex => 49,
            Self::Nucleus => 202,
            Self::Capacity => 217,
            Self::BoardInUse => 231,
            Self::Board => 232,
            Self::BoardDepth => 233,
            Self::BoardSize => 234,
            Self::Rectangle => 236,
            Self::NoIndexes => 517,
            Self::Start => 551,
            Self::WorkstationInUse | Self::ColorModel => return None,
        })
    }
}

impl fmt::Display for GpError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(number) = self.number() {
            write!(f, "graPHIGS error {number}: ")?;
        }
        f.write_str(match self {
            Self::RequiresPhcl => "function requires state PHCL",
            Self::RequiresPhop => "function requires state PHOP",
            Self::RequiresWsop => "function requires state WSOP",
            Self::RequiresNrop => "function requires state STOP or NROP",
            Self::WorkstationType => "workstation type does not exist",
            Self::WorkstationInUse => "workstation is open already",
            Self::Workstation => "workstation does not exist",
            Self::ColorIndex => "colour index exceeds the workstation's table",
            Self::ColorModel => "workstation does not have the colour model",
            Self::Nucleus => "nucleus does not exist",
            Self::Capacity => "request exceeds the capacity of the nucleus",
            Self::BoardInUse => "image board identifier is in use",
            Self::Board => "image board does not exist",
            Self::BoardDepth => "image board depth is not supported",
            Self::BoardSize => "image board size is invalid",
            Self::Rectangle => "rectangle definition is invalid",
            Self::NoIndexes => "number of indexes is less than one",
            Self::Start => "start value exceeds the colour table",
        })
    }
}

impl core::error::Error for GpError {}
