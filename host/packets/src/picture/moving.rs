//! Pictures in which something moves while the shutter is open. What moves is copied for each sample; boxes are about its whole way.

use core::marker::PhantomData;

use rta_core::color::Rgb;
use rta_core::illumination::Illumination;
use rta_core::needs::Everything;
use rta_core::range::Admitted;
use rta_core::raster::Raster;
use rta_core::scalar::Unit;
use rta_core::trace::dice::Sample;
use rta_core::trace::moving::{self, Memory};
use rta_core::trace::{Distributed, Observer, Trace, Tracer};
use rta_scenes::accelerator::bvh::Built;
use rta_scenes::accelerator::search::Search;
use rta_scenes::narrow::Narrowed;
use rta_scenes::narrow::moving::Held;
use rta_scenes::sampler::Spreading;

use super::{Format, MAX_DEPTH, Modelled, Pass, Picture, PutRow, Setup, Sums};
use crate::cache::ShadowCache;
use crate::rows::put_rows;

/// A picture in which something moves; `still` is the one of the middle of the time.
pub(super) struct Moving<S: Format, M> {
    pub(super) still: Modelled<S, M>,
    pub(super) spreading: Spreading,
    /// The scene with what moves, as it is in the middle of the time.
    pub(super) scene: Narrowed<S>,
    pub(super) built: Built<S>,
}

type Traced<'t, S, M> = moving::Moving<'t, S, M, Everything, { MAX_DEPTH as usize }, Search<'t, S>, Held<S>>;

impl<S: Format, M: Illumination<S> + Clone> Moving<S, M> {
    /// Returns what `draw` makes of the tracer of the picture whose rays are spread by `seed`.
    fn with_tracer<R>(&self, seed: u32, draw: impl FnOnce(&Traced<'_, S, M>) -> R) -> Option<R> {
        let (ready, scene) = (&self.still.ready, &self.scene);
        let search = self.built.bvh().map_or(Search::Lists, Search::Hierarchy);
        let admitted = Admitted::baked(scene.scene(), ready.limits, search);
        let Setup { depth, cutoff, .. } = ready.setup;
        let mut tracer = Tracer::new(&admitted, self.still.model.clone(), depth).ok()?;
        if let Some((numerator, denominator)) = cutoff {
            tracer = tracer.with_cutoff(S::Unit::ratio(numerator, denominator));
        }
        let spread = scene.spread(&self.spreading);
        let still = Distributed { tracer, spread: &spread, seed };
        Some(draw(&Traced { still, motions: &scene.spreads.motions, room: PhantomData }))
    }
}

impl<S: Format, M: Illumination<S> + Clone> Picture<S> for Moving<S, M> {
    fn rows(&self, first: u32, end: u32, put: PutRow<S>) {
        let raster = self.setup().raster;
        let (camera, samples) = (&self.scene.camera, self.spreading.samples);
        self.with_tracer(samples.seed(), |tracer| {
            put_rows(tracer, camera, (raster, samples), (first, end), put);
        });
    }

    fn preview_rows(&self, raster: Raster, first: u32, end: u32, put: PutRow<S>) {
        self.still.preview_rows(raster, first, end, put);
    }

    fn sample(
        &self,
        place: (S::Unit, S::Unit),
        sample: Sample,
        _cache: &mut ShadowCache,
        observer: &mut dyn Observer<S>,
    ) -> Rgb<S::Light> {
        let camera = &self.scene.camera;
        let seed = self.spreading.samples.seed();
        let light = self.with_tracer(seed, |tracer| {
            tracer.sample(camera, place, sample, &mut Memory::default(), observer)
        });
        light.unwrap_or(Rgb::BLACK)
    }

    fn add(&self, pass: Pass, sums: Sums<S>) {
        let (camera, mut memory) = (&self.scene().camera, Memory::default());
        self.with_tracer(pass.samples.seed(), |tracer| {
            pass.add::<S>((self.setup().raster, pass.samples), sums, |place, sample| {
                tracer.sample(camera, place, sample, &mut memory, &mut ())
            });
        });
    }

    fn setup(&self) -> &Setup {
        self.still.setup()
    }

    fn scene(&self) -> &Narrowed<S> {
        &self.scene
    }
}
