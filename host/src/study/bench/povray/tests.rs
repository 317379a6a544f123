//! What is in POV-Ray's files.

use rta_scenes::{nff, shipped};

use super::lit::Radiosity;
use super::{lit_scene, scene};
use crate::engine::Model;
use crate::request::scene_file::SceneFile;

#[test]
fn everything_is_in_the_file_once() {
    let all = SceneFile::named("hall-22").expect("a shipped scene").expect("it is well formed").description;
    let text = scene(&all, Model::Rta, 5, 4.0 / 3.0).expect("it can be traced");
    let count = |words: &str| text.matches(words).count();
    assert_eq!(count("\ncylinder {"), 6);
    assert_eq!(count("\nsphere { 0, 1 scale"), 6);
    assert_eq!(count("\nsphere { <"), 10 + all.lamps.iter().filter(|lamp| lamp.radius > 0.0).count());
    assert_eq!(count("\nlight_source {"), all.lamps.len());
    assert_eq!(count("\nplane {"), 1);
    assert!(text.contains("max_trace_level 6"));
    // What is used is declared.
    for line in text.lines().filter(|line| !line.starts_with("#declare")) {
        if let Some((_, name)) = line.split_once("material { ") {
            let name = name.split(' ').next().unwrap_or_default();
            assert_eq!(count(&format!("#declare {name} = ")), 1, "{line}");
        }
    }
}

#[test]
fn the_eye_is_where_the_scene_has_it() {
    let balls = nff::read(shipped::BALLS_2.as_bytes(), "balls2.nff").expect("a scene");
    let text = scene(&balls, Model::Phong, 0, 1.0).expect("it can be traced");
    assert!(text.contains("camera { perspective location <2.1, 1.3, 1.7> direction <-0."), "{text}");
    assert!(text.contains("max_trace_level 1 ") && text.contains("background { rgb <0.078, 0.361, 0.753> }"));
    assert!(!text.contains("fade_power"));
}

#[test]
fn cones_and_triangles_keep_their_kind() {
    let text = "v from 0 -4 1 at 0 0 0 up 0 0 1 angle 40 hither 1 resolution 8 8\nl 5 -5 5\n\
        f 1 .5 .25 .5 .5 20 0.25 1.5\nc 0 0 0 1 0 0 1 1\nc 0 0 0 1 0 0 1 0.5\np 3 0 0 0 1 0 0 0 1 0\n\
        pp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 .1 1\n";
    let description = nff::read(text.as_bytes(), "a.nff").expect("a scene");
    let text = scene(&description, Model::Phong, 5, 1.0).expect("it can be traced");
    for words in ["\ncylinder { <0.0, 0.0, 0.0>, <0.0, 0.0, 1.0>, 1.0 open", "1.0, <0.0, 0.0, 1.0>, 0.5 open"]
    {
        assert!(text.contains(words), "{words} in {text}");
    }
    assert_eq!(["\nmesh {", "\ntriangle {", "\nsmooth_triangle {"].map(|w| text.matches(w).count()), [1; 3]);
    assert!(text.contains("transmit 0.25") && text.contains("interior { ior 1.5 }"), "{text}");
}

#[test]
fn a_room_that_is_lit_has_lamps_with_a_size() {
    let room = rta_scenes::read(shipped::CORNELL.as_bytes(), "cornell.rta").expect("a scene");
    let radiosity = Radiosity {
        lamp: 4,
        count: 50,
        nearest: 5,
        error_bound: 0.5,
        recursion: 3,
        step: 0.02,
        smoothing: (0.1, 2),
    };
    let text = lit_scene(&room, Model::Lambert, (5, 1.0), &radiosity).expect("it can be traced");
    let count = |words: &str| text.matches(words).count();
    assert_eq!(
        [
            count("light_source"),
            count("area_light"),
            count("radiosity {"),
            count("emission rgb <17.0, 12.0, 4.0>")
        ],
        [1; 4]
    );
    assert!(
        text.contains("spotlight point_at <2.78")
            && text.contains(", 2.795, 4.487> radius")
            && text.contains("count 50 "),
        "{text}"
    );
    // Without it, it has neither.
    let text = scene(&room, Model::Lambert, 5, 1.0).expect("it can be traced");
    assert!(!text.contains("light_source") && !text.contains("emission"), "{text}");
}
