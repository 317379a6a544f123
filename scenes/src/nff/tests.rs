mod dialects;
mod errors;

use super::read;
use crate::description::{
    Camera, Cone, Description, Ellipsoid, FallOff, Lamp, Model, Optics, Side, Sky, Sphere, Surface, Triangle,
};

/// One of everything; each test spoils one line of it.
const SCENE: &str = "\
# a comment
b .1 .2 .3
v
from 1 2 3
at 1 5 3
up 0 0 2
angle 90
hither 0.5
resolution 640 480
l 1 2 3
l -4 5 6  .7 .8 9
f .9 .8 .7  .6 .5 40.5 .3 1.5
s 1 2 3 .25
f 1 2 3  0 0 0 0 0
s 4 5 6 -2
c 0 0 1 .5
  0 0 2 .25
c 0 0 1 -2  0 0 0 -1
p 4
0 0 0
1 0 0
1 1 0
0 1 0
pp 3
0 0 0  0 0 5
1 0 0  0 0 0
0 1 0  1 0 1
";

const FINISH: Surface = Surface::Finish { kd: 0.6, ks: 0.5, exponent: 40.5, kt: 0.3, ior: 1.5 };
const DARK: Surface = Surface::Finish { kd: 0.0, ks: 0.0, exponent: 0.0, kt: 0.0, ior: 1.0 };

/// The scene with one of its lines (from 1) replaced.
fn with_line(line: usize, text: &str) -> String {
    let lines = SCENE.lines().enumerate().map(|(index, old)| if index + 1 == line { text } else { old });
    lines.flat_map(|line| [line, "\n"]).collect()
}

fn error_of(text: impl AsRef<[u8]>) -> String {
    read(text.as_ref(), "s.nff").expect_err("it should be refused").to_string()
}

fn accepted(text: impl AsRef<[u8]>) -> Description {
    read(text.as_ref(), "s.nff").unwrap_or_else(|error| panic!("{error}"))
}

fn triangle(vertices: [[f64; 3]; 3], normals: Option<[[f64; 3]; 3]>, line: u32) -> Triangle {
    Triangle { vertices, normals, one_sided: false, color: [1.0, 2.0, 3.0], surface: DARK, line }
}

#[test]
fn every_number_lands_where_it_belongs() {
    let share = 1.0 / 2.0_f64.sqrt();
    let color = [1.0, 2.0, 3.0];
    let cone = Cone {
        base: [0.0, 0.0, 1.0],
        base_radius: 0.5,
        apex: [0.0, 0.0, 2.0],
        apex_radius: 0.25,
        capped: false,
        inside_only: false,
        color,
        surface: DARK,
        line: 16,
    };
    let inside = Cone {
        base_radius: 2.0,
        apex: [0.0; 3],
        apex_radius: 1.0,
        inside_only: true,
        line: 18,
        ..cone.clone()
    };
    let camera = Camera {
        eye: [1.0, 2.0, 3.0],
        view: [0.0, 3.0, 0.0],
        focal: 0.0,
        side: Side::Height,
        up: Some([0.0, 0.0, 2.0]),
    };
    let expected = Description {
        spheres: vec![Sphere {
            position: [1.0, 2.0, 3.0],
            color: [0.9, 0.8, 0.7],
            radius: 0.25,
            surface: FINISH,
            line: 13,
        }],
        ellipsoids: vec![Ellipsoid {
            position: [4.0, 5.0, 6.0],
            color,
            radii: [2.0; 3],
            inside_only: true,
            surface: DARK,
            line: 15,
        }],
        cones: vec![cone, inside],
        triangles: vec![
            triangle([[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]], None, 19),
            triangle([[0.0; 3], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]], None, 19),
            triangle(
                [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
                Some([[0.0, 0.0, 5.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0]]),
                24,
            ),
        ],
        lamps: vec![
            Lamp {
                position: [1.0, 2.0, 3.0],
                color: [share; 3],
                radius: 0.0,
                fall_off: FallOff::Constant,
                line: 10,
            },
            Lamp {
                position: [-4.0, 5.0, 6.0],
                color: [0.7, 0.8, 9.0],
                radius: 0.0,
                fall_off: FallOff::Constant,
                line: 11,
            },
        ],
        sky: Sky { horizon: [0.1, 0.2, 0.3], zenith: [0.1, 0.2, 0.3] },
        model: Model::Phong,
        raster: Some([640, 480]),
        optics: Optics { hither: Some(0.5), ..Optics::default() },
        ..Description::empty(camera)
    };
    let mut got = accepted(SCENE);
    // Half the height of 479 rows is 1 at distance 1.
    let focal = core::mem::take(&mut got.camera.focal);
    assert!((focal - 0.5 * 479.0 / 480.0).abs() < 1e-15, "{focal}");
    assert_eq!(got, expected);
}

