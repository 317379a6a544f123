//! An accelerator that is told what a ray meets.

use core::ops::ControlFlow;

use crate::accelerator::Accelerator;
use crate::error::Error;
use crate::needs::Needs;
use crate::range::Admitted;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::scalar::vector::Vec3;
use crate::scene::{Hit, Object, Scene, Visit, index};
use crate::shape::Primitive;
use crate::world::World;

/// An accelerator that can be told which object a ray meets first.
#[derive(Clone, Copy, Debug)]
pub struct Told<A>(A);

impl<A: Copy> Told<A> {
    /// Returns an admitted scene whose accelerator can be told so.
    pub fn of<'a, S: Scalar>(scene: &Admitted<'a, S, A>) -> Admitted<'a, S, Self> {
        Admitted::baked(scene.scene, scene.limits, Self(*scene.accelerator()))
    }
}

/// What [`Told`] keeps from ray to ray.
#[derive(Clone, Copy, Debug, Default)]
pub struct Memory<M> {
    /// What the accelerator itself keeps.
    pub(super) own: M,
    /// The object of the next ray, counted from 1 in the order of [`Scene::each`], 0 for none; nothing if the ray is searched for.
    pub(super) next: Option<u32>,
}

impl<S: Scalar, A: Accelerator<S>> Accelerator<S> for Told<A> {
    type Memory = Memory<A::Memory>;
    const IN_ORDER: bool = A::IN_ORDER;
    const WITH_PLAN: bool = A::WITH_PLAN;

    fn candidates<N: Needs>(
        &self,
        scene: &Scene<'_, S>,
        ray: &Ray<S>,
        visit: &mut impl Visit<S>,
    ) -> ControlFlow<()> {
        self.0.candidates::<N>(scene, ray, visit)
    }

    fn check(&self, scene: &Scene<'_, S>) -> Result<(), Error> {
        self.0.check(scene)
    }

    fn places(&self, see: impl FnMut(Vec3<S>)) {
        self.0.places(see);
    }

    fn closest<N: Needs>(
        &self,
        world: &World<'_, S>,
        ray: &Ray<S>,
        memory: &mut Self::Memory,
    ) -> Option<Hit<S>> {
        match memory.next.take() {
            // Floor and visible lamps are in no list, and are asked as ever.
            Some(number) => Only(number).closest::<N>(world, ray, &mut ()),
            None => self.0.closest::<N>(world, ray, &mut memory.own),
        }
    }

    fn transmittance<N: Needs>(
        &self,
        world: &World<'_, S>,
        ray: &Ray<S>,
        t_max: S,
        lamp: usize,
        memory: &mut Self::Memory,
    ) -> S::Unit {
        self.0.transmittance::<N>(world, ray, t_max, lamp, &mut memory.own)
    }
}

/// The accelerator that knows one object, by its number.
#[derive(Clone, Copy, Debug)]
struct Only(u32);

impl<S: Scalar> Accelerator<S> for Only {
    type Memory = ();
    const IN_ORDER: bool = true;

    fn candidates<N: Needs>(
        &self,
        scene: &Scene<'_, S>,
        _ray: &Ray<S>,
        visit: &mut impl Visit<S>,
    ) -> ControlFlow<()> {
        if self.0 == 0 {
            ControlFlow::Continue(())
        } else {
            scene.each::<N>(&mut Pick { left: self.0, visit })
        }
    }

    fn check(&self, _scene: &Scene<'_, S>) -> Result<(), Error> {
        Ok(())
    }
}

/// A visitor that passes on one object.
struct Pick<'v, V> {
    /// How many objects there are up to it.
    left: u32,
    visit: &'v mut V,
}

impl<S: Scalar, V: Visit<S>> Visit<S> for Pick<'_, V> {
    fn run<P: Primitive<S>>(&mut self, first: Object, run: &[P]) -> ControlFlow<()> {
        let place = self.left - 1;
        match run.get(index(place)) {
            Some(object) => {
                self.visit.run(first.after(place), core::slice::from_ref(object))?;
                ControlFlow::Break(())
            }
            None => {
                // A list has fewer than 2^32 objects.
                self.left -= u32::try_from(run.len()).unwrap_or(place);
                ControlFlow::Continue(())
            }
        }
    }
}
