//! J. E. Warnock, University of Utah TR 4-15 (1969), and G. W. Romney, University of Utah TR 4-20 (1970): what is farther away is
//! darker.

use super::Air;
use crate::color::Rgb;
use crate::illumination::fade::fade;
use crate::illumination::{Passage, Way};
use crate::needs::Needs;
use crate::ray::RayKind;
use crate::scalar::vector::Vec3;
use crate::scalar::{Exponent, Scalar};

/// Light fades with the distance from the eye, `min(1, (d0 / d)^p)`; it acts on the rays from the eye alone.
#[derive(Clone, Copy, Debug)]
pub struct Distance<S> {
    /// p: 1 of Warnock, 2 or 4 of Romney, or any other of 0 or more.
    pub exponent: Exponent,
    /// d0, up to which nothing fades, above 0.
    pub reference: S,
}

impl<S: Scalar> Air<S> for Distance<S> {
    fn passage<N: Needs>(
        &self,
        way: &Way<S>,
        length: Option<S>,
        _lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Rgb<S::Unit>>> {
        let length = length?;
        let is_seen = way.kind == RayKind::Primary && length > self.reference;
        let part = is_seen.then(|| fade(length, self.reference, self.exponent))?;
        Some(Passage { weight: Rgb::new(part, part, part), veil: Rgb::BLACK })
    }
}
