//! What holds of every text that a scene reader is given, whoever wrote it: for the fuzz target and for the test of its corpus.

use rta_scenes::description::Description;
use rta_scenes::error::SceneError;
use rta_scenes::{dat, nff, rta};

/// Reads bytes by all readers, checks that what is read can be written and read again, and returns whether any reader took them.
///
/// # Panics
/// A reader panics, an error does not say where, or what is written is not read as what was read.
pub fn check(text: &[u8]) -> bool {
    let thesis = answered(dat::read(text, "fuzz.dat"));
    if let Some(scene) = &thesis {
        let again = scene.to_dat().expect("what is read can be said");
        let read = dat::read(again.as_bytes(), "again.dat").expect("what is written can be read");
        assert_eq!(read.without_lines(), scene.clone().without_lines(), "{again}");
    }
    let others = [nff::read(text, "fuzz.nff"), rta::read(text, "fuzz.rta")].map(answered);
    let scenes = others.iter().chain([&thesis]).flatten();
    scenes.map(round).count() > 0
}

/// Returns the scene that was read, if there is one. A message is one line and says where.
fn answered(read: Result<Description, SceneError>) -> Option<Description> {
    let is_told = |error: &SceneError| {
        let told = error.to_string();
        assert!(told.starts_with("fuzz.") && !told.contains('\n'), "{told}");
    };
    read.inspect_err(is_told).ok()
}

/// The scene language says all that a scene of any format is.
fn round(scene: &Description) {
    let text = scene.to_rta();
    let read = rta::read(text.as_bytes(), "again.rta").expect("what is written can be read");
    assert_eq!(read.without_lines(), scene.clone().named().without_lines(), "{text}");
}
