//! The number formats that a scene can be brought into, chosen when a program runs.

use core::fmt;

pub use rta_core::{Q16, Q20};

/// A number format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// 32-bit float.
    F32,
    /// 64-bit float: the reference. The target of a baked scene needs the feature `f64` of `rta-core`.
    F64,
    /// Fixed point: lengths in Q16.16, unit vectors in Q2.30. The same bytes on every machine.
    Q16,
    /// Fixed point: lengths in Q12.20, finer and shorter, unit vectors in Q2.30. The same bytes on every machine.
    Q20,
}

impl Format {
    /// All formats.
    pub const ALL: &[Self] = &[Self::F32, Self::F64, Self::Q16, Self::Q20];

    /// Returns the name on a command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::Q16 => "q16",
            Self::Q20 => "q20",
        }
    }

    /// Returns what a help text says of it, without a full stop.
    #[must_use]
    pub const fn about(self) -> &'static str {
        match self {
            Self::F32 => "32-bit float",
            Self::F64 => "64-bit float: the reference",
            Self::Q16 => {
                "Fixed point: lengths in Q16.16, unit vectors in Q2.30. The same bytes on every machine"
            }
            Self::Q20 => {
                "Fixed point: lengths in Q12.20, finer and shorter, unit vectors in Q2.30. The same bytes on every machine"
            }
        }
    }
}

impl Format {
    /// Returns the step from one length to the next, where all steps are equal: in fixed point.
    #[must_use]
    pub const fn step(self) -> Option<f64> {
        match self {
            Self::F32 | Self::F64 => None,
            Self::Q16 => Some(1.0 / 65_536.0),
            Self::Q20 => Some(1.0 / 1_048_576.0),
        }
    }

    /// Returns the one after this one, in a circle.
    #[must_use]
    pub fn next(self) -> Self {
        let after = Self::ALL.iter().copied().skip_while(|one| *one != self).nth(1);
        after.or(Self::ALL.first().copied()).unwrap_or(self)
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Evaluates an expression in which a type parameter stands for the scalar of a [`Format`]: `in_format!(format, S =>
/// narrow::<S>(scene))`. It is the only place where a program chooses code by its number format.
#[macro_export]
macro_rules! in_format {
    ($format:expr, $S:ident => $body:expr) => {
        match $format {
            $crate::format::Format::F32 => {
                type $S = f32;
                $body
            }
            $crate::format::Format::F64 => {
                type $S = f64;
                $body
            }
            $crate::format::Format::Q16 => {
                type $S = $crate::format::Q16;
                $body
            }
            $crate::format::Format::Q20 => {
                type $S = $crate::format::Q20;
                $body
            }
        }
    };
}
