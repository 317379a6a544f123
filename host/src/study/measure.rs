//! How different two pictures look: FLIP, S-CIELAB and PSNR.
//!
//! | step | where |
//! | --- | --- |
//! | codes of sRGB into linear light, CIE XYZ and CIELAB | [`colorimetry`] |
//! | blurring as the eye does at a distance | [`convolution`] |
//! | FLIP: how visible the difference is, from 0 to 1 | [`flip`] |
//! | S-CIELAB: the difference of colours that are blurred first | [`scielab`], with [`mod@ciede2000`] |
//! | PSNR: the difference of the codes, without an eye | [`mod@psnr`] |
//!
//! All three compare a test picture with a reference of equal size, both with 8 bits a register, read as codes of sRGB: that is
//! how a window shows them, and a PNG without a gamma.

pub mod ciede2000;
pub mod colorimetry;
pub mod convolution;
pub mod flip;
pub mod psnr;
pub mod scielab;

use core::fmt;
use core::str::FromStr;

use rta_core::color::Rgb;

use crate::picture::raster::Size;

pub use ciede2000::ciede2000;
pub use psnr::{Psnr, psnr};

/// Most pixels in one degree of the visual field. The eye resolves about 120.
pub const MAX_PIXELS_PER_DEGREE: f64 = 1000.0;

/// Two pictures or a distance that cannot be measured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeasureError {
    /// A picture does not have the number of pixels that its size says.
    #[error("a picture of {width}x{height} cannot be compared: it has {pixels} pixels")]
    Pixels {
        /// Pixels in a row, as they should be.
        width: u32,
        /// Rows, as they should be.
        height: u32,
        /// The number of pixels there are.
        pixels: usize,
    },
    /// Not a number above 0 up to [`MAX_PIXELS_PER_DEGREE`].
    #[error("pixels per degree are above 0 and at most {MAX_PIXELS_PER_DEGREE}, not {0}")]
    PixelsPerDegree(f64),
}

/// A reference and a test picture of equal size, as codes of sRGB, row by row from the upper left.
#[derive(Clone, Copy, Debug)]
pub struct Pair<'a> {
    reference: &'a [Rgb<u8>],
    test: &'a [Rgb<u8>],
    size: Size,
}

impl<'a> Pair<'a> {
    /// Returns the pair if both pictures are of `size`.
    ///
    /// # Errors
    /// [`MeasureError::Pixels`] for the first that has more pixels or fewer.
    pub fn new(reference: &'a [Rgb<u8>], test: &'a [Rgb<u8>], size: Size) -> Result<Self, MeasureError> {
        for pixels in [reference.len(), test.len()] {
            if pixels != size.pixels() {
                return Err(MeasureError::Pixels { width: size.width(), height: size.height(), pixels });
            }
        }
        Ok(Self { reference, test, size })
    }
}

/// How many pixels of a picture one degree of the visual field holds: the resolution of a screen times the distance of the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelsPerDegree(f64);

impl PixelsPerDegree {
    /// 67, a screen of today at arm's length: FLIP's own default.
    pub const DEFAULT: Self = Self(67.0);

    /// Returns `pixels` in a degree if that is a number above 0 up to [`MAX_PIXELS_PER_DEGREE`].
    ///
    /// # Errors
    /// [`MeasureError::PixelsPerDegree`].
    pub fn new(pixels: f64) -> Result<Self, MeasureError> {
        if pixels > 0.0 && pixels <= MAX_PIXELS_PER_DEGREE {
            Ok(Self(pixels))
        } else {
            Err(MeasureError::PixelsPerDegree(pixels))
        }
    }
}

impl fmt::Display for PixelsPerDegree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl FromStr for PixelsPerDegree {
    type Err = MeasureError;

    fn from_str(text: &str) -> Result<Self, MeasureError> {
        Self::new(text.parse().unwrap_or(f64::NAN))
    }
}

/// Returns the mean of a map of errors, as [`flip::map`] and [`scielab::map`] return it; 0 for one without pixels.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "a picture has fewer than 2^53 pixels")]
pub fn mean(map: &[f32]) -> f64 {
    map.iter().copied().map(f64::from).sum::<f64>() / map.len().max(1) as f64
}
