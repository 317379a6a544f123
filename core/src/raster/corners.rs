//! Adaptive antialiasing with light at the corners of pixels (T. Whitted, "An Improved Illumination Model for Shaded Display", CACM 23,
//! 1980).
//!
//! Where the light at the four corners of a pixel is alike, the pixel is their mean. Where it is not, the pixel is cut into quarters, and
//! each of them again, down to a depth. Corners are shared: most pixels cost one ray, and a pixel on an edge about `2^(k + 2)` of them, k
//! being the depth, for the error of a grid of `2^k x 2^k` samples.
//!
//! Something small may lie between corners that are alike. It is rarely alone: where one of the four pixels to the left or to
//! the right is cut, the light in the middle is compared too, and so is what is known already of the light on the left edge, and within a
//! pixel on the edges of a quarter, as squares beside have traced it. And a [`Force`] cuts pixels whatever their corners are, as Whitted
//! does for objects smaller than a pixel.

mod cells;
mod cutting;
mod keep;

pub use cutting::Cutting;
pub use keep::{Force, Keep, Packed};

use super::Raster;
use crate::camera::Camera;
use crate::color::Rgb;
use crate::scalar::{Light, Scalar, Unit};
use crate::trace::Trace;
use crate::trace::dice::Sample;
use cells::{Cells, mean};

/// Pixels to the left and to the right within which one that is cut has the middle of a pixel looked at: 1152 x 900 pixels of the
/// thesis's scenes need 4 for the error of 4 x 4 samples, more would find little (host/README.md has the figures).
const NEAR: u32 = 4;

/// Corners of the lower edge that are traced ahead: those of as many pixels and of this one.
const AHEAD: usize = NEAR as usize + 2;

/// The rows of a picture, from the top to the bottom. `PLACES` is the room for the light within a pixel, [`Cutting::places`].
///
/// The memory is the caller's: the light of the corners of one row, one more than it has pixels, as it is or [`Packed`].
pub struct Corners<
    'a,
    S: Scalar,
    T: Trace<S>,
    const PLACES: usize = 25,
    K = Rgb<<S as Scalar>::Light>,
    F = (),
> {
    tracer: &'a T,
    camera: &'a Camera<S>,
    raster: Raster,
    cutting: Cutting,
    /// The light at the upper corners of the row that is next.
    above: &'a mut [K],
    /// The light on the upper edges of the pixels of that row, between the corners; empty where it is not shared.
    edges: &'a mut [Rgb<S::Light>],
    cells: Cells<S, PLACES>,
    /// The column after that of the pixel to which the cells belong; 0 for none.
    after: u32,
    force: F,
    y: u32,
    /// Rays from the eye so far.
    rays: u64,
    memory: T::Memory,
}

impl<'a, S: Scalar, T: Trace<S>, const PLACES: usize, K: Keep<S::Light>> Corners<'a, S, T, PLACES, K> {
    /// Returns the rows of a picture from row `first` on; `None` where `above` is not as long as a row and one, or `PLACES` are too few.
    pub fn new(
        tracer: &'a T,
        (camera, raster): (&'a Camera<S>, Raster),
        cutting: Cutting,
        above: &'a mut [K],
        first: u32,
    ) -> Option<Self> {
        let corners = usize::try_from(raster.width()).ok()?.checked_add(1)?;
        if above.len() != corners || PLACES < cutting.places() {
            return None;
        }
        let (memory, cells) = (T::Memory::default(), Cells::NONE);
        let (edges, force) = (&mut [][..], ());
        let mut rows = Self {
            tracer,
            camera,
            raster,
            cutting,
            above,
            edges,
            cells,
            after: 0,
            force,
            y: first,
            rays: 0,
            memory,
        };
        for x in 0..=raster.width() {
            let light = rows.corner(x, first);
            rows.keep(x, light);
        }
        Some(rows)
    }

    /// Returns the rows with some pixels cut whatever their corners are.
    pub fn forced<F: Force>(self, force: F) -> Corners<'a, S, T, PLACES, K, F> {
        let Self { tracer, camera, raster, cutting, above, edges, cells, after, y, rays, memory, .. } = self;
        Corners { tracer, camera, raster, cutting, above, edges, cells, after, force, y, rays, memory }
    }
}

