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
    /// Above 0 and at most 1.
    Part,
    /// An angle of view in degrees.
    Angle,
    /// The angle at which a highlight has half its strength, in degrees.
    Gloss,
    /// From one number to another.
    Between(f64, f64),
    /// A whole number from one to another.
    Whole(u8, u8),
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
            Self::Part => number > 0.0 && number <= 1.0,
            Self::Angle => number > 0.0 && number < 180.0,
            Self::Gloss => number > 0.0 && number < 45.0,
            Self::Between(least, most) => (least..=most).contains(&number),
            Self::Whole(least, most) => {
                number.fract() == 0.0 && (f64::from(least)..=f64::from(most)).contains(&number)
            }
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
            Self::Part => "a number > 0 and at most 1",
            Self::Angle => "degrees > 0 and < 180",
            Self::Gloss => "degrees > 0 and < 45",
            Self::Between(least, most) => return write!(f, "a number from {least} to {most}"),
            Self::Whole(least, most) => return write!(f, "a whole number from {least} to {most}"),
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

/// A number in a message, with at most six digits, and with an exponent where it is long.
#[derive(Clone, Copy, Debug)]
pub struct Short {
    number: f64,
    /// Whether it is rounded to what is not smaller, to what is not larger, or to the nearest.
    toward: core::cmp::Ordering,
}

impl Short {
    /// Returns the nearest short number.
    #[must_use]
    pub const fn nearest(number: f64) -> Self {
        Self { number, toward: core::cmp::Ordering::Equal }
    }

    /// Returns the largest short number that is not above `number`, which is 0 or more.
    #[must_use]
    pub const fn at_most(number: f64) -> Self {
        Self { number, toward: core::cmp::Ordering::Less }
    }

    /// Returns the smallest short number that is not below `number`, which is 0 or more.
    #[must_use]
    pub const fn at_least(number: f64) -> Self {
        Self { number, toward: core::cmp::Ordering::Greater }
    }

    /// Returns the number with six digits.
    fn rounded(self) -> f64 {
        let text = format!("{:.5e}", self.number);
        let read = |text: &str| text.parse::<f64>().unwrap_or(self.number);
        let Some((mantissa, exponent)) = text.split_once('e') else { return self.number };
        let Ok(digits) = mantissa.replace('.', "").parse::<i64>() else { return self.number };
        let step = match (self.toward, read(&text).total_cmp(&self.number)) {
            (core::cmp::Ordering::Less, core::cmp::Ordering::Greater) => -1,
            (core::cmp::Ordering::Greater, core::cmp::Ordering::Less) => 1,
            _ => 0,
        };
        let power = exponent.parse::<i32>().unwrap_or(0) - 5;
        // Below a power of ten the steps are a tenth.
        let (digits, power) =
            if step < 0 && digits == 100_000 { (10 * digits, power - 1) } else { (digits, power) };
        read(&format!("{}e{power}", digits + step))
    }
}

impl Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = self.rounded();
        if number == 0.0 || !number.is_finite() || (1e-4..1e9).contains(&number.abs()) {
            write!(f, "{number}")
        } else {
            write!(f, "{number:e}")
        }
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

#[cfg(test)]
mod tests {
    use super::Short;

    #[test]
    fn short_numbers_are_short_and_on_the_right_side() {
        let limit = 32768.0 - 1.0 / 65536.0;
        for (number, least, nearest, most) in [
            (0.0, "0", "0", "0"),
            (90001.0, "90001", "90001", "90001"),
            (limit, "32768", "32768", "32767.9"),
            (f64::from(1e18_f32), "1e18", "1e18", "9.99999e17"),
            (1e300, "1e300", "1e300", "1e300"),
            (1.0 / 3.0, "0.333334", "0.333333", "0.333333"),
            (1e-9 / 3.0, "3.33334e-10", "3.33333e-10", "3.33333e-10"),
            (9.999_999, "10", "10", "9.99999"),
            (f64::INFINITY, "inf", "inf", "inf"),
        ] {
            assert_eq!(Short::at_least(number).to_string(), least);
            assert_eq!(Short::nearest(number).to_string(), nearest);
            assert_eq!(Short::at_most(number).to_string(), most);
        }
        assert_eq!(Short::nearest(-2.0 / 3.0).to_string(), "-0.666667");
    }
}
