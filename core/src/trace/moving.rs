//! Pictures of scenes in which something moves while the shutter is open: each sample is the scene at an instant of its own.
//!
//! Everything moves along straight lines and does not turn, so that whatever is as far apart at both ends as the number format can hold is
//! so in between: a proof of the scene at both ends is one of all instants.

use core::marker::PhantomData;

use super::decision::Start;
use super::dice::{Dice, Sample, Thrown};
use super::distributed::Distributed;
use super::{Observer, Trace, Tracer};
use crate::accelerator::Accelerator;
use crate::camera::Camera;
use crate::color::Rgb;
use crate::illumination::Illumination;
use crate::needs::Needs;
use crate::range::Admitted;
use crate::sampling::pairs::Purpose;
use crate::scalar::vector::{UnitVec3, Vec3, Vector};
use crate::scalar::{Scalar, Unit};
use crate::scene::{Copies, Object, Scene};

/// How an object or a lamp moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<S: Scalar> {
    /// What moves.
    pub object: Object,
    /// How far it moves while the shutter is open: half of it before it is where it is in the scene, and half of it after that.
    pub by: Vec3<S>,
}

impl<S: Scalar> Motion<S> {
    /// Puts what moves where it is at an instant, from -1/2, when the shutter opens, to 1/2. `scene` is as it is in the middle of the time.
    pub fn put(&self, copies: &mut Copies<S>, scene: &Scene<S>, time: S::Unit) {
        copies.put(self.object, scene, moved::<S>(self.by, time));
    }
}

/// Returns how far something is at an instant from where it is in the middle of the time, for how far it moves in all.
pub fn moved<S: Scalar>(by: Vec3<S>, time: S::Unit) -> Vec3<S> {
    Vec3::<S>::new(by.x().scale(time), by.y().scale(time), by.z().scale(time))
}

/// The memory of the copies of lists in which something moves.
pub trait Room<S: Scalar>: Default {
    /// Returns copies of the lists of a scene in which something moves, as they are in the scene or as they were left, and nothing in place of
    /// the others.
    fn copies<'c>(&'c mut self, scene: &Scene<S>, motions: &[Motion<S>]) -> Copies<'c, S>;
}

/// A tracer of a scene in which something moves. `R` is the memory of what moves.
#[derive(Clone, Copy, Debug)]
pub struct Moving<'a, S: Scalar, M, N, const STACK: usize, A, R> {
    /// The tracer of the scene as it is in the middle of the time, and what spreads besides.
    pub still: Distributed<'a, S, M, N, STACK, A>,
    /// What moves.
    pub motions: &'a [Motion<S>],
    /// The memory, which each thread has for itself.
    pub room: PhantomData<fn() -> R>,
}

/// What is kept from ray to ray.
#[derive(Debug, Default)]
pub struct Memory<M, R> {
    accelerator: M,
    room: R,
}

