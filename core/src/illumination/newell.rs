//! M. E. Newell, R. G. Newell and T. L. Sancha, "A Solution to the Hidden Surface Problem", ACM National Conference (1972), with the
//! edges of D. S. Kay (1979).

use super::fade::edge;
use super::table::{Properties, Row, Tabled, Value};
use super::{Bend, Illumination, Phong, Secondary};
use crate::color::Rgb;
use crate::light::Incident;
use crate::needs::Needs;
use crate::scalar::vector::UnitVector;
use crate::scalar::{Exponent, Light, Scalar, Unit};
use crate::surface::Surface;

/// `I = (1 - t) I_surface + t I_behind`, with Phong's surface
///
/// Light goes straight through, so nothing is refracted, and nothing is reflected: a mirror shows its highlights alone. t is kt of the
/// material, or for a thin wall with an edge `least + (most - least) (1 - (1 - N.V)^n)`, denser where it is seen at an angle. What is
/// closed is crossed twice. Lamps are not attenuated.
#[derive(Clone, Copy, Debug)]
pub struct Newell<'a, S: Scalar> {
    /// The surface.
    pub surface: Phong<S>,
    /// The edges of the materials.
    pub rows: &'a [NewellRow<S>],
}

impl<S: Scalar> Default for Newell<'static, S> {
    fn default() -> Self {
        Self { surface: Phong::default(), rows: &[] }
    }
}

/// What Newell's model must know of a material.
#[derive(Clone, Copy, Debug)]
pub struct NewellRow<S: Scalar> {
    /// Whether it is a wall with an edge; otherwise it transmits its kt.
    pub has_edge: bool,
    /// n, from 1 to 3.
    pub exponent: Exponent,
    /// Transmission at the edge, 0 to 1.
    pub least: S::Unit,
    /// Transmission where it is seen perpendicularly, 0 to 1.
    pub most: S::Unit,
}

impl<S: Scalar> Row<S> for NewellRow<S> {
    const NAME: &'static str = "NewellRow";
    fn fields(&self, mut see: impl FnMut(&'static str, Value<S>)) {
        see("has_edge", Value::Flag(self.has_edge));
        see("exponent", Value::Exponent(self.exponent));
        see("least", Value::Unit(self.least));
        see("most", Value::Unit(self.most));
    }
}

impl<S: Scalar> Tabled<S> for Newell<'_, S> {
    type Row = NewellRow<S>;
    type Over<'r> = Newell<'r, S>;

    fn row(&self, material: &impl Properties<S>) -> NewellRow<S> {
        let edge = material.edge();
        let (exponent, least, most) = edge.unwrap_or((Exponent::new(2, 0), S::Unit::ZERO, S::Unit::ZERO));
        NewellRow { has_edge: edge.is_some(), exponent, least, most }
    }

    fn over<'r>(&self, rows: &'r [NewellRow<S>]) -> Newell<'r, S> {
        Newell { surface: self.surface, rows }
    }
}

impl<S: Scalar> Newell<'_, S> {
    /// Returns t, the part of the light from behind that comes through, 0 to 1.
    fn transmitted<N: Needs>(&self, surface: &Surface<S>) -> S::Unit {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        if let Some(row) = self.rows.get(usize::from(surface.number)).filter(|row| row.has_edge) {
            let cosine = -surface.normal.dot(surface.incoming);
            let cosine = if cosine > one { one } else { cosine };
            let cosine = if cosine < zero { zero } else { cosine };
            return edge(row.least, row.most, row.exponent, cosine);
        }
        let kt = surface.material.glass::<N>().map_or(zero, |glass| glass.kt);
        if kt > one { one } else { kt }
    }
}

impl<S: Scalar> Illumination<S> for Newell<'_, S> {
    type Weight = S::Unit;
    const REFRACTS: bool = false;
    const ATTENUATION: bool = false;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        let left = S::Unit::ONE - self.transmitted::<N>(surface);
        self.surface.ambient::<N>(surface, ambient).map(|light| light.times(left))
    }

    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool {
        self.surface.is_lit::<N>(surface)
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        let left = S::Unit::ONE - self.transmitted::<N>(surface);
        self.surface.direct::<N>(surface, incident).map(|light| light.times(left))
    }

    fn diffuse<N: Needs>(&self, surface: &Surface<S>) -> Rgb<S::Unit> {
        let left = S::Unit::ONE - self.transmitted::<N>(surface);
        self.surface.diffuse::<N>(surface).map(|part| part.times(left))
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<S::Unit> {
        let part = self.transmitted::<N>(surface);
        let transmitted = (part > S::Unit::ZERO).then_some(part);
        Secondary { reflected: None, transmitted, bend: Bend::Straight }
    }
}
