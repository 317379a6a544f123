//! A baked program of each illumination model, with its options and with air, draws what the engine draws: its rows, its layers and
//! its set of needs are the scene's.
//!
//! `build.rs` writes the list, from the core's list of models; a new model is tested without a change.

use rta::engine::Settings;
use rta_scenes::bake::TEXELS;
use rta_tests::picture::{Bits, SMALL, by_engine};

use super::baked::draw_spectrum;

/// Makes the test of a baked scene, by the name of its module and the text of its scene file.
macro_rules! drawn {
    ($name:ident: $text:literal) => {
        mod $name {
            #[allow(unreachable_pub)] // a program may use all of it, or re-export it
            mod scene {
                include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));
            }

            #[test]
            fn is_drawn_as_the_engine_draws_it() {
                let [model, further @ ..] = scene::models();
                let got = super::draw_spectrum::<_, _, _, scene::Needs>(
                    (&scene::SCENE, &scene::CAMERA),
                    (model, &further),
                    &scene::FURTHER,
                    (&scene::WEIGHTS, &scene::DISPERSIVE),
                );
                super::check($text, &got);
            }
        }
    };
}

include!(concat!(env!("OUT_DIR"), "/drawn.rs"));

fn check(text: &str, got: &Bits) {
    let mut scene = rta_scenes::read(text.as_bytes(), "models.rta").expect("it was baked");
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes");
    scene.load_pictures(folder.as_ref(), TEXELS).expect("they were baked");
    let settings = Settings { model: scene.model, ..SMALL };
    let want = by_engine(&scene, &settings);
    let model = text.lines().rev().find(|line| line.starts_with("model")).unwrap_or_default();
    let differing = got.0.iter().zip(&want.0).filter(|(got, want)| got != want).count();
    assert_eq!(differing, 0, "of {} pixels of {model}", got.0.len());
    assert!(got.1 == want.1);
}
