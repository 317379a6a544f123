//! What the source of a baked scene says. That it compiles and draws the right picture is seen in the tests of
//! `rta-baked`.
#![allow(clippy::indexing_slicing)] // a test may panic

use rta_core::needs::Used;

use super::{BakeError, Format, Model, Recipe, module};
use crate::description::{Description, FallOff};
use crate::sampler::{Adaptive, Cutting, Lamps, Spreading};
use crate::{dat, shipped};

/// What a scene without coats, and of which no rays are spread, leaves out.
const UNCOVERED: [&str; 20] = [
    "COATS",
    "CHECKER",
    "MARBLE",
    "WOOD",
    "IMAGES",
    "BUMPS",
    "SURROUNDINGS",
    "EMISSION",
    "MESHES",
    "SKY_MAP",
    "AREA_LAMPS",
    "SQUARE_LAMPS",
    "CONE_LAMPS",
    "LENS",
    "RADIOSITY",
    "AIR_REACH",
    "SPREAD_AIR",
    "EYE_MOTION",
    "GLOSS",
    "GROOVES",
];

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

/// A ball under two lamps, seen by a pinhole: nothing in it spreads rays by itself.
const STILL: &str = "rta 1
camera at 0 -8 2  to 0 0 1  lens 1.2
lamp at -5 -6 8  radius 1  power 75  square
lamp corner 1 -2 4  edges 1 0 0  0 1 0  power 9  square
";

#[test]
fn what_spreads_rays_is_needed_where_it_does() {
    let still = STILL.to_owned() + "sphere at 0 0 1  radius 1  of mirror\nsphere at 0 2 1  radius 1\n";
    let lens = still.replace("lens 1.2", "lens 1.2  aperture .5");
    let rough =
        still.clone() + "material dull like mirror  roughness .2\nsphere at 3 0 1  radius 1  of dull\n";
    let grooved =
        rough.replace("rta 1", "rta 1\nmodel cook-torrance lobes").replace("  roughness .2", "  slope .2");
    let ball = still.lines().filter(|line| !line.contains("corner")).collect::<Vec<_>>().join("\n");
    let moving = still.clone() + "sphere at 3 0 1  radius 1  moves 1 0 0\n";
    let eye = still.replace("lens 1.2", "lens 1.2  moves 0 0 1");
    let air = still.clone() + "medium extinction .1  shadows 16  reach 9\n";
    let beams = air.replace("  reach 9", "");
    let lamp = still.replace("power 75", "moves 0 0 1  power 75");
    let spread = |text: &str, lamps, form: Format| {
        let scene = crate::read(text.as_bytes(), "scene.rta").expect("a scene");
        let spreading = Spreading::of(&scene, lamps, 4);
        let source = source(&scene, &Recipe { spreading, ..Recipe::of(form, &scene) });
        let own = &UNCOVERED[9..];
        let needs = needs(&source, true).into_iter().filter(|need| own.contains(need)).collect::<Vec<_>>();
        let items = ["Sobol> = None;", "MOTIONS: [::rta_core::trace::moving::Motion<Number>; 0]"];
        (needs.join(" "), items.map(|item| source.contains(item)))
    };
    for format in [Format::F32, Format::Q16] {
        for (text, lamps, needed, items) in [
            (&still, Lamps::Point, "", [true, true]),
            (&lens, Lamps::Point, "LENS", [false, true]),
            (&lens, Lamps::Area, "AREA_LAMPS SQUARE_LAMPS LENS", [false, true]),
            (&ball, Lamps::Area, "AREA_LAMPS", [false, true]),
            (&ball, Lamps::Cone, "AREA_LAMPS CONE_LAMPS", [false, true]),
            (&rough, Lamps::Point, "GLOSS", [false, true]),
            (&grooved, Lamps::Point, "GLOSS GROOVES", [false, true]),
            (&moving, Lamps::Point, "", [false, false]),
            (&eye, Lamps::Point, "EYE_MOTION", [false, true]),
            (&lamp, Lamps::Point, "", [false, false]),
            (&air, Lamps::Point, "AIR_REACH", [true, true]),
            (&beams, Lamps::Area, "AREA_LAMPS SQUARE_LAMPS SPREAD_AIR", [false, true]),
            // Nothing is spread of points through still air.
            (&beams, Lamps::Point, "", [true, true]),
        ] {
            assert_eq!(spread(text, lamps, format), (needed.to_owned(), items), "{text}");
        }
    }
}

#[test]
fn pixels_are_antialiased_where_that_is_asked_and_nothing_is_spread_then() {
    let text = STILL.replace("lens 1.2", "lens 1.2  aperture .5") + "sphere at 0 0 1  radius 1\n";
    let scene = crate::read(text.as_bytes(), "scene.rta").expect("a scene");
    let of = |adaptive| source(&scene, &Recipe { adaptive, ..Recipe::of(Format::Q16, &scene) });
    let path = "::rta_core::raster::corners::Cutting";
    for (adaptive, cutting, has_contrast) in [
        (None, "None".to_owned(), false),
        (Cutting::new(3, 7).map(Adaptive::Whitted), format!("{path}::new(3, 7)"), false),
        (Some(Adaptive::Mitchell), "None".to_owned(), true),
    ] {
        let source = of(adaptive);
        assert!(source.contains(&format!("CUTTING: Option<{path}> = {cutting};")), "{source}");
        assert!(source.contains(&format!("CONTRAST: bool = {has_contrast};")), "{source}");
        assert_eq!(needs(&source, true).contains(&"LENS"), adaptive.is_none());
    }
}

#[test]
fn the_range_is_proved_from_all_of_the_lens_and_as_long_as_the_shutter_is_open() {
    let text = |optics: &str, moves: &str| {
        format!(
            "rta 1\npath p at 0 0 0 0  at 1 0 90000 0\ncamera at 0 0 0  look 0 1 0  lens 1{optics}\n\
             sphere at 0 9000 0  radius 1{moves}\n"
        )
    };
    let bake = |text: &str| {
        let scene = crate::read(text.as_bytes(), "scene.rta").expect("a scene");
        module(&scene, "scene", &Recipe::of(Format::Q16, &scene))
    };
    assert!(bake(&text("", "")).is_ok());
    assert!(bake(&text("  aperture 2  focus 9  moves 0 9 0", "  moves 0 9 0")).is_ok());
    // Only a shutter that is told is open for a part of the film.
    assert!(bake(&text("", "  along p")).is_ok());
    for text in [
        text("  aperture 44000  focus 9000000", ""),
        text("", "  moves 0 30000 0"),
        text("  moves 0 40000 0", ""),
        text("", "\nmedium extinction .5  reach 2048"),
        text("", "\nmedium extinction 0  reach 40000"),
        text("", "\nlamp at 0 9000 3  moves 0 30000 0"),
        text("  shutter 0 .5", "  along p"),
        text("  shutter 0 .5  along p", ""),
    ] {
        let error = bake(&text).expect_err("too wide");
        assert!(matches!(error, BakeError::Range(_) | BakeError::Narrow(_)), "{error:?}");
    }
}
