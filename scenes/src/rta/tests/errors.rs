//! What is told of texts that are wrong.

use super::refused;

/// Returns what is wrong with a line behind a sound beginning, which has four lines.
fn wrong(line: &str) -> String {
    refused(&format!("rta 1\ncamera at 0 -8 2  look 0 1 0\nlamp at 0 0 9\n# sound so far\n{line}\n"))
}

#[test]
fn the_errors_of_the_law_are_told_as_it_has_them() {
    let begin = "rta 1\ncamera at 0 -8 2  look 0 1 0\n";
    let pad = |line: usize, text: &str| format!("{begin}{}{text}", "\n".repeat(line - 3));
    let cases = [
        ("camera at 0 0 0".to_owned(), "a.rta:1:1: expected \"rta 1\", found \"camera\""),
        (
            pad(7, "sphere ad 0 0 1"),
            "a.rta:7:8: expected \"at\" or \"radius\" of the sphere, found \"ad\" (did you mean \"at\"?)",
        ),
        (
            pad(7, "sphere at 123456 # no more"),
            "a.rta:7:17: expected the y of the sphere's place (a number), found the end of the line",
        ),
        (
            pad(7, "sphere at 1.25 2.5 3  radius -0"),
            "a.rta:7:30: expected the radius of the sphere (a number, not 0), found -0",
        ),
        (
            pad(7, "cylinder at 1.25 2.5 3 radius -1"),
            "a.rta:7:31: expected the radius of the cylinder (a number > 0), found -1",
        ),
        (
            pad(9, "sphere at 0 0 1  radius 1  of chrown"),
            "a.rta:9:31: expected a material defined above, found \"chrown\" (did you mean \"crown\"?)",
        ),
        (
            pad(4, "lamp at 0 0 9 radius 1 radius 2"),
            "a.rta:4:24: expected nothing more of the lamp, found a second \"radius\"",
        ),
        (
            pad(5, "camera at 0 0 0 look 0 1 0"),
            "a.rta:5:1: expected one \"camera\", found a second (the first is in line 2)",
        ),
        (pad(6, "material paint ambient 1.5"), "a.rta:6:24: expected a share from 0 to 1, found 1.5"),
        (
            pad(8, "material x slope .4 share .4 slope .2 share .5"),
            "a.rta:8:45: expected shares of slopes that add up to 1, found .9",
        ),
        (
            pad(3, "model fong"),
            "a.rta:3:7: expected a model (one of rta, whitted, phong, lambert, flat, bouknight, romney, blinn, \
             newell, blinn-full, kay-greenberg, cook-torrance, hall-greenberg), found \"fong\" (did you mean \"phong\"?)",
        ),
        (
            "rta 1\n  camera at 0 0 0\n".to_owned(),
            "a.rta:2:1: expected a statement, found a continuation (a line that begins with white space) with nothing before it",
        ),
        (
            "rta 1\n".to_owned() + &"lamp at 0 0 9\n".repeat(10),
            "a.rta:12:1: expected a camera, found the end of the file",
        ),
    ];
    for (text, told) in cases {
        // Models may come and go in this program; the language has them all.
        if told.contains("one of") {
            let (end, all) = (told.rsplit("), ").next().expect("an end"), refused(&text));
            let begins = all.starts_with("a.rta:3:7: expected a model (one of rta, whitted, phong, ");
            assert!(begins && all.ends_with(end) && all.contains("hall-greenberg"), "{all}");
            continue;
        }
        assert_eq!(refused(&text), told, "{text}");
    }
}

#[test]
fn a_file_begins_with_its_name() {
    for (text, told) in [
        ("", "a.rta:1:1: expected \"rta 1\", found an empty file"),
        ("# rta 1", "a.rta:1:1: expected \"rta 1\", found an empty file"),
        ("rta 2\n", "a.rta:1:1: expected \"rta 1\", found \"rta 2\""),
        ("rta\n1\n", "a.rta:1:1: expected \"rta 1\", found \"rta\""),
        ("rta 1 camera", "a.rta:1:7: expected the end of the line after \"rta 1\", found \"camera\""),
        (
            " rta 1",
            "a.rta:1:1: expected a statement, found a continuation (a line that begins with white space) with nothing before it",
        ),
        (
            "rta 1\n\n # c\n\tsky",
            "a.rta:4:1: expected a statement, found a continuation (a line that begins with white space) with nothing before it",
        ),
        ("rta 1\nsfere", "a.rta:2:1: expected a statement, found \"sfere\" (did you mean \"sphere\"?)"),
        ("rta 1\n5", "a.rta:2:1: expected a statement, found 5"),
        ("\0", "a.rta:1:1: expected a scene, which is text in UTF-8, found a binary file (byte 0x00)"),
    ] {
        assert_eq!(refused(text), told, "{text:?}");
    }
}

