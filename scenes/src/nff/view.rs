//! The viewpoint.

use core::fmt::Display;

use super::Reader;
use crate::description::{Camera, Side};
use crate::error::{Found, SceneError};
use crate::numbers::{AXES, Numbers, Range};
use crate::space::{Triple, cross, difference, length, unit};
use crate::tokens::Token;

/// How near the upward direction may come to that of view: the sine of the angle between them.
const UPRIGHT: f64 = 1e-9;

/// The entity `v`.
pub(super) struct Viewpoint {
    pub(super) camera: Camera,
    /// The place that is looked at.
    pub(super) at: Triple,
    pub(super) raster: [u32; 2],
    line: u32,
}

impl Reader<'_> {
    pub(super) fn viewpoint(&mut self, entity: Token<'_>) -> Result<(), SceneError> {
        if let Some(Viewpoint { line, .. }) = self.viewpoint {
            return Err(self.wrong(entity, format!("no second viewpoint (the first is in line {line})")));
        }
        self.begin("viewpoint", entity.line, 0);
        self.word("from")?;
        let from = self.tokens.vector(AXES, "from", Range::Any)?;
        self.word("at")?;
        let place = self.tokens.place();
        let at = self.tokens.vector(AXES, "at", Range::Any)?;
        let view = difference(at, from);
        let Some(forward) = unit(view) else {
            return Err(self.vector_error(place, "at (another place than from)", at));
        };
        self.word("up")?;
        let place = self.tokens.place();
        let up = self.tokens.vector(AXES, "up", Range::Any)?;
        if unit(up).is_none_or(|up| length(cross(forward, up)) < UPRIGHT) {
            return Err(self.vector_error(place, "up (a direction that is not along the view)", up));
        }
        self.word("angle")?;
        let place = self.tokens.place();
        let angle = self.tokens.number("the angle", Range::Angle)?;
        self.word("hither")?;
        let hither = self.tokens.number("hither", Range::Any)?;
        self.scene.optics.hither = Some(hither).filter(|hither| *hither > 0.0);
        self.word("resolution")?;
        let width = self.tokens.whole("the pixels of a row (a whole number > 0)", 1, u32::MAX)?;
        let height = self.tokens.whole("the number of rows (a whole number > 0)", 1, u32::MAX)?;
        // The angle leaves out half a row above and half a row below.
        let rows = f64::from(height.max(2));
        let whole = if height > 1 { rows / (rows - 1.0) } else { 1.0 };
        let focal = 0.5 / ((angle.to_radians() / 2.0).tan() * whole);
        if !focal.is_finite() {
            let found = Found::Number(Numbers(&[angle]).to_string());
            return Err(self.tokens.error(place, "an angle that is not next to nothing".into(), found));
        }
        let camera = Camera { eye: from, view, focal, side: Side::Height, up: Some(up) };
        self.viewpoint = Some(Viewpoint { camera, at, raster: [width, height], line: entity.line });
        Ok(())
    }

    /// Goes past a word that must stand here.
    fn word(&mut self, word: &str) -> Result<(), SceneError> {
        let place = self.tokens.place();
        let found = match self.tokens.next() {
            Some(token) if token.text.eq_ignore_ascii_case(word) => return Ok(()),
            Some(token) => Found::word(token.text),
            None => Found::EndOfFile,
        };
        Err(self.tokens.error(place, format!("the word \"{word}\" of the viewpoint"), found))
    }

    /// An error about three numbers together.
    pub(super) fn vector_error(
        &self,
        place: (u32, u32),
        expected: impl Display,
        found: Triple,
    ) -> SceneError {
        self.tokens.error(place, expected.to_string(), Found::Number(Numbers(&found).to_string()))
    }
}
