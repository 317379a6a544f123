//! Several samples a pixel, on a regular or jittered grid or by a sequence, whose light is averaged; and the numbers that rays are spread by.

pub mod mapping;
pub mod pairs;
mod sobol;

use pairs::hash;
pub use sobol::{Sobol, Uncut};

use crate::color::Rgb;
use crate::raster::Raster;
pub use crate::raster::{Center, Places};
use crate::scalar::{Light, Unit};

/// Where the samples of a pixel lie: one in each cell of a grid of `side x side` cells, in its middle or, jittered
/// (R. Cook, "Stochastic Sampling in Computer Graphics", ACM TOG 5, 1986), anywhere in it.
///
/// Places are ratios of integers in every format. The jitter is a hash of pixel, sample and seed, so a picture does not
/// depend on the order in which its pixels are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sampling {
    side: u8,
    seed: Option<u32>,
}

/// The number of jittered positions along the side of a cell.
const CELL: i64 = 1 << 16;

impl Sampling {
    /// One sample, in the middle of the pixel.
    pub const CENTER: Self = Self { side: 1, seed: None };

    /// The most cells along a side: 16384 samples of at most 1 add up to less than the largest
    /// [`Radiance`](crate::scalar::Radiance).
    pub const MAX_SIDE: u8 = 128;

    /// Returns a grid of `side x side` samples, each in the middle of its cell; `None` where `side` is 0 or above
    /// [`Sampling::MAX_SIDE`].
    pub const fn grid(side: u8) -> Option<Self> {
        if side == 0 || side > Self::MAX_SIDE { None } else { Some(Self { side, seed: None }) }
    }

    /// Returns the grid with each sample at a random place in its cell, which depends on `seed`.
    pub const fn jittered(self, seed: u32) -> Self {
        Self { seed: Some(seed), ..self }
    }

    /// Returns whether the samples are jittered.
    pub const fn is_jittered(self) -> bool {
        self.seed.is_some()
    }

    /// Returns where a sample lies in its cell, in 1/65536 of the cell from its left and from its upper edge.
    fn part(self, x: u32, y: u32, sample: u32) -> (i64, i64) {
        let Some(seed) = self.seed else { return (CELL / 2, CELL / 2) };
        let [right, down, ..] = hash([x, y, sample, seed]);
        (i64::from(right >> 16), i64::from(down >> 16))
    }
}

/// Samples are numbered row by row from the pixel's upper left. The mean is a box filter. Light is cut to white first, or a
/// highlight twenty thousand times as bright as white would whiten a pixel of which it covers a sixteenth; the light of
/// [`Sampling::CENTER`] is not cut.
impl Places for Sampling {
    /// The number of the row.
    type Row<U: Unit> = u32;

    fn samples(&self) -> u32 {
        u32::from(self.side) * u32::from(self.side)
    }

    fn row<U: Unit>(&self, _raster: Raster, y: u32) -> u32 {
        y
    }

    fn place<U: Unit>(&self, raster: Raster, y: u32, x: u32, sample: u32) -> (U, U) {
        let side = u32::from(self.side);
        let place = |pixel: u32, cell: u32, part: i64, pixels: u32| {
            let cells = i64::from(pixels) * i64::from(side);
            let whole = i64::from(pixel) * i64::from(side) + i64::from(cell);
            U::ratio(2 * (whole * CELL + part) - cells * CELL, 2 * cells * CELL)
        };
        let (right, down) = self.part(x, y, sample);
        (place(x, sample % side, right, raster.width()), -place(y, sample / side, down, raster.height()))
    }

    fn add<L: Light>(&self, sum: Rgb<L>, light: Rgb<L>) -> Rgb<L> {
        if *self == Self::CENTER {
            return light;
        }
        sum.plus(light.map(|light| if light > L::WHITE { L::WHITE } else { light }))
    }

    fn mean<L: Light>(&self, sum: Rgb<L>) -> Rgb<L> {
        let share = L::Unit::ratio(1, i64::from(self.samples()));
        sum.map(|light| light.times(share))
    }
}

#[cfg(test)]
#[cfg(feature = "f64")]
#[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, clippy::indexing_slicing)] // tests
mod tests;
