//! How a scene is searched: a type, chosen for a program like its number format.
//!
//! [`Lists`] asks one object after the other and is right for some dozen of them. [`Bvh`] is a hierarchy that is made ahead.
//! A program for a larger machine brings its own: it implements [`Accelerator::candidates`], and where it is faster also
//! the other two methods. Whatever is used, the picture is the same to the last bit.

pub mod bvh;
mod closest;
mod transmittance;

use core::ops::ControlFlow;

pub use bvh::{Bvh, Node};
use closest::Closest;
pub use transmittance::{Filters, transmitted};

use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::vector::Vec3;
use crate::scalar::{Scalar, Unit};
use crate::scene::{Hit, Scene, Visit};
use crate::world::World;

/// A way of searching a scene. One method is required; a faster machine overrides others.
pub trait Accelerator<S: Scalar>: Copy + Send + Sync {
    /// What is kept from ray to ray, such as the last occluder of each lamp; `()` where nothing is.
    type Memory: Default;
    /// Whether [`Accelerator::candidates`] come in order of [`Object`](crate::scene::Object). Where they do not, equally
    /// near hits are told apart by that order, which costs a comparison.
    const IN_ORDER: bool;
    /// Whether rays come with a [`GroundPlan`](crate::ray::GroundPlan) where the scene has vertical cylinders. An accelerator
    /// that seldom asks them makes it when it does.
    const WITH_PLAN: bool = true;

    /// Shows `visit` at least the objects of the lists that the ray meets nearer than [`Visit::t_max`], until it has seen
    /// enough.
    fn candidates<N: Needs>(
        &self,
        scene: &Scene<'_, S>,
        ray: &Ray<S>,
        visit: &mut impl Visit<S>,
    ) -> ControlFlow<()>;

    /// Returns the first thing that is wrong with it as an accelerator of this scene: it does not lead on, does not end, does
    /// not name each object once, or (as far as that can be told) does not contain one. Asked on admission.
    ///
    /// # Errors
    /// The number of the node that is wrong.
    fn check(&self, scene: &Scene<'_, S>) -> Result<(), WrongNode>;

    /// Calls `see` with each place, besides eye, objects and lamps, that rays are measured from.
    fn places(&self, _see: impl FnMut(Vec3<S>)) {}

    /// Returns the nearest hit of a ray, if it meets anything; of what is equally near, the first in order of
    /// [`Object`](crate::scene::Object).
    fn closest<N: Needs>(
        &self,
        world: &World<'_, S>,
        ray: &Ray<S>,
        _memory: &mut Self::Memory,
    ) -> Option<Hit<S>> {
        let floor = world.floor::<N>(ray);
        if Self::IN_ORDER {
            let mut closest = Closest::<_, true>::new(ray, floor);
            let _ = self.candidates::<N>(&world.scene, ray, &mut closest);
            closest.with_lamps::<N>(world.scene.lamps)
        } else {
            let mut closest = Closest::<_, false>::new(ray, floor);
            let _ = self.candidates::<N>(&world.scene, ray, &mut closest);
            closest.with_lamps::<N>(world.scene.lamps)
        }
    }

    /// Returns what part of the light of lamp number `lamp` comes through along a shadow ray that ends at `t_max`: 0 behind
    /// anything that is not transparent, else the product of kt over the transparent objects on the way, once for each,
    /// multiplied in order of [`Object`](crate::scene::Object), as rounding depends on it.
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

/// A node of an accelerator that is wrong, by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrongNode(pub usize);

/// One object after the other, list by list.
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

    fn check(&self, _scene: &Scene<'_, S>) -> Result<(), WrongNode> {
        Ok(())
    }
}
