//! Pictures whose rays are spread: over a lens, over lamps, and over the facets of rough surfaces.

use core::marker::PhantomData;

use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Lambert, Rta};
use rta_core::needs::{Everything, Needs};
use rta_core::raster::{Places, Raster};
use rta_core::trace::dice::Sample;
use rta_core::trace::{Distributed, Observer, Trace};
use rta_scenes::description::Air;
use rta_scenes::model::Model;
use rta_scenes::narrow::Narrowed;
use rta_scenes::sampler::Spreading;
use rta_scenes::shading::AnyModel;

use super::room::{Room, is_room};
use super::{Format, MAX_DEPTH, Modelled, Pass, Picture, PutRow, Ready, Setup, Sums};
use crate::cache::ShadowCache;
use crate::packets::Packets;
use crate::rows::Samples;

/// A picture whose rays are spread as `spreading` says; `still` is the one whose rays are not, and `N` what its tracer has.
struct Spread<S: Format, M, N> {
    still: Modelled<S, M>,
    spreading: Spreading,
    needs: PhantomData<fn() -> N>,
}

type Traced<'t, S, M, N> = Distributed<'t, S, M, N, { MAX_DEPTH as usize }, &'t Packets>;

/// Returns the picture whose rays are spread; `still` is the one whose rays are not, by this model, in this air.
pub(super) fn picture<S: Format>(
    still: Modelled<S, AnyModel<S>>,
    (model, air): (Model, &Air),
    spreading: Spreading,
) -> Box<dyn Picture<S>> {
    fn of<S: Format, M: Illumination<S> + Clone + 'static, N: Needs + 'static>(
        (ready, model): (Ready<S>, M),
        spreading: Spreading,
        needs: PhantomData<fn() -> N>,
    ) -> Box<dyn Picture<S>> {
        Box::new(Spread { still: Modelled { ready, model }, spreading, needs })
    }
    let everything = PhantomData::<fn() -> Everything>;
    let shines_through = still.ready.scene.said.iter().any(|own| own.back.is_some());
    let is_clear = *air == Air::default();
    let Modelled { ready, model: any } = still;
    // Models that need no row of a material. The others, and all in air, are behind a pointer.
    match model {
        Model::Lambert if is_clear && !shines_through => {
            if is_room(&ready.scene, (model, air)) {
                return of((ready, Lambert::default()), spreading, PhantomData::<fn() -> Room>);
            }
            of((ready, Lambert::default()), spreading, everything)
        }
        Model::Rta if is_clear => of((ready, Rta), spreading, everything),
        _ => of((ready, any), spreading, everything),
    }
}

impl<S: Format, M: Illumination<S> + Clone, N: Needs> Spread<S, M, N> {
    /// Returns what `draw` makes of the tracer of the picture whose rays are spread by `seed`.
    fn with_tracer<R>(&self, seed: u32, draw: impl FnOnce(&Traced<'_, S, M, N>) -> R) -> Option<R> {
        let ready = &self.still.ready;
        let admitted = ready.admitted();
        let spread = ready.scene.spread(&self.spreading);
        // There is a tracer: the depth was checked when the picture was made ready.
        let tracer = self.still.tracer(&admitted)?;
        Some(draw(&Distributed { tracer, spread: &spread, seed }))
    }
}

impl<S: Format, M: Illumination<S> + Clone, N: Needs> Picture<S> for Spread<S, M, N> {
    fn rows(&self, first: u32, end: u32, put: PutRow<S>) {
        let raster = self.setup().raster;
        let (camera, samples) = (&self.scene().camera, self.spreading.samples);
        let (width, end) = (raster.width(), end.min(raster.height()));
        let pixels = (first..end).flat_map(|y| (0..width).map(move |x| [x, y]));
        let all = Samples::new(pixels, 0..samples.samples());
        let mut row = Vec::with_capacity(width as usize);
        let (mut sum, mut summed) = (Rgb::BLACK, 0);
        self.with_tracer(samples.seed(), |tracer| {
            S::trace_samples(tracer, camera, (raster, samples), all, |light| {
                (sum, summed) = (samples.add(sum, light), summed + 1);
                if summed == samples.samples() {
                    row.push(samples.mean(sum));
                    (sum, summed) = (Rgb::BLACK, 0);
                }
                if row.len() == width as usize {
                    put(&row);
                    row.clear();
                }
            });
        });
    }

    fn preview_rows(&self, raster: Raster, first: u32, end: u32, put: PutRow<S>) {
        self.still.preview_rows(raster, first, end, put);
    }

    fn sample(
        &self,
        place: (S::Unit, S::Unit),
        sample: Sample,
        cache: &mut ShadowCache,
        observer: &mut dyn Observer<S>,
    ) -> Rgb<S::Light> {
        let camera = &self.scene().camera;
        let seed = self.spreading.samples.seed();
        let light = self.with_tracer(seed, |tracer| tracer.sample(camera, place, sample, cache, observer));
        light.unwrap_or(Rgb::BLACK)
    }

    fn add(&self, pass: Pass, sums: Sums<S>) {
        let (camera, Pass { samples, first }) = (&self.scene().camera, pass);
        let mut pixels: Vec<_> = sums.collect();
        if pixels.is_empty() {
            return;
        }
        let places: Vec<_> = pixels.iter().map(|pixel| pixel.place).collect();
        let numbers = first..samples.samples();
        let all = Samples::new(places.into_iter(), numbers.clone());
        let (mut pixels, mut pixel, mut left) = (pixels.iter_mut(), None, 0);
        self.with_tracer(samples.seed(), |tracer| {
            S::trace_samples(tracer, camera, (self.setup().raster, samples), all, |light| {
                if left == 0 {
                    (pixel, left) = (pixels.next(), numbers.len());
                }
                left -= 1;
                if let Some(pixel) = &mut pixel {
                    pixel.take(samples, light);
                }
            });
        });
    }

    fn setup(&self) -> &Setup {
        self.still.setup()
    }

    fn rays_before(&self) -> u64 {
        self.still.ready.rays
    }

    fn scene(&self) -> &Narrowed<S> {
        self.still.scene()
    }
}
