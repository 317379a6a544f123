//! NFF scenes, and scenes that are scaled to fit.

use std::fs;
use std::io::Write;
use std::process::{Output, Stdio};

use super::folder::{Folder, SCENE, decoder};

const BALLS: &str = rta_scenes::shipped::BALLS_2;

/// A small scene in NFF.
const SMALL: &str = "\
v from 0 -4 1 at 0 0 0 up 0 0 1 angle 40 hither 1 resolution 32 24
b .2 .3 .4
l 5 -5 5
f 1 .5 .25 .5 .5 20 0 1
s 0 0 0 1
";

/// The same in a world a hundred thousand times as large.
const LARGE: &str = "\
v from 0 -4e5 1e5 at 0 0 0 up 0 0 1 angle 40 hither 1 resolution 32 24
b .2 .3 .4
l 5e5 -5e5 5e5
f 1 .5 .25 .5 .5 20 0 1
s 0 0 0 1e5
";

fn folder() -> Folder {
    let folder = Folder::new();
    for (name, text) in [("balls2.nff", BALLS), ("small.nff", SMALL), ("large.nff", LARGE)] {
        folder.scene(name, text);
    }
    folder
}

#[test]
fn a_picture_is_as_large_as_its_scene_says() {
    let folder = folder();
    let size = |name: &str, args: &[&str]| {
        folder.renders(&[&[name, "-o", "x.png"], args].concat());
        let reader = decoder(&folder.path("x.png"));
        let info = reader.info();
        (info.width, info.height, info.pixel_dims.map(|dims| (dims.xppu, dims.yppu)))
    };
    assert_eq!(size("balls2.nff", &["--device", "none"]), (512, 512, None));
    assert_eq!(size("small.nff", &["--device", "none"]), (32, 24, None));
    assert_eq!(size("small.nff", &["--device", "none", "--size", "40x50"]), (40, 50, None));
    assert_eq!(size("small.nff", &[]), (320, 200, Some((6, 5))));
    // What is 320 x 200 in an NFF file has square pixels all the same.
    folder.scene("wide.nff", SMALL.replace("32 24", "320 200"));
    assert_eq!(size("wide.nff", &["--device", "none"]), (320, 200, None));
    assert_eq!(size("wide.nff", &["--device", "none", "--aspect", "4:3"]), (320, 200, Some((6, 5))));
    folder.scene("vast.nff", SMALL.replace("32 24", "70000 2"));
    let vast = ["render", "vast.nff", "-o", "vast.png", "--device", "none"];
    folder.refuses(&vast, &["vast.nff", "70000x2", "65535", "--size"]);
    folder.renders(&["vast.nff", "-o", "vast.png", "--device", "none", "--size", "8x6"]);
}

#[test]
fn the_model_is_the_one_that_the_scene_was_made_for() {
    let folder = folder();
    for (scene, own, other) in [("small.nff", "phong", "rta"), ("scene.dat", "rta", "phong")] {
        let picture = |args: &[&str]| {
            folder.renders(&[&[scene, "-o", "-", "--device", "none", "--size", "32x24"], args].concat())
        };
        let png = picture(&[]);
        assert!(png == picture(&["--model", own]) && png != picture(&["--model", other]), "{scene}");
        let hash = |args: &[&str]| folder.prints(&[&["hash", scene, "--size", "32x24"], args].concat());
        assert_eq!(hash(&[]), hash(&["--model", own]));
        assert_ne!(hash(&[]), hash(&["--model", other]));
        let baked = |args: &[&str]| folder.prints(&[&["bake", scene, "-o", "-"], args].concat());
        assert_eq!(baked(&[]), baked(&["--model", own]));
        assert_ne!(baked(&[]), baked(&["--model", other]));
        let explained =
            |args: &[&str]| folder.prints(&[&["explain", scene, "--pixel", "16,12"], args].concat());
        assert_eq!(explained(&[]), explained(&["--model", own]));
        assert!(explained(&[]).contains(&format!("model {own}")));
    }
    assert!(folder.prints(&["explain", "small.nff", "--pixel", "31,23"]).contains("pixel 31,23 of 32x24"));
    folder.refuses(&["explain", "small.nff", "--pixel", "32,23"], &["32,23", "columns 0 to 31"]);
    let shown = folder.rta(&["show", "balls2.nff", "--size", "40x25"]);
    assert!(String::from_utf8(shown.stdout).unwrap().contains("./rta-balls2-vga.png"));
}

