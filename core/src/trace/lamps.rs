//! The light of a lamp that has a size: shadow rays to places on it.

use super::decision::{Start, glimpsed};
use super::dice::{Dice, LampPlaces};
use super::{Observer, Tracer};
use crate::accelerator::Accelerator;
use crate::color::Rgb;
use crate::illumination::Illumination;
use crate::light::area::Glimpse;
use crate::light::{Incident, Lamp};
use crate::needs::Needs;
use crate::sampling::pairs::Purpose;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3};
use crate::scalar::{Light, Scalar, Unit};
use crate::scene::Object;
use crate::surface::Surface;

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>>
    Tracer<'_, S, M, N, STACK, A>
{
    /// Returns the radiance that a surface, a point of `object`, sends back of lamp number `number`, which has a size; `None` where the dice take it
    /// as a point. `is_first` says whether the point ends a ray from the eye.
    #[inline(never)]
    pub fn spread_light<D: Dice<S>, O: Observer<S> + ?Sized>(
        &self,
        (surface, object): (&Surface<S>, Option<Object>),
        (number, lamp): (usize, &Lamp<S>),
        (dice, node, is_first): (D, D::Node, bool),
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Option<Rgb<S::Light>> {
        if N::CONE_LAMPS
            && let Some(bodies) = dice.bodies()
        {
            return Some(self.cone_light((surface, object), (number, lamp), bodies, observer));
        }
        let places = dice.places(number, (Purpose::Lamp, node), is_first)?;
        Some(self.placed_light(surface, (number, lamp), (dice, &places), memory, observer))
    }

    /// Returns the part of the light of lamp number `number` that reaches a place in the air on the way of the ray at a node, 0 to 1, for a
    /// lamp with a size: the mean over places on it, one where they differ from sample to sample, or what things in the cone to it leave. A
    /// parallelogram lights the air before it, by the cosine there. `None` where the dice take the lamp as a point.
    #[inline(never)] // points do not pay for it
    pub fn beam<D: Dice<S>>(
        &self,
        place: Vec3<S>,
        number: usize,
        (dice, node): (D, D::Node),
        memory: &mut A::Memory,
    ) -> Option<S::Unit> {
        let scene = &self.scene.scene;
        let lamp = scene.lamps.get(number).filter(|_| N::SHADOWS)?;
        if !has_size::<S, D, N>(dice, number, lamp) {
            return None;
        }
        if N::CONE_LAMPS
            && let Some(bodies) = dice.bodies()
        {
            return Some(self.cone_beam(place, lamp, bodies));
        }
        let places = dice.places(number, (Purpose::Beam, node), false)?;
        let point = Lamp { radius: S::ZERO, ..*lamp };
        let (own, from) = ((lamp.radius, lamp.inverse_radius), (place, UnitVec3::<S>::Z));
        let share = S::Unit::fraction(1, places.count());
        let mut part = S::Unit::ZERO;
        for k in 0..places.count() {
            let pair = places.get(k);
            let (glimpse, sent) = match dice.square(number) {
                Some(square) if N::SQUARE_LAMPS => {
                    let Some(glimpse) = Glimpse::on_square(&point, square, from, pair) else { continue };
                    let sent = -square.normal.dot(glimpse.place.direction);
                    (glimpse, sent)
                }
                _ => (Glimpse::of_sphere(&point, own, from, pair), S::Unit::ONE),
            };
            let Incident { direction, distance, .. } = glimpse.place;
            let ray = self.ray(Start { origin: place, direction });
            let search = self.scene.accelerator();
            let passed = search.transmittance::<N>(self.scene, &ray, distance, number, memory);
            part = part + passed.times(sent).times(share);
        }
        Some(part)
    }

    /// Returns the radiance that a surface sends back of lamp number `number`: the mean over `places` on it.
    fn placed_light<D: Dice<S>, O: Observer<S> + ?Sized>(
        &self,
        surface: &Surface<S>,
        (number, lamp): (usize, &Lamp<S>),
        (dice, places): (D, &LampPlaces),
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let point = Lamp { radius: S::ZERO, ..*lamp };
        let own = (lamp.radius, lamp.inverse_radius);
        let from = (surface.point, surface.normal);
        let count = places.count();
        // A division and a product, which most have no need of.
        let share = (count > 1).then(|| S::Unit::fraction(1, count));
        let mut light = Rgb::BLACK;
        for k in 0..count {
            let pair = places.get(k);
            let glimpse = match dice.square(number) {
                Some(square) if N::SQUARE_LAMPS && N::GLINT => Glimpse::of_square(&point, square, from, pair),
                Some(square) if N::SQUARE_LAMPS => Glimpse::on_square(&point, square, from, pair),
                _ => Some(Glimpse::of_sphere(&point, own, from, pair)),
            };
            let Some(Glimpse { place, lamp }) = glimpse else { continue };
            let unhidden = glimpsed::<S, M, N>(&self.model, surface, &place, &lamp);
            let part = self.unshadowed(surface, &place, unhidden, number, memory, observer);
            observer.lamp(number, &lamp, unhidden, part);
            let part = share.map_or(part, |share| part.times(share));
            // Most things hide all of the place or nothing, which takes no products.
            if part == S::Unit::ONE {
                light = light.plus(unhidden);
            } else if part > S::Unit::ZERO {
                light = light.plus(unhidden.map(|light| light.times(part)));
            }
        }
        light
    }
}

/// Returns where a shadow ray to a lamp starts, and by how much it is shorter than the way to the lamp.
#[inline]
pub(super) fn shadow_start<S: Scalar, N: Needs>(
    surface: &Surface<S>,
    incident: &Incident<S>,
) -> (Start<S>, S) {
    let side = surface.side::<N>();
    let side = if surface.is_behind::<N>(incident) { -side } else { side };
    let (origin, used) = surface.point.leave(side, incident.direction, surface.extent);
    (Start { origin, direction: incident.direction }, used)
}

/// Returns whether a lamp is larger than a point for some dice: a sphere with a radius, or a parallelogram.
pub(super) fn has_size<S: Scalar, D: Dice<S>, N: Needs>(dice: D, number: usize, lamp: &Lamp<S>) -> bool {
    lamp.radius > S::ZERO || N::SQUARE_LAMPS && dice.square(number).is_some()
}

#[cfg(test)]
#[cfg(feature = "f64")]
mod tests;
