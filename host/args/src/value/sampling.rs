//! The number of samples a pixel, as the command line states it.

use core::fmt;
use core::str::FromStr;

use rta_core::sampling::{Places, Sampling};

/// Samples a pixel: a square number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Samples(Sampling);

impl Samples {
    /// One sample, in the middle of the pixel.
    pub const ONE: Self = Self(Sampling::CENTER);

    /// Returns a number of samples; `None` where it is no square number from 1 to [`Samples::MOST`].
    #[must_use]
    pub fn of(samples: u32) -> Option<Self> {
        let side = samples.isqrt();
        if side * side != samples || samples > Self::MOST {
            return None;
        }
        u8::try_from(side).ok().and_then(Sampling::grid).map(Self)
    }

    /// The largest number of samples a pixel that may be asked for.
    pub const MOST: u32 = 1024;

    /// Returns where in a pixel the samples lie: on a regular grid, or jittered where there is a seed.
    #[must_use]
    pub const fn sampling(self, seed: Option<u32>) -> Sampling {
        match seed {
            Some(seed) => self.0.jittered(seed),
            None => self.0,
        }
    }
}

/// The number of samples is not a square number within the limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("expected a square number from 1 to {}: 1, 4, 9, 16 ...", Samples::MOST)]
pub struct NotASquare;

impl FromStr for Samples {
    type Err = NotASquare;

    fn from_str(text: &str) -> Result<Self, NotASquare> {
        text.parse().ok().and_then(Self::of).ok_or(NotASquare)
    }
}

impl fmt::Display for Samples {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.samples().fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use rta_core::sampling::Places;

    use super::Samples;

    #[test]
    fn samples_are_squares() {
        for (text, samples) in [("1", 1), ("4", 4), ("9", 9), ("16", 16), ("1024", 1024)] {
            let read = text.parse::<Samples>().expect(text);
            assert_eq!((read.sampling(None).samples(), read.to_string().as_str()), (samples, text));
            assert!(read.sampling(Some(7)).is_jittered() && !read.sampling(None).is_jittered());
        }
        for text in ["0", "2", "15", "-4", "", "1089", "4294967295", "4.0"] {
            assert!(text.parse::<Samples>().is_err(), "{text}");
        }
    }
}
