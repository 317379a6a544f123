//! The number of samples a pixel, and how lamps are asked, as the command line states them.

use core::fmt;
use core::str::FromStr;

use rta_core::sampling::{Sampling, Sobol};
use rta_scenes::sampler::{Adaptive, Cutting, Lamps};

/// Samples a pixel: 1 to [`Sobol::MAX_SAMPLES`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Samples(u32);

impl Samples {
    /// One sample.
    pub const ONE: Self = Self(1);

    /// The most samples on a grid.
    pub const MOST_ON_GRID: u32 = 1024;

    /// Returns a number of samples; `None` where it is 0 or above [`Sobol::MAX_SAMPLES`].
    #[must_use]
    pub const fn of(samples: u32) -> Option<Self> {
        if samples == 0 || samples > Sobol::MAX_SAMPLES { None } else { Some(Self(samples)) }
    }

    /// Returns the number.
    #[must_use]
    pub const fn count(self) -> u32 {
        self.0
    }

    /// Returns them on a regular grid, or jittered where there is a seed.
    ///
    /// # Errors
    /// [`NotASquare`] if they do not fill a grid.
    pub fn grid(self, seed: Option<u32>) -> Result<Sampling, NotASquare> {
        let side = self.0.isqrt();
        let fits = side * side == self.0 && self.0 <= Self::MOST_ON_GRID;
        let grid = u8::try_from(side).ok().filter(|_| fits).and_then(Sampling::grid).ok_or(NotASquare)?;
        Ok(seed.map_or(grid, |seed| grid.jittered(seed)))
    }
}

/// The samples do not fill a square grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("a square number from 1 to {}: 1, 4, 9, 16 ...", Samples::MOST_ON_GRID)]
pub struct NotASquare;

/// It is no number of samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("expected a whole number from 1 to {}", Sobol::MAX_SAMPLES)]
pub struct NotSamples;

impl FromStr for Samples {
    type Err = NotSamples;

    fn from_str(text: &str) -> Result<Self, NotSamples> {
        text.parse().ok().and_then(Self::of).ok_or(NotSamples)
    }
}

impl fmt::Display for Samples {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// How far the samples of a pixel may be from agreeing, as a part of white, and the fewest that it has: `PART` or `PART:FEWEST`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToleranceValue {
    part: f64,
    fewest: u32,
}

/// It is no tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "expected a part of white from {} to 1, or with the fewest samples of a pixel, as .02:1",
    ToleranceValue::LEAST
)]
pub struct NotTolerance;

impl ToleranceValue {
    /// The smallest: a sixteenth of one of 255 levels, rounded up.
    const LEAST: f64 = 0.00025;

    /// The fewest samples of a pixel where nobody says more.
    const FEWEST: u32 = 4;

    /// Returns the part of white.
    #[must_use]
    pub const fn part(self) -> f64 {
        self.part
    }

    /// Returns the fewest samples of a pixel, 1 or more.
    #[must_use]
    pub const fn fewest(self) -> u32 {
        self.fewest
    }
}

impl FromStr for ToleranceValue {
    type Err = NotTolerance;

    fn from_str(text: &str) -> Result<Self, NotTolerance> {
        let (part, fewest) = match text.split_once(':') {
            Some((part, fewest)) => (part, fewest.parse().map_err(|_| NotTolerance)?),
            None => (text, Self::FEWEST),
        };
        let part = part.parse().map_err(|_| NotTolerance)?;
        if (Self::LEAST..=1.0).contains(&part) && fewest >= 1 {
            Ok(Self { part, fewest })
        } else {
            Err(NotTolerance)
        }
    }
}

impl fmt::Display for ToleranceValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.part.fmt(f)?;
        if self.fewest == Self::FEWEST { Ok(()) } else { write!(f, ":{}", self.fewest) }
    }
}

/// How lamps with a size are asked for their light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LampsValue(pub Lamps);

/// It is no way to ask lamps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("expected point, fixed:K with a square number K from 1 to 1024, area or cone")]
pub struct NotLamps;

impl FromStr for LampsValue {
    type Err = NotLamps;

    fn from_str(text: &str) -> Result<Self, NotLamps> {
        let text = text.to_ascii_lowercase();
        let fixed = |places: &str| {
            let places: u32 = places.parse().ok().filter(|places| (1..=1024).contains(places))?;
            let side = places.isqrt();
            u8::try_from(side).ok().filter(|_| side * side == places).map(Lamps::Fixed)
        };
        match (text.as_str(), text.strip_prefix("fixed:")) {
            ("point", _) => Ok(Self(Lamps::Point)),
            ("area", _) => Ok(Self(Lamps::Area)),
            ("cone", _) => Ok(Self(Lamps::Cone)),
            (_, Some(places)) => fixed(places).map(Self).ok_or(NotLamps),
            _ => Err(NotLamps),
        }
    }
}

