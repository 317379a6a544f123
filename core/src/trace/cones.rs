//! The light of a lamp that is a sphere, by a cone to it instead of shadow rays: soft shadows without noise.

use core::marker::PhantomData;
use core::ops::ControlFlow;

use super::decision::{casts_shadow_ray, glimpsed};
use super::lamps::shadow_start;
use super::{Observer, Tracer};
use crate::accelerator::{Accelerator, transmitted};
use crate::color::Rgb;
use crate::illumination::Illumination;
use crate::light::cone::{Hidden, LampCone};
use crate::light::{Incident, Lamp};
use crate::needs::Needs;
use crate::scalar::vector::{UnitVec3, UnitVector, Vec3};
use crate::scalar::{Light, Scalar, Unit};
use crate::scene::{Object, Visit, index};
use crate::shape::{Look, Primitive};
use crate::surface::Surface;
use crate::world::World;

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>>
    Tracer<'_, S, M, N, STACK, A>
{
    /// Returns the radiance that a surface, a point of `object`, sends back of lamp number `number`, which is a sphere of a radius above 0: that
    /// of a point in the lamp's middle, times the part of the lamp that is not hidden. A point within the lamp is lit as one on it. `bodies` is
    /// [`Spread::bodies`](super::dice::Spread::bodies).
    pub fn cone_light<O: Observer<S> + ?Sized>(
        &self,
        (surface, object): (&Surface<S>, Option<Object>),
        (number, lamp): (usize, &Lamp<S>),
        bodies: &[u32],
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let point = Lamp { radius: S::ZERO, ..*lamp };
        let outside = Incident::new(&point, surface.point, surface.normal)
            .filter(|incident| incident.distance > lamp.radius);
        let incident = outside.unwrap_or(Incident {
            direction: surface.normal,
            distance: lamp.radius,
            inverse_distance: lamp.inverse_radius,
            cosine: S::Unit::ONE,
            lamp: &point,
        });
        let unhidden = glimpsed::<S, M, N>(&self.model, surface, &incident, &incident);
        let mut part = S::Unit::ONE;
        if outside.is_some() && casts_shadow_ray::<N, _>(unhidden) {
            let (start, _) = shadow_start::<S, N>(surface, &incident);
            observer.shadow(number, &start);
            let cone = LampCone::new(start.origin, &incident, lamp.radius);
            // What is convex hides nothing of a lamp above its surface from a point of it, but for what has set already.
            let is_above = !surface.inside && !surface.is_behind::<N>(&incident);
            let own = object.filter(|_| is_above);
            part = cone.map_or(part, |cone| unhidden_part::<S, N>(self.scene, &cone, own, bodies));
        }
        observer.lamp(number, &incident, unhidden, part);
        unhidden.map(|light| light.times(part))
    }

    /// Returns the part of a lamp that the things in the cone from a place in the air to it leave.
    pub(super) fn cone_beam(&self, place: Vec3<S>, lamp: &Lamp<S>, bodies: &[u32]) -> S::Unit {
        let point = Lamp { radius: S::ZERO, ..*lamp };
        let incident = Incident::new(&point, place, UnitVec3::<S>::Z);
        let cone = incident.and_then(|incident| LampCone::new(place, &incident, lamp.radius));
        cone.map_or(S::Unit::ONE, |cone| unhidden_part::<S, N>(self.scene, &cone, None, bodies))
    }
}

/// Returns the part of a lamp that the things of a scene leave, but for `own`: the product of what each body leaves. The scene's lists are gone
/// through in their order, so that faces of one body follow one another.
fn unhidden_part<S: Scalar, N: Needs>(
    world: &World<'_, S>,
    cone: &LampCone<S>,
    own: Option<Object>,
    bodies: &[u32],
) -> S::Unit {
    let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
    let floor = world.scene.floor.filter(|_| N::FLOOR && own != Some(Object::Floor));
    let part = floor.map_or(one, |floor| one - floor.hidden(cone));
    if part <= zero {
        return zero;
    }
    let (body, needs) = (None, PhantomData::<fn() -> N>);
    let mut shade = Shade { world, cone, own, bodies, part, body, hidden: [zero; 2], dims: one, needs };
    if world.scene.each::<N>(&mut shade).is_break() {
        return zero;
    }
    shade.end_body();
    shade.part
}

/// The visitor that multiplies what the bodies of a scene leave of a lamp, and stops where nothing is left.
struct Shade<'c, S: Scalar, N> {
    world: &'c World<'c, S>,
    cone: &'c LampCone<S>,
    own: Option<Object>,
    bodies: &'c [u32],
    /// What the bodies before the current one leave.
    part: S::Unit,
    /// The number of the current body, and what its faces hide that are seen from the front, and from behind.
    body: Option<u32>,
    hidden: [S::Unit; 2],
    /// The part of the light that the current body takes where it hides the lamp.
    dims: S::Unit,
    needs: PhantomData<fn() -> N>,
}

impl<S: Scalar, N: Needs> Shade<'_, S, N> {
    fn end_body(&mut self) {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        let [front, back] = self.hidden;
        let hidden = if front < back { back } else { front };
        self.part = self.part.times(one - hidden.times(self.dims));
        (self.hidden, self.body) = ([zero; 2], None);
    }

    /// Returns the number of the body that an object is a face of.
    fn body_of(&self, object: Object) -> Option<u32> {
        let Object::Triangle(number) = object else { return None };
        self.bodies.get(index(number)).copied()
    }
}

impl<S: Scalar, N: Needs> Visit<S> for Shade<'_, S, N> {
    fn run<P: Primitive<S>>(&mut self, first: Object, run: &[P]) -> ControlFlow<()> {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        for (i, primitive) in (0..).zip(run) {
            let Look { center, radius, material, .. } = primitive.look();
            let object = first.after(i);
            if Some(object) == self.own || (P::IS_FINITE && !self.cone.is_near(center, radius)) {
                continue;
            }
            let Hidden { part, from_behind } = primitive.hidden(self.cone);
            if part <= zero {
                continue;
            }
            let body = self.body_of(object);
            if body.is_none() || body != self.body {
                self.end_body();
            }
            self.body = body;
            self.dims = transmitted::<S, N>(self.world, material).map_or(one, |kt| one - kt);
            let [front, back] = &mut self.hidden;
            let side = if from_behind { back } else { front };
            let sum = *side + part;
            *side = if sum > one { one } else { sum };
            if body.is_none() {
                self.end_body();
            }
            if self.part <= zero {
                return ControlFlow::Break(());
            }
        }
        ControlFlow::Continue(())
    }
}

#[cfg(test)]
#[cfg(feature = "f64")]
mod tests;
