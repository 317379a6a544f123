//! How an index of refraction depends on the wavelength.

/// How an index of refraction depends on the wavelength.
#[derive(Clone, Debug, PartialEq)]
pub enum Dispersion {
    /// By Cauchy's formula `n = A + B / l^2` through the index at 587.5618 nm: the Abbe number, above 0.
    Abbe(f64),
    /// By Cauchy's formula with three terms, `n = A + B / l^2 + C / l^4`, l in micrometres: that of the built-in `ethyl-alcohol`, and of
    /// materials like it.
    Cauchy([f64; 3]),
    /// By Sellmeier's formula, `n^2 = offset + sum B l^2 / (l^2 - C)`, l in micrometres.
    Sellmeier {
        /// The first term, usually 1.
        offset: f64,
        /// B, and C in square micrometres.
        terms: Vec<[f64; 2]>,
    },
}

/// Wavelengths in micrometres of the lines that Abbe's number is measured at: d, F and C.
const D: f64 = 0.587_561_8;
const F: f64 = 0.486_132_7;
const C: f64 = 0.656_272_5;

/// The indices of what can be looked through; near its poles Sellmeier's formula gives others.
const INDICES: (f64, f64) = (0.1, 10.0);

impl Dispersion {
    /// Returns the index at a wavelength in nanometres, of a material whose index at 587.5618 nm is `index`, which only an Abbe number
    /// needs. It is cut to 0.1 to 10.
    #[must_use]
    pub fn index(&self, index: f64, nanometres: f64) -> f64 {
        let square = (nanometres / 1000.0).powi(2);
        let n = match self {
            Self::Abbe(number) => {
                let b = (index - 1.0) / number / (F.powi(-2) - C.powi(-2));
                index - b / D.powi(2) + b / square
            }
            Self::Cauchy([a, b, c]) => a + b / square + c / square.powi(2),
            Self::Sellmeier { offset, terms } => {
                let sum: f64 = terms.iter().map(|[b, c]| b * square / (square - c)).sum();
                (offset + sum).max(0.0).sqrt()
            }
        };
        if n.is_nan() { index } else { n.clamp(INDICES.0, INDICES.1) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_abbe_number_is_that_of_its_indices() {
        let index = |um: f64| Dispersion::Abbe(33.0).index(1.66, um * 1000.0);
        assert!((index(D) - 1.66).abs() < 1e-12);
        assert!(((index(D) - 1.0) / (index(F) - index(C)) - 33.0).abs() < 1e-9);
    }

    #[test]
    fn the_index_stays_one_of_a_glass_at_the_poles_of_a_formula() {
        let pole = Dispersion::Sellmeier { offset: 1.0, terms: vec![[0.2, 0.25], [0.1, 0.25]] };
        let opposite = Dispersion::Sellmeier { offset: 1.0, terms: vec![[0.2, 0.25], [-0.1, 0.25]] };
        for nm in [400.0, 499.999, 500.0, 500.001, 700.0] {
            for index in [&pole, &opposite].map(|dispersion| dispersion.index(1.5, nm)) {
                assert!((0.1..=10.0).contains(&index), "{nm}: {index}");
            }
        }
    }
}