#[test]
fn errors_are_about_the_format_of_the_file() {
    let folder = folder();
    folder.scene("BAD.NFF", SMALL.replace("s 0 0 0 1", "s 0 0 0 x"));
    let words = ["BAD.NFF:5:9: expected the radius of sphere 1 (a number, not 0), found \"x\", not a number"];
    folder.refuses(&["render", "BAD.NFF", "-o", "out.png"], &words);
    folder.refuses(&["show", "BAD.NFF"], &words);
    folder.refuses(&["bake", "BAD.NFF", "-o", "bad.rs"], &words);
    folder.scene("bad.nff", SMALL.replace("angle", "angel"));
    folder.refuses(&["check", "bad.nff"], &["bad.nff:1:33: expected the word \"angle\"", "found \"angel\""]);
    folder.scene("bad.nff", SMALL.replace("b .2", "qq .2"));
    folder.refuses(
        &["hash", "bad.nff"],
        &[
            "bad.nff:2:1: expected an entity (one of v, b, l, f, s, c, p and pp)",
            "found \"qq\"; --lenient reads",
        ],
    );
    folder.scene("bad.nff", SCENE);
    folder.refuses(&["hash", "bad.nff"], &["bad.nff:1:1: expected an entity"]);
    folder.scene("bad.dat", SMALL);
    folder.refuses(&["hash", "bad.dat"], &["bad.dat:1:1: expected the x of the observer position"]);
}

#[test]
fn standard_input_is_recognised_by_what_it_says() {
    let folder = folder();
    for (text, name) in [(SMALL, "small.nff"), (SCENE, "scene.dat")] {
        let args = ["-o", "-", "--as", "ppm", "--device", "none", "--size", "32x24"];
        let mut command = folder.command(&[&["render", "-q", "-"], &args[..]].concat());
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
        let piped = child.wait_with_output().unwrap().stdout;
        assert!(piped == folder.renders(&[&[name], &args[..]].concat()), "{name}");
    }
}

#[test]
fn a_scene_that_does_not_fit_is_scaled_if_that_is_asked() {
    let folder = folder();
    let args = ["--device", "none", "--as", "ppm", "-o", "-", "--format", "q16"];
    folder.refuses(
        &[&["render", "large.nff"], &args[..]].concat(),
        &["large.nff", "--fit would scale it by 0."],
    );
    folder.refuses(&["check", "large.nff"], &["large.nff", "; it fits f32", "--fit would scale it by 0."]);
    folder.refuses(&["bake", "large.nff", "-o", "large.rs"], &["--fit would scale it by 0."]);
    folder.refuses(&["explain", "large.nff", "--pixel", "1,1"], &["--fit would scale it by 0."]);
    folder.refuses(&["hash", "large.nff"], &["large.nff does not fit q16", "--fit would scale it by 0."]);
    for command in [
        &[&["render", "-q", "large.nff"], &args[..]].concat()[..],
        &["check", "large.nff"],
        &["bake", "large.nff", "-o", "-"],
        &["explain", "large.nff", "--pixel", "1,1"],
        &["hash", "large.nff", "--size", "8x8"],
        &["show", "large.nff", "--format", "q16", "--size", "8x8"],
    ] {
        let Output { status, stdout, stderr } = folder.rta(&[command, &["--fit"]].concat());
        let told = String::from_utf8(stderr).unwrap();
        assert!(status.success() && !stdout.is_empty(), "{command:?}: {told}");
        assert!(told.starts_with("rta: large.nff is scaled by 0."), "{command:?}: {told}");
        assert!(told.ends_with(" to fit q16\n") && told.lines().count() == 1, "{command:?}: {told}");
    }
    // It is the picture of the small scene, but for rounding: the factor is no power of ten.
    for model in ["phong", "rta"] {
        let large =
            folder.rta(&[&["render", "large.nff", "--fit", "--model", model], &args[..]].concat()).stdout;
        let exact = folder.renders(&[
            "large.nff",
            "--device",
            "none",
            "--as",
            "ppm",
            "-o",
            "-",
            "--format",
            "f64",
            "--model",
            model,
        ]);
        assert_eq!(large.len(), exact.len());
        let far = large.iter().zip(&exact).filter(|(a, b)| a.abs_diff(**b) > 2).count();
        assert!(far * 100 < exact.len(), "{model}: {far} of {}", exact.len());
    }
}

#[test]
fn a_scene_that_gains_by_a_scale_is_told_so() {
    let folder = folder();
    let args = ["--device", "none", "--as", "pfm", "-o", "-", "--format", "q16"];
    let small = [&["render", "small.nff"], &args[..]].concat();
    let advice = "rta: small.nff is small for q16: --fit scales it by 2048 and makes its picture 3 bits more precise\n";
    for command in [&small[..], &["check", "small.nff"]] {
        let Output { status, stdout, stderr } = folder.rta(command);
        assert!(status.success() && !stdout.is_empty(), "{command:?}");
        // After it, `render` tells what it has drawn.
        assert!(String::from_utf8(stderr).unwrap().starts_with(advice), "{command:?}");
        let told = folder.rta(&[command, &["--fit"]].concat()).stderr;
        let scaled = "rta: small.nff is scaled by 2048 to fit q16\n";
        assert!(String::from_utf8(told).unwrap().starts_with(scaled), "{command:?}");
    }
    assert!(folder.rta(&small).stdout != folder.rta(&[&small[..], &["--fit"]].concat()).stdout);
    // A scene that is large enough, one with a floor and floats gain nothing, and are left alone.
    folder.scene("wide.nff", SMALL.replace("l 5 -5 5", "l 70 -70 70"));
    for (scene, format) in
        [("wide.nff", "q16"), ("scene.dat", "q16"), ("small.nff", "f32"), ("small.nff", "f64")]
    {
        folder.prints(&["check", scene, "--format", format]);
        folder.prints(&["check", scene, "--format", format, "--fit"]);
    }
}

