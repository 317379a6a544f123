//! What patches see, kept: where their rays end does not depend on light, so that sweeps need not trace them anew where there is
//! memory for it.

use super::cast::Casts;
use super::ends::{End, View};
use super::gather::Solver;
use super::mesh::Patch;
use super::sweep::Gathered;
use crate::accelerator::Accelerator;
use crate::color::Rgb;
use crate::needs::Needs;
use crate::scalar::{Scalar, Summed};

impl<S: Scalar, N: Needs, C: Casts<S>, A: Accelerator<S>> Solver<'_, S, N, C, A> {
    /// Calls `keep` with each end of the rays of a patch, and returns the sum of the weights of its rays; `None` for a patch that is not there.
    pub fn view(
        &self,
        patch: Patch,
        memory: &mut A::Memory,
        keep: impl FnMut(End<S>),
    ) -> Option<<S::Light as Summed>::Sum> {
        let site = self.mesh().site(patch)?;
        let mut found = (Gathered::<S::Light>::NOTHING, keep);
        self.each(
            &site,
            memory,
            &mut found,
            |(gathered, _), weight| gathered.weigh(weight),
            |(_, keep), (_, number), weights, is_straight| {
                // Patches are counted in 32 bits.
                if let Ok(number) = u32::try_from(number) {
                    keep(End { number, weights, is_straight });
                }
            },
        );
        Some(found.0.whole())
    }

    /// Returns `factor` times what arrives from what a patch sees, where `reflected` is X of each patch: what its rays find when they are
    /// traced, to the last bit.
    pub fn viewed(
        &self,
        view: &View<'_, S>,
        reflected: &[Rgb<S::Light>],
        factor: Rgb<S::Unit>,
    ) -> Rgb<S::Light> {
        let mut gathered = Gathered::of(view.whole);
        for End { number, weights, is_straight } in view.ends {
            let number = crate::scene::index(*number);
            let patch = || self.mesh().patch(number);
            gathered.add_each(self.sent((number, patch), *is_straight, reflected), *weights);
        }
        gathered.mean(factor)
    }
}
