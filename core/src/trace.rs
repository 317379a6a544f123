//! The ray tree, walked with a flat stack (T. Whitted 1980; no recursion).
//!
//! A pending ray carries its weight: what part of its light arrives in the pixel. Weights multiply on the way down and
//! contributions add up, so nothing has to be kept of the way back.

mod four;

use heapless::Vec;

use crate::camera::Camera;
use crate::color::Rgb;
use crate::error::Error;
use crate::illumination::{Illumination, RayKind, Surface, Weight};
use crate::light::Incident;
use crate::material::Glass;
use crate::needs::Needs;
use crate::range::Admitted;
use crate::ray::Ray;
use crate::scalar::{Light, Scalar, Unit};
use crate::scene::{Known, Seen};
use crate::vector::{LengthVector, UnitVec3, UnitVector, Vec3};

/// Draws a scene with an illumination model.
///
/// `STACK` is the deepest recursion it can be asked for: of the two rays that a point of a glass asks for, one is
/// followed at once and one waits, so that at most one waits for each level.
#[derive(Clone, Copy, Debug)]
pub struct Tracer<'a, S: Scalar, M, N, const STACK: usize> {
    scene: Admitted<'a, S>,
    model: M,
    depth: u8,
    cutoff: S::Unit,
    needs: core::marker::PhantomData<fn() -> N>,
}

/// A ray that waits for its turn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pending<S: Scalar, W> {
    origin: Vec3<S>,
    direction: UnitVec3<S>,
    weight: W,
    depth: u8,
    kind: RayKind,
}

/// The rays that wait for their turn.
pub(crate) type Stack<S, W, const STACK: usize> = Vec<Pending<S, W>, STACK>;

impl<'a, S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize> Tracer<'a, S, M, N, STACK> {
    /// Bytes of the stack of pending rays: what the ray tree costs beyond one ray.
    ///
    /// In `Q16`, `Q20` and `f32` a ray that waits takes 40 bytes with [`Rta`](crate::illumination::Rta)'s weights of three
    /// registers and 32 with [`Whitted`](crate::illumination::Whitted)'s of one; at depth 5 that is 208 and 168 bytes
    /// with the length of the stack, on a machine of 64 bits.
    pub const STACK_BYTES: usize = size_of::<Stack<S, M::Weight, STACK>>();

    /// A tracer that follows rays through `depth` reflections and refractions: the eye's ray is depth 0, and a ray of
    /// depth `depth` spawns nothing.
    ///
    /// # Errors
    /// [`Error::Depth`] where `depth` exceeds the capacity `STACK`.
    pub fn new(scene: Admitted<'a, S>, model: M, depth: u32) -> Result<Self, Error> {
        let error = Error::Depth { depth, capacity: STACK };
        let depth = u8::try_from(depth).map_err(|_| error)?;
        if usize::from(depth) > STACK {
            return Err(error);
        }
        Ok(Self { scene, model, depth, cutoff: S::Unit::ZERO, needs: core::marker::PhantomData })
    }

    /// The same, but a ray that would bring less than the part `cutoff` of its light into the pixel is not traced:
    /// adaptive depth (R. Hall and D. Greenberg, "A Testbed for Realistic Image Synthesis", IEEE CG&A 3, 1983). 0, the
    /// default, traces all.
    pub fn with_cutoff(self, cutoff: S::Unit) -> Self {
        Self { cutoff, ..self }
    }

    /// The light that comes in along the eye's ray with a camera's direction.
    pub fn primary(&self, camera: &Camera<S>, direction: UnitVec3<S>) -> Rgb<S::Light> {
        self.radiance(camera.eye, direction)
    }

    /// The light that arrives at `origin` against `direction`, from all of the ray tree.
    pub fn radiance(&self, origin: Vec3<S>, direction: UnitVec3<S>) -> Rgb<S::Light> {
        self.radiance_after(origin, direction, &mut Known::new())
    }

    /// The same of one ray after another.
    #[cfg_attr(not(target_os = "none"), inline(never))] // once is enough
    pub(crate) fn radiance_after(
        &self,
        origin: Vec3<S>,
        direction: UnitVec3<S>,
        known: &mut Known,
    ) -> Rgb<S::Light> {
        self.follow(origin, direction, known)
    }

    /// The same for a loop over many rays.
    #[cfg_attr(not(target_os = "none"), inline(always))] // with all that it calls, so that the loop makes ready what all rays need
    pub(crate) fn follow(&self, origin: Vec3<S>, direction: UnitVec3<S>, known: &mut Known) -> Rgb<S::Light> {
        if !N::MIRROR {
            self.model.note(RayKind::Primary);
            return self.local(&self.scene.ray::<N>(origin, direction), known).0;
        }
        let mut pending = Stack::<S, M::Weight, STACK>::new();
        let mut light = Rgb::BLACK;
        let mut next =
            Some(Pending { origin, direction, weight: M::Weight::WHOLE, depth: 0, kind: RayKind::Primary });
        while let Some(current) = next {
            self.model.note(current.kind);
            let ray = self.scene.ray::<N>(current.origin, current.direction);
            let (own, seen) = self.local(&ray, known);
            light = light.plus(current.weight.filter(own));
            next = match seen {
                Some((surface, extent)) if current.depth < self.depth => {
                    self.spawn(&surface, extent, &current, &mut pending)
                }
                _ => None,
            };
            next = next.or_else(|| pending.pop());
        }
        light
    }

