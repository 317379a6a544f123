//! Paths, and scenes at instants of a film.

use rta_core::scene::Object;

use super::{EVERYTHING, accepted, scene};
use crate::accelerator::solid::solids;
use crate::description::Path;
use crate::space::difference;

/// Returns the path of a line.
fn path(line: &str) -> Path {
    scene(&format!("path p {line}")).details.paths.remove(0)
}

#[test]
fn a_path_is_at_its_keyframes_and_stands_still_outside_of_them() {
    for linear in ["", "linear "] {
        let path = path(&format!("{linear}at .25 1 2 3 at .5 4 4 4 at .75 0 9 1"));
        for (instant, place) in [
            (0.0, [1.0, 2.0, 3.0]),
            (0.25, [1.0, 2.0, 3.0]),
            (0.5, [4.0, 4.0, 4.0]),
            (0.75, [0.0, 9.0, 1.0]),
            (1.0, [0.0, 9.0, 1.0]),
        ] {
            assert_eq!(path.place(instant), place, "{linear}{instant}");
        }
    }
}

#[test]
fn a_linear_path_is_straight_and_a_spline_of_equal_steps_too() {
    for line in ["linear at 0 0 0 0 at .5 2 4 6 at 1 4 8 12", "at 0 0 0 0 at .5 2 4 6 at 1 4 8 12"] {
        let path = path(line);
        for step in 0..=20 {
            let t = f64::from(step) / 20.0;
            let off = difference(path.place(t), [4.0 * t, 8.0 * t, 12.0 * t]);
            assert!(off.into_iter().all(|off| off.abs() < 1e-14), "{line} {t}: {off:?}");
        }
    }
}

/// In the middle between two keyframes of equal distances the spline of Catmull and Rom is (9 (b + c) - a - d) / 16.
#[test]
fn a_spline_has_the_values_of_catmull_and_rom() {
    let middle = path("at 0 1 0 0 at .25 3 0 0 at .5 -2 0 0 at .75 7 0 0").place(0.375);
    assert_eq!(middle, [(9.0 * (3.0 - 2.0) - 1.0 - 7.0) / 16.0, 0.0, 0.0]);
}

#[test]
fn a_path_that_ends_where_it_begins_goes_round_without_a_kink() {
    let round = path("at 0 1 0 0 at .25 0 1 0 at .5 -1 0 0 at .75 0 -1 0 at 1 1 0 0");
    let step = 1e-6;
    let [before, after] = [
        difference(round.place(1.0), round.place(1.0 - step)),
        difference(round.place(step), round.place(0.0)),
    ];
    assert!(before[1] > 0.0 && difference(before, after).into_iter().all(|off| off.abs() < 1e-9));
    // All quarters are alike, turned by a right angle.
    let [first, second] = [0.1, 0.35].map(|t| round.place(t));
    assert!((first[0] - second[1]).abs() < 1e-15 && (first[1] + second[0]).abs() < 1e-15);
}

#[test]
fn at_the_beginning_a_scene_is_as_its_statements_have_it() {
    let moving = accepted(EVERYTHING);
    let timed = moving.at(0.0);
    assert!(moving.moves() && !timed.moves());
    // Without a shutter nothing that goes along a path is blurred.
    let unblurred = EVERYTHING.replace("shutter 0 .5", "");
    let still = accepted(&unblurred).at(0.0);
    let lines = unblurred.lines().filter(|line| !line.starts_with("path") && !line.contains("at .75"));
    let mut text = lines.collect::<Vec<_>>().join("\n");
    for name in ["swing", "lift"] {
        text = text.replace(&format!("along {name}"), "");
    }
    assert_eq!(still.without_lines(), accepted(&text).without_lines());
}

#[test]
fn everything_on_a_path_moves_by_what_the_path_moves() {
    let text = |z: f64| {
        format!(
            "path up linear at 0 5 5 5 at 1 5 5 9\nlamp at 0 0 {z} along up\nsphere at 1 0 {z} radius 1 along up\n\
             ellipsoid at 2 0 {z} radii 1 2 3 along up\ncylinder at 3 0 {z} radius 1 along up\n\
             cone from 4 0 {z} radius 1 to 5 0 {z} radius 0 along up\n\
             polygon 0 0 {z} 1 0 {z} 1 1 {z} 0 1 {z} along up\n\
             plane at 0 0 {z} normal 0 1 1 along up\nsphere at 0 0 0 radius 1"
        )
    };
    let moved = scene(&text(1.0)).at(0.5);
    let there = scene(&text(3.0)).at(0.0);
    assert_eq!(moved, there);
}

#[test]
fn a_camera_with_an_aim_turns_and_one_with_a_direction_does_not() {
    let camera = |towards: &str| {
        let text =
            format!("rta 1\npath east linear at 0 0 0 0 at 1 8 0 0\ncamera at 0 -8 2 along east {towards}");
        accepted(&text).at(0.5).camera
    };
    let [looking, aiming] = ["look 0 1 0", "to 0 0 2"].map(camera);
    assert_eq!((looking.eye, aiming.eye), ([4.0, -8.0, 2.0], [4.0, -8.0, 2.0]));
    assert_eq!((looking.view, aiming.view), ([0.0, 1.0, 0.0], [-4.0, 8.0, 0.0]));
    // In the place that it looks at it has no other direction than before.
    let there = camera("to 4 -8 2");
    assert_eq!((there.eye, there.view), ([4.0, -8.0, 2.0], [4.0, 0.0, 0.0]));
}

