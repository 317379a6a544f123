//! What spreads in four ray trees: the light of lamps that have a size, and the secondary rays of rough surfaces.
//!
//! It is apart from what all trees run through, so that those in which nothing spreads do not pay for it.

use core::fmt::Debug;

use rta_core::color::Rgb;
use rta_core::illumination::Illumination;
use rta_core::light::Lamp;
use rta_core::needs::Needs;
use rta_core::trace::dice::Dice;

use super::area::Large4;
use super::dice::Dice4;
use super::geometry::Ray4;
use super::trace::{Met4, Rays4, Traced, Trees4};
use super::vector::{one, one_mut};
use crate::leaf::Bits;

impl<'a, M: Illumination<f32>, T: Copy + Debug, const STACK: usize> Trees4<'a, M, T, STACK> {
    /// Adds what four surfaces send back of a lamp with a size, of those in `lit`; false, and nothing is added, where the dice take it as a point.
    /// All are points that the eye sees if `are_first`, or none is.
    #[inline(never)]
    pub(super) fn add_large_lamp<N: Needs, D: Dice4<Node = T>>(
        &mut self,
        tracer: &Traced<'a, M, N, STACK>,
        (number, lamp): (usize, &Lamp<f32>),
        met: &Met4<D, M::Weight, T>,
        (lit, are_first): (u32, bool),
        lights: &mut [Rgb<f32>; 4],
    ) -> bool {
        let square = if N::SQUARE_LAMPS { met.dice.one(0).square(number) } else { None };
        if !N::AREA_LAMPS || !(lamp.radius > 0.0 || square.is_some()) {
            return false;
        }
        let meshes = if N::MESHES { lit & self.surfaces.meshed } else { 0 };
        let nodes = met.current.map(|(_, node)| node);
        let Some(places) = met.dice.places(number, nodes, are_first) else {
            return self.add_alone::<N, D>(tracer, (number, lamp), met, lit, lights);
        };
        if meshes != 0 {
            self.add_alone::<N, D>(tracer, (number, lamp), met, meshes, lights);
        }
        let lit = lit & !meshes;
        let point = Lamp { radius: 0.0, ..*lamp };
        let (points, normals) = (self.surfaces.spot.point, self.surfaces.spot.normal);
        let from = (points, normals);
        let (large, mut seen) = Large4::new(&point, (lamp.radius, lamp.inverse_radius), square, points);
        let count = places.count();
        #[allow(clippy::cast_precision_loss)] // below 2^16
        let share = 1.0 / count as f32;
        let mut sums = [Rgb::BLACK; 4];
        for k in 0..count {
            let reached = large.look(from, places.get(k), lit, &mut seen);
            let seen = (&seen.place, &seen.lamp);
            self.add_incident::<N>(tracer, (number, &point), seen, met.rays, (reached, share), &mut sums);
        }
        for k in Bits(lit) {
            let light = one_mut(lights, k);
            *light = light.plus(one(&sums, k));
        }
        true
    }

    /// Adds what surfaces send back of a lamp with a size, of those in `which`, one after the other: meshes, or all where lamps are asked by cones.
    /// False where the dice take the lamp as a point.
    fn add_alone<N: Needs, D: Dice4<Node = T>>(
        &mut self,
        tracer: &Traced<'a, M, N, STACK>,
        asked: (usize, &Lamp<f32>),
        met: &Met4<D, M::Weight, T>,
        which: u32,
        lights: &mut [Rgb<f32>; 4],
    ) -> bool {
        for k in Bits(which) {
            let surface = self.surfaces.whole(met.rays, k);
            let (ray, node) = one(met.current, k);
            let from = (&surface, one(&met.nearest.objects, k));
            let thrown = (met.dice.one(k), node, ray.branch.depth == 0);
            let Some(own) = tracer.spread_light(from, asked, thrown, &mut self.cache, &mut ()) else {
                return false;
            };
            let light = one_mut(lights, k);
            *light = light.plus(own);
        }
        true
    }

    /// Returns which of some surfaces are rough.
    #[inline(always)]
    pub(super) fn are_rough<D: Dice4<Node = T>>(
        &self,
        dice: &D,
        current: &Rays4<M::Weight, T>,
        which: u32,
    ) -> u32 {
        let is_rough = |&k: &usize| {
            let (_, node) = one(current, k);
            dice.one(k).facet(self.surfaces.number(k), node).is_some()
        };
        Bits(which).filter(is_rough).fold(0, |rough, k| rough | 1 << k)
    }

    /// Spawns the secondary rays of rough surfaces, of those in `which`, one after the other. The reflected ones take the place of their `parents`: a
    /// bit for each that there is.
    #[inline(never)] // smooth surfaces do not pay for it
    pub(super) fn spawn_rough<N: Needs, D: Dice4<Node = T>>(
        &mut self,
        tracer: &Traced<'a, M, N, STACK>,
        (rays, dice): (&Ray4, &D),
        which: u32,
        (parents, lights): (&mut Rays4<M::Weight, T>, &mut [Rgb<f32>; 4]),
    ) -> u32 {
        let mut going_on = 0;
        for k in Bits(which) {
            let surface = self.surfaces.whole(rays, k);
            let current = one_mut(parents, k);
            let sum = (one_mut(&mut self.pending, k), one_mut(lights, k));
            let parent = (&current.0, dice.one(k), current.1);
            if let Some(next) = tracer.spawn(&surface, parent, sum, &mut ()) {
                *current = next;
                going_on |= 1 << k;
            }
        }
        going_on
    }
}
