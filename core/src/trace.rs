//! The ray tree (T. Whitted 1980), walked with a stack of pending rays instead of recursion.
//!
//! A pending ray carries its weight: the part of its light that arrives in the pixel. Weights are multiplied on the way down
//! and contributions are added up, so no way back up the tree is needed. Shadow rays are traced here too, one for each lamp
//! that would light the point.
//!
//! Which secondary rays a point spawns, and with which weights, is decided in [`decision`].

mod aspects;
mod cones;
pub mod decision;
pub mod dice;
mod distributed;
mod lamps;
pub mod moving;
mod observer;
pub mod path;
mod spawn;
mod spectrum;

use core::marker::PhantomData;

use heapless::Vec;

use decision::{Branch, Start, ambient, casts_shadow_ray, direct};
use dice::{Dice, Sample, Still};
pub use distributed::Distributed;
use lamps::{has_size, shadow_start};
pub use observer::Observer;
pub use path::Paths;
pub use spectrum::Spectrum;

use crate::accelerator::{Accelerator, Lists};
use crate::camera::Camera;
use crate::color::Rgb;
use crate::error::Error;
use crate::illumination::{Illumination, Passage, Way, Weight};
use crate::light::Incident;
use crate::needs::Needs;
use crate::range::Admitted;
use crate::ray::{Ray, RayKind};
use crate::scalar::vector::{LengthVector, UnitVec3, Vec3};
use crate::scalar::{Light, Scalar, Unit};
use crate::surface::Surface;
use crate::world::Seen;

/// Traces rays through a scene in the scalar `S` with the illumination model `M`; `N` says what is compiled in.
///
/// `STACK` is the greatest recursion depth: of the two rays that glass spawns one is followed at once and one waits, so that
/// at most one waits for each level. `A` is how the scene is searched.
#[derive(Clone, Copy, Debug)]
pub struct Tracer<'a, S: Scalar, M, N, const STACK: usize, A = Lists> {
    scene: &'a Admitted<'a, S, A>,
    model: M,
    depth: u8,
    cutoff: S::Unit,
    needs: PhantomData<fn() -> N>,
}

/// A ray that is still to be traced.
#[derive(Clone, Copy, Debug)]
pub struct Pending<S: Scalar, W> {
    /// Where it starts and where it goes.
    pub start: Start<S>,
    /// Its place in the tree.
    pub branch: Branch<W>,
}

/// The stack of rays that are still to be traced.
pub type Stack<S, W, const STACK: usize> = Vec<Pending<S, W>, STACK>;

/// The rays that are still to be traced, each with its node in the tree.
pub type Waiting<S, W, T, const STACK: usize> = Vec<(Pending<S, W>, T), STACK>;

/// What returns the light of a ray from the eye: a [`Tracer`], the [`Spectrum`] of several, or one that is [`Distributed`].
pub trait Trace<S: Scalar> {
    /// What its accelerator keeps from ray to ray: [`Accelerator::Memory`].
    type Memory: Default;

    /// Whether samples differ in more than the ray from the eye: whether [`Trace::sample`] is more than what it is by itself.
    const SPREADS: bool = false;

