//! Pictures of paths of light. One ray at a time, with every model behind its pointer.

use rta_core::color::Rgb;
use rta_core::illumination::Illumination;
use rta_core::needs::Everything;
use rta_core::raster::Raster;
use rta_core::sampling::Uncut;
use rta_core::trace::dice::Sample;
use rta_core::trace::path::Rules;
use rta_core::trace::{Distributed, Observer, Paths, Trace};
use rta_scenes::narrow::Narrowed;
use rta_scenes::sampler::Spreading;

use super::{Format, MAX_DEPTH, Modelled, Pass, Picture, PutRow, Setup, Sums};
use crate::cache::ShadowCache;
use crate::packets::Packets;
use crate::rows::put_rows;

/// A picture whose samples are paths, of so many bounces at most, spread as `spreading` says; `still` is the one of ray trees.
pub(super) struct Pathed<S: Format, M> {
    pub(super) still: Modelled<S, M>,
    pub(super) spreading: Spreading,
    pub(super) bounces: u8,
    /// Whether light is cut to white before the mean is taken.
    pub(super) is_cut: bool,
}

type Traced<'t, S, M> = Paths<'t, S, M, Everything, { MAX_DEPTH as usize }, &'t Packets>;

impl<S: Format, M: Illumination<S> + Clone> Pathed<S, M> {
    /// Returns what `draw` makes of the tracer of the picture whose rays are spread by `seed`.
    fn with_tracer<R>(&self, seed: u32, draw: impl FnOnce(&Traced<'_, S, M>) -> R) -> Option<R> {
        let ready = &self.still.ready;
        let admitted = ready.admitted();
        let spread = ready.scene.spread(&self.spreading);
        // There is a tracer: the depth was checked when the picture was made ready.
        let tracer = self.still.tracer(&admitted)?;
        let spread = Distributed { tracer, spread: &spread, seed };
        let rules = Rules { bounces: self.bounces, ..Rules::default() };
        Some(draw(&Paths { spread, emitters: &ready.scene.spreads.emitters, rules }))
    }
}

impl<S: Format, M: Illumination<S> + Clone> Picture<S> for Pathed<S, M> {
    fn rows(&self, first: u32, end: u32, put: PutRow<S>) {
        let raster = self.setup().raster;
        let (camera, samples) = (&self.scene().camera, self.spreading.samples);
        self.with_tracer(samples.seed(), |tracer| {
            if self.is_cut {
                put_rows(tracer, camera, (raster, samples), (first, end), put);
            } else {
                put_rows(tracer, camera, (raster, Uncut(samples)), (first, end), put);
            }
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
        let (camera, mut memory) = (&self.scene().camera, ShadowCache::default());
        let (raster, samples) = (self.setup().raster, pass.samples);
        self.with_tracer(samples.seed(), |tracer| {
            let trace = |place, sample| tracer.sample(camera, place, sample, &mut memory, &mut ());
            if self.is_cut {
                pass.add::<S>((raster, samples), sums, trace);
            } else {
                pass.add::<S>((raster, Uncut(samples)), sums, trace);
            }
        });
    }

    fn setup(&self) -> &Setup {
        self.still.setup()
    }

    fn scene(&self) -> &Narrowed<S> {
        self.still.scene()
    }
}
