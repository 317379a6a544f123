//! Where the samples of a pixel lie: in its middle, or wherever another type places them, such as
//! [`Sampling`](crate::sampling::Sampling).

use super::Raster;
use crate::color::Rgb;
use crate::scalar::{Light, Unit};

/// Where the samples of a pixel lie on the image plane, and how their light is averaged.
pub trait Places: Copy + Send + Sync {
    /// What is computed once for all samples of a row of pixels.
    type Row<U: Unit>: Copy;

    /// Returns the number of samples of each pixel, at least 1.
    fn samples(&self) -> u32;

    /// Returns what the samples of row `y` have in common; row 0 is at the top.
    fn row<U: Unit>(&self, raster: Raster, y: u32) -> Self::Row<U>;

    /// Returns the place of a sample of pixel `x` on the image plane: how far to the right and how far up, each from -1/2 to
    /// 1/2, as [`Camera::direction`](crate::camera::Camera::direction) takes it.
    fn place<U: Unit>(&self, raster: Raster, row: Self::Row<U>, x: u32, sample: u32) -> (U, U);

    /// Returns the sum of the light of the samples so far and of one more.
    fn add<L: Light>(&self, sum: Rgb<L>, light: Rgb<L>) -> Rgb<L>;

    /// Returns the light of a pixel from the sum over all of its samples.
    fn mean<L: Light>(&self, sum: Rgb<L>) -> Rgb<L>;
}

/// One sample in the middle of each pixel, whose light is kept as it is.
#[derive(Clone, Copy, Debug, Default)]
pub struct Center;

impl Center {
    /// Returns where the centre of pixel `i` of `n` lies: `(2i + 1) / 2n - 1/2`. A rounded step that is added up from pixel to
    /// pixel would drift across the picture.
    fn place<U: Unit>(i: u32, n: u32) -> U {
        // Both are at most 2^17.
        U::fraction((2 * i + 1).cast_signed() - n.cast_signed(), 2 * n)
    }
}

impl Places for Center {
    /// How far down the row lies on the image plane, from -1/2 to 1/2.
    type Row<U: Unit> = U;

    fn samples(&self) -> u32 {
        1
    }

    fn row<U: Unit>(&self, raster: Raster, y: u32) -> U {
        Self::place(y, raster.height())
    }

    fn place<U: Unit>(&self, raster: Raster, row: U, x: u32, _sample: u32) -> (U, U) {
        (Self::place(x, raster.width()), -row)
    }

    fn add<L: Light>(&self, _sum: Rgb<L>, light: Rgb<L>) -> Rgb<L> {
        light
    }

    fn mean<L: Light>(&self, sum: Rgb<L>) -> Rgb<L> {
        sum
    }
}
