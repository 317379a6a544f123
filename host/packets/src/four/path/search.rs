//! How the rays of paths are searched for.

use rta_core::accelerator::Accelerator;
use rta_core::needs::Needs;
use rta_core::ray::Ray;
use rta_core::scene::Object;
use rta_core::world::World;

use crate::cache::ShadowCache;
use crate::flat::FlatSearch;
use crate::packets::Packets;

/// What rays are searched for by.
pub(crate) struct Search<'a> {
    pub(super) flat: FlatSearch<'a>,
    cache: ShadowCache,
}

impl<'a> Search<'a> {
    /// Returns a search; `None` where not all is triangles.
    pub(super) fn new(packets: &'a Packets) -> Option<Self> {
        Some(Self { flat: FlatSearch::new(packets)?, cache: ShadowCache::default() })
    }

    /// Returns the triangle that a ray meets first, which is not searched for among flat triangles alone.
    #[inline(never)] // hardly any
    pub(super) fn closest<N: Needs>(&mut self, world: &World<'_, f32>, ray: &Ray<f32>) -> Option<u32> {
        match self.flat.packets().closest::<N>(world, ray, &mut self.cache)?.object {
            Object::Triangle(i) => Some(i),
            _ => None,
        }
    }

    /// Returns what part of a lamp's light comes through along a ray, likewise.
    #[inline(never)] // hardly any
    pub(super) fn transmittance<N: Needs>(
        &mut self,
        world: &World<'_, f32>,
        (ray, t_max): (&Ray<f32>, f32),
        lamp: usize,
    ) -> f32 {
        self.flat.packets().transmittance::<N>(world, ray, t_max, lamp, &mut self.cache)
    }
}
