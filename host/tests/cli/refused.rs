//! What is refused, and how: scenes, pictures and outputs that cannot be.

use std::fs;

use super::folder::{Folder, SCENE, spoilt};

#[test]
fn scenes_that_cannot_be_read() {
    let folder = Folder::new();
    fs::create_dir(folder.path("folder.dat")).unwrap();
    for (name, word) in [("missing.dat", "No such file"), ("folder.dat", "directory")] {
        folder.refuses(&["render", name, "-o", "out.png"], &[name, word]);
        folder.refuses(&["show", name], &[name, word]);
    }
}

#[test]
fn scenes_that_are_none() {
    let folder = Folder::new();
    folder.refuses_scene("", &["empty file"]);
    folder.refuses_scene(" \n# nothing\n", &["empty file"]);
    folder.refuses_scene(b"\x7fELF\x02\x01\x01\0\0\0", &["binary file"]);
    folder.refuses_scene(b"0 -10 2 \xff\xfe", &["binary file"]);
    folder.refuses_scene(SCENE.trim_end().trim_end_matches('1').trim_end(), &["end of file"]);
    folder.refuses_scene("0 -10", &["end of file"]);
    folder.refuses_scene(format!("{SCENE} 7"), &["bad.dat:8:2", "found 7"]);
}

#[test]
fn scenes_with_wrong_numbers() {
    let folder = Folder::new();
    for number in ["NaN", "nan", "inf", "-inf", "1e400"] {
        folder.refuses_scene(
            spoilt("5 5 0", &format!("5 {number} 0")),
            &["bad.dat:2:7", number, "not a finite"],
        );
    }
    for radius in ["-1", "0", "-0.0", "0e5"] {
        folder.refuses_scene(spoilt("0.4   0", &format!("{radius} 0")), &["radius of cylinder 1", radius]);
        folder.refuses_scene(spoilt("1 0.5 0.25", &format!("1 {radius} 0.25")), &["ellipsoid 1", radius]);
        folder.refuses_scene(spoilt("1   2\n", &format!("{radius} 2\n")), &["radius of sphere 1", radius]);
    }
    folder.refuses_scene(spoilt("80   0.5", "80   -0.5"), &["radius of lamp 1", "-0.5"]);
    folder.refuses_scene(spoilt("0 1 0   1\n", "0 0 0   1\n"), &["direction of view"]);
    folder.refuses_scene(spoilt("0 1 0   1\n", "0 1 0   0\n"), &["focal distance"]);
    for count in ["-1", "1000000000", "1e9", "2.5"] {
        folder.refuses_scene(spoilt("2   0 0 1", &format!("{count}   0 0 1")), &["number of spheres", count]);
    }
    folder.refuses_scene(spoilt("0.25 0.75", "0.25 0.7"), &["sphere 2", "0.7"]);
    folder.refuses_scene(spoilt("0.25 0.75", "-0.25 1.25"), &["sphere 2", "-0.25"]);
    folder.refuses_scene(spoilt("1   2\n", "1   4\n"), &["type of sphere 1", "4"]);
}

#[test]
fn scenes_beyond_fixed_point() {
    let folder = Folder::new();
    folder.scene("far.dat", spoilt("0 0 1   1 1 1   1   2", "0 90000 1   1 1 1   1   2"));
    let args = ["render", "far.dat", "-o", "out.png", "--format"];
    folder.refuses(&[&args[..], &["q16"]].concat(), &["far.dat", "sphere 1", "90001", "32767"]);
    folder.refuses(&["show", "far.dat", "--format", "q16"], &["far.dat", "sphere 1", "90001"]);
    folder.renders(&["far.dat", "-o", "out.png", "--format", "f32"]);
}

