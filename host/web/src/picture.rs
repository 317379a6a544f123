//! A scene ready to be traced, in any number format and with any model.

use rta_core::Error;
use rta_core::color::Rgb;
use rta_core::needs::Everything;
use rta_core::range::Admitted;
use rta_core::raster::lattice::Lattice;
use rta_core::raster::{Pixels, Raster};
use rta_core::sampling::{Places, Sampling};
use rta_core::scalar::Unit;
use rta_core::scene::Limits;
use rta_core::trace::Trace;
use rta_scenes::accelerator::bvh::{self, Built};
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrowed, narrow};
use rta_scenes::shading::{AnySpectrum, Shade, Wavelengths};
use rta_scenes::{Model, in_format};

use crate::explain::{Explanation, Recorder};
use crate::failure::Failure;
use crate::request::{DEPTH, MAX_DEPTH, Request};
use rta_scenes::accelerator::search::Search;

/// How a picture is traced, whatever its number format.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Setup {
    /// Width and height in pixels.
    pub(crate) raster: Raster,
    /// Width over height of the screen.
    pub(crate) aspect: f64,
    /// The illumination model.
    pub(crate) model: Model,
    /// Recursion depth.
    pub(crate) depth: u32,
    /// Numerator and denominator of the part of its light that a ray must bring into the pixel; the model's own without it.
    pub(crate) cutoff: Option<(u16, u16)>,
    /// Samples of a pixel.
    pub(crate) sampling: Sampling,
}

impl Setup {
    /// Returns how a scene is drawn as a request says; where it leaves something open, as the scene does.
    ///
    /// # Errors
    /// [`Failure`] if there is no such raster.
    pub(crate) fn new(request: &Request, scene: &Description) -> Result<Self, Failure> {
        let (width, height) = request.size();
        let said = &scene.settings;
        let side = said.samples.and_then(|samples| u8::try_from(samples.isqrt()).ok());
        Ok(Self {
            raster: Raster::new(width, height).map_err(Failure::plain)?,
            aspect: request.aspect(),
            model: request.model.unwrap_or(scene.model),
            depth: request.depth.or(said.depth).unwrap_or(DEPTH).min(MAX_DEPTH),
            cutoff: said.cutoff_ratio(),
            sampling: side.and_then(Sampling::grid).unwrap_or(Sampling::CENTER),
        })
    }
}

/// A picture in any number format. Rows may be asked for in any order.
pub(crate) trait Picture {
    /// Returns the light of a row as levels 0..=`most`.
    ///
    /// # Errors
    /// None, once there is a picture.
    fn row(&self, y: u32, most: u8) -> Result<Vec<Rgb<u8>>, Error>;

    /// Returns the colours, 8 bits a gun, of those of the picture's pixels that are on a grid, one sample each.
    ///
    /// # Errors
    /// None, once there is a picture.
    fn on_grid(&self, lattice: Lattice) -> Result<Vec<Rgb<u8>>, Error>;

    /// Traces a pixel of the raster and returns what its rays meet.
    ///
    /// # Errors
    /// None, once there is a picture.
    fn explain(&self, x: u32, y: u32) -> Result<Explanation, Error>;
}

/// Makes a scene ready in the number format of a request.
///
/// # Errors
/// [`Failure`] with the object that does not fit the format.
pub(crate) fn picture(
    request: &Request,
    scene: &Description,
    setup: Setup,
) -> Result<Box<dyn Picture>, Failure> {
    in_format!(request.format, S => Ok(Box::new(Ready::<S>::new(scene, setup)?)))
}

/// Proves that a scene fits the number format of a request.
///
/// # Errors
/// [`Failure`] with the object that does not fit.
pub(crate) fn admit(request: &Request, scene: &Description, setup: Setup) -> Result<(), Failure> {
    in_format!(request.format, S => admitted::<S>(scene, setup).map(|_| ()))
}

