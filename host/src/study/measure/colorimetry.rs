//! From codes of sRGB (IEC 61966-2-1) to linear light, to CIE 1931 XYZ, and to CIELAB (1976).

use rta_core::color::Rgb;

/// Three rows of three numbers, by which a colour of three registers is multiplied.
pub type Matrix = [[f64; 3]; 3];

/// Turns linear sRGB of 0 to 1 into XYZ, whose Y is 1 for white: computed from the chromaticities of the primaries of ITU-R BT.709
/// and of D65 as fractions, as FLIP does it.
pub const XYZ_OF_RGB: Matrix = [
    [10_135_552.0 / 24_577_794.0, 8_788_810.0 / 24_577_794.0, 4_435_075.0 / 24_577_794.0],
    [2_613_072.0 / 12_288_897.0, 8_788_810.0 / 12_288_897.0, 887_015.0 / 12_288_897.0],
    [1_425_312.0 / 73_733_382.0, 8_788_810.0 / 73_733_382.0, 70_074_185.0 / 73_733_382.0],
];

/// Turns XYZ into linear sRGB.
pub const RGB_OF_XYZ: Matrix = inverse(&XYZ_OF_RGB);

/// XYZ of the white of sRGB, D65.
pub const WHITE: [f64; 3] = product(&XYZ_OF_RGB, [1.0; 3]);

/// Returns a matrix times a colour.
#[must_use]
pub const fn product(matrix: &Matrix, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let [[a, b, c], [d, e, f], [g, h, i]] = *matrix;
    [a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z]
}

/// Returns the inverse of a matrix by Cramer's rule. One without an inverse gives infinities and NaN.
#[must_use]
pub const fn inverse(matrix: &Matrix) -> Matrix {
    let [[a, b, c], [d, e, f], [g, h, i]] = *matrix;
    let cofactors = [e * i - f * h, f * g - d * i, d * h - e * g];
    let [p, q, r] = cofactors;
    let determinant = a * p + b * q + c * r;
    [
        [p / determinant, (c * h - b * i) / determinant, (b * f - c * e) / determinant],
        [q / determinant, (a * i - c * g) / determinant, (c * d - a * f) / determinant],
        [r / determinant, (b * g - a * h) / determinant, (a * e - b * d) / determinant],
    ]
}

/// Returns the linear light, 0 to 1, of a code of sRGB, 0 to 1.
#[must_use]
pub fn linear(code: f64) -> f64 {
    if code <= 0.04045 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

/// Returns XYZ of each pixel of a picture in codes of sRGB; white has Y = 1.
pub fn xyz(pixels: &[Rgb<u8>]) -> impl ExactSizeIterator<Item = [f64; 3]> {
    let levels: Vec<f64> = (0..=u8::MAX).map(|code| linear(f64::from(code) / 255.0)).collect();
    pixels.iter().map(move |pixel| {
        // The table has an entry for each code.
        let Rgb { r, g, b } = pixel.map(|code| levels.get(usize::from(code)).copied().unwrap_or(1.0));
        product(&XYZ_OF_RGB, [r, g, b])
    })
}

/// A colour in CIELAB with the white of sRGB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lab {
    /// Lightness: 0 is black, 100 is white.
    pub l: f64,
    /// Green below 0, red above.
    pub a: f64,
    /// Blue below 0, yellow above.
    pub b: f64,
}

impl Lab {
    /// Returns the CIELAB of XYZ, where white has Y = 1 (CIE 15:2004, section 8.2.1). A tristimulus value below 0, which filters can
    /// give, continues the straight part of the curve.
    #[must_use]
    pub fn of_xyz([x, y, z]: [f64; 3]) -> Self {
        let [white_x, white_y, white_z] = WHITE;
        let [x, y, z] = [x / white_x, y / white_y, z / white_z].map(response);
        Self { l: 116.0 * y - 16.0, a: 500.0 * (x - y), b: 200.0 * (y - z) }
    }
}

/// Returns the cube root of a tristimulus value relative to white, and below (6/29)^3 the tangent there.
fn response(value: f64) -> f64 {
    /// Where the curve becomes straight, as a cube root.
    const BEND: f64 = 6.0 / 29.0;
    if value > BEND * BEND * BEND { value.cbrt() } else { value / (3.0 * BEND * BEND) + 4.0 / 29.0 }
}
