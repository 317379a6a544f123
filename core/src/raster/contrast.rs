//! Adaptive antialiasing by contrast (D. Mitchell, "Generating Antialiased Images at Low Sampling Densities", SIGGRAPH 87).
//!
//! Each pixel has one jittered sample. Where the contrast of the samples of a pixel and of the eight around it is too high for the eye, the
//! pixel has eight more; its light is the mean of its own.

use super::Raster;
use super::corners::Keep;
use super::places::Places;
use crate::camera::Camera;
use crate::color::Rgb;
use crate::sampling::Sobol;
use crate::scalar::{Light, Scalar, Unit};
use crate::trace::Trace;
use crate::trace::dice::Sample;

/// Samples of a pixel whose contrast is too high.
const SAMPLES: u32 = 9;

/// The greatest contrast, `(max - min) / (max + min)`, in tenths, of red, green and blue (Mitchell 1987, section 3).
const CONTRAST: Rgb<i64> = Rgb::new(4, 3, 6);

/// The rows of a picture, from the top to the bottom.
///
/// The memory is the caller's: the first samples of the pixels of three rows, as they are or [`Packed`](super::corners::Packed).
pub struct Contrasts<'a, S: Scalar, T: Trace<S>, K = Rgb<<S as Scalar>::Light>> {
    tracer: &'a T,
    camera: &'a Camera<S>,
    raster: Raster,
    places: Sobol,
    /// Row y is third y % 3.
    rows: &'a mut [K],
    y: u32,
    /// Rays from the eye so far.
    rays: u64,
    memory: T::Memory,
}

impl<'a, S: Scalar, T: Trace<S>, K: Keep<S::Light>> Contrasts<'a, S, T, K> {
    /// Returns the rows of a picture from row `first` on; `None` where `rows` is not as long as three rows. Pictures with different seeds
    /// have their samples at different places.
    pub fn new(
        tracer: &'a T,
        (camera, raster): (&'a Camera<S>, Raster),
        seed: u32,
        rows: &'a mut [K],
        first: u32,
    ) -> Option<Self> {
        let places = Sobol::new(SAMPLES, seed)?;
        if rows.len() != usize::try_from(raster.width()).ok()?.checked_mul(3)? {
            return None;
        }
        let memory = T::Memory::default();
        let mut contrasts = Self { tracer, camera, raster, places, rows, y: first, rays: 0, memory };
        for y in first.saturating_sub(1)..=first {
            contrasts.first_samples(y);
        }
        Some(contrasts)
    }

    /// Calls `put` with the light of each pixel of the next row, from left to right. Returns whether there was one.
    pub fn next_row(&mut self, mut put: impl FnMut(Rgb<S::Light>)) -> bool {
        let y = self.y;
        if y >= self.raster.height() {
            return false;
        }
        self.first_samples(y + 1);
        for x in 0..self.raster.width() {
            let first = self.kept(x, y);
            put(if self.is_contrasty(x, y) { self.refined((x, y), first) } else { first });
        }
        self.y += 1;
        true
    }

    /// Returns the number of rays from the eye so far.
    pub const fn rays(&self) -> u64 {
        self.rays
    }

    fn place(&self, x: u32, y: u32) -> Option<usize> {
        usize::try_from(u64::from(y % 3) * u64::from(self.raster.width()) + u64::from(x)).ok()
    }

    fn kept(&self, x: u32, y: u32) -> Rgb<S::Light> {
        let light = self.place(x, y).and_then(|place| self.rows.get(place));
        light.map_or(Rgb::BLACK, |light| light.light())
    }

    /// Traces the first sample of each pixel of a row, if there is such a row.
    fn first_samples(&mut self, y: u32) {
        if y >= self.raster.height() {
            return;
        }
        for x in 0..self.raster.width() {
            let light = self.light((x, y), 0);
            if let Some(place) = self.place(x, y).and_then(|place| self.rows.get_mut(place)) {
                *place = K::keep(light);
            }
        }
    }

    /// Returns the light of a sample of a pixel, white at most.
    fn light(&mut self, (x, y): (u32, u32), number: u32) -> Rgb<S::Light> {
        let row = self.places.row::<S::Unit>(self.raster, y);
        let place = self.places.place(self.raster, row, x, number);
        self.rays += 1;
        let own = Sample { x, y, number };
        let light = self.tracer.sample(self.camera, place, own, &mut self.memory, &mut ());
        light.map(|light| if light > S::Light::WHITE { S::Light::WHITE } else { light })
    }

    /// Returns whether the contrast of the first samples of a pixel and of those around it is too high in any register.
    fn is_contrasty(&self, x: u32, y: u32) -> bool {
        let mut low = Rgb::BLACK.map(|_: S::Light| S::Light::WHITE);
        let mut high = Rgb::BLACK;
        for row in y.saturating_sub(1)..=(y + 1).min(self.raster.height() - 1) {
            for column in x.saturating_sub(1)..=(x + 1).min(self.raster.width() - 1) {
                let light = self.kept(column, row);
                low = low.zip(light, |low, light| if light < low { light } else { low });
                high = high.zip(light, |high, light| if light > high { light } else { high });
            }
        }
        let most =
            low.zip(high, S::Light::plus).zip(CONTRAST, |sum, tenths| sum.times(S::Unit::ratio(tenths, 10)));
        let Rgb { r, g, b } = low.plus(most).zip(high, |most, high| high > most);
        r || g || b
    }

    /// Returns the mean light of all samples of a pixel, the first of which has the light `first`.
    fn refined(&mut self, pixel: (u32, u32), first: Rgb<S::Light>) -> Rgb<S::Light> {
        let sum = (1..SAMPLES).fold(first, |sum, number| sum.plus(self.light(pixel, number)));
        self.places.mean(sum)
    }
}

#[cfg(test)]
#[cfg(feature = "f64")]
#[allow(clippy::indexing_slicing, reason = "a test may panic")]
mod tests;
