//! Pictures whose rays are spread: over a lens, over lamps, and over the facets of rough surfaces. One ray at a time, with every model behind
//! its pointer, but for rooms.

use core::marker::PhantomData;

use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Lambert};
use rta_core::needs::{Everything, Needs};
use rta_core::raster::Raster;
use rta_core::trace::dice::Sample;
use rta_core::trace::{Distributed, Observer, Trace};
use rta_scenes::description::Air;
use rta_scenes::model::Model;
use rta_scenes::narrow::Narrowed;
use rta_scenes::sampler::Spreading;
use rta_scenes::shading::AnyModel;

use super::room::{Room, is_room};
use super::{Format, MAX_DEPTH, Modelled, Pass, Picture, PutRow, Setup, Sums};
use crate::cache::ShadowCache;
use crate::packets::Packets;
use crate::rows::put_rows;

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
    let shines_through = still.ready.scene.said.iter().any(|own| own.back.is_some());
    if is_room(&still.ready.scene, (model, air)) && !shines_through {
        let still = Modelled { model: Lambert::default(), ready: still.ready };
        return Box::new(Spread { still, spreading, needs: PhantomData::<fn() -> Room> });
    }
    Box::new(Spread { still, spreading, needs: PhantomData::<fn() -> Everything> })
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
        self.with_tracer(pass.samples.seed(), |tracer| {
            pass.add::<S>((self.setup().raster, pass.samples), sums, |place, sample| {
                tracer.sample(camera, place, sample, &mut memory, &mut ())
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
