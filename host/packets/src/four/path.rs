//! Four paths side by side in a scene of flat, diffuse triangles, in `f32`: four times [`rta_core::trace::path`], to the last bit.
//!
//! Each ray is searched for by itself, as paths soon lead apart; what is computed where they end is computed for four. A path that ends
//! makes room for the next sample, so that all four places are taken until no sample is left, and light is told in the order of the samples.

mod eyes;
mod lamps;
mod queue;
mod search;

use glam::{Vec3, Vec4};
use rta_core::camera::Camera;
use rta_core::color::Rgb;
use rta_core::illumination::Lambert;
use rta_core::needs::Needs;
use rta_core::raster::Raster;
use rta_core::sampling::pairs::Purpose;
use rta_core::shape::Triangle;
use rta_core::trace::Paths;
use rta_core::trace::dice::Sample;
use rta_core::trace::path::{Asked, Rules};

use super::geometry::{Ray4, SurfacePoint4, leave};
use super::mapping::{Frame4, disc, lifted};
use super::pairs::{Pairs4, Words, units};
use super::vector::{Vec3x4, lane, one, one_mut, set};
use crate::flat::{Nearest, Ready4};
use crate::leaf::{Bits, index};
use crate::packets::Packets;
use eyes::Eyes;
use queue::Queue;
pub(crate) use search::Search;

/// A tracer of paths in `f32` in a scene of diffuse surfaces.
pub(crate) type Traced<'t, N> = Paths<'t, f32, Lambert<'static, f32>, N, 1, &'t Packets>;

/// Registers of light, or parts of it, side by side.
type Rgb4 = [Vec4; 3];

/// No light.
const BLACK: Rgb4 = [Vec4::ZERO; 3];

/// Returns whether nothing is in a scene with these needs but triangles that are flat, diffuse and opaque.
pub(crate) const fn is_flat<N: Needs>() -> bool {
    let others =
        N::SPHERES | N::ELLIPSOIDS | N::CYLINDERS | N::CONES | N::PLANES | N::FLOOR | N::VISIBLE_LAMPS;
    let curved = N::NORMALS | N::BUMPS | N::MESHES;
    let painted = N::CHECKER | N::MARBLE | N::WOOD | N::IMAGES | N::SURROUNDINGS | N::SKY_MAP;
    let shiny = N::MIRROR | N::GLASS | N::GLOSS | N::TRANSPARENT_SHADOWS;
    !(others | curved | painted | shiny) && N::TRIANGLES && N::LAMPS && N::SHADOWS
}

/// Returns the search by which paths of a tracer are followed side by side; `None` where they are followed one after the other: where other things
/// than flat, diffuse triangles are drawn, or lamps are asked in another way than by the default [`Rules`].
pub(crate) fn search<'t, N: Needs>(tracer: &Traced<'t, N>) -> Option<Search<'t>> {
    let Rules { lamps, weighs, .. } = tracer.rules;
    let (world, ..) = tracer.spread.tracer.parts();
    let is_known = is_flat::<N>() && lamps == Asked::One && weighs;
    if is_known && !world.scene.triangles.is_empty() { Search::new(world.accelerator()) } else { None }
}

/// Where four paths end for now.
struct Places<'a> {
    triangles: [&'a Triangle<f32>; 4],
    /// The normals are turned towards the rays' origins.
    spot: SurfacePoint4,
    extent: Vec4,
    /// The chance with which each path goes on.
    chance: Vec4,
    /// The parts of the light that are sent back.
    part: Rgb4,
}

/// Four paths on their way.
struct Four {
    rays: Ray4,
    samples: [Sample; 4],
    /// The bounces between the eye and the ends of the rays.
    bounces: [u8; 4],
    /// What of the light from there arrives in the pixels, over the chance that the paths go there.
    weight: Rgb4,
    /// The density over the solid angle, times pi, with which they left the surfaces before.
    density: Vec4,
    /// The light of the paths so far.
    light: Rgb4,
    /// What arrives from where they end now.
    own: Rgb4,
}

