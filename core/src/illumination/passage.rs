//! What happens to light on its way: fading, haze, absorption inside of a material.

use super::Weight;
use crate::color::Rgb;
use crate::ray::{RayKind, Start};
use crate::scalar::Scalar;
use crate::surface::Surface;

/// The way of a ray from its origin to what it meets.
#[derive(Clone, Copy, Debug)]
pub struct Way<'a, S: Scalar> {
    /// What the ray is traced for.
    pub kind: RayKind,
    /// Where it starts and where it goes.
    pub start: Start<S>,
    /// The length up to what it meets, a surface or a lamp; `None` where it meets nothing.
    pub length: Option<S>,
    /// The surface that it meets; if it is met from the [inside](Surface::inside), the ray ran inside of its material.
    pub surface: Option<&'a Surface<'a, S>>,
}

/// What a way does to the light of a ray. It acts on all that the ray brings: the light of what it meets and that of its
/// secondary rays.
#[derive(Clone, Copy, Debug)]
pub struct Passage<S: Scalar, W> {
    /// The part of the light that arrives, 0 to 1.
    pub weight: W,
    /// The radiance that is added on the way.
    pub veil: Rgb<S::Light>,
}

impl<S: Scalar, W: Weight<S>> Passage<S, W> {
    /// Returns the passage with a weight of three registers.
    pub fn registers(self) -> Passage<S, Rgb<S::Unit>> {
        Passage { weight: self.weight.registers(), veil: self.veil }
    }
}
