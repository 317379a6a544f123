//! Shooting: the patch with the most light that it has not sent yet sends it to all others.

use super::mesh::{Mesh, Patch};
use super::sweep::Gathered;
use super::{Error, room};
use crate::color::Rgb;
use crate::scalar::{Light, Scalar, Unit};

/// Progressive refinement (Cohen et al. 1988): after each shot the light of all patches is a better picture than before.
#[derive(Debug)]
pub struct Shooter<'a, S: Scalar> {
    mesh: Mesh<'a, S>,
    light: &'a mut [Rgb<S::Light>],
    unshot: &'a mut [Rgb<S::Light>],
    largest: S::Power,
    clamped: u32,
}

impl<'a, S: Scalar> Shooter<'a, S> {
    /// Begins with what is emitted. `light` is B of each patch, `unshot` the part of it that it has not sent yet.
    ///
    /// # Errors
    /// [`Error::Room`] where a slice is shorter than the mesh.
    pub fn new(
        mesh: Mesh<'a, S>,
        light: &'a mut [Rgb<S::Light>],
        unshot: &'a mut [Rgb<S::Light>],
    ) -> Result<Self, Error> {
        let (light, unshot) = (room(light, mesh.len())?, room(unshot, mesh.len())?);
        for ((light, unshot), patch) in light.iter_mut().zip(&mut *unshot).zip(mesh.patches()) {
            (*light, *unshot) = (mesh.emitted(patch), mesh.emitted(patch));
        }
        Ok(Self { mesh, light, unshot, largest: mesh.largest_area(), clamped: 0 })
    }

    /// Returns B of each patch.
    pub fn light(&self) -> &[Rgb<S::Light>] {
        self.light
    }

    /// Returns how many factors were above 1 and were taken as 1.
    pub const fn clamped(&self) -> u32 {
        self.clamped
    }

    /// Returns the area of a patch as a part of the largest.
    fn share(&self, patch: Patch) -> S::Unit {
        self.mesh.share(patch, self.largest)
    }

    /// Returns the patch that shoots next: that with the largest product of area and unshot light, all registers together; of equal ones the
    /// first. `None` where nothing is left.
    pub fn next(&self) -> Option<Patch> {
        let mut most = (S::Light::ZERO, None);
        for (patch, unshot) in self.mesh.patches().zip(&*self.unshot) {
            // A third of each register, so that their sum is not cut.
            let third = self.share(patch).times(S::Unit::ratio(1, 3));
            let mut gathered = Gathered::NOTHING;
            gathered.weigh(S::Unit::ONE);
            for register in [unshot.r, unshot.g, unshot.b] {
                gathered.add(Rgb::new(register, S::Light::ZERO, S::Light::ZERO), third);
            }
            let light = gathered.mean(white::<S>()).r;
            if light > most.0 {
                most = (light, Some(patch));
            }
        }
        most.1
    }

    /// Sends the unshot light of a patch to all others. `factor` returns the form factor from a patch, the receiver, to the one that shoots:
    /// the part that this one has of what the receiver sees.
    pub fn shoot(&mut self, source: Patch, mut factor: impl FnMut(Patch) -> S::Unit) {
        let Some(sent) = self.mesh.number(source).and_then(|number| self.unshot.get_mut(number)) else {
            return;
        };
        let sent = core::mem::replace(sent, Rgb::BLACK);
        for ((patch, light), unshot) in self.mesh.patches().zip(&mut *self.light).zip(&mut *self.unshot) {
            let Some(quad) = self.mesh.quads().get(patch.quad).filter(|_| patch != source) else { continue };
            let mut part = factor(patch);
            if part > S::Unit::ONE {
                part = S::Unit::ONE;
                self.clamped = self.clamped.saturating_add(1);
            }
            let arrived = sent.zip(quad.reflectance, |sent, reflectance| sent.times(part.times(reflectance)));
            (*light, *unshot) = (light.plus(arrived), unshot.plus(arrived));
        }
    }

    /// Returns the unshot part of what was emitted, both summed over areas and registers: 1 at first, as a radiance; 0 where nothing emits.
    pub fn left(&self) -> S::Light {
        if self.mesh.patches().all(|patch| self.mesh.emitted(patch) == Rgb::BLACK) {
            return S::Light::ZERO;
        }
        let mut sums = [Gathered::<S::Light>::NOTHING; 2];
        for (patch, unshot) in self.mesh.patches().zip(&*self.unshot) {
            let share = self.share(patch);
            for (sum, light) in sums.iter_mut().zip([*unshot, self.mesh.emitted(patch)]) {
                for register in [light.r, light.g, light.b] {
                    sum.add(Rgb::new(register, S::Light::ZERO, S::Light::ZERO), share);
                }
            }
        }
        let [left, whole] = sums;
        left.over_each(&whole).r
    }

    /// Returns the light that a patch shows with an estimate of what unshot light will bring it (Cohen et al. 1988): if all of it goes
    /// round evenly, `rho sum A dB / sum A (1 - rho)`. It is for the picture alone: shooting goes on without it.
    pub fn with_ambient(&self, patch: Patch) -> Rgb<S::Light> {
        let number = self.mesh.number(patch);
        let light = number.and_then(|number| self.light.get(number)).copied().unwrap_or(Rgb::BLACK);
        let ambient = self.ambient();
        let reflectance = self.mesh.quads().get(patch.quad).map(|quad| quad.reflectance);
        reflectance.map_or(light, |reflectance| light.plus(ambient.zip(reflectance, S::Light::times)))
    }

    /// Returns the estimate of the unshot light that arrives everywhere.
    pub fn ambient(&self) -> Rgb<S::Light> {
        let white = Rgb::new(S::Light::WHITE, S::Light::WHITE, S::Light::WHITE);
        let (mut left, mut absorbed) = (Gathered::NOTHING, Gathered::<S::Light>::NOTHING);
        for (patch, unshot) in self.mesh.patches().zip(&*self.unshot) {
            let share = self.share(patch);
            left.add(*unshot, share);
            if let Some(quad) = self.mesh.quads().get(patch.quad) {
                absorbed.add_each(white, quad.reflectance.map(|part| share.times(S::Unit::ONE - part)));
            }
        }
        left.over_each(&absorbed)
    }
}

/// Returns the colour that leaves light as it is.
fn white<S: Scalar>() -> Rgb<S::Unit> {
    Rgb::new(S::Unit::ONE, S::Unit::ONE, S::Unit::ONE)
}
