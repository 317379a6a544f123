//! Pictures whose rays are spread: each sample throws dice of its own.

use super::decision::Start;
use super::dice::{Sample, Spread, Thrown};
use super::{Observer, Trace, Tracer};
use crate::accelerator::{Accelerator, Lists};
use crate::camera::Camera;
use crate::color::Rgb;
use crate::illumination::Illumination;
use crate::needs::Needs;
use crate::sampling::mapping::disc;
use crate::sampling::pairs::Purpose;
use crate::scalar::Scalar;
use crate::scalar::vector::{UnitVec3, Vec3};

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

impl<S: Scalar, M: Illumination<S>, N: Needs, const STACK: usize, A: Accelerator<S>> Trace<S>
    for Distributed<'_, S, M, N, STACK, A>
{
    type Memory = A::Memory;

    /// As sample 0 of the first pixel.
    fn trace<O: Observer<S> + ?Sized>(
        &self,
        origin: Vec3<S>,
        direction: UnitVec3<S>,
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let dice = Thrown { spread: self.spread, sample: Sample::default(), seed: self.seed };
        self.tracer.walk(Start { origin, direction }, &dice, memory, observer)
    }

    fn sample<O: Observer<S> + ?Sized>(
        &self,
        camera: &Camera<S>,
        (right, up): (S::Unit, S::Unit),
        sample: Sample,
        memory: &mut A::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let dice = Thrown { spread: self.spread, sample, seed: self.seed };
        let start = match &self.spread.aperture {
            Some(aperture) => {
                let spot = disc(dice.pairs(Purpose::Lens, 1).units(sample.number));
                camera.through(aperture, (right, up), spot)
            }
            None => Start { origin: camera.eye, direction: camera.direction(right, up) },
        };
        self.tracer.walk(start, &dice, memory, observer)
    }
}
