//! The table of materials: each once, however many objects have it.

use std::collections::HashMap;

use rta_core::material::{Finish, Glass, Material};
use rta_core::scalar::Unit;
use rta_core::scene::PLAIN;

use super::check::{Checker, exponent};
use super::spectrum::Table;
use super::{Narrow, NarrowError};
use crate::description::{self, Coefficients, Kind, Shading, Surface};

/// The materials that were met so far, in the order of their numbers.
pub(super) struct Materials<'a, S: Narrow> {
    named: &'a [description::Material],
    numbers: HashMap<([u64; 6], Shading), u16>,
    /// Wavelengths in nanometres; none where materials have the index that they state.
    wavelengths: Vec<f64>,
    /// How triangles of each are shaded.
    pub(super) shadings: Vec<Shading>,
    /// The materials at the first wavelength.
    pub(super) first: Table<S>,
    /// The materials at each further wavelength.
    pub(super) further: Vec<Table<S>>,
}

impl<'a, S: Narrow> Materials<'a, S> {
    /// Returns an empty table for a scene with the materials `named`, at some wavelengths in nanometres; without any, materials have the
    /// index that they state.
    pub(super) fn new(named: &'a [description::Material], wavelengths: Vec<f64>) -> Self {
        let further = wavelengths.iter().skip(1).map(|_| Table::EMPTY).collect();
        Self {
            named,
            numbers: HashMap::new(),
            wavelengths,
            shadings: Vec::new(),
            first: Table::EMPTY,
            further,
        }
    }

    /// Returns the number of a surface's material; `check` names the object that has it.
    pub(super) fn number(&mut self, check: &Checker<S>, surface: &Surface) -> Result<u16, NarrowError> {
        self.shaded(check, surface, Shading::Normals)
    }

    /// Returns the number of a triangle's material, shaded in that way; `check` names the triangle.
    pub(super) fn shaded(
        &mut self,
        check: &Checker<S>,
        surface: &Surface,
        shading: Shading,
    ) -> Result<u16, NarrowError> {
        let key = (key(surface), shading);
        if let Some(&number) = self.numbers.get(&key) {
            return Ok(number);
        }
        let number = u16::try_from(self.first.said.len()).ok().filter(|&number| number < PLAIN);
        let number = number.ok_or_else(|| {
            check.error("the number of its material", f64::from(PLAIN), f64::from(PLAIN - 1))
        })?;
        let said = description::Material::of(surface, self.named);
        let mut wavelengths = self.wavelengths.iter();
        for table in core::iter::once(&mut self.first).chain(&mut self.further) {
            let said = wavelengths.next().map_or_else(|| said.clone(), |&nanometres| said.at(nanometres));
            table.materials.push(narrow(check, &said)?);
            table.said.push(said);
        }
        self.shadings.push(shading);
        self.numbers.insert(key, number);
        Ok(number)
    }
}

/// Returns what the tracer must know of materials, in their order.
///
/// # Errors
/// A coefficient that the format cannot hold.
pub(crate) fn finishes<S: Narrow>(said: &[description::Material]) -> Result<Vec<Material<S>>, NarrowError> {
    said.iter().map(|said| narrow(&Checker::named("a material"), said)).collect()
}

/// Returns numbers that differ for different surfaces.
fn key(surface: &Surface) -> [u64; 6] {
    match *surface {
        Surface::Opaque => [0; 6],
        Surface::Shiny => [1, 0, 0, 0, 0, 0],
        Surface::Mirror => [2, 0, 0, 0, 0, 0],
        Surface::Transparent { ks, kt, ior } => [3, ks.to_bits(), kt.to_bits(), ior.to_bits(), 0, 0],
        Surface::Finish { kd, ks, exponent, kt, ior } => {
            [4, kd.to_bits(), ks.to_bits(), exponent.to_bits(), kt.to_bits(), ior.to_bits()]
        }
        Surface::Of(number) => [5, number.into(), 0, 0, 0, 0],
    }
}

fn narrow<S: Narrow>(check: &Checker<S>, said: &description::Material) -> Result<Material<S>, NarrowError> {
    let Some(Coefficients { ka, kd, ks, kt, exponent: halfway, reflected, index }) = said.coefficients()
    else {
        return Ok(match said.kind {
            Kind::Shiny => Material::Shiny,
            Kind::Mirror => Material::Mirror,
            _ => Material::Opaque,
        });
    };
    for coefficient in [ka, kd, ks, kt] {
        check.at_most("a coefficient", coefficient, S::LARGEST_COLOR)?;
    }
    let [ka, kd, ks, kt] = [ka, kd, ks, kt].map(S::unit);
    let eta = S::unit(if index > 1.0 { 1.0 / index } else { index });
    let glass = Glass { ks, kt, eta, denser: index >= 1.0 };
    // The thesis's type 3, which programs that know no other coefficients can draw.
    let is_plain = said.exponent.is_none() && said.gloss.is_none();
    if is_plain && ka == S::Unit::ZERO && kd == S::Unit::ZERO && kt > S::Unit::ZERO {
        return Ok(Material::Transparent(glass));
    }
    let (exponent, reflected) = (exponent(halfway), exponent(reflected));
    Ok(Material::Finish(Finish { ka, kd, exponent, reflected, glass }))
}