#[test]
fn the_largest_numbers_stay_numbers() {
    let far = "path p at 0 1e308 0 0 at .5 -1e308 0 0 at 1 1e308 0 0\nsphere at 1e308 0 0 radius 1 along p";
    let moving = scene(far);
    for step in 0..=100 {
        let still = moving.at(f64::from(step) / 100.0);
        assert!(still.spheres[0].position.iter().all(|part| part.is_finite()), "{step}");
    }
}

/// Returns a scene of everything that goes along the path `p`, or that moves.
fn all(path: &str, shutter: &str, along: &str) -> crate::description::Description {
    accepted(&format!(
        "rta 1\n{path}\ncamera at 0 -9 1  look 0 1 0  {shutter}  {along}\nlamp at 0 0 1 {along}\n\
         lamp corner 1 1 1  edges 1 0 0  0 1 0  {along}\nsphere at 1 0 1 radius 1 {along}\n\
         ellipsoid at 2 0 1 radii 1 2 3 {along}\ncylinder at 3 0 1 radius 1 {along}\n\
         cone from 4 0 1 radius 1 to 5 0 1 radius 0 {along}\npolygon 0 0 1 1 0 1 1 1 1 0 1 1 {along}\n\
         plane at 0 0 1 normal 0 1 1 {along}"
    ))
}

#[test]
fn what_goes_along_a_path_has_its_velocity_while_the_shutter_is_open() {
    let line = "path p linear at 0 5 5 5 at 1 9 5 -3";
    for shutter in ["shutter 0 .25", "shutter -.125 .125"] {
        let blurred = all(line, shutter, "along p");
        for instant in [0.25, 0.5] {
            // Without a shutter a path moves nothing while it is open.
            let mut there = all(line, "", "along p  moves 4 0 -8").at(instant);
            there.optics.shutter = blurred.optics.shutter;
            assert_eq!(blurred.at(instant), there);
        }
        // A scene that is drawn without an instant is drawn as it is when the film begins.
        assert!(blurred.has_motion() && blurred.stopped() == blurred.at(0.0).stopped());
        assert_eq!(blurred.in_the_middle(), blurred.at(0.0).in_the_middle());
        let boxes = |scene| solids(scene).into_iter().map(|own| (own.bounds.low, own.bounds.high)).collect();
        let [kept, begun]: [Vec<_>; 2] = [&blurred, &blurred.at(0.0)].map(boxes);
        assert_eq!(kept, begun);
    }
    let unblurred = all(line, "", "along p");
    assert!(!unblurred.has_motion() && !unblurred.at(0.5).has_motion());
}

#[test]
fn while_the_shutter_is_open_things_go_from_where_the_path_is_to_where_it_is() {
    let round = "path p at 0 1 0 0 at .25 0 1 0 at .5 -1 0 0 at .75 0 -1 0 at 1 1 0 0";
    let moving = all(round, "shutter -.05 .15", "along p");
    let path = &moving.details.paths[0];
    // The last is beyond the end, where it goes round.
    for instant in [0.1, 0.3, 0.95] {
        let there = moving.at(instant);
        let ends = there.swept(Object::Sphere(0)).expect("it moves");
        for (end, time) in ends.into_iter().zip([instant - 0.05, instant + 0.15]) {
            let [x, y, z] = there.spheres[0].position;
            let [east, north, up] = end;
            let place = [x + east - 1.0, y + north, z + up - 1.0];
            let want = difference(path.place(f64::rem_euclid(time, 1.0)), path.place(0.0));
            let off = difference(place, want);
            assert!(off.into_iter().all(|off| off.abs() < 1e-12), "{instant} {time}: {off:?}");
        }
    }
    // One that is open for no time shows where the path is.
    let flash = all(round, "shutter .25 .25", "along p").at(0.0);
    assert_eq!(flash.swept(Object::Sphere(0)), Some([[0.0; 3]; 2]));
    assert!(flash.spheres[0].position[0].abs() < 1e-12);
}

#[test]
fn a_camera_with_an_aim_looks_at_it_from_the_middle_of_its_way() {
    let path = "rta 1\npath east linear at 0 0 0 0 at 1 8 0 0\n";
    let text = format!("{path}camera at 0 -8 2  to 0 0 2  along east  shutter 0 .5");
    let moving = accepted(&text).at(0.5);
    assert_eq!((moving.camera.eye, moving.optics.moves), ([4.0, -8.0, 2.0], Some([8.0, 0.0, 0.0])));
    let middle = moving.stopped().camera;
    assert_eq!((middle.eye, middle.view), ([6.0, -8.0, 2.0], [-6.0, 8.0, 0.0]));
}
