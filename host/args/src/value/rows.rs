//! Some rows of a picture, or frames of a film.

use core::fmt;
use core::ops::Range;
use core::str::FromStr;

/// Rows of a picture, or frames of a film, from one to before another, counted from 0: at least one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rows(pub Range<u32>);

/// The text names none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("expected A..B, from A to before B, as 0..100")]
pub struct NoRows;

impl FromStr for Rows {
    type Err = NoRows;

    fn from_str(text: &str) -> Result<Self, NoRows> {
        let (start, end) = text.split_once("..").ok_or(NoRows)?;
        let number = |text: &str| text.parse().map_err(|_| NoRows);
        let rows = number(start)?..number(end)?;
        if rows.is_empty() { Err(NoRows) } else { Ok(Self(rows)) }
    }
}

impl fmt::Display for Rows {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}..{}", self.0.start, self.0.end)
    }
}
