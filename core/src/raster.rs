//! The raster, and its pixels as an iterator: a window takes some of them for each frame, firmware takes one between
//! interrupts, a test collects all.

pub mod contrast;
pub mod corners;
pub mod lattice;
mod places;

#[cfg(test)]
#[cfg(feature = "f64")]
mod edge;

use core::iter::FusedIterator;

pub use places::{Center, Places};

use crate::camera::Camera;
use crate::color::Rgb;
use crate::error::Error;
use crate::scalar::Scalar;
use crate::trace::dice::Sample;
use crate::trace::{Observer, Trace};

/// Width and height in pixels, each 1 to 65535.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Raster {
    width: u32,
    height: u32,
}

impl Raster {
    /// The most pixels in a row or in a column.
    pub const MAX_SIDE: u32 = u16::MAX as u32;

    /// Returns a raster of `width` x `height` pixels.
    ///
    /// # Errors
    /// [`Error::Raster`] where a side is 0 or exceeds [`Raster::MAX_SIDE`].
    pub const fn new(width: u32, height: u32) -> Result<Self, Error> {
        if width == 0 || height == 0 || width > Self::MAX_SIDE || height > Self::MAX_SIDE {
            return Err(Error::Raster { width, height });
        }
        Ok(Self { width, height })
    }

    /// Returns the number of pixels in a row.
    pub const fn width(self) -> u32 {
        self.width
    }

    /// Returns the number of rows.
    pub const fn height(self) -> u32 {
        self.height
    }
}

/// An iterator over the radiance of the pixels of some rows, from left to right and from top to bottom. `P` places the samples
/// of each pixel.
/// `for_each` and `fold` may be quicker than repeated calls of `next`, and give the same light.
pub struct Pixels<'a, S: Scalar, T: Trace<S>, P: Places = Center> {
    tracer: &'a T,
    camera: &'a Camera<S>,
    raster: Raster,
    places: P,
    x: u32,
    y: u32,
    end: u32,
    /// The column after the last pixel of the last row, row `end - 1`: less than the width once pixels were taken from the end.
    right: u32,
    /// What the samples of row `y` have in common: see [`Places::row`].
    row: P::Row<S::Unit>,
    memory: T::Memory,
}

impl<'a, S: Scalar, T: Trace<S>> Pixels<'a, S, T> {
    /// Returns an iterator over all pixels of a raster, one sample each.
    pub fn new(tracer: &'a T, camera: &'a Camera<S>, raster: Raster) -> Self {
        Self::sampled(tracer, camera, raster, Center, 0, raster.height)
    }

    /// Returns an iterator over the pixels of row `y`, 0 at the top, one sample each.
    pub fn row(tracer: &'a T, camera: &'a Camera<S>, raster: Raster, y: u32) -> Self {
        Self::sampled(tracer, camera, raster, Center, y, y.saturating_add(1))
    }
}

impl<'a, S: Scalar, T: Trace<S>, P: Places> Pixels<'a, S, T, P> {
    /// Returns an iterator over the rows `first..end`, cut to the raster, with the samples that `places` names.
    pub fn sampled(
        tracer: &'a T,
        camera: &'a Camera<S>,
        raster: Raster,
        places: P,
        first: u32,
        end: u32,
    ) -> Self {
        let row = places.row(raster, first.min(raster.height));
        let (end, memory) = (end.min(raster.height), T::Memory::default());
        Self { tracer, camera, raster, places, x: 0, y: first, end, right: raster.width, row, memory }
    }

    /// Returns the radiance of the next pixel, if there is one; `observer` is told of every ray.
    pub fn next_observed<O: Observer<S> + ?Sized>(&mut self, observer: &mut O) -> Option<Rgb<S::Light>> {
        self.step(self.tracer, self.camera, observer)
    }

