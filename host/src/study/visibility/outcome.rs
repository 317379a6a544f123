//! What an algorithm leaves: ids, counts, memory.

use core::fmt;

/// What came of an algorithm.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The id of each pixel, row by row from the upper left: 0, or one more than the number of the triangle.
    pub ids: Vec<u32>,
    /// What it did.
    pub counts: Counts,
    /// Bytes that it needs beside the triangles and the picture, at their most; of buffers, which are the picture, those of the buffer.
    pub bytes: u64,
    /// The visible part of each triangle, in parts of the picture, of an algorithm that has no pixels.
    pub areas: Option<Vec<f64>>,
}

/// Why an algorithm was not run to its end.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("left out: more than {limit} {what}")]
pub struct LeftOut {
    /// What there is too much of.
    pub what: &'static str,
    /// How much there may be.
    pub limit: u64,
}

impl LeftOut {
    /// Checks a number against its limit.
    ///
    /// # Errors
    /// [`LeftOut`] if it is larger.
    pub const fn check(what: &'static str, number: u64, limit: u64) -> Result<(), Self> {
        if number > limit { Err(Self { what, limit }) } else { Ok(()) }
    }
}

/// A count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Count {
    name: &'static str,
    number: u64,
    is_step: bool,
}

/// Counts by name, in the order in which they were added.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Counts(Vec<Count>);

impl Counts {
    /// Returns no counts.
    #[must_use]
    pub const fn new() -> Self {
        Self(Vec::new())
    }

    /// Adds a count of work: one look at one thing, which is a test of a pixel, ray, window, edge or fragment against a triangle, its plane
    /// or its box, a comparison of two depths or two places, or a write.
    #[must_use]
    pub fn step(self, name: &'static str, number: u64) -> Self {
        self.with(Count { name, number, is_step: true })
    }

    /// Adds a count of something that is no work of its own.
    #[must_use]
    pub fn note(self, name: &'static str, number: u64) -> Self {
        self.with(Count { name, number, is_step: false })
    }

    fn with(mut self, count: Count) -> Self {
        self.0.push(count);
        self
    }

    /// Returns the number that was counted by this name, if there is one.
    #[must_use]
    pub fn of(&self, name: &str) -> Option<u64> {
        self.0.iter().find(|count| count.name == name).map(|count| count.number)
    }

    /// Returns all steps together.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.0.iter().filter(|count| count.is_step).map(|count| count.number).sum()
    }
}

impl fmt::Display for Counts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, Count { name, number, .. }) in self.0.iter().enumerate() {
            let comma = if place == 0 { "" } else { ", " };
            write!(f, "{comma}{name} {number}")?;
        }
        Ok(())
    }
}

/// Returns the comparisons that sorting so many things takes: n log2 n, rounded up.
pub(super) fn sorting(things: usize) -> u64 {
    let things = things as u64;
    things * u64::from(things.max(1).next_power_of_two().ilog2())
}