#[test]
fn the_angle_is_between_the_middles_of_pixels() {
    let focal = |angle: &str, resolution: &str| {
        let text = SCENE.replace("angle 90", angle).replace("resolution 640 480", resolution);
        accepted(text).camera.focal
    };
    // Pixels seen from the eye: the first and the last row are 90 degrees apart.
    for rows in [2.0, 3.0, 512.0] {
        let last = (0.5 - 0.5 / rows) / focal("angle 90", &format!("resolution 7 {rows}"));
        assert!((last - 1.0).abs() < 1e-15, "{rows}: {last}");
    }
    assert!((focal("angle 90", "resolution 7 1") - 0.5).abs() < 1e-15);
    let half = 30.0_f64.to_radians().tan();
    assert!((focal("angle 60", "resolution 9 5") - 0.5 / (half * 1.25)).abs() < 1e-15);
}

#[test]
fn layout_of_the_text_plays_no_part() {
    let expected = accepted(SCENE);
    assert_eq!(accepted(SCENE.replace('\n', "\r\n")), expected);
    assert_eq!(accepted(SCENE.replace('\n', "#x 1\r")), expected);
    assert_eq!(accepted(SCENE.replace(' ', "\t \t")), accepted(SCENE));
    assert_eq!(accepted(SCENE.trim_end()), expected);
    let body = SCENE.split_once('\n').expect("it has lines").1;
    let one_line = accepted(body.replace('\n', " "));
    assert_eq!(one_line.without_lines(), expected.clone().without_lines());
    let pieces = accepted(body.split_whitespace().flat_map(|piece| [piece, "\n\n"]).collect::<String>());
    assert_eq!(pieces.without_lines(), expected.without_lines());
}

#[test]
fn what_is_left_out_has_a_default() {
    let view = "v from 0 0 0 at 0 1 0 up 0 0 1 angle 9 hither 0 resolution 4 4\n";
    let scene = accepted(view);
    let camera = scene.camera.clone();
    let empty = Description { model: Model::Phong, raster: Some([4, 4]), ..Description::empty(camera) };
    assert_eq!(scene.without_lines(), empty);
    for (count, share) in [(1, 1.0), (2, 0.5_f64.sqrt()), (3, (1.0_f64 / 3.0).sqrt()), (4, 0.5)] {
        // Lights that say their colour count too.
        let scene = accepted(format!("{}l 1 2 3 5 6 7\n{view}", "l 1 2 3\n".repeat(count - 1)));
        let colors: Vec<_> = scene.lamps.iter().map(|lamp| lamp.color).collect();
        let (told, others) = colors.split_last().expect("it has lamps");
        assert_eq!(*told, [5.0, 6.0, 7.0]);
        assert_eq!(others.len(), count - 1);
        assert!(others.iter().flatten().all(|register| (register - share).abs() < 1e-15), "{others:?}");
    }
    // The last background holds.
    assert_eq!(accepted(format!("b 1 1 1 {view} b 0 .5 0")).sky.zenith, [0.0, 0.5, 0.0]);
}

