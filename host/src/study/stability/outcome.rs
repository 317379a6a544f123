//! The outcome of one case in one format: counts and errors.

use super::guard::Failure;

/// The outcome of a case in a format.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// The format does not admit the scene: the reason.
    Refused(String),
    /// The scene was traced.
    Traced(Measured),
}

/// Counts and errors of one case in one format.
#[derive(Clone, Debug, Default)]
pub struct Measured {
    /// Rays from the eye.
    pub samples: usize,
    /// Rays of all kinds that the format traced for them.
    pub rays: u64,
    /// Panics that were no overflow.
    pub panics: u64,
    /// Numbers that left their format, where the build looks for them.
    pub overflows: u64,
    /// Lights with a register that is not finite.
    pub non_finite: u64,
    /// Points of a lone convex object that shadow themselves.
    pub acne: Acne,
    /// Rays from the eye that hit another object than in `f64`, or hit where they should miss, or miss where they should hit.
    pub wrong: u64,
    /// Median difference of a ray's worst register from `f64`, in levels of 255, over the rays that hit the same object.
    pub median: f64,
    /// Difference in levels of 255 that one ray in a hundred exceeds.
    pub p99: f64,
    /// Difference of the worst ray, in levels of 255.
    pub worst: f64,
    /// Message of the first panic or overflow.
    pub failure: Option<String>,
}

impl Measured {
    /// Returns whether there was no panic, overflow, non-finite light or acne.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        self.panics == 0 && self.overflows == 0 && self.non_finite == 0 && self.acne.points == 0
    }

    /// Counts a panic or an overflow.
    pub fn failed(&mut self, failure: Failure) {
        if failure.is_overflow {
            self.overflows += 1;
        } else {
            self.panics += 1;
        }
        self.failure.get_or_insert(failure.message);
    }

    pub(super) fn spread(&mut self, errors: &mut [f64]) {
        errors.sort_unstable_by(f64::total_cmp);
        let at = |index: usize| errors.get(index).copied().unwrap_or(0.0);
        let last = errors.len().saturating_sub(1);
        (self.median, self.p99, self.worst) = (at(last / 2), at(last - last / 100), at(last));
    }
}

/// Counts of the search for acne.
#[derive(Clone, Debug, Default)]
pub struct Acne {
    /// Points with acne.
    pub points: u64,
    /// Points that were looked at.
    pub of: u64,
    /// The first point with acne.
    pub first: Option<String>,
}
