//! A picture about to be traced: a scene in one number format and with one illumination model, ready for any of its rows.
//!
//! The tracers of all formats and models are instantiated here, in one place, so that the crates above need not compile them.

use rta_core::Error;
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Phong, Rta, Whitted};
use rta_core::needs::{Everything, Needs};
use rta_core::range::Admitted;
use rta_core::raster::Raster;
use rta_core::raster::lattice::Lattice;
use rta_core::sampling::Places;
use rta_core::scalar::Unit;
use rta_core::scene::Limits;
use rta_core::trace::dice::Sample;
use rta_core::trace::{Observer, Trace, Tracer};
use rta_core::{Q16, Q20};
use rta_scenes::accelerator::bvh;
use rta_scenes::description::{Air, Description};
use rta_scenes::model::Model;
use rta_scenes::narrow::{Narrow, Narrowed, narrow};
use rta_scenes::sampler::{Integrator, Sampler};
use rta_scenes::shading::{Shade, Wavelengths};

use crate::cache::ShadowCache;
use crate::packets::Packets;
pub use crate::rows::PutRow;
use crate::rows::Rows;

mod added;
mod antialiased;
mod cache;
mod error;
mod moving;
mod paths;
mod room;
mod spectral;
mod spread;

pub use added::{Added, Pass, Sums};
use antialiased::Antialiased;
use cache::{Gathered, gathered};
pub use error::PictureError;
use moving::Moving;
use paths::Following;
use spectral::Spectral;

/// The deepest recursion: the capacity of the tracer's stack of pending rays.
pub const MAX_DEPTH: u32 = 32;

/// How a picture is traced, whatever its number format and model.
#[derive(Clone, Copy, Debug)]
pub struct Setup {
    /// Width and height in pixels.
    pub raster: Raster,
    /// Width over height of the screen (not of the raster).
    pub aspect: f64,
    /// Recursion depth, 0 to [`MAX_DEPTH`].
    pub depth: u32,
    /// Numerator and denominator of the part of its light that a ray must bring into the pixel to be traced, 0 to 1: every
    /// number format rounds it for itself. Without it, the model's counts.
    pub cutoff: Option<(i64, i64)>,
    /// Samples of a pixel. The light of one in its middle is kept as it is; of several it is the mean of displayable light.
    pub sampling: Sampler,
}

/// A picture in the number format `S`. Rows may be asked for in any order, from any number of threads.
pub trait Picture<S: Narrow>: Send + Sync {
    /// Calls `put` with the light of the pixels of each row from `first` to before `end`, as far as the raster has them, from
    /// top to bottom.
    fn rows(&self, first: u32, end: u32, put: PutRow<S>);

    /// Calls `put` with the light of the rows from `first` to before `end` of a preview: the picture on the raster `raster`
    /// instead of its own, with one sample in the middle of each pixel.
    fn preview_rows(&self, raster: Raster, first: u32, end: u32, put: PutRow<S>);

    /// Returns the light of one sample at a place of the image plane, how far to the right and how far up, each from -1/2 to 1/2; `observer`
    /// is told of every ray. By `sample` the sample's rays are spread, where rays are; `cache` is kept from sample to sample.
    fn sample(
        &self,
        place: (S::Unit, S::Unit),
        sample: Sample,
        cache: &mut ShadowCache,
        observer: &mut dyn Observer<S>,
    ) -> Rgb<S::Light>;

    /// Adds samples to the sums of the light of some pixels. Of rays that are not spread the seed of the pass moves the places alone.
    fn add(&self, pass: Pass, sums: Sums<S>) {
        let mut cache = ShadowCache::default();
        pass.add::<S>((self.setup().raster, pass.samples), sums, |place, sample| {
            self.sample(place, sample, &mut cache, &mut ())
        });
    }

    /// How the picture is traced.
    fn setup(&self) -> &Setup;

    /// Returns how many rays were traced before the picture is: those that gathered indirect light, where it is gathered for each picture.
    fn rays_before(&self) -> u64 {
        0
    }

    /// The scene and the eye.
    fn scene(&self) -> &Narrowed<S>;

    /// Traces the pixels of the rows from `first` to before `end`; `observer` is told of every ray.
    fn observed_rows(&self, first: u32, end: u32, observer: &mut dyn Observer<S>) {
        let raster = self.setup().raster;
        let mut cache = ShadowCache::default();
        for y in first..end.min(raster.height()) {
            for x in 0..raster.width() {
                observed(self, (x, y), &mut cache, observer);
            }
        }
    }

