//! Materials at several wavelengths.

use rta_core::color::Rgb;
use rta_core::material::Material;
use rta_core::scalar::{Scalar, Unit};

use super::Narrow;
use crate::description;
use crate::spectrum;

/// The materials of a scene at one wavelength, in the order of their numbers.
#[derive(Clone, Debug)]
pub struct Table<S: Scalar> {
    /// What the tracer must know of each.
    pub materials: Vec<Material<S>>,
    /// What the scene says of each.
    pub said: Vec<description::Material>,
}

impl<S: Scalar> Table<S> {
    pub(super) const EMPTY: Self = Self { materials: Vec::new(), said: Vec::new() };
}

/// What a scene has of further wavelengths, where something of it depends on them.
#[derive(Clone, Debug)]
pub struct Spectrum<S: Scalar> {
    /// The weights of all wavelengths.
    pub weights: Vec<Rgb<S::Unit>>,
    /// The materials at all wavelengths but the first.
    pub further: Vec<Table<S>>,
}

/// Returns [`weights`](crate::spectrum::weights) in a number format. The largest weight of each register takes up what the others are rounded by, so that the sum is
/// 1, exactly in fixed point.
#[must_use]
pub fn weights<S: Narrow>(count: u32) -> Vec<Rgb<S::Unit>> {
    let weights = spectrum::weights(count);
    let register = |register: usize| {
        let own = |weight: &[f64; 3]| weight.get(register).map_or(S::Unit::ZERO, |&w| S::unit(w));
        let mut all: Vec<S::Unit> = weights.iter().map(own).collect();
        let mut largest = 0;
        for (i, weight) in all.iter().enumerate() {
            if all.get(largest).is_some_and(|most| weight > most) {
                largest = i;
            }
        }
        let others = all.iter().enumerate().filter(|(i, _)| *i != largest);
        let others = others.fold(S::Unit::ZERO, |sum, (_, &weight)| sum + weight);
        if let Some(most) = all.get_mut(largest) {
            *most = S::Unit::ONE - others;
        }
        all
    };
    let (red, green, blue) = (register(0), register(1), register(2));
    red.into_iter().zip(green).zip(blue).map(|((r, g), b)| Rgb::new(r, g, b)).collect()
}

#[cfg(test)]
mod tests {
    use rta_core::{Q16, Q20};

    use super::*;

    fn sum<S: Narrow>(count: u32) -> [f64; 3] {
        let zero = Rgb::new(S::Unit::ZERO, S::Unit::ZERO, S::Unit::ZERO);
        let sum = weights::<S>(count).into_iter().fold(zero, |sum, weight| sum.zip(weight, |a, b| a + b));
        [sum.r, sum.g, sum.b].map(S::unit_to_f64)
    }

    #[test]
    #[allow(clippy::float_cmp, reason = "fixed point is exact")]
    fn weights_add_up_to_one_in_every_format() {
        for count in (1..=31).step_by(2) {
            assert_eq!(weights::<f64>(count).len(), count as usize);
            assert_eq!((sum::<Q16>(count), sum::<Q20>(count)), ([1.0; 3], [1.0; 3]), "{count}");
            for (sums, tolerance) in [(sum::<f64>(count), 1e-15), (sum::<f32>(count), 2e-7)] {
                assert!(sums.iter().all(|sum| (sum - 1.0).abs() <= tolerance), "{count}: {sums:?}");
            }
            assert!(
                spectrum::weights(count).as_flattened().iter().all(|weight| (0.0..=1.0).contains(weight))
            );
        }
    }
}
