//! `--fit`: a scene that does not fit a number format, or has few of its steps, is scaled, or is told by how much it could be.

use std::borrow::Cow;
use std::io::{self, Write};

use rta_core::Error;
use rta_scenes::OutOfRange;
use rta_scenes::description::Description;
use rta_scenes::fit::{Fitted, FloorError, fit, missing};

use super::error::{Hint, PowerOfTwo, RequestError};
use super::scene_file::SceneFile;
use crate::engine::admission::{Refusal, admits, alternatives};
use crate::engine::{EngineError, Format, Model};

/// The bits that a scene must gain by a scale to be told so.
const TOLD: f64 = 2.0;

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
    /// The depth of the rays; 0 where none are traced.
    pub depth: u32,
    /// Whether `--fit` was given.
    pub asked: bool,
}

impl Fit {
    /// Returns the scene as it is, or scaled by a power of two where `--fit` was given and a scale makes it fit, or its picture
    /// more precise. A line on standard error tells the factor.
    #[must_use]
    pub fn scaled<'a>(&self, scene: &'a SceneFile) -> Cow<'a, Description> {
        let (scaled, factor) = self.scaled_by(scene);
        if let Some(factor) = factor {
            tell(&format!("{} is scaled by {} to fit {}", scene.source, PowerOfTwo(factor), self.format));
        }
        scaled
    }

    /// Returns the scene as it is, or scaled as [`Fit::scaled`] has it, and the factor then. Nothing is told.
    #[must_use]
    pub fn scaled_by<'a>(&self, scene: &'a SceneFile) -> (Cow<'a, Description>, Option<f64>) {
        if self.asked
            && let Ok(Fitted::Scaled { factor, scene: scaled, .. }) =
                self.fitted(&scene.description, self.admits(&scene.description))
        {
            return (Cow::Owned(*scaled), Some(factor));
        }
        (Cow::Borrowed(&scene.description), None)
    }

    /// Writes a line on standard error about a scene that is admitted and would be drawn much more precisely with `--fit`.
    pub fn advise(&self, scene: &SceneFile) {
        if !self.asked
            && missing(&scene.description, self.format) >= TOLD
            && let Ok(Fitted::Scaled { factor, gain: Some(gain), .. }) = self.fitted(&scene.description, true)
            && gain >= TOLD
        {
            let (name, format) = (&scene.source, self.format);
            tell(&format!(
                "{name} is small for {format}: --fit scales it by {} and makes its picture {gain:.0} bits more precise",
                PowerOfTwo(factor)
            ));
        }
    }

    /// Returns the error about a scene that the format does not admit, with the formats that do and what scaling could do.
    #[must_use]
    pub fn refused(&self, scene: &SceneFile, reason: Refusal) -> RequestError {
        let others = alternatives(&scene.description, self.format, self.aspect, self.depth);
        let (name, fit) = (scene.source.clone(), self.hint(&scene.description));
        RequestError::Refused { name, format: self.format, reason: Box::new(reason), others, fit }
    }

    /// Returns the error about a scene that could not be made ready to be traced.
    #[must_use]
    pub fn engine_error(&self, scene: &SceneFile, source: EngineError) -> RequestError {
        match source {
            EngineError::Narrow(error) => self.refused(scene, error.into()),
            EngineError::Cones(_)
            | EngineError::Radiosity(_)
            | EngineError::Core(Error::Depth { .. } | Error::Raster { .. }) => {
                RequestError::Engine { name: scene.source.clone(), source }
            }
            EngineError::Core(error) => {
                self.refused(scene, OutOfRange::new(error, &scene.description).into())
            }
        }
    }

    fn hint(&self, scene: &Description) -> Hint {
        match (self.asked, scene.floor.is_some()) {
            // It was scaled, if that could help.
            (true, false) => Hint::NoScale,
            (true, true) => Hint::Floor,
            (false, _) => match self.fitted(scene, false) {
                Ok(Fitted::Scaled { factor, .. }) => Hint::Factor(factor),
                _ => Hint::None,
            },
        }
    }

    /// `is_admitted` is whether the scene is admitted as it is.
    fn fitted(&self, scene: &Description, is_admitted: bool) -> Result<Fitted, FloorError> {
        fit(scene, self.model.unwrap_or(scene.model), self.format, is_admitted, |scene| self.admits(scene))
    }

    fn admits(&self, scene: &Description) -> bool {
        admits(scene, self.format, self.aspect, self.depth)
    }
}

/// Writes a line on standard error.
fn tell(line: &str) {
    // It may be closed: then nobody wants to know.
    let _ = writeln!(io::stderr(), "rta: {line}");
}
