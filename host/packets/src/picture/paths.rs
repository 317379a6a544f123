//! Pictures of paths of light. One ray at a time, with every model behind its pointer, but for rooms.

use core::marker::PhantomData;

use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Lambert};
use rta_core::needs::{Everything, Needs};
use rta_core::raster::Raster;
use rta_core::sampling::Uncut;
use rta_core::trace::dice::Sample;
use rta_core::trace::path::Rules;
use rta_core::trace::{Distributed, Observer, Paths, Trace, Tracer};
use rta_scenes::description::Air;
use rta_scenes::model::Model;
use rta_scenes::narrow::Narrowed;
use rta_scenes::sampler::Spreading;
use rta_scenes::shading::AnyModel;

use super::room::{Room, is_room};
use super::{Format, Modelled, Pass, Picture, PutRow, Setup, Sums};
use crate::cache::ShadowCache;
use crate::packets::Packets;
use crate::rows::put_rows;

/// How samples are paths.
#[derive(Clone, Copy)]
pub(super) struct Following {
    /// How they are spread.
    pub(super) spreading: Spreading,
    /// The most bounces.
    pub(super) bounces: u8,
    /// Whether light is cut to white before the mean is taken.
    pub(super) is_cut: bool,
}

/// A picture whose samples are paths; `still` is the one of ray trees. `P` is the model of the paths.
struct Pathed<S: Format, P, N> {
    still: Modelled<S, AnyModel<S>>,
    following: Following,
    model: P,
    needs: PhantomData<fn() -> N>,
}

type Traced<'t, S, P, N> = Paths<'t, S, P, N, 1, &'t Packets>;

/// Returns the picture whose samples are paths; `still` is the one of ray trees by this model, in this air.
pub(super) fn picture<S: Format>(
    still: Modelled<S, AnyModel<S>>,
    (model, air): (Model, &Air),
    following: Following,
) -> Box<dyn Picture<S>> {
    if is_room(&still.ready.scene, (model, air)) {
        // Paths ask for no light that shines through from behind.
        let model = Lambert::default();
        return Box::new(Pathed { still, following, model, needs: PhantomData::<fn() -> Room> });
    }
    let model = still.model.clone();
    Box::new(Pathed { still, following, model, needs: PhantomData::<fn() -> Everything> })
}

impl<S: Format, P: Illumination<S> + Clone, N: Needs> Pathed<S, P, N> {
    /// Returns what `draw` makes of the tracer of the picture whose rays are spread by `seed`.
    fn with_tracer<R>(&self, seed: u32, draw: impl FnOnce(&Traced<'_, S, P, N>) -> R) -> Option<R> {
        let ready = &self.still.ready;
        let admitted = ready.admitted();
        let spread = ready.scene.spread(&self.following.spreading);
        // There is a tracer: any scene has rays of depth 0, and paths are followed without its stack.
        let tracer = Tracer::new(&admitted, self.model.clone(), 0).ok()?;
        let spread = Distributed { tracer, spread: &spread, seed };
        let rules = Rules { bounces: self.following.bounces, ..Rules::default() };
        Some(draw(&Paths { spread, emitters: &ready.scene.spreads.emitters, rules }))
    }
}

impl<S: Format, P: Illumination<S> + Clone, N: Needs> Picture<S> for Pathed<S, P, N> {
    fn rows(&self, first: u32, end: u32, put: PutRow<S>) {
        let raster = self.setup().raster;
        let (camera, samples) = (&self.scene().camera, self.following.spreading.samples);
        self.with_tracer(samples.seed(), |tracer| {
            if self.following.is_cut {
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
        let seed = self.following.spreading.samples.seed();
        let light = self.with_tracer(seed, |tracer| tracer.sample(camera, place, sample, cache, observer));
        light.unwrap_or(Rgb::BLACK)
    }

    fn add(&self, pass: Pass, sums: Sums<S>) {
        let (camera, mut memory) = (&self.scene().camera, ShadowCache::default());
        let (raster, samples) = (self.setup().raster, pass.samples);
        self.with_tracer(samples.seed(), |tracer| {
            let trace = |place, sample| tracer.sample(camera, place, sample, &mut memory, &mut ());
            if self.following.is_cut {
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
