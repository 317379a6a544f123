//! The scene readers never panic, and what they read can be written and read again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use rta_scenes::description::Description;
use rta_scenes::error::SceneError;
use rta_scenes::{dat, nff, rta};

fuzz_target!(|text: &[u8]| {
    if let Some(scene) = answered(dat::read(text, "fuzz.dat")) {
        let again = scene.to_dat().expect("what is read can be said");
        let read = dat::read(again.as_bytes(), "again.dat").expect("what is written can be read");
        assert_eq!(read.without_lines(), scene.clone().without_lines(), "{again}");
        round(&scene);
    }
    if let Some(scene) = answered(nff::read(text, "fuzz.nff")) {
        round(&scene);
    }
    if let Some(scene) = answered(rta::read(text, "fuzz.rta")) {
        round(&scene);
    }
});

/// Returns the scene that was read, if there is one. A message is one line and says where.
fn answered(read: Result<Description, SceneError>) -> Option<Description> {
    read.inspect_err(|error| assert!(error.to_string().starts_with("fuzz."))).ok()
}

/// The scene language says all that a scene of any format is.
fn round(scene: &Description) {
    let text = scene.to_rta();
    let read = rta::read(text.as_bytes(), "again.rta").expect("what is written can be read");
    assert_eq!(read.without_lines(), scene.clone().named().without_lines(), "{text}");
}
