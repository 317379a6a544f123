//! Scenes that were once drawn wrong, each with what is right: thin solids, rays along an axis, an apex, mixed normals, endless
//! cylinders. Their files are in `tests/scenes/cases/`.

#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use core::f64::consts::PI;

use rta::engine::{Format, Settings};
use rta_core::illumination::Phong;
use rta_core::needs::Everything;
use rta_scenes::description::{Camera, Cylinder, Description, FallOff, Lamp, Sky, Surface};
use rta_scenes::model::Model;
use rta_tests::exact::Exact;
use rta_tests::picture::{render, share_within};

type Color = [f64; 3];

/// Reads a scene of `tests/scenes/cases/`.
fn scene(name: &str) -> Description {
    let path = format!("{}/scenes/cases/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    rta_scenes::read(&text, name).unwrap_or_else(|error| panic!("{error}"))
}

/// Draws a scene with Phong's model, or the thesis's where its file has no raster, and that depth.
fn draw(name: &str, format: Format, depth: u32) -> Vec<Color> {
    let scene = scene(name);
    let (model, [width, height]) = match scene.raster {
        Some(raster) => (Model::Phong, raster),
        None => (Model::Rta, [40, 30]),
    };
    let aspect = f64::from(width) / f64::from(height);
    let settings = Settings { format, width, height, aspect, model, depth, ..Settings::default() };
    render(&scene, &settings).unwrap_or_else(|error| panic!("{name}, {format}: {error}"))
}

/// Returns how many pixels are not within 1e-4 of `color`.
fn others(picture: &[Color], color: Color) -> usize {
    let is_other = |pixel: &&Color| pixel.iter().zip(color).any(|(got, want)| (got - want).abs() > 1e-4);
    picture.iter().filter(is_other).count()
}

#[test]
fn thin_cylinders_do_not_shadow_themselves() {
    for &format in Format::ALL {
        let picture = draw("01-thin-cylinders.nff", format, 5);
        let is_cylinder = |[_, _, blue]: &&Color| *blue < 0.25;
        let (seen, black) =
            (picture.iter().filter(is_cylinder).count(), picture.len() - others(&picture, [0.0; 3]));
        assert!((1020..1035).contains(&seen) && black == 0, "{format}: {seen} pixels, {black} of them black");
    }
}

#[test]
fn a_slim_mirror_does_not_meet_itself() {
    for &format in Format::ALL {
        assert_eq!(others(&draw("rel-slim-cylinder.nff", format, 5), [1.0; 3]), 0, "{format}");
    }
}

#[test]
fn a_ray_along_a_tube_meets_nothing() {
    for &format in Format::ALL {
        assert_eq!(others(&draw("04-along-a-tube.nff", format, 5), [0.0, 0.0, 0.5]), 0, "{format}");
    }
}

#[test]
fn an_apex_is_met_and_lit_like_the_side() {
    for &format in Format::ALL {
        let picture = draw("11-apex.nff", format, 5);
        // The sine of the angle between axis and side; beside the apex a little less.
        for (x, want) in [(64, 1.0 / 17f64.sqrt()), (65, 0.2370)] {
            let [red, green, blue] = picture[64 * 129 + x];
            assert!((red - want).abs() < 1e-4 && green + blue == 0.0, "{format}: {red} {green} {blue}");
        }
    }
}

#[test]
fn a_patch_with_mixed_normals_does_not_meet_itself() {
    for &format in Format::ALL {
        let picture = draw("rel-patch-meets-itself.nff", format, 5);
        let mirror = others(&picture, [1.0; 3]);
        assert!((700..900).contains(&mirror), "{format}: {mirror} pixels");
        assert_eq!(others(&picture, [0.5; 3]), picture.len() - mirror, "{format}: one colour");
    }
}

/// A closed ball of smooth mirror polygons before white: all it can reflect is white.
#[test]
fn a_ball_of_smooth_mirrors_reflects_only_the_sky() {
    let place = |i: u32, j: u32| {
        let (latitude, longitude) = (f64::from(i) * PI / 8.0, f64::from(j) * PI / 8.0);
        [latitude.sin() * longitude.cos(), latitude.sin() * longitude.sin(), latitude.cos()]
    };
    for eye in ["0 -6 0.5", "3 4 -2", "0.2 0.1 6"] {
        let mut text =
            format!("b 1 1 1\nv from {eye} at 0 0 0 up 0.3 0.1 1 angle 24 hither 1 resolution 64 64\n");
        text.push_str("f 1 1 1 0 1 1 0 1\n");
        for (i, j) in (0..8).flat_map(|i| (0..16).map(move |j| (i, j))) {
            let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
            let corners: Vec<_> = match i {
                0 => [0, 1, 2].map(|k| corners[k]).into(),
                7 => [0, 1, 3].map(|k| corners[k]).into(),
                _ => corners.into(),
            };
            text.push_str(&format!("pp {}\n", corners.len()));
            for (i, j) in corners {
                let [x, y, z] = place(i, j).map(|c| c + 0.0);
                text.push_str(&format!("{x:.9} {y:.9} {z:.9} {x:.9} {y:.9} {z:.9}\n"));
            }
        }
        let scene = rta_scenes::read(text.as_bytes(), "ball.nff").expect("it is right");
        for &format in Format::ALL {
            let settings = Settings {
                format,
                width: 64,
                height: 64,
                aspect: 1.0,
                model: Model::Phong,
                depth: 16,
                ..Settings::default()
            };
            let picture = render(&scene, &settings).expect("it fits");
            assert_eq!(others(&picture, [1.0; 3]), 0, "{format}, from {eye}");
        }
    }
}

/// An endless cylinder has no end, also where the number format has no numbers for the place of the hit.
#[test]
fn an_endless_cylinder_is_seen_at_any_height() {
    let walls = [
        scene("rel-cylinder-ends.dat"),
        inside([0.0, 0.0, 1.0], [0.05, 0.02, 1.0]),
        inside([0.0, 0.0, 1.0], [0.3, 0.2, 1.0]),
    ];
    for wall in walls {
        let draw = |format| {
            let settings = Settings { format, width: 40, height: 30, ..Settings::default() };
            render(&wall, &settings).expect("it fits")
        };
        let (exact, fixed) = (draw(Format::F64), draw(Format::Q16));
        assert!(share_within(&exact, &fixed, 1.0 / 63.0) == 100.0, "{:?}", wall.camera);
    }
}

/// An opaque cylinder about an eye that looks up, and a lamp beside it.
fn inside(eye: Color, view: Color) -> Description {
    let sky = Sky { horizon: [0.5; 3], zenith: [1.0; 3] };
    let mut scene =
        Description { ambient: [0.2; 3], sky, ..Description::empty(Camera::upright(eye, view, 20.0)) };
    let (color, surface) = ([0.9, 0.5, 0.2], Surface::Opaque);
    scene.cylinders.push(Cylinder { position: [0.0; 3], color, radius: 2867.0, surface, line: 0 });
    scene.lamps.push(Lamp {
        position: [9.0, 3.0, 2.0],
        color: [1e6; 3],
        radius: 0.0,
        fall_off: FallOff::OfModel,
        line: 0,
    });
    scene
}

/// Two polygons of one slanted plane, each cut from other corners: the first in the file is seen everywhere, in every format and
/// by every search; the second, where it is nearer.
#[test]
fn of_polygons_in_one_place_the_first_is_seen() {
    let corners = [[-3.0, 0.1, -2.0], [3.1, 1.7, -2.2], [3.0, 3.3, 1.9], [-3.1, 1.7, 2.1]];
    // All in one plane, to within the digits of an f64.
    let [a, b, _, d] = corners;
    let c = [0, 1, 2].map(|i| b[i] + d[i] - a[i]);
    let polygon = |corners: [Color; 4], color: &str| {
        let corners = corners.map(|[x, y, z]| format!("{x} {y} {z}\n")).concat();
        format!("f {color} 1 0 1 0 1\np 4\n{corners}")
    };
    let view =
        "b 0 0 1\nv from 0.3 -7 0.4 at 0 1.5 0 up 0 0 1 angle 50 hither 0 resolution 64 64\nl 0.3 -7 0.4\n";
    let nearer = [b, c, d, a].map(|[x, y, z]| [x, y - 1.0 / 256.0, z]);
    for (first, second, other, seen) in [
        ("1 0 0", "0 1 0", [b, c, d, a], 0),
        ("0 1 0", "1 0 0", [b, c, d, a], 1),
        ("1 0 0", "0 1 0", nearer, 1),
    ] {
        let text = view.to_owned() + &polygon([a, b, c, d], first) + &polygon(other, second);
        let scene = rta_scenes::read(text.as_bytes(), "coincident.nff").expect("it is right");
        for &format in Format::ALL {
            let settings = Settings {
                format,
                width: 64,
                height: 64,
                aspect: 1.0,
                model: Model::Phong,
                ..Settings::default()
            };
            let picture = render(&scene, &settings).expect("it fits");
            let of = |gun: usize| picture.iter().filter(|pixel| pixel[gun] > 0.0).count();
            // The rim of the one that is farther away may look out by a pixel.
            let most = if other == nearer { 64 } else { 0 };
            assert!(of(seen) > 800 && of(1 - seen) <= most, "{format}: {} and {} pixels", of(0), of(1));
        }
        let exact = Exact::new(&scene, 64, 64);
        let listed = exact.picture::<_, Everything>(Phong::default(), 5);
        assert!(listed == exact.searched::<_, Everything>(exact.packets(), Phong::default(), 5));
    }
}
