//! Numbers in a text: what they may be, how they are read, how they are written.

use core::fmt::{self, Display};

use crate::error::{Found, SceneError};
use crate::tokens::Tokens;

/// The names of three coordinates.
pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];

/// What a number may be.
#[derive(Clone, Copy)]
pub(crate) enum Range {
    Any,
    NotZero,
    Positive,
    NotNegative,
    NotPositive,
    /// From 0 to 1.
    Share,
    /// An angle of view in degrees.
    Angle,
}

impl Range {
    pub(crate) fn holds(self, number: f64) -> bool {
        match self {
            Self::Any => true,
            Self::NotZero => number != 0.0,
            Self::Positive => number > 0.0,
            Self::NotNegative => number >= 0.0,
            Self::NotPositive => number <= 0.0,
            Self::Share => (0.0..=1.0).contains(&number),
            Self::Angle => number > 0.0 && number < 180.0,
        }
    }
}

impl Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Any => "a number",
            Self::NotZero => "a number, not 0",
            Self::Positive => "a number > 0",
            Self::NotNegative => "a number >= 0",
            Self::NotPositive => "a number <= 0",
            Self::Share => "a number from 0 to 1",
            Self::Angle => "degrees > 0 and < 180",
        })
    }
}

/// Numbers with a space between them, each in the fewest digits that read back as the same `f64`.
pub(crate) struct Numbers<'a>(pub(crate) &'a [f64]);

impl Display for Numbers<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, number) in self.0.iter().enumerate() {
            let space = if index == 0 { "" } else { " " };
            match number.abs() {
                // 1e300 in full would be 301 digits.
                size if size >= 1e15 || (size < 1e-9 && size > 0.0) => write!(f, "{space}{number:e}")?,
                _ => write!(f, "{space}{number}")?,
            }
        }
        Ok(())
    }
}

/// The next pieces, read as what a format wants there. `what` is only written where it is not there.
impl Tokens<'_> {
    pub(crate) fn color(&mut self, what: impl Display) -> Result<[f64; 3], SceneError> {
        self.vector(["red", "green", "blue"], what, Range::NotNegative)
    }

    pub(crate) fn vector(
        &mut self,
        [x, y, z]: [&str; 3],
        what: impl Display,
        range: Range,
    ) -> Result<[f64; 3], SceneError> {
        Ok([
            self.number(format_args!("the {x} of {what}"), range)?,
            self.number(format_args!("the {y} of {what}"), range)?,
            self.number(format_args!("the {z} of {what}"), range)?,
        ])
    }

    pub(crate) fn number(&mut self, what: impl Display, range: Range) -> Result<f64, SceneError> {
        self.parse(format_args!("{what} ({range})"), |text| {
            text.parse().ok().filter(|number: &f64| number.is_finite() && range.holds(*number))
        })
    }

    /// A number of digits alone, from `least` to `most`.
    pub(crate) fn whole(&mut self, expected: impl Display, least: u32, most: u32) -> Result<u32, SceneError> {
        self.parse(expected, |text| text.parse().ok().filter(|number| (least..=most).contains(number)))
    }

    fn parse<T>(
        &mut self,
        expected: impl Display,
        meaning: impl Fn(&str) -> Option<T>,
    ) -> Result<T, SceneError> {
        let place = self.place();
        let token = self.next();
        token.and_then(|token| meaning(token.text)).ok_or_else(|| {
            let found = token.map_or(Found::EndOfFile, |token| Found::token(token.text));
            self.error(place, expected.to_string(), found)
        })
    }
}
