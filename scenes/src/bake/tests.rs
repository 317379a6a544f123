//! What the source of a baked scene says. That it compiles and draws the right picture is seen in `tests/baked.rs` of
//! `rta-tests`.
#![allow(clippy::indexing_slicing)] // a test may panic

use rta_core::needs::Used;

use super::{BakeError, Format, Model, Recipe, module};
use crate::description::{Description, FallOff};
use crate::{dat, shipped};

/// What a scene without coats and wavelengths leaves out.
const UNCOVERED: [&str; 9] =
    ["COATS", "CHECKER", "MARBLE", "WOOD", "IMAGES", "BUMPS", "SURROUNDINGS", "MESHES", "SKY_MAP"];

fn read(text: &str) -> Description {
    dat::read(text.as_bytes(), "scene.dat").expect("a scene")
}

fn source(scene: &Description, recipe: &Recipe) -> String {
    module(scene, "scene", recipe).expect("it fits")
}

#[test]
fn the_model_follows_the_one_that_a_scene_was_made_for() {
    let balls = crate::read(include_bytes!("../../balls2.nff"), "balls2.nff").expect("it ships");
    assert_eq!(balls.model, Model::Phong);
    assert_eq!(read(shipped::GLASS_2).model, Model::Rta);
    let recipe = Recipe { model: balls.model, ..Recipe::new(Format::Q16) };
    assert!(needs(&source(&balls, &recipe), false).contains(&"ATTENUATION"));
    // Its lamps say that they are constant, whatever the model.
    assert!(needs(&source(&balls, &Recipe::new(Format::Q16)), false).contains(&"ATTENUATION"));
    let fading = |fall_off| {
        let mut scene = balls.clone();
        scene.lamps.iter_mut().take(1).for_each(|lamp| lamp.fall_off = fall_off);
        let needs = needs_of(&scene, Model::Rta);
        (needs.attenuation, needs.several_fall_offs)
    };
    assert_eq!(fading(FallOff::OfModel), (true, true));
    assert_eq!(fading(FallOff::Constant), (false, false));
}

/// Returns what a scene needs in q16.
fn needs_of(scene: &Description, model: Model) -> rta_core::needs::Used {
    let narrowed = crate::narrow::narrow::<rta_core::Q16>(scene, 1.0).expect("it fits");
    model.used(&narrowed.scene())
}

/// The names of the needs that are `value`, in the order in which they stand.
fn needs(source: &str, value: bool) -> Vec<&str> {
    let end = format!(": bool = {value};");
    source.lines().filter_map(|line| line.trim().strip_prefix("const ")?.strip_suffix(end.as_str())).collect()
}

#[test]
fn a_scene_needs_what_is_in_it_and_no_more() {
    for (text, without) in [
        (
            shipped::JUGGLER,
            &[
                "ELLIPSOIDS",
                "CONES",
                "TRIANGLES",
                "NORMALS",
                "PLANES",
                "CYLINDERS",
                "TILES",
                "GLASS",
                "FINISH",
                "SEVERAL_LAMPS",
                "SEVERAL_FALL_OFFS",
                "TRANSPARENT_SHADOWS",
            ][..],
        ),
        (
            shipped::HALL_22,
            &[
                "CONES",
                "TRIANGLES",
                "NORMALS",
                "PLANES",
                "TILES",
                "GLASS",
                "FINISH",
                "SEVERAL_FALL_OFFS",
                "TRANSPARENT_SHADOWS",
            ],
        ),
        (
            shipped::GLASS_2,
            &[
                "ELLIPSOIDS",
                "CONES",
                "TRIANGLES",
                "NORMALS",
                "PLANES",
                "CYLINDERS",
                "TILES",
                "FINISH",
                "SEVERAL_FALL_OFFS",
            ],
        ),
    ] {
        for format in [Format::F32, Format::F64, Format::Q16, Format::Q20] {
            let source = source(&read(text), &Recipe::new(format));
            assert_eq!(needs(&source, false), [without, &UNCOVERED].concat());
            assert_eq!(
                needs(&source, true).len() + without.len() + UNCOVERED.len(),
                Used::default().named().len()
            );
        }
    }
}

#[test]
fn the_model_decides_what_is_needed() {
    let recipe = Recipe { model: Model::Whitted, ..Recipe::new(Format::Q16) };
    let mut scene = read(shipped::GLASS_2);
    assert_eq!(
        needs(&source(&scene, &recipe), false),
        [
            &[
                "ELLIPSOIDS",
                "CONES",
                "TRIANGLES",
                "NORMALS",
                "PLANES",
                "CYLINDERS",
                "TILES",
                "FINISH",
                "ATTENUATION",
                "SEVERAL_FALL_OFFS"
            ][..],
            &UNCOVERED
        ]
        .concat()
    );
    // A shiny sphere alone: it reflects in Whitted's model only.
    scene.spheres.remove(0);
    assert!(needs(&source(&scene, &recipe), true).contains(&"MIRROR"));
    assert!(!needs(&source(&scene, &Recipe::new(Format::Q16)), true).contains(&"MIRROR"));
}

#[test]
fn a_scene_out_of_range_is_an_error() {
    let mut scene = read(shipped::GLASS_2);
    let bake = |scene: &Description, format| module(scene, "scene", &Recipe::new(format));
    // A coordinate beyond the format.
    scene.spheres[1].position[0] = 3000.0;
    assert!(matches!(bake(&scene, Format::Q20), Err(BakeError::Narrow(_))));
    assert!(bake(&scene, Format::F32).is_ok());
    // Each coordinate fits, the distance between two of them does not.
    scene.spheres[1].position[0] = 30_000.0;
    scene.spheres[0].position[0] = -30_000.0;
    let error = bake(&scene, Format::Q16).expect_err("too far apart");
    assert!(matches!(error, BakeError::Range(_)), "{error:?}");
    assert!(bake(&scene, Format::F64).is_ok());
}

#[test]
fn the_same_scene_is_always_the_same_source() {
    let scene = read(shipped::HALL_22);
    for format in [Format::F32, Format::Q16] {
        let source = source(&scene, &Recipe::new(format));
        assert_eq!(source, module(&scene, "scene", &Recipe::new(format)).expect("it fits"));
    }
}

#[test]
fn a_name_stays_in_its_comment() {
    let source =
        module(&read(shipped::GLASS_2), "a\nstatic\r*/ \"", &Recipe::new(Format::Q16)).expect("it fits");
    assert!(source.starts_with("// a static */ \" in q16 "));
    assert!(source.lines().nth(1).is_some_and(|line| line.starts_with("// ")));
}
