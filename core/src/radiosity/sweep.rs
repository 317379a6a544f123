//! Sums of light, and when sweeps end.

use super::Error;
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

    /// Sweeps until an outcome is done, or as often as is allowed, but once at least.
    pub(super) fn repeat<L>(
        self,
        mut sweep: impl FnMut() -> Result<Outcome<L>, Error>,
    ) -> Result<Outcome<L>, Error> {
        let mut sweeps = 0;
        loop {
            let outcome = sweep()?;
            sweeps += 1;
            if outcome.is_done || sweeps >= self.sweeps {
                return Ok(Outcome { sweeps, ..outcome });
            }
        }
    }
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
#[derive(Clone, Copy)]
pub(super) struct Gathered<L: Light> {
    sums: Rgb<L::Sum>,
    whole: L::Sum,
}

impl<L: Light> Gathered<L> {
    pub(super) const NOTHING: Self = Self { sums: Rgb::new(L::EMPTY, L::EMPTY, L::EMPTY), whole: L::EMPTY };

    /// Returns no light of weights that come to `whole`.
    pub(super) const fn of(whole: L::Sum) -> Self {
        Self { whole, ..Self::NOTHING }
    }

    /// Returns the sum of the weights.
    pub(super) const fn whole(&self) -> L::Sum {
        self.whole
    }

    pub(super) fn weigh(&mut self, weight: L::Unit) {
        self.whole = L::WHITE.added(self.whole, weight);
    }

    pub(super) fn add(&mut self, light: Rgb<L>, weight: L::Unit) {
        self.sums = self.sums.zip(light, |sum, light| light.added(sum, weight));
    }

    /// Adds light of which each register has a weight of its own.
    pub(super) fn add_each(&mut self, light: Rgb<L>, weights: Rgb<L::Unit>) {
        self.sums =
            self.sums.zip(light.zip(weights, |light, weight| (light, weight)), |sum, (light, weight)| {
                light.added(sum, weight)
            });
    }

    /// Returns each sum over that of another.
    pub(super) fn over_each(&self, whole: &Self) -> Rgb<L> {
        self.sums.zip(whole.sums, |sum, whole| L::mean(sum, whole, L::Unit::ONE))
    }

    /// Returns the mean times `factor`.
    pub(super) fn mean(&self, factor: Rgb<L::Unit>) -> Rgb<L> {
        self.sums.zip(factor, |sum, factor| L::mean(sum, self.whole, factor))
    }
}

/// The largest change of a sweep.
pub(super) struct Watch<L> {
    change: L,
    largest: L,
}

impl<L: Light> Watch<L> {
    pub(super) const NEW: Self = Self { change: L::ZERO, largest: L::ZERO };

    /// Replaces the light of a patch, of which it reflects `reflected`.
    pub(super) fn put(&mut self, light: &mut Rgb<L>, new: Rgb<L>, reflected: Rgb<L>) {
        see(&mut self.change, light.zip(new, apart));
        see(&mut self.largest, reflected);
        *light = new;
    }

    /// Returns what came of the sweep, which is the last one where the change is below `2^-bits` of the largest.
    pub(super) fn outcome(self, bits: u8) -> Outcome<L> {
        let Self { change, largest } = self;
        let is_small = bits != Stop::STILL && change.size() < largest.size().shift(-i32::from(bits));
        Outcome { sweeps: 1, change, largest, is_done: is_small || change == L::ZERO }
    }
}

/// Returns by how much two radiances differ.
fn apart<L: Light>(one: L, other: L) -> L {
    let (more, less) = if one < other { (other, one) } else { (one, other) };
    let part = |light: L, sum: L::Sum, weight| light.added(sum, weight);
    let sum = part(less, part(more, L::EMPTY, L::Unit::ONE), -L::Unit::ONE);
    L::mean(sum, L::WHITE.added(L::EMPTY, L::Unit::ONE), L::Unit::ONE)
}

/// Makes `most` the largest register of it and a colour.
fn see<L: Light>(most: &mut L, light: Rgb<L>) {
    light.map(|light| {
        if light > *most {
            *most = light;
        }
    });
}
