//! Scenes in the scene language: drawn, converted, told.

use std::fs;
use std::io::Write;
use std::process::Stdio;

use super::folder::{Folder, SCENE, decoder};

const FIRST: &str = "\
rta 1
camera at 0 -8 2  look 0 1 -.1  lens 1.2
sky horizon .8 .87 .97  zenith .15 .3 .65
floor .9 .9 .9  .1 .1 .1
lamp at -5 -6 8  power 75
ambient grey .25
sphere at 0 0 1  radius 1  color .9 .2 .1  of shiny
sphere at 2 1 1  radius 1  of crown
";

fn hash(folder: &Folder, args: &[&str]) -> String {
    folder.prints(&[&["hash"], args, &["--size", "40x30"]].concat())
}

#[test]
fn a_scene_is_drawn_from_a_file_and_from_standard_input() {
    let folder = Folder::new();
    folder.scene("first.rta", FIRST);
    let file = hash(&folder, &["first.rta"]);
    let mut child = folder.command(&["hash", "-", "--size", "40x30"]);
    let mut child = child.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(FIRST.as_bytes()).unwrap();
    let piped = String::from_utf8(child.wait_with_output().unwrap().stdout).unwrap();
    assert_eq!(file[..16], piped[..16]);
}

#[test]
fn a_scene_says_how_it_is_drawn_unless_the_command_line_does() {
    let folder = Folder::new();
    let line = "picture 60 40  screen 2 1  depth 2  samples 4  cutoff .015625\nmodel phong\n";
    folder.scene("told.rta", FIRST.to_owned() + line);
    let caption = |args: &[&str]| hash(&folder, &[&["told.rta"], args].concat());
    let told = caption(&[]);
    for words in ["model phong", "depth 2", "cut-off 1/64", "4 regular samples"] {
        assert!(told.contains(words), "{words}: {told}");
    }
    let asked = caption(&["--depth", "3", "--cutoff", "0", "--samples", "1", "--model", "rta"]);
    assert!(asked.contains("depth 3") && asked.contains("model rta"), "{asked}");
    assert!(!asked.contains("cut-off") && !asked.contains("samples"), "{asked}");
    folder.renders(&["told.rta", "-o", "told.png", "--device", "none"]);
    let reader = decoder(&folder.path("told.png"));
    let info = reader.info();
    // The screen is 2 wide and 1 high, so that the pixels of 60 x 40 are 4 wide and 3 high.
    assert_eq!((info.width, info.height), (60, 40));
    assert_eq!(info.pixel_dims.map(|dims| (dims.xppu, dims.yppu)), Some((3, 4)));
}

#[test]
fn converted_scenes_are_the_same_and_what_cannot_be_said_is_an_error() {
    let folder = Folder::new();
    folder.scene("first.rta", FIRST);
    folder.prints(&["convert", "scene.dat", "-o", "scene.rta"]);
    folder.prints(&["convert", "scene.rta", "-o", "again.dat"]);
    let hashes = ["scene.dat", "scene.rta", "again.dat"].map(|name| hash(&folder, &[name])[..16].to_owned());
    assert_eq!((&hashes[1], &hashes[2]), (&hashes[0], &hashes[0]));
    let again = rta_scenes::dat::read(&fs::read(folder.path("again.dat")).unwrap(), "again.dat").unwrap();
    let before = rta_scenes::dat::read(SCENE.as_bytes(), "scene.dat").unwrap();
    assert_eq!(again.without_lines(), before.without_lines());
    let shown = folder.prints(&["convert", "scene.dat", "-o", "-"]);
    assert_eq!(shown, fs::read_to_string(folder.path("scene.rta")).unwrap());
    folder.refuses(&["convert", "first.rta", "-o", "first.dat"], &["first.rta", "more than a .dat"]);
    folder.refuses(&["convert", "first.rta", "-o", "first.nff"], &["first.nff", ".rta or .dat"]);
    folder.scene("wrong.rta", "rta 1\nsfere\n");
    folder.refuses(&["render", "wrong.rta", "-o", "x.png"], &["wrong.rta:2:1", "did you mean \"sphere\"?"]);
}

#[test]
fn the_language_is_told() {
    let folder = Folder::new();
    let help = folder.prints(&["help", "scene"]);
    assert_eq!(help, rta_scenes::rta::help());
    assert!(folder.prints(&["help", "convert"]).contains("rta help scene"));
}

#[test]
fn what_the_model_does_not_use_is_told() {
    let folder = Folder::new();
    folder.scene(
        "own.rta",
        FIRST.to_owned() + "material own like bottle  gloss 3\nsphere at 0 3 1 radius 1 of own\n",
    );
    let told = folder.prints(&["check", "own.rta", "--model", "whitted"]);
    assert!(told.contains("\nwhitted does not use of the material own (line 9): absorb\n"), "{told}");
    let told = folder.prints(&["check", "own.rta", "--model", "hall-greenberg"]);
    assert!(!told.contains("does not use"), "{told}");
    // The model of the scene itself.
    folder.scene("flat.rta", FIRST.to_owned() + "model flat\n");
    assert!(
        folder.prints(&["check", "flat.rta"]).contains("flat does not use of the material crown: index\n")
    );
}
