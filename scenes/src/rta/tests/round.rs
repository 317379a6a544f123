//! What is written reads back.

use super::{EVERYTHING, FIRST, METALS, PRISM, accepted};
use crate::description::{Camera, Description, Kind, Material, Sphere, Surface};
use crate::{dat, nff, shipped};

/// Checks that a scene reads back as it is, but for what [`Description::named`] changes, and returns its text.
fn round(scene: &Description) -> String {
    let text = scene.to_rta();
    let named = scene.clone().named();
    assert_eq!(accepted(&text).without_lines(), named.clone().without_lines(), "{text}");
    // Nothing changes any more.
    assert_eq!(named.clone().named(), named);
    assert_eq!(accepted(&text).to_rta(), text);
    text
}

#[test]
fn scenes_of_every_format_read_back() {
    for text in [FIRST, METALS, PRISM, EVERYTHING] {
        round(&accepted(text));
    }
    for (name, text) in shipped::ALL {
        round(&dat::read(text.as_bytes(), name).expect(name));
    }
    round(&nff::read(shipped::BALLS_2.as_bytes(), "balls2.nff").expect("a shipped scene"));
}

#[test]
fn names_are_made_where_there_are_none() {
    let material =
        |name: &str, diffuse| Material { name: name.into(), diffuse: Some(diffuse), ..Material::default() };
    let sphere = |surface| Sphere { position: [0.0; 3], color: [1.0; 3], radius: 1.0, surface, line: 0 };
    let glass = Surface::Transparent { ks: 0.1, kt: 0.9, ior: 1.5 };
    let finish = Surface::Finish { kd: 0.5, ks: 0.0, exponent: 9.0, kt: 0.0, ior: 7.0 };
    let scene = Description {
        materials: vec![
            material("", 0.1),
            material("gold", 0.2),
            material("x", 0.3),
            material("x", 0.4),
            material("No", 0.5),
        ],
        spheres: [glass, finish, glass].into_iter().chain((0..6).map(Surface::Of)).map(sphere).collect(),
        ..Description::empty(Camera::upright([0.0, -5.0, 0.0], [0.0, 1.0, 0.0], 1.0))
    };
    let text = round(&scene);
    let named = scene.named();
    let names: Vec<_> = named.materials.iter().map(|material| material.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "material-1",
            "material-2",
            "material-3",
            "material-4",
            "x",
            "material-6",
            "material-7",
            "material-8"
        ]
    );
    // An exponent without highlights and an index where nothing comes through say nothing.
    assert_eq!((named.materials[1].exponent, named.materials[1].index), (None, None));
    assert!(
        text.contains("material material-1  diffuse 0  specular 0.1  transmit 0.9  index 1.5\n"),
        "{text}"
    );
}

#[test]
fn what_glass_and_metals_do_not_say_is_said() {
    let of = |kind, color| {
        let sphere =
            Sphere { position: [0.0; 3], color: [1.0; 3], radius: 1.0, surface: Surface::Of(0), line: 0 };
        let material = Material { name: "m".into(), kind, color, ..Material::default() };
        let camera = Camera::upright([0.0, -5.0, 0.0], [0.0, 1.0, 0.0], 1.0);
        Description { materials: vec![material], spheres: vec![sphere], ..Description::empty(camera) }
    };
    for kind in [Kind::Opaque, Kind::Shiny, Kind::Mirror, Kind::Glass, Kind::Metal] {
        for color in [None, Some([0.5, 0.25, 1.0])] {
            round(&of(kind, color));
        }
    }
    let metal = of(Kind::Metal, Some([0.5, 0.25, 1.0])).named();
    assert_eq!(metal.materials[0].metal, Some([0.5, 0.25, 1.0]));
    assert_eq!(of(Kind::Glass, None).named().materials[0].index, Some(1.0));
}

#[test]
fn any_text_is_answered_and_what_is_read_is_written() {
    let answer = |text: &[u8]| match crate::rta::read(text, "a.rta") {
        Ok(scene) => {
            let again =
                crate::rta::read(scene.to_rta().as_bytes(), "b.rta").expect("what is written can be read");
            assert_eq!(again.without_lines(), scene.named().without_lines());
            true
        }
        Err(error) => {
            let told = error.to_string();
            assert!(told.starts_with("a.rta:") && !told.contains('\n'), "{told}");
            false
        }
    };
    let mut sound = 0;
    let corpus = [FIRST, METALS, PRISM, EVERYTHING];
    let words: Vec<&str> = corpus.iter().flat_map(|text| text.split_whitespace()).collect();
    let mut dice = fastrand::Rng::with_seed(16);
    for text in corpus {
        // Cut off anywhere, without any line, and with any byte changed.
        for end in 0..text.len() {
            sound += u32::from(answer(&text.as_bytes()[..end]));
            let mut bytes = text.as_bytes().to_vec();
            bytes[end] = dice.u8(..);
            sound += u32::from(answer(&bytes));
        }
        for left_out in 0..text.lines().count() {
            let lines = text.lines().enumerate().filter(|(line, _)| *line != left_out);
            let lines: Vec<_> = lines.map(|(_, line)| line).collect();
            sound += u32::from(answer(lines.join("\n").as_bytes()));
        }
        // With words of others in the place of its own.
        for _ in 0..2000 {
            let mut parts: Vec<&str> = text.split(' ').collect();
            let at = dice.usize(..parts.len());
            parts[at] = words[dice.usize(..words.len())];
            sound += u32::from(answer(parts.join(" ").as_bytes()));
        }
    }
    // Not all of them are wrong in one way.
    assert!(sound > 1000, "{sound}");
}
