//! The light within one pixel.

use crate::color::Rgb;
use crate::scalar::{Light, Scalar, Unit};

/// The light within one pixel that was traced so far, at the places of a lattice of `side + 1` lights along each side.
pub(super) struct Cells<S: Scalar, const PLACES: usize> {
    light: [Option<Rgb<S::Light>>; PLACES],
}

impl<S: Scalar, const PLACES: usize> Cells<S, PLACES> {
    /// No light.
    pub(super) const NONE: Self = Self { light: [None; PLACES] };

    fn index((x, y): (u32, u32), side: u32) -> usize {
        usize::try_from(y * (side + 1) + x).unwrap_or(usize::MAX)
    }

    pub(super) fn get(&self, at: (u32, u32), side: u32) -> Option<Rgb<S::Light>> {
        self.light.get(Self::index(at, side)).copied().flatten()
    }

    pub(super) fn keep(&mut self, at: (u32, u32), side: u32, light: Rgb<S::Light>) {
        if let Some(place) = self.light.get_mut(Self::index(at, side)) {
            *place = Some(light);
        }
    }

    /// Returns the lights on the right edge, without its ends, that are known, and how far down each is.
    pub(super) fn on_right(&self, side: u32) -> impl Iterator<Item = (u32, Rgb<S::Light>)> {
        (1..side).filter_map(move |y| Some((y, self.get((side, y), side)?)))
    }

    /// Returns the lights in the middles of the edges of a square that are known: `at` is its upper left, `half` half of its side. The upper
    /// edge of the pixel is left out, whose light is known only where rows [share](super::Corners::sharing) it.
    pub(super) fn on_edges(
        &self,
        (x, y): (u32, u32),
        half: u32,
        side: u32,
    ) -> impl Iterator<Item = Rgb<S::Light>> {
        let size = 2 * half;
        let middles = [(x, y + half), (x + size, y + half), (x + half, y + size), (x + half, y)];
        middles.into_iter().filter(|&(_, y)| y > 0).filter_map(move |at| self.get(at, side))
    }
}

/// Returns the mean of four lights.
pub(super) fn mean<L: Light>(four: [Rgb<L>; 4]) -> Rgb<L> {
    let sum = four.into_iter().fold(Rgb::BLACK, Rgb::plus);
    sum.map(|light| light.times(L::Unit::ratio(1, 4)))
}
