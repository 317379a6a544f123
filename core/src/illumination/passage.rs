//! What happens to light on its way: fading, haze, absorption inside of a material.

use super::Weight;
use super::fade::transmittance;
use super::table::PositiveOf;
use crate::color::Rgb;
use crate::light::Lamp;
use crate::ray::{RayKind, Start};
use crate::scalar::{Scalar, Unit};
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
    /// Where in its steps light is taken that is gathered by steps along the way, 0 to 1; `None` for the middles.
    pub shift: Option<S::Unit>,
    /// The scene's lamps.
    pub lamps: &'a [Lamp<S>],
}

impl<S: Scalar> Way<'_, S> {
    /// Returns the number of the material inside of which the ray ran; `None` for a ray in the air.
    pub fn inside(&self) -> Option<u16> {
        self.surface.filter(|surface| surface.inside).map(|surface| surface.number)
    }

    /// Returns what is left of the light after a way of this length through a material of which the part `2^-density` is left after a
    /// length of 1; `None` where all is left.
    pub fn absorbed(&self, density: Rgb<PositiveOf<S>>) -> Option<Passage<S, Rgb<S::Unit>>> {
        let (none, length) = (S::Unit::ZERO.positive(), self.length?);
        let is_clear = [density.r, density.g, density.b].iter().all(|register| *register == none);
        let weight = density.map(|density| transmittance(density, length));
        (!is_clear).then_some(Passage { weight, veil: Rgb::BLACK })
    }
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
