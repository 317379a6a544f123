//! Pictures of one number a pixel, filtered along rows and columns. Beyond its border a picture goes on with its outermost pixels.

use core::iter::repeat_n;

/// The smallest standard deviation of a Gaussian, in pixels: with it a pixel's neighbour weighs exp(-50), which is nothing beside 1
/// in f32, so any that is smaller gives the same filter.
pub const SHARPEST: f64 = 0.1;

/// A filter in one dimension: the weights of a pixel and of those up to a radius before and after it.
#[derive(Clone, Debug, PartialEq)]
pub struct Kernel(Vec<f32>);

impl Kernel {
    /// Returns the filter that has `weight` at each distance from `-radius` to `radius`, in pixels.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "planes are f32")]
    pub fn new(radius: u16, weight: impl Fn(f64) -> f64) -> Self {
        Self(distances(radius).map(|x| weight(x) as f32).collect())
    }

    /// Returns a Gaussian, cut off at `radius`, whose weights have the sum 1. `deviation` is its standard deviation in pixels, at
    /// least [`SHARPEST`].
    #[must_use]
    pub fn gaussian(radius: u16, deviation: f64) -> Self {
        let sum = gaussian_sum(radius, deviation);
        Self::new(radius, |x| gaussian(x, deviation) / sum)
    }

    /// Returns the radius beyond which a Gaussian is cut off here: three standard deviations, rounded up.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates, and is positive")]
    pub fn radius(deviation: f64) -> u16 {
        (3.0 * deviation).ceil() as u16
    }
}

/// Returns a Gaussian of height 1 at the distance `x`; both are in pixels.
#[must_use]
pub fn gaussian(x: f64, deviation: f64) -> f64 {
    (-0.5 * (x / deviation).powi(2)).exp()
}

/// Returns the sum of a Gaussian of height 1 at all distances up to a radius.
#[must_use]
pub fn gaussian_sum(radius: u16, deviation: f64) -> f64 {
    distances(radius).map(|x| gaussian(x, deviation)).sum()
}

/// Returns the distances from `-radius` to `radius`.
pub fn distances(radius: u16) -> impl Iterator<Item = f64> {
    (-i32::from(radius)..=i32::from(radius)).map(f64::from)
}

/// A picture of one number a pixel, row by row from the upper left.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    columns: usize,
    values: Vec<f32>,
}

impl Plane {
    /// Returns a picture with rows of `columns` pixels, at least 1, as many of them as `values` fill.
    #[must_use]
    pub fn new(columns: usize, values: Vec<f32>) -> Self {
        Self { columns: columns.max(1), values }
    }

    /// The pixels.
    #[must_use]
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// Returns the picture filtered along its rows.
    #[must_use]
    pub fn along_rows(&self, kernel: &Kernel) -> Self {
        let radius = kernel.0.len() / 2;
        let mut sums = Vec::with_capacity(self.values.len());
        let mut extended = Vec::with_capacity(self.columns + 2 * radius);
        for row in self.values.chunks_exact(self.columns) {
            extended.clear();
            extended.extend(repeat_n(row.first().copied().unwrap_or_default(), radius));
            extended.extend_from_slice(row);
            extended.extend(repeat_n(row.last().copied().unwrap_or_default(), radius));
            sums.extend(weighted_sum(kernel, extended.windows(self.columns), self.columns));
        }
        Self { columns: self.columns, values: sums }
    }

    /// Returns the picture filtered along its columns.
    #[must_use]
    pub fn along_columns(&self, kernel: &Kernel) -> Self {
        let radius = kernel.0.len() / 2;
        let rows = || self.values.chunks_exact(self.columns);
        let above = rows().take(1).cycle().take(radius);
        let below = rows().next_back().into_iter().cycle().take(radius);
        let extended: Vec<&[f32]> = above.chain(rows()).chain(below).collect();
        let mut sums = Vec::with_capacity(self.values.len());
        for window in extended.windows(kernel.0.len()) {
            sums.extend(weighted_sum(kernel, window.iter().copied(), self.columns));
        }
        Self { columns: self.columns, values: sums }
    }

    /// Returns the picture blurred by a sum of filters, each with its share: a share's filter goes along rows and along columns.
    #[must_use]
    pub fn blurred(&self, shares: &[(f32, Kernel)]) -> Self {
        let mut sum = vec![0.0; self.values.len()];
        for (share, kernel) in shares {
            let blurred = self.along_rows(kernel).along_columns(kernel);
            for (sum, value) in sum.iter_mut().zip(&blurred.values) {
                *sum += share * value;
            }
        }
        Self { columns: self.columns, values: sum }
    }
}

/// Returns the sum of rows of pixels, each times its weight. One weight goes through a whole row before the next, which compilers
/// turn into SIMD.
fn weighted_sum<'a>(kernel: &Kernel, rows: impl Iterator<Item = &'a [f32]>, columns: usize) -> Vec<f32> {
    let mut sums = vec![0.0; columns];
    for (weight, row) in kernel.0.iter().zip(rows) {
        for (sum, value) in sums.iter_mut().zip(row) {
            *sum += weight * value;
        }
    }
    sums
}
