//! D. S. Kay and D. P. Greenberg, "Transparency for Computer Synthesized Images", SIGGRAPH 1979.

use super::table::{PositiveOf, Properties, Row, Tabled, Value};
use super::{Illumination, Passage, Secondary, Way, Whitted};
use crate::color::Rgb;
use crate::light::Incident;
use crate::needs::Needs;
use crate::scalar::vector::Vec3;
use crate::scalar::{Scalar, Unit};
use crate::surface::Surface;

/// `I = ka C Ia + sum S I (kd C N.L + ks (N.H)^n) + ks A^d I_ref + kt A^d I_tra`
///
/// Whitted's model, with light that is absorbed inside of materials: of the light of a ray that ran a distance d inside of one the part
/// A^d is left, A being the material's for a length of 1 and for each register. Shadow rays are not absorbed.
#[derive(Clone, Copy, Debug)]
pub struct KayGreenberg<'a, S: Scalar> {
    /// The surface.
    pub surface: Whitted<S>,
    /// What the materials absorb.
    pub rows: &'a [KayGreenbergRow<S>],
}

impl<S: Scalar> Default for KayGreenberg<'static, S> {
    fn default() -> Self {
        Self { surface: Whitted::default(), rows: &[] }
    }
}

/// What Kay's and Greenberg's model must know of a material.
#[derive(Clone, Copy, Debug)]
pub struct KayGreenbergRow<S: Scalar> {
    /// -log2 of A, 0 or more.
    pub density: Rgb<PositiveOf<S>>,
}

impl<S: Scalar> Row<S> for KayGreenbergRow<S> {
    const NAME: &'static str = "KayGreenbergRow";
    fn fields(&self, mut see: impl FnMut(&'static str, Value<S>)) {
        see("density", Value::Positives(self.density));
    }
}

impl<S: Scalar> Tabled<S> for KayGreenberg<'_, S> {
    type Row = KayGreenbergRow<S>;
    type Over<'r> = KayGreenberg<'r, S>;

    fn row(&self, material: &impl Properties<S>) -> KayGreenbergRow<S> {
        let none = S::Unit::ZERO.positive();
        KayGreenbergRow { density: material.absorption().unwrap_or(Rgb::new(none, none, none)) }
    }

    fn over<'r>(&self, rows: &'r [KayGreenbergRow<S>]) -> KayGreenberg<'r, S> {
        KayGreenberg { surface: self.surface, rows }
    }
}

impl<S: Scalar> Illumination<S> for KayGreenberg<'_, S> {
    type Weight = Rgb<S::Unit>;
    const ATTENUATION: bool = false;
    const ALONG: bool = true;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        self.surface.ambient::<N>(surface, ambient)
    }

    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool {
        self.surface.is_lit::<N>(surface)
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        self.surface.direct::<N>(surface, incident)
    }

    fn diffuse<N: Needs>(&self, surface: &Surface<S>) -> Rgb<S::Unit> {
        self.surface.diffuse::<N>(surface)
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<Self::Weight> {
        self.surface.secondary::<N>(surface).registers::<S>()
    }

    fn along<N: Needs>(
        &self,
        way: &Way<S>,
        _lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Self::Weight>> {
        let number = way.inside().filter(|_| N::GLASS)?;
        way.absorbed(self.rows.get(usize::from(number))?.density)
    }
}
