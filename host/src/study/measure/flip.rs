//! LDR-FLIP: how visible the difference is to somebody who flips between two pictures, from 0 to 1 for each pixel. P. Andersson,
//! J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström and M. D. Fairchild, "FLIP: A Difference Evaluator for Alternating
//! Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020, section 4:
//!
//! | step of the paper | what |
//! | --- | --- |
//! | spatial filtering | a colour's three opponent parts, blurred by the contrast sensitivity of the eye |
//! | colour metric | the HyAB distance of two colours in CIELAB with the Hunt effect |
//! | error redistribution | the distance brought to 0..1 |
//! | feature pipeline | edges and points of luminance |
//! | final difference | one error out of both differences |
//!
//! Filters, their radii, their normalization and the border are those of the authors' own program (flip-evaluator 1.7).

use core::f64::consts::PI;

use rta_core::color::Rgb;

use super::colorimetry::{Lab, RGB_OF_XYZ, WHITE, XYZ_OF_RGB, product, xyz};
use super::convolution::{Kernel, Plane, SHARPEST, distances, gaussian, gaussian_sum};
use super::{Pair, PixelsPerDegree};

/// The exponent q_c of a distance between colours (colour metric).
const COLOR_EXPONENT: f64 = 0.7;
/// The part p_c of the greatest distance where compression begins (error redistribution).
const KNEE: f64 = 0.4;
/// The part p_t of the range 0..1 that distances below the knee fill (error redistribution).
const KNEE_ERROR: f64 = 0.95;
/// The width w of an edge that the feature filters answer to, in degrees (feature pipeline).
const FEATURE_WIDTH: f64 = 0.082;
/// The exponent q_f of a difference of features (feature pipeline).
const FEATURE_EXPONENT: f64 = 0.5;

/// Gaussians of the contrast sensitivity (spatial filtering) as `(a, b)`: a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees.
const ACHROMATIC: [(f64, f64); 1] = [(1.0, 0.0047)];
/// Those of the opponent part from green to red.
const RED_GREEN: [(f64, f64); 1] = [(1.0, 0.0053)];
/// Those of the opponent part from blue to yellow.
const BLUE_YELLOW: [(f64, f64); 2] = [(34.1, 0.04), (13.5, 0.025)];
/// The largest b, which gives the radius of all of them.
const WIDEST: f64 = 0.04;

/// Returns FLIP's error of each pixel, 0 to 1, row by row from the upper left. It does not matter which of the pictures is the
/// reference.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "an error of 0 to 1")]
pub fn map(pair: &Pair<'_>, pixels_per_degree: PixelsPerDegree) -> Vec<f32> {
    let filters = Filters::new(pixels_per_degree);
    let columns = pair.size.columns();
    let [reference, test] = [pair.reference, pair.test].map(|pixels| Seen::new(pixels, columns, &filters));
    let greatest = greatest_distance();
    let colors = reference.colors.iter().zip(&test.colors);
    let features = reference.features.iter().zip(&test.features);
    let errors = colors.zip(features).map(|((color, other), (feature, other_feature))| {
        let color_error = color_error(distance(*color, *other), greatest);
        color_error.powf(1.0 - feature_error(*feature, *other_feature)) as f32
    });
    errors.collect()
}

/// What the eye sees of one picture.
struct Seen {
    /// The blurred colours, with the Hunt effect.
    colors: Vec<Lab>,
    features: Vec<Feature>,
}

/// How much of an edge and of a point is at a pixel: lengths of gradients of luminance.
#[derive(Clone, Copy)]
struct Feature {
    edge: f64,
    point: f64,
}

impl Seen {
    fn new(pixels: &[Rgb<u8>], columns: usize, filters: &Filters) -> Self {
        let [luminance, red_green, blue_yellow] = planes(pixels, columns);
        let features = features(&luminance, filters);
        let luminance = luminance.blurred(&filters.achromatic);
        let red_green = red_green.blurred(&filters.red_green);
        let blue_yellow = blue_yellow.blurred(&filters.blue_yellow);
        let parts = luminance.values().iter().zip(red_green.values()).zip(blue_yellow.values());
        let colors = parts.map(|((y, cx), cz)| seen_color(f64::from(*y), f64::from(*cx), f64::from(*cz)));
        Self { colors: colors.collect(), features }
    }
}

/// Returns the opponent parts of a picture's colours: Y, X - Y and Y - Z, relative to white. These are the YCxCz of the paper
/// without its factors and its offset, which filters whose weights have the sum 1 leave as they are.
#[expect(clippy::cast_possible_truncation, reason = "planes are f32")]
fn planes(pixels: &[Rgb<u8>], columns: usize) -> [Plane; 3] {
    let [white_x, white_y, white_z] = WHITE;
    let mut planes = [const { Vec::new() }; 3];
    for [x, y, z] in xyz(pixels) {
        let [x, y, z] = [x / white_x, y / white_y, z / white_z];
        for (plane, part) in planes.iter_mut().zip([y, x - y, y - z]) {
            plane.push(part as f32);
        }
    }
    planes.map(|values| Plane::new(columns, values))
}

/// Returns the colour of opponent parts Y, X - Y and Y - Z in CIELAB with the Hunt effect, brought into the screen's gamut.
fn seen_color(y: f64, cx: f64, cz: f64) -> Lab {
    let [white_x, white_y, white_z] = WHITE;
    let rgb = product(&RGB_OF_XYZ, [(y + cx) * white_x, y * white_y, (y - cz) * white_z]);
    hunt(rgb.map(|light| light.clamp(0.0, 1.0)))
}

