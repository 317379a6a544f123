//! Solved light in the place of a scene's ambient light, for a tracer: the second of two passes.
//!
//! J. Wallace, M. Cohen and D. Greenberg, "A Two-pass Solution to the Rendering Equation", SIGGRAPH 87.

use super::cast::Casts;
use super::gather::Solver;
use super::sweep::Gathered;
use super::vertex::Solution;
use super::{Error, room};
use crate::accelerator::Accelerator;
use crate::color::Rgb;
use crate::needs::Needs;
use crate::scalar::vector::UnitVector;
use crate::scalar::{Light, Scalar, Unit};
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

impl<S: Scalar, N: Needs, C: Casts<S>, A: Accelerator<S>> Solver<'_, S, N, C, A> {
    /// Makes `arriving` what arrives at each patch from the others, over pi, as [`Indirect::arriving`] wants it, and returns its mean over the
    /// area. `reflected` is X of each patch, as [`Solver::solve`] leaves it. All rays are traced once more.
    ///
    /// # Errors
    /// [`Error::Room`] where a slice is shorter than the mesh.
    pub fn over_pi(
        &self,
        reflected: &[Rgb<S::Light>],
        arriving: &mut [Rgb<S::Light>],
    ) -> Result<Rgb<S::Light>, Error> {
        let mesh = self.mesh();
        let (needed, found) = (mesh.len(), reflected.len());
        if found < needed {
            return Err(Error::Room { needed, found });
        }
        let arriving = room(arriving, needed)?;
        // 2/pi, which is taken within 2^-32, and a half.
        let part = S::Unit::of_word(0xa2f9_836e).times(S::Unit::ratio(1, 2));
        let (largest, mut sum, mut memory) = (mesh.largest_area(), Gathered::NOTHING, A::Memory::default());
        for (patch, arriving) in mesh.patches().zip(arriving) {
            *arriving = self.indirect(patch, reflected, &mut memory).map(|light| light.times(part));
            let share = mesh.share(patch, largest);
            sum.weigh(share);
            sum.add(*arriving, share);
        }
        let one = S::Unit::ONE;
        Ok(sum.mean(Rgb::new(one, one, one)))
    }
}