#[test]
fn what_does_not_go_together_is_told() {
    for (line, told) in [
        (
            "lamp at 0 0 9 square constant",
            "5:22: expected nothing more of the lamp, found \"constant\" beside \"square\"",
        ),
        (
            "lamp toward 0 0 1 radius 2",
            "5:19: expected nothing more of the lamp, found \"radius\" beside \"toward\"",
        ),
        (
            "lamp toward 0 0 1 square",
            "5:19: expected nothing more of the lamp, found \"square\" beside \"toward\"",
        ),
        ("lamp toward 0 0 0", "5:13: expected the lamp's direction (not zero), found 0 0 0"),
        ("lamp corner 0 0 9", "5:18: expected \"edges\" of the lamp, found the end of the line"),
        (
            "lamp corner 0 0 9 edges 1 0 0 2 0 0",
            "5:25: expected the edges of the lamp (not parallel), found edges without an area between them",
        ),
        (
            "lamp color white",
            "5:17: expected \"at\", \"toward\" or \"corner\" of the lamp, found the end of the line",
        ),
        (
            "sky 1 1 1 horizon white zenith white",
            "5:11: expected nothing more of the sky, found \"horizon\" beside what stands first",
        ),
        ("sky horizon white", "5:18: expected \"zenith\" of the sky, found the end of the line"),
        ("sky map sky.png", "5:9: expected the file of the sky (a name in quotes), found \"sky.png\""),
        ("sky map \"sky.png", "5:9: expected the file of the sky (a name in quotes), found \"\\\"sky.png\""),
        ("sky grey", "5:9: expected the grey of the sky's colour (a number >= 0), found the end of the line"),
        (
            "sky srgb 1 256 0",
            "5:12: expected the green of the sky's colour (a whole number from 0 to 255), found 256",
        ),
        (
            "sky red",
            "5:5: expected the red of the sky's colour (a number >= 0, or grey, srgb, white, black), found \"red\", not a number",
        ),
        (
            "ambient 1 -1 1",
            "5:11: expected the green of the ambient light's colour (a number >= 0), found -1",
        ),
        (
            "ambient 1 1e999 1",
            "5:11: expected the green of the ambient light's colour (a number >= 0), found 1e999, not a finite number",
        ),
        (
            "picture 0 9",
            "5:9: expected the width of the picture (a whole number from 1 to 4294967295), found 0",
        ),
        (
            "picture 9 9 samples 8",
            "5:21: expected the samples of the picture (a square number: 1, 4, 9, 16 ... 1024), found 8",
        ),
        (
            "spectral 8",
            "5:10: expected the number of wavelengths of the spectral (an odd number from 1 to 31), found 8",
        ),
        ("attenuation haze 9 3", "5:20: expected the distance of full haze (a number > 9), found 3"),
        (
            "attenuation haze 9",
            "5:13: expected two numbers behind \"haze\" of the attenuation, found 1 of them",
        ),
        (
            "attenuation mist 9",
            "5:13: expected an attenuation (\"none\", \"warnock\", \"romney\", \"haze\" or \"fog\"), found \"mist\"",
        ),
        (
            "attenuation warnock 9",
            "5:21: expected nothing more behind \"warnock\" of the attenuation, found 9",
        ),
        (
            "attenuation fog .1\nmedium extinction .1",
            "6:1: expected one medium, found a second: fog is a medium too",
        ),
        (
            "medium extinction .1\nattenuation fog .1",
            "6:1: expected one medium, found a second: fog is a medium too",
        ),
        (
            "model lambert mach 2",
            "5:15: expected nothing more of the model lambert, which has no options, found \"mach\"",
        ),
        (
            "model bouknight gloss 2",
            "5:17: expected an option of the model bouknight (\"mach\" or \"p\"), found \"gloss\"",
        ),
        (
            "model bouknight mach 9",
            "5:22: expected the mach of the model bouknight (a whole number from 1 to 3), found 9",
        ),
        (
            "material 9",
            "5:10: expected a name of the material (small letters, then digits and - too), found 9",
        ),
        ("material gold", "5:10: expected a new name of the material, found \"gold\", which is built in"),
        (
            "material a\nmaterial a",
            "6:10: expected a new name of the material, found \"a\", which is defined in line 5",
        ),
        (
            "texture a wood white black\ntexture a wood white black",
            "6:9: expected a new name of the texture, found \"a\", which is defined in line 5",
        ),
        ("material a like b", "5:17: expected a material defined above, found \"b\""),
        ("material a texture stone", "5:20: expected a texture defined above, found \"stone\""),
        (
            "material a metal 1 1 2",
            "5:22: expected the blue of the material's reflectance (a number from 0 to 1), found 2",
        ),
        (
            "material a absorb black",
            "5:19: expected the red of the material's absorption (a number > 0 and at most 1, or grey, srgb, white), found \"black\", not a number",
        ),
        (
            "material a slope .4 slope .2 share 1",
            "5:21: expected the share of the slope before, found \"slope\"",
        ),
        (
            "material a slope .4 share .5 gloss 3 slope .2 share .5",
            "5:38: expected nothing more of the material, found a second \"slope\"",
        ),
        ("material a share 1", "5:12: expected \"like\", \"color\", "),
        (
            "sphere at 0 0 1 radius 1 of gold grey",
            "5:34: expected \"color\", \"moves\" or \"along\" of the sphere, found \"grey\"",
        ),
        (
            "sphere at 0 0 1 radius 1 2",
            "5:26: expected nothing more, or \"color\", \"of\", \"moves\" or \"along\" of the sphere, found 2",
        ),
        ("cone from 0 0 0 to 0 0 1 radius 1", "5:17: expected \"radius\" of the cone, found \"to\""),
        (
            "cone from 0 0 0 radius 1 to 0 0 0 radius 1",
            "5:29: expected the other end of the cone (not where it begins), found the same place",
        ),
        (
            "cone from 0 0 0 radius 0 to 0 0 1 radius 0",
            "5:42: expected a radius of the cone (a number > 0 at one end), found 0 at both",
        ),
        (
            "polygon 0 0 0 1 0 0",
            "5:20: expected the x of the polygon's third corner (a number), found the end of the line",
        ),
        (
            "polygon 0 0 0 1 0 0 1 1 0 0 1 0 normals 0 0 1 0 0 1 0 0 1",
            "5:33: expected 4 normals, one a corner of the polygon, found 3 of them",
        ),
        (
            "triangle 0 0 0 1 0 0 1 1 0 normals 0 0 1 0 0 0 0 0 1",
            "5:42: expected a normal that is not zero, found 0 0 0",
        ),
        ("plane at 0 0 0 normal 0 0 0", "5:23: expected the plane's normal (not zero), found 0 0 0"),
    ] {
        let got = wrong(line);
        assert!(got.starts_with(&format!("a.rta:{told}")), "{line}\n{got}");
    }
    for (camera, told) in [
        ("look 0 0 0", "2:22: expected the camera's direction (not zero), found 0 0 0"),
        ("to 0 0 0", "2:20: expected a place to look at (another than that of the camera), found 0 0 0"),
        (
            "to 0 9 0 up 0 1 0",
            "2:29: expected the camera's up (a direction that is not along the view), found 0 1 0",
        ),
        (
            "to 0 9 0 lens 1 angle 40",
            "2:33: expected nothing more of the camera, found \"angle\" beside \"lens\"",
        ),
        ("to 0 9 0 angle 180", "2:32: expected the angle of the camera (degrees > 0 and < 180), found 180"),
        ("up 0 0 1", "2:25: expected \"look\" or \"to\" of the camera, found the end of the line"),
    ] {
        assert_eq!(refused(&format!("rta 1\ncamera at 0 0 0 {camera}")), format!("a.rta:{told}"));
    }
}

