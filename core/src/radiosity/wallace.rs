//! Form factors from a receiver to a patch that shoots.

use super::cast::Casts;
use super::gather::Solver;
use super::mesh::Patch;
use crate::accelerator::Accelerator;
use crate::color::Rgb;
use crate::needs::Needs;
use crate::scalar::vector::{LengthVector, UnitVector};
use crate::scalar::{Positive, Scalar, Unit};

/// What a mesh emits, and what it absorbs, each as a mean over its area. The rest leaves the scene, or meets what has no patches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance<L> {
    /// The mean of E.
    pub emitted: Rgb<L>,
    /// The mean of `(1 - rho) H`, where H is all that arrives.
    pub absorbed: Rgb<L>,
}

impl<S: Scalar, N: Needs, C: Casts<S>, A: Accelerator<S>> Solver<'_, S, N, C, A> {
    /// Returns the form factor from the middle of a patch, the receiver, to another, which is seen at the middles of its four quarters as
    /// discs: `A/4 sum cos cos V / (pi r^2 + A/4)` (Wallace et al. 1989). Each term is at most 1; where their sum is more,
    /// [`Shooter::shoot`](super::Shooter::shoot) takes it as 1 and counts it, and here it is at most 1.99.
    pub fn disc_factor(&self, receiver: Patch, source: Patch, memory: &mut A::Memory) -> S::Unit {
        let mesh = self.mesh();
        let (Some(site), Some(other), Some(area)) =
            (mesh.site(receiver), mesh.site(source), mesh.area(source))
        else {
            return S::Unit::ZERO;
        };
        let half = S::Unit::ratio(1, 2);
        let place = site.quad.place(site.quad.within(receiver.cell, [half; 2]));
        // Pi, within 2^-62, times 4.
        let four_pi = S::Power::new(0xc90f_daa2_2168_c235, -60);
        let one = S::Unit::ONE.positive();
        let mut sum = S::Unit::ZERO.positive();
        for quarter in 0..4u8 {
            let part = |bit: u8| S::Unit::ratio(if quarter >> bit & 1 == 0 { 1 } else { 3 }, 4);
            let there = other.quad.place(other.quad.within(source.cell, [part(0), part(1)]));
            let Some((direction, distance, _)) = (there - place).normalize() else { continue };
            let cosines = [site.normal.dot(direction), -other.normal.dot(direction)];
            if cosines.iter().any(|&cosine| cosine <= S::Unit::ZERO) {
                continue;
            }
            let [own, others] = cosines;
            if self.is_open(&site, place, (source.quad, there), memory) {
                let distance = distance.positive();
                let apart = four_pi.times(distance.times(distance)).over(area).plus(one);
                sum = sum.plus(own.times(others).positive().over(apart));
            }
        }
        let most = S::Unit::ratio(199, 100);
        let sum = sum.unit();
        if sum > most { most } else { sum }
    }

    /// Returns what the mesh emits and absorbs, where `reflected` is X of each patch and `arriving` is H, if it is kept. All rays are traced
    /// once more.
    pub fn balance(
        &self,
        reflected: &[Rgb<S::Light>],
        arriving: Option<&[Rgb<S::Light>]>,
    ) -> Balance<S::Light> {
        let mesh = self.mesh();
        let largest = mesh.largest_area();
        let mut memory = A::Memory::default();
        let (mut emitted, mut absorbed) = (super::sweep::Gathered::NOTHING, super::sweep::Gathered::NOTHING);
        for (number, patch) in mesh.patches().enumerate() {
            let share = mesh.share(patch, largest);
            let direct = match arriving.and_then(|arriving| arriving.get(number)) {
                Some(&direct) => direct,
                None => self.arriving(patch, &mut memory),
            };
            let light = direct.plus(self.indirect(patch, reflected, &mut memory));
            let Some(quad) = mesh.quads().get(patch.quad) else { continue };
            emitted.weigh(share);
            emitted.add(mesh.emitted(patch), share);
            absorbed.weigh(share);
            absorbed.add_each(light, quad.reflectance.map(|part| share.times(S::Unit::ONE - part)));
        }
        let white = Rgb::new(S::Unit::ONE, S::Unit::ONE, S::Unit::ONE);
        Balance { emitted: emitted.mean(white), absorbed: absorbed.mean(white) }
    }
}
