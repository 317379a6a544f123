//! The contribution cut-off: rays that bring less than some part of their light into the pixel are not traced.

use core::fmt;
use core::str::FromStr;

use rta_scenes::description::Settings;

/// The part of its light that a ray must bring into the pixel to be traced, 0 to 1: a ratio of integers, so that every
/// number format rounds it for itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Cutoff {
    numerator: u16,
    denominator: u16,
}

impl Cutoff {
    /// No cut-off: every ray is traced.
    pub const OFF: Self = Self { numerator: 0, denominator: 1 };

    /// The part `1 / denominator`, or [`Cutoff::OFF`] where the denominator is 0.
    #[must_use]
    pub const fn one_in(denominator: u16) -> Self {
        if denominator == 0 { Self::OFF } else { Self { numerator: 1, denominator } }
    }

    /// Returns the ratio that a scene states: see [`Settings::cutoff_ratio`].
    #[must_use]
    pub fn of(settings: &Settings) -> Option<Self> {
        settings.cutoff_ratio().map(|(numerator, denominator)| Self { numerator, denominator })
    }

    /// The numerator.
    #[must_use]
    pub const fn numerator(self) -> i64 {
        self.numerator as i64
    }

    /// The denominator, which is never 0.
    #[must_use]
    pub const fn denominator(self) -> i64 {
        self.denominator as i64
    }
}

/// The text is not a ratio from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("expected a part from 0 to 1 as a ratio of whole numbers up to 65535, such as 1/64")]
pub struct NotAPart;

impl FromStr for Cutoff {
    type Err = NotAPart;

    fn from_str(text: &str) -> Result<Self, NotAPart> {
        let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
        let whole = |text: &str| text.parse::<u16>().map_err(|_| NotAPart);
        match (whole(numerator)?, whole(denominator)?) {
            (_, 0) => Err(NotAPart),
            (0, _) => Ok(Self::OFF),
            (numerator, denominator) if numerator <= denominator => Ok(Self { numerator, denominator }),
            _ => Err(NotAPart),
        }
    }
}

impl fmt::Display for Cutoff {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.numerator {
            0 => f.write_str("0"),
            numerator => write!(f, "{numerator}/{}", self.denominator),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Cutoff;

    #[test]
    fn cutoffs_are_ratios_from_0_to_1() {
        for (text, shown) in [("0", "0"), ("0/7", "0"), ("1/64", "1/64"), ("3/4", "3/4"), ("1", "1/1")] {
            assert_eq!(text.parse::<Cutoff>().expect(text).to_string(), shown);
        }
        assert_eq!("1/16".parse(), Ok(Cutoff::one_in(16)));
        assert_eq!(Cutoff::one_in(0), Cutoff::OFF);
        for text in ["", "2", "65/64", "1/0", "0.5", "-1/4", "1/65536", "1/2/3"] {
            assert!(text.parse::<Cutoff>().is_err(), "{text}");
        }
    }
}
