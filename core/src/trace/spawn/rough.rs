//! The secondary rays of a rough surface: one of its facets, by chance, reflects and refracts.

use super::super::decision::{refract, secondary};
use super::super::dice::Dice;
use super::{Child, Parent, Sum};
use crate::accelerator::Accelerator;
use crate::illumination::microfacet::{Sight, Visible};
use crate::illumination::{Bend, Illumination, Weight};
use crate::needs::Needs;
use crate::scalar::vector::{UnitVec3, UnitVector};
use crate::scalar::{Scalar, Unit};
use crate::surface::Surface;
use crate::trace::{Observer, Tracer};

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>>
    Tracer<'_, S, M, N, STACK, A>
{
    /// Spawns the secondary rays of a rough surface, as `spawn` does those of a smooth one: about the normal of one of its facets
    /// instead of its own. Their weights are those of the model, times the part that neighbouring facets do not hide; a ray that would
    /// leave on the wrong side of the surface is lost.
    #[inline(never)] // smooth surfaces do not pay for it
    pub(super) fn spawn_rough<D: Dice<S>, O: Observer<S> + ?Sized>(
        &self,
        surface: &Surface<S>,
        (facets, words): (Visible<'_, S::Unit>, [u32; 2]),
        parent: Parent<S, M::Weight, D>,
        sum: Sum<S, M::Weight, D::Node, STACK>,
        observer: &mut O,
    ) -> Child<S, M::Weight, D::Node> {
        let view = -surface.incoming;
        let normal = facets.seen::<S>(surface.normal, view, words);
        let facet = Surface { normal, ..*surface };
        let slope = surface.normal.dot(normal);
        let sight = Sight { slope, view: surface.normal.dot(view), incidence: normal.dot(view) };
        // The part of the light that passes in a direction, above the surface or below it; `None` on the other side.
        let passed = |direction: UnitVec3<S>, is_above: bool| {
            let cosine = surface.normal.dot(direction);
            let cosine = if is_above { cosine } else { -cosine };
            (cosine > S::Unit::ZERO).then(|| facets.passed(&sight, cosine))
        };
        let dimmed = |weight: Option<M::Weight>, part: Option<S::Unit>| {
            weight.zip(part).map(|(weight, part)| weight.dimmed(part))
        };
        let mut rays = secondary::<S, M, N>(&self.model, surface);
        let mirrored = surface.incoming.reflect(normal);
        let above = passed(mirrored, true);
        let is_bent = N::GLASS && rays.transmitted.is_some() && rays.bend == Bend::Refracted;
        let glass = if is_bent { surface.material.glass::<N>() } else { None };
        let through = glass.map(|glass| refract(&facet, glass));
        if let Some(through) = through {
            let part = through.map_or(above, |direction| passed(direction, false));
            rays.transmitted = dimmed(rays.transmitted, part);
        }
        rays.reflected = dimmed(rays.reflected, above);
        self.spawn_about::<D, O>((surface, &facet), rays, parent, sum, observer)
    }
}
