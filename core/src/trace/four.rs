//! Four pixels at once: their ray trees are walked beside each other, one ray of each at a time.
//!
//! Each pixel's light adds up in the order of its own tree, so that it is the same, to the last bit, as of one pixel after another.

use super::{Pending, Stack, Tracer};
use crate::color::Rgb;
use crate::illumination::{Illumination, RayKind, Surface, Weight};
use crate::light::{Incident, Lamp};
use crate::needs::Needs;
use crate::scalar::Scalar;
use crate::scene::{Known, Seen};
use crate::vector::{UnitVec3, Vec3};

/// Surfaces with the sizes of their objects.
type Surfaces<'a, S> = [Option<(Surface<'a, S>, S)>; 4];

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize> Tracer<'_, S, M, N, STACK> {
    /// The light that arrives at `origin` against the first `count` of four directions; the others are copies.
    #[inline(always)]
    pub(crate) fn follow_four(
        &self,
        origin: Vec3<S>,
        directions: [UnitVec3<S>; 4],
        count: u32,
        pending: &mut [Stack<S, M::Weight, STACK>; 4],
        known: &mut Known,
    ) -> [Rgb<S::Light>; 4] {
        let limits = self.scene.limits();
        let mut lights = [Rgb::BLACK; 4];
        let mut current = directions.map(|direction| {
            let (weight, kind) = (M::Weight::WHOLE, RayKind::Primary);
            Pending { origin, direction, weight, depth: 0, kind }
        });
        let (mut there, mut are_eyes) = ((1u32 << count) - 1, true);
        while there != 0 {
            let rays = current.each_ref().map(|ray| self.scene.ray::<N>(ray.origin, ray.direction));
            let hits = self.scene.find_four::<N>(&rays, there, are_eyes, limits.lid, known);
            are_eyes = false;
            let mut surfaces = [const { None }; 4];
            let (mut own, mut lit) = ([Rgb::BLACK; 4], 0);
            let lanes = own.iter_mut().zip(&mut surfaces).zip(&rays).zip(hits).zip(&current);
            for (k, ((((own, place), ray), hit), current)) in lanes.enumerate() {
                if there >> k & 1 == 0 {
                    continue;
                }
                self.model.note(current.kind);
                match self.scene.see::<N>(ray, hit, &limits) {
                    Seen::Light(light) => {
                        self.model.note_light(light);
                        *own = light;
                    }
                    Seen::Surface(surface, extent) => {
                        *own = self.model.ambient::<N>(&surface, self.scene.ambient);
                        lit |= u32::from(self.model.is_lit::<N>(&surface)) << k;
                        *place = Some((surface, extent));
                    }
                }
            }
            if N::LAMPS && lit != 0 {
                let lamps = if N::SEVERAL_LAMPS { self.scene.lamps.len() } else { 1 };
                for (number, lamp) in self.scene.lamps.iter().take(lamps).enumerate() {
                    self.direct_four((number, lamp), (&surfaces, lit), &mut own, known);
                }
            }
            let lanes = lights.iter_mut().zip(own).zip(&mut current).zip(pending.iter_mut()).zip(&surfaces);
            for (k, ((((light, own), current), pending), surface)) in lanes.enumerate() {
                if there >> k & 1 == 0 {
                    continue;
                }
                *light = light.plus(current.weight.filter(own));
                let next = match surface {
                    Some((surface, extent)) if N::MIRROR && current.depth < self.depth => {
                        self.spawn(surface, *extent, current, pending)
                    }
                    _ => None,
                };
                match next.or_else(|| if N::MIRROR { pending.pop() } else { None }) {
                    Some(next) => *current = next,
                    None => there &= !(1 << k),
                }
            }
        }
        lights
    }

    /// Adds what four surfaces send back of a lamp, of those in `lit`.
    #[inline(always)]
    fn direct_four(
        &self,
        (number, lamp): (usize, &Lamp<S>),
        (surfaces, lit): (&Surfaces<S>, u32),
        lights: &mut [Rgb<S::Light>; 4],
        known: &mut Known,
    ) {
        let mut direct = [Rgb::BLACK; 4];
        let mut shadows = [const { None }; 4];
        let mut there = 0;
        let lanes = direct.iter_mut().zip(&mut shadows).zip(surfaces);
        for (k, ((direct, shadow), surface)) in lanes.enumerate() {
            if lit >> k & 1 == 1
                && let Some((surface, extent)) = surface
                && let Some(incident) = Incident::new(lamp, surface.point, surface.normal)
            {
                *direct = self.direct(surface, &incident, *extent, |light, ray, t_max| {
                    *shadow = Some((*ray, t_max));
                    there |= 1 << k;
                    light
                });
            }
        }
        if there != 0 {
            let lid = self.scene.limits().lid;
            let parts = self.scene.transmittance_four::<N>(&shadows, there, lid, number, known);
            for (k, (direct, part)) in direct.iter_mut().zip(parts).enumerate() {
                if there >> k & 1 == 1 {
                    *direct = self.dimmed(*direct, part);
                }
            }
        }
        for (light, direct) in lights.iter_mut().zip(direct) {
            *light = light.plus(direct);
        }
    }
}
