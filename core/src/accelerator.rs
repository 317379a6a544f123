//! How a scene is searched for hits. A program chooses the accelerator as a type, like its number format.
//!
//! [`Lists`] tests one object after the other and suits some dozen of them. [`Bvh`] is a bounding volume hierarchy that is
//! built ahead. A program for a larger machine can bring its own, which implements [`Accelerator::candidates`] and may override
//! [`Accelerator::closest`] and [`Accelerator::transmittance`]. With each of them the picture is equal to the last bit.

pub mod bvh;
mod closest;
mod transmittance;

use core::ops::ControlFlow;

pub use bvh::{Bvh, Node};
pub use closest::{Closest, STEEPEST, is_flat};
pub use transmittance::{Filters, transmitted};

use crate::error::Error;
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::vector::Vec3;
use crate::scalar::{Scalar, Unit};
use crate::scene::{Hit, Scene, Visit};
use crate::world::World;

/// A way of searching a scene for the objects that a ray meets.
pub trait Accelerator<S: Scalar>: Copy + Send + Sync {
    /// What is kept from ray to ray, such as the last occluder of each lamp; `()` where nothing is.
    type Memory: Default;
    /// Whether [`Accelerator::candidates`] come in order of [`Object`](crate::scene::Object). Where they do not, the transparent
    /// objects in the way of a shadow ray have to be sorted.
    const IN_ORDER: bool;
    /// Whether the tracer gives rays a [`GroundPlan`](crate::ray::GroundPlan) where the scene has vertical cylinders. An
    /// accelerator that seldom tests cylinders sets this to false and adds the plan itself.
    const WITH_PLAN: bool = true;

    /// Passes to `visit` at least those objects of the lists that the ray meets nearer than [`Visit::t_max`]. Returns `Break`
    /// as soon as `visit` does.
    fn candidates<N: Needs>(
        &self,
        scene: &Scene<'_, S>,
        ray: &Ray<S>,
        visit: &mut impl Visit<S>,
    ) -> ControlFlow<()>;

    /// Checks, when a scene is admitted, that this accelerator belongs to it: that the walk ends, that each object is named once,
    /// and, as far as that can be told, that nodes contain their objects.
    ///
    /// # Errors
    /// [`Error::Hierarchy`] with the number of the first node that is wrong.
    fn check(&self, scene: &Scene<'_, S>) -> Result<(), Error>;

    /// Calls `see` with each further place, such as a node's centre, whose distance from a ray's origin is computed.
    fn places(&self, _see: impl FnMut(Vec3<S>)) {}

    /// Returns the nearest hit of a ray, if there is one; of several surfaces at one place, the first in order of
    /// [`Object`](crate::scene::Object), as [`Closest`] tells it.
    fn closest<N: Needs>(
        &self,
        world: &World<'_, S>,
        ray: &Ray<S>,
        _memory: &mut Self::Memory,
    ) -> Option<Hit<S>> {
        closest::closest::<S, N, _>(self, &world.scene, ray, world.floor::<N>(ray))
    }

    /// Returns the part, 0 to 1, of the light of lamp number `lamp` that passes along a shadow ray of length `t_max`: 0 where an
    /// opaque object is in the way, else the product of kt over the transparent objects in the way. The factors are multiplied
    /// in order of [`Object`](crate::scene::Object), on which the rounding depends.
    fn transmittance<N: Needs>(
        &self,
        world: &World<'_, S>,
        ray: &Ray<S>,
        t_max: S,
        _lamp: usize,
        _memory: &mut Self::Memory,
    ) -> S::Unit {
        let part = transmittance::through::<S, N, _>(self, world, ray, t_max);
        let is_open = part > S::Unit::ZERO && !world.floor::<N>(ray).is_some_and(|t| t < t_max);
        if is_open { part } else { S::Unit::ZERO }
    }
}

/// The accelerator that tests one object after the other, list by list.
#[derive(Clone, Copy, Debug, Default)]
pub struct Lists;

impl<S: Scalar> Accelerator<S> for Lists {
    type Memory = ();
    const IN_ORDER: bool = true;

    fn candidates<N: Needs>(
        &self,
        scene: &Scene<'_, S>,
        _ray: &Ray<S>,
        visit: &mut impl Visit<S>,
    ) -> ControlFlow<()> {
        scene.each::<N>(visit)
    }

    fn check(&self, _scene: &Scene<'_, S>) -> Result<(), Error> {
        Ok(())
    }
}