    /// Calls `put` with the light of the pixels of a grid, one sample in the middle of each, in the rows from `first` to before `end` of
    /// the grid.
    fn grid_rows(&self, lattice: Lattice, first: u32, end: u32, put: &mut dyn FnMut(Rgb<S::Light>)) {
        let (grid, mut cache) = (lattice.grid(), ShadowCache::default());
        for y in first..end.min(grid.height()) {
            let row = lattice.row::<S::Unit>(grid, y);
            for x in 0..grid.width() {
                let (column, line) = lattice.pixel(x, y);
                let own = Sample { x: column, y: line, number: 0 };
                put(self.sample(lattice.place(grid, row, x, 0), own, &mut cache, &mut ()));
            }
        }
    }

    /// Traces the samples of the pixel in column `x` of row `y`; `observer` is told of every ray.
    fn observed_pixel(&self, x: u32, y: u32, observer: &mut dyn Observer<S>) {
        observed(self, (x, y), &mut ShadowCache::default(), observer);
    }
}

/// Traces the samples of one pixel; `observer` is told of every ray.
fn observed<S: Narrow>(
    picture: &(impl Picture<S> + ?Sized),
    (x, y): (u32, u32),
    cache: &mut ShadowCache,
    observer: &mut dyn Observer<S>,
) {
    let Setup { raster, sampling, .. } = *picture.setup();
    let row = Places::row::<S::Unit>(&sampling, raster, y);
    for sample in 0..sampling.samples() {
        let own = Sample { x, y, number: sample };
        picture.sample(sampling.place(raster, row, x, sample), own, cache, observer);
    }
}

/// A number format that pictures can be traced in.
pub trait Format: Rows + Shade {
    /// Makes a scene ready.
    ///
    /// # Errors
    /// Whatever keeps it from being drawn with these settings; once there is a picture, nothing does.
    fn picture(
        scene: &Description,
        model: Model,
        setup: &Setup,
    ) -> Result<Box<dyn Picture<Self>>, PictureError>;
}

macro_rules! formats {
    ($($f:ty)*) => {
        $(impl Format for $f {
            fn picture(
                scene: &Description,
                model: Model,
                setup: &Setup,
            ) -> Result<Box<dyn Picture<Self>>, PictureError> {
                if setup.sampling == Sampler::Cones {
                    return Err(PictureError::Cones("pictures of rays"));
                }
                let drawn = scene.drawn_by(model);
                let scene = &*drawn;
                if let Sampler::Adaptive(adaptive) = setup.sampling {
                    let single = Self::picture(scene, model, &Setup { sampling: Sampler::CENTER, ..*setup })?;
                    return Ok(Box::new(Antialiased::new(single, *setup, adaptive)));
                }
                let (ready, air) = (Ready::<$f>::new(scene, setup)?, &scene.air);
                let limits = ready.limits;
                let any = |scene: &_| Wavelengths::new(model, air, scene, limits);
                if ready.scene.spectrum.is_some() {
                    let wavelengths = any(&ready.scene);
                    if wavelengths.is_dispersive() {
                        return Ok(Box::new(Spectral { ready, wavelengths }));
                    }
                }
                if let Some(&spreading) = setup.sampling.spreading() {
                    let still = Modelled { model: any(&ready.scene).into_first(), ready };
                    if let Integrator::Paths { bounces, is_cut } = spreading.integrator {
                        let following = Following { spreading, bounces, is_cut };
                        return Ok(paths::picture(still, (model, air), following));
                    }
                    if scene.has_motion() {
                        let (mut held, built) = (narrow::<$f>(scene, setup.aspect)?, bvh::build::<$f>(scene));
                        held.solve(&scene.stopped(), limits)?;
                        return Ok(Box::new(Moving { still, spreading, scene: held, built }));
                    }
                    return Ok(spread::picture(still, (model, air), spreading));
                }
                let is_clear = *air == Air::default();
                Ok(match model {
                    // The pictures that are drawn most have a tracer of their own.
                    Model::Rta if is_clear => Box::new(Modelled { ready, model: Rta }),
                    Model::Whitted if is_clear => Box::new(Modelled { ready, model: Whitted::default() }),
                    Model::Phong if is_clear => Box::new(Modelled { ready, model: Phong::default() }),
                    _ => {
                        let model = any(&ready.scene).into_first();
                        Box::new(Modelled { ready, model })
                    }
                })
            }
        })*
    };
}