/// Returns a scene in a number format and its limits.
fn admitted<S: Shade>(scene: &Description, setup: Setup) -> Result<(Narrowed<S>, Limits<S>), Failure> {
    let narrowed = narrow::<S>(scene, setup.aspect).map_err(|error| Failure::narrow(&error))?;
    let failed = |error| Failure::range(error, scene);
    let limits = narrowed.admit().map_err(failed)?.limits;
    let depth = u8::try_from(setup.depth).unwrap_or(u8::MAX);
    if depth > limits.depth {
        narrowed.scene().check_depth(depth).map_err(failed)?;
    }
    Ok((narrowed, limits))
}

/// A scene in one number format, with its hierarchy and its model.
struct Ready<S: Shade> {
    scene: Narrowed<S>,
    limits: Limits<S>,
    built: Built<S>,
    models: Wavelengths<S>,
    setup: Setup,
}

/// The tracer of a number format.
type Traced<'a, 'scene, S> = AnySpectrum<'a, S, Everything, { MAX_DEPTH as usize }, Search<'scene, S>>;

impl<S: Shade> Ready<S> {
    fn new(scene: &Description, setup: Setup) -> Result<Self, Failure> {
        let (narrowed, limits) = admitted::<S>(scene, setup)?;
        let models = Wavelengths::new(setup.model, &scene.air, &narrowed, limits);
        let ready = Self { scene: narrowed, limits, built: bvh::build(scene), models, setup };
        // What the hierarchy adds to the proof: a scene that fails it is searched without.
        let search = ready.search();
        match ready.scene.scene().admit_with(&ready.scene.camera, search).map(|admitted| admitted.limits) {
            Ok(limits) => Ok(Self { limits, ..ready }),
            Err(_) => Ok(Self { built: Built { nodes: Vec::new(), order: Vec::new() }, ..ready }),
        }
    }

    fn search(&self) -> Search<'_, S> {
        self.built.bvh().map_or(Search::Lists, Search::Hierarchy)
    }

    fn trace<'scene, R>(&'scene self, draw: impl FnOnce(&Traced<'_, 'scene, S>) -> R) -> Result<R, Error> {
        let Setup { depth, cutoff, .. } = self.setup;
        let cutoff =
            cutoff.map(|(numerator, denominator)| S::Unit::ratio(numerator.into(), denominator.into()));
        let admitted = Admitted::baked(self.scene.scene(), self.limits, self.search());
        self.models.with_tracer(&self.scene, &admitted, (depth, cutoff), draw)
    }
}

impl<S: Shade> Picture for Ready<S> {
    fn row(&self, y: u32, most: u8) -> Result<Vec<Rgb<u8>>, Error> {
        let (Setup { raster, sampling, .. }, camera) = (self.setup, &self.scene.camera);
        let end = y.saturating_add(1);
        if sampling == Sampling::CENTER {
            return self.trace(|tracer| {
                Pixels::row(tracer, camera, raster, y).map(|light| light.levels(most)).collect()
            });
        }
        self.trace(|tracer| {
            Pixels::sampled(tracer, camera, raster, sampling, y, end)
                .map(|light| light.levels(most))
                .collect()
        })
    }

    fn on_grid(&self, lattice: Lattice) -> Result<Vec<Rgb<u8>>, Error> {
        self.trace(|tracer| {
            let light = Pixels::sampled(tracer, &self.scene.camera, lattice.grid(), lattice, 0, u32::MAX);
            light.map(|light| light.levels(u8::MAX)).collect()
        })
    }

    fn explain(&self, x: u32, y: u32) -> Result<Explanation, Error> {
        let (Setup { raster, sampling, .. }, camera) = (self.setup, &self.scene.camera);
        self.trace(|tracer| {
            let mut recorder = Recorder::new(&self.scene);
            let mut sum = Rgb::BLACK;
            let row = Places::row::<S::Unit>(&sampling, raster, y);
            for sample in 0..sampling.samples() {
                let (right, up) = sampling.place(raster, row, x, sample);
                let direction = camera.direction(right, up);
                sum = sampling.add(sum, tracer.trace(camera.eye, direction, &mut (), &mut recorder));
            }
            recorder.explanation(sampling.mean(sum), sampling.samples())
        })
    }
}
