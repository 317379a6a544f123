//! Baked scenes: the modules that `build.rs` has made of scene files hold the scenes that are read and narrowed here,
//! and are drawn as the engine draws them.

use core::fmt::Debug;

use rta::engine::{Format, Model, Settings};
use rta_core::accelerator::Accelerator;
use rta_core::camera::Camera;
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Phong, Rta, Whitted};
use rta_core::needs::{Needs, Used};
use rta_core::range::Admitted;
use rta_core::raster::{Center, Pixels, Places, Raster};
use rta_core::trace::{Spectrum, Trace, Tracer};
use rta_scenes::accelerator::bvh;
use rta_scenes::bake;
use rta_scenes::description::Description;
use rta_scenes::narrow::{Narrow, narrow};
use rta_scenes::used;
use rta_tests::picture::{Bits, SMALL, bits, by_engine};

/// Capacity of the stack of pending rays: no more than a firmware would reserve for this depth.
pub(super) const STACK: usize = 5;

/// Makes a module with two tests of each baked scene from its name, scene file, number format and illumination model.
macro_rules! baked {
    ($($name:ident: $file:literal, $format:ident, $kind:ident, $model:expr;)*) => {$(
        mod $name {
            use super::*;

            #[allow(unreachable_pub)] // a program may use all of it, or re-export it
            mod scene {
                include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));
            }

            #[test]
            fn is_the_scene() {
                is_scene::<_, scene::Needs>(&scene::SCENE, &scene::CAMERA, &read($file), Model::$kind);
            }

            #[test]
            fn is_drawn_as_the_engine_draws_it() {
                let settings = Settings { format: Format::$format, model: Model::$kind, ..SMALL };
                let got = draw::<_, _, scene::Needs>(&scene::SCENE, &scene::CAMERA, $model);
                assert!(got == by_engine(&read($file), &settings));
            }
        }
    )*};
}

baked! {
    juggler: "../../scenes/juggler.dat", Q16, Rta, Rta;
    juggler_q16: "../../scenes/juggler.dat", Q16, Rta, Rta;
    juggler_q20: "../../scenes/juggler.dat", Q20, Rta, Rta;
    juggler_f32: "../../scenes/juggler.dat", F32, Rta, Rta;
    hall_22_q16: "../../scenes/hall-22.dat", Q16, Rta, Rta;
    hall_22_q20: "../../scenes/hall-22.dat", Q20, Rta, Rta;
    hall_22_f32: "../../scenes/hall-22.dat", F32, Rta, Rta;
    glass_2_q16: "../../scenes/glass-2.dat", Q16, Rta, Rta;
    glass_2_q20: "../../scenes/glass-2.dat", Q20, Rta, Rta;
    glass_2_f32: "../../scenes/glass-2.dat", F32, Rta, Rta;
    glass_2_f64: "../../scenes/glass-2.dat", F64, Rta, Rta;
    opaque_q16: "../boards/scenes/opaque.dat", Q16, Rta, Rta;
    whitted_q16: "../../scenes/hall-22.dat", Q16, Whitted, Whitted::default();
    tiles_q16: "../scenes/tiles.rta", Q16, Rta, Rta;
    tiles_f32: "../scenes/tiles.rta", F32, Rta, Rta;
    solids_q16: "../scenes/solids.nff", Q16, Phong, Phong::default();
    solids_f32: "../scenes/solids.nff", F32, Phong, Phong::default();
    kinds_q16: "../scenes/kinds.nff", Q16, Phong, Phong::default();
    kinds_f32: "../scenes/kinds.nff", F32, Phong, Phong::default();
    balls_2_q16: "../../scenes/balls2.nff", Q16, Phong, Phong::default();
    balls_2_f32: "../../scenes/balls2.nff", F32, Phong, Phong::default();
}

/// Reads a scene file, named from the folder of this package.
fn read(file: &str) -> Description {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    rta_scenes::read(&std::fs::read(path).expect("a scene file"), file).expect("a scene")
}

/// Asserts that a baked scene is the one that is read and narrowed here, and that its set of needs is the smallest.
fn is_scene<S: Narrow, N: Needs>(
    scene: &Admitted<'_, S, impl Accelerator<S> + Debug>,
    camera: &Camera<S>,
    description: &Description,
    model: Model,
) {
    let narrowed = narrow::<S>(description, SMALL.aspect).expect("it was baked");
    // The numbers print exactly.
    let bvh = bvh::build::<S>(description);
    let printed = match bvh.bvh() {
        Some(bvh) => {
            format!("{:?}", narrowed.scene().admit_with(&narrowed.camera, bvh).expect("it was baked"))
        }
        None => format!("{:?}", narrowed.admit().expect("it was baked")),
    };
    assert_eq!(format!("{scene:?}"), printed);
    assert_eq!(format!("{camera:?}"), format!("{:?}", narrowed.camera));
    assert_eq!(Used::of::<N>(), used::by(&scene.scene, model != Model::Rta));
    if model == Model::Rta {
        assert_eq!(used::missing::<N, S>(&scene.scene), None);
    }
}

pub(super) fn draw<S: Narrow, M: Illumination<S>, N: Needs>(
    scene: &Admitted<'_, S, impl Accelerator<S>>,
    camera: &Camera<S>,
    model: M,
) -> Bits {
    let tracer: Tracer<_, _, N, STACK, _> =
        Tracer::new(scene, model, SMALL.depth).expect("the stack is deep enough");
    picture(&tracer, camera, Center)
}

/// Draws a scene as a program does that may have several wavelengths: with the model at each of them, their weights, the scenes at all but
/// the first, and the dispersive materials.
pub(super) fn draw_spectrum<S: Narrow, M: Illumination<S> + Copy, A: Accelerator<S>, N: Needs>(
    (scene, camera): (&Admitted<'_, S, A>, &Camera<S>),
    (model, models): (M, &[M]),
    scenes: &[Admitted<'_, S, A>],
    (weights, dispersive): (&[Rgb<S::Unit>], &[u16]),
) -> Bits {
    let tracer = |(scene, model): (_, &M)| -> Tracer<_, M, N, STACK, A> {
        Tracer::new(scene, *model, SMALL.depth).expect("the stack is deep enough")
    };
    let further: Vec<_> = scenes.iter().zip(models).map(tracer).collect();
    let first = tracer((scene, &model));
    if weights.is_empty() {
        return picture(&first, camera, Center);
    }
    picture(&Spectrum { weights, first, further: &further, dispersive }, camera, Center)
}

pub(super) fn picture<S: Narrow>(tracer: &impl Trace<S>, camera: &Camera<S>, places: impl Places) -> Bits {
    let raster = Raster::new(SMALL.width, SMALL.height).expect("a raster");
    let light: Vec<_> = Pixels::sampled(tracer, camera, raster, places, 0, raster.height()).collect();
    // Fixed point below 256 is exact in f32, and f64 is rounded as by the engine.
    #[allow(clippy::cast_possible_truncation, reason = "to the nearest")]
    let single = |light| S::light_to_f64(light) as f32;
    let linear = light.iter().map(|light| bits(light.map(single))).collect();
    (linear, light.iter().map(|light| light.levels(63)).collect())
}

#[test]
fn a_build_script_and_the_program_bake_the_same() {
    let recipe = bake::Recipe::new(bake::Format::Q16);
    let source = bake::module(&read("../../scenes/juggler.dat"), "../../scenes/juggler.dat", &recipe);
    let baked = include_str!(concat!(env!("OUT_DIR"), "/juggler.rs"));
    assert!(source.expect("it was baked") == baked);
}
