//! A scene that was proved to fit its number format.

use core::ops::Deref;

use crate::accelerator::{Accelerator, Lists};
use crate::material::Material;
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::scene::{Hit, Limits, Scene};
use crate::world::World;

/// A scene that was proved to fit its number format for one eye, and its accelerator.
#[derive(Clone, Copy, Debug)]
pub struct Admitted<'a, S: Scalar, A = Lists> {
    world: World<'a, S>,
    accelerator: A,
}

impl<'a, S: Scalar, A> Admitted<'a, S, A> {
    /// Returns a scene as admitted without a proof. Nothing checks that a proof was ever made, so this is for generated code,
    /// whose scene was admitted when it was generated, and for owners of an admitted scene. Everybody else calls
    /// [`Scene::admit`].
    pub const fn baked(scene: Scene<'a, S>, limits: Limits<S>, accelerator: A) -> Self {
        Self { world: World { scene, limits }, accelerator }
    }

    /// Returns the scene with other materials, at another wavelength: they differ in nothing that the proof of the scene is about, as
    /// an index of refraction enters no bound of it.
    pub const fn with_materials(&self, materials: &'a [Material<S>]) -> Self
    where
        A: Copy,
    {
        let world = World { scene: Scene { materials, ..self.world.scene }, limits: self.world.limits };
        Self { world, accelerator: self.accelerator }
    }

    /// Returns the accelerator.
    pub const fn accelerator(&self) -> &A {
        &self.accelerator
    }
}

impl<S: Scalar, A: Accelerator<S>> Admitted<'_, S, A> {
    /// Returns the nearest hit of a single ray: see [`Accelerator::closest`].
    pub fn closest<N: Needs>(&self, ray: &Ray<S>) -> Option<Hit<S>> {
        self.accelerator.closest::<N>(&self.world, ray, &mut A::Memory::default())
    }

    /// Returns the part, 0 to 1, of the light of lamp number `lamp` that passes along a single shadow ray of length `t_max`: see
    /// [`Accelerator::transmittance`].
    pub fn transmittance<N: Needs>(&self, ray: &Ray<S>, t_max: S, lamp: usize) -> S::Unit {
        self.accelerator.transmittance::<N>(&self.world, ray, t_max, lamp, &mut A::Memory::default())
    }
}

impl<'a, S: Scalar, A> Deref for Admitted<'a, S, A> {
    type Target = World<'a, S>;
    fn deref(&self) -> &Self::Target {
        &self.world
    }
}
