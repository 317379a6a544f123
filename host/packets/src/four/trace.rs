//! Four samples at once: their ray trees are walked side by side, one ray of each at a time.
//!
//! Each sample's light adds up in the order of its own tree, so that it is the same, to the last bit, as of one sample after
//! another.

use core::fmt::Debug;

use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Passage, Weight};
use rta_core::light::Lamp;
use rta_core::material::Glass;
use rta_core::needs::Needs;
use rta_core::ray::RayKind;
use rta_core::trace::decision::{Branch, Start, branch, casts_shadow_ray, mirrored_sky};
use rta_core::trace::dice::Dice;
use rta_core::trace::{Pending, Tracer, Waiting};

use super::area::Incidents4;
use super::closest::Hits4;
use super::dice::Dice4;
use super::geometry::{Ray4, leave, normalize, reflect, refract};
use super::surfaces::Surfaces4;
use super::vector::{Vec3x4, lane, one, one_mut};
use crate::cache::ShadowCache;
use crate::flat::FlatSearch;
use crate::leaf::Bits;
use crate::packets::Packets;

/// Glass for a ray that meets none.
const NO_GLASS: Glass<f32> = Glass { ks: 0.0, kt: 0.0, eta: 1.0, denser: true };

/// Rays that nobody has asked for.
const NOWHERE: Ray4 = Ray4 { origin: Vec3x4::ZERO, direction: Vec3x4::ZERO };

/// One ray of each of four trees, and its node in the tree.
pub(super) type Rays4<W, T> = [(Pending<f32, W>, T); 4];

/// The ray trees of four samples; `T` is the place of a ray in a tree.
pub(crate) struct Trees4<'a, M: Illumination<f32>, T, const STACK: usize> {
    pub(super) pending: [Waiting<f32, M::Weight, T, STACK>; 4],
    pub(super) surfaces: Surfaces4<'a>,
    pub(super) cache: ShadowCache,
    /// The search of a room of flat triangles, where it is one.
    pub(super) flat: Option<FlatSearch<'a>>,
}

/// Four rays, what they meet, the dice of their samples, and where they are in their trees.
pub(super) struct Met4<'m, D, W, T> {
    pub(super) rays: &'m Ray4,
    pub(super) nearest: &'m Hits4,
    pub(super) dice: &'m D,
    pub(super) current: &'m Rays4<W, T>,
}

pub(super) type Traced<'a, M, N, const STACK: usize> = Tracer<'a, f32, M, N, STACK, &'a Packets>;

impl<'a, M: Illumination<f32>, T: Copy + Debug, const STACK: usize> Trees4<'a, M, T, STACK> {
    /// Nothing waits, and nothing is known.
    pub(crate) fn new() -> Self {
        let pending = core::array::from_fn(|_| Waiting::new());
        Self { pending, surfaces: Surfaces4::NONE, cache: ShadowCache::default(), flat: None }
    }

