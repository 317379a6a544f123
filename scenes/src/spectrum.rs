//! The wavelengths of a picture and their colours.

/// The visible wavelengths that pictures are made of, in nanometres.
const VISIBLE: (f64, f64) = (400.0, 700.0);

/// The colour-matching functions of the CIE's observer of 1931 as sums of lobes: height, middle in nanometres, and the reciprocal widths
/// before and after the middle (C. Wyman, P.-P. Sloan and P. Shirley, "Simple Analytic Approximations to the CIE XYZ Color
/// Matching Functions", JCGT 2, 2013).
const LOBES: [&[[f64; 4]]; 3] = [
    &[[0.362, 442.0, 0.0624, 0.0374], [1.056, 599.8, 0.0264, 0.0323], [-0.065, 501.1, 0.0490, 0.0382]],
    &[[0.821, 568.8, 0.0213, 0.0247], [0.286, 530.9, 0.0613, 0.0322]],
    &[[1.217, 437.0, 0.0845, 0.0278], [0.681, 459.0, 0.0385, 0.0725]],
];

/// From XYZ to linear sRGB (IEC 61966-2-1), a row for each register.
const SRGB: [[f64; 3]; 3] =
    [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]];

/// Returns wavelength number `i` of `count`, from 0, in nanometres: the middle of its part of what is visible.
#[must_use]
pub fn wavelength(i: u32, count: u32) -> f64 {
    let (first, last) = VISIBLE;
    first + (last - first) * (f64::from(i) + 0.5) / f64::from(count.max(1))
}

/// Returns red, green and blue of light of one wavelength in nanometres; what is outside the gamut is cut to it.
fn color(nanometres: f64) -> [f64; 3] {
    let lobe = |&[height, middle, before, after]: &[f64; 4]| {
        let width = if nanometres < middle { before } else { after };
        height * (-0.5 * (width * (nanometres - middle)).powi(2)).exp()
    };
    let [x, y, z] = LOBES.map(|lobes| lobes.iter().map(lobe).sum::<f64>());
    SRGB.map(|[a, b, c]| (a * x + b * y + c * z).max(0.0))
}

/// Returns the weights of `count` wavelengths in red, green and blue. Each register adds up to 1, so that grey stays grey; one that none
/// of so few wavelengths has takes an equal part of each.
#[must_use]
pub fn weights(count: u32) -> Vec<[f64; 3]> {
    let mut colors: Vec<_> = (0..count).map(|i| color(wavelength(i, count))).collect();
    let mut sums = [0.0; 3];
    for color in &colors {
        sums.iter_mut().zip(color).for_each(|(sum, register)| *sum += register);
    }
    for color in &mut colors {
        for (register, sum) in color.iter_mut().zip(sums) {
            *register = if sum > 0.0 { *register / sum } else { f64::from(count).recip() };
        }
    }
    colors
}

#[cfg(test)]
mod tests {
    #![allow(clippy::indexing_slicing)] // a test may panic
    use super::*;

    #[test]
    fn one_wavelength_is_in_the_middle_and_weighs_all() {
        assert!((wavelength(0, 1) - 550.0).abs() < 1e-12);
        assert_eq!(weights(1), [[1.0; 3]]);
    }

    #[test]
    fn short_wavelengths_are_blue_and_long_ones_red() {
        for count in (9..=31).step_by(2) {
            let weights = weights(count);
            let most = |register: usize| {
                (0..weights.len()).max_by(|&a, &b| weights[a][register].total_cmp(&weights[b][register]))
            };
            assert!(most(2) < most(1) && most(1) < most(0), "{count}");
        }
    }
}
