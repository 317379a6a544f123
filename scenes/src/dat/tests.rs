mod bytes;
mod notes;

use super::read;
use crate::description::{
    Camera, Cylinder, Description, Ellipsoid, FallOff, Floor, Lamp, Sky, Sphere, Surface,
};
use crate::shipped;

/// One of everything; each test spoils one line of it.
const SCENE: &str = "\
# a comment
1 2 3
0 1 -0.5
1.5
1
4 5 6  .1 .2 .3  0.7  2
1
7 8 9  .4 .5 .6  1 2 3  0
2
-1 -2 -3  0 0 0  1e-3  1
1e1 +2 3.  .7 .8 9  2  3  .25 .75 1.5
1
0 0 99  4e4 4e4 4e4  0
.9 .8 .7
.1 .2 .3
.4 .5 .6
.7 .8 1
.1 .1 1
";

/// The scene with one of its lines (from 1) replaced.
fn with_line(line: usize, text: &str) -> String {
    SCENE
        .lines()
        .enumerate()
        .map(|(index, old)| if index + 1 == line { text } else { old })
        .flat_map(|line| [line, "\n"])
        .collect()
}

fn error_of(text: impl AsRef<[u8]>) -> String {
    read(text.as_ref(), "s.dat").expect_err("it should be refused").to_string()
}

