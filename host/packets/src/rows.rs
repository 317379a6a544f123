//! Rows of a picture, with each number format's fastest way through them.

use core::ops::Range;

use glam::Vec4;
use rta_core::camera::Camera;
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Lambert};
use rta_core::needs::Needs;
use rta_core::raster::{Pixels, Raster};
use rta_core::sampling::{Center, Places, Sobol};
use rta_core::scalar::Scalar;
use rta_core::trace::dice::Sample;
use rta_core::trace::{Distributed, Paths, Trace, Tracer};
use rta_scenes::sampler::Sampler;

use crate::cache::ShadowCache;
use crate::four::dice::{Still4, Thrown4};
use crate::four::geometry::{Ray4, through_plane};
use crate::four::path;
use crate::four::trace::Trees4;
use crate::four::vector::Vec3x4;
use crate::number::ToF32;
use crate::packets::Packets;

/// What takes the light of a row of pixels.
pub type PutRow<'a, S> = &'a mut dyn FnMut(&[Rgb<<S as Scalar>::Light>]);

/// Samples of some pixels, by their columns and rows, with the same numbers in each: pixel by pixel, in the order of their numbers.
#[derive(Clone, Debug)]
pub struct Samples<I> {
    pixels: I,
    numbers: Range<u32>,
    next: Sample,
}

impl<I: Iterator<Item = [u32; 2]>> Samples<I> {
    /// Returns the samples with these numbers.
    pub fn new(pixels: I, numbers: Range<u32>) -> Self {
        let next = Sample { number: numbers.end, ..Sample::default() };
        Self { pixels, numbers, next }
    }
}

impl<I: Iterator<Item = [u32; 2]>> Iterator for Samples<I> {
    type Item = Sample;

    #[inline]
    fn next(&mut self) -> Option<Sample> {
        if self.next.number >= self.numbers.end {
            let [x, y] = self.pixels.next().filter(|_| !self.numbers.is_empty())?;
            self.next = Sample { x, y, number: self.numbers.start };
        }
        let sample = self.next;
        self.next.number += 1;
        Some(sample)
    }
}

/// Calls `put` with the light of each of the rows from `first` to before `end`, as far as the raster has them.
pub(crate) fn put_rows<S: Scalar, T: Trace<S>>(
    tracer: &T,
    camera: &Camera<S>,
    (raster, places): (Raster, impl Places),
    (first, end): (u32, u32),
    put: PutRow<S>,
) {
    for y in first..end.min(raster.height()) {
        put(&Pixels::sampled(tracer, camera, raster, places, y, y + 1).collect::<Vec<_>>());
    }
}

/// A number format that rows of a picture can be traced in.
pub trait Rows: ToF32 {
    /// Calls `put` with the light of each pixel of the rows from `first` to before `end`, from left to right and from top to
    /// bottom: the light of [`Pixels`].
    fn trace_rows<'a, M: Illumination<Self>, N: Needs, const STACK: usize>(
        tracer: &Tracer<'a, Self, M, N, STACK, &'a Packets>,
        camera: &Camera<Self>,
        (raster, sampling): (Raster, Sampler),
        (first, end): (u32, u32),
        put: impl FnMut(Rgb<Self::Light>),
    ) {
        Pixels::sampled(tracer, camera, raster, sampling, first, end).for_each(put);
    }

    /// Calls `put` with the light of each of some samples, in their order, at the `places` of their pixels on `raster`, from a tracer whose rays are
    /// spread: the light of [`Trace::sample`].
    fn trace_samples<'a, M: Illumination<Self>, N: Needs, const STACK: usize>(
        tracer: &Distributed<'a, Self, M, N, STACK, &'a Packets>,
        camera: &Camera<Self>,
        (raster, places): (Raster, Sobol),
        samples: Samples<impl Iterator<Item = [u32; 2]>>,
        mut put: impl FnMut(Rgb<Self::Light>),
    ) {
        let mut cache = ShadowCache::default();
        for sample in samples {
            let Sample { x, y, number } = sample;
            let place = places.place::<Self::Unit>(raster, y, x, number);
            put(tracer.sample(camera, place, sample, &mut cache, &mut ()));
        }
    }

    /// Calls `put` with the light of the path of each of some samples, in their order, at the `places` of their pixels on `raster`, in a scene of
    /// diffuse surfaces: the light of [`Trace::sample`].
    fn follow_diffuse<'a, N: Needs>(
        tracer: &Paths<'a, Self, Lambert<'static, Self>, N, 1, &'a Packets>,
        camera: &Camera<Self>,
        (raster, places): (Raster, Sobol),
        samples: &mut dyn Iterator<Item = Sample>,
        put: &mut dyn FnMut(Rgb<Self::Light>),
    ) {
        follow(tracer, camera, (raster, places), samples, put);
    }
}

