//! Pictures of paths of light. One ray at a time, with every model behind its pointer, but for rooms.

use core::marker::PhantomData;

use rta_core::camera::Camera;
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Lambert};
use rta_core::needs::{Everything, Needs};
use rta_core::raster::Raster;
use rta_core::sampling::{Places, Sobol, Uncut};
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
use crate::rows::{Samples, follow};

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

/// A model of paths.
trait Followed<S: Format>: Illumination<S> + Clone {
    /// Calls `put` with the light of the path of each of some samples, in their order, as many of a pixel as `places` has.
    fn follow<'a, N: Needs>(
        tracer: &Traced<'a, S, Self, N>,
        camera: &Camera<S>,
        (raster, places): (Raster, Sobol),
        samples: &mut dyn Iterator<Item = Sample>,
        put: &mut dyn FnMut(Rgb<S::Light>),
    ) {
        follow(tracer, camera, (raster, places), samples, put);
    }
}

impl<S: Format> Followed<S> for AnyModel<S> {}

impl<S: Format> Followed<S> for Lambert<'static, S> {
    fn follow<'a, N: Needs>(
        tracer: &Traced<'a, S, Self, N>,
        camera: &Camera<S>,
        (raster, places): (Raster, Sobol),
        samples: &mut dyn Iterator<Item = Sample>,
        put: &mut dyn FnMut(Rgb<S::Light>),
    ) {
        S::follow_diffuse(tracer, camera, (raster, places), samples, put);
    }
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

impl<S: Format, P: Followed<S>, N: Needs> Pathed<S, P, N> {
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

    /// Calls `put` with the light of some samples of as many as `samples` are of a pixel, in their order.
    fn follow(
        &self,
        samples: Sobol,
        mut some: impl Iterator<Item = Sample>,
        mut put: impl FnMut(Rgb<S::Light>),
    ) {
        let (camera, raster) = (&self.scene().camera, self.setup().raster);
        self.with_tracer(samples.seed(), |tracer| {
            P::follow(tracer, camera, (raster, samples), &mut some, &mut put);
        });
    }

    /// Calls `put` with the light of each of the rows from `first` to before `end`, as far as the raster has them.
    fn put_rows(&self, places: impl Places, (first, end): (u32, u32), put: PutRow<S>) {
        let (raster, count) = (self.setup().raster, places.samples());
        let width = raster.width();
        let pixels = (first..end.min(raster.height())).flat_map(|y| (0..width).map(move |x| [x, y]));
        let (mut row, mut sum, mut summed) = (Vec::new(), Rgb::BLACK, 0);
        self.follow(self.following.spreading.samples, Samples::new(pixels, 0..count), |light| {
            sum = places.add(sum, light);
            summed += 1;
            if summed == count {
                row.push(places.mean(core::mem::replace(&mut sum, Rgb::BLACK)));
                summed = 0;
            }
            if row.len() == width as usize {
                put(&row);
                row.clear();
            }
        });
    }
}

impl<S: Format, P: Followed<S>, N: Needs> Picture<S> for Pathed<S, P, N> {
    fn rows(&self, first: u32, end: u32, put: PutRow<S>) {
        let samples = self.following.spreading.samples;
        if self.following.is_cut {
            self.put_rows(samples, (first, end), put);
        } else {
            self.put_rows(Uncut(samples), (first, end), put);
        }
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
        let mut pixels: Vec<_> = sums.collect();
        let places: Vec<_> = pixels.iter().map(|pixel| pixel.place).collect();
        let numbers = pass.first..pass.samples.samples();
        let all = Samples::new(places.into_iter(), numbers.clone());
        let mut told = (0..).flat_map(|pixel| numbers.clone().map(move |_| pixel));
        self.follow(pass.samples, all, |light| {
            let pixel = told.next().and_then(|pixel: usize| pixels.get_mut(pixel));
            match pixel {
                Some(pixel) if self.following.is_cut => pixel.take(pass.samples, light),
                Some(pixel) => pixel.take(Uncut(pass.samples), light),
                None => {}
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
