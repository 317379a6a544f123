//! S-CIELAB: colours are blurred as the eye does at a distance before they are compared. X. Zhang and B. A. Wandell, "A spatial
//! extension of CIELAB for digital color image reproduction", SID Digest of Technical Papers 27, 1996.
//!
//! A picture's XYZ is turned into three opponent parts, each is blurred by a sum of Gaussians, and the blurred picture is compared
//! in CIELAB by [`ciede2000()`] (the paper has the CIELAB distance of 1976). Gaussians are exp(-x^2 / s^2) in each direction, cut off
//! at three standard deviations, which is 2.12 s, and normalized to the sum 1; s is in degrees:
//!
//! | part | weights in the paper | weights here | spreads s |
//! | --- | --- | --- | --- |
//! | black to white | 0.921, 0.105, -0.108 | 0.8977, 0.1023 | 0.0283, 0.133 (4.336 is left out) |
//! | green to red | 0.531, 0.330 | 0.6167, 0.3833 | 0.0392, 0.494 |
//! | blue to yellow | 0.488, 0.371 | 0.5681, 0.4319 | 0.0536, 0.386 |
//!
//! The paper too scales the weights of each part to the sum 1, so that a picture of one colour stays as it is. Its third Gaussian of
//! black to white is a wide surround with a negative weight, wider than most screens; without it the border of a picture counts
//! for less. Beyond the border a picture goes on with its outermost pixels.

use rta_core::color::Rgb;

use super::ciede2000::ciede2000;
use super::colorimetry::{Lab, Matrix, inverse, product, xyz};
use super::convolution::{Kernel, Plane, SHARPEST};
use super::{Pair, PixelsPerDegree};

/// Turns XYZ into the opponent parts black to white, green to red and blue to yellow (A. B. Poirson and B. A. Wandell, 1993).
pub const OPPONENT_OF_XYZ: Matrix = [[0.279, 0.72, -0.107], [-0.449, 0.29, -0.077], [0.086, -0.59, 0.501]];

/// Turns opponent parts into XYZ.
const XYZ_OF_OPPONENT: Matrix = inverse(&OPPONENT_OF_XYZ);

/// Weight and spread s, in degrees, of the two Gaussians of each opponent part.
pub const GAUSSIANS: [[(f64, f64); 2]; 3] =
    [[(0.921, 0.0283), (0.105, 0.133)], [(0.531, 0.0392), (0.330, 0.494)], [(0.488, 0.0536), (0.371, 0.386)]];

/// Returns the S-CIELAB error of each pixel in units of CIEDE2000, row by row from the upper left.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "an error of 0 to about 100")]
pub fn map(pair: &Pair<'_>, pixels_per_degree: PixelsPerDegree) -> Vec<f32> {
    let filters = GAUSSIANS.map(|gaussians| filter(gaussians, pixels_per_degree));
    let columns = pair.size.columns();
    let [reference, test] = [pair.reference, pair.test].map(|pixels| seen(pixels, columns, &filters));
    reference.iter().zip(&test).map(|(color, other)| ciede2000(*color, *other) as f32).collect()
}

/// Returns the blur of one opponent part as normalized Gaussians and their shares.
#[expect(clippy::cast_possible_truncation, reason = "planes are f32")]
fn filter(gaussians: [(f64, f64); 2], pixels_per_degree: PixelsPerDegree) -> [(f32, Kernel); 2] {
    let pixels = pixels_per_degree.pixels();
    let sum: f64 = gaussians.iter().map(|(weight, _)| weight).sum();
    gaussians.map(|(weight, spread)| {
        let deviation = (spread * pixels / 2.0_f64.sqrt()).max(SHARPEST);
        ((weight / sum) as f32, Kernel::gaussian(Kernel::radius(deviation), deviation))
    })
}

/// Returns the blurred colours of one picture.
#[expect(clippy::cast_possible_truncation, reason = "planes are f32")]
fn seen(pixels: &[Rgb<u8>], columns: usize, filters: &[[(f32, Kernel); 2]; 3]) -> Vec<Lab> {
    let mut planes = [const { Vec::new() }; 3];
    for xyz in xyz(pixels) {
        for (plane, part) in planes.iter_mut().zip(product(&OPPONENT_OF_XYZ, xyz)) {
            plane.push(part as f32);
        }
    }
    let [light, red_green, blue_yellow] = planes;
    let [light_filter, red_green_filter, blue_yellow_filter] = filters;
    let light = Plane::new(columns, light).blurred(light_filter);
    let red_green = Plane::new(columns, red_green).blurred(red_green_filter);
    let blue_yellow = Plane::new(columns, blue_yellow).blurred(blue_yellow_filter);
    let parts = light.values().iter().zip(red_green.values()).zip(blue_yellow.values());
    let colors = parts.map(|((light, red_green), blue_yellow)| {
        let opponent = [f64::from(*light), f64::from(*red_green), f64::from(*blue_yellow)];
        Lab::of_xyz(product(&XYZ_OF_OPPONENT, opponent))
    });
    colors.collect()
}
