//! Parts of a picture, and the picture that they make.

use std::fs;

use super::film::SCENE as FILM;
use super::folder::{Folder, SCENE};

/// Pictures, their parts, and the options that they are traced with: tables made of samples and of all pixels, tables that grow, diffusion
/// across the seams, several samples a pixel, no device, linear light, rays that are spread, and pixels that are cut.
const PICTURES: [(&str, &[&str]); 8] = [
    ("png", &["--size", "40x25"]),
    ("png", &["--size", "40x25", "--device", "graphigs", "--table", "baked", "--samples", "4"]),
    ("ppm", &["--size", "40x25", "--device", "pixrect", "--table", "tolerant", "--dither", "fs"]),
    ("png", &["--size", "40x25", "--table", "frame", "--format", "q16", "--table-samples", "100"]),
    ("png", &["--size", "40x25", "--device", "none"]),
    ("pfm", &["--size", "40x25", "--device", "none", "--format", "f64"]),
    ("png", &["--size", "40x25", "--sampler", "sobol", "--samples", "4", "--aperture", ".1"]),
    ("png", &["--size", "40x25", "--aa", "whitted"]),
];

/// Writes the parts of a picture.
fn parts(folder: &Folder, kind: &str, options: &[&str], rows: &[&str]) -> Vec<String> {
    let part = |rows: &&str| {
        let name = format!("{rows}.part");
        let linear: &[&str] = if kind == "pfm" { &["--as", "pfm"] } else { &[] };
        folder.renders(&[&["scene.dat", "-o", &name, "--rows", rows], linear, options].concat());
        name
    };
    rows.iter().map(part).collect()
}

#[test]
fn parts_make_the_picture_of_the_whole() {
    let folder = Folder::new();
    for (kind, options) in PICTURES {
        let whole = format!("whole.{kind}");
        folder.renders(&[&["scene.dat", "-o", &whole], options].concat());
        for rows in [&["0..25"][..], &["10..11", "0..10", "11..25"]] {
            let (parts, merged) = (parts(&folder, kind, options, rows), format!("merged.{kind}"));
            let names = parts.iter().map(String::as_str);
            let args: Vec<&str> = ["merge", "-q", "-o", &merged].into_iter().chain(names).collect();
            assert_eq!(folder.prints(&args), "");
            let same = fs::read(folder.path(&whole)).unwrap() == fs::read(folder.path(&merged)).unwrap();
            assert!(same, "{kind} {options:?} {rows:?}");
        }
    }
}