#[test]
fn pictures_that_cannot_be() {
    let folder = Folder::new();
    for device in ["vga", "graphigs", "pixrect", "none"] {
        for size in ["0x0", "0x200", "100000x100000", "-1x-1", "big"] {
            let size = format!("--size={size}");
            folder.refuses(&["render", "scene.dat", "-o", "out.png", "--device", device, &size], &["--size"]);
        }
    }
    let render = ["render", "scene.dat", "-o", "out.png"];
    for (options, words) in [
        (["--size", "321x200"], ["321x200", "vga"]),
        (["--aspect", "0"], ["--aspect", "4:3"]),
        (["--depth", "33"], ["--depth", "32"]),
        (["--depth", "4294967296"], ["--depth", "32"]),
        (["--depth", "-1"], ["-1", ""]),
        (["--threads", "0"], ["--threads", "1024"]),
        (["--device", "cga"], ["--device", "graphigs"]),
        (["--format", "f16"], ["--format", "q16"]),
        (["--model", "gouraud"], ["--model", "phong"]),
    ] {
        folder.refuses(&[&render[..], &options].concat(), &words);
        folder.refuses(&[&["show", "scene.dat"][..], &options].concat(), &words[..1]);
    }
}

#[test]
fn outputs_that_cannot_be_written() {
    let folder = Folder::new();
    fs::create_dir(folder.path("folder.png")).unwrap();
    for (output, words) in [
        ("out.jpg", ["out.jpg", ".png"]),
        ("out", ["out", ".pfm"]),
        ("folder.png", ["folder.png", "is a directory"]),
        ("missing/out.png", ["missing/out.png", "No such file"]),
        ("scene.dat/out.png", ["scene.dat/out.png", "cannot write"]),
        ("out.pfm", ["PFM", "--device none"]),
        #[cfg(target_os = "linux")]
        ("/proc/out.png", ["/proc/out.png", "cannot write"]),
        #[cfg(target_os = "linux")]
        ("/dev/full", ["/dev/full", "No space left"]),
    ] {
        folder.refuses(&["render", "scene.dat", "-o", output], &words);
    }
    folder.refuses(&["render", "scene.dat"], &["--output"]);
    // The output is looked at before the scene is read, and before hours of work.
    folder.refuses(&["render", "-", "-o", "missing/out.png"], &["missing/out.png"]);
}

#[test]
fn what_was_there_stays_after_an_error() {
    let folder = Folder::new();
    folder.scene("out.png", "precious");
    folder.scene("bad.dat", "0 0");
    folder.refuses(&["render", "bad.dat", "-o", "out.png"], &["bad.dat"]);
    assert_eq!(fs::read(folder.path("out.png")).unwrap(), b"precious");
    folder.renders(&["scene.dat", "-o", "out.png"]);
    assert!(fs::read(folder.path("out.png")).unwrap().starts_with(b"\x89PNG"));
    assert_eq!(folder.names(), ["bad.dat", "out.png", "scene.dat"]);
}

#[test]
fn a_refusal_names_lines_and_both_ends_of_a_distance() {
    let folder = Folder::new();
    let far = spoilt("2   0 0 1", "2   900 0 1").replace("2 1 1   0 1 1", "-900 1 1   0 1 1");
    folder.scene("far.dat", &far);
    let table = String::from_utf8(folder.rta(&["check", "far.dat", "--format", "q20"]).stdout).unwrap();
    assert!(table.contains("! sphere 2, sphere 1\n"), "{table}");
    folder.scene("far.dat", far.replace("900", "30000"));
    let message = folder.rta(&["check", "far.dat", "--format", "q16"]).stderr;
    let message = String::from_utf8(message).unwrap();
    let words = "sphere 2 (line 5) and sphere 1 (line 4) are out of the number format's range: distance between two places 600";
    assert!(message.contains(words), "{message}");
    let render = ["render", "far.dat", "-o", "x.png", "--format", "q16"];
    folder.refuses(&render, &[words, "does not fit q16", "; it fits f32, f64"]);
    // A sphere that is too large by itself is one thing.
    let view = "v from 0 -4 1 at 0 0 0 up 0 0 1 angle 40 hither 1 resolution 8 6\n";
    folder.scene("large.nff", format!("{view}l 0 -3 2\nf 1 1 1 1 0 1 0 1\ns 0 0 0 20000\n"));
    folder.refuses(
        &["render", "large.nff", "-o", "x.png", "--format", "q16"],
        &["sphere 1 (line 4) is out of"],
    );
    folder.scene("deep.dat", spoilt("1 1 1   1   2", "1.1 1 1   1   2"));
    let deep = ["render", "deep.dat", "-o", "x.png", "--format", "q16", "--depth", "8"];
    folder.refuses(&deep, &["sphere 1 (line 4)", "weight of a ray at depth 8 2.14", "; it fits f32, f64"]);
}