    /// Returns the light of the first `count` of four rays from the eye, whose trees are spread by `dice`; the others are copies.
    #[inline(always)]
    pub(crate) fn radiance<N: Needs, D: Dice4<Node = T>>(
        &mut self,
        tracer: &Traced<'a, M, N, STACK>,
        mut rays: Ray4,
        dice: &D,
        count: u32,
    ) -> [Rgb<f32>; 4] {
        let (scene, model, depth, _) = tracer.parts();
        let mut lights = [Rgb::BLACK; 4];
        let mut current =
            [0, 1, 2, 3].map(|k| (Pending { start: start(&rays, k), branch: Branch::eye::<f32>() }, D::EYE));
        let (mut there, mut are_eyes) = ((1u32 << count) - 1, true);
        loop {
            let nearest = self.closest::<N>(scene, &rays, (there, are_eyes));
            self.surfaces.see::<N>(scene, &rays, &nearest, (there, are_eyes));
            let lengths = nearest.distance;
            let (mut own, mut lit) = (self.surfaces.lights, 0);
            for k in Bits(there & self.surfaces.on) {
                let surface = self.surfaces.surface(&rays, k);
                let solved = one(&nearest.objects, k).filter(|_| N::RADIOSITY && dice.has_solved());
                let solved = solved.and_then(|object| dice.one(k).arriving(object, &surface));
                let ambient = solved.unwrap_or(scene.scene.ambient);
                *one_mut(&mut own, k) = model.ambient::<N>(&surface, ambient);
                lit |= u32::from(model.is_lit::<N>(&surface)) << k;
            }
            let met = Met4 { rays: &rays, nearest: &nearest, dice, current: &current };
            if N::MESHES && self.surfaces.meshed & there != 0 {
                self.mesh_ambient::<N, D>(tracer, &met, there, &mut own);
            }
            if N::LAMPS && lit != 0 {
                let lamps = if N::SEVERAL_LAMPS { scene.scene.lamps.len() } else { 1 };
                for (number, lamp) in scene.scene.lamps.iter().take(lamps).enumerate() {
                    let asked = (number, lamp);
                    if D::STILL || !self.add_large_lamp(tracer, asked, &met, (lit, are_eyes), &mut own) {
                        self.add_lamp(tracer, asked, &rays, lit, &mut own);
                    }
                }
            }
            are_eyes = false;
            if N::EMISSION && !scene.scene.coats.is_empty() {
                for k in Bits(there & self.surfaces.on) {
                    let light = one_mut(&mut own, k);
                    *light = scene.shining::<N>(*light, Some(&self.surfaces.surface(&rays, k)));
                }
            }
            let mut branching = 0;
            for k in Bits(there) {
                let (pending, node) = one_mut(&mut current, k);
                let (weight, own) = (pending.branch.weight, one(&own, k));
                let mut arrived = weight.filter(own);
                if M::ALONG {
                    let length = one(&nearest.objects, k).map(|_| lane(&lengths, k));
                    let thrown = (dice.one(k), *node);
                    let passage = self.along(tracer, (pending, &rays, k), length, thrown);
                    if let Some(Passage { weight: part, veil }) = passage {
                        pending.branch.weight = weight.compose(part);
                        arrived = pending.branch.weight.filter(own).plus(weight.filter(veil));
                    }
                }
                let light = one_mut(&mut lights, k);
                *light = light.plus(arrived);
                branching |= u32::from(pending.branch.depth < depth) << k;
            }
            branching &= self.surfaces.on;
            let mut going_on = 0;
            if N::MIRROR && branching != 0 {
                if !D::STILL && N::GLOSS {
                    let rough = self.are_rough(dice, &current, branching);
                    if rough != 0 {
                        let trees = (&mut current, &mut lights);
                        branching &= !rough;
                        going_on = self.spawn_rough::<N, D>(tracer, (&rays, dice), rough, trees);
                    }
                }
                let meshed = if N::MESHES { branching & self.surfaces.meshed } else { 0 };
                let flat = branching & !meshed;
                going_on |= self.spawn::<N, D, false>(tracer, &rays, flat, (&mut current, &mut lights));
                if N::MESHES && meshed != 0 {
                    going_on |= self.spawn_meshes::<N, D>(tracer, &rays, meshed, (&mut current, &mut lights));
                }
            }
            for k in Bits(there & !going_on) {
                match if N::MIRROR { one_mut(&mut self.pending, k).pop() } else { None } {
                    Some(next) => *one_mut(&mut current, k) = next,
                    None => there &= !(1 << k),
                }
            }
            if there == 0 {
                return lights;
            }
            rays = Ray4 {
                origin: Vec3x4::new(current.each_ref().map(|(ray, _)| ray.start.origin)),
                direction: Vec3x4::new(current.each_ref().map(|(ray, _)| ray.start.direction)),
            };
        }
    }

    /// Adds what four surfaces send back of a lamp, of those in `lit`.
    #[inline(always)]
    fn add_lamp<N: Needs>(
        &mut self,
        tracer: &Traced<'a, M, N, STACK>,
        (number, lamp): (usize, &Lamp<f32>),
        rays: &Ray4,
        lit: u32,
        lights: &mut [Rgb<f32>; 4],
    ) {
        let spot = &self.surfaces.spot;
        let (direction, distance, inverse_distance, none) =
            normalize(Vec3x4::splat(lamp.position) - spot.point);
        let cosine = spot.normal.dot(direction);
        let seen = Incidents4 { direction, distance, inverse_distance, cosine };
        self.add_incident::<N>(tracer, (number, lamp), (&seen, &seen), rays, (lit & !none, 1.0), lights);
    }