impl fmt::Display for LampsValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Lamps::Point => f.write_str("point"),
            Lamps::Fixed(side) => write!(f, "fixed:{}", u32::from(side) * u32::from(side)),
            Lamps::Area => f.write_str("area"),
            Lamps::Cone => f.write_str("cone"),
        }
    }
}

/// A way of adaptive antialiasing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AdaptiveValue(pub Adaptive);

/// It is no way of adaptive antialiasing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("expected whitted, whitted:K with a depth K from 0 to {}, or mitchell", Cutting::DEEPEST)]
pub struct NotAdaptive;

impl FromStr for AdaptiveValue {
    type Err = NotAdaptive;

    fn from_str(text: &str) -> Result<Self, NotAdaptive> {
        let text = text.to_ascii_lowercase();
        match (text.as_str(), text.strip_prefix("whitted:")) {
            ("whitted", _) => Ok(Self(Adaptive::Whitted(Cutting::default()))),
            ("mitchell", _) => Ok(Self(Adaptive::Mitchell)),
            (_, Some(depth)) => {
                let cutting = depth.parse().ok().and_then(|depth| Cutting::new(depth, Cutting::TOLERANCE));
                cutting.map(|cutting| Self(Adaptive::Whitted(cutting))).ok_or(NotAdaptive)
            }
            _ => Err(NotAdaptive),
        }
    }
}

impl fmt::Display for AdaptiveValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Adaptive::Whitted(cutting) => write!(f, "whitted:{}", cutting.depth()),
            Adaptive::Mitchell => f.write_str("mitchell"),
        }
    }
}

#[cfg(test)]
mod tests {
    use rta_core::sampling::Places;

    use super::{AdaptiveValue, LampsValue, Samples, ToleranceValue};

    #[test]
    fn samples_on_a_grid_are_squares() {
        for (text, samples) in [("1", 1), ("4", 4), ("9", 9), ("16", 16), ("1024", 1024)] {
            let read = text.parse::<Samples>().expect(text);
            let grid = |seed| read.grid(seed).expect(text);
            assert_eq!((grid(None).samples(), read.to_string().as_str()), (samples, text));
            assert!(grid(Some(7)).is_jittered() && !grid(None).is_jittered());
        }
        for text in ["2", "15", "1089", "16384"] {
            assert!(text.parse::<Samples>().expect(text).grid(None).is_err(), "{text}");
        }
        for text in ["0", "-4", "", "16385", "4294967295", "4.0"] {
            assert!(text.parse::<Samples>().is_err(), "{text}");
        }
    }

    #[test]
    fn antialiasing_is_told_as_it_is_read() {
        for (text, told) in [
            ("whitted", "whitted:2"),
            ("whitted:0", "whitted:0"),
            ("Whitted:4", "whitted:4"),
            ("Mitchell", "mitchell"),
        ] {
            let read = text.parse::<AdaptiveValue>().expect(text);
            assert_eq!(read.to_string(), told);
        }
        for text in ["", "whitted:", "whitted:5", "whitted:-1", "mitchell:2", "cones"] {
            assert!(text.parse::<AdaptiveValue>().is_err(), "{text}");
        }
    }

    #[test]
    fn a_tolerance_is_a_part_of_white() {
        for (text, told) in [
            ("1", "1"),
            (".01", "0.01"),
            ("1e-3", "0.001"),
            ("0.00025", "0.00025"),
            (".02:1", "0.02:1"),
            (".02:2", "0.02:2"),
            (".02:4", "0.02"),
        ] {
            assert_eq!(text.parse::<ToleranceValue>().expect(text).to_string(), told);
        }
        for text in ["", "0", "-0.1", "1.01", "1e-5", "NaN", "inf", "a", ".02:0", ".02:", ":2", ".02:-4"] {
            assert!(text.parse::<ToleranceValue>().is_err(), "{text}");
        }
    }

    #[test]
    fn lamps_are_told_as_they_are_read() {
        for text in ["point", "area", "fixed:1", "fixed:4", "fixed:256"] {
            assert_eq!(text.parse::<LampsValue>().map(|lamps| lamps.to_string()).as_deref(), Ok(text));
        }
        for text in ["", "fixed", "fixed:", "fixed:0", "fixed:3", "fixed:-4", "fixed:1089", "cones"] {
            assert!(text.parse::<LampsValue>().is_err(), "{text}");
        }
    }
}