#[test]
fn wrong_paths_are_told() {
    for (line, told) in [
        ("path up at 0 0 0 0", "5:19: expected a second \"at\" of the path, found the end of the path"),
        ("path up", "5:8: expected \"at\" of the path, found the end of the line"),
        ("path up at .5 0 0 0 at .5 0 0 1", "5:24: expected a time of the path after 0.5, found .5"),
        ("path up at .5 0 0 0 at .25 0 0 1", "5:24: expected a time of the path after 0.5, found .25"),
        (
            "path up at 0 0 0 0 at 1.5 0 0 1",
            "5:23: expected the time of the path (a number from 0 to 1), found 1.5",
        ),
        (
            "path up at 0 0 0 at 1 0 0 1",
            "5:18: expected the z of the path's place (a number), found \"at\", not a number",
        ),
        (
            "path a at 0 0 0 0 at 1 0 0 1\npath a at 0 0 0 0 at 1 0 0 1",
            "6:6: expected a new name of the path, found \"a\", which is defined above",
        ),
        (
            "path swing at 0 0 0 0 at 1 0 0 1\nsphere at 0 0 1 radius 1 along swin",
            "6:32: expected a path defined above, found \"swin\" (did you mean \"swing\"?)",
        ),
        ("lamp at 0 0 9 along up", "5:21: expected a path defined above, found \"up\""),
        (
            "path a at 0 0 0 0 at 1 0 0 1\nlamp toward 0 0 1 along a",
            "6:19: expected nothing more of the lamp, found \"along\" beside \"toward\"",
        ),
    ] {
        assert_eq!(wrong(line), format!("a.rta:{told}"));
    }
}
