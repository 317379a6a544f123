//! How a scene is searched: by the hierarchy of machines without a heap, or one object after the other.
//!
//! Both behind one type, so that there is one tracer for each number format.

use core::ops::ControlFlow;

use rta_core::accelerator::{Accelerator, Bvh, Lists};
use rta_core::needs::Needs;
use rta_core::ray::Ray;
use rta_core::scene::{Scene, Visit};
use rta_core::vector::Vec3;
use rta_core::{Error, Scalar};

/// A way of searching that is chosen when a scene is known.
#[derive(Clone, Copy, Debug)]
pub enum Search<'a, S: Scalar> {
    /// One object after the other.
    Lists,
    /// By a hierarchy.
    Hierarchy(Bvh<'a, S>),
}

impl<S: Scalar> Accelerator<S> for Search<'_, S> {
    type Memory = ();
    const IN_ORDER: bool = false;

    fn candidates<N: Needs>(
        &self,
        scene: &Scene<'_, S>,
        ray: &Ray<S>,
        visit: &mut impl Visit<S>,
    ) -> ControlFlow<()> {
        match self {
            Self::Lists => Lists.candidates::<N>(scene, ray, visit),
            Self::Hierarchy(bvh) => bvh.candidates::<N>(scene, ray, visit),
        }
    }

    fn check(&self, scene: &Scene<'_, S>) -> Result<(), Error> {
        match self {
            Self::Lists => Accelerator::<S>::check(&Lists, scene),
            Self::Hierarchy(bvh) => bvh.check(scene),
        }
    }

    fn places(&self, see: impl FnMut(Vec3<S>)) {
        match self {
            Self::Lists => {}
            Self::Hierarchy(bvh) => bvh.places(see),
        }
    }
}
