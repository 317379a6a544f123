//! The size of a picture in pixels and the shape of the screen it fills.

use core::fmt;
use core::str::FromStr;

/// Largest number of pixels along one side of a picture.
pub const MAX_SIDE: u32 = 65_535;

/// Narrowest and widest screen that is accepted, as width over height.
pub const ASPECTS: core::ops::RangeInclusive<f64> = 0.01..=100.0;

/// Width and height in pixels, both within [`MAX_SIDE`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    width: u32,
    height: u32,
}

/// A size or an aspect that cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RasterError {
    /// Not of the form `WxH`.
    #[error("expected WIDTHxHEIGHT in whole pixels, such as 320x200")]
    NotASize,
    /// A side of zero.
    #[error("a picture needs at least 1x1 pixel")]
    NoPixels,
    /// A side beyond the limit.
    #[error("a side may have up to {MAX_SIDE} pixels")]
    TooLarge,
    /// Not a ratio of width to height.
    #[error("expected width over height as 4:3 or 1.333, from {} to {}", ASPECTS.start(), ASPECTS.end())]
    NotAnAspect,
}

impl Size {
    /// Returns the size if it is within the limits.
    ///
    /// # Errors
    /// [`RasterError::NoPixels`] and [`RasterError::TooLarge`].
    pub fn new(width: u32, height: u32) -> Result<Self, RasterError> {
        if width == 0 || height == 0 {
            return Err(RasterError::NoPixels);
        }
        if width > MAX_SIDE || height > MAX_SIDE {
            return Err(RasterError::TooLarge);
        }
        Ok(Self { width, height })
    }

    /// Clamps both sides to 1 to 8192; for the rasters of devices, which are within these limits.
    #[must_use]
    pub fn clamped(width: u32, height: u32) -> Self {
        Self { width: width.clamp(1, 8192), height: height.clamp(1, 8192) }
    }

    /// Pixels in a row.
    #[must_use]
    pub const fn width(self) -> u32 {
        self.width
    }

    /// Number of rows.
    #[must_use]
    pub const fn height(self) -> u32 {
        self.height
    }

    /// Pixels in a row, as a length of slices.
    #[must_use]
    pub const fn columns(self) -> usize {
        self.width as usize
    }

    /// Number of pixels, saturated where it does not fit a `usize`.
    #[must_use]
    pub const fn pixels(self) -> usize {
        (self.width as usize).saturating_mul(self.height as usize)
    }

    /// Width over height if the pixels are square.
    #[must_use]
    pub fn ratio(self) -> f64 {
        f64::from(self.width) / f64::from(self.height)
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

impl FromStr for Size {
    type Err = RasterError;

    fn from_str(text: &str) -> Result<Self, RasterError> {
        let side = |text: &str| {
            if text.is_empty() || !text.bytes().all(|byte| byte.is_ascii_digit()) {
                return Err(RasterError::NotASize);
            }
            // Digits alone that do not parse are a number beyond u32.
            text.parse::<u32>().map_err(|_| RasterError::TooLarge)
        };
        let (width, height) = text.split_once(['x', 'X']).ok_or(RasterError::NotASize)?;
        Self::new(side(width)?, side(height)?)
    }
}

/// Width over height of a whole screen, within [`ASPECTS`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aspect(f64);

impl Aspect {
    /// Returns the aspect if it is within the limits.
    ///
    /// # Errors
    /// [`RasterError::NotAnAspect`].
    pub fn new(ratio: f64) -> Result<Self, RasterError> {
        if ASPECTS.contains(&ratio) { Ok(Self(ratio)) } else { Err(RasterError::NotAnAspect) }
    }

    /// Width over height.
    #[must_use]
    pub const fn ratio(self) -> f64 {
        self.0
    }
}

impl FromStr for Aspect {
    type Err = RasterError;

    fn from_str(text: &str) -> Result<Self, RasterError> {
        let number = |text: &str| text.parse::<f64>().map_err(|_| RasterError::NotAnAspect);
        match text.split_once([':', '/']) {
            Some((width, height)) => Self::new(number(width)? / number(height)?),
            None => Self::new(number(text)?),
        }
    }
}

/// Returns the ratio as a fraction of small numbers, by continued fractions: 0.8333... is (5, 6).
///
/// A picture file states the shape of its pixels this way.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "each part is below 65536 where it is cast")]
#[expect(clippy::cast_sign_loss, reason = "each part is above 0")]
pub fn fraction(ratio: f64) -> (u32, u32) {
    let (mut last, mut best) = ((1.0, 0.0), (ratio.floor(), 1.0));
    let mut rest = ratio - ratio.floor();
    while rest > 1e-9 && (best.0 / best.1 - ratio).abs() > 1e-9 * ratio {
        let part = (1.0 / rest).floor();
        let next = (part * best.0 + last.0, part * best.1 + last.1);
        if next.0 > 65_535.0 || next.1 > 65_535.0 {
            break;
        }
        rest = 1.0 / rest - part;
        (last, best) = (best, next);
    }
    ((best.0 as u32).max(1), best.1 as u32)
}

#[cfg(test)]
mod tests {
    use super::{Aspect, RasterError, Size, fraction};

    #[test]
    fn sizes_are_read_and_printed() {
        let size: Size = "320x200".parse().expect("a size");
        assert_eq!((size.width(), size.height(), size.pixels()), (320, 200, 64_000));
        assert_eq!(size.to_string(), "320x200");
        assert_eq!("8192x8192".parse(), Size::new(8192, 8192));
    }

    #[test]
    fn sizes_beyond_the_limits_are_refused() {
        for text in ["0x0", "0x200", "320x0"] {
            assert_eq!(text.parse::<Size>(), Err(RasterError::NoPixels), "{text}");
        }
        for text in ["100000x100000", "65536x1", "1x65536", "99999999999999999999x1"] {
            assert_eq!(text.parse::<Size>(), Err(RasterError::TooLarge), "{text}");
        }
        for text in ["", "x", "320", "320x", "x200", "-1x5", "+1x5", "3.0x2", "320x200x2", " 320x200"] {
            assert_eq!(text.parse::<Size>(), Err(RasterError::NotASize), "{text}");
        }
    }

    #[test]
    fn aspects_are_ratios_or_numbers() {
        assert_eq!("4:3".parse::<Aspect>(), Aspect::new(4.0 / 3.0));
        assert_eq!("1.25".parse::<Aspect>(), Aspect::new(1.25));
        for text in ["", ":", "4:0", "0:3", "0", "-1", "nan", "inf", "1e9", "4:3:2", "wide"] {
            assert_eq!(text.parse::<Aspect>(), Err(RasterError::NotAnAspect), "{text}");
        }
    }

    #[test]
    fn fractions_are_the_shortest() {
        assert_eq!(fraction(4.0 / 3.0 / (320.0 / 200.0)), (5, 6));
        assert_eq!(fraction(1.0), (1, 1));
        assert_eq!(fraction(0.01), (1, 100));
        assert_eq!(fraction(100.0), (100, 1));
        assert_eq!(fraction(core::f64::consts::PI), (355, 113), "the next, 103993 : 33102, is too long");
    }
}