impl<'a, S: Scalar, T: Trace<S>, const PLACES: usize, K: Keep<S::Light>, F: Force>
    Corners<'a, S, T, PLACES, K, F>
{
    /// Returns the rows with the light between the corners of pixels one above the other traced once: the same picture for fewer rays.
    /// `edges` is their memory, of [`Cutting::edges`] lights for each pixel of a row; with less of it, less is shared.
    pub fn sharing(self, edges: &'a mut [Rgb<S::Light>]) -> Self {
        edges.fill(Self::unknown());
        Self { edges, ..self }
    }

    /// Calls `put` with the light of each pixel of the next row, from left to right. Returns whether there was one.
    pub fn next_row(&mut self, mut put: impl FnMut(Rgb<S::Light>)) -> bool {
        if self.y >= self.raster.height() {
            return false;
        }
        let (y, width) = (self.y, self.raster.width());
        self.after = 0;
        let mut ahead = [Rgb::BLACK; AHEAD];
        ahead[AHEAD - 1] = self.corner(0, y + 1);
        // A bit for each of the pixels from this one on whose corners differ, and the number of pixels since one was cut.
        let (mut differing, mut since) = (0, u32::MAX);
        for x in 0..=NEAR {
            differing |= u32::from(self.differs(x, &mut ahead)) << x;
        }
        for x in 0..width {
            let [below, next, ..] = ahead;
            let corners = [self.kept(x), self.kept(x + 1), below, next];
            let is_near = differing > 0 || since <= NEAR;
            let (light, is_cut) = self.pixel((x, y), &corners, differing & 1 == 0, is_near);
            put(light);
            self.keep(x, below);
            since = if is_cut { 1 } else { since.saturating_add(1) };
            differing = (differing >> 1) | u32::from(self.differs(x + 1 + NEAR, &mut ahead)) << NEAR;
        }
        let [end, ..] = ahead;
        self.keep(width, end);
        self.y += 1;
        true
    }

    /// Returns whether the corners of the pixel in column `x` of the next row differ; `false` beyond it. `ahead` are the last ones of its lower
    /// edge that were traced, and one more is.
    fn differs(&mut self, x: u32, ahead: &mut [Rgb<S::Light>; AHEAD]) -> bool {
        ahead.rotate_left(1);
        if x >= self.raster.width() {
            return false;
        }
        let light = self.corner(x + 1, self.y + 1);
        let [.., before, last] = ahead;
        *last = light;
        let corners = [self.kept(x), self.kept(x + 1), *before, light];
        !self.are_alike(corners)
    }

    /// Returns the number of rays from the eye so far.
    pub const fn rays(&self) -> u64 {
        self.rays
    }

    fn keep(&mut self, x: u32, light: Rgb<S::Light>) {
        if let Some(place) = usize::try_from(x).ok().and_then(|x| self.above.get_mut(x)) {
            *place = K::keep(light);
        }
    }

    /// Returns the light at a corner of pixels, as it is kept.
    fn corner(&mut self, x: u32, y: u32) -> Rgb<S::Light> {
        let side = 1 << self.cutting.depth;
        let light = self.light((x * side, y * side));
        K::keep(light).light()
    }

    fn kept(&self, x: u32) -> Rgb<S::Light> {
        let light = usize::try_from(x).ok().and_then(|x| self.above.get(x));
        light.map_or(Rgb::BLACK, |light| light.light())
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

    /// Returns the light of a pixel from that of its corners: upper left, upper right, lower left, lower right; and whether it was cut.
    /// `is_alike` tells whether they are alike, `is_near` whether a pixel near by is cut.
    fn pixel(
        &mut self,
        (x, y): (u32, u32),
        corners: &[Rgb<S::Light>; 4],
        is_alike: bool,
        is_near: bool,
    ) -> (Rgb<S::Light>, bool) {
        let side = 1u32 << self.cutting.depth;
        let is_forced = self.force.is_cut(x, y);
        if side == 1 || (is_alike && !is_near && !is_forced) {
            self.forget(x);
            return (mean(*corners), false);
        }
        let (first, half) = ((x * side, y * side), side / 2);
        let mut middle = None;
        if is_alike && !is_forced {
            let light = self.light((first.0 + half, first.1 + half));
            let left = self.is_beside(x).then(|| self.cells.on_right(side).map(|(_, light)| light));
            if self.are_alike(corners.iter().copied().chain([light]).chain(left.into_iter().flatten())) {
                self.forget(x);
                let whole = mean(*corners);
                return (mean([whole, whole, light, light]), false);
            }
            middle = Some(light);
        }
        self.enter(x);
        for (at, light) in [(0, 0), (side, 0), (0, side), (side, side)].into_iter().zip(*corners) {
            self.cells.keep(at, side, light);
        }
        if let Some(light) = middle {
            self.cells.keep((half, half), side, light);
        }
        let quarters = [(0, 0), (half, 0), (0, half), (half, half)];
        let light = mean(quarters.map(|at| self.square(first, at, half, is_forced)));
        self.leave(x);
        (light, true)
    }

    /// Returns the light of a square within a pixel whose place on the picture's lattice is `pixel`: `at` is its upper left, `size` its side.
    fn square(&mut self, pixel: (u32, u32), (x, y): (u32, u32), size: u32, is_forced: bool) -> Rgb<S::Light> {
        let side = 1 << self.cutting.depth;
        let corners = [(x, y), (x + size, y), (x, y + size), (x + size, y + size)];
        let corners = corners.map(|at| match self.cells.get(at, side) {
            Some(light) => light,
            None => {
                let light = self.light((pixel.0 + at.0, pixel.1 + at.1));
                self.cells.keep(at, side, light);
                light
            }
        });
        if size == 1 {
            return mean(corners);
        }
        let half = size / 2;
        if !is_forced && self.are_alike(corners.into_iter().chain(self.cells.on_edges((x, y), half, side))) {
            return mean(corners);
        }
        let quarters = [(x, y), (x + half, y), (x, y + half), (x + half, y + half)];
        mean(quarters.map(|at| self.square(pixel, at, half, is_forced)))
    }

    /// What stands for light that is not known: no light that is kept is brighter than white.
    fn unknown() -> Rgb<S::Light> {
        Rgb::BLACK.map(|_: S::Light| S::Light::WHITE.plus(S::Light::WHITE))
    }

    /// Returns the memory of the upper edge of a pixel, if there is any.
    fn edge(&mut self, x: u32) -> &mut [Rgb<S::Light>] {
        let edges = self.cutting.edges();
        let first = usize::try_from(x).map_or(usize::MAX, |x| x.saturating_mul(edges));
        self.edges.get_mut(first..first.saturating_add(edges)).unwrap_or_default()
    }

    /// Returns whether the cells are still those of the pixel to the left, which was cut.
    const fn is_beside(&self, x: u32) -> bool {
        self.after == x && x > 0
    }

    /// Makes the cells ready for a pixel, with the light of its left and of its upper edge that is known.
    fn enter(&mut self, x: u32) {
        let side = 1 << self.cutting.depth;
        let is_beside = self.is_beside(x);
        let cells = core::mem::replace(&mut self.cells, Cells::NONE);
        for (y, light) in cells.on_right(side).filter(|_| is_beside) {
            self.cells.keep((0, y), side, light);
        }
        for at in 1..side {
            let known = self.edge(x).get(at as usize - 1).copied();
            if let Some(light) = known.filter(|light| light.r <= S::Light::WHITE) {
                self.cells.keep((at, 0), side, light);
            }
        }
    }

    /// Keeps the light of the lower edge of a pixel that was cut.
    fn leave(&mut self, x: u32) {
        let side = 1 << self.cutting.depth;
        for at in 1..side {
            let light = self.cells.get((at, side), side).unwrap_or(Self::unknown());
            if let Some(place) = self.edge(x).get_mut(at as usize - 1) {
                *place = light;
            }
        }
        self.after = x + 1;
    }

    /// Forgets the light of the upper edge of a pixel that is not cut: that of its lower edge is not known.
    fn forget(&mut self, x: u32) {
        self.edge(x).fill(Self::unknown());
    }

    /// Returns whether lights differ by no more than the tolerance.
    fn are_alike(&self, lights: impl IntoIterator<Item = Rgb<S::Light>>) -> bool {
        let tolerance = S::Light::WHITE.times(S::Unit::ratio(self.cutting.tolerance.into(), 256));
        let mut low = Rgb::BLACK.map(|_: S::Light| S::Light::WHITE);
        let mut high = Rgb::BLACK;
        for light in lights {
            low = low.zip(light, |low, light| if light < low { light } else { low });
            high = high.zip(light, |high, light| if light > high { light } else { high });
        }
        let Rgb { r, g, b } = low.zip(high, |low, high| high <= low.plus(tolerance));
        r && g && b
    }
}

#[cfg(test)]
#[cfg(feature = "f64")]
#[allow(clippy::indexing_slicing, reason = "a test may panic")]
mod tests;
