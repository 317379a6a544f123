//! Several samples a pixel: regular and jittered grids, and the mean of what they see.

use core::iter::FusedIterator;

use crate::camera::Camera;
use crate::color::Rgb;
use crate::illumination::Illumination;
use crate::needs::Needs;
use crate::raster::Raster;
use crate::scalar::{Light, Scalar, Unit};
use crate::trace::Tracer;

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

/// Fractions of a cell that jitter tells apart.
const CELL: i64 = 1 << 16;

impl Sampling {
    /// One sample, in the middle of the pixel.
    pub const CENTER: Self = Self { side: 1, seed: None };

    /// The most cells along a side: 16384 samples of at most 1 add up to less than the largest
    /// [`Radiance`](crate::scalar::Radiance).
    pub const MAX_SIDE: u8 = 128;

    /// `side x side` samples, each in the middle of its cell; nothing where `side` is 0 or above
    /// [`Sampling::MAX_SIDE`].
    pub const fn grid(side: u8) -> Option<Self> {
        if side == 0 || side > Self::MAX_SIDE { None } else { Some(Self { side, seed: None }) }
    }

    /// The same cells, with each sample anywhere in its own.
    pub const fn jittered(self, seed: u32) -> Self {
        Self { seed: Some(seed), ..self }
    }

    /// Samples a pixel.
    pub fn samples(self) -> u32 {
        u32::from(self.side) * u32::from(self.side)
    }

    /// Whether the samples are jittered.
    pub const fn is_jittered(self) -> bool {
        self.seed.is_some()
    }

    /// The places of a pixel's samples on the image plane, for [`Camera::direction`]: row by row from the pixel's upper
    /// left, each coordinate from -1/2 to 1/2. Pixel (0, 0) is the upper left one.
    pub fn places<U: Unit>(self, raster: Raster, x: u32, y: u32) -> impl Iterator<Item = (U, U)> {
        let side = u32::from(self.side);
        let place = move |pixel: u32, cell: u32, part: i64, pixels: u32| {
            let cells = i64::from(pixels) * i64::from(side);
            let whole = i64::from(pixel) * i64::from(side) + i64::from(cell);
            U::ratio(2 * (whole * CELL + part) - cells * CELL, 2 * cells * CELL)
        };
        (0..self.samples()).map(move |sample| {
            let (right, down) = self.part(x, y, sample);
            (place(x, sample % side, right, raster.width()), -place(y, sample / side, down, raster.height()))
        })
    }

    /// Where in its cell a sample lies, in 1/65536ths from the left and from above.
    fn part(self, x: u32, y: u32, sample: u32) -> (i64, i64) {
        let Some(seed) = self.seed else { return (CELL / 2, CELL / 2) };
        let [right, down, ..] = hash([x, y, sample, seed]);
        (i64::from(right >> 16), i64::from(down >> 16))
    }

    /// The mean of the light of `samples` samples (the box filter), each cut to what a display can show: a glint
    /// twenty thousand times as bright as white would whiten a pixel that it covers a sixteenth of.
    pub fn mean<L: Light>(self, samples: impl Iterator<Item = Rgb<L>>) -> Rgb<L> {
        let shown = |light: L| if light > L::WHITE { L::WHITE } else { light };
        let sum = samples.fold(Rgb::BLACK, |sum: Rgb<L>, light| sum.plus(light.map(shown)));
        let share = L::Unit::ratio(1, i64::from(self.samples()));
        sum.map(|light| light.times(share))
    }

    /// The light of one pixel.
    pub fn pixel<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize>(
        self,
        tracer: &Tracer<'_, S, M, N, STACK>,
        camera: &Camera<S>,
        raster: Raster,
        (x, y): (u32, u32),
    ) -> Rgb<S::Light> {
        let places = self.places(raster, x, y);
        self.mean(places.map(|(right, up)| tracer.primary(camera, camera.direction(right, up))))
    }
}

/// Four words into four others that look random: `pcg4d` of M. Jarzynski and M. Olano, "Hash Functions for GPU
/// Rendering", JCGT 9(3), 2020.
fn hash(words: [u32; 4]) -> [u32; 4] {
    let mix = |[mut x, mut y, mut z, mut w]: [u32; 4]| {
        x = x.wrapping_add(y.wrapping_mul(w));
        y = y.wrapping_add(z.wrapping_mul(x));
        z = z.wrapping_add(x.wrapping_mul(y));
        w = w.wrapping_add(y.wrapping_mul(z));
        [x, y, z, w]
    };
    let words = words.map(|word| word.wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
    mix(mix(words).map(|word| word ^ (word >> 16)))
}

/// The pixels of some rows like [`Pixels`](crate::raster::Pixels), each the mean of several samples.
///
/// With [`Sampling::CENTER`] the light is that of `Pixels`, but cut to what a display can show.
pub struct Supersampled<'a, S: Scalar, M, N, const STACK: usize> {
    tracer: &'a Tracer<'a, S, M, N, STACK>,
    camera: &'a Camera<S>,
    raster: Raster,
    sampling: Sampling,
    x: u32,
    y: u32,
    end: u32,
}

impl<'a, S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize> Supersampled<'a, S, M, N, STACK> {
    /// The pixels of the rows from `first` to before `end`, as far as the raster has them.
    pub fn rows(
        tracer: &'a Tracer<'a, S, M, N, STACK>,
        camera: &'a Camera<S>,
        raster: Raster,
        sampling: Sampling,
        first: u32,
        end: u32,
    ) -> Self {
        Self { tracer, camera, raster, sampling, x: 0, y: first, end: end.min(raster.height()) }
    }
}

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize> Iterator
    for Supersampled<'_, S, M, N, STACK>
{
    type Item = Rgb<S::Light>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.y >= self.end {
            return None;
        }
        let light = self.sampling.pixel(self.tracer, self.camera, self.raster, (self.x, self.y));
        self.x += 1;
        if self.x == self.raster.width() {
            self.x = 0;
            self.y += 1;
        }
        Some(light)
    }
}

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize> FusedIterator
    for Supersampled<'_, S, M, N, STACK>
{
}
