//! Meshes beside what they stand for: a ball cut into more and more triangles, shaded in three ways.
#![allow(clippy::indexing_slicing)] // a test may panic

use rta::engine::{Engine, Format, Settings};
use rta::study::figures::meshes;
use rta_core::color::Rgb;
use rta_scenes::Reading;
use rta_scenes::description::{Description, Shading};

const WAYS: [Shading; 3] = [Shading::Gouraud, Shading::Normals, Shading::BishopWeimer];

/// A ball.
const BALL: &str = "\
rta 1
camera at 0 -4 0  to 0 0 0  lens 1.4
model whitted
sky grey .1
ambient grey .2
lamp at -4 -7 5  power 1 constant
material m  diffuse .6  specular .3  exponent 8
sphere at 0 0 0  radius 1  color .9 .6 .3  of m
";

fn scene(text: &str, reading: Reading) -> Description {
    rta_scenes::read_with(text.as_bytes(), "mesh.rta", reading).expect("a scene")
}

/// Returns the light of a picture.
fn picture(scene: &Description, (width, height): (u32, u32), format: Format) -> Vec<Rgb<f32>> {
    let settings = Settings { width, height, format, model: scene.model, ..Settings::default() };
    let engine = Engine::new(scene, &settings).expect("it fits");
    let mut light = vec![Rgb::new(0.0, 0.0, 0.0); (width * height) as usize];
    engine.linear_rows(0, &mut light);
    light
}

/// Returns the mean of the absolute differences of two pictures.
fn error(a: &[Rgb<f32>], b: &[Rgb<f32>]) -> f64 {
    let apart = |a: f32, b: f32| f64::from((a - b).abs());
    let sum: f64 = a.iter().zip(b).map(|(a, b)| apart(a.r, b.r) + apart(a.g, b.g) + apart(a.b, b.b)).sum();
    sum / (3 * a.len()).max(1) as f64
}

#[test]
fn the_error_of_meshes_falls_with_the_square_of_their_rows() {
    for shading in WAYS {
        let errors = meshes::of(shading);
        for (rows, error) in &errors {
            println!("{shading:?}, {rows} rows: {error:.6}");
        }
        let slope = meshes::slope(&errors);
        println!("{shading:?}: N^{slope:.2}");
        assert_eq!(errors.len(), 4);
        assert!((-2.2..-1.8).contains(&slope), "{shading:?}: the error falls as N^{slope}");
    }
}

#[test]
fn each_way_is_the_same_in_all_formats() {
    let size = (160, 120);
    for shading in WAYS {
        for scanline in [false, true] {
            let reading =
                Reading { tessellate: Some(6), shading: Some(shading), scanline, ..Reading::default() };
            let scene = scene(BALL, reading);
            let want = picture(&scene, size, Format::F64);
            for format in [Format::F32, Format::Q16, Format::Q20] {
                let got = picture(&scene, size, format);
                let far = |a: &Rgb<f32>, b: &Rgb<f32>| {
                    [(a.r, b.r), (a.g, b.g), (a.b, b.b)].into_iter().any(|(a, b)| (a - b).abs() > 1.0 / 63.0)
                };
                let count = got.iter().zip(&want).filter(|(a, b)| far(a, b)).count();
                println!("{shading:?} scanline {scanline} {format}: {count} of {} pixels", want.len());
                assert!(count * 100 <= want.len(), "{shading:?} {format}: {count} pixels");
            }
        }
    }
}

/// Two triangles that lean back, so that a scan line's weights differ from those in space.
const SLANTED: &str = "\
rta 1
camera at 0 -3 0  to 0 0 0
model lambert
lamp at 0 -3 1  power 1 constant
polygon -1 -1 -1  1 -1 -1  1 9 1  -1 9 1  normals -1 -1 0  1 -1 0  1 -1 1  -1 -1 1  gouraud
sphere at 0 2 0 radius .2
";

#[test]
fn weights_of_a_scan_line_count_from_the_eye_alone() {
    let size = (80, 60);
    let of = |reading| picture(&scene(SLANTED, reading), size, Format::F64);
    let own = of(Reading::default());
    let on_screen = of(Reading { scanline: true, ..Reading::default() });
    let normals = of(Reading { shading: Some(Shading::Normals), ..Reading::default() });
    let both = of(Reading { shading: Some(Shading::Normals), scanline: true, ..Reading::default() });
    assert!(error(&own, &on_screen) > 0.005, "{}", error(&own, &on_screen));
    assert!(error(&normals, &both) > 0.005, "{}", error(&normals, &both));
    assert!(error(&own, &normals) > 0.005);
    // Down the screen within one triangle, Gouraud's light on the screen changes in equal steps.
    let row: Vec<f32> =
        on_screen.iter().skip(80 * 44 + 42).step_by(80).take(5).map(|pixel| pixel.r).collect();
    let steps: Vec<f32> = row.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert!(steps.iter().all(|step| (step - steps[0]).abs() < 1e-5 && step.abs() > 1e-6), "{row:?}");
}

#[test]
fn what_has_no_normals_is_flat_whatever_is_asked() {
    let text = SLANTED.replace(" normals -1 -1 0  1 -1 0  1 -1 1  -1 -1 1", "");
    let flat = picture(&scene(&text.replace(" gouraud", ""), Reading::default()), (40, 30), Format::Q16);
    for shading in WAYS {
        let reading = Reading { shading: Some(shading), scanline: true, ..Reading::default() };
        assert_eq!(picture(&scene(&text, reading), (40, 30), Format::Q16), flat);
    }
}