/// Calls `put` with the light of the path of each of some samples on `raster`, in their order: the light of
/// [`Trace::sample`](rta_core::trace::Trace::sample) at the places of a [`Sobol`](rta_core::sampling::Sobol).
pub(crate) fn follow<N: Needs>(
    (tracer, mut search): (&Traced<'_, N>, Search<'_>),
    (camera, raster): (&Camera<f32>, Raster),
    samples: &mut dyn Iterator<Item = Sample>,
    put: &mut dyn FnMut(Rgb<f32>),
) {
    let (scene, ..) = tracer.spread.tracer.parts();
    let Some(any) = scene.scene.triangles.first() else { return };
    let mut queue = Queue::new();
    let mut eyes = Eyes::new((tracer.spread.spread, tracer.spread.seed), (camera, raster), samples);
    let mut four = Four::NONE;
    let (mut there, mut ended) = (0, 15);
    loop {
        for k in Bits(ended) {
            if there >> k & 1 == 1 {
                queue.end(k, four.ended(k), put);
                there &= !(1 << k);
            }
            if let Some((sample, ray)) = eyes.next() {
                queue.begin(k);
                four.begin(k, sample, ray);
                there |= 1 << k;
            }
        }
        if there == 0 {
            return;
        }
        let mut places = Places::none(any);
        let mut going = four.meet(tracer, there, &mut places, &mut search);
        if going != 0 {
            going = four.lobes(tracer, going, &mut places);
        }
        if going != 0 {
            four.add_lamp(tracer, going, &places, &mut search);
            going = four.go_on(going, tracer.spread.seed, &places);
        }
        four.light = plus(four.light, core::mem::replace(&mut four.own, BLACK));
        ended = 15 & !going;
    }
}

impl<'a> Places<'a> {
    /// Nothing, for which any triangle stands.
    fn none(any: &'a Triangle<f32>) -> Self {
        Self {
            triangles: [any; 4],
            spot: SurfacePoint4::ZERO,
            extent: Vec4::ZERO,
            chance: Vec4::ONE,
            part: BLACK,
        }
    }
}

impl Four {
    /// Nothing.
    const NONE: Self = Self {
        rays: Ray4 { origin: Vec3x4::ZERO, direction: Vec3x4::ZERO },
        samples: [Sample { x: 0, y: 0, number: 0 }; 4],
        bounces: [0; 4],
        weight: BLACK,
        density: Vec4::ZERO,
        light: BLACK,
        own: BLACK,
    };

    /// Path `k` begins.
    fn begin(&mut self, k: usize, sample: Sample, (origin, direction): (Vec3, Vec3)) {
        self.rays.origin.set(k, origin);
        self.rays.direction.set(k, direction);
        *one_mut(&mut self.samples, k) = sample;
        *one_mut(&mut self.bounces, k) = 0;
        for (weight, light) in self.weight.iter_mut().zip(&mut self.light) {
            set(weight, k, 1.0);
            set(light, k, 0.0);
        }
    }

    /// Returns the light of path `k`.
    fn ended(&self, k: usize) -> Rgb<f32> {
        let [r, g, b] = self.light.each_ref().map(|register| lane(register, k));
        Rgb::new(r, g, b)
    }

    /// Returns a pair of numbers for each path from 0 to 1, for a purpose where its ray ends.
    fn words(&self, purpose: Purpose, seed: u32) -> [Words; 2] {
        // Node 1 is where the ray from the eye ends.
        let tags = self.bounces.map(|bounce| purpose.tag(u32::from(bounce) + 1));
        Pairs4::new(&self.samples, tags, seed).words(self.samples.map(|sample| sample.number))
    }

