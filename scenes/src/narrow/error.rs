//! Why a number format cannot hold a scene.

use core::fmt;

use crate::numbers::Short;

/// Something in a scene that a number format cannot hold.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct NarrowError {
    /// The thing, with its line in the file if it has one: `sphere 3 (line 12)`.
    pub object: String,
    /// What of it does not fit: `x and radius`.
    pub quantity: &'static str,
    /// Its size.
    pub value: f64,
    /// What it may be at most, or at least where it is too small.
    pub limit: f64,
    /// The number format.
    pub format: &'static str,
}

impl fmt::Display for NarrowError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { object, quantity, value, limit, format } = self;
        let size = value.abs();
        let (size, side, limit) = if size < *limit {
            (Short::at_most(size), "below the smallest", Short::at_least(*limit))
        } else {
            (Short::at_least(size), "beyond the largest", Short::at_most(*limit))
        };
        let sign = if *value < 0.0 { "-" } else { "" };
        write!(f, "{object} is out of {format}'s range: {quantity} {sign}{size}, {side} {limit}")
    }
}

impl core::error::Error for NarrowError {}
