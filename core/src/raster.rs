//! The raster, and its pixels as an iterator: a window takes a slice of it for each frame, firmware polls it between
//! interrupts, a test collects it.

use core::iter::FusedIterator;

use crate::camera::Camera;
use crate::color::Rgb;
use crate::error::Error;
use crate::illumination::Illumination;
use crate::lanes::geometry::through_plane;
use crate::needs::Needs;
use crate::scalar::{Scalar, Unit};
use crate::scene::{Known, Spots};
use crate::trace::{Stack, Tracer};
use crate::vector::UnitVec3;

/// Width and height in pixels, each 1 to 65535.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Raster {
    width: u32,
    height: u32,
}

impl Raster {
    /// The most pixels in a row or in a column.
    pub const MAX_SIDE: u32 = 65535;

    /// A raster.
    ///
    /// # Errors
    /// [`Error::Raster`] where a side is 0 or exceeds [`Raster::MAX_SIDE`].
    pub const fn new(width: u32, height: u32) -> Result<Self, Error> {
        if width == 0 || height == 0 || width > Self::MAX_SIDE || height > Self::MAX_SIDE {
            return Err(Error::Raster { width, height });
        }
        Ok(Self { width, height })
    }

    /// Pixels in a row.
    pub const fn width(self) -> u32 {
        self.width
    }

    /// Rows.
    pub const fn height(self) -> u32 {
        self.height
    }

    /// Where the centre of pixel `i` of `n` lies, from -1/2 to 1/2: the whole extent scaled by `(2i + 1) / 2n`. A step
    /// that was rounded and then added up would drift across the picture.
    fn center<U: Unit>(i: u32, n: u32) -> U {
        // Both are at most 2^17.
        U::fraction((2 * i + 1).cast_signed() - n.cast_signed(), 2 * n)
    }
}

/// The light of the pixels of some rows, from left to right and from top to bottom.
///
/// A loop over all of them (`for_each`, `fold`) is quicker than one step after the other, and brings the same light.
pub struct Pixels<'a, S: Scalar, M, N, const STACK: usize> {
    tracer: &'a Tracer<'a, S, M, N, STACK>,
    camera: &'a Camera<S>,
    raster: Raster,
    x: u32,
    y: u32,
    end: u32,
    /// Where the rows lie: of row `y`.
    height: S::Unit,
    known: Known,
}

impl<'a, S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize> Pixels<'a, S, M, N, STACK> {
    /// All pixels of a raster.
    pub fn new(tracer: &'a Tracer<'a, S, M, N, STACK>, camera: &'a Camera<S>, raster: Raster) -> Self {
        Self::rows(tracer, camera, raster, 0, raster.height)
    }

    /// The pixels of one row, 0 at the top.
    pub fn row(
        tracer: &'a Tracer<'a, S, M, N, STACK>,
        camera: &'a Camera<S>,
        raster: Raster,
        y: u32,
    ) -> Self {
        Self::rows(tracer, camera, raster, y, y.saturating_add(1))
    }

    /// The pixels of the rows from `first` to before `end`, as far as the raster has them.
    pub fn rows(
        tracer: &'a Tracer<'a, S, M, N, STACK>,
        camera: &'a Camera<S>,
        raster: Raster,
        first: u32,
        end: u32,
    ) -> Self {
        let height = Raster::center(first.min(raster.height), raster.height);
        let (end, known) = (end.min(raster.height), Known::new());
        Self { tracer, camera, raster, x: 0, y: first, end, height, known }
    }

    /// The next one, whose light `trace` finds.
    #[inline(always)]
    fn step(
        &mut self,
        camera: &Camera<S>,
        trace: impl FnOnce(UnitVec3<S>, &mut Known) -> Rgb<S::Light>,
    ) -> Option<Rgb<S::Light>> {
        if self.y >= self.end {
            return None;
        }
        let x = Raster::center(self.x, self.raster.width);
        let light = trace(camera.direction(x, -self.height), &mut self.known);
        self.go_on(1);
        Some(light)
    }

    /// On by so many pixels, not beyond the next row's first one.
    #[inline(always)]
    fn go_on(&mut self, pixels: u32) {
        self.x += pixels;
        if self.x == self.raster.width {
            self.x = 0;
            self.y += 1;
            self.height = Raster::center(self.y, self.raster.height);
        }
    }

    /// All that are left, one after the other.
    pub(crate) fn one_by_one<B>(mut self, init: B, mut f: impl FnMut(B, Rgb<S::Light>) -> B) -> B {
        let (tracer, camera) = (self.tracer, self.camera);
        self.each(tracer, camera, init, &mut f)
    }

    /// The same. Tracer and camera are its own, but arguments, of which it is known that nothing changes them: what all rays need
    /// of them is made ready once.
    #[cfg_attr(not(target_os = "none"), inline(never))]
    fn each<B>(
        &mut self,
        tracer: &Tracer<'_, S, M, N, STACK>,
        camera: &Camera<S>,
        init: B,
        f: &mut impl FnMut(B, Rgb<S::Light>) -> B,
    ) -> B {
        let mut folded = init;
        let trace = |direction, known: &mut _| tracer.follow(camera.eye, direction, known);
        while let Some(light) = self.step(camera, trace) {
            folded = f(folded, light);
        }
        folded
    }
}

impl<M: Illumination<f32>, N: Needs, const STACK: usize> Pixels<'_, f32, M, N, STACK> {
    /// All that are left, four at once.
    pub(crate) fn by_fours<B>(mut self, init: B, mut f: impl FnMut(B, Rgb<f32>) -> B) -> B {
        let (tracer, camera) = (self.tracer, self.camera);
        self.four_by_four(tracer, camera, init, &mut f)
    }

    /// The same. See [`Pixels::each`].
    #[inline(never)]
    fn four_by_four<B>(
        &mut self,
        tracer: &Tracer<'_, f32, M, N, STACK>,
        camera: &Camera<f32>,
        init: B,
        f: &mut impl FnMut(B, Rgb<f32>) -> B,
    ) -> B {
        let mut folded = init;
        let (mut pending, mut spots) = (core::array::from_fn(|_| Stack::new()), Spots::NONE);
        while self.y < self.end {
            let count = (self.raster.width - self.x).min(4);
            // Where there are less, the last one again.
            let [a, b, c, d] =
                [0, 1, 2, 3].map(|k: u32| Raster::center(self.x + k.min(count - 1), self.raster.width));
            let x = glam::Vec4::new(a, b, c, d);
            let directions = through_plane(camera.forward, camera.right, camera.up, x, -self.height);
            let lights =
                tracer.follow_four(camera.eye, directions, count, &mut pending, &mut spots, &mut self.known);
            for (light, _) in lights.into_iter().zip(0..count) {
                folded = f(folded, light);
            }
            self.go_on(count);
        }
        folded
    }
}

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize> Iterator for Pixels<'_, S, M, N, STACK> {
    type Item = Rgb<S::Light>;

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        let (tracer, camera) = (self.tracer, self.camera);
        self.step(camera, |direction, known| tracer.radiance_after(camera.eye, direction, known))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let rows = u64::from(self.end.saturating_sub(self.y));
        let left = rows * u64::from(self.raster.width) - u64::from(self.x);
        usize::try_from(left).map_or((usize::MAX, None), |left| (left, Some(left)))
    }

    fn fold<B, F: FnMut(B, Self::Item) -> B>(self, init: B, f: F) -> B {
        S::fold_pixels(self, init, f)
    }
}

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize> FusedIterator
    for Pixels<'_, S, M, N, STACK>
{
}
