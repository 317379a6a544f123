//! The settings that the study varies: number format, samples, depth and cut-off.

use core::fmt;
use core::ops::RangeInclusive;

use rta_core::sampling::{Places, Sampling};

use crate::engine::Cutoff;
use crate::engine::{Format, MAX_DEPTH};

/// Number formats under test; `f64` is the reference.
pub const FORMATS: [Format; 3] = [Format::F32, Format::Q16, Format::Q20];

/// Recursion depths.
pub const DEPTHS: RangeInclusive<u32> = 0..=8;

/// Cut-offs, the lowest first.
pub const CUTOFFS: [Cutoff; 5] =
    [Cutoff::OFF, Cutoff::one_in(1024), Cutoff::one_in(256), Cutoff::one_in(64), Cutoff::one_in(16)];

/// Recursion depth of the reference, which has no cut-off.
pub const REFERENCE_DEPTH: u32 = MAX_DEPTH;

/// Cells along a side of the sampling grids: 1, 4, 9 and 16 samples a pixel.
const SIDES: [u8; 4] = [1, 2, 3, 4];

/// Cells along a side of the reference's grid: 1024 samples a pixel.
const REFERENCE_SIDE: u8 = 32;

/// Seed of the jittered samples.
const SEED: u32 = 1990;

fn grid(side: u8) -> Sampling {
    Sampling::grid(side).unwrap_or(Sampling::CENTER)
}

/// Returns the samples of the reference: 1024 a pixel, on a regular grid.
#[must_use]
pub fn reference_sampling() -> Sampling {
    grid(REFERENCE_SIDE)
}

/// Returns the samplings under test: the regular grids, then the jittered ones.
#[must_use]
pub fn samplings() -> Vec<Sampling> {
    let jittered = SIDES.iter().filter(|side| **side > 1).map(|side| grid(*side).jittered(SEED));
    SIDES.iter().map(|side| grid(*side)).chain(jittered).collect()
}

/// A curve of the diagram: number format and sampling.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Method {
    /// Number format.
    pub format: Format,
    /// Samples of a pixel.
    pub sampling: Sampling,
}

impl Method {
    /// Returns the methods with these samples: every format with regular ones, `f32` alone with jittered ones.
    pub fn with(sampling: Sampling) -> impl Iterator<Item = Self> {
        let formats = if sampling.is_jittered() { FORMATS.get(..1) } else { FORMATS.get(..) };
        formats.unwrap_or_default().iter().map(move |format| Self { format: *format, sampling })
    }

    /// `regular` or `jittered`.
    #[must_use]
    pub const fn sampler(&self) -> &'static str {
        if self.sampling.is_jittered() { "jittered" } else { "regular" }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let samples = self.sampling.samples();
        let plural = if samples == 1 { "" } else { "s" };
        let jittered = if self.sampling.is_jittered() { ", jittered" } else { "" };
        write!(f, "{}, {samples} sample{plural}{jittered}", self.format)
    }
}

/// Depth and cut-off. One walk of the ray tree gives the pictures of all limits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limit {
    /// Recursion depth.
    pub depth: u32,
    /// Cut-off.
    pub cutoff: Cutoff,
}

impl Limit {
    /// The reference: as deep as it goes, and nothing cut off.
    pub const REFERENCE: Self = Self { depth: REFERENCE_DEPTH, cutoff: Cutoff::OFF };

    /// Returns all depths with all cut-offs, depth by depth.
    pub fn all() -> impl Iterator<Item = Self> {
        DEPTHS.flat_map(|depth| CUTOFFS.map(|cutoff| Self { depth, cutoff }))
    }
}

/// Number of limits in [`Limit::all`].
pub const LIMITS: usize = (*DEPTHS.end() as usize + 1) * CUTOFFS.len();

#[cfg(test)]
mod tests {
    use rta_core::sampling::Places;

    use super::{LIMITS, Limit, Method, samplings};

    #[test]
    fn every_combination_is_there_once() {
        assert_eq!(Limit::all().count(), LIMITS);
        let methods: Vec<_> = samplings().into_iter().flat_map(Method::with).collect();
        let names: std::collections::BTreeSet<_> = methods.iter().map(ToString::to_string).collect();
        assert_eq!((methods.len(), names.len()), (15, 15), "{names:?}");
        let samples: Vec<_> = samplings().iter().map(|sampling| sampling.samples()).collect();
        assert_eq!(samples, [1, 4, 9, 16, 4, 9, 16]);
    }
}
