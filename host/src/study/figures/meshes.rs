//! The error of meshes beside the ball that they stand for.

use rta_core::color::Rgb;
use rta_scenes::Reading;
use rta_scenes::description::{Description, Shading};

use super::chart::{Axis, Chart, Curve, Ink};
use crate::engine::{Engine, Format, Settings};

/// A ball, an eye and a lamp that are far away, so that the directions to both are nearly the same all over a triangle.
const BALL: &str = "\
rta 1
camera at 0 -400 0  to 0 0 0  lens 160
model whitted
sky grey .1
ambient grey .2
lamp at -200 -350 250  power 1 constant
material m  diffuse .6  specular .3  exponent 8
sphere at 0 0 0  radius 1  color .9 .6 .3  of m
";

/// Pixels of the pictures.
const SIZE: (u32, u32) = (240, 180);

/// The numbers of rows of the meshes.
const ROWS: [u32; 4] = [4, 8, 16, 32];

/// The ways in which meshes are shaded.
const WAYS: [(&str, Shading, Ink); 3] = [
    ("Gouraud", Shading::Gouraud, Ink::Red),
    ("Phong", Shading::Normals, Ink::Black),
    ("Bishop, Weimer", Shading::BishopWeimer, Ink::Blue),
];

/// Returns the mean absolute errors of meshes shaded in one way, from few rows to many; none where a scene cannot be drawn.
#[must_use]
pub fn of(shading: Shading) -> Vec<(u32, f64)> {
    let ball = |reading| {
        rta_scenes::read_with(BALL.as_bytes(), "ball.rta", reading).ok().and_then(|scene| light(&scene))
    };
    let Some(whole) = ball(Reading::default()) else { return Vec::new() };
    let error = |rows| {
        let mesh = ball(Reading { tessellate: Some(rows), shading: Some(shading), ..Reading::default() })?;
        Some((rows, apart(&mesh, &whole)))
    };
    ROWS.into_iter().filter_map(error).collect()
}

/// Returns the power of the number of rows by which errors fall: the slope of the line nearest to their logarithms.
#[must_use]
pub fn slope(errors: &[(u32, f64)]) -> f64 {
    let points = errors.iter().map(|&(rows, error)| (f64::from(rows).ln(), error.ln()));
    let (mut count, mut sums, mut both, mut square) = (0.0, (0.0, 0.0), 0.0, 0.0);
    for (x, y) in points {
        count += 1.0;
        sums = (sums.0 + x, sums.1 + y);
        both += x * y;
        square += x * x;
    }
    (both - sums.0 * sums.1 / count) / (square - sums.0 * sums.0 / count)
}

fn light(scene: &Description) -> Option<Vec<Rgb<f32>>> {
    let (width, height) = SIZE;
    let settings = Settings { width, height, format: Format::F64, model: scene.model, ..Settings::default() };
    let engine = Engine::new(scene, &settings).ok()?;
    let mut light = vec![Rgb::new(0.0, 0.0, 0.0); usize::try_from(width * height).ok()?];
    engine.linear_rows(0, &mut light);
    Some(light)
}

fn apart(a: &[Rgb<f32>], b: &[Rgb<f32>]) -> f64 {
    let of = |a: f32, b: f32| f64::from((a - b).abs());
    let pairs = a.iter().zip(b).map(|(a, b)| of(a.r, b.r) + of(a.g, b.g) + of(a.b, b.b));
    let (count, sum) = pairs.fold((0.0, 0.0), |(count, sum), pair| (count + 3.0, sum + pair));
    sum / count
}

/// The errors of all ways, on logarithmic scales, with their slopes.
pub(super) fn errors() -> Chart {
    let curve = |(name, shading, ink)| {
        let errors = of(shading);
        let name = format!("{name}: N^{:.2}", slope(&errors));
        let points =
            errors.into_iter().map(|(rows, error)| (f64::from(rows).log2(), error.log10())).collect();
        Curve { points, ..Curve::of(name, ink, &(2.0..5.0), |_| 0.0) }
    };
    Chart {
        title: "Error of a ball as a mesh",
        x: Axis { name: "N rows, as a power of 2", range: 2.0..5.0 },
        y: Axis { name: "mean error, as a power of 10", range: -4.0..-1.0 },
        curves: WAYS.map(curve).into(),
    }
}
