//! Wavelengths: their weights and the indices of glasses, as pictures have them.

use rta_core::color::Rgb;
use rta_core::illumination::table::Properties;
use rta_scenes::description::{Dispersion, Material};
use rta_scenes::narrow::{Narrow, spectrum};
use rta_scenes::rta;

/// The materials whose index is by Sellmeier's formula, by their numbers from 1.
const SELLMEIER: [&str; 6] = ["bk7", "sf2", "fused-quartz", "water", "diamond", "carbon-disulfide"];

/// The most wavelengths of a picture.
const MOST: f64 = 31.0;

/// Returns a number as an index, if it is one from 0 to `most`.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // it is a small whole number
fn index(number: f64, most: f64) -> Option<usize> {
    ((0.0..=most).contains(&number) && number.fract() == 0.0).then_some(number as usize)
}

/// Returns the weight of wavelength `i` of `count` in a register: 0 red, 1 green, 2 blue.
pub(super) fn weight<S: Narrow>(count: f64, i: f64, register: f64) -> f64 {
    let weight = || {
        let count = u32::try_from(index(count, MOST)?).ok()?;
        let Rgb { r, g, b } = *spectrum::weights::<S>(count).get(index(i, MOST)?)?;
        [r, g, b].get(index(register, 2.0)?).map(|&weight| S::unit_to_f64(weight))
    };
    weight().unwrap_or(f64::NAN)
}

/// Returns the index of a material at a wavelength in nanometres, from the ratio of indices that the format has.
fn at<S: Narrow>(material: &Material, nm: f64) -> f64 {
    let index = Properties::<S>::index(&material.at(nm));
    index.map_or(f64::NAN, |(eta, is_denser)| {
        let eta = S::unit_to_f64(eta);
        if is_denser { eta.recip() } else { eta }
    })
}

/// Returns the index of a material that every scene knows.
pub(super) fn built_in<S: Narrow>(name: &str, nm: f64) -> f64 {
    rta::built_in(name).map_or(f64::NAN, |material| at::<S>(&material, nm))
}

/// Returns the index of a material by Sellmeier's formula.
pub(super) fn sellmeier<S: Narrow>(k: f64, nm: f64) -> f64 {
    let name = index(k - 1.0, MOST).and_then(|k| SELLMEIER.get(k));
    name.map_or(f64::NAN, |name| built_in::<S>(name, nm))
}

/// Returns the index by Cauchy's formula through the index at 587.5618 nm.
pub(super) fn cauchy<S: Narrow>(index: f64, abbe: f64, nm: f64) -> f64 {
    let material =
        Material { index: Some(index), dispersion: Some(Dispersion::Abbe(abbe)), ..Material::default() };
    at::<S>(&material, nm)
}