fn accepted(text: impl AsRef<[u8]>) -> Description {
    read(text.as_ref(), "s.dat").unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn every_number_lands_where_it_belongs() {
    let expected = Description {
        cylinders: vec![Cylinder {
            position: [4.0, 5.0, 6.0],
            color: [0.1, 0.2, 0.3],
            radius: 0.7,
            surface: Surface::Mirror,
            line: 6,
        }],
        ellipsoids: vec![Ellipsoid {
            position: [7.0, 8.0, 9.0],
            color: [0.4, 0.5, 0.6],
            radii: [1.0, 2.0, 3.0],
            inside_only: false,
            surface: Surface::Opaque,
            line: 8,
        }],
        spheres: vec![
            Sphere {
                position: [-1.0, -2.0, -3.0],
                color: [0.0; 3],
                radius: 0.001,
                surface: Surface::Shiny,
                line: 10,
            },
            Sphere {
                position: [10.0, 2.0, 3.0],
                color: [0.7, 0.8, 9.0],
                radius: 2.0,
                surface: Surface::Transparent { ks: 0.25, kt: 0.75, ior: 1.5 },
                line: 11,
            },
        ],
        lamps: vec![Lamp {
            position: [0.0, 0.0, 99.0],
            color: [4e4; 3],
            radius: 0.0,
            fall_off: FallOff::OfModel,
            line: 13,
        }],
        floor: Some(Floor { colors: [[0.9, 0.8, 0.7], [0.1, 0.2, 0.3]], surface: Surface::Opaque }),
        ambient: [0.4, 0.5, 0.6],
        sky: Sky { horizon: [0.7, 0.8, 1.0], zenith: [0.1, 0.1, 1.0] },
        ..Description::empty(Camera::upright([1.0, 2.0, 3.0], [0.0, 1.0, -0.5], 1.5))
    };
    let mut got = accepted(SCENE);
    let warnings = core::mem::take(&mut got.warnings);
    assert_eq!(got, expected);
    assert_eq!(
        warnings.iter().map(|warning| warning.of_file("s.dat").to_string()).collect::<Vec<_>>(),
        ["s.dat:11: the colour of sphere 2 of 2 has a register of 9: colours go from 0 to 1"]
    );
}

#[test]
fn layout_of_the_text_plays_no_part() {
    let expected = accepted(SCENE);
    assert_eq!(accepted(SCENE.replace('\n', "\r\n")), expected);
    assert_eq!(accepted(SCENE.replace('\n', "\r")), expected);
    assert_eq!(accepted(format!("\u{feff}{SCENE}")), expected);
    assert_eq!(accepted(SCENE.trim_end()), expected);
    assert_eq!(accepted(SCENE.replace('\n', "#x 1\n")), expected);
    let one_line: String = SCENE.lines().skip(1).flat_map(|line| [line, " "]).collect();
    assert_eq!(accepted(&one_line).without_lines(), expected.without_lines());
    assert_eq!(accepted(one_line).spheres.first().map(|sphere| sphere.line), Some(1));
}

#[test]
fn what_is_written_reads_back_the_same() {
    let mut scenes: Vec<Description> =
        shipped::ALL.iter().map(|(name, text)| read(text.as_bytes(), name).expect("it ships")).collect();
    scenes.push(accepted(SCENE));
    let mut extreme = accepted(SCENE);
    extreme.camera.eye = [f64::MAX, f64::MIN_POSITIVE, 5e-324];
    extreme.camera.view = [1e300, -0.1 - 0.2, 1.0 / 3.0];
    extreme.lamps.clear();
    extreme.cylinders.iter_mut().for_each(|c| {
        c.surface = Surface::Transparent { ks: 0.1, kt: 0.899_999_5, ior: 1e15 };
    });
    scenes.push(extreme);
    for scene in scenes {
        let text = scene.to_dat().expect("it has a floor");
        assert_eq!(accepted(&text).without_lines(), scene.without_lines(), "{text}");
    }
    let floorless = Description { floor: None, ..accepted(SCENE) };
    assert_eq!(floorless.to_dat(), None);
}

#[test]
fn shipped_scenes_hold_what_their_names_say() {
    let sizes = shipped::ALL.map(|(name, text)| {
        let scene = read(text.as_bytes(), name).expect("it ships");
        (name, scene.cylinders.len(), scene.ellipsoids.len(), scene.spheres.len(), scene.lamps.len())
    });
    assert_eq!(
        sizes,
        [("juggler.dat", 0, 0, 70, 1), ("hall-22.dat", 6, 6, 10, 2), ("glass-2.dat", 0, 0, 2, 2)]
    );
}

#[test]
fn files_that_hold_no_scene() {
    let expected =
        "s.dat:1:1: expected a scene, which begins with the observer position, found an empty file";
    for text in ["", "\n\n", "\u{feff}", "# nothing\r\n  # here"] {
        assert_eq!(error_of(text), expected);
    }
    assert_eq!(
        error_of(b"\x89PNG\r\n\x1a\n\0"),
        "s.dat:1:1: expected a scene, which is text in UTF-8, found a binary file (byte 0x89)"
    );
    assert_eq!(
        error_of(b"1 2\n3 \0"),
        "s.dat:2:3: expected a scene, which is text in UTF-8, found a binary file (byte 0x00)"
    );
}

#[test]
fn truncated_anywhere_it_ends_where_the_file_ends() {
    // Cut behind each number but the last: always an error, always at the end.
    let body = SCENE.split_once('\n').expect("it has lines").1;
    let ends = body.char_indices().filter(|(_, c)| c.is_whitespace()).map(|(end, _)| end);
    let mut cuts = 0;
    for cut in ends.map(|end| body.split_at(end).0).filter(|cut| cut.len() + 1 < body.len()) {
        let error = read(cut.as_bytes(), "s.dat").expect_err("it is cut short");
        assert_eq!(error.found.to_string(), "end of file");
        let last = cut.rsplit('\n').next().map_or(0, str::len);
        assert_eq!((error.line as usize, error.column as usize), (cut.split('\n').count(), last + 1));
        cuts += 1;
    }
    assert!(cuts > 70, "{cuts}");
    assert_eq!(
        error_of("0 0 1  0 1 0  1  0 0 2\n0 0 1  1 1 1  1 0\n0 0 1"),
        "s.dat:3:6: expected the red of the colour of sphere 2 of 2 (a number >= 0), found end of file; \
         the sphere that begins in line 3 has 3 of 8 numbers"
    );
    assert_eq!(
        error_of("1\n"),
        "s.dat:2:1: expected the y of the observer position (a number), found end of file"
    );
}

#[test]
fn each_wrong_number_is_named_with_its_place() {
    let cases = [
        (
            2,
            "1 2 NaN",
            "2:5: expected the z of the observer position (a number), found NaN, not a finite number",
        ),
        (
            2,
            "-inf 2 3",
            "2:1: expected the x of the observer position (a number), found -inf, not a finite number",
        ),
        (
            2,
            "1 1e400 3",
            "2:3: expected the y of the observer position (a number), found 1e400, not a finite number",
        ),
        (
            2,
            "1 0x10 3",
            "2:3: expected the y of the observer position (a number), found \"0x10\", not a number",
        ),
        (
            2,
            "1 2,5 3",
            "2:3: expected the y of the observer position (a number), found \"2,5\", not a number",
        ),
        (2, "é 2 3", "2:1: expected the x of the observer position (a number), found \"é\", not a number"),
        (3, " 0 -0 0.0", "3:2: expected the direction of view (not zero), found 0 -0 0"),
        (3, "1e-400 0 0", "3:1: expected the direction of view (not zero), found 0 0 0"),
        (4, "0", "4:1: expected the focal distance (a number > 0), found 0"),
        (4, "  -1.5", "4:3: expected the focal distance (a number > 0), found -1.5"),
        (5, "-1", "5:1: expected the number of cylinders (a whole number from 0 to 65535), found -1"),
        (5, "1.0", "5:1: expected the number of cylinders (a whole number from 0 to 65535), found 1.0"),
        (6, "4 5 6 .1 .2 .3 0 2", "6:16: expected the radius of cylinder 1 of 1 (a number > 0), found 0"),
        (
            6,
            "4 5 6 .1 -.2 .3 1 2",
            "6:10: expected the green of the colour of cylinder 1 of 1 (a number >= 0), found -.2",
        ),
        (6, "4 5 6 .1 .2 .3 1 4", "6:18: expected the type of cylinder 1 of 1 (0, 1, 2 or 3), found 4"),
        (7, "1e9", "7:1: expected the number of ellipsoids (a whole number from 0 to 65535), found 1e9"),
        (
            8,
            "7 8 9 .4 .5 .6 1 -2 3 0",
            "8:18: expected the y radius of ellipsoid 1 of 1 (a number > 0), found -2",
        ),
        (
            8,
            "7 8 9 .4 .5 .6 1 2 3 1.5",
            "8:22: expected the type of ellipsoid 1 of 1 (0, 1, 2 or 3), found 1.5",
        ),
        (
            9,
            "1000000000",
            "9:1: expected the number of spheres (a whole number from 0 to 65535), found 1000000000",
        ),
        (9, "65536", "9:1: expected the number of spheres (a whole number from 0 to 65535), found 65536"),
        (
            9,
            "two",
            "9:1: expected the number of spheres (a whole number from 0 to 65535), found \"two\", not a number",
        ),
        (10, "1 2 3 0 0 0 -1 1", "10:13: expected the radius of sphere 1 of 2 (a number > 0), found -1"),
        (10, "1 2 3 0 0 0 1 -1", "10:15: expected the type of sphere 1 of 2 (0, 1, 2 or 3), found -1"),
        (
            11,
            "1 2 3 0 0 0 1 3 .5 .4 1.5",
            "11:20: expected the kt of sphere 2 of 2 (ks + kt = 1 within 1e-6), found ks + kt = 0.5 + 0.4",
        ),
        (
            11,
            "1 2 3 0 0 0 1 3 -.5 1.5 1",
            "11:17: expected the ks of sphere 2 of 2 (a number from 0 to 1), found -.5",
        ),
        (
            11,
            "1 2 3 0 0 0 1 3 0 1.1 1",
            "11:19: expected the kt of sphere 2 of 2 (a number from 0 to 1), found 1.1",
        ),
        (
            11,
            "1 2 3 0 0 0 1 3 0 1 0",
            "11:21: expected the index of refraction of sphere 2 of 2 (a number > 0), found 0",
        ),
        (13, "0 0 9 1 1 1 -1", "13:13: expected the radius of lamp 1 of 1 (a number >= 0), found -1"),
        (
            13,
            "0 0 9 -1 1 1 1",
            "13:7: expected the red of the colour of lamp 1 of 1 (a number >= 0), found -1",
        ),
        (14, "-1 1 1", "14:1: expected the red of the first floor colour (a number >= 0), found -1"),
        (15, "1 -1 1", "15:3: expected the green of the second floor colour (a number >= 0), found -1"),
        (16, "1 1 -1", "16:5: expected the blue of the ambient light (a number >= 0), found -1"),
        (17, "-1 1 1", "17:1: expected the red of the colour of the horizon (a number >= 0), found -1"),
        (18, "1 1 -1e9", "18:5: expected the blue of the colour of the zenith (a number >= 0), found -1e9"),
        (18, "1 1 1 1", "18:7: expected the end of the file after the colour of the zenith, found 1"),
        (
            18,
            "1 1 1 \u{1a} x",
            "18:7: expected the end of the file after the colour of the zenith, found \"\\u{1a}\", not a number",
        ),
    ];
    for (line, text, expected) in cases {
        let error = error_of(with_line(line, text));
        assert_eq!(error.split("; ").next(), Some(&*format!("s.dat:{expected}")));
    }
}

#[test]
fn a_count_is_not_believed_before_its_objects_are_read() {
    assert_eq!(
        error_of("0 0 1  0 1 0  1  0 0 65535\n"),
        "s.dat:2:1: expected the x of the position of sphere 1 of 65535 (a number), found end of file"
    );
}

#[test]
fn numbers_at_the_edge_are_taken() {
    for (line, text) in [
        (2, "1e300 -1e300 1e-320"),
        (3, "0 1e300 -1e300"),
        (3, "5e-324 0 0"),
        (4, "5e-324"),
        (11, "1 2 3 0 0 0 1e300 3 0 1 0.1"),
        (11, "1 2 3 0 0 0 1 3 1 0 5e-324"),
        (11, "1 2 3 0 0 0 1 3 .5 .500001 1"),
        (11, "1 2 3 0 0 0 1 3 .5 .499999 1"),
    ] {
        accepted(with_line(line, text));
    }
    for kt in [".5000011", ".4999989"] {
        let error = error_of(with_line(11, &format!("1 2 3 0 0 0 1 3 .5 {kt} 1")));
        assert!(error.starts_with("s.dat:11:20: expected the kt"), "{error}");
    }
}
