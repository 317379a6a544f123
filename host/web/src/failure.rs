//! Why a page does not get what it asks for.

use core::fmt;

use rta_core::Error;
use rta_scenes::OutOfRange;
use rta_scenes::description::Description;
use rta_scenes::error::SceneError;
use rta_scenes::narrow::NarrowError;

use crate::json;

/// An error, with its place in the scene's text if it has one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Failure {
    /// Line, from 1.
    pub(crate) line: Option<u32>,
    /// Column, from 1, in characters.
    pub(crate) column: Option<u32>,
    /// What is wrong.
    pub(crate) message: String,
}

impl Failure {
    /// An error that has no place in the text.
    pub(crate) fn plain(message: impl fmt::Display) -> Self {
        Self { line: None, column: None, message: message.to_string() }
    }

    /// What a number format cannot hold. The message names the line, and so does the error.
    pub(crate) fn narrow(error: &NarrowError) -> Self {
        let line = |object: &str| object.rsplit_once("(line ")?.1.strip_suffix(')')?.parse().ok();
        Self { line: line(&error.object), ..Self::plain(error) }
    }

    /// What the range proof of the core refuses of a scene.
    pub(crate) fn range(error: Error, scene: &Description) -> Self {
        let line = error.objects().into_iter().flatten().find_map(|object| scene.line_of(object));
        Self { line, ..Self::plain(OutOfRange::new(error, scene)) }
    }

    /// Returns the error as JSON.
    pub(crate) fn json(&self) -> String {
        let whole = |number: u32| number.to_string();
        json::object([
            ("line", json::or_null(self.line, whole)),
            ("column", json::or_null(self.column, whole)),
            ("message", json::text(&self.message)),
        ])
    }
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        let SceneError { line, column, ref expected, ref found, ref note, .. } = error;
        let note = note.as_ref().map_or_else(String::new, |note| format!("; {note}"));
        let message = format!("expected {expected}, found {found}{note}");
        Self { line: Some(line), column: Some(column), message }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}
