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

use rta_core::color::Rgb;

use crate::picture::raster::Size;
pub use rta_args::value::degrees::PixelsPerDegree;

pub use ciede2000::ciede2000;
pub use psnr::{Psnr, psnr};

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

/// Returns the mean of a map of errors, as [`flip::map`] and [`scielab::map`] return it; 0 for one without pixels.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "a picture has fewer than 2^53 pixels")]
pub fn mean(map: &[f32]) -> f64 {
    map.iter().copied().map(f64::from).sum::<f64>() / map.len().max(1) as f64
}
