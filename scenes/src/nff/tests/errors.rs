//! Files that are no scene: each error names what is wrong and where.

use super::*;

#[test]
fn files_that_hold_no_scene() {
    for text in ["", "\n\n", "\u{feff}", "# nothing\r\n  # here"] {
        assert_eq!(error_of(text), "s.nff:1:1: expected a scene with a viewpoint (v), found an empty file");
    }
    assert_eq!(
        error_of(b"v from\n1 \0"),
        "s.nff:2:3: expected a scene, which is text in UTF-8, found a binary file (byte 0x00)"
    );
    assert_eq!(error_of("b 0 0 0\n l 1 1 1 "), "s.nff:2:10: expected a viewpoint (v), found end of file");
}

#[test]
fn each_wrong_piece_is_named_with_its_place() {
    let cases = [
        (2, "b 1 -1 1", "2:5: expected the green of the background (a number >= 0), found -1"),
        (2, "b 1 1", "3:1: expected the blue of the background (a number >= 0), found \"v\", not a number"),
        (
            2,
            "xy 1",
            "2:1: expected an entity (one of v, b, l, f, s, c, p and pp) or the end of the file, found \"xy\"",
        ),
        (
            2,
            "b 1 1 1 1",
            "2:9: expected an entity (one of v, b, l, f, s, c, p and pp) or the end of the file, found 1",
        ),
        (2, "V", "3:1: expected the word \"from\" of the viewpoint, found \"v\""),
        (4, "eye 1 2 3", "4:1: expected the word \"from\" of the viewpoint, found \"eye\""),
        (4, "1 2 3", "4:1: expected the word \"from\" of the viewpoint, found 1"),
        (4, "from 1 2 nan", "4:10: expected the z of from (a number), found nan, not a finite number"),
        (5, "at 1 2 3", "5:4: expected at (another place than from), found 1 2 3"),
        (5, "to 1 2 3", "5:1: expected the word \"at\" of the viewpoint, found \"to\""),
        (6, "up 0 0 0", "6:4: expected up (a direction that is not along the view), found 0 0 0"),
        (6, "up  0 -7 0", "6:5: expected up (a direction that is not along the view), found 0 -7 0"),
        (6, "at 0 0 1", "6:1: expected the word \"up\" of the viewpoint, found \"at\""),
        (7, "angle 180", "7:7: expected the angle (degrees > 0 and < 180), found 180"),
        (7, "angle 0", "7:7: expected the angle (degrees > 0 and < 180), found 0"),
        (7, "angle 1e-320", "7:7: expected an angle that is not next to nothing, found 1e-320"),
        (7, "fov 9", "7:1: expected the word \"angle\" of the viewpoint, found \"fov\""),
        (8, "hither x", "8:8: expected hither (a number), found \"x\", not a number"),
        (9, "resolution 0 4", "9:12: expected the pixels of a row (a whole number > 0), found 0"),
        (9, "resolution 4 4.5", "9:14: expected the number of rows (a whole number > 0), found 4.5"),
        (10, "l 1 2", "11:1: expected the z of light 1 (a number), found \"l\", not a number"),
        (
            11,
            "l 1 2 3 .5",
            "12:1: expected the green of the colour of light 2 (a number >= 0), found \"f\", not a number",
        ),
        (11, "l 1 2 3 -1 1 1", "11:9: expected the red of the colour of light 2 (a number >= 0), found -1"),
        (
            11,
            "l 1 2 3 1,5",
            "11:9: expected the red of the colour of light 2 (a number >= 0), found \"1,5\", not a number",
        ),
        (12, "f -1 1 1 1 1 1 1 1", "12:3: expected the red of the fill (a number >= 0), found -1"),
        (12, "f 1 1 1 -1 1 1 1 1", "12:9: expected the Kd of the fill (a number >= 0), found -1"),
        (12, "f 1 1 1 1 -1 1 1 1", "12:11: expected the Ks of the fill (a number >= 0), found -1"),
        (12, "f 1 1 1 1 1 -1 1 1", "12:13: expected the Shine of the fill (a number >= 0), found -1"),
        (12, "f 1 1 1 1 1 1 -1 1", "12:15: expected the T of the fill (a number >= 0), found -1"),
        (13, "s 1 2 3 0", "13:9: expected the radius of sphere 1 (a number, not 0), found 0"),
        (
            15,
            "s 1 2 inf 1",
            "15:7: expected the z of the centre of sphere 2 (a number), found inf, not a finite number",
        ),
        (17, "v", "17:1: expected the x of the apex of cone 1 (a number), found \"v\", not a number"),
        (18, "v", "18:1: expected no second viewpoint (the first is in line 3), found \"v\""),
        (
            19,
            "p 2",
            "19:3: expected the number of corners of polygon 1 (a whole number from 3 to 10000), found 2",
        ),
        (
            19,
            "p 10001",
            "19:3: expected the number of corners of polygon 1 (a whole number from 3 to 10000), found 10001",
        ),
        (19, "p 5", "24:1: expected the x of corner 5 of polygon 1 (a number), found \"pp\", not a number"),
        (
            19,
            "p 3",
            "23:1: expected an entity (one of v, b, l, f, s, c, p and pp) or the end of the file, found 0",
        ),
        (
            26,
            "1 0 0 0 0",
            "28:1: expected the z of the normal of corner 3 of polygon 2 (a number), found end of file",
        ),
        (
            27,
            "0 1 0 1",
            "28:1: expected the y of the normal of corner 3 of polygon 2 (a number), found end of file",
        ),
    ];
    for (line, text, message) in cases {
        let error = error_of(with_line(line, text));
        assert_eq!(error.split("; ").next(), Some(&*format!("s.nff:{message}")), "{text}");
    }
}

