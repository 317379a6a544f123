//! Scene files of the kinds that people have and that were once drawn wrong, or not at all: each says in its comments what is
//! right. They are drawn in every number format.
#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use rta::engine::{Format, Model, Settings};
use rta_scenes::Reading;
use rta_scenes::description::Description;
use rta_tests::picture::{render, settings};

/// Reads a scene of `tests/scenes/cases`.
fn read(file: &str) -> Vec<u8> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/cases");
    std::fs::read(folder.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

fn scene(text: impl AsRef<[u8]>) -> Description {
    rta_scenes::read(text.as_ref(), "case.nff").unwrap_or_else(|error| panic!("{error}"))
}

/// The warnings of a scene, as they are printed.
fn warnings(scene: &Description) -> Vec<String> {
    scene.warnings.iter().map(|warning| warning.of_file("case.nff").to_string()).collect()
}

/// A picture of the size that a scene is made for, row by row from the top.
struct Picture(usize, Vec<[f64; 3]>);

impl Picture {
    fn new(scene: &Description, format: Format) -> Self {
        let [width, height] = scene.raster.expect("NFF says it");
        let aspect = f64::from(width) / f64::from(height);
        let settings = Settings { width, height, aspect, model: Model::Phong, ..settings(format) };
        Self(width as usize, render(scene, &settings).expect("it fits every format"))
    }

    fn at(&self, x: usize, y: usize) -> [f64; 3] {
        self.1[y * self.0 + x]
    }

    /// How many pixels are more red than black.
    fn red(&self) -> usize {
        self.1.iter().filter(|pixel| pixel[0] > 0.02).count()
    }
}

/// Calls `test` with the picture of a scene in every format.
fn drawn(scene: &Description, test: impl Fn(Format, &Picture)) {
    for &format in Format::ALL {
        test(format, &Picture::new(scene, format));
    }
}

fn is_near(got: [f64; 3], want: [f64; 3]) -> bool {
    got.iter().zip(want).all(|(got, want)| (got - want).abs() < 1e-3)
}

#[test]
fn an_outline_may_run_out_and_back_from_any_corner_on() {
    let text = String::from_utf8(read("polygon-antenna.nff")).expect("it is text");
    let (head, corners) = text.split_once("p 6\n").expect("it is a polygon of six corners");
    let mut corners: Vec<_> = corners.lines().collect();
    for _ in 0..6 {
        let scene = scene(format!("{head}p 6\n{}\n", corners.join("\n")));
        assert!(scene.warnings.is_empty());
        drawn(&scene, |format, picture| assert_eq!(picture.red(), 1849, "{format}: {corners:?}"));
        corners.rotate_left(1);
    }
}

#[test]
fn a_bow_tie_is_two_triangles() {
    let scene = scene(read("bow-tie.nff"));
    assert_eq!(
        warnings(&scene),
        ["case.nff:13: this polygon crosses itself: all that its outline winds around is shown"]
    );
    drawn(&scene, |format, picture| {
        let red = picture.red();
        assert!((930..=990).contains(&red), "{format}: {red}");
    });
}

#[test]
fn a_sphere_may_be_seen_from_the_inside_only() {
    drawn(&scene(read("inside-only-sphere.nff")), |format, picture| {
        assert!(is_near(picture.at(32, 32), [0.0, 0.0, 1.0]), "{format}: {:?}", picture.at(32, 32));
        let [red, green, blue] = picture.at(42, 32);
        assert!(red > 0.3 && green + blue == 0.0, "{format}: {red} {green} {blue}");
        assert_eq!(picture.at(0, 0), [0.0; 3]);
    });
}

#[test]
fn a_polygon_may_be_seen_from_one_side_only() {
    let text = read("one-sided-polygon.nff");
    drawn(&scene(&text), |format, picture| assert_eq!(picture.at(32, 32), [0.0; 3], "{format}"));
    let reading = Reading { one_sided: true, ..Reading::default() };
    let one_sided = rta_scenes::read_with(&text, "case.nff", reading).expect("it is sound");
    drawn(&one_sided, |format, picture| {
        let pixel = picture.at(32, 32);
        assert!(is_near(pixel, [0.0, 1.0, 0.0]), "{format}: {pixel:?}");
    });
}

#[test]
fn a_scene_without_light_is_black_and_says_why() {
    let scene = scene(read("no-light.nff"));
    assert_eq!(
        warnings(&scene),
        ["case.nff: the scene has no light: what does not mirror its background is black"]
    );
    drawn(&scene, |format, picture| assert!(picture.1.iter().all(|pixel| *pixel == [0.0; 3]), "{format}"));
}

#[test]
fn old_texts_are_read() {
    let text = read("old-text.nff");
    assert!(text.ends_with(b"\x1a") && core::str::from_utf8(&text).is_err());
    let scene = scene(text);
    assert!(scene.warnings.is_empty());
    drawn(&scene, |format, picture| assert_eq!(picture.red(), 1549, "{format}"));
}

#[test]
fn an_object_before_the_first_fill_is_drawn() {
    let scene = scene(read("object-before-fill.nff"));
    assert_eq!(warnings(&scene), ["case.nff:11: objects before the first fill (f) are white and diffuse"]);
    drawn(&scene, |format, picture| {
        assert!(is_near(picture.at(32, 32), [1.0; 3]), "{format}");
        assert!(is_near(picture.at(0, 0), [0.0, 0.0, 0.5]), "{format}");
    });
}

#[test]
fn another_format_of_that_name_is_named() {
    let error = rta_scenes::read(&read("other-nff.nff"), "case.nff").expect_err("it is another format");
    assert!(error.to_string().contains("WorldToolKit's NFF"), "{error}");
}

#[test]
fn lights_brighter_than_1_are_not_cut() {
    let text = String::from_utf8(read("bright-light.nff")).expect("it is text");
    let (bright, dim) = (scene(&text), scene(text.replace("0 -9 0 2 1 .5", "0 -9 0 1 .5 .25")));
    assert_ne!(bright, dim);
    drawn(&bright, |format, picture| {
        let dim = Picture::new(&dim, format);
        assert!(dim.red() > 100);
        for (bright, dim) in picture.1.iter().zip(&dim.1) {
            assert!(is_near(*bright, dim.map(|register| 2.0 * register)), "{format}: {bright:?} {dim:?}");
        }
    });
    // Lamps that do not say that they are constant are.
    let mut square = bright;
    square.lamps.iter_mut().for_each(|lamp| lamp.fall_off = rta_scenes::description::FallOff::OfModel);
    drawn(&square, |format, picture| {
        let dim = Picture::new(&dim, format);
        assert!(picture.1.iter().zip(&dim.1).all(|(bright, dim)| is_near(*bright, *dim)), "{format}");
    });
}

#[test]
fn a_plane_reaches_to_the_horizon() {
    let head = "b 0 0 1\nv from 0 0 3 at 0 10 3 up 0 0 1 angle 40 hither 1 resolution 33 33\nl 0 0 1000\n";
    // Written by three points of any order and distance, it is one plane.
    for points in ["9 9 0  -9 9 0  -9 -9 0", "-1e3 0 0  1e3 1 0  0 -1e3 0"] {
        let plane = scene(format!("{head}f 1 0 0 1 0 1 0 1\npl {points}\ns 0 10 1 1"));
        drawn(&plane, |format, picture| {
            for y in 0..33 {
                let want = if y < 16 { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
                let pixel = picture.at(3, y);
                // Where the plane ends in numbers, in fixed point, its light is that of its rim.
                let is_rim = y == 16;
                assert!(is_rim || (pixel[0] > 0.9) == (want[0] > 0.9), "{format}, {y}: {pixel:?}");
                assert!(is_rim || (pixel[2] > 0.9) == (want[2] > 0.9), "{format}, {y}: {pixel:?}");
            }
        });
    }
    // A mirror shows the sky, and the shadow of a sphere lies where it stands.
    let mirror = scene(format!("{head}f 1 1 1 0 1 1000 0 1\npl 0 0 0 1 0 0 0 1 0"));
    drawn(&mirror, |format, picture| assert!(is_near(picture.at(16, 30), [0.0, 0.0, 1.0]), "{format}"));
    let shaded = scene(format!("{head}f 1 0 0 1 0 1 0 1\npl 0 0 0 1 0 0 0 1 0\ns 0 12 2.5 1"));
    drawn(&shaded, |format, picture| {
        let row = |x: usize| (17..33).filter(|&y| picture.at(x, y) == [0.0; 3]).count();
        assert!(row(16) > 0 && row(0) == 0, "{format}");
    });
}

/// A file of the dialects is drawn, with so many warnings.
#[test]
fn dialects_are_drawn() {
    let head = "b 0 0 0.5\nv\nfrom 0 0 8\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 65 65\nl 3 4 8\n\
                f 1 0 0 1 0 1 0 1\n";
    let ball = "s 0 0 0 1\n";
    let plain = Picture::new(&scene(format!("{head}{ball}")), Format::F64);
    for (line, warned, changes) in [
        ("f 1 0.5 0.5 0.6 0.4 30 0 1 wood.png", 1, true),
        ("fp 1 0.5 0.5 0.6 0.4 30 0 1", 0, true),
        ("pl 9 9 -1  -9 9 -1  -9 -9 -1", 0, true),
        ("box -1 -1 -1  1 1 1", 0, true),
        ("Balls", 1, false),
        ("F 0 1 0 1 0 1 0 1", 0, true),
        ("tess 4", 1, false),
        ("Q 2", 1, false),
        ("B sky.hdr", 1, false),
        ("L 1 1 0.9 30 atten 0 0 1\np 3 0 0 3 1 0 3 0 1 3\nL 0 0 0 0", 1, true),
        ("k 0.1 0.1 0.1", 0, true),
        ("accel 0\nspp 0\nbclr 0.1 0.3 0.7\naperture 0\nfocal 1", 0, true),
        ("f 1 0.7 0.3  1 1 1  0.8 0 10 0 1", 0, true),
    ] {
        let scene = scene(format!("{head}{line}\n{ball}"));
        assert_eq!(scene.warnings.len(), warned, "{line}: {:?}", scene.warnings);
        assert!(scene.warnings.iter().all(|warning| warning.line == 11), "{line}");
        drawn(&scene, |format, picture| {
            let middle = picture.at(32, 32);
            assert!(middle[0].max(middle[1]) > 0.02, "{format}, {line}: {middle:?}");
            if format == Format::F64 {
                assert_eq!(picture.1 != plain.1, changes, "{line}");
            }
        });
    }
}

/// The annotated scenes of the page about scene files are scenes, and nothing is to be said of them.
#[test]
fn the_scenes_of_the_page_are_drawn() {
    let page = include_str!("../../../scenes/README.md");
    let blocks: Vec<_> =
        page.split("```text\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    let [.., dat, nff, error] = blocks[..] else { panic!("{} blocks", blocks.len()) };
    for (text, name, objects) in [(dat, "page.dat", 4), (nff, "page.nff", 5)] {
        let scene = rta_scenes::read(text.as_bytes(), name).unwrap_or_else(|error| panic!("{error}"));
        assert!(scene.warnings.is_empty(), "{:?}", scene.warnings);
        let Description { cylinders, ellipsoids, spheres, cones, triangles, .. } = &scene;
        let count = cylinders.len() + ellipsoids.len() + spheres.len() + cones.len() + triangles.len();
        assert_eq!(count, objects, "{name}");
        for &format in Format::ALL {
            assert!(render(&scene, &settings(format)).is_ok(), "{name} in {format}");
        }
    }
    // The error is the one that such a file gives.
    let file = "\n".repeat(9) + "f 1 1 1 1 0 1 0 1 s 0 0 0 1 s 0 0 0 1\ns 1 2 3\n    s 0 0 0 1";
    let got = rta_scenes::read(file.as_bytes(), "scene.nff").expect_err("a sphere is short");
    assert_eq!(got.to_string(), error.trim_end());
}