    /// Follows the paths in `there` to what they meet, and adds the light that is sent from there. Returns which of them meet a surface.
    fn meet<'a, N: Needs>(
        &mut self,
        tracer: &Traced<'a, N>,
        there: u32,
        places: &mut Places<'a>,
        search: &mut Search,
    ) -> u32 {
        let (world, ..) = tracer.spread.tracer.parts();
        let ready = Ready4::new(&self.rays, world.accelerator());
        let (mut on, mut numbers) = (0, [0; 4]);
        for k in Bits(there) {
            let met = match search.flat.nearest(&ready, k, one(&self.bounces, k) == 0) {
                Nearest::Triangle(i, _) => Some(i),
                Nearest::Nothing => None,
                Nearest::Unknown => search.closest::<N>(world, &self.rays.lane(k)),
            };
            if let Some(i) = met
                && let Some(triangle) = world.scene.triangles.get(index(i))
            {
                *one_mut(&mut places.triangles, k) = triangle;
                *one_mut(&mut numbers, k) = i;
                on |= 1 << k;
            } else {
                self.send(k, world.scene.radiance::<N>(self.rays.direction.lane(k)));
            }
        }
        if on == 0 {
            return 0;
        }
        let mut spot = SurfacePoint4::on_triangles(places.triangles, &self.rays);
        let inside = spot.normal.dot(self.rays.direction).cmpgt(Vec4::ZERO);
        spot.normal = Vec3x4::select(inside, -spot.normal, spot.normal);
        (places.spot, places.extent) = (spot, four(places.triangles, |triangle| triangle.extent));
        if N::EMISSION && !world.scene.coats.is_empty() {
            for k in Bits(on & !inside.bitmask()) {
                let sent = world.emitted(one(&places.triangles, k).material, false);
                if sent != Rgb::BLACK {
                    let part = self.counted(tracer, one(&numbers, k), &places.spot, k);
                    self.send(k, sent.map(|register| register * part));
                }
            }
        }
        on
    }

    /// Light is sent into path `k` from where its ray ends.
    fn send(&mut self, k: usize, light: Rgb<f32>) {
        for ((own, weight), light) in self.own.iter_mut().zip(&self.weight).zip([light.r, light.g, light.b]) {
            set(own, k, light * lane(weight, k));
        }
    }

    /// Returns what the surfaces in `on` send back, and which paths go on from there at all.
    fn lobes<N: Needs>(&self, tracer: &Traced<'_, N>, on: u32, places: &mut Places) -> u32 {
        let (world, ..) = tracer.spread.tracer.parts();
        let Rules { bounces, roulette, .. } = tracer.rules;
        let mut part = [|rgb: &Rgb<f32>| rgb.r, |rgb: &Rgb<f32>| rgb.g, |rgb: &Rgb<f32>| rgb.b]
            .map(|register| four(places.triangles, |triangle| register(&triangle.color)));
        if N::FINISH && !world.scene.materials.is_empty() {
            let kd = four(places.triangles, |triangle| {
                world.scene.material(triangle.material).finish::<N>().map_or(1.0, |finish| finish.kd)
            });
            part = part.map(|register| register * kd);
        }
        places.part = part.map(|register| register.max(Vec4::ZERO));
        let [red, green, blue] = times(self.weight, places.part);
        let size = red.max(green).max(blue);
        let most = four(self.bounces, |bounce| {
            let may_all_end = roulette.is_some_and(|first| bounce.saturating_add(1) >= first);
            if may_all_end { 19.0 / 20.0 } else { 1.0 }
        });
        let longer = size * Vec4::splat(4.0 / 3.0);
        let chance = Vec4::select(size.cmplt(Vec4::splat(0.75)), longer, Vec4::ONE).min(most);
        places.chance = if roulette.is_some() { chance } else { Vec4::ONE };
        let mut on = on & (size.cmpgt(Vec4::ZERO) & places.chance.cmpgt(Vec4::ZERO)).bitmask();
        for k in Bits(on) {
            on &= !(u32::from(one(&self.bounces, k) >= bounces) << k);
        }
        on
    }

    /// Sends the paths in `on` on from where they are; returns which of them go on.
    fn go_on(&mut self, on: u32, seed: u32, places: &Places) -> u32 {
        let [first, second] = self.words(Purpose::Lobe, seed).map(units);
        let Places { spot, chance, part, .. } = places;
        let goes_on = first.cmplt(*chance) | !chance.cmplt(Vec4::ONE);
        let going = on & goes_on.bitmask();
        if going == 0 {
            return 0;
        }
        let spread = disc([(first / *chance).min(Vec4::ONE), second]);
        let [x, y] = spread;
        let direction = Frame4::about(spot.normal).vector([x, y, lifted(spread)]);
        let (origin, _) = leave(spot.point, spot.normal, direction, places.extent);
        self.rays = Ray4 { origin, direction };
        self.density = spot.normal.dot(direction).max(Vec4::ZERO) * *chance;
        self.weight = times(self.weight, part.map(|register| register / *chance));
        for k in Bits(going) {
            let bounce = one_mut(&mut self.bounces, k);
            *bounce = bounce.saturating_add(1);
        }
        going
    }
}

/// Returns a number of each of four things.
#[inline(always)]
fn four<T>(of: [T; 4], number: impl Fn(T) -> f32) -> Vec4 {
    let [a, b, c, d] = of.map(number);
    Vec4::new(a, b, c, d)
}

/// Returns products of registers.
#[inline(always)]
fn times([r, g, b]: Rgb4, [by_r, by_g, by_b]: Rgb4) -> Rgb4 {
    [r * by_r, g * by_g, b * by_b]
}

/// Returns sums of registers.
#[inline(always)]
fn plus([r, g, b]: Rgb4, [more_r, more_g, more_b]: Rgb4) -> Rgb4 {
    [r + more_r, g + more_g, b + more_b]
}
