//! How four ray trees look for what their rays meet: in rooms of flat triangles one ray after the other, in a search of their own, else together.

use core::fmt::Debug;

use glam::Vec4;
use rta_core::Scalar;
use rta_core::accelerator::Accelerator;
use rta_core::illumination::Illumination;
use rta_core::needs::Needs;
use rta_core::range::Admitted;
use rta_core::scene::Object;

use super::closest::Hits4;
use super::geometry::Ray4;
use super::path::is_flat;
use super::trace::Trees4;
use super::vector::{lane, one_mut, set};
use crate::flat::{FlatSearch, Nearest, Ready4};
use crate::leaf::Bits;
use crate::packets::Packets;

impl<'a, M: Illumination<f32>, T: Copy + Debug, const STACK: usize> Trees4<'a, M, T, STACK> {
    /// Prepares for a scene with these needs.
    pub(crate) fn prepare<N: Needs>(&mut self, world: &'a Admitted<'a, f32, &'a Packets>) {
        self.flat = if is_flat::<N>() { FlatSearch::new(world.accelerator()) } else { None };
    }

    /// Returns the nearest hits of four rays, see [`Packets::closest_four`].
    #[inline(always)]
    pub(super) fn closest<N: Needs>(
        &mut self,
        world: &'a Admitted<'a, f32, &'a Packets>,
        rays: &Ray4,
        (there, are_eyes): (u32, bool),
    ) -> Hits4 {
        let packets = *world.accelerator();
        let Some(flat) = self.flat.as_mut().filter(|_| is_flat::<N>()) else {
            return packets.closest_four::<N>(world, rays, (there, are_eyes), &mut self.cache);
        };
        let ready = Ready4::new(rays, packets);
        let mut hits = Hits4 { distance: Vec4::splat(f32::FAR), objects: [None; 4] };
        for k in Bits(there) {
            match flat.nearest(&ready, k, are_eyes) {
                Nearest::Nothing => {}
                Nearest::Triangle(number, distance) => {
                    set(&mut hits.distance, k, distance);
                    *one_mut(&mut hits.objects, k) = Some(Object::Triangle(number));
                }
                Nearest::Unknown => hits.set(k, packets.closest::<N>(world, &rays.lane(k), &mut self.cache)),
            }
        }
        hits
    }

    /// Returns what comes through along four shadow rays, see [`Packets::transmittance_four`].
    #[inline(always)]
    pub(super) fn transmittance<N: Needs>(
        &mut self,
        world: &'a Admitted<'a, f32, &'a Packets>,
        (rays, t_max, there): (&Ray4, Vec4, u32),
        lamp: usize,
    ) -> [f32; 4] {
        let packets = *world.accelerator();
        let Some(flat) = self.flat.as_mut().filter(|_| is_flat::<N>()) else {
            return packets.transmittance_four::<N>(world, (rays, t_max, there), lamp, &mut self.cache);
        };
        let ready = Ready4::new(rays, packets);
        let mut parts = [1.0; 4];
        for k in Bits(there) {
            let length = lane(&t_max, k);
            *one_mut(&mut parts, k) = match flat.is_open(&ready, k, length) {
                Some(is_open) => f32::from(u8::from(is_open)),
                None => packets.transmittance::<N>(world, &rays.lane(k), length, lamp, &mut self.cache),
            };
        }
        parts
    }
}