    /// Returns the radiance that a ray from `origin` in the unit direction `direction` brings back, from the whole ray tree.
    /// `memory` is what the accelerator keeps from ray to ray; `observer` is told of every ray.
    fn trace<O: Observer<S> + ?Sized>(
        &self,
        origin: Vec3<S>,
        direction: UnitVec3<S>,
        memory: &mut Self::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light>;

    /// Returns the radiance of one sample of a picture, at the place `right` and `up` of the image plane, as
    /// [`Camera::direction`] takes it: that of the ray through there from the eye, unless rays are spread.
    #[inline]
    fn sample<O: Observer<S> + ?Sized>(
        &self,
        camera: &Camera<S>,
        (right, up): (S::Unit, S::Unit),
        _sample: Sample,
        memory: &mut Self::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        self.trace(camera.eye, camera.direction(right, up), memory, observer)
    }
}

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>> Trace<S>
    for Tracer<'_, S, M, N, STACK, A>
{
    type Memory = A::Memory;

    #[cfg_attr(not(target_os = "none"), inline(always))]
    fn trace<O: Observer<S> + ?Sized>(
        &self,
        origin: Vec3<S>,
        direction: UnitVec3<S>,
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        self.walk(Start { origin, direction }, Still, memory, observer)
    }
}

impl<'a, S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>>
    Tracer<'a, S, M, N, STACK, A>
{
    /// The size of the stack of pending rays in bytes: the memory that the ray tree takes.
    ///
    /// In `Q16`, `Q20` and `f32` a pending ray takes 40 bytes with [`Rta`](crate::illumination::Rta)'s weights of three
    /// registers and 32 with [`Whitted`](crate::illumination::Whitted)'s of one; at depth 5 that is 208 and 168 bytes
    /// with the length of the stack, on a machine of 64 bits.
    pub const STACK_BYTES: usize = size_of::<Stack<S, M::Weight, STACK>>();

    /// Returns a tracer that follows rays through `depth` reflections and refractions: the primary ray has depth 0, and a ray
    /// of depth `depth` spawns no secondary rays.
    ///
    /// # Errors
    /// [`Error::Depth`] where `depth` exceeds the capacity `STACK` or the scene's [`Limits::depth`](crate::scene::Limits::depth).
    pub fn new(scene: &'a Admitted<'a, S, A>, model: M, depth: u32) -> Result<Self, Error> {
        let capacity = STACK.min(usize::from(scene.limits.depth));
        let error = Error::Depth { depth, capacity };
        let depth = u8::try_from(depth).map_err(|_| error)?;
        if usize::from(depth) > capacity {
            return Err(error);
        }
        let cutoff = model.cutoff();
        Ok(Self { scene, model, depth, cutoff, needs: PhantomData })
    }

    /// Returns the tracer with a contribution cut-off: a secondary ray whose weight is below `cutoff` is not traced. This is
    /// adaptive depth (R. Hall and D. Greenberg, "A Testbed for Realistic Image Synthesis", IEEE CG&A 3,
    /// 1983). The default is the model's, [`Illumination::cutoff`].
    pub fn with_cutoff(self, cutoff: S::Unit) -> Self {
        Self { cutoff, ..self }
    }

    /// Returns scene, model, depth and cut-off, for a loop outside the core that traces several rays side by side.
    pub const fn parts(&self) -> (&'a Admitted<'a, S, A>, &M, u8, S::Unit) {
        (self.scene, &self.model, self.depth, self.cutoff)
    }

    /// Returns the radiance that a ray from `origin` in the unit direction `direction` brings back: see [`Trace::trace`].
    pub fn radiance(&self, origin: Vec3<S>, direction: UnitVec3<S>) -> Rgb<S::Light> {
        self.trace(origin, direction, &mut A::Memory::default(), &mut ())
    }

    /// Returns the radiance of a ray from the whole ray tree, whose rays are spread by `dice`.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    fn walk<D: Dice<S>, O: Observer<S> + ?Sized>(
        &self,
        start: Start<S>,
        dice: D,
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        // A ray and its node, in one place: taken apart, they are copied once more.
        let mut current = (Pending { start, branch: Branch::eye::<S>() }, D::EYE);
        if !N::MIRROR {
            let light = self.arrived(&mut current.0, &mut None, (dice, current.1), memory, observer);
            observer.light(light);
            return light;
        }
        let mut pending = Waiting::<S, M::Weight, D::Node, STACK>::new();
        let mut light = Rgb::BLACK;
        loop {
            let mut surface = None;
            let weighted = self.arrived(&mut current.0, &mut surface, (dice, current.1), memory, observer);
            observer.light(weighted);
            light = light.plus(weighted);
            let next = match &surface {
                Some(surface) if current.0.branch.depth < self.depth => {
                    let parent = (&current.0, dice, current.1);
                    self.spawn(surface, parent, (&mut pending, &mut light), observer)
                }
                _ => None,
            };
            match next.or_else(|| pending.pop()) {
                Some(next) => current = next,
                None => return light,
            }
        }
    }

