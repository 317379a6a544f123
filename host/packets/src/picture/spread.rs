//! Pictures whose rays are spread: over a lens, over lamps, and over the facets of rough surfaces.

use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Lambert, Rta};
use rta_core::raster::{Places, Raster};
use rta_core::trace::dice::Sample;
use rta_core::trace::{Distributed, Observer, Trace};
use rta_scenes::description::{Air, Description};
use rta_scenes::model::Model;
use rta_scenes::narrow::Narrowed;
use rta_scenes::sampler::Spreading;
use rta_scenes::shading::AnyModel;

use super::{Format, MAX_DEPTH, Modelled, Pass, Picture, PutRow, Setup, Sums};
use crate::cache::ShadowCache;
use crate::packets::Packets;
use crate::rows::Samples;

/// A picture whose rays are spread as `spreading` says; `still` is the one whose rays are not.
struct Spread<S: Format, M> {
    still: Modelled<S, M>,
    spreading: Spreading,
}

/// Returns the picture whose rays are spread as `spreading` says; `still` is the one whose rays are not, of a scene by this model, in this air.
pub(super) fn picture<S: Format>(
    still: Modelled<S, AnyModel<S>>,
    (scene, model): (&Description, Model),
    spreading: Spreading,
) -> Box<dyn Picture<S>> {
    let is_clear = scene.air == Air::default();
    let shines_through = scene.materials.iter().any(|own| own.back.is_some_and(|back| back > 0.0));
    // Models that need no row of a material. The others, and all in air, are behind a pointer.
    match model {
        Model::Lambert if is_clear && !shines_through => {
            let still = Modelled { ready: still.ready, model: Lambert::default() };
            Box::new(Spread { still, spreading })
        }
        Model::Rta if is_clear => {
            Box::new(Spread { still: Modelled { ready: still.ready, model: Rta }, spreading })
        }
        _ => Box::new(Spread { still, spreading }),
    }
}

type Traced<'t, S, M> =
    Distributed<'t, S, M, rta_core::needs::Everything, { MAX_DEPTH as usize }, &'t Packets>;

impl<S: Format, M: Illumination<S> + Clone> Spread<S, M> {
    /// Returns what `draw` makes of the tracer of the picture whose rays are spread by `seed`.
    fn with_tracer<R>(&self, seed: u32, draw: impl FnOnce(&Traced<'_, S, M>) -> R) -> Option<R> {
        let ready = &self.still.ready;
        let admitted = ready.admitted();
        let spread = ready.scene.spread(&self.spreading);
        // There is a tracer: the depth was checked when the picture was made ready.
        let tracer = self.still.tracer(&admitted)?;
        Some(draw(&Distributed { tracer, spread: &spread, seed }))
    }
}

impl<S: Format, M: Illumination<S> + Clone> Picture<S> for Spread<S, M> {
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

    fn scene(&self) -> &Narrowed<S> {
        self.still.scene()
    }
}
