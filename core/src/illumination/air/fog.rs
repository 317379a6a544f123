//! P. Bouguer (1729) and A. Beer (1852): a medium that leaves the same part of the light over each unit of length.

use super::Air;
use crate::color::Rgb;
use crate::illumination::{Passage, Way};
use crate::needs::Needs;
use crate::scalar::Scalar;
use crate::scalar::vector::Vec3;

/// Fog that absorbs light and scatters none: `exp(-s d)` of it is left over a length d. It acts on every ray.
#[derive(Clone, Copy, Debug)]
pub struct Fog<S: Scalar> {
    /// `s log2 e` of each register: -log2 of what is left over a length of 1, 0 or more.
    pub density: Rgb<S::Power>,
}

impl<S: Scalar> Air<S> for Fog<S> {
    fn passage<N: Needs>(
        &self,
        way: &Way<S>,
        _length: S,
        _lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Rgb<S::Unit>>> {
        way.absorbed(self.density)
    }
}
