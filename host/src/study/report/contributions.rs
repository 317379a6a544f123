//! One walk of the ray tree, all depths and cut-offs.
//!
//! A picture of less depth, or of a higher cut-off, is the sum of some of the contributions that the deepest walk adds
//! up, in the same order: what a ray brings of its own does not depend on what it spawns. So an observer notes each
//! contribution as it is added, with the depth of its ray and the cut-offs that the ray passed; summed up again they give
//! the pictures of all settings, to the last bit, with the rays that each of them traces.

use rta_core::color::Rgb;
use rta_core::ray::RayKind;
use rta_core::scalar::{Light, Scalar, Unit};
use rta_core::trace::Observer;
use rta_core::trace::decision::Start;
use rta_packets::tally::{self, Rays};

use super::setting::{CUTOFFS, DEPTHS, LIMITS};

/// What one ray of the tree brought into the pixel, and what it took.
#[derive(Clone, Copy, Debug)]
struct Contribution<L> {
    light: Rgb<L>,
    depth: u8,
    /// How many of the cut-offs the ray and those before it have passed.
    passed: u8,
    rays: Rays,
}

/// The light of one sample with each of [`Limit::all`](super::setting::Limit::all), then with no limit but the
/// tracer's own depth.
pub struct Limited<L> {
    /// With each limit.
    pub lights: [Rgb<L>; LIMITS],
    /// With none.
    pub whole: Rgb<L>,
}

/// The number of cut-offs.
#[allow(clippy::cast_possible_truncation)] // 5
const ALL: u8 = CUTOFFS.len() as u8;
const _: () = assert!(CUTOFFS.len() < 256 && *DEPTHS.end() < 256);

/// An observer that notes what each ray of one sample brings.
pub struct Contributions<L> {
    contributions: Vec<Contribution<L>>,
    /// Rays since the last contribution.
    rays: Rays,
    /// Depth of the current ray, and how many cut-offs it has passed.
    depth: u8,
    passed: u8,
    /// How many cut-offs the rays have passed that wait; the last one is traced next.
    waiting: Vec<u8>,
}

impl<L> Default for Contributions<L> {
    /// Nothing noted.
    fn default() -> Self {
        Self { contributions: Vec::new(), rays: [0; 4], depth: 0, passed: ALL, waiting: Vec::new() }
    }
}

impl<L: Light> Contributions<L> {
    /// Traces one sample, which `trace` tells the observer of, and adds the rays of each limit to `rays`.
    pub fn sample(
        &mut self,
        rays: &mut [Rays; LIMITS],
        trace: impl FnOnce(&mut Self) -> Rgb<L>,
    ) -> Limited<L> {
        self.contributions.clear();
        let whole = trace(self);
        let mut lights = [Rgb::BLACK; LIMITS];
        for contribution in &self.contributions {
            let deep_enough = lights.chunks_mut(CUTOFFS.len()).zip(rays.chunks_mut(CUTOFFS.len()));
            for (lights, rays) in deep_enough.skip(contribution.depth.into()) {
                for (light, rays) in lights.iter_mut().zip(rays).take(contribution.passed.into()) {
                    *light = light.plus(contribution.light);
                    rays.iter_mut().zip(contribution.rays).for_each(|(sum, more)| *sum += more);
                }
            }
        }
        Limited { lights, whole }
    }

    fn count(&mut self, kind: RayKind) {
        if let Some(rays) = self.rays.get_mut(tally::place(kind)) {
            *rays += 1;
        }
    }
}

impl<S: Scalar> Observer<S> for Contributions<S::Light> {
    fn ray(&mut self, kind: RayKind, depth: u8, _start: &Start<S>) {
        self.count(kind);
        self.depth = depth;
        // A ray from the eye did not wait.
        self.passed = if depth == 0 { ALL } else { self.waiting.pop().unwrap_or(ALL) };
    }

    fn shadow(&mut self, _lamp: usize, _start: &Start<S>) {
        self.count(RayKind::Shadow);
    }

    fn light(&mut self, light: Rgb<S::Light>) {
        let Self { depth, passed, .. } = *self;
        let rays = core::mem::take(&mut self.rays);
        self.contributions.push(Contribution { light, depth, passed, rays });
    }

    fn spawned(&mut self, passes: &dyn Fn(S::Unit) -> bool) {
        let passed = CUTOFFS
            .iter()
            .take(self.passed.into())
            .take_while(|cutoff| passes(S::Unit::ratio(cutoff.numerator(), cutoff.denominator())));
        self.waiting.push(u8::try_from(passed.count()).unwrap_or(ALL));
    }
}
