//! Entries that are too short or too long: the error is found later, and tells where they begin.

use super::{SCENE, accepted, error_of, shipped, with_line};

#[test]
fn an_entry_that_is_too_short_is_told_where_it_begins() {
    for (line, text, note) in [
        // The type is missing, and the next sphere's x is none.
        (10, "-1 -2 -3  0 0 0  1e-3", "the sphere that begins in line 10 has 7 of 8 numbers"),
        (10, "-1 -2 -3  0 0 0", "the sphere that begins in line 10 has 6 of 8 numbers"),
        // What follows is taken for it until something does not fit.
        (6, "4 5 6  .1 .2 .3", "the cylinder that begins in line 6 has 6 of 8 numbers"),
        (11, "1e1 +2 3.  .7 .8 9  2  3", "the sphere that begins in line 11 has 8 of 11 numbers"),
        (13, "0 0 99  4e4 4e4 4e4", "the lamp that begins in line 13 has 6 of 7 numbers"),
        (8, "7 8 9  .4 .5 .6  1 2 3  0 0", "in line 8 more numbers follow the 10 of the ellipsoid"),
    ] {
        let told = error_of(with_line(line, text));
        assert!(told.ends_with(&format!("; {note}")), "{told}");
    }
    // The end of the file amid an object.
    let cut = SCENE.split_once("  1e-3").expect("it is there").0;
    assert!(
        error_of(cut).ends_with("found end of file; the sphere that begins in line 10 has 6 of 8 numbers")
    );
}

#[test]
fn what_is_no_cause_is_not_told() {
    for text in [
        // A wrong number in its own place, and in a file that breaks its lines elsewhere.
        with_line(10, "-1 -2 -3  0 0 0  -1  1"),
        SCENE.lines().skip(1).flat_map(|line| [line, " "]).collect::<String>().replace("1e-3  1", "1e-3  7"),
        with_line(18, "1 1 -1"),
    ] {
        assert!(!error_of(&text).contains("; "), "{}", error_of(&text));
    }
    for (_, text) in shipped::ALL {
        assert!(accepted(text).warnings.is_empty());
    }
}

#[test]
fn colours_above_1_are_counted() {
    let warnings = |text: String| {
        let scene = accepted(text);
        scene.warnings.iter().map(|warning| warning.of_file("s.dat").to_string()).collect::<Vec<_>>()
    };
    let bright = with_line(6, "4 5 6  255 128 0  0.7  2").replace(".9 .8 .7", "200 0 0");
    assert_eq!(
        warnings(bright),
        [
            "s.dat:6: the colour of cylinder 1 of 1 has a register of 255: colours go from 0 to 1; and 2 more like it"
        ]
    );
    // Lamps and the sky may be of any brightness.
    assert!(warnings(with_line(11, "0 0 0 1 1 1 1 0").replace(".7 .8 1\n", "7 8 9\n")).is_empty());
}
