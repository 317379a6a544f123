//! What arrives at a single place of a quadrilateral, found by rays from there.

use super::cast::{Cast, Casts};
use super::follow::{Ended, left};
use super::gather::Solver;
use super::sweep::Gathered;
use crate::accelerator::Accelerator;
use crate::color::Rgb;
use crate::needs::Needs;
use crate::scalar::{Scalar, Unit};

impl<S: Scalar, N: Needs, C: Casts<S>, A: Accelerator<S>> Solver<'_, S, N, C, A> {
    /// Returns what arrives at the place (u, v) of a quadrilateral from patches, an irradiance, where `reflected` is X of each; `None` at a place
    /// that is not there, and where more than a quarter of the rays meet the backs of patches, as at the foot of a box that stands on the
    /// quadrilateral or within it. All rays leave from that place. `name` is the number by which they differ from those of other places, as a
    /// patch's does. `see` is told how far away each ray ends: by the harmonic mean of the distances it is known how fast the irradiance
    /// changes there (G. Ward, F. Rubinstein and R. Clear, "A Ray Tracing Solution for Diffuse Interreflection", SIGGRAPH 88).
    pub fn arriving_at(
        &self,
        (quad, at): (usize, [S::Unit; 2]),
        name: u32,
        reflected: &[Rgb<S::Light>],
        memory: &mut A::Memory,
        mut see: impl FnMut(S),
    ) -> Option<Rgb<S::Light>> {
        let site = self.mesh().at(quad, at).and_then(|patch| self.mesh().site(patch))?;
        let (place, number) = (site.quad.place(at), u32::try_from(quad).unwrap_or(u32::MAX));
        let (mut gathered, mut behind) = (Gathered::NOTHING, 0);
        for k in 0..self.casts().count() {
            let Cast { direction, weight, .. } = self.casts().cast(name, number, k);
            let start = left(&site, place, site.frame.vector(direction));
            gathered.weigh(weight);
            self.follow(start, weight, memory, |end, weights, is_straight, distance| {
                see(distance);
                match end {
                    Ended::On((patch, number)) => {
                        let light = self.sent((number, || Some(patch)), is_straight, reflected);
                        gathered.add_each(light, weights);
                    }
                    Ended::Behind => behind += 1,
                    Ended::Elsewhere => {}
                }
            });
        }
        let one = S::Unit::ONE;
        (behind <= self.casts().count() / 4).then(|| gathered.mean(Rgb::new(one, one, one)))
    }
}
