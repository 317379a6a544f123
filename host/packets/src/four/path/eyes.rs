//! The rays of samples from the eye, four at once.

use glam::Vec3;
use rta_core::camera::Camera;
use rta_core::raster::Raster;
use rta_core::trace::dice::{Sample, Spread};

use crate::four::dice::Thrown4;
use crate::four::geometry::Ray4;
use crate::four::vector::{Vec3x4, one};

/// The rays of samples from the eye.
pub(super) struct Eyes<'s> {
    spread: &'s Spread<'s, f32>,
    seed: u32,
    seen: (&'s Camera<f32>, Raster),
    samples: &'s mut dyn Iterator<Item = Sample>,
    /// The samples that are made ready, those of them that have not begun, and their rays.
    ready: [Sample; 4],
    next: usize,
    count: usize,
    rays: Ray4,
}

impl<'s> Eyes<'s> {
    /// Returns the rays of some samples on a raster, whose rays are spread by a seed.
    pub(super) fn new(
        (spread, seed): (&'s Spread<'s, f32>, u32),
        seen: (&'s Camera<f32>, Raster),
        samples: &'s mut dyn Iterator<Item = Sample>,
    ) -> Self {
        let rays = Ray4 { origin: Vec3x4::ZERO, direction: Vec3x4::ZERO };
        Self { spread, seed, seen, samples, ready: [Sample::default(); 4], next: 0, count: 0, rays }
    }

    /// Makes the next four ready.
    #[inline(never)] // one time of four
    fn prepare(&mut self) {
        (self.next, self.count) = (0, 0);
        let mut last = Sample::default();
        for place in &mut self.ready {
            if let Some(sample) = self.samples.next() {
                (last, self.count) = (sample, self.count + 1);
            }
            *place = last;
        }
        if self.count > 0 {
            let (camera, raster) = self.seen;
            self.rays = Thrown4::new(self.spread, self.ready, self.seed).start(camera, raster);
        }
    }

    /// Returns the next sample with its ray, if there is one.
    #[inline(always)]
    pub(super) fn next(&mut self) -> Option<(Sample, (Vec3, Vec3))> {
        if self.next == self.count {
            self.prepare();
        }
        let k = self.next;
        if k == self.count {
            return None;
        }
        self.next += 1;
        Some((one(&self.ready, k), (self.rays.origin.lane(k), self.rays.direction.lane(k))))
    }
}