impl<S, M, N, const STACK: usize, A, R> Moving<'_, S, M, N, STACK, A, R>
where
    S: Scalar,
    M: Illumination<S> + Clone,
    N: Needs,
    A: Accelerator<S>,
    R: Room<S>,
{
    /// Calls `trace` with the scene as it is at an instant: see [`Motion::put`].
    fn at<T>(
        &self,
        time: S::Unit,
        room: &mut R,
        trace: impl FnOnce(&Tracer<'_, S, M, N, STACK, A>) -> T,
    ) -> Option<T> {
        let (admitted, model, depth, cutoff) = self.still.tracer.parts();
        let scene = &admitted.scene;
        let mut copies = room.copies(scene, self.motions);
        for motion in self.motions {
            motion.put(&mut copies, scene, time);
        }
        let frozen = Admitted::baked(scene.with(&copies), admitted.limits, *admitted.accelerator());
        let tracer = Tracer::new(&frozen, model.clone(), depth.into()).ok()?.with_cutoff(cutoff);
        Some(trace(&tracer))
    }
}

impl<S, M, N, const STACK: usize, A, R> Trace<S> for Moving<'_, S, M, N, STACK, A, R>
where
    S: Scalar,
    M: Illumination<S> + Clone,
    N: Needs,
    A: Accelerator<S>,
    R: Room<S>,
{
    type Memory = Memory<A::Memory, R>;
    const SPREADS: bool = true;

    /// As sample 0 of the first pixel, in the middle of the time.
    fn trace<O: Observer<S> + ?Sized>(
        &self,
        origin: Vec3<S>,
        direction: UnitVec3<S>,
        memory: &mut Self::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let dice = self.still.dice(Sample::default());
        let start = Start { origin, direction };
        let Memory { accelerator, room } = memory;
        let light = self.at(S::Unit::ZERO, room, |tracer| tracer.walk(start, &dice, accelerator, observer));
        light.unwrap_or(Rgb::BLACK)
    }

    fn sample<O: Observer<S> + ?Sized>(
        &self,
        camera: &Camera<S>,
        place: (S::Unit, S::Unit),
        sample: Sample,
        memory: &mut Self::Memory,
        observer: &mut O,
    ) -> Rgb<S::Light> {
        let dice = self.still.dice(sample);
        let [time, _] = dice.words(Purpose::Time, <&Thrown<S> as Dice<S>>::EYE);
        let time = S::Unit::of_word(time) - S::Unit::of_word(1 << 31);
        let mut start = self.still.start(camera, place, &dice);
        if N::EYE_MOTION
            && let Some(by) = self.still.spread.eye
        {
            start.origin = start.origin + moved::<S>(by, time);
        }
        let Memory { accelerator, room } = memory;
        let light = self.at(time, room, |tracer| tracer.walk(start, &dice, accelerator, observer));
        light.unwrap_or(Rgb::BLACK)
    }
}

#[cfg(test)]
#[cfg(feature = "f64")]
mod tests {
    use super::*;
    use crate::accelerator::Lists;
    use crate::camera::Lens;
    use crate::illumination::Flat;
    use crate::needs::Everything;
    use crate::scalar::Light;
    use crate::scalar::vector::UnitVector;
    use crate::scene::{PLAIN, Sky};
    use crate::shape::Sphere;
    use crate::trace::dice::Spread;
    use crate::{Q16, Q20};

    /// Room for one sphere.
    struct One<S: Scalar>([Sphere<S>; 1]);

    impl<S: Scalar> Default for One<S> {
        fn default() -> Self {
            Self([ball::<S>([0, 0, 0], 0)])
        }
    }

    impl<S: Scalar> Room<S> for One<S> {
        fn copies<'c>(&'c mut self, _scene: &Scene<S>, _motions: &[Motion<S>]) -> Copies<'c, S> {
            Copies { spheres: &mut self.0, ..Copies::none() }
        }
    }

    /// A length in halves.
    fn halves<S: Scalar>(n: i32) -> S {
        S::of_lattice(n << 15)
    }

    fn vector<S: Scalar>(halves: [i32; 3]) -> Vec3<S> {
        let [x, y, z] = halves.map(self::halves::<S>);
        Vec3::<S>::new(x, y, z)
    }

    fn ball<S: Scalar>(center: [i32; 3], color: i64) -> Sphere<S> {
        let color = S::Unit::ratio(color, 1);
        Sphere::new(vector::<S>(center), halves::<S>(2), Rgb::new(color, color, color), PLAIN)
    }

    /// Returns the part of the time that a white ball is seen along y, by 32 seeds of 64 samples, and its standard error.
    fn seen<S: Scalar>(center: [i32; 3], by: [i32; 3]) -> [f64; 2] {
        // In the middle of the time.
        let ([x, y, z], [east, north, upward]) = (center, by);
        let spheres = [ball::<S>([x + east / 2, y + north / 2, z + upward / 2], 1)];
        let black = Rgb::BLACK;
        let scene = Scene { spheres: &spheres, ..Scene::empty(Sky { horizon: black, zenith: black }, black) };
        let lens = Lens::new(1, 1, (1, 1));
        let camera = Camera::new(vector::<S>([0; 3]), UnitVec3::<S>::Y, lens);
        let admitted = scene.admit_with(&camera, Lists).expect("it is small");
        let tracer: Tracer<'_, S, _, Everything, 1, _> = Tracer::new(&admitted, Flat, 0).expect("not deep");
        let motions = [Motion { object: Object::Sphere(0), by: vector::<S>(by) }];
        let mut sums = [0.0; 2];
        for seed in 0..32 {
            let still = Distributed { tracer, spread: &Spread::NONE, seed };
            let moving = Moving { still, motions: &motions, room: PhantomData::<fn() -> One<S>> };
            let mut memory = Memory::default();
            let mut part = 0.0;
            for number in 0..64 {
                let place = (S::Unit::ZERO, S::Unit::ZERO);
                let own = Sample { x: 1, y: 2, number };
                let light = moving.sample(&camera, place, own, &mut memory, &mut ());
                part += if light.r >= S::Light::WHITE { 1.0 / 64.0 } else { 0.0 };
            }
            sums = [sums[0] + part, sums[1] + part * part];
        }
        let mean = sums[0] / 32.0;
        [mean, libm::sqrt((sums[1] / 32.0 - mean * mean).max(0.0) / 31.0)]
    }

    #[test]
    fn moving_balls_are_seen_as_long_as_they_should_be() {
        let cases = [
            ([-4, 16, 0], [8, 0, 0], 0.5),
            ([-4, 16, 1], [8, 0, 0], 0.433_012_702),
            ([-1, 16, 0], [4, 6, 0], 0.75),
            ([0, 16, 0], [0, 10, 0], 1.0),
        ];
        for (center, by, exact) in cases {
            for [part, error] in [
                seen::<f64>(center, by),
                seen::<f32>(center, by),
                seen::<Q16>(center, by),
                seen::<Q20>(center, by),
            ] {
                assert!((part - exact).abs() <= 5.0 * error + 1e-3, "{center:?} {by:?}: {part}, {exact}");
            }
        }
    }
}