/// Calls `put` with the light of the path of each of some samples, one after the other.
pub(crate) fn follow<'a, S: ToF32, M: Illumination<S>, N: Needs>(
    tracer: &Paths<'a, S, M, N, 1, &'a Packets>,
    camera: &Camera<S>,
    (raster, places): (Raster, Sobol),
    samples: &mut dyn Iterator<Item = Sample>,
    put: &mut dyn FnMut(Rgb<S::Light>),
) {
    let mut cache = ShadowCache::default();
    for sample in samples {
        let Sample { x, y, number } = sample;
        let place = places.place::<S::Unit>(raster, y, x, number);
        put(tracer.sample(camera, place, sample, &mut cache, &mut ()));
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
        (raster, sampling): (Raster, Sampler),
        (first, end): (u32, u32),
        mut put: impl FnMut(Rgb<f32>),
    ) {
        let mut trees = Trees4::new();
        let samples = sampling.samples();
        // The same places and the same light either way; this one is quicker (5 % of the instructions of a simple scene).
        let is_center = sampling == Sampler::CENTER;
        let (mut sum, mut summed) = (Rgb::BLACK, 0);
        for y in first..end.min(raster.height()) {
            let (row, middle) = (sampling.row::<f32>(raster, y), Center.row::<f32>(raster, y));
            let (mut x, mut sample) = (0, 0);
            while x < raster.width() {
                let (mut right, mut up) = (Vec4::ZERO, Vec4::ZERO);
                let mut count = 0;
                // Samples of one pixel, or of neighbours. Where the row has no more, the last one again.
                let mut place = (0.0, 0.0);
                for k in 0..4 {
                    if x < raster.width() {
                        count += 1;
                        if is_center {
                            place = Center.place::<f32>(raster, middle, x, 0);
                            x += 1;
                        } else {
                            place = sampling.place::<f32>(raster, row, x, sample);
                            sample += 1;
                            if sample == samples {
                                (x, sample) = (x + 1, 0);
                            }
                        }
                    }
                    (right[k], up[k]) = place;
                }
                let direction = through_plane(camera.forward, camera.right, camera.up, right, up);
                let rays = Ray4 { origin: Vec3x4::splat(camera.eye), direction };
                let lights = trees.radiance(tracer, rays, &Still4, count);
                for (light, _) in lights.into_iter().zip(0..count) {
                    if is_center {
                        put(light);
                        continue;
                    }
                    sum = sampling.add(sum, light);
                    summed += 1;
                    if summed == samples {
                        put(sampling.mean(sum));
                        (sum, summed) = (Rgb::BLACK, 0);
                    }
                }
            }
        }
    }

    fn trace_samples<'a, M: Illumination<f32>, N: Needs, const STACK: usize>(
        tracer: &Distributed<'a, f32, M, N, STACK, &'a Packets>,
        camera: &Camera<f32>,
        (raster, places): (Raster, Sobol),
        mut samples: Samples<impl Iterator<Item = [u32; 2]>>,
        mut put: impl FnMut(Rgb<f32>),
    ) {
        debug_assert_eq!(places.seed(), tracer.seed, "places and rays are spread by one seed");
        let mut trees = Trees4::new();
        trees.prepare::<N>(tracer.tracer.parts().0);
        while let Some(first) = samples.next() {
            // Samples of one pixel, or of neighbours. Where there are no more, the last one again.
            let (mut last, mut count) = (first, 1);
            let [second, third, fourth] = [(); 3].map(|()| {
                if let Some(sample) = samples.next() {
                    (last, count) = (sample, count + 1);
                }
                last
            });
            let four = [first, second, third, fourth];
            let dice = Thrown4::new(tracer.spread, four, tracer.seed);
            let rays = dice.start(camera, raster);
            let lights = trees.radiance(&tracer.tracer, rays, &dice, count);
            for (light, _) in lights.into_iter().zip(0..count) {
                put(light);
            }
        }
    }

    fn follow_diffuse<'a, N: Needs>(
        tracer: &Paths<'a, f32, Lambert<'static, f32>, N, 1, &'a Packets>,
        camera: &Camera<f32>,
        (raster, places): (Raster, Sobol),
        samples: &mut dyn Iterator<Item = Sample>,
        put: &mut dyn FnMut(Rgb<f32>),
    ) {
        match path::search(tracer) {
            Some(search) => path::follow((tracer, search), (camera, raster), samples, put),
            None => follow(tracer, camera, (raster, places), samples, put),
        }
    }
}
