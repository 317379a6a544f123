//! The options of illumination models do what they say, in pictures.

use rta::engine::{Engine, Format, Settings};
use rta_core::color::Rgb;

const SCENE: &str = include_str!("../../scenes/models.rta");

/// Returns the light of the scene with a line `model`, and other lines.
fn light(lines: &str) -> Vec<Rgb<f32>> {
    of(&format!("{SCENE}{lines}\n"))
}

fn of(text: &str) -> Vec<Rgb<f32>> {
    let scene = rta_scenes::read(text.as_bytes(), "models.rta").expect("a scene");
    assert!(scene.warnings.is_empty(), "{:?}", scene.warnings);
    let settings =
        Settings { width: 64, height: 40, format: Format::F64, model: scene.model, ..Settings::default() };
    let engine = Engine::new(&scene, &settings).expect("it fits");
    let mut light = vec![Rgb::new(0.0, 0.0, 0.0); 64 * 40];
    engine.linear_rows(0, &mut light);
    light
}

/// Asserts that the light of all pixels is the same, to the rounding of parameters.
fn equal(one: &str, other: &str) {
    let (got, want) = (light(one), light(other));
    let worst = got.iter().zip(&want).map(|(a, b)| difference(*a, *b)).fold(0.0, f32::max);
    assert!(worst < 1e-4, "{one} and {other} differ by {worst}");
}

fn difference(a: Rgb<f32>, b: Rgb<f32>) -> f32 {
    let Rgb { r, g, b } = a.zip(b, |a, b| (a - b).abs());
    r.max(g).max(b)
}

/// Asserts that more than `pixels` are different.
fn differ(one: &str, other: &str, pixels: usize) {
    let (got, want) = (light(one), light(other));
    let count = got.iter().zip(&want).filter(|(a, b)| difference(**a, **b) > 1.0 / 255.0).count();
    assert!(count > pixels, "{one} and {other} differ in {count} pixels");
}

#[test]
fn defaults_may_be_said() {
    for (said, default) in [
        ("model bouknight mach 2", "model bouknight"),
        ("model bouknight mach 1", "model bouknight p 1.5"),
        ("model romney p 2", "model romney"),
        ("model blinn-full trowbridge .260494889", "model blinn-full"),
        ("model blinn-full gloss 10", "model blinn-full"),
        ("model hall-greenberg cutoff .001953125", "model hall-greenberg"),
        // Each distribution by its own parameter for the same angle of 10 degrees.
        ("model blinn-full power 45.2776022", "model blinn-full power"),
        ("model blinn-full gauss 4.77018654", "model blinn-full gauss"),
    ] {
        equal(said, default);
    }
}

#[test]
fn options_change_the_picture() {
    for (said, default, pixels) in [
        ("model bouknight p 1", "model bouknight", 200),
        ("model romney p 7", "model romney", 200),
        ("model newell edge 3 .1 .9", "model newell", 20),
        ("model blinn-full power", "model blinn-full", 5),
        ("model blinn-full gauss 2", "model blinn-full power", 20),
        // Facets hide each other at grazing angles alone.
        ("model cook-torrance sancer", "model cook-torrance", 0),
        ("model cook-torrance exact", "model cook-torrance", 10),
        ("model cook-torrance published", "model cook-torrance", 40),
        ("model cook-torrance mirror .5", "model cook-torrance", 100),
        ("model cook-torrance gloss 25", "model cook-torrance", 20),
        ("model hall-greenberg cutoff .3", "model hall-greenberg", 30),
    ] {
        differ(said, default, pixels);
    }
}

#[test]
fn a_material_that_says_it_wins_over_an_option() {
    let said = SCENE.replace("diffuse .1  thin  edge 2 .2 .8", "diffuse .1  thin  edge 2 .2 .8 ");
    assert_eq!(said.matches("edge").count(), 1);
    // The pane has an edge of its own, the bottle takes that of the option.
    let bottle = SCENE.replace("exponent 80", "exponent 80  edge 3 .1 .9");
    let by_option = of(&format!("{SCENE}model newell edge 3 .1 .9\n"));
    let by_material = of(&format!("{bottle}model newell\n"));
    assert!(by_option.iter().zip(&by_material).all(|(a, b)| difference(*a, *b) < 1e-6));
}

#[test]
fn options_are_those_of_the_model_that_the_scene_names() {
    let text = format!("{SCENE}model romney p 7\n");
    let scene = rta_scenes::read(text.as_bytes(), "models.rta").expect("a scene");
    let drawn = |scene: &rta_scenes::description::Description, model| {
        let settings = Settings { width: 32, height: 20, model, ..Settings::default() };
        let mut light = vec![Rgb::new(0.0, 0.0, 0.0); 32 * 20];
        Engine::new(scene, &settings).expect("it fits").linear_rows(0, &mut light);
        light
    };
    let other = rta_scenes::read(SCENE.as_bytes(), "models.rta").expect("a scene");
    let bouknight = rta_scenes::Model::Bouknight;
    assert!(drawn(&scene, bouknight) == drawn(&other, bouknight));
}

#[test]
fn the_papers_constant_makes_highlights_four_times_as_bright() {
    // One metal, nothing diffuse, no ambient light, far below saturation.
    let text = "rta 1\ncamera at 0 -5 0  look 0 1 0\nlamp at -4 -6 5  power 2\n\
                material m metal .9 .7 .4  slope .5\nsphere at 0 0 0  radius 1  of m\n";
    let plain = of(&format!("{text}model cook-torrance\n"));
    let published = of(&format!("{text}model cook-torrance published\n"));
    let bright = plain.iter().filter(|light| light.r > 0.001).count();
    assert!(bright > 100, "{bright}");
    for (plain, published) in plain.iter().zip(&published) {
        assert!((4.0 * plain.r - published.r).abs() <= 1e-5 * published.r.abs() + 1e-7);
    }
}
