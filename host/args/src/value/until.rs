//! When a picture that is traced in passes is done.

use core::fmt;
use core::str::FromStr;
use core::time::Duration;

/// When a picture that is traced in passes is done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Until {
    /// Once its estimated error, an rms of linear light from 0 for black to 1 for white, is at most this: above 0 and below 1.
    Error(f64),
    /// Once this time is over, which is not 0.
    Time(Duration),
}

/// It is no end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "expected an error above 0 and below 1, as 0.004 (an rms of light), or a time, as 500ms, 30s, 2m or 1h"
)]
pub struct NoEnd;

/// The longest time, in seconds: a year.
const LONGEST: f64 = 365.0 * 24.0 * 3600.0;

/// Units of time, in seconds. One that ends as another does comes first.
const UNITS: [(&str, f64); 4] = [("ms", 0.001), ("s", 1.0), ("m", 60.0), ("h", 3600.0)];

impl FromStr for Until {
    type Err = NoEnd;

    fn from_str(text: &str) -> Result<Self, NoEnd> {
        let text = text.to_ascii_lowercase();
        let number = |text: &str| {
            let is_plain = text.starts_with(|first: char| first.is_ascii_digit() || first == '.');
            text.parse().ok().filter(|number: &f64| is_plain && *number > 0.0).ok_or(NoEnd)
        };
        let time = UNITS.iter().find_map(|(unit, seconds)| Some((text.strip_suffix(unit)?, seconds)));
        let Some((count, seconds)) = time else {
            return Some(number(&text)?).filter(|error| *error < 1.0).map(Self::Error).ok_or(NoEnd);
        };
        let seconds = Some(number(count)? * seconds).filter(|seconds| *seconds <= LONGEST).ok_or(NoEnd)?;
        let time = Duration::try_from_secs_f64(seconds).map_err(|_| NoEnd)?;
        if time.is_zero() { Err(NoEnd) } else { Ok(Self::Time(time)) }
    }
}

impl fmt::Display for Until {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Error(error) => error.fmt(f),
            Self::Time(time) => write!(f, "{}s", time.as_secs_f64()),
        }
    }
}

#[cfg(test)]
mod tests {
    use core::time::Duration;

    use super::Until;

    #[test]
    fn errors_are_numbers_and_times_have_units() {
        let time = |text: &str| match text.parse() {
            Ok(Until::Time(time)) => time,
            other => panic!("{text}: {other:?}"),
        };
        for (text, milliseconds) in [
            ("500ms", 500),
            ("30s", 30_000),
            ("2M", 120_000),
            ("1h", 3_600_000),
            ("1.5s", 1500),
            (".25S", 250),
        ] {
            assert_eq!(time(text), Duration::from_millis(milliseconds), "{text}");
        }
        for (text, error) in [("0.004", 0.004), (".5", 0.5), ("1e-3", 0.001)] {
            assert_eq!(text.parse(), Ok(Until::Error(error)), "{text}");
        }
        for text in ["30s", "0.5s", "0.004"] {
            assert_eq!(text.parse::<Until>().expect(text).to_string(), text);
        }
        for text in [
            "", "0", "0.0", "-0.004", "+0.004", "1", "30", "nan", "inf", "infs", "nans", "0s", "-3s", "3 s",
            "s", "ms", "3d", "3sec", "1e-30s", "9000h", "1e300h", "0x1s", "1e-400",
        ] {
            assert!(text.parse::<Until>().is_err(), "{text}");
        }
    }
}
