//! Pictures by cones instead of rays (J. Amanatides, "Ray Tracing with Cones", SIGGRAPH 84): a study, in `f64`, of what one cone over each pixel
//! can do and what it gets wrong.
//!
//! | step | where |
//! | --- | --- |
//! | a cone, what it covers, and what curved and rough surfaces make of it | [`beam`] |
//! | parts of a disc | [`cover`] |
//! | outlines of ellipsoids, cylinders and truncated cones, by rays | [`outline`] |
//! | radii of curvature | [`curvature`] |
//! | what rough surfaces do | [`gloss`] |
//! | what a cone meets, from near to far | [`hits`] |
//! | the floor's tiles | [`tiles`] |
//! | which is before which | [`order`] |
//! | shading, and the tree of reflected and refracted cones | [`tree`] |

use rta_core::Error;
use rta_core::camera::Camera;
use rta_core::color::Rgb;
use rta_core::range::Admitted;
use rta_core::raster::Raster;
use rta_core::sampling::Places;
use rta_core::scene::Limits;
use rta_core::trace::dice::Sample;
use rta_core::trace::{Observer, Tracer};
use rta_packets::ShadowCache;
use rta_packets::picture::{MAX_DEPTH, Picture, PictureError, PutRow, Setup};
use rta_scenes::description::{Description, LampShape};
use rta_scenes::model::Model;
use rta_scenes::narrow::{Narrowed, narrow};
use rta_scenes::sampler::{Sampler, is_spectral};
use rta_scenes::shading::{AnyModel, any_model};

use beam::Beam;
use hits::Search;
use tree::{Cones, Shader};

pub mod beam;
pub mod cover;
pub mod curvature;
pub mod gloss;
pub mod hits;
pub mod order;
pub mod outline;
pub mod tiles;
pub mod tree;

/// A scene of which pictures are drawn by cones.
pub struct Coned {
    scene: Narrowed<f64>,
    limits: Limits<f64>,
    model: AnyModel<f64>,
    setup: Setup,
}

/// Returns what of a scene cones do not know, if there is anything.
fn unknown(scene: &Description) -> Option<&'static str> {
    let is_area = |shape: &LampShape| matches!(shape, LampShape::Area { .. });
    let cases = [
        (scene.has_motion(), "things that move"),
        (scene.optics.aperture.is_some_and(|aperture| aperture > 0.0), "a lens; --aperture 0 is a pinhole"),
        (scene.details.light.is_some(), "light that was solved"),
        (scene.has_emitters(), "quads that emit light"),
        (scene.details.lamps.iter().any(|(_, shape)| is_area(shape)), "lamps that are parallelograms"),
        (is_spectral(scene), "several wavelengths; --spectral 0 traces one"),
    ];
    cases.into_iter().find_map(|(is_there, what)| is_there.then_some(what))
}

/// Returns whether cones know all that is in a scene.
#[must_use]
pub fn knows(scene: &Description) -> bool {
    unknown(scene).is_none()
}

impl Coned {
    /// Makes a scene ready.
    ///
    /// # Errors
    /// [`PictureError::Cones`] for a scene in which something is that cones do not know; those of [`narrow`] and of the range proof;
    /// [`Error::Depth`].
    pub fn new(scene: &Description, model: Model, setup: Setup) -> Result<Self, PictureError> {
        let drawn = scene.drawn_by(model);
        let scene = &*drawn;
        if let Some(what) = unknown(scene) {
            return Err(PictureError::Cones(what));
        }
        if setup.depth > MAX_DEPTH {
            return Err(Error::Depth { depth: setup.depth, capacity: MAX_DEPTH as usize }.into());
        }
        let narrowed = narrow::<f64>(scene, setup.aspect)?;
        let limits = narrowed.admit()?.limits;
        let depth = u8::try_from(setup.depth).unwrap_or(u8::MAX);
        if depth > limits.depth {
            narrowed.scene().check_depth(depth)?;
        }
        let model = any_model(model, &scene.air, &narrowed, limits);
        Ok(Self { scene: narrowed, limits, model, setup })
    }

    /// Returns what `draw` makes of the cones of the picture.
    fn with_cones<R>(&self, draw: impl FnOnce(&Cones<'_>) -> R) -> Option<R> {
        let admitted = Admitted::baked(self.scene.scene(), self.limits, rta_core::accelerator::Lists);
        let Setup { depth, cutoff, .. } = self.setup;
        // There is one: the depth was checked.
        let shader: Shader<'_> = Tracer::new(&admitted, self.model.clone(), depth).ok()?;
        let shader = match cutoff {
            #[allow(clippy::cast_precision_loss, reason = "both are small")]
            Some((numerator, denominator)) => shader.with_cutoff(numerator as f64 / denominator as f64),
            None => shader,
        };
        let spreads = &self.scene.spreads;
        let search = Search { world: &admitted, bodies: &spreads.bodies };
        Some(draw(&Cones { search, shader: &shader, roughness: &spreads.roughness }))
    }

    /// Returns the cone over a pixel of a raster, about a place of the image plane: the disc of the pixel's area.
    fn eye(&self, raster: Raster, (right, up): (f64, f64)) -> Beam {
        let Camera { eye, forward, right: width, up: height } = self.scene.camera;
        let pixels = f64::from(raster.width()) * f64::from(raster.height());
        let area = width.length() * height.length() / pixels;
        let tangent = (area / core::f64::consts::PI).sqrt() / forward.length();
        Beam::new(eye, self.scene.camera.direction(right, up), 0.0, tangent.atan())
    }

    /// Calls `put` with the light of rows of the picture on a raster.
    fn drawn(&self, raster: Raster, first: u32, end: u32, put: PutRow<f64>) {
        self.with_cones(|cones| {
            for y in first..end.min(raster.height()) {
                let row = Places::row::<f64>(&Sampler::CENTER, raster, y);
                let pixel = |x| {
                    let place = Sampler::CENTER.place(raster, row, x, 0);
                    cones.light(self.eye(raster, place), &mut ())
                };
                put(&(0..raster.width()).map(pixel).collect::<Vec<_>>());
            }
        });
    }
}

impl Picture<f64> for Coned {
    fn rows(&self, first: u32, end: u32, put: PutRow<f64>) {
        self.drawn(self.setup.raster, first, end, put);
    }

    fn preview_rows(&self, raster: Raster, first: u32, end: u32, put: PutRow<f64>) {
        self.drawn(raster, first, end, put);
    }

    fn sample(
        &self,
        place: (f64, f64),
        _sample: Sample,
        _cache: &mut ShadowCache,
        observer: &mut dyn Observer<f64>,
    ) -> Rgb<f64> {
        let beam = self.eye(self.setup.raster, place);
        self.with_cones(|cones| cones.light(beam, observer)).unwrap_or(Rgb::BLACK)
    }

    fn setup(&self) -> &Setup {
        &self.setup
    }

    fn scene(&self) -> &Narrowed<f64> {
        &self.scene
    }
}

#[cfg(test)]
mod tests;
