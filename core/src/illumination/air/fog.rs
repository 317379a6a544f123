//! P. Bouguer (1729) and A. Beer (1852): a medium that leaves the same part of the light over each unit of length.

use super::Air;
use crate::color::Rgb;
use crate::illumination::{Passage, Way};
use crate::needs::Needs;
use crate::scalar::vector::Vec3;
use crate::scalar::{Light, Scalar, Unit};

/// Fog: `exp(-s d)` of the light is left over a length d, and the rest is replaced by the fog's own. It acts on every ray.
#[derive(Clone, Copy, Debug)]
pub struct Fog<S: Scalar> {
    /// `s log2 e` of each register: -log2 of what is left over a length of 1, 0 or more.
    pub density: Rgb<S::Power>,
    /// The radiance of deep fog: the part of the ambient light that it scatters, black where it only absorbs.
    pub glow: Rgb<S::Light>,
}

impl<S: Scalar> Air<S> for Fog<S> {
    fn passage<N: Needs>(
        &self,
        way: &Way<S>,
        _length: Option<S>,
        _lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Rgb<S::Unit>>> {
        let Passage { weight, .. } = way.absorbed(self.density)?;
        let veil = self.glow.zip(weight, |light, left| light.times(S::Unit::ONE - left));
        Some(Passage { weight, veil })
    }
}
