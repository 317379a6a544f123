//! What stands in files that people have, besides what the format has.
#![allow(clippy::indexing_slicing)] // a test may panic

use super::{Description, FINISH, Surface, error_of};
use crate::nff::{read, read_with};
use crate::reading::Reading;

/// A sound head.
const HEAD: &str = "\
b 0 0 0.5
v
from 0 0 8
at 0 0 1
up 0 1 0
angle 40
hither 1
resolution 9 9
l 0 0 8
f 1 1 1 1 0 1 0 1
";

fn warnings(scene: &Description) -> Vec<String> {
    scene.warnings.iter().map(|warning| warning.of_file("s.nff").to_string()).collect()
}

/// The head with something before and after it.
fn with(before: &str, after: &str) -> Description {
    read(format!("{before}{HEAD}{after}\ns 0 0 0 1\n").as_bytes(), "s.nff")
        .unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn what_changes_nothing_is_passed_over_with_a_warning() {
    let plain = with("", "");
    for (text, shown) in [
        ("Balls", "\"Balls\" is"),
        ("Balls by somebody", "\"Balls\" and the rest of its line are"),
        ("tess 4", "\"tess\" and"),
        ("Q 2", "\"Q\" and"),
        ("r 1 2 3", "\"r\" and"),
        ("B sky.hdr", "\"B\" and"),
        ("spp 4", "\"spp\" and"),
        ("aperture 2", "\"aperture\" and"),
    ] {
        let scene = with("", text);
        let [warning] = &warnings(&scene)[..] else { panic!("{:?}", scene.warnings) };
        assert!(warning.starts_with("s.nff:11: ") && warning.contains(shown), "{warning}");
        assert_eq!(scene.without_lines(), plain.clone().without_lines(), "{text}");
        assert!(
            warnings(&with(&format!("{text}\n"), "")).iter().any(|w| w.starts_with("s.nff:1: ")),
            "{text}"
        );
    }
    for text in [
        "accel 0\nfocal 1\naperture 0\nspp 1\nspp 0",
        "fp 1 1 1 1 0 1 0 1",
        "F 1 1 1 1 0 1 0 1",
        "bclr 0 0 .5",
        "B 0 0 0.5",
    ] {
        assert_eq!(with("", text).without_lines(), plain.clone().without_lines(), "{text}");
        assert!(with("", text).warnings.is_empty(), "{text}");
    }
    let loud = with("", "S 0 0 0 1\nC 0 0 0 1 1 1 1 1\nP 3 0 0 0 1 0 0 0 1 0\nL 1 2 3");
    assert_eq!((loud.spheres.len(), loud.cones.len(), loud.triangles.len(), loud.lamps.len()), (2, 1, 1, 2));
    assert!(loud.warnings.is_empty());
    assert_eq!(with("", "k .1 .2 .3").ambient, [0.1, 0.2, 0.3]);
}

#[test]
fn lines_that_may_hold_an_object_are_passed_over_by_a_lenient_reader_only() {
    for line in ["torus 1 2 3 4", "sphere 0 0 0 1", "5 6", "m 1 2 wood"] {
        let text = format!("{HEAD}{line}\ns 0 0 0 1\n{line}");
        let error = error_of(&text);
        assert!(error.starts_with("s.nff:11:1: expected an entity"), "{error}");
        let scene = read_with(text.as_bytes(), "s.nff", Reading { lenient: true, ..Reading::default() })
            .expect("lenient");
        let word = line.split(' ').next().expect("it has one");
        let told = |line| {
            format!(
                "s.nff:{line}: \"{word}\" and the rest of its line are passed over: it is no entity that rta draws"
            )
        };
        assert_eq!(warnings(&scene), [told(11), told(13)]);
        assert_eq!(scene.spheres.len(), 1);
    }
    // What is no scene at all is none, however many words it has.
    assert_eq!(
        error_of("Dear reader,\nthis is a letter.\n"),
        "s.nff:1:1: expected an entity (one of v, b, l, f, s, c, p and pp) or the end of the file, found \"Dear\"; \
         without a viewpoint it may be another format of that name"
    );
}

#[test]
fn the_fill_may_have_a_texture_or_a_highlight() {
    for texture in ["wood.png", "bricks", "wood.png 2 2"] {
        let scene = with("", &format!("f .9 .8 .7  .6 .5 40.5 .3 1.5 {texture}"));
        let name = texture.split(' ').next().expect("it has one");
        assert_eq!(
            warnings(&scene),
            [format!("s.nff:11: the texture \"{name}\" of the fill is passed over")]
        );
        assert_eq!(scene.spheres[0].surface, FINISH);
    }
    assert_eq!(with("", "f .9 .8 .7  .6 .5 40.5 .3 1.5 s 1 1 1 1").spheres.len(), 2);
    let scene = with("", "f .9 .8 .7  1 1 1  .6 .5 40.5 .3 1.5");
    assert_eq!((scene.spheres[0].surface, scene.spheres[0].color), (FINISH, [0.9, 0.8, 0.7]));
    assert!(scene.warnings.is_empty());
    let told = warnings(&with("", "f 1 1 1  1 0 0  1 1 1 0 1\nf 1 1 1  0 0 0  1 1 1 0 1"));
    assert_eq!(
        told,
        [
            "s.nff:11: the colour of the fill's highlight is not used: highlights have the light's; and 1 more like it"
        ]
    );
}

#[test]
fn objects_before_the_first_fill_are_white() {
    let text = HEAD.replace("f 1 1 1 1 0 1 0 1\n", "s 0 0 0 1\ns 0 0 0 2\n");
    let scene = read(text.as_bytes(), "s.nff").expect("it has a default");
    let white = Surface::Finish { kd: 1.0, ks: 0.0, exponent: 0.0, kt: 0.0, ior: 1.0 };
    assert!(scene.spheres.iter().all(|sphere| sphere.surface == white && sphere.color == [1.0; 3]));
    assert_eq!(warnings(&scene), ["s.nff:10: objects before the first fill (f) are white and diffuse"]);
}

#[test]
fn a_box_is_closed_and_shows_its_outside() {
    for corners in ["-1 -2 -3  1 2 3", "1 2 3  -1 -2 -3", "1 -2 3 -1 2 -3"] {
        let triangles = with("", &format!("box {corners}")).triangles;
        assert_eq!(triangles.len(), 12);
        // Six times the volume, by the triangles' own senses: 48 if all look outwards.
        let volume: f64 = triangles
            .iter()
            .map(|triangle| {
                let [a, b, c] = triangle.vertices;
                crate::space::dot(a, crate::space::cross(b, c))
            })
            .sum();
        assert!((volume - 6.0 * 48.0).abs() < 1e-9, "{corners}: {volume}");
    }
    let flat = with("", "box 0 0 0  1 1 0");
    assert_eq!(flat.triangles.len(), 4);
    assert_eq!(warnings(&flat), ["s.nff:11: this polygon has no area and is left out; and 3 more like it"]);
}

#[test]
fn an_area_light_shines_from_the_middles_of_its_polygons() {
    let text = "L 1 .5 0 30 atten 0 0 1\np 4 -1 -1 6 1 -1 6 1 1 6 -1 1 6\np 3 0 0 3  2 0 3  0 1 3\nL 0 0 0 0\n\
                p 3 0 0 0 1 0 0 0 1 0";
    let scene = with("", text);
    assert_eq!((scene.triangles.len(), scene.lamps.len()), (1, 3));
    assert_eq!(
        warnings(&scene),
        ["s.nff:11: the polygons of this area light shine from their middles and are not seen"]
    );
    // Four of five parts, 5 away from the place that is looked at.
    let lamp = &scene.lamps[1];
    assert_eq!((lamp.position, lamp.line), ([0.0, 0.0, 6.0], 12));
    let strength = 30.0 * 0.8 / 25.0;
    assert!((lamp.color[0] - strength).abs() < 1e-12 && (lamp.color[1] - strength / 2.0).abs() < 1e-12);
    // Without an attenuation it is as bright as it says.
    let constant = with("", "L 1 1 1 .5\np 3 0 0 3  2 0 3  0 1 3\nL 0 0 0 0");
    assert_eq!(constant.lamps[1].color, [0.5; 3]);
    assert!(error_of(format!("{HEAD}L 1 1 1 30 atten 1 2\n")).ends_with("has 2 of 3 numbers"));
}

#[test]
fn another_format_of_that_name_is_named() {
    for text in ["nff\nversion 2.0\n", "# v\nNFF version 2.0", &format!("nff\n{HEAD}")] {
        let error = error_of(text);
        assert!(
            error.contains("found \"")
                && error.ends_with("; this is WorldToolKit's NFF (Sense8), which rta does not read"),
            "{error}"
        );
    }
}

#[test]
fn a_picture_that_would_be_black_is_told_why() {
    let dark = read(HEAD.replace("l 0 0 8\n", "").as_bytes(), "s.nff").expect("it is sound");
    assert_eq!(
        warnings(&dark),
        ["s.nff: the scene has no light: what does not mirror its background is black"]
    );
    let ambient = read(HEAD.replace("l 0 0 8\n", "k .1 0 0\n").as_bytes(), "s.nff").expect("it is sound");
    assert!(ambient.warnings.is_empty());
    let inside = with("", "l 0 0 30\ns 1 0 8 9");
    assert!(inside.warnings.is_empty(), "a light is there too: {:?}", inside.warnings);
    let text = HEAD.replace("l 0 0 8\n", "l 0 0 20\n") + "s 0 0 7 2";
    let inside = read(text.as_bytes(), "s.nff").expect("it is sound");
    assert_eq!(warnings(&inside), ["s.nff:11: the observer is inside of this sphere, and no light is there"]);
    let away = HEAD.to_owned() + "p 3 0 0 0  0 1 0  1 0 0";
    let one_sided = Reading { one_sided: true, ..Reading::default() };
    let turned = read_with(away.as_bytes(), "s.nff", one_sided).expect("it is sound");
    assert_eq!(warnings(&turned), ["s.nff: all polygons turn their invisible side to the observer"]);
    assert!(read(away.as_bytes(), "s.nff").expect("it is sound").warnings.is_empty());
    let glass = read(text.replace("1 0 1 0 1\n", "1 0 1 .5 1\n").as_bytes(), "s.nff").expect("it is sound");
    assert!(glass.warnings.is_empty());
}

#[test]
fn a_polygon_that_crosses_itself_is_told() {
    let scene = with(
        "",
        "p 4 -1 -1 0 1 1 0 1 -1 0 -1 1 0\npp 4 -1 -1 0 1 0 1 1 1 0 0 0 1 1 -1 0 -1 0 1 -1 1 0 0 0 1",
    );
    assert_eq!(
        warnings(&scene),
        [
            "s.nff:11: this polygon crosses itself: all that its outline winds around is shown; and 1 more like it"
        ]
    );
    assert_eq!(scene.triangles.len(), 4);
    let crossing = scene.triangles.iter().filter_map(|t| Some((t.vertices, t.normals?)));
    let crossing = crossing.filter_map(|(vertices, normals)| {
        let at = vertices.iter().position(|place| *place == [0.0; 3])?;
        normals.get(at).copied()
    });
    assert_eq!(crossing.collect::<Vec<_>>(), [[0.5, 0.0, 1.0]; 2]);
}