    #[cfg_attr(not(target_os = "none"), inline(always))]
    fn step<O: Observer<S> + ?Sized>(
        &mut self,
        tracer: &T,
        camera: &Camera<S>,
        observer: &mut O,
    ) -> Option<Rgb<S::Light>> {
        if self.y >= self.end {
            return None;
        }
        let light = self.pixel(tracer, camera, self.row, (self.x, self.y), observer);
        self.x += 1;
        if self.x == self.raster.width {
            self.x = 0;
            self.y += 1;
            self.row = self.places.row(self.raster, self.y);
        }
        self.meet();
        Some(light)
    }

    /// Ends the iteration where its front has reached its back within a row.
    fn meet(&mut self) {
        if self.y + 1 == self.end && self.x >= self.right {
            self.y = self.end;
        }
    }

    /// Returns the radiance of the pixel in column `x` of row `y`, to which `row` belongs.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    fn pixel<O: Observer<S> + ?Sized>(
        &mut self,
        tracer: &T,
        camera: &Camera<S>,
        row: P::Row<S::Unit>,
        (x, y): (u32, u32),
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let mut sum = Rgb::BLACK;
        for sample in 0..self.places.samples() {
            let (right, up) = self.places.place(self.raster, row, x, sample);
            let light = if T::SPREADS {
                let own = Sample { x, y, number: sample };
                tracer.sample(camera, (right, up), own, &mut self.memory, observer)
            } else {
                // What it does by itself, without a call more: 24 bytes of a small machine's stack.
                tracer.trace(camera.eye, camera.direction(right, up), &mut self.memory, observer)
            };
            sum = self.places.add(sum, light);
        }
        self.places.mean(sum)
    }

    /// Does the work of [`Iterator::fold`]. Tracer and camera are arguments so that the compiler knows that they do not change,
    /// and reads their fields once (2 to 12 % fewer instructions for a picture).
    #[inline(never)]
    fn each<B>(
        &mut self,
        tracer: &T,
        camera: &Camera<S>,
        init: B,
        f: &mut impl FnMut(B, Rgb<S::Light>) -> B,
    ) -> B {
        let mut folded = init;
        while let Some(light) = self.step(tracer, camera, &mut ()) {
            folded = f(folded, light);
        }
        folded
    }
}

impl<S: Scalar, T: Trace<S>, P: Places> Iterator for Pixels<'_, S, T, P> {
    type Item = Rgb<S::Light>;

    fn next(&mut self) -> Option<Self::Item> {
        self.next_observed(&mut ())
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        // Each side is below 2^16, so the product is below 2^32.
        let rows = u64::from(self.end.saturating_sub(self.y));
        let taken = if rows == 0 { 0 } else { self.x + (self.raster.width - self.right) };
        let left = rows * u64::from(self.raster.width) - u64::from(taken);
        usize::try_from(left).map_or((usize::MAX, None), |left| (left, Some(left)))
    }

    fn fold<B, F: FnMut(B, Self::Item) -> B>(mut self, init: B, mut f: F) -> B {
        let (tracer, camera) = (self.tracer, self.camera);
        self.each(tracer, camera, init, &mut f)
    }
}

impl<S: Scalar, T: Trace<S>, P: Places> DoubleEndedIterator for Pixels<'_, S, T, P> {
    /// Returns the last pixel that is left: dithering draws every second row from right to left.
    fn next_back(&mut self) -> Option<Self::Item> {
        if self.y >= self.end {
            return None;
        }
        let y = self.end - 1;
        let row = self.places.row(self.raster, y);
        self.right -= 1;
        let light = self.pixel(self.tracer, self.camera, row, (self.right, y), &mut ());
        if self.right == 0 {
            self.right = self.raster.width;
            self.end -= 1;
        }
        self.meet();
        Some(light)
    }
}

impl<S: Scalar, T: Trace<S>, P: Places> ExactSizeIterator for Pixels<'_, S, T, P> {
    // The default checks that both ends of the hint are equal, and firmware would have the message.
    fn len(&self) -> usize {
        self.size_hint().0
    }
}

impl<S: Scalar, T: Trace<S>, P: Places> FusedIterator for Pixels<'_, S, T, P> {}
