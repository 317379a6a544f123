//! Sums of light, and when sweeps end.

use crate::color::Rgb;
use crate::scalar::{Light, Unit};

/// When sweeps end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stop {
    /// After how many sweeps at the latest.
    pub sweeps: u16,
    /// Where no register of a patch changes by `2^-bits` of the largest, or more, what it reflects; [`Stop::STILL`] where nothing changes.
    pub bits: u8,
}

impl Stop {
    /// As many bits as no change but 0 is small enough for.
    pub const STILL: u8 = u8::MAX;
}

impl Default for Stop {
    /// 2^-12 of the largest, or 16 sweeps.
    fn default() -> Self {
        Self { sweeps: 16, bits: 12 }
    }
}

/// What came of sweeps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome<L> {
    /// How many there were.
    pub sweeps: u16,
    /// The largest change of a register of a patch in the last one.
    pub change: L,
    /// The largest register of what a patch reflects.
    pub largest: L,
    /// Whether the change is small enough: whether more sweeps were not needed.
    pub is_done: bool,
}

/// A sum of light, register by register, and that of the weights.
pub(super) struct Gathered<L: Light> {
    sums: Rgb<L::Sum>,
    whole: L::Sum,
}

impl<L: Light> Gathered<L> {
    pub(super) const NOTHING: Self = Self { sums: Rgb::new(L::EMPTY, L::EMPTY, L::EMPTY), whole: L::EMPTY };

    pub(super) fn weigh(&mut self, weight: L::Unit) {
        self.whole = L::WHITE.added(self.whole, weight);
    }

    pub(super) fn add(&mut self, light: Rgb<L>, weight: L::Unit) {
        self.sums = self.sums.zip(light, |sum, light| light.added(sum, weight));
    }

    /// Returns the mean times `factor`.
    pub(super) fn mean(&self, factor: Rgb<L::Unit>) -> Rgb<L> {
        self.sums.zip(factor, |sum, factor| L::mean(sum, self.whole, factor))
    }
}

/// Returns by how much two radiances differ.
pub(super) fn apart<L: Light>(one: L, other: L) -> L {
    let (more, less) = if one < other { (other, one) } else { (one, other) };
    let part = |light: L, sum: L::Sum, weight| light.added(sum, weight);
    let sum = part(less, part(more, L::EMPTY, L::Unit::ONE), -L::Unit::ONE);
    L::mean(sum, L::WHITE.added(L::EMPTY, L::Unit::ONE), L::Unit::ONE)
}

/// Makes `most` the largest register of it and a colour.
pub(super) fn see<L: Light>(most: &mut L, light: Rgb<L>) {
    light.map(|light| {
        if light > *most {
            *most = light;
        }
    });
}
