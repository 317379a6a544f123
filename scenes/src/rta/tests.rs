#![allow(clippy::indexing_slicing)] // a test may panic

mod errors;
mod meaning;
mod paths;
mod quads;
mod round;

use crate::description::Description;

pub(super) const FIRST: &str = include_str!("../../first.rta");
pub(super) const METALS: &str = include_str!("tests/metals.rta");
pub(super) const PRISM: &str = include_str!("tests/prism.rta");
pub(super) const EVERYTHING: &str = include_str!("tests/everything.rta");

/// Returns the scene of a text that is sound.
pub(super) fn accepted(text: &str) -> Description {
    super::read(text.as_bytes(), "a.rta").unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Returns a scene of a camera and a few lines more.
pub(super) fn scene(lines: &str) -> Description {
    accepted(&format!("rta 1\ncamera at 0 -8 2  look 0 1 0\n{lines}"))
}

/// Returns what is wrong with a text.
pub(super) fn refused(text: &str) -> String {
    super::read(text.as_bytes(), "a.rta").err().map_or_else(|| "accepted".into(), |error| error.to_string())
}
