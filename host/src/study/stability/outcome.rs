//! What the rays of one case in one format came to: counts and errors.

use super::guard::Failure;

/// What a case did in a format.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// The format does not admit the scene: the reason.
    Refused(String),
    /// It was traced.
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
    /// Points of a convex object on its own that see themselves.
    pub acne: Acne,
    /// Eye rays that meet something else than in `f64`, or something instead of nothing.
    pub wrong: u64,
    /// How far the worst register is from `f64`, in levels of 255: the median of the rays that meet the same.
    pub median: f64,
    /// The same for the worst hundredth.
    pub p99: f64,
    /// The same for the worst ray.
    pub worst: f64,
    /// What the first panic or overflow said.
    pub failure: Option<String>,
}

impl Measured {
    /// Whether nothing happened that must not.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        self.panics == 0 && self.overflows == 0 && self.non_finite == 0 && self.acne.points == 0
    }

    /// Takes note of a panic.
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

/// What the search found.
#[derive(Clone, Debug, Default)]
pub struct Acne {
    /// Points with acne.
    pub points: u64,
    /// Points that were looked at.
    pub of: u64,
    /// The first point with acne.
    pub first: Option<String>,
}
