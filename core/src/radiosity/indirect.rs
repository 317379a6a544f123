//! Solved light in the place of a scene's ambient light, for a tracer: the second of two passes.
//!
//! J. Wallace, M. Cohen and D. Greenberg, "A Two-pass Solution to the Rendering Equation", SIGGRAPH 87.

use super::vertex::Solution;
use crate::color::Rgb;
use crate::scalar::vector::UnitVector;
use crate::scalar::{Scalar, Unit};
use crate::scene::Object;
use crate::surface::Surface;

/// What arrives at the surfaces of a scene from others, over pi, so that a surface of the reflectance C sends back C times it.
#[derive(Clone, Copy, Debug)]
pub struct Indirect<'a, S: Scalar> {
    /// What arrives at the patches: irradiance over pi.
    pub arriving: Solution<'a, S>,
    /// What arrives at all other surfaces, and at the backs of patches: the mean over the area of the patches, say.
    pub elsewhere: Rgb<S::Light>,
}

impl<S: Scalar> Indirect<'_, S> {
    /// Returns what arrives at a surface, a point of `object`.
    pub fn at(&self, object: Object, surface: &Surface<S>) -> Rgb<S::Light> {
        let mesh = self.arriving.mesh();
        let found = mesh.locate(object, surface.point);
        let side = surface.face.unwrap_or(surface.normal);
        let is_front = |quad: usize| mesh.normal(quad).is_some_and(|normal| normal.dot(side) > S::Unit::ZERO);
        match found.filter(|&(quad, _)| is_front(quad)) {
            Some((quad, at)) => self.arriving.at(quad, at),
            None => self.elsewhere,
        }
    }
}