    /// What one ray brings of its own, and the surface that it has met with the size of its object.
    #[allow(clippy::type_complexity)] // light, and perhaps a surface with a size
    #[cfg_attr(not(target_os = "none"), inline(always))] // see `follow`
    fn local(&self, ray: &Ray<S>, known: &mut Known) -> (Rgb<S::Light>, Option<(Surface<'_, S>, S)>) {
        let (surface, extent) = match self.scene.look::<N>(ray, &self.scene.limits()) {
            Seen::Light(light) => {
                self.model.note_light(light);
                return (light, None);
            }
            Seen::Surface(surface, extent) => (surface, extent),
        };
        let mut light = self.model.ambient::<N>(&surface, self.scene.ambient);
        if N::LAMPS && self.model.is_lit::<N>(&surface) {
            let lamps = if N::SEVERAL_LAMPS { self.scene.lamps.len() } else { 1 };
            for (number, lamp) in self.scene.lamps.iter().take(lamps).enumerate() {
                if let Some(incident) = Incident::new(lamp, surface.point, surface.normal) {
                    light = light.plus(self.direct(&surface, &incident, extent, number, known));
                }
            }
        }
        (light, Some((surface, extent)))
    }

    /// What the surface sends back of one lamp, as far as nothing hides it.
    #[cfg_attr(not(target_os = "none"), inline(always))] // see `follow`
    fn direct(
        &self,
        surface: &Surface<S>,
        incident: &Incident<S>,
        extent: S,
        number: usize,
        known: &mut Known,
    ) -> Rgb<S::Light> {
        let behind = incident.cosine <= S::Unit::ZERO;
        if behind && !M::BOTH_SIDES {
            return Rgb::BLACK;
        }
        let light = self.model.direct::<N>(surface, incident);
        if !N::SHADOWS || light == Rgb::BLACK {
            return light;
        }
        let side = if behind { -surface.normal } else { surface.normal };
        let (origin, used) = surface.point.leave(side, incident.direction, extent);
        self.model.note(RayKind::Shadow);
        let ray = self.scene.ray::<N>(origin, incident.direction);
        let (t_max, lid) = (incident.distance - used, self.scene.limits().lid);
        let part = self.scene.transmittance_after::<N>(&ray, t_max, lid, number, known);
        self.model.note_shadow(part);
        if part == S::Unit::ONE { light } else { light.map(|register| register.times(part)) }
    }

    /// The secondary rays of a surface: the transmitted one waits, the reflected one is to be followed at once.
    #[cfg_attr(not(target_os = "none"), inline(always))] // see `follow`
    fn spawn(
        &self,
        surface: &Surface<S>,
        extent: S,
        parent: &Pending<S, M::Weight>,
        pending: &mut Stack<S, M::Weight, STACK>,
    ) -> Option<Pending<S, M::Weight>> {
        let secondary = self.model.secondary::<N>(surface);
        let ray = |side, direction, weight: M::Weight, kind| {
            let weight = parent.weight.compose(weight);
            if weight.is_below(self.cutoff) {
                return None;
            }
            let (origin, _) = surface.point.leave(side, direction, extent);
            Some(Pending { origin, direction, weight, depth: parent.depth + 1, kind })
        };
        let mut reflected = secondary.reflected;
        if N::GLASS
            && let (Some(glass), Some(through)) = (surface.material.glass::<N>(), secondary.transmitted)
        {
            match refract(surface, glass) {
                Some(direction) => {
                    if let Some(ray) = ray(-surface.normal, direction, through, RayKind::Transmitted) {
                        // There is room: at most one ray waits for each level, and there are no more than STACK.
                        let pushed = pending.push(ray);
                        debug_assert!(pushed.is_ok(), "the ray stack is one entry for each level of depth");
                    }
                }
                // Total internal reflection: both rays are one.
                None => reflected = Some(reflected.map_or(through, |weight| weight.join(through))),
            }
        }
        reflected.and_then(|weight| {
            let direction = surface.incoming.reflect(surface.normal);
            ray(surface.normal, direction, weight, RayKind::Reflected)
        })
    }
}

/// The transmitted ray by Snell's law; nothing where there is total internal reflection.
///
/// `T = eta I + (eta cos - sqrt(1 - eta^2 (1 - cos^2))) N`, where eta is the index of refraction where the ray comes
/// from over that where it goes. Where that is above 1 everything is divided by it, so that no number is: the direction
/// is normalised in the end anyway.
pub fn refract<S: Scalar>(surface: &Surface<S>, glass: &Glass<S>) -> Option<UnitVec3<S>> {
    let one = S::Unit::ONE;
    let cosine = -surface.normal.dot(surface.incoming);
    let direction = if surface.inside != glass.denser {
        // Into the denser: 1 - eta^2 + (eta cos)^2.
        let slanted = glass.eta.times(cosine);
        let root = S::Unit::radical(one, slanted, glass.eta)?;
        surface.incoming.scale(glass.eta).plus(surface.normal, slanted - root)
    } else {
        // Into the thinner, over eta: (1/eta)^2 - 1 + cos^2.
        let root = S::Unit::radical(cosine, glass.eta, one)?;
        surface.incoming.plus(surface.normal, cosine - root)
    };
    direction.normalize().map(|(direction, _)| direction)
}
