//! The sums of a picture's light in one number format, to which passes add.

use core::sync::atomic::{AtomicUsize, Ordering};

use rayon::ThreadPool;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};
use rta_core::color::Rgb;
use rta_core::raster::{Places, Raster};
use rta_core::sampling::Sobol;
use rta_core::sampling::pairs::hash;
use rta_packets::agreement::Agreement;
use rta_packets::picture::{Added, Pass, Picture, Setup};
use rta_scenes::narrow::Narrow;

use super::{SCRAMBLES, Sums, Tolerance};
use crate::engine::single;

/// The error is told by one pixel of each block of so many rows and columns of a large picture.
const BLOCK: u32 = 4;

/// A small picture has smaller blocks, so that there are about as many.
const BLOCKS: u32 = 1024;

/// Pixels that a thread adds to before it asks whether the work is to end. A tracer is made ready for each: 5 % of the instructions of a quick
/// picture of a room with 32 of them.
const CHUNK: usize = 128;

/// What is kept of a pixel's samples beside their sum: nothing, or how far they differ.
trait Kept: Copy + Default + Send + Sync + 'static {
    /// Returns what is told of each sample, if something is.
    fn agreement(&mut self) -> Option<&mut Agreement>;

    /// Returns whether the samples agree within a tolerance.
    fn agrees(&self, tolerance: u16) -> bool;

    /// Returns whether the samples of another pixel have nearly the same mean, see [`Agreement::is_near`].
    fn is_near(&self, other: &Self, tolerance: u16) -> bool;
}

impl Kept for () {
    fn agreement(&mut self) -> Option<&mut Agreement> {
        None
    }

    fn agrees(&self, _tolerance: u16) -> bool {
        false
    }

    fn is_near(&self, _other: &Self, _tolerance: u16) -> bool {
        false
    }
}

impl Kept for Agreement {
    fn agreement(&mut self) -> Option<&mut Agreement> {
        Some(self)
    }

    fn agrees(&self, tolerance: u16) -> bool {
        self.is_within(tolerance)
    }

    fn is_near(&self, other: &Self, tolerance: u16) -> bool {
        Self::is_near(self, other, tolerance)
    }
}

/// A pixel: the sum of the light of its samples, and what else is kept of them.
#[derive(Clone, Copy)]
struct Pixel<S: Narrow, K> {
    sum: Rgb<S::Light>,
    kept: K,
}

/// The sums of a picture in the number format `S`.
struct Accumulated<'e, S: Narrow, K> {
    picture: &'e dyn Picture<S>,
    width: usize,
    pixels: Vec<Pixel<S, K>>,
    /// Room for the next pass.
    next: Vec<Pixel<S, K>>,
    checked: Vec<Checked<S>>,
    next_checked: Vec<Checked<S>>,
    tolerance: Option<Tolerance>,
    /// How many samples each pixel has ended with, 0 of those that go on; empty as long as all go on.
    ended: Vec<u32>,
}

/// A pixel by which the error is told: its place, and its sums by the other seeds.
#[derive(Clone, Copy)]
struct Checked<S: Narrow> {
    pixel: [u32; 2],
    sums: [Rgb<S::Light>; SCRAMBLES - 1],
}

/// Returns whether a pixel takes more samples; `ended` is [`Accumulated::ended`].
fn takes_more(ended: &[u32], index: usize) -> bool {
    ended.get(index).is_none_or(|&samples| samples == 0)
}

/// Begins the sums of a picture; `None` where there is no memory for them.
pub(in crate::engine) fn begin<S: Narrow>(
    picture: &dyn Picture<S>,
    seed: u32,
    tolerance: Option<Tolerance>,
) -> Option<Box<dyn Sums + '_>> {
    match tolerance {
        None => Accumulated::<S, ()>::new(picture, checked(picture.setup().raster, seed), None),
        Some(tolerance) => Accumulated::<S, Agreement>::new(picture, Vec::new(), Some(tolerance)),
    }
}