#[test]
fn a_scene_that_no_scale_helps_says_so() {
    let folder = folder();
    folder.scene("far.dat", SCENE.replace("0 0 1   1 1 1   1   2", "0 90000 1   1 1 1   1   2"));
    let words = ["far.dat", "sphere 1", "90001"];
    folder.refuses(
        &["check", "far.dat", "--fit"],
        &[&words[..], &["a scene with a floor cannot be scaled"]].concat(),
    );
    let render = ["render", "far.dat", "-o", "x.png", "--format", "q16"];
    folder.refuses(&[&render[..], &["--fit"]].concat(), &[&words[..], &["a floor cannot"]].concat());
    let stderr = folder.rta(&render).stderr;
    assert!(!String::from_utf8(stderr).unwrap().contains("--fit"));
    folder.scene("bright.nff", SMALL.replace("f 1", "f 9"));
    let message = String::from_utf8(folder.rta(&["check", "bright.nff"]).stderr).unwrap();
    assert!(message.contains("sphere 1") && !message.contains("--fit"), "{message}");
    folder.refuses(&["check", "bright.nff", "--fit"], &["sphere 1", "--fit finds no scale at which it fits"]);
    assert!(fs::metadata(folder.path("x.png")).is_err());
}

#[test]
fn warnings_are_told_on_standard_error_and_lenience_is_asked_for() {
    let folder = folder();
    folder.scene("odd.nff", SMALL.replace("b .2", "tess 4\nb .2"));
    folder.scene("unknown.nff", SMALL.replace("b .2", "torus 1 2 3\nb .2"));
    let args = |name| ["render", name, "-o", "x.ppm", "--device", "none", "--quiet"];
    let told = |args: &[&str]| {
        let Output { status, stdout, stderr } = folder.rta(args);
        assert!(status.success() && stdout.is_empty(), "{args:?}");
        String::from_utf8(stderr).unwrap()
    };
    let warning = |name, word| {
        format!(
            "rta: warning: {name}:2: \"{word}\" and the rest of its line are passed over: it is no entity that rta draws\n"
        )
    };
    assert_eq!(told(&args("odd.nff")), warning("odd.nff", "tess"));
    folder.refuses(&args("unknown.nff"), &["found \"torus\"; --lenient reads past such lines"]);
    let lenient = [&args("unknown.nff")[..], &["--lenient"]].concat();
    assert_eq!(told(&lenient), warning("unknown.nff", "torus"));
    for command in
        [&["check", "unknown.nff"][..], &["hash", "unknown.nff"], &["bake", "unknown.nff", "-o", "-"]]
    {
        let output = folder.rta(&[command, &["--lenient"]].concat());
        assert!(output.status.success() && output.stderr.starts_with(b"rta: warning: "), "{command:?}");
    }
    // A wall that turns its back on the eye.
    folder.scene("wall.nff", SMALL.to_owned() + "p 3 -9 -2 -9  0 -2 9  9 -2 -9\n");
    let one_sided = [&args("wall.nff")[..], &["--one-sided"]].concat();
    assert!(told(&args("wall.nff")).is_empty());
    let wall = fs::read(folder.path("x.ppm")).unwrap();
    assert_eq!(
        told(&one_sided),
        "rta: warning: wall.nff: all polygons turn their invisible side to the observer\n"
    );
    assert_ne!(fs::read(folder.path("x.ppm")).unwrap(), wall);
    assert!(told(&args("small.nff")).is_empty());
    assert_ne!(fs::read(folder.path("x.ppm")).unwrap(), wall);
}

#[test]
fn large_files_are_read_and_refusals_name_lines() {
    let folder = folder();
    // Most of it is a comment: what counts is that 64 MiB are no limit.
    let comment = "# 0123456789 abcdef\n".repeat((66 << 20) / 20);
    folder.scene("long.nff", comment.clone() + SMALL);
    assert!(folder.prints(&["check", "long.nff", "--format", "f32"]).contains("long is admitted to f32"));
    folder.scene("far.nff", SMALL.to_owned() + "s 20000 0 0 1\ns -20000 0 0 1\n");
    folder.refuses(&["check", "far.nff", "--format", "q20"], &["sphere 2 (line 6) is out of q20's range"]);
    let refused = folder.rta(&["check", "far.nff", "--format", "q16"]);
    let message = String::from_utf8(refused.stderr).unwrap();
    assert!(
        message.contains("sphere 2 (line 6) and ") && message.contains("distance between two places"),
        "{message}"
    );
}