    /// Adds a `share` of what four surfaces send back of a lamp, of those in `lit`, as seen at a place on it, which a shadow ray goes to, and shown to
    /// the model as `shown`.
    #[inline(always)]
    pub(super) fn add_incident<N: Needs>(
        &mut self,
        tracer: &Traced<'a, M, N, STACK>,
        (number, lamp): (usize, &Lamp<f32>),
        (place, shown): (&Incidents4, &Incidents4),
        rays: &Ray4,
        (lit, share): (u32, f32),
        lights: &mut [Rgb<f32>; 4],
    ) {
        let (scene, model, ..) = tracer.parts();
        let spot = &self.surfaces.spot;
        let behind = self.surfaces.are_behind::<N>(place.direction, place.cosine);
        let lit = lit & self.surfaces.are_lit::<M>(behind);
        let meshes = if N::MESHES { lit & self.surfaces.meshed } else { 0 };
        let mut unhidden = [Rgb::BLACK; 4];
        let mut shadowed = 0;
        for k in Bits(lit & !meshes) {
            let light = model.direct::<N>(&self.surfaces.surface(rays, k), &shown.lane(lamp, k));
            if casts_shadow_ray::<N, _>(light) {
                *one_mut(&mut unhidden, k) = light;
                shadowed |= 1 << k;
            } else {
                let own = one_mut(lights, k);
                *own = own.plus(light.map(|register| register * share));
            }
        }
        if N::MESHES && meshes != 0 {
            let lights = (&mut unhidden, &mut *lights);
            shadowed |= self.mesh_direct::<N>(tracer, lamp, rays, meshes, lights);
        }
        if shadowed != 0 {
            let side = self.surfaces.sides::<N>();
            let side = Vec3x4::select(behind, -side, side);
            let (origin, used) = leave(spot.point, side, place.direction, self.surfaces.extent);
            let shadows = (&Ray4 { origin, direction: place.direction }, place.distance - used, shadowed);
            let parts = self.transmittance::<N>(scene, shadows, number);
            for k in Bits(shadowed) {
                let (own, part) = (one_mut(lights, k), one(&parts, k));
                if part == 1.0 && share == 1.0 {
                    *own = own.plus(one(&unhidden, k));
                } else if part > 0.0 {
                    *own = own.plus(one(&unhidden, k).map(|register| register * (part * share)));
                }
            }
        }
    }

    /// Spawns the secondary rays of four surfaces, of those in `which`. The reflected ones take the place of their `parents`: a
    /// bit for each that there is. What those bring that see the sky alone is added to `lights`. All are meshes, or none is.
    #[inline(always)]
    pub(super) fn spawn<N: Needs, D: Dice4<Node = T>, const MESHES: bool>(
        &mut self,
        tracer: &Traced<'a, M, N, STACK>,
        rays: &Ray4,
        which: u32,
        (parents, lights): (&mut Rays4<M::Weight, T>, &mut [Rgb<f32>; 4]),
    ) -> u32 {
        let (scene, model, _, cutoff) = tracer.parts();
        let (incoming, surfaces) = (rays.direction, &self.surfaces);
        let normal = surfaces.spot.normal;
        let (mut refracted, mut total) = (NOWHERE, 0);
        if N::GLASS && Bits(which).any(|k| one(&surfaces.materials, k).glass::<N>().is_some()) {
            let glasses = surfaces.materials.map(|material| material.glass::<N>().unwrap_or(&NO_GLASS));
            let (direction, none) = refract(incoming, normal, surfaces.inside, glasses);
            (refracted, total) = (surfaces.secondary::<N>(direction, false), none);
        }
        // Computed for all four when the first of them asks.
        let (mut reflected, mut is_reflected) = (NOWHERE, false);
        let mut going_on = 0;
        for k in Bits(which) {
            let (parent, node) = one_mut(parents, k);
            let surface = surfaces.surface(rays, k);
            let secondary = if MESHES {
                surfaces.mesh_secondary::<M, N>(model, rays, k)
            } else {
                model.secondary::<N>(&surface)
            };
            let [transmitted, mirrored] = branch::<f32, M::Weight, N>(
                secondary,
                &surface,
                (&parent.branch, cutoff),
                || {
                    if !core::mem::replace(&mut is_reflected, true) {
                        reflected = surfaces.secondary::<N>(reflect(incoming, normal), true);
                    }
                    start(&reflected, k)
                },
                |_| (total >> k & 1 == 0).then(|| start(&refracted, k)),
                || start(&surfaces.secondary::<N>(incoming, false), k),
            );
            if N::GLASS
                && let Some((branch, start)) = transmitted
            {
                // There is room: at most one ray waits for each level, and there are no more than STACK.
                let pushed = one_mut(&mut self.pending, k)
                    .push((Pending { start, branch }, child::<D>(*node, branch.kind)));
                debug_assert!(pushed.is_ok(), "the ray stack is one entry for each level of depth");
            }
            let Some((branch, start)) = mirrored else { continue };
            if N::SURROUNDINGS && surfaces.surroundings >> k & 1 == 1 {
                let light = one_mut(lights, k);
                let sky = mirrored_sky::<f32, _, N>(&scene.scene, branch.weight, start.direction);
                *light = light.plus(sky);
                continue;
            }
            *node = child::<D>(*node, branch.kind);
            *parent = Pending { start, branch };
            going_on |= 1 << k;
        }
        going_on
    }
}

/// Returns the place of a secondary ray of that kind, from that of its parent.
#[inline(always)]
fn child<'d, D: Dice4 + 'd>(node: D::Node, kind: RayKind) -> D::Node {
    <D::One<'d> as Dice<f32>>::child(node, kind)
}

/// Where one of four rays starts and goes.
#[inline(always)]
fn start(rays: &Ray4, k: usize) -> Start<f32> {
    Start { origin: rays.origin.lane(k), direction: rays.direction.lane(k) }
}
