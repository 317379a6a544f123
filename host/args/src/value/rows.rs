//! Some rows of a picture.

use core::fmt;
use core::ops::Range;
use core::str::FromStr;

/// Rows of a picture from one to before another, 0 at the top: at least one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rows(pub Range<u32>);

/// The text names no rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("expected rows as A..B, from row A to before row B: 0..100")]
pub struct NoRows;

impl FromStr for Rows {
    type Err = NoRows;

    fn from_str(text: &str) -> Result<Self, NoRows> {
        let (start, end) = text.split_once("..").ok_or(NoRows)?;
        let row = |text: &str| text.parse().map_err(|_| NoRows);
        let rows = row(start)?..row(end)?;
        if rows.is_empty() { Err(NoRows) } else { Ok(Self(rows)) }
    }
}

impl fmt::Display for Rows {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}..{}", self.0.start, self.0.end)
    }
}