#[test]
fn wrong_parts_are_refused_with_the_reason_and_nothing_is_written() {
    let folder = Folder::new();
    let size: &[&str] = &["--size", "20x12"];
    parts(&folder, "png", size, &["0..5", "4..12", "5..12", "6..12", "5..11"]);
    let merge = |rest: &[&'static str]| [&["merge", "-o", "out.png"], rest].concat();
    folder.refuses(&merge(&["0..5.part", "4..12.part"]), &["rows 4..5 are in 0..5.part and in 4..12.part"]);
    folder.refuses(&merge(&["0..5.part", "5..12.part", "0..5.part"]), &["rows 0..5 are in"]);
    folder.refuses(&merge(&["0..5.part", "6..12.part"]), &["rows 5..6 of 12 are in none of the parts"]);
    folder.refuses(&merge(&["5..11.part", "0..5.part"]), &["rows 11..12 of 12 are in none of the parts"]);
    folder.refuses(&merge(&["5..12.part"]), &["rows 0..5 of 12 are in none of the parts"]);
    folder.refuses(&merge(&[]), &["PARTS"]);
    folder.refuses(&merge(&["0..5.part", "scene.dat"]), &["scene.dat: no part of a picture"]);
    folder.refuses(&merge(&["nothing.part"]), &["nothing.part"]);
    folder.refuses(
        &["merge", "-o", "5..12.part", "--as", "png", "0..5.part", "5..12.part"],
        &["the input itself"],
    );
    folder.refuses(&["merge", "-o", "out.pfm", "0..5.part", "5..12.part"], &["PFM", "linear light"]);

    let second = fs::read(folder.path("5..12.part")).unwrap();
    let spoil = |content: &[u8], word: &str| {
        folder.scene("spoilt.part", content);
        folder.refuses(&merge(&["0..5.part", "spoilt.part"]), &["spoilt.part: ", word]);
    };
    for missing in [1, 100, second.len() / 2] {
        spoil(&second[..second.len() - missing], "cut off");
    }
    spoil(&second[..60], "header");
    spoil(&second[..0], "no part of a picture");
    spoil(&[&second[..], b"1234"].concat(), "4 bytes follow");
    // Whatever bit is changed, it is found.
    for at in (12..second.len()).step_by(7) {
        let mut content = second.clone();
        content[at] ^= 1;
        spoil(&content, "");
    }

    for (other, setting) in [
        (&["--size", "20x13"][..], "size is 20x12"),
        (&["--size", "20x12", "--depth", "2"], "settings"),
        (&["--size", "20x12", "--format", "q16"], "settings"),
        (&["--size", "20x12", "--dither", "fs"], "settings"),
        (&["--size", "20x12", "--aspect", "2"], "aspect"),
        (&["--size", "20x12", "--fit"], "scene"),
    ] {
        folder.renders(&[&["scene.dat", "-o", "other.part", "--rows", "5..12"], other].concat());
        folder.refuses(&merge(&["0..5.part", "other.part"]), &["two pictures", setting]);
    }
    folder.scene("scene.dat", SCENE.replace("0.5 0.5 0.5", "0.5 0.5 0.6"));
    folder.renders(&[&["scene.dat", "-o", "other.part", "--rows", "5..12"], size].concat());
    folder.refuses(&merge(&["0..5.part", "other.part"]), &["two pictures", "scene"]);
}

#[test]
fn rows_that_are_none_are_refused() {
    let folder = Folder::new();
    let render =
        |rows: &'static str| ["render", "scene.dat", "-o", "a.part", "--size", "20x12", "--rows", rows];
    for rows in ["5", "5..5", "6..5", "..5", "5..", "0..5..7", "a..b"] {
        folder.refuses(&render(rows), &["--rows", "A..B"]);
    }
    folder.refuses(&render("5..13"), &["rows 5..13", "0..12"]);
    folder
        .refuses(&["render", "scene.dat", "-o", "a.part", "--rows", "0..5", "--frames", "2"], &["--frames"]);
    folder
        .refuses(&["render", "scene.dat", "-o", "a.part", "--rows", "0..5", "--as", "pfm"], &["PFM", "vga"]);
}

#[test]
fn parts_of_a_film_make_the_film_and_wrong_ones_are_refused() {
    let folder = Folder::new();
    folder.scene("film.rta", FILM);
    let film = |rest: &[&str]| {
        let options = ["film.rta", "--size", "40x25", "--frames", "4", "--device", "graphigs"];
        folder.renders(&[&options[..], rest].concat());
    };
    let kinds: &[&str] = if cfg!(feature = "image") { &["gif", "png", "ppm"] } else { &["png", "ppm"] };
    for only in ["0..1", "1..3", "3..4", "2..4"] {
        film(&["--only", only, "-o", &format!("{only}.part")]);
    }
    for kind in kinds {
        let (whole, merged) = (format!("whole.{kind}"), format!("merged.{kind}"));
        film(&["-o", &whole]);
        folder.prints(&["merge", "-q", "-o", &merged, "3..4.part", "0..1.part", "1..3.part"]);
        let same = fs::read(folder.path(&whole)).unwrap() == fs::read(folder.path(&merged)).unwrap();
        assert!(same, "{kind}");
    }
    let merge = |rest: &[&'static str]| [&["merge", "-o", "out.png", "0..1.part"], rest].concat();
    folder.refuses(&merge(&["1..3.part", "2..4.part"]), &["frames 2..3 are in 1..3.part and in 2..4.part"]);
    folder.refuses(&merge(&["2..4.part"]), &["frames 1..2 of 4 are in none"]);
    folder.refuses(&merge(&["1..3.part"]), &["frames 3..4 of 4 are in none"]);
    #[cfg(feature = "image")]
    folder
        .refuses(&["merge", "-o", "out.bmp", "0..1.part", "1..3.part", "3..4.part"], &["BMP", "one picture"]);
    film(&["--only", "1..4", "--rate", "10", "-o", "slow.part"]);
    folder.refuses(&merge(&["slow.part"]), &["two pictures", "10 in a second"]);
    let render = |rest: &[&'static str]| [&["render", "film.rta", "-o", "a.part"], rest].concat();
    folder.refuses(&render(&["--only", "0..1"]), &["--frames"]);
    folder.refuses(&render(&["--only", "3..5", "--frames", "4"]), &["frames 3..5", "0..4"]);
    folder.refuses(&render(&["--only", "0..1", "--frames", "4", "--one-table"]), &["--one-table"]);
    let linear = ["--only", "0..1", "--frames", "4", "--device", "none", "--as", "pfm"];
    folder.refuses(&render(&linear), &["PFM", "one picture"]);
}
