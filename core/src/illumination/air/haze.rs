//! Haze that begins at one distance and hides all from another on (the thesis, section 3.5.2).

use super::Air;
use crate::color::Rgb;
use crate::illumination::fade::haze;
use crate::illumination::{Passage, Way};
use crate::needs::Needs;
use crate::scalar::vector::Vec3;
use crate::scalar::{Light, Scalar, Unit};

/// Haze: up to the length `near` of a ray nothing is hidden, from `far` on all is, and between them the part that is hidden grows
/// evenly. It acts on every ray.
#[derive(Clone, Copy, Debug)]
pub struct Haze<S: Scalar> {
    /// The length from which on haze is seen, 0 or more.
    pub near: S,
    /// The length from which on nothing else is seen, above `near`.
    pub far: S,
    /// Its radiance, usually that of the horizon.
    pub color: Rgb<S::Light>,
}

impl<S: Scalar> Air<S> for Haze<S> {
    fn passage<N: Needs>(
        &self,
        _way: &Way<S>,
        length: Option<S>,
        _lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Rgb<S::Unit>>> {
        let hidden = haze(length?, self.near, self.far);
        let left = S::Unit::ONE - hidden;
        (hidden > S::Unit::ZERO).then(|| Passage {
            weight: Rgb::new(left, left, left),
            veil: self.color.map(|light| light.times(hidden)),
        })
    }
}
