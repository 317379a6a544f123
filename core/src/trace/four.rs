//! Four pixels at once: their ray trees are walked beside each other, one ray of each at a time.
//!
//! Each pixel's light adds up in the order of its own tree, so that it is the same, to the last bit, as of one pixel after another.

use glam::{Vec3, Vec4};

use super::{Pending, Stack, Tracer};
use crate::bvh::Bits;
use crate::color::Rgb;
use crate::illumination::{Illumination, RayKind, Weight};
use crate::lanes::geometry::{Ray4, leave, normalize, reflect, refract};
use crate::lanes::vectors::{Vec3x4, lane, one, one_mut, one_ref};
use crate::light::{Incident, Lamp};
use crate::material::Glass;
use crate::needs::Needs;
use crate::scene::{Known, Spots};

impl<M: Illumination<f32>, N: Needs, const STACK: usize> Tracer<'_, f32, M, N, STACK> {
    /// The light that arrives at `origin` against the first `count` of four directions; the others are copies.
    #[inline(always)]
    pub(crate) fn follow_four<'s>(
        &'s self,
        origin: Vec3,
        directions: Vec3x4,
        count: u32,
        pending: &mut [Stack<f32, M::Weight, STACK>; 4],
        spots: &mut Spots<'s>,
        known: &mut Known,
    ) -> [Rgb<f32>; 4] {
        let limits = self.scene.limits();
        let mut lights = [Rgb::BLACK; 4];
        let mut current = [0, 1, 2, 3].map(|k| {
            let (weight, kind) = (M::Weight::WHOLE, RayKind::Primary);
            Pending { origin, direction: directions.lane(k), weight, depth: 0, kind }
        });
        let mut rays = Ray4 { origin: Vec3x4::splat(origin), direction: directions };
        let (mut there, mut are_eyes) = ((1u32 << count) - 1, true);
        loop {
            let nearest = self.scene.find_four::<N>(&rays, there, are_eyes, limits.lid, known);
            are_eyes = false;
            self.scene.see_four::<N>(&rays, &nearest, there, &limits, spots);
            let (mut own, mut lit) = (spots.lights, 0);
            for k in Bits(there) {
                let own = one_mut(&mut own, k);
                self.model.note(one_ref(&current, k).kind);
                if spots.on >> k & 1 == 1 {
                    let surface = spots.surface(&rays, k);
                    *own = self.model.ambient::<N>(&surface, self.scene.ambient);
                    lit |= u32::from(self.model.is_lit::<N>(&surface)) << k;
                } else {
                    self.model.note_light(*own);
                }
            }
            if N::LAMPS && lit != 0 {
                let lamps = if N::SEVERAL_LAMPS { self.scene.lamps.len() } else { 1 };
                for (number, lamp) in self.scene.lamps.iter().take(lamps).enumerate() {
                    self.direct_four((number, lamp), (&rays, spots, lit), &mut own, known);
                }
            }
            let mut branching = 0;
            for k in Bits(there) {
                let current = one_ref(&current, k);
                let light = one_mut(&mut lights, k);
                *light = light.plus(current.weight.filter(one(&own, k)));
                branching |= u32::from(current.depth < self.depth) << k;
            }
            let mut going_on = 0;
            if N::MIRROR && branching & spots.on != 0 {
                going_on = self.spawn_four(&rays, spots, branching & spots.on, &mut current, pending);
            }
            for k in Bits(there & !going_on) {
                match if N::MIRROR { one_mut(pending, k).pop() } else { None } {
                    Some(next) => *one_mut(&mut current, k) = next,
                    None => there &= !(1 << k),
                }
            }
            if there == 0 {
                return lights;
            }
            rays = Ray4 {
                origin: Vec3x4::new(current.each_ref().map(|ray| ray.origin)),
                direction: Vec3x4::new(current.each_ref().map(|ray| ray.direction)),
            };
        }
    }

    /// Adds what four surfaces send back of a lamp, of those in `lit`.
    #[inline(always)]
    fn direct_four(
        &self,
        (number, lamp): (usize, &Lamp<f32>),
        (rays, spots, lit): (&Ray4, &Spots, u32),
        lights: &mut [Rgb<f32>; 4],
        known: &mut Known,
    ) {
        let normal = spots.spot.normal;
        let (direction, distance, inverse, none) = normalize(Vec3x4::splat(lamp.position) - spots.spot.point);
        let cosine = normal.dot(direction);
        let behind = cosine.cmple(Vec4::ZERO);
        let mut lit = lit & !none;
        if !M::BOTH_SIDES {
            lit &= !behind.bitmask();
        }
        let mut direct = [Rgb::BLACK; 4];
        let mut shadowed = 0;
        for k in Bits(lit) {
            let incident = Incident {
                direction: direction.lane(k),
                distance: lane(&distance, k),
                inverse_distance: lane(&inverse, k),
                cosine: lane(&cosine, k),
                lamp,
            };
            let light = self.model.direct::<N>(&spots.surface(rays, k), &incident);
            // No register is negative.
            if N::SHADOWS && light.r + light.g + light.b > 0.0 {
                self.model.note(RayKind::Shadow);
                *one_mut(&mut direct, k) = light;
                shadowed |= 1 << k;
            } else {
                let own = one_mut(lights, k);
                *own = own.plus(light);
            }
        }
        if shadowed != 0 {
            let side = Vec3x4::select(behind, -normal, normal);
            let (origin, used) = leave(spots.spot.point, side, direction, spots.extent);
            let lid = self.scene.limits().lid;
            let shadows = Ray4 { origin, direction };
            let parts =
                self.scene.transmittance_four::<N>(&shadows, distance - used, shadowed, lid, number, known);
            for k in Bits(shadowed) {
                let (own, part) = (one_mut(lights, k), one(&parts, k));
                self.model.note_shadow(part);
                if part == 1.0 {
                    *own = own.plus(one(&direct, k));
                } else if part > 0.0 {
                    *own = own.plus(one(&direct, k).map(|register| register * part));
                }
            }
        }
    }

    /// The secondary rays of four surfaces, of those in `which`: see [`Tracer::spawn`]. The reflected ones take the place of their
    /// `parents`: a bit for each that there is.
    #[inline(always)]
    fn spawn_four(
        &self,
        rays: &Ray4,
        spots: &Spots,
        which: u32,
        parents: &mut [Pending<f32, M::Weight>; 4],
        pending: &mut [Stack<f32, M::Weight, STACK>; 4],
    ) -> u32 {
        let none = Glass { ks: 0.0, kt: 0.0, eta: 1.0, denser: true };
        let (mut reflected, mut transmitted, mut glasses) = ([None; 4], [None; 4], [&none; 4]);
        let (mut reflecting, mut transmitting) = (0, 0);
        for k in Bits(which) {
            let surface = spots.surface(rays, k);
            let secondary = self.model.secondary::<N>(&surface);
            *one_mut(&mut reflected, k) = secondary.reflected;
            reflecting |= u32::from(secondary.reflected.is_some()) << k;
            if N::GLASS
                && let (Some(glass), Some(_)) = (surface.material.glass::<N>(), secondary.transmitted)
            {
                *one_mut(&mut transmitted, k) = secondary.transmitted;
                *one_mut(&mut glasses, k) = glass;
                transmitting |= 1 << k;
            }
        }
        let (incoming, normal, point) = (rays.direction, spots.spot.normal, spots.spot.point);
        let ray = |parent: &Pending<f32, M::Weight>,
                   k: usize,
                   (origin, direction): (&Vec3x4, &Vec3x4),
                   weight: M::Weight,
                   kind| {
            let weight = parent.weight.compose(weight);
            if weight.is_below(self.cutoff) {
                return None;
            }
            let (origin, direction) = (origin.lane(k), direction.lane(k));
            Some(Pending { origin, direction, weight, depth: parent.depth + 1, kind })
        };
        if N::GLASS && transmitting != 0 {
            let (direction, total) = refract(incoming, normal, spots.inside, glasses);
            let (origin, _) = leave(point, -normal, direction, spots.extent);
            for k in Bits(transmitting) {
                let Some(through) = one(&transmitted, k) else { continue };
                if total >> k & 1 == 1 {
                    // Total internal reflection: both rays are one.
                    let reflected = one_mut(&mut reflected, k);
                    *reflected = Some(reflected.map_or(through, |weight| weight.join(through)));
                    reflecting |= 1 << k;
                } else if let Some(ray) =
                    ray(one_ref(parents, k), k, (&origin, &direction), through, RayKind::Transmitted)
                {
                    // There is room: at most one ray waits for each level, and there are no more than STACK.
                    let pushed = one_mut(pending, k).push(ray);
                    debug_assert!(pushed.is_ok(), "the ray stack is one entry for each level of depth");
                }
            }
        }
        if reflecting != 0 {
            let direction = reflect(incoming, normal);
            let (origin, _) = leave(point, normal, direction, spots.extent);
            for k in Bits(reflecting) {
                let Some(weight) = one(&reflected, k) else { continue };
                let place = one_mut(parents, k);
                match ray(place, k, (&origin, &direction), weight, RayKind::Reflected) {
                    Some(ray) => *place = ray,
                    None => reflecting &= !(1 << k),
                }
            }
        }
        reflecting
    }
}
