//! The resolution of a screen as it is seen.

use core::fmt;
use core::str::FromStr;

/// Most pixels in one degree of the visual field. The eye resolves about 120.
pub const MAX_PIXELS_PER_DEGREE: f64 = 1000.0;

/// How many pixels of a picture one degree of the visual field holds: the resolution of a screen times the distance of the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelsPerDegree(pub(super) f64);

impl PixelsPerDegree {
    /// 67, a screen of today at arm's length: FLIP's own default.
    pub const DEFAULT: Self = Self(67.0);

    /// Returns `pixels` in a degree if that is a number above 0 up to [`MAX_PIXELS_PER_DEGREE`].
    ///
    /// # Errors
    /// [`NotInADegree`].
    pub fn new(pixels: f64) -> Result<Self, NotInADegree> {
        if pixels > 0.0 && pixels <= MAX_PIXELS_PER_DEGREE {
            Ok(Self(pixels))
        } else {
            Err(NotInADegree(pixels))
        }
    }

    /// Returns the number.
    #[must_use]
    pub const fn pixels(self) -> f64 {
        self.0
    }
}

/// Not a number above 0 up to [`MAX_PIXELS_PER_DEGREE`].
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("pixels per degree are above 0 and at most {MAX_PIXELS_PER_DEGREE}, not {0}")]
pub struct NotInADegree(pub f64);

impl fmt::Display for PixelsPerDegree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl FromStr for PixelsPerDegree {
    type Err = NotInADegree;

    fn from_str(text: &str) -> Result<Self, NotInADegree> {
        Self::new(text.parse().unwrap_or(f64::NAN))
    }
}
