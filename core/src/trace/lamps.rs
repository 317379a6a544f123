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
use crate::scalar::vector::LengthVector;
use crate::scalar::{Light, Scalar, Unit};
use crate::scene::Object;
use crate::surface::Surface;

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>>
    Tracer<'_, S, M, N, STACK, A>
{
    /// Returns the radiance that a surface, a point of `object`, sends back of lamp number `number`; `None` where the dice take it as a point.
    /// `is_first` says whether the point ends a ray from the eye.
    #[inline(never)]
    pub(super) fn spread_light<D: Dice<S>, O: Observer<S> + ?Sized>(
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
        let places = dice.places(number, node, is_first)?;
        Some(self.placed_light(surface, (number, lamp), (dice, &places), memory, observer))
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
        // A division, which most have no need of.
        let share = if count == 1 { S::Unit::ONE } else { S::Unit::fraction(1, count) };
        let mut light = Rgb::BLACK;
        for k in 0..count {
            let pair = places.get(k);
            let glimpse = match dice.square(number) {
                Some(square) if N::SQUARE_LAMPS => Glimpse::of_square(&point, square, from, pair),
                _ => Some(Glimpse::of_sphere(&point, own, from, pair)),
            };
            let Some(Glimpse { place, lamp }) = glimpse else { continue };
            let unhidden = glimpsed::<S, M, N>(&self.model, surface, &place, &lamp);
            let part = self.unshadowed(surface, &place, unhidden, number, memory, observer);
            observer.lamp(number, &lamp, unhidden, part);
            light = light.plus(unhidden.map(|light| light.times(part.times(share))));
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
