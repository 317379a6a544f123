//! What meshes among four surfaces send back, which are not shaded by their mixed normals alone.
//!
//! It is apart from what all surfaces run through, so that scenes without meshes do not pay for it.

use core::fmt::Debug;

use rta_core::color::Rgb;
use rta_core::illumination::Illumination;
use rta_core::light::Lamp;
use rta_core::needs::Needs;
use rta_core::trace::decision::casts_shadow_ray;
use rta_core::trace::dice::Dice;

use super::dice::Dice4;
use super::geometry::Ray4;
use super::trace::{Met4, Rays4, Traced, Trees4};
use super::vector::{one, one_mut};
use crate::leaf::Bits;

impl<'a, M: Illumination<f32>, T: Copy + Debug, const STACK: usize> Trees4<'a, M, T, STACK> {
    /// Replaces the ambient light of those that are meshes, of those in `which`.
    #[inline(never)] // scenes without meshes do not pay for it
    pub(super) fn mesh_ambient<N: Needs, D: Dice4<Node = T>>(
        &self,
        tracer: &Traced<'a, M, N, STACK>,
        met: &Met4<D, M::Weight, T>,
        which: u32,
        lights: &mut [Rgb<f32>; 4],
    ) {
        let (scene, model, ..) = tracer.parts();
        for k in Bits(which & self.surfaces.meshed) {
            if let Some(aspects) = self.surfaces.aspects::<N>(met.rays, k) {
                let solved = one(&met.nearest.objects, k).filter(|_| N::RADIOSITY && met.dice.has_solved());
                let surface = self.surfaces.whole(met.rays, k);
                let solved = solved.and_then(|object| met.dice.one(k).arriving(object, &surface));
                let ambient = solved.unwrap_or(scene.scene.ambient);
                *one_mut(lights, k) = aspects.ambient::<M, N>(model, ambient);
            }
        }
    }

    /// Computes what meshes send back of a lamp, of those in `meshes`, and returns which of them cast a shadow ray.
    #[inline(never)]
    pub(super) fn mesh_direct<N: Needs>(
        &self,
        tracer: &Traced<'a, M, N, STACK>,
        lamp: &Lamp<f32>,
        rays: &Ray4,
        meshes: u32,
        (unhidden, lights): (&mut [Rgb<f32>; 4], &mut [Rgb<f32>; 4]),
    ) -> u32 {
        let (_, model, ..) = tracer.parts();
        let mut shadowed = 0;
        for k in Bits(meshes) {
            if let Some(aspects) = self.surfaces.aspects::<N>(rays, k) {
                let light = aspects.direct::<M, N>(model, lamp);
                if casts_shadow_ray::<N, _>(light) {
                    *one_mut(unhidden, k) = light;
                    shadowed |= 1 << k;
                } else {
                    let own = one_mut(lights, k);
                    *own = own.plus(light);
                }
            }
        }
        shadowed
    }

    /// Spawns the secondary rays of those in `which`, all of them meshes.
    #[inline(never)]
    pub(super) fn spawn_meshes<N: Needs, D: Dice4<Node = T>>(
        &mut self,
        tracer: &Traced<'a, M, N, STACK>,
        rays: &Ray4,
        which: u32,
        parents_and_lights: (&mut Rays4<M::Weight, T>, &mut [Rgb<f32>; 4]),
    ) -> u32 {
        self.spawn::<N, D, true>(tracer, rays, which, parents_and_lights)
    }
}
