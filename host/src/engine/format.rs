//! The number formats that a picture can be computed in, chosen when the program runs.

use core::fmt;

use rta_scenes::bake;

/// The number format that a picture is computed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, clap::ValueEnum)]
pub enum Format {
    /// 32-bit float.
    F32,
    /// 64-bit float: the reference.
    F64,
    /// Fixed point: lengths in Q16.16, unit vectors in Q2.30. The same bytes on every machine.
    Q16,
    /// Fixed point: lengths in Q12.20, finer and shorter, unit vectors in Q2.30. The same bytes on every machine.
    Q20,
}

/// Evaluates an expression in which a type parameter stands for the scalar of a [`Format`]: `in_format!(format, S =>
/// narrow::<S>(scene))`. It is the only place where the program chooses code by its number format.
macro_rules! in_format {
    ($format:expr, $S:ident => $body:expr) => {
        match $format {
            $crate::engine::Format::F32 => {
                type $S = f32;
                $body
            }
            $crate::engine::Format::F64 => {
                type $S = f64;
                $body
            }
            $crate::engine::Format::Q16 => {
                type $S = rta_core::Q16;
                $body
            }
            $crate::engine::Format::Q20 => {
                type $S = rta_core::Q20;
                $body
            }
        }
    };
}
pub(crate) use in_format;

impl Format {
    /// The format after this one, in a circle.
    #[must_use]
    pub const fn next(self) -> Self {
        match self {
            Self::F32 => Self::F64,
            Self::F64 => Self::Q16,
            Self::Q16 => Self::Q20,
            Self::Q20 => Self::F32,
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::Q16 => "q16",
            Self::Q20 => "q20",
        })
    }
}

impl From<Format> for bake::Format {
    fn from(format: Format) -> Self {
        match format {
            Format::F32 => Self::F32,
            Format::F64 => Self::F64,
            Format::Q16 => Self::Q16,
            Format::Q20 => Self::Q20,
        }
    }
}
