//! Rows of a picture, with each number format's fastest way through them.

use glam::Vec4;
use rta_core::camera::Camera;
use rta_core::color::Rgb;
use rta_core::illumination::Illumination;
use rta_core::needs::Needs;
use rta_core::raster::{Pixels, Raster};
use rta_core::sampling::Places;
use rta_core::trace::Tracer;

use crate::four::geometry::through_plane;
use crate::four::trace::Trees4;
use crate::number::ToF32;
use crate::packets::Packets;

/// A number format that rows of a picture can be traced in.
pub trait Rows: ToF32 {
    /// Calls `put` with the light of each pixel of the rows from `first` to before `end`, from left to right and from top to
    /// bottom: the light of [`Pixels`].
    fn trace_rows<'a, M: Illumination<Self>, N: Needs, const STACK: usize>(
        tracer: &Tracer<'a, Self, M, N, STACK, &'a Packets>,
        camera: &Camera<Self>,
        (raster, places): (Raster, impl Places),
        (first, end): (u32, u32),
        put: impl FnMut(Rgb<Self::Light>),
    ) {
        Pixels::sampled(tracer, camera, raster, places, first, end).for_each(put);
    }
}

impl Rows for f64 {}
impl Rows for rta_core::Q16 {}
impl Rows for rta_core::Q20 {}

/// Four samples side by side.
impl Rows for f32 {
    fn trace_rows<'a, M: Illumination<f32>, N: Needs, const STACK: usize>(
        tracer: &Tracer<'a, f32, M, N, STACK, &'a Packets>,
        camera: &Camera<f32>,
        (raster, places): (Raster, impl Places),
        (first, end): (u32, u32),
        mut put: impl FnMut(Rgb<f32>),
    ) {
        let mut trees = Trees4::new();
        let samples = places.samples();
        let (mut sum, mut summed) = (Rgb::BLACK, 0);
        for y in first..end.min(raster.height()) {
            let row = places.row::<f32>(raster, y);
            let (mut x, mut sample) = (0, 0);
            while x < raster.width() {
                let (mut right, mut up) = (Vec4::ZERO, Vec4::ZERO);
                let mut count = 0;
                // Samples of one pixel, or of neighbours. Where the row has no more, the last one again.
                let mut place = (0.0, 0.0);
                for k in 0..4 {
                    if x < raster.width() {
                        place = places.place::<f32>(raster, row, x, sample);
                        count += 1;
                        sample += 1;
                        if sample == samples {
                            (x, sample) = (x + 1, 0);
                        }
                    }
                    (right[k], up[k]) = place;
                }
                let directions = through_plane(camera.forward, camera.right, camera.up, right, up);
                let lights = trees.radiance(tracer, camera.eye, directions, count);
                for (light, _) in lights.into_iter().zip(0..count) {
                    sum = places.add(sum, light);
                    summed += 1;
                    if summed == samples {
                        put(places.mean(sum));
                        (sum, summed) = (Rgb::BLACK, 0);
                    }
                }
            }
        }
    }
}