/// Returns linear sRGB in CIELAB, where the chroma of dark colours is less.
fn hunt(rgb: [f64; 3]) -> Lab {
    let Lab { l, a, b } = Lab::of_xyz(product(&XYZ_OF_RGB, rgb));
    Lab { l, a: 0.01 * l * a, b: 0.01 * l * b }
}

/// Returns the HyAB distance to the power of q_c (colour metric): lightness and chroma are told apart.
fn distance(color: Lab, other: Lab) -> f64 {
    let hyab = (color.l - other.l).abs() + (color.a - other.a).hypot(color.b - other.b);
    hyab.powf(COLOR_EXPONENT)
}

/// Returns the greatest distance of two colours of the screen: of its green from its blue.
fn greatest_distance() -> f64 {
    distance(hunt([0.0, 1.0, 0.0]), hunt([0.0, 0.0, 1.0]))
}

/// Returns a distance of colours as an error of 0 to 1; the largest distances are compressed (error redistribution).
fn color_error(distance: f64, greatest: f64) -> f64 {
    let knee = KNEE * greatest;
    if distance < knee {
        KNEE_ERROR * distance / knee
    } else {
        KNEE_ERROR + (1.0 - KNEE_ERROR) * (distance - knee) / (greatest - knee)
    }
}

/// Returns the difference of edges or of points, whichever is larger, as an error of 0 to 1.
fn feature_error(feature: Feature, other: Feature) -> f64 {
    let edges = (feature.edge - other.edge).abs();
    let points = (feature.point - other.point).abs();
    (edges.max(points) / 2.0_f64.sqrt()).powf(FEATURE_EXPONENT)
}

/// Returns the edges and points of luminance.
fn features(luminance: &Plane, filters: &Filters) -> Vec<Feature> {
    let Derivatives { none, first, second } = &filters.features;
    let smooth = luminance.along_rows(none);
    let [edge_x, edge_y] = [luminance.along_rows(first).along_columns(none), smooth.along_columns(first)];
    let [point_x, point_y] = [luminance.along_rows(second).along_columns(none), smooth.along_columns(second)];
    let edges = edge_x.values().iter().zip(edge_y.values());
    let points = point_x.values().iter().zip(point_y.values());
    let length = |(x, y): (&f32, &f32)| f64::from(x * x + y * y).sqrt();
    edges.zip(points).map(|(edge, point)| Feature { edge: length(edge), point: length(point) }).collect()
}

/// The filters at one distance.
struct Filters {
    achromatic: Vec<(f32, Kernel)>,
    red_green: Vec<(f32, Kernel)>,
    blue_yellow: Vec<(f32, Kernel)>,
    features: Derivatives,
}

impl Filters {
    fn new(pixels_per_degree: PixelsPerDegree) -> Self {
        let pixels = pixels_per_degree.pixels();
        let radius = Kernel::radius(deviation(WIDEST) * pixels);
        Self {
            achromatic: sensitivity(&ACHROMATIC, radius, pixels),
            red_green: sensitivity(&RED_GREEN, radius, pixels),
            blue_yellow: sensitivity(&BLUE_YELLOW, radius, pixels),
            features: Derivatives::new(0.5 * FEATURE_WIDTH * pixels),
        }
    }
}

/// Returns the standard deviation in degrees of a Gaussian exp(-pi^2 x^2 / b).
fn deviation(b: f64) -> f64 {
    (0.5 * b).sqrt() / PI
}

/// Returns a sum of Gaussians in two dimensions, whose weights have the sum 1, as normalized Gaussians and their shares in it.
#[expect(clippy::cast_possible_truncation, reason = "planes are f32")]
fn sensitivity(gaussians: &[(f64, f64)], radius: u16, pixels_per_degree: f64) -> Vec<(f32, Kernel)> {
    let parts = gaussians.iter().map(|&(a, b)| {
        let deviation = (deviation(b) * pixels_per_degree).max(SHARPEST);
        let volume = a * (PI / b).sqrt() * gaussian_sum(radius, deviation).powi(2);
        (volume, Kernel::gaussian(radius, deviation))
    });
    let parts: Vec<_> = parts.collect();
    let volume: f64 = parts.iter().map(|(volume, _)| volume).sum();
    parts.into_iter().map(|(part, kernel)| ((part / volume) as f32, kernel)).collect()
}

/// A Gaussian and its first and second derivatives in one dimension, which answer to edges and to points.
struct Derivatives {
    none: Kernel,
    first: Kernel,
    second: Kernel,
}

impl Derivatives {
    /// Returns the filters of a Gaussian whose standard deviation is given in pixels.
    fn new(deviation: f64) -> Self {
        let radius = Kernel::radius(deviation);
        let deviation = deviation.max(SHARPEST);
        Self {
            none: Kernel::gaussian(radius, deviation),
            first: balanced(radius, |x| -x * gaussian(x, deviation)),
            second: balanced(radius, |x| ((x / deviation).powi(2) - 1.0) * gaussian(x, deviation)),
        }
    }
}

/// Returns a filter whose positive weights have the sum 1, and its negative ones -1.
fn balanced(radius: u16, weight: impl Fn(f64) -> f64) -> Kernel {
    let positive: f64 = distances(radius).map(|x| weight(x).max(0.0)).sum();
    let negative: f64 = distances(radius).map(|x| -weight(x).min(0.0)).sum();
    Kernel::new(radius, |x| weight(x) / if weight(x) > 0.0 { positive } else { negative })
}