formats!(f32 f64 Q16 Q20);

/// A scene made ready in a number format.
struct Ready<S: Narrow> {
    scene: Narrowed<S>,
    packets: Packets,
    limits: Limits<S>,
    setup: Setup,
    /// Rays that were traced to make it ready.
    rays: u64,
}

impl<S: Format> Ready<S> {
    fn new(scene: &Description, setup: &Setup) -> Result<Self, PictureError> {
        if setup.depth > MAX_DEPTH {
            return Err(Error::Depth { depth: setup.depth, capacity: MAX_DEPTH as usize }.into());
        }
        let mut narrowed = narrow::<S>(scene, setup.aspect)?;
        let limits = narrowed.admit()?.limits;
        let stopped = scene.has_motion().then(|| scene.stopped());
        let scene = stopped.as_ref().unwrap_or(scene);
        if stopped.is_some() {
            narrowed = narrow::<S>(scene, setup.aspect)?;
        }
        let depth = u8::try_from(setup.depth).unwrap_or(u8::MAX);
        if depth > limits.depth {
            narrowed.scene().check_depth(depth)?;
        }
        narrowed.solve(scene, limits)?;
        // Last, as it takes longest: a scene that is refused is refused at once.
        let packets = Packets::build::<S>(scene);
        let mut ready = Self { scene: narrowed, packets, limits, setup: *setup, rays: 0 };
        if let Some(Gathered { lit, rays }) = gathered(&ready) {
            (ready.scene.lit, ready.rays) = (Some(lit), rays);
        }
        Ok(ready)
    }

    /// Returns the scene, which was proved once, when the picture was made ready.
    fn admitted(&self) -> Admitted<'_, S, &Packets> {
        Admitted::baked(self.scene.scene(), self.limits, &self.packets)
    }
}

struct Modelled<S: Narrow, M> {
    ready: Ready<S>,
    model: M,
}

type Traced<'a, S, M, N> = Tracer<'a, S, M, N, { MAX_DEPTH as usize }, &'a Packets>;

impl<S: Format, M: Illumination<S> + Clone> Modelled<S, M> {
    fn tracer<'a, N: Needs>(
        &self,
        admitted: &'a Admitted<'a, S, &'a Packets>,
    ) -> Option<Traced<'a, S, M, N>> {
        let Setup { depth, cutoff, .. } = self.ready.setup;
        let tracer: Traced<'a, S, M, N> = Tracer::new(admitted, self.model.clone(), depth).ok()?;
        Some(match cutoff {
            Some((numerator, denominator)) => tracer.with_cutoff(S::Unit::ratio(numerator, denominator)),
            None => tracer,
        })
    }

    /// Calls `put` with each of the rows `range` of the picture on `raster`, with samples at `places`.
    fn traced(&self, raster: Raster, places: Sampler, range: (u32, u32), put: PutRow<S>) {
        // There is a tracer: the depth was checked when the picture was made ready.
        let admitted = self.ready.admitted();
        let Some(tracer) = self.tracer::<Everything>(&admitted) else { return };
        let width = raster.width() as usize;
        let mut row = Vec::with_capacity(width);
        S::trace_rows(&tracer, &self.ready.scene.camera, (raster, places), range, |light| {
            row.push(light);
            if row.len() == width {
                put(&row);
                row.clear();
            }
        });
    }
}

impl<S: Format, M: Illumination<S> + Clone> Picture<S> for Modelled<S, M> {
    fn rows(&self, first: u32, end: u32, put: PutRow<S>) {
        let Setup { raster, sampling, .. } = self.ready.setup;
        self.traced(raster, sampling, (first, end), put);
    }

    fn preview_rows(&self, raster: Raster, first: u32, end: u32, put: PutRow<S>) {
        self.traced(raster, Sampler::CENTER, (first, end), put);
    }

    fn sample(
        &self,
        place: (S::Unit, S::Unit),
        sample: Sample,
        cache: &mut ShadowCache,
        observer: &mut dyn Observer<S>,
    ) -> Rgb<S::Light> {
        let admitted = self.ready.admitted();
        let Some(tracer) = self.tracer::<Everything>(&admitted) else { return Rgb::BLACK };
        tracer.sample(&self.ready.scene.camera, place, sample, cache, observer)
    }

    fn setup(&self) -> &Setup {
        &self.ready.setup
    }

    fn scene(&self) -> &Narrowed<S> {
        &self.ready.scene
    }
}