/// Returns the pixels by which the error is told.
fn checked<S: Narrow>(raster: Raster, seed: u32) -> Vec<Checked<S>> {
    // Both sides are below 2^16.
    let side = (raster.width() * raster.height() / BLOCKS).isqrt().clamp(1, BLOCK);
    let mut checked = Vec::new();
    for y in (0..raster.height()).step_by(side as usize) {
        for x in (0..raster.width()).step_by(side as usize) {
            // A place of its own in each block: what repeats in the picture is met as often as it is there.
            let [right, down, ..] = hash([x, y, seed, 1]);
            let pixel = [x + right % side, y + down % side];
            if pixel[0] < raster.width() && pixel[1] < raster.height() {
                checked.push(Checked { pixel, sums: [Rgb::BLACK; SCRAMBLES - 1] });
            }
        }
    }
    checked
}

impl<'e, S: Narrow, K: Kept> Accumulated<'e, S, K> {
    #[allow(clippy::new_ret_no_self)] // it is only known by its trait
    fn new(
        picture: &'e dyn Picture<S>,
        checked: Vec<Checked<S>>,
        tolerance: Option<Tolerance>,
    ) -> Option<Box<dyn Sums + 'e>> {
        let Setup { raster, .. } = *picture.setup();
        let [width, height] = [raster.width(), raster.height()].map(|side| side as usize);
        let black = || {
            let mut pixels = Vec::new();
            pixels.try_reserve_exact(width.checked_mul(height)?).ok()?;
            pixels.resize(width * height, Pixel { sum: Rgb::BLACK, kept: K::default() });
            Some(pixels)
        };
        let next_checked = checked.clone();
        let (pixels, next) = (black()?, black()?);
        Some(Box::new(Self {
            picture,
            width,
            pixels,
            next,
            checked,
            next_checked,
            tolerance,
            ended: Vec::new(),
        }))
    }

    /// Ends the pixels that agree, and whose neighbours do, with the `samples` that all that went on have. One sample agrees with those of its
    /// neighbours or not.
    fn settle(&mut self, samples: u32) {
        let Some(Tolerance { parts, fewest }) = self.tolerance else { return };
        if samples < fewest {
            return;
        }
        // Few pixels differ once there are many samples.
        let goes_on = if samples == 1 { self.unlike(parts) } else { self.differing(parts) };
        self.ended.resize(self.pixels.len(), 0);
        for (ended, goes_on) in self.ended.iter_mut().zip(goes_on) {
            if *ended == 0 && !goes_on {
                *ended = samples;
            }
        }
    }

    /// Returns the pixels that go on and whose samples differ by more than a tolerance, and their neighbours.
    fn differing(&self, parts: u16) -> Vec<bool> {
        let mut goes_on = vec![false; self.pixels.len()];
        for (index, pixel) in self.pixels.iter().enumerate() {
            if !takes_more(&self.ended, index) || pixel.kept.agrees(parts) {
                continue;
            }
            let (x, y) = (index % self.width, index / self.width);
            for row in y.saturating_sub(1)..=y + 1 {
                let columns = x.saturating_sub(1)..(x + 2).min(self.width);
                let around = row * self.width + columns.start..row * self.width + columns.end;
                if let Some(around) = goes_on.get_mut(around) {
                    around.fill(true);
                }
            }
        }
        goes_on
    }

    /// Returns the pixels with a neighbour that differs by more than a tolerance. All have as many samples.
    fn unlike(&self, parts: u16) -> Vec<bool> {
        let mut unlike = vec![false; self.pixels.len()];
        for (index, pixel) in self.pixels.iter().enumerate() {
            let (is_first, is_last) = (index % self.width == 0, index % self.width + 1 == self.width);
            // Right, and below. The others have asked this one.
            let below = index + self.width;
            let others = [(is_last, index + 1), (is_first, below - 1), (false, below), (is_last, below + 1)];
            for (is_beside, other) in others {
                if let Some(beside) = self.pixels.get(other).filter(|_| !is_beside)
                    && !pixel.kept.is_near(&beside.kept, parts)
                {
                    for k in [index, other] {
                        if let Some(unlike) = unlike.get_mut(k) {
                            *unlike = true;
                        }
                    }
                }
            }
        }
        unlike
    }

    /// Hands each pixel from row `first` on over with its mean light.
    fn each<T>(&self, samples: Sobol, first: u32, out: &mut [T], convert: impl Fn(Rgb<S::Light>) -> T) {
        let first = first as usize * self.width;
        for (out, (index, pixel)) in out.iter_mut().zip((first..).zip(self.pixels.iter().skip(first))) {
            let ended = self.ended.get(index).and_then(|&ended| Sobol::new(ended, samples.seed()));
            *out = convert(ended.unwrap_or(samples).mean(pixel.sum));
        }
    }
}

