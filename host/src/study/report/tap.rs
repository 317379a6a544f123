//! One walk of the ray tree, all depths and cut-offs.
//!
//! A picture of less depth, or of a higher cut-off, is the sum of some of the contributions that the deepest walk adds
//! up, in the same order: what a ray brings of its own does not depend on what it spawns. So an illumination model whose
//! weights know their depth, and which cut-offs they passed, can note each contribution as it is added; summed up again
//! they give the pictures of all settings, to the last bit, with the rays that each of them traces.

use core::any::Any;
use core::cell::RefCell;

use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, RayKind, Secondary, Surface, Weight};
use rta_core::light::Incident;
use rta_core::needs::Needs;
use rta_core::scalar::{Light, Scalar, Unit};

use super::setting::{CUTOFFS, DEPTHS, LIMITS};
use crate::engine::tally::{self, Rays};

/// What one ray of the tree brought into the pixel, and what it took.
#[derive(Clone, Copy, Debug)]
struct Contribution<L> {
    light: Rgb<L>,
    depth: u8,
    /// How many of the cut-offs the ray and those before it have passed.
    passed: u8,
    rays: Rays,
}

/// The contributions to one sample so far.
struct Recording<L> {
    rays: Rays,
    contributions: Vec<Contribution<L>>,
}

std::thread_local! {
    /// The tracer has weights made from nothing, so they cannot carry a reference to where contributions go.
    static RECORDING: RefCell<Box<dyn Any>> = RefCell::new(Box::new(()));
}

fn recording<L: 'static>(note: impl FnOnce(&mut Recording<L>)) {
    RECORDING.with_borrow_mut(|any| {
        if let Some(recording) = any.downcast_mut() {
            note(recording);
        }
    });
}

/// The light of one sample with each of [`Limit::all`](super::setting::Limit::all), then with no limit but the
/// tracer's own depth.
pub struct Limited<L> {
    /// With each limit.
    pub lights: [Rgb<L>; LIMITS],
    /// With none.
    pub whole: Rgb<L>,
}

/// Traces one sample with a model that is a [`Tap`], and adds the rays of each limit to `rays`.
pub fn sample<L: Light>(rays: &mut [Rays; LIMITS], trace: impl FnOnce() -> Rgb<L>) -> Limited<L> {
    RECORDING.with_borrow_mut(|any| match any.downcast_mut::<Recording<L>>() {
        Some(recording) => recording.contributions.clear(),
        None => *any = Box::new(Recording::<L> { rays: Rays::default(), contributions: Vec::new() }),
    });
    let whole = trace();
    let mut lights = [Rgb::BLACK; LIMITS];
    recording(|recording: &mut Recording<L>| {
        for contribution in &recording.contributions {
            let deep_enough = lights.chunks_mut(CUTOFFS.len()).zip(rays.chunks_mut(CUTOFFS.len()));
            for (lights, rays) in deep_enough.skip(contribution.depth.into()) {
                for (light, rays) in lights.iter_mut().zip(rays).take(contribution.passed.into()) {
                    *light = light.plus(contribution.light);
                    rays.iter_mut().zip(contribution.rays).for_each(|(sum, more)| *sum += more);
                }
            }
        }
    });
    Limited { lights, whole }
}

/// A model that notes what each ray brings.
#[derive(Clone, Copy, Debug)]
pub struct Tap<M>(pub M);

/// A weight that knows where it is in the ray tree.
#[derive(Clone, Copy, Debug)]
pub struct Tapped<W> {
    weight: W,
    depth: u8,
    passed: u8,
}

/// All the cut-offs.
#[allow(clippy::cast_possible_truncation)] // 5
const ALL: u8 = CUTOFFS.len() as u8;
const _: () = assert!(CUTOFFS.len() < 256 && *DEPTHS.end() < 256);

impl<W> Tapped<W> {
    const fn secondary(weight: W) -> Self {
        Self { weight, depth: 1, passed: ALL }
    }
}

impl<S: Scalar, W: Weight<S>> Weight<S> for Tapped<W> {
    const WHOLE: Self = Self { weight: W::WHOLE, depth: 0, passed: ALL };

    fn compose(self, other: Self) -> Self {
        let weight = self.weight.compose(other.weight);
        let passes = |passed: &u8| {
            CUTOFFS.get(usize::from(*passed)).is_some_and(|cutoff| {
                !weight.is_below(S::Unit::ratio(cutoff.numerator(), cutoff.denominator()))
            })
        };
        let passed = (0..self.passed).take_while(passes).count();
        let passed = u8::try_from(passed).unwrap_or(ALL);
        Self { weight, depth: self.depth.saturating_add(other.depth), passed }
    }

    fn join(self, other: Self) -> Self {
        Self { weight: self.weight.join(other.weight), ..self }
    }

    fn filter(self, light: Rgb<S::Light>) -> Rgb<S::Light> {
        let light = self.weight.filter(light);
        recording(|recording: &mut Recording<S::Light>| {
            let Self { depth, passed, .. } = self;
            let rays = core::mem::take(&mut recording.rays);
            recording.contributions.push(Contribution { light, depth, passed, rays });
        });
        light
    }

    fn is_below(self, threshold: S::Unit) -> bool {
        self.weight.is_below(threshold)
    }
}

impl<S: Scalar, M: Illumination<S>> Illumination<S> for Tap<M> {
    type Weight = Tapped<M::Weight>;
    const BOTH_SIDES: bool = M::BOTH_SIDES;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        self.0.ambient::<N>(surface, ambient)
    }

    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool {
        self.0.is_lit::<N>(surface)
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        self.0.direct::<N>(surface, incident)
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<Self::Weight> {
        let Secondary { reflected, transmitted } = self.0.secondary::<N>(surface);
        Secondary {
            reflected: reflected.map(Tapped::secondary),
            transmitted: transmitted.map(Tapped::secondary),
        }
    }

    fn note(&self, kind: RayKind) {
        recording(|recording: &mut Recording<S::Light>| {
            if let Some(rays) = recording.rays.get_mut(tally::place(kind)) {
                *rays += 1;
            }
        });
    }
}
