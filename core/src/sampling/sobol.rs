//! Samples of a pixel by a sequence.

use super::pairs::{Purpose, pair};
use crate::color::Rgb;
use crate::raster::{Places, Raster};
use crate::scalar::{Light, Unit};

/// Samples of a pixel at the places of a Sobol sequence of its own.
///
/// Powers of two are well spread; any other number of samples draws a right picture with more noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sobol {
    samples: u32,
    seed: u32,
}

impl Sobol {
    /// The most samples of a pixel: their light adds up to less than the largest [`Radiance`](crate::scalar::Radiance).
    pub const MAX_SAMPLES: u32 = 16_384;

    /// Returns `samples` samples a pixel; `None` where that is 0 or above [`Sobol::MAX_SAMPLES`].
    pub const fn new(samples: u32, seed: u32) -> Option<Self> {
        if samples == 0 || samples > Self::MAX_SAMPLES { None } else { Some(Self { samples, seed }) }
    }

    /// Returns the seed, by which pictures of the same scene differ.
    pub const fn seed(&self) -> u32 {
        self.seed
    }
}

/// The samples of a [`Sobol`] whose light is kept as it is, for pictures of linear light: their mean is that of all their light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Uncut(pub Sobol);

impl Places for Uncut {
    /// The number of the row.
    type Row<U: Unit> = u32;

    fn samples(&self) -> u32 {
        self.0.samples()
    }

    fn row<U: Unit>(&self, _raster: Raster, y: u32) -> u32 {
        y
    }

    fn place<U: Unit>(&self, raster: Raster, y: u32, x: u32, sample: u32) -> (U, U) {
        self.0.place(raster, y, x, sample)
    }

    fn add<L: Light>(&self, sum: Rgb<L>, light: Rgb<L>) -> Rgb<L> {
        sum.plus(light)
    }

    fn mean<L: Light>(&self, sum: Rgb<L>) -> Rgb<L> {
        self.0.mean(sum)
    }
}

/// The mean is a box filter; light is cut to white first, as [`Sampling`](super::Sampling) does it.
impl Places for Sobol {
    /// The number of the row.
    type Row<U: Unit> = u32;

    fn samples(&self) -> u32 {
        self.samples
    }

    fn row<U: Unit>(&self, _raster: Raster, y: u32) -> u32 {
        y
    }

    fn place<U: Unit>(&self, raster: Raster, y: u32, x: u32, sample: u32) -> (U, U) {
        let words = pair(x, y, Purpose::Pixel.tag(1), self.seed, sample);
        let place = |pixel: u32, word: u32, pixels: u32| {
            // The upper 16 bits of the word; both terms are below 2^33.
            let part = i64::from(pixel << 16 | word >> 16);
            U::ratio(2 * part - (i64::from(pixels) << 16), i64::from(pixels) << 17)
        };
        (place(x, words[0], raster.width()), -place(y, words[1], raster.height()))
    }

    fn add<L: Light>(&self, sum: Rgb<L>, light: Rgb<L>) -> Rgb<L> {
        sum.plus(light.map(|light| if light > L::WHITE { L::WHITE } else { light }))
    }

    fn mean<L: Light>(&self, sum: Rgb<L>) -> Rgb<L> {
        let share = L::Unit::ratio(1, i64::from(self.samples));
        sum.map(|light| light.times(share))
    }
}
