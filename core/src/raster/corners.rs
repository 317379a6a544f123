//! Adaptive antialiasing with light at the corners of pixels (T. Whitted, "An Improved Illumination Model for Shaded Display", CACM 23,
//! 1980).
//!
//! Where the light at the four corners of a pixel is alike, the pixel is their mean. Where it is not, the pixel is cut into quarters, and
//! each of them again, down to a depth. Corners are shared: most pixels cost one ray, and a pixel on an edge about `2^(k + 2)` of them, k
//! being the depth, for the error of a grid of `2^k x 2^k` samples.

use super::Raster;
use crate::camera::Camera;
use crate::color::Rgb;
use crate::scalar::{Light, Scalar, Unit};
use crate::trace::Trace;
use crate::trace::dice::Sample;

/// How pixels are cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Cutting {
    /// How often a pixel is halved along each side at most, 0 to [`Cutting::DEEPEST`].
    depth: u8,
    /// Corners that differ by more than this share of white, in 256ths, in any register are not alike.
    tolerance: u8,
}

impl Default for Cutting {
    /// Twice, where corners differ by more than a sixteenth.
    fn default() -> Self {
        Self { depth: 2, tolerance: 16 }
    }
}

impl Cutting {
    /// The largest depth.
    pub const DEEPEST: u8 = 4;

    /// Returns a depth and a tolerance in 256ths of white; `None` where the depth is above [`Cutting::DEEPEST`].
    pub const fn new(depth: u8, tolerance: u8) -> Option<Self> {
        if depth > Self::DEEPEST { None } else { Some(Self { depth, tolerance }) }
    }

    /// Returns the deepest cutting, of pixels that differ at all.
    pub const fn most() -> Self {
        Self { depth: Self::DEEPEST, tolerance: 0 }
    }

    /// Returns the depth.
    pub const fn depth(self) -> u8 {
        self.depth
    }

    /// Returns how many places of a pixel have light of their own at most: `(2^depth + 1)^2`, the room of a [`Corners`].
    pub const fn places(self) -> usize {
        let side = (1 << self.depth) + 1;
        side * side
    }
}

/// The rows of a picture, from the top to the bottom. `PLACES` is the room for the light within a pixel, [`Cutting::places`].
///
/// The memory is the caller's: the light of the corners of one row, one more than it has pixels.
pub struct Corners<'a, S: Scalar, T: Trace<S>, const PLACES: usize = 25> {
    tracer: &'a T,
    camera: &'a Camera<S>,
    raster: Raster,
    cutting: Cutting,
    /// The light at the upper corners of the row that is next.
    above: &'a mut [Rgb<S::Light>],
    y: u32,
    /// Rays from the eye so far.
    rays: u64,
    memory: T::Memory,
}

/// The light within one pixel, at the places of a lattice.
struct Cells<S: Scalar, const PLACES: usize> {
    light: [Option<Rgb<S::Light>>; PLACES],
}