#[test]
fn indices_of_refraction_that_make_no_sense() {
    for (end, expected) in [("0 0", 1.0), ("0 -3", 1.0), (".5 0", 1.0), ("0 1.5", 1.5), (".5 .75", 0.75)] {
        let scene = accepted(with_line(12, &format!("f 1 1 1 0 0 0 {end}")));
        let surface = scene.spheres.first().map(|sphere| sphere.surface);
        let Some(Surface::Finish { ior, .. }) = surface else { panic!("{surface:?}") };
        assert!((ior - expected).abs() < 1e-15, "{end}: {ior}");
    }
    assert_eq!(
        error_of(with_line(12, "f 1 1 1 0 0 0 .5 -1.5")),
        "s.nff:12:18: expected the index of refraction of the fill (a number >= 0), found -1.5"
    );
}

#[test]
fn cones_by_their_radii() {
    for (radii, inside_only) in
        [(["1", "0"], false), (["0", "1"], false), (["-1", "0"], true), (["0", "-1"], true)]
    {
        let [base, apex] = radii;
        let scene = accepted(with_line(18, &format!("c 0 0 0 {base} 0 0 1 {apex}")));
        let cone = scene.cones.last().expect("it has two");
        assert_eq!(cone.inside_only, inside_only, "{radii:?}");
        assert!((cone.base_radius + cone.apex_radius - 1.0).abs() < 1e-15 && cone.base_radius >= 0.0);
    }
    for (cone, message) in [
        (
            "c 0 0 0 1  0 0 1 -1",
            "18:18: expected the apex radius of cone 2 (a number >= 0 like the base radius), found -1 (the base radius is 1)",
        ),
        (
            "c 0 0 0 -2  0 0 1 .5",
            "18:19: expected the apex radius of cone 2 (a number <= 0 like the base radius), found 0.5 (the base radius is -2)",
        ),
        (
            "c 0 0 0 0  0 0 1 0",
            "18:18: expected the apex radius of cone 2 (a number, not 0 like the base radius), found 0 (the base radius is 0)",
        ),
        ("c 1 2 3 1  1 2 3 1", "18:12: expected the apex of cone 2 (not its base), found 1 2 3"),
    ] {
        assert_eq!(error_of(with_line(18, cone)), format!("s.nff:{message}"));
    }
}

#[test]
fn polygons_without_area_are_left_out_and_concave_ones_cut() {
    let corners = |text: &str| accepted(with_line(19, text)).triangles.len();
    let rest = accepted(SCENE).triangles.len();
    assert_eq!(corners("p 3 0 0 0 1 1 1 2 2 2  p 4"), rest);
    assert_eq!(corners("p 3 0 0 0 0 0 0 0 0 0  p 4"), rest);
    assert_eq!(corners("p 6 0 0 0 3 0 0 3 1 0 1 1 0 1 2 0 0 2 0  p 4"), rest + 4);
    // The normals go with their corners.
    let dart = "pp 4  0 2 0 0 0 1   -1 0 0 0 0 2   0 1 0 0 0 3   1 0 0 0 0 4\np 4";
    let scene = accepted(with_line(19, dart));
    let triangles: Vec<_> = scene.triangles.iter().filter(|t| t.line == 19).take(2).collect();
    assert_eq!(triangles.len(), 2);
    for triangle in triangles {
        for (vertex, normal) in triangle.vertices.iter().zip(triangle.normals.expect("it has normals")) {
            let expected = [
                ([0.0, 2.0, 0.0], 1.0),
                ([-1.0, 0.0, 0.0], 2.0),
                ([0.0, 1.0, 0.0], 3.0),
                ([1.0, 0.0, 0.0], 4.0),
            ];
            let (_, z) = expected.into_iter().find(|(place, _)| place == vertex).expect("it is a corner");
            assert_eq!(normal, [0.0, 0.0, z]);
        }
    }
}

#[test]
fn the_shipped_example_is_what_it_says() {
    let scene = accepted(include_bytes!("../../balls2.nff"));
    assert_eq!((scene.spheres.len(), scene.triangles.len(), scene.lamps.len()), (91, 2, 3));
    assert_eq!(scene.raster, Some([512, 512]));
    assert_eq!(scene.model, Model::Phong);
}