#[test]
fn entities_that_are_too_short_or_too_long_are_told_where_they_begin() {
    for (line, text, note) in [
        (13, "s 1 2 3", "the sphere that begins in line 13 has 3 of 4 numbers"),
        (13, "s", "the sphere that begins in line 13 has 0 of 4 numbers"),
        (16, "c 0 0 1", "the cone that begins in line 16 has 7 of 8 numbers"),
        (12, "f 1 1 1", "the fill that begins in line 12 has 3 of 8 numbers"),
        (10, "l 1 2", "the light that begins in line 10 has 2 of 3 numbers"),
        (10, "l 1 2 3 4", "the light that begins in line 10 has 4 of 6 numbers"),
        (19, "p 5", "the polygon that begins in line 19 has 13 of 16 numbers"),
        (27, "0 1 0", "the polygon that begins in line 24 has 16 of 19 numbers"),
        (15, "s 4 5 6 -2 7", "the sphere that begins in line 15 has 4 numbers and no more"),
        (2, "b 1 1 1 1", "the background that begins in line 2 has 3 numbers and no more"),
    ] {
        let error = error_of(with_line(line, text));
        assert!(error.ends_with(&format!("; {note}")), "{error}");
    }
    // What is wrong in itself is not too short.
    for (line, text) in [(13, "s 1 2 3 0"), (2, "xy 1"), (7, "angle 200"), (19, "p 2")] {
        assert!(!error_of(with_line(line, text)).contains("; "));
    }
}

#[test]
fn truncated_anywhere_it_is_an_error_or_a_shorter_scene() {
    let whole = accepted(SCENE);
    let ends = SCENE.char_indices().filter(|(_, c)| c.is_whitespace()).map(|(end, _)| end);
    let mut scenes = 0;
    for cut in ends.map(|end| SCENE.split_at(end).0) {
        match read(cut.as_bytes(), "s.nff") {
            Ok(scene) => {
                assert!(scene.spheres.len() <= whole.spheres.len() && scene.camera == whole.camera);
                scenes += 1;
            }
            Err(error) => {
                assert!(["end of file", "an empty file"].contains(&&*error.found.to_string()), "{error}")
            }
        }
    }
    // After the viewpoint, 2 lights, 2 fills, 2 spheres, 2 cones, a polygon; the last light ends in two places.
    assert!((10..20).contains(&scenes), "{scenes}");
}
