//! The rays that solving takes.

use core::ops::ControlFlow;
use core::sync::atomic::{AtomicU64, Ordering};

use rta_core::accelerator::Accelerator;
use rta_core::needs::Needs;
use rta_core::ray::Ray;
use rta_core::scene::{Hit, Scene, Visit};
use rta_core::vector::Vec3;
use rta_core::world::World;
use rta_core::{Error, Scalar};

/// A way of searching that counts the rays it is asked for, on one thread.
#[derive(Clone, Copy, Debug)]
pub(super) struct Counted<'a, A> {
    /// How the scene is searched.
    pub(super) search: A,
    /// Rays so far.
    pub(super) rays: &'a AtomicU64,
}

impl<A> Counted<'_, A> {
    fn count(&self) {
        // Nobody else writes, so that no exchange is needed.
        self.rays.store(self.rays.load(Ordering::Relaxed) + 1, Ordering::Relaxed);
    }
}

impl<S: Scalar, A: Accelerator<S>> Accelerator<S> for Counted<'_, A> {
    type Memory = A::Memory;
    const IN_ORDER: bool = A::IN_ORDER;
    const WITH_PLAN: bool = A::WITH_PLAN;

    fn candidates<N: Needs>(
        &self,
        scene: &Scene<'_, S>,
        ray: &Ray<S>,
        visit: &mut impl Visit<S>,
    ) -> ControlFlow<()> {
        self.search.candidates::<N>(scene, ray, visit)
    }

    fn check(&self, scene: &Scene<'_, S>) -> Result<(), Error> {
        self.search.check(scene)
    }

    fn places(&self, see: impl FnMut(Vec3<S>)) {
        self.search.places(see);
    }

    fn closest<N: Needs>(
        &self,
        world: &World<'_, S>,
        ray: &Ray<S>,
        memory: &mut A::Memory,
    ) -> Option<Hit<S>> {
        self.count();
        self.search.closest::<N>(world, ray, memory)
    }

    fn transmittance<N: Needs>(
        &self,
        world: &World<'_, S>,
        ray: &Ray<S>,
        t_max: S,
        lamp: usize,
        memory: &mut A::Memory,
    ) -> S::Unit {
        self.count();
        self.search.transmittance::<N>(world, ray, t_max, lamp, memory)
    }
}
