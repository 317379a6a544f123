//! Pictures whose rays are spread: each sample throws dice of its own.

use super::decision::Start;
use super::dice::{Dice, Sample, Spread, Thrown};
use super::{Observer, Trace, Tracer};
use crate::accelerator::{Accelerator, Lists};
use crate::camera::Camera;
use crate::color::Rgb;
use crate::illumination::Illumination;
use crate::needs::Needs;
use crate::sampling::mapping::disc;
use crate::sampling::pairs::Purpose;
use crate::scalar::vector::{UnitVec3, Vec3};
use crate::scalar::{Scalar, Unit};

/// A tracer whose rays are spread over a lens, over lamps, and over the facets of rough surfaces.
#[derive(Clone, Copy, Debug)]
pub struct Distributed<'a, S: Scalar, M, N, const STACK: usize, A = Lists> {
    /// The tracer.
    pub tracer: Tracer<'a, S, M, N, STACK, A>,
    /// What spreads.
    pub spread: &'a Spread<'a, S>,
    /// The seed, by which pictures of the same scene differ.
    pub seed: u32,
}

impl<S: Scalar, M, N: Needs, const STACK: usize, A> Distributed<'_, S, M, N, STACK, A> {
    /// Returns the dice of a sample.
    pub(super) const fn dice(&self, sample: Sample) -> Thrown<'_, S> {
        Thrown { spread: self.spread, sample, seed: self.seed }
    }

    /// Returns the ray of a sample through a place of the image plane, from the eye or from a spot of the lens.
    pub(super) fn start(
        &self,
        camera: &Camera<S>,
        (right, up): (S::Unit, S::Unit),
        dice: &Thrown<S>,
    ) -> Start<S> {
        match &self.spread.aperture {
            Some(aperture) if N::LENS => {
                let spot = dice.words(Purpose::Lens, <&Thrown<S> as Dice<S>>::EYE);
                camera.through(aperture, (right, up), disc(spot.map(S::Unit::of_word)))
            }
            _ => Start { origin: camera.eye, direction: camera.direction(right, up) },
        }
    }
}

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>> Trace<S>
    for Distributed<'_, S, M, N, STACK, A>
{
    type Memory = A::Memory;
    const SPREADS: bool = true;

    /// As sample 0 of the first pixel.
    fn trace<O: Observer<S> + ?Sized>(
        &self,
        origin: Vec3<S>,
        direction: UnitVec3<S>,
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let dice = self.dice(Sample::default());
        self.tracer.walk(Start { origin, direction }, &dice, memory, observer)
    }

    fn sample<O: Observer<S> + ?Sized>(
        &self,
        camera: &Camera<S>,
        place: (S::Unit, S::Unit),
        sample: Sample,
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let dice = self.dice(sample);
        let start = self.start(camera, place, &dice);
        self.tracer.walk(start, &dice, memory, observer)
    }
}