impl<S: Narrow, K: Kept> Sums for Accumulated<'_, S, K> {
    fn add(
        &mut self,
        [own, others @ ..]: [Pass; SCRAMBLES],
        pool: &ThreadPool,
        goes_on: &(dyn Fn() -> bool + Sync),
        done: &(dyn Fn(usize) + Sync),
    ) -> bool {
        let (picture, width, ended) = (self.picture, self.width, &self.ended);
        let added = AtomicUsize::new(0);
        let place = |index: usize| {
            // Both are sides of a raster.
            [index % width, index / width].map(|side| u32::try_from(side).unwrap_or(u32::MAX))
        };
        pool.install(|| {
            let chunks = self.next.par_chunks_mut(CHUNK).zip(self.pixels.par_chunks(CHUNK)).enumerate();
            chunks.for_each(|(chunk, (next, pixels))| {
                if goes_on() {
                    next.copy_from_slice(pixels);
                    let more =
                        (chunk * CHUNK..).zip(next.iter_mut()).filter(|(index, _)| takes_more(ended, *index));
                    picture.add(
                        own,
                        &mut more.map(|(index, Pixel { sum, kept })| Added {
                            place: place(index),
                            sum,
                            agreement: kept.agreement(),
                        }),
                    );
                    added.fetch_add(pixels.len(), Ordering::Relaxed);
                    done(pixels.len());
                }
            });
            let chunks = self.next_checked.par_chunks_mut(CHUNK).zip(self.checked.par_chunks(CHUNK));
            chunks.for_each(|(next, checked)| {
                if goes_on() {
                    next.copy_from_slice(checked);
                    for (scramble, pass) in others.into_iter().enumerate() {
                        let sums = next.iter_mut().filter_map(|Checked { pixel, sums }| {
                            let sum = sums.get_mut(scramble)?;
                            Some(Added { place: *pixel, sum, agreement: None })
                        });
                        picture.add(pass, &mut { sums });
                    }
                    added.fetch_add(checked.len(), Ordering::Relaxed);
                }
            });
        });
        let is_complete = added.into_inner() == self.pixels.len() + self.checked.len();
        if is_complete {
            core::mem::swap(&mut self.pixels, &mut self.next);
            core::mem::swap(&mut self.checked, &mut self.next_checked);
            self.settle(own.samples.samples());
        }
        is_complete
    }

    fn unsettled(&self) -> usize {
        (0..self.pixels.len()).filter(|&index| takes_more(&self.ended, index)).count()
    }

    fn taken(&self, all: u32) -> u64 {
        let taken = |index| self.ended.get(index).copied().filter(|&ended| ended > 0).unwrap_or(all);
        (0..self.pixels.len()).map(|index| u64::from(taken(index))).sum()
    }

    #[allow(clippy::cast_precision_loss)] // a picture has fewer than 2^32 pixels
    fn error(&self, samples: Sobol) -> f64 {
        let spread = |checked: &Checked<S>| {
            let [x, y] = checked.pixel.map(|side| side as usize);
            let own = self.pixels.get(y * self.width + x).map_or(Rgb::BLACK, |pixel| pixel.sum);
            let light = |sum| samples.mean(sum).map(S::light_to_f64);
            let [a, b, c] = checked.sums;
            let lights = [own, a, b, c].map(light);
            let variance = |register: fn(&Rgb<f64>) -> f64| {
                let mean = lights.iter().map(register).sum::<f64>() / SCRAMBLES as f64;
                let squares = lights.iter().map(|light| (register(light) - mean).powi(2));
                squares.sum::<f64>() / (SCRAMBLES - 1) as f64
            };
            (variance(|light| light.r) + variance(|light| light.g) + variance(|light| light.b)) / 3.0
        };
        if self.checked.is_empty() {
            return f64::INFINITY;
        }
        (self.checked.iter().map(spread).sum::<f64>() / self.checked.len() as f64).sqrt()
    }

    fn linear(&self, samples: Sobol, first: u32, out: &mut [Rgb<f32>]) {
        self.each(samples, first, out, |light| light.map(single::<S>));
    }

    fn levels(&self, samples: Sobol, first: u32, gun_max: u8, out: &mut [Rgb<u8>]) {
        self.each(samples, first, out, |light| light.levels(gun_max));
    }
}
