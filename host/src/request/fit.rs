//! `--fit`: a scene that does not fit a number format is scaled, or its error tells by how much it could be.

use std::borrow::Cow;
use std::io::{self, Write};

use rta_scenes::description::{self, Description};
use rta_scenes::fit::{FloorError, fit};

use super::error::{Hint, RequestError};
use super::scene_file::SceneFile;
use crate::engine::admission::{Refusal, admits, alternatives};
use crate::engine::{EngineError, Format, Model};

/// The number format and screen that a scene has to fit, and whether it may be scaled to do so.
#[derive(Clone, Copy, Debug)]
pub struct Fit {
    /// The number format.
    pub format: Format,
    /// Width over height of the screen.
    pub aspect: f64,
    /// The illumination model that it is drawn with, which decides whether lamps are attenuated; without one, the model that
    /// the scene was made for.
    pub model: Option<Model>,
    /// Whether `--fit` was given.
    pub asked: bool,
}

impl Fit {
    /// Returns the scene as it is, or scaled by a power of two where `--fit` was given and scaling makes it fit. A line on
    /// standard error tells the factor.
    #[must_use]
    pub fn scaled<'a>(&self, scene: &'a SceneFile) -> Cow<'a, Description> {
        if self.asked
            && let Ok(Some(factor)) = self.factor(&scene.description)
            && factor != 1.0
            && let Ok(scaled) = self.drawn(&scene.description).scaled(factor)
        {
            let name = &scene.source;
            // Standard error may be closed: then nobody wants to know.
            let _ = writeln!(io::stderr(), "rta: {name} is scaled by {factor} to fit {}", self.format);
            return Cow::Owned(Description { model: scene.description.model, ..scaled });
        }
        Cow::Borrowed(&scene.description)
    }

    /// Returns the error about a scene that the format does not admit, with the formats that do and what scaling could do.
    #[must_use]
    pub fn refused(&self, scene: &SceneFile, reason: Refusal) -> RequestError {
        let others = alternatives(&scene.description, self.format, self.aspect);
        let (name, fit) = (scene.source.clone(), self.hint(&scene.description));
        let line = reason.object().and_then(|object| scene.description.line_of(object));
        RequestError::Refused { name, format: self.format, reason: Box::new(reason), line, others, fit }
    }

    /// Returns the error about a scene that could not be made ready to be traced, with what scaling could do if its numbers are
    /// the reason.
    #[must_use]
    pub fn engine_error(&self, scene: &SceneFile, source: EngineError) -> RequestError {
        let fit = match &source {
            EngineError::Narrow(_) | EngineError::Core(rta_core::Error::Range(_)) => {
                self.hint(&scene.description)
            }
            EngineError::Core(_) => Hint::None,
        };
        RequestError::Engine { name: scene.source.clone(), source, fit }
    }

    fn hint(&self, scene: &Description) -> Hint {
        match self.factor(scene) {
            Ok(Some(factor)) if factor != 1.0 => Hint::Factor(factor),
            Ok(None) if self.asked => Hint::NoScale,
            Err(FloorError) if self.asked => Hint::Floor,
            _ => Hint::None,
        }
    }

    fn factor(&self, scene: &Description) -> Result<Option<f64>, FloorError> {
        fit(&self.drawn(scene), |scene| admits(scene, self.format, self.aspect))
    }

    /// The scene as if it were made for the model that it is drawn with.
    fn drawn(&self, scene: &Description) -> Description {
        let model = match self.model.map(Model::is_attenuated) {
            None => scene.model,
            Some(true) => description::Model::Rta,
            Some(false) => description::Model::Phong,
        };
        Description { model, ..scene.clone() }
    }
}