    /// Returns the part of the radiance of one ray, without its secondary rays, that arrives in the pixel. `surface` becomes the surface
    /// that the ray meets, if any. What is lost on the ray's way is lost to the secondary rays too: the ray's weight is changed.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    fn arrived<D: Dice<S>, O: Observer<S> + ?Sized>(
        &self,
        current: &mut Pending<S, M::Weight>,
        surface: &mut Option<Surface<'a, S>>,
        dice: (D, D::Node),
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let mut length = None;
        let own = self.local(current, (&mut length, surface), dice, memory, observer);
        let own = self.scene.shining::<N>(own, surface.as_ref());
        let weight = current.branch.weight;
        if M::ALONG {
            let Pending { start, branch: Branch { kind, .. } } = *current;
            let (lamps, is_spread) = (self.scene.scene.lamps, !D::STILL && N::SPREAD_AIR);
            let shift = if is_spread && kind == RayKind::Primary { dice.0.step(dice.1) } else { None };
            let way = Way { kind, start, length, surface: surface.as_ref(), shift, lamps };
            let lit = |place, lamp| {
                let spread =
                    if is_spread && N::AREA_LAMPS { self.beam(place, lamp, dice, memory) } else { None };
                spread.unwrap_or_else(|| self.reached(place, lamp, memory))
            };
            if let Some(Passage { weight: part, veil }) = self.model.along::<N>(&way, lit) {
                current.branch.weight = weight.compose(part);
                return current.branch.weight.filter(own).plus(weight.filter(veil));
            }
        }
        if N::MIRROR { weight.filter(own) } else { own }
    }

    /// Returns the part of the light of a lamp, by its number, that reaches a place in the air, 0 to 1.
    pub fn reached(&self, place: Vec3<S>, number: usize, memory: &mut A::Memory) -> S::Unit {
        let Some(lamp) = self.scene.scene.lamps.get(number).filter(|_| N::SHADOWS) else {
            return S::Unit::ONE;
        };
        let Some((direction, distance, _)) = (lamp.position - place).normalize() else { return S::Unit::ONE };
        let ray = self.ray(Start { origin: place, direction });
        self.scene.accelerator().transmittance::<N>(self.scene, &ray, distance, number, memory)
    }

    /// Returns the radiance of one ray without its secondary rays. `length` becomes the length of the ray, if it meets anything and if the
    /// model asks for it, and `met` the surface that it meets, if any.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    fn local<D: Dice<S>, O: Observer<S> + ?Sized>(
        &self,
        current: &Pending<S, M::Weight>,
        (length, met): (&mut Option<S>, &mut Option<Surface<'a, S>>),
        (dice, node): (D, D::Node),
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let (scene, branch) = (self.scene, &current.branch);
        observer.ray(branch.kind, branch.depth, &current.start);
        let ray = self.ray(current.start);
        let hit = scene.accelerator().closest::<N>(scene, &ray, memory);
        if M::ALONG {
            *length = hit.map(|hit| hit.distance);
        }
        let ray = if A::WITH_PLAN { ray } else { scene.planned::<N>(ray, hit.as_ref()) };
        let surface = match scene.seen::<N>(&ray, hit) {
            Seen::Light(light) => {
                observer.hit(hit.as_ref(), None);
                return light;
            }
            Seen::Surface(surface) => met.insert(surface),
        };
        if let Some(hit) = &hit {
            scene.cover::<N>(surface, hit.object, branch.kind);
        }
        observer.hit(hit.as_ref(), Some(surface));
        let solved = hit.filter(|_| N::RADIOSITY).and_then(|hit| dice.arriving(hit.object, surface));
        let mut light = ambient::<S, M, N>(&self.model, surface, solved.unwrap_or(scene.scene.ambient));
        if N::LAMPS && self.model.is_lit::<N>(surface) {
            let lamps = if N::SEVERAL_LAMPS { scene.scene.lamps.len() } else { 1 };
            for (number, lamp) in scene.scene.lamps.iter().take(lamps).enumerate() {
                if !D::STILL
                    && N::AREA_LAMPS
                    && has_size::<S, D, N>(dice, number, lamp)
                    && let asked = (dice, node, branch.depth == 0)
                    && let from = (&*surface, hit.map(|hit| hit.object))
                    && let Some(own) = self.spread_light(from, (number, lamp), asked, memory, observer)
                {
                    light = light.plus(own);
                    continue;
                }
                if let Some(incident) = Incident::new(lamp, surface.point, surface.normal) {
                    let unhidden = direct::<S, M, N>(&self.model, surface, &incident);
                    let part = self.unshadowed(surface, &incident, unhidden, number, memory, observer);
                    observer.lamp(number, &incident, unhidden, part);
                    let is_whole = part == S::Unit::ONE;
                    light = light.plus(if is_whole { unhidden } else { unhidden.map(|l| l.times(part)) });
                }
            }
        }
        light
    }

    fn ray(&self, Start { origin, direction }: Start<S>) -> Ray<S> {
        if A::WITH_PLAN { self.scene.ray::<N>(origin, direction) } else { Ray::new(origin, direction) }
    }

    /// Returns the part of a lamp's light that arrives at a surface, 0 to 1. `light` is what the surface would send back of it;
    /// where [`casts_shadow_ray`] needs no shadow ray for it, the result is 1.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    pub fn unshadowed<O: Observer<S> + ?Sized>(
        &self,
        surface: &Surface<S>,
        incident: &Incident<S>,
        light: Rgb<S::Light>,
        number: usize,
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> S::Unit {
        if !casts_shadow_ray::<N, _>(light) {
            return S::Unit::ONE;
        }
        let (start, used) = shadow_start::<S, N>(surface, incident);
        observer.shadow(number, &start);
        let ray = self.ray(start);
        let t_max = incident.distance - used;
        self.scene.accelerator().transmittance::<N>(self.scene, &ray, t_max, number, memory)
    }
}
