//! Air: what becomes of light between the things of a scene, under any illumination model.
//!
//! A layer of air stands around a model, [`Through`]: `Through { model: Whitted::default(), air: Haze { .. } }` is itself a model. It acts
//! on each ray as a whole, on all light that the ray brings. A program that uses none contains none.

mod distance;
mod fog;
mod haze;
mod medium;

pub use distance::Distance;
pub use fog::Fog;
pub use haze::Haze;
pub use medium::Medium;

use super::{Illumination, Passage, Secondary, Way, Weight};
use crate::color::Rgb;
use crate::light::Incident;
use crate::needs::Needs;
use crate::scalar::vector::Vec3;
use crate::scalar::{Light, Scalar};
use crate::surface::Surface;

/// What fills the space between the things of a scene.
pub trait Air<S: Scalar>: Send + Sync {
    /// Returns what becomes of the light of a ray that is `length` long, `None` where it meets nothing; `None` for nothing. `lit` returns the part of the light of a
    /// lamp, by its number, that reaches a place, 0 to 1; it traces a shadow ray.
    fn passage<N: Needs>(
        &self,
        way: &Way<S>,
        length: Option<S>,
        lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Rgb<S::Unit>>>;
}

/// Air that may not be there.
impl<S: Scalar, A: Air<S>> Air<S> for Option<A> {
    fn passage<N: Needs>(
        &self,
        way: &Way<S>,
        length: Option<S>,
        lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Rgb<S::Unit>>> {
        self.as_ref()?.passage::<N>(way, length, lit)
    }
}

/// Air of two kinds at once.
impl<S: Scalar, A: Air<S>, B: Air<S>> Air<S> for (A, B) {
    fn passage<N: Needs>(
        &self,
        way: &Way<S>,
        length: Option<S>,
        mut lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Rgb<S::Unit>>> {
        let first = self.0.passage::<N>(way, length, &mut lit);
        match (first, self.1.passage::<N>(way, length, lit)) {
            (Some(first), Some(second)) => Some(first.then(second)),
            (first, second) => first.or(second),
        }
    }
}

/// An illumination model whose light passes through air. A ray that meets nothing shows the sky as it is, but
/// for a [`Medium`] with a reach.
///
/// Weights have three registers, as air may have a colour.
#[derive(Clone, Copy, Debug)]
pub struct Through<M, A> {
    /// The model.
    pub model: M,
    /// The air.
    pub air: A,
}

impl<S: Scalar, M: Illumination<S>, A: Air<S>> Illumination<S> for Through<M, A> {
    type Weight = Rgb<S::Unit>;
    const BOTH_SIDES: bool = M::BOTH_SIDES;
    const REFRACTS_LAMPS: bool = M::REFRACTS_LAMPS;
    const SPECULAR: bool = M::SPECULAR;
    const ATTENUATION: bool = M::ATTENUATION;
    const ALONG: bool = true;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        self.model.ambient::<N>(surface, ambient)
    }

    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool {
        self.model.is_lit::<N>(surface)
    }

    fn is_reached<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> bool {
        self.model.is_reached::<N>(surface, incident)
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        self.model.direct::<N>(surface, incident)
    }

    fn diffuse<N: Needs>(&self, surface: &Surface<S>) -> Rgb<S::Unit> {
        self.model.diffuse::<N>(surface)
    }

    fn fades(&self) -> bool {
        self.model.fades()
    }

    fn cutoff(&self) -> S::Unit {
        self.model.cutoff()
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<Self::Weight> {
        self.model.secondary::<N>(surface).registers()
    }

    fn along<N: Needs>(
        &self,
        way: &Way<S>,
        mut lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Self::Weight>> {
        let inner = if M::ALONG { self.model.along::<N>(way, &mut lit) } else { None };
        let inner = inner.map(Passage::registers);
        let outer = self.air.passage::<N>(way, way.length, lit);
        match (inner, outer) {
            (Some(inner), Some(outer)) => Some(inner.then(outer)),
            (inner, outer) => inner.or(outer),
        }
    }
}

impl<S: Scalar> Passage<S, Rgb<S::Unit>> {
    /// Returns what two passages do, one after the other.
    #[must_use]
    pub fn then(self, next: Self) -> Self {
        let weight = Weight::<S>::compose(self.weight, next.weight);
        Self { weight, veil: Weight::<S>::filter(next.weight, self.veil).zip(next.veil, Light::plus) }
    }
}
