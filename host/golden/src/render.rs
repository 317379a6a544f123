//! A scene file into a picture.

use std::fs;
use std::path::Path;

use rta_core::Error;
use rta_core::accelerator::Accelerator;
use rta_core::needs::Everything;
use rta_core::trace::Tracer;
use rta_scenes::accelerator::bvh;
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrowed, narrow};
use rta_scenes::shading::{Shade, any_model};
use rta_scenes::{Format, Model, OutOfRange, in_format};

use crate::error::DrawError;
use crate::picture::Picture;
use crate::screen::Screen;

/// The deepest recursion: the capacity of the tracer's stack of pending rays.
const STACK: usize = 32;

/// How a scene is drawn. The default is what `rta hash` draws: on a VGA, in `q16`, with the model that the scene was made for, to
/// depth 5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Render {
    /// The screen that it is drawn for.
    pub screen: Screen,
    /// The number format. Pictures in `q16` and `q20` are the same on every machine; those in `f32` and `f64` need not be.
    pub format: Format,
    /// The illumination model, or that which the scene was made for: `Phong` for NFF, else `Rta`.
    pub model: Option<Model>,
    /// Reflections and refractions that a ray is followed through, 0 to 32.
    pub depth: u32,
}

impl Default for Render {
    fn default() -> Self {
        Self { screen: Screen::VGA, format: Format::Q16, model: None, depth: 5 }
    }
}

impl Render {
    /// Draws a scene file, `.dat`, `.nff` or `.p3f`. Its path is relative to the folder in which the test runs: Cargo takes that
    /// of the package. What the reader would warn about is passed over.
    ///
    /// # Errors
    /// [`DrawError::Read`] and [`DrawError::Scene`] for a file that is not there or no scene, else [`DrawError::File`] with the
    /// file's name and an error of [`Render::scene`].
    pub fn file(&self, path: impl AsRef<Path>) -> Result<Picture, DrawError> {
        let path = path.as_ref();
        let text = fs::read(path).map_err(|source| DrawError::Read { path: path.to_owned(), source })?;
        let scene = rta_scenes::read(&text, &path.display().to_string())?;
        self.scene(&scene)
            .map_err(|reason| DrawError::File { path: path.to_owned(), reason: Box::new(reason) })
    }

    /// Draws a scene that was read by [`rta_scenes::read`], scaled by [`Description::scaled`], or made otherwise.
    ///
    /// # Errors
    /// [`DrawError::Narrow`] and [`DrawError::Range`] for a scene that does not fit the number format, [`DrawError::Tracer`] for
    /// a depth beyond 32 or beyond the scene's limit, and those of the [`Screen`].
    pub fn scene(&self, scene: &Description) -> Result<Picture, DrawError> {
        in_format!(self.format, S => self.draw::<S>(scene))
    }

    fn draw<S: Shade>(&self, scene: &Description) -> Result<Picture, DrawError> {
        let narrowed = narrow::<S>(scene, self.screen.aspect()?)?;
        let built = bvh::build::<S>(scene);
        let traced = match built.bvh() {
            Some(bvh) => self.search(scene, &narrowed, bvh),
            None => self.search(scene, &narrowed, rta_core::accelerator::Lists),
        };
        traced.map_err(|error| match error {
            DrawError::Tracer(error) if !matches!(error, Error::Depth { .. } | Error::Raster { .. }) => {
                OutOfRange::new(error, scene).into()
            }
            error => error,
        })
    }

    fn search<S: Shade>(
        &self,
        described: &Description,
        narrowed: &Narrowed<S>,
        accelerator: impl Accelerator<S>,
    ) -> Result<Picture, DrawError> {
        let admitted = narrowed.scene().admit_with(&narrowed.camera, accelerator)?;
        let model =
            any_model(self.model.unwrap_or(described.model), &described.air, narrowed, admitted.limits);
        let tracer: Tracer<_, _, Everything, STACK, _> = Tracer::new(&admitted, model, self.depth)?;
        self.screen.trace(&tracer, &narrowed.camera)
    }
}