impl<'a, S: Scalar, T: Trace<S>, const PLACES: usize> Corners<'a, S, T, PLACES> {
    /// Returns the rows of a picture from row `first` on; `None` where `above` is not as long as a row and one, or `PLACES` are too few.
    pub fn new(
        tracer: &'a T,
        (camera, raster): (&'a Camera<S>, Raster),
        cutting: Cutting,
        above: &'a mut [Rgb<S::Light>],
        first: u32,
    ) -> Option<Self> {
        let corners = usize::try_from(raster.width()).ok()?.checked_add(1)?;
        if above.len() != corners || PLACES < cutting.places() {
            return None;
        }
        let memory = T::Memory::default();
        let mut rows = Self { tracer, camera, raster, cutting, above, y: first, rays: 0, memory };
        for x in 0..=raster.width() {
            let light = rows.corner(x, first);
            rows.keep(x, light);
        }
        Some(rows)
    }

    /// Calls `put` with the light of each pixel of the next row, from left to right. Returns whether there was one.
    pub fn next_row(&mut self, mut put: impl FnMut(Rgb<S::Light>)) -> bool {
        if self.y >= self.raster.height() {
            return false;
        }
        let y = self.y;
        let mut below = self.corner(0, y + 1);
        for x in 0..self.raster.width() {
            let [left, right] = [x, x + 1].map(|x| self.kept(x));
            let next = self.corner(x + 1, y + 1);
            put(self.pixel((x, y), [left, right, below, next]));
            self.keep(x, below);
            below = next;
        }
        self.keep(self.raster.width(), below);
        self.y += 1;
        true
    }

    /// Returns the number of rays from the eye so far.
    pub const fn rays(&self) -> u64 {
        self.rays
    }

    fn kept(&self, x: u32) -> Rgb<S::Light> {
        let light = usize::try_from(x).ok().and_then(|x| self.above.get(x));
        light.copied().unwrap_or(Rgb::BLACK)
    }

    fn keep(&mut self, x: u32, light: Rgb<S::Light>) {
        if let Some(place) = usize::try_from(x).ok().and_then(|x| self.above.get_mut(x)) {
            *place = light;
        }
    }

    fn corner(&mut self, x: u32, y: u32) -> Rgb<S::Light> {
        let side = 1 << self.cutting.depth;
        self.light((x * side, y * side))
    }

    /// Returns the light at a place of the lattice that cuts each pixel `2^depth` times, from 0 at the picture's left and upper edges; white at
    /// most.
    fn light(&mut self, (x, y): (u32, u32)) -> Rgb<S::Light> {
        let place = |at: u32, pixels: u32| {
            let whole = i64::from(pixels) << self.cutting.depth;
            S::Unit::ratio(2 * i64::from(at) - whole, 2 * whole)
        };
        let (right, up) = (place(x, self.raster.width()), -place(y, self.raster.height()));
        self.rays += 1;
        let own = Sample { x, y, number: 0 };
        let light = self.tracer.sample(self.camera, (right, up), own, &mut self.memory, &mut ());
        light.map(|light| if light > S::Light::WHITE { S::Light::WHITE } else { light })
    }

    /// Returns the light of a pixel from that of its corners: upper left, upper right, lower left, lower right.
    fn pixel(&mut self, (x, y): (u32, u32), corners: [Rgb<S::Light>; 4]) -> Rgb<S::Light> {
        let depth = self.cutting.depth;
        if depth == 0 || self.are_alike(&corners) {
            return mean(corners);
        }
        let side = 1u32 << depth;
        let mut cells = Cells::<S, PLACES> { light: [None; PLACES] };
        for (at, light) in [(0, 0), (side, 0), (0, side), (side, side)].into_iter().zip(corners) {
            cells.keep(at, side, light);
        }
        self.square(&mut cells, (x * side, y * side), (0, 0), side)
    }

    /// Returns the light of a square within a pixel whose place on the picture's lattice is `pixel`: `at` is its upper left, `size` its side.
    fn square(
        &mut self,
        cells: &mut Cells<S, PLACES>,
        pixel: (u32, u32),
        (x, y): (u32, u32),
        size: u32,
    ) -> Rgb<S::Light> {
        let side = 1 << self.cutting.depth;
        let corners = [(x, y), (x + size, y), (x, y + size), (x + size, y + size)];
        let corners = corners.map(|at| match cells.get(at, side) {
            Some(light) => light,
            None => {
                let light = self.light((pixel.0 + at.0, pixel.1 + at.1));
                cells.keep(at, side, light);
                light
            }
        });
        if size == 1 || self.are_alike(&corners) {
            return mean(corners);
        }
        let half = size / 2;
        let quarters = [(x, y), (x + half, y), (x, y + half), (x + half, y + half)];
        mean(quarters.map(|at| self.square(cells, pixel, at, half)))
    }

    fn are_alike(&self, corners: &[Rgb<S::Light>; 4]) -> bool {
        let tolerance = S::Light::WHITE.times(S::Unit::ratio(self.cutting.tolerance.into(), 256));
        let spread = |register: fn(&Rgb<S::Light>) -> S::Light| {
            let [first, rest @ ..] = corners.each_ref().map(register);
            let low = rest.into_iter().fold(first, |low, light| if light < low { light } else { low });
            let high = rest.into_iter().fold(first, |high, light| if light > high { light } else { high });
            high <= low.plus(tolerance)
        };
        spread(|light| light.r) && spread(|light| light.g) && spread(|light| light.b)
    }
}

impl<S: Scalar, const PLACES: usize> Cells<S, PLACES> {
    fn index((x, y): (u32, u32), side: u32) -> usize {
        usize::try_from(y * (side + 1) + x).unwrap_or(usize::MAX)
    }

    fn get(&self, at: (u32, u32), side: u32) -> Option<Rgb<S::Light>> {
        self.light.get(Self::index(at, side)).copied().flatten()
    }

    fn keep(&mut self, at: (u32, u32), side: u32, light: Rgb<S::Light>) {
        if let Some(place) = self.light.get_mut(Self::index(at, side)) {
            *place = Some(light);
        }
    }
}

fn mean<L: Light>(four: [Rgb<L>; 4]) -> Rgb<L> {
    let sum = four.into_iter().fold(Rgb::BLACK, Rgb::plus);
    sum.map(|light| light.times(L::Unit::ratio(1, 4)))
}

#[cfg(test)]
#[cfg(feature = "f64")]
mod tests;
