//! A baked program of a scene whose rays are spread draws what the engine draws, each with what it needs and no more: over lamps that are
//! balls or parallelograms, over a lens, over rough surfaces, and over the time that the shutter is open.
//!
//! `build.rs` writes the list.

use core::marker::PhantomData;

use rta::engine::{Format, Settings};
use rta_core::accelerator::Accelerator;
use rta_core::camera::Camera;
use rta_core::illumination::Illumination;
use rta_core::needs::Needs;
use rta_core::range::Admitted;
use rta_core::sampling::Sobol;
use rta_core::trace::dice::Spread;
use rta_core::trace::moving::{Motion, Moving, Room};
use rta_core::trace::{Distributed, Tracer};
use rta_scenes::bake::SAMPLES;
use rta_scenes::narrow::Narrow;
use rta_scenes::sampler::{Lamps, Sampler, Spreading};
use rta_tests::picture::{Bits, SMALL, by_engine};

use super::baked::{STACK, picture};

/// Makes the test of a baked scene, by the name of its module, its number format, how its lamps are asked, and the text of its scene file.
macro_rules! spread {
    ($name:ident: $format:ident, $way:ident$(($side:literal))?, $text:literal) => {
        mod $name {
            #[allow(unreachable_pub)] // a program may use all of it, or re-export it
            mod scene {
                include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));
            }

            #[test]
            fn is_drawn_as_the_engine_draws_it() {
                let got = super::draw::<_, _, _, scene::Needs, scene::Room>(
                    (&scene::SCENE, &scene::CAMERA),
                    scene::model(),
                    scene::SAMPLES.expect("rays are spread"),
                    (&scene::SPREAD, &scene::MOTIONS),
                );
                let lamps = super::Lamps::$way$(($side))?;
                super::check($text, (super::Format::$format, lamps), &got);
            }
        }
    };
}

include!(concat!(env!("OUT_DIR"), "/spread.rs"));

fn draw<S: Narrow, M: Illumination<S> + Copy, A: Accelerator<S>, N: Needs, R: Room<S>>(
    (scene, camera): (&Admitted<'_, S, A>, &Camera<S>),
    model: M,
    samples: Sobol,
    (spread, motions): (&Spread<'_, S>, &[Motion<S>]),
) -> Bits {
    let tracer: Tracer<_, _, N, STACK, _> =
        Tracer::new(scene, model, SMALL.depth).expect("the stack is deep enough");
    let still = Distributed { tracer, spread, seed: samples.seed() };
    if motions.is_empty() && spread.eye.is_none() {
        return picture(&still, camera, samples);
    }
    picture(&Moving { still, motions, room: PhantomData::<fn() -> R> }, camera, samples)
}

fn check(text: &str, (format, lamps): (Format, Lamps), got: &Bits) {
    let scene = rta_scenes::read(text.as_bytes(), "spread.rta").expect("it was baked");
    let spreading = Spreading::of(&scene, lamps, SAMPLES).expect("rays are spread");
    let settings = Settings { format, model: scene.model, sampling: Sampler::Sobol(spreading), ..SMALL };
    let want = by_engine(&scene, &settings);
    let differing = got.0.iter().zip(&want.0).filter(|(got, want)| got != want).count();
    assert_eq!(differing, 0, "of {} pixels of {text}", got.0.len());
    assert!(got.1 == want.1);
    // It is not the picture of rays that are not spread.
    let still = by_engine(&scene, &Settings { sampling: Sampler::CENTER, ..settings });
    assert!(got.1 != still.1, "{text}");
}
