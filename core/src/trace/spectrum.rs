//! Pictures of several wavelengths: glass bends each of them by an index of its own, and a prism spreads white light into colours.
//!
//! A picture of several wavelengths is the sum of the ordinary pictures with each wavelength's index, times that wavelength's weight in
//! red, green and blue. The weights of each register add up to 1, so that grey stays grey. The first wavelength is traced for
//! every sample; the others only where a ray of its tree met a surface whose light depends on the wavelength, for all others would
//! see the same.

use core::iter::once;

use super::decision::Start;
use super::{Observer, Trace, Tracer};
use crate::accelerator::{Accelerator, Lists};
use crate::color::Rgb;
use crate::illumination::Illumination;
use crate::light::Incident;
use crate::needs::Needs;
use crate::ray::RayKind;
use crate::scalar::vector::{UnitVec3, Vec3};
use crate::scalar::{Light, Scalar};
use crate::scene::Hit;
use crate::surface::Surface;

/// The tracers of a picture of several wavelengths.
#[derive(Clone, Copy, Debug)]
pub struct Spectrum<'a, S: Scalar, M, N, const STACK: usize, A = Lists> {
    /// The weight of each wavelength in each register, from the first on, 0 to 1. Each register adds up to 1.
    pub weights: &'a [Rgb<S::Unit>],
    /// The tracer of the first wavelength.
    pub first: Tracer<'a, S, M, N, STACK, A>,
    /// The tracers of all wavelengths but the first, in the order of the weights.
    pub further: &'a [Tracer<'a, S, M, N, STACK, A>],
    /// The numbers of the materials whose light depends on the wavelength.
    pub dispersive: &'a [u16],
}

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>> Trace<S>
    for Spectrum<'_, S, M, N, STACK, A>
{
    type Memory = A::Memory;

    fn trace<O: Observer<S> + ?Sized>(
        &self,
        origin: Vec3<S>,
        direction: UnitVec3<S>,
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let mut watched = Watched { observer, dispersive: self.dispersive, is_met: false };
        let mut light = Rgb::BLACK;
        for (tracer, &weight) in once(&self.first).chain(self.further).zip(self.weights) {
            let own = tracer.trace(origin, direction, memory, &mut watched);
            if !watched.is_met {
                return own;
            }
            light = light.plus(own.zip(weight, Light::times));
        }
        light
    }
}

/// An observer that notes whether a ray of the tree meets one of some materials, and passes on to another all that it is told.
struct Watched<'a, O: ?Sized> {
    observer: &'a mut O,
    dispersive: &'a [u16],
    is_met: bool,
}

impl<S: Scalar, O: Observer<S> + ?Sized> Observer<S> for Watched<'_, O> {
    fn ray(&mut self, kind: RayKind, depth: u8, start: &Start<S>) {
        self.observer.ray(kind, depth, start);
    }

    fn hit(&mut self, hit: Option<&Hit<S>>, surface: Option<&Surface<S>>) {
        self.is_met |= surface.is_some_and(|surface| self.dispersive.contains(&surface.number));
        self.observer.hit(hit, surface);
    }

    fn shadow(&mut self, lamp: usize, start: &Start<S>) {
        self.observer.shadow(lamp, start);
    }

    fn lamp(&mut self, lamp: usize, incident: &Incident<S>, light: Rgb<S::Light>, part: S::Unit) {
        self.observer.lamp(lamp, incident, light, part);
    }

    fn light(&mut self, weighted: Rgb<S::Light>) {
        self.observer.light(weighted);
    }

    fn spawned(&mut self, passes: &dyn Fn(S::Unit) -> bool) {
        self.observer.spawned(passes);
    }

    fn total_reflection(&mut self) {
        self.observer.total_reflection();
    }
}
