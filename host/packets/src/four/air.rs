//! What air does to the light of four rays on their way, one after the other.

use core::fmt::Debug;

use rta_core::illumination::{Illumination, Passage, Way};
use rta_core::needs::Needs;
use rta_core::ray::RayKind;
use rta_core::trace::Pending;
use rta_core::trace::dice::Dice;

use super::geometry::Ray4;
use super::trace::{Traced, Trees4};

impl<'a, M: Illumination<f32>, T: Copy + Debug, const STACK: usize> Trees4<'a, M, T, STACK> {
    /// Returns what happens to the light of ray `k` on its way, whose length is `length` if it meets anything.
    pub(super) fn along<N: Needs, D: Dice<f32, Node = T>>(
        &mut self,
        tracer: &Traced<'a, M, N, STACK>,
        (pending, rays, k): (&Pending<f32, M::Weight>, &Ray4, usize),
        length: Option<f32>,
        (dice, node): (D, T),
    ) -> Option<Passage<f32, M::Weight>> {
        let (scene, model, ..) = tracer.parts();
        let surface = (self.surfaces.on >> k & 1 == 1).then(|| self.surfaces.surface(rays, k));
        let (kind, is_spread) = (pending.branch.kind, !D::STILL && N::SPREAD_AIR);
        let way = Way {
            kind,
            start: pending.start,
            length,
            surface: surface.as_ref(),
            shift: if is_spread && kind == RayKind::Primary { dice.step(node) } else { None },
            lamps: scene.scene.lamps,
        };
        model.along::<N>(&way, |place, lamp| {
            let memory = &mut self.cache;
            let spread = if is_spread && N::AREA_LAMPS {
                tracer.beam(place, lamp, (dice, node), memory)
            } else {
                None
            };
            spread.unwrap_or_else(|| tracer.reached(place, lamp, memory))
        })
    }
}
