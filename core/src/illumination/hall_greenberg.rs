//! R. A. Hall and D. P. Greenberg, "A Testbed for Realistic Image Synthesis", IEEE CG&A 3 (1983).

use super::microfacet::{highlight, refracting};
use super::table::{Kind, PositiveOf, Properties, Reflecting, Reflection, Row, Tabled, Value};
use super::{Bend, Illumination, Passage, Secondary, Way, Whitted};
use crate::color::Rgb;
use crate::light::Incident;
use crate::needs::Needs;
use crate::scalar::vector::{UnitVector, Vec3};
use crate::scalar::{Exponent, Light, Scalar, Unit};
use crate::surface::Surface;

/// `I = ka C Ia + kd C sum S I N.L + ks (F I_ref A^d + sum S I F_h (N.H)^n) + kt ((1 - F) I_tra A^d + sum' S I (1 - F_t) (N'.H')^n)`
///
/// Light is reflected and transmitted by Fresnel's equations and absorbed inside of materials; a ray inside of glass sees the lamps
/// outside through its surface (sum'). H' faces so that it refracts light of the lamp into the ray. Lamps are not attenuated.
///
/// | of the thesis's types | kd | ks | kt | reflectance |
/// | --- | --- | --- | --- | --- |
/// | 0, opaque | 1 | 0 | 0 | |
/// | 1, shiny | .8 | .2 | 0 | of the index 1.5 |
/// | 2, mirror | 0 | 1 | 0 | the object's colour where it is met perpendicularly |
/// | 3, glass | 0 | its ks | its kt | of its index |
///
/// Glass that states no coefficients has ks and kt 1: Fresnel's equations share the light.
#[derive(Clone, Copy, Debug)]
pub struct HallGreenberg<'a, S: Scalar> {
    /// The ambient and the diffuse part of the surface.
    pub surface: Whitted<S>,
    /// The materials.
    pub rows: &'a [HallGreenbergRow<S>],
    /// The weight below which, in every register, no ray is traced: their adaptive depth.
    pub cutoff: S::Unit,
}

impl<S: Scalar> Default for HallGreenberg<'static, S> {
    /// With a cut-off of 1/512, half of a level of 8 bits.
    fn default() -> Self {
        Self::with_cutoff(S::Unit::ratio(1, 512))
    }
}

impl<S: Scalar> HallGreenberg<'static, S> {
    /// Returns the model with another cut-off, 0 to 1.
    pub fn with_cutoff(cutoff: S::Unit) -> Self {
        Self { surface: Whitted::default(), rows: &[], cutoff }
    }
}

/// What Hall's and Greenberg's model must know of a material.
#[derive(Clone, Copy, Debug)]
pub struct HallGreenbergRow<S: Scalar> {
    /// ks, 0 to 1.
    pub specular: S::Unit,
    /// kt, 0 to 1.
    pub transmit: S::Unit,
    /// n, of both kinds of highlights.
    pub exponent: Exponent,
    /// What its border reflects.
    pub reflection: Reflection<S>,
    /// -log2 of what is left of light inside after a length of 1, 0 or more.
    pub density: Rgb<PositiveOf<S>>,
}

impl<S: Scalar> Row<S> for HallGreenbergRow<S> {
    const NAME: &'static str = "HallGreenbergRow";
    fn fields(&self, mut see: impl FnMut(&'static str, Value<S>)) {
        see("specular", Value::Unit(self.specular));
        see("transmit", Value::Unit(self.transmit));
        see("exponent", Value::Exponent(self.exponent));
        see("reflection", Value::Reflection(self.reflection));
        see("density", Value::Positives(self.density));
    }
}

impl<S: Scalar> Tabled<S> for HallGreenberg<'_, S> {
    type Row = HallGreenbergRow<S>;
    type Over<'r> = HallGreenberg<'r, S>;

    fn row(&self, material: &impl Properties<S>) -> HallGreenbergRow<S> {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        let (specular, transmit) = match material.kind() {
            Kind::Opaque => (zero, zero),
            Kind::Shiny => (S::Unit::ratio(1, 5), zero),
            Kind::Mirror | Kind::Metal => (one, zero),
            Kind::Glass => (one, one),
        };
        let none = zero.positive();
        HallGreenbergRow {
            specular: material.specular().unwrap_or(specular),
            transmit: material.transmit().unwrap_or(transmit),
            exponent: material.exponent().unwrap_or(Exponent::new(50, 0)),
            reflection: Reflection::of(material),
            density: material.absorption().unwrap_or(Rgb::new(none, none, none)),
        }
    }

    fn over<'r>(&self, rows: &'r [HallGreenbergRow<S>]) -> HallGreenberg<'r, S> {
        HallGreenberg { surface: self.surface, rows, cutoff: self.cutoff }
    }
}

impl<S: Scalar> HallGreenberg<'_, S> {
    fn row_of(&self, surface: &Surface<S>) -> Option<&HallGreenbergRow<S>> {
        self.rows.get(usize::from(surface.number))
    }

    /// Returns the highlight of a lamp on the side of the ray, or of one outside on a surface that is seen from inside, as a
    /// reflectance or a transmittance of each register.
    fn highlight<N: Needs>(
        row: &HallGreenbergRow<S>,
        surface: &Surface<S>,
        incident: &Incident<S>,
    ) -> Rgb<S::Unit> {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        let (light, view) = (incident.direction, -surface.incoming);
        let is_beyond = incident.cosine <= zero;
        if is_beyond && !N::GLASS {
            return Rgb::new(zero, zero, zero);
        }
        let coefficient = if is_beyond { row.transmit } else { row.specular };
        let Reflection { q, denser, is_thin, .. } = row.reflection;
        let (cosine, incidence) = if is_beyond && (is_thin || q >= one) {
            (-light.dot(view), -incident.cosine)
        } else {
            let facet = if is_beyond { refracting(light, view, q, denser) } else { light.halfway(view) };
            facet.map_or((zero, zero), |facet| {
                let cosine = surface.normal.dot(facet);
                (if is_beyond { -cosine } else { cosine }, light.dot(facet))
            })
        };
        if cosine <= zero || incidence <= zero || coefficient <= zero {
            return Rgb::new(zero, zero, zero);
        }
        let shine = highlight(if cosine > one { one } else { cosine }, row.exponent, coefficient);
        // Light of a lamp beyond comes from outside.
        let part = row.reflection.at(surface.color, surface.inside && !is_beyond, incidence);
        part.map(|part| if is_beyond { one - part } else { part }.times(shine))
    }
}

impl<S: Scalar> Illumination<S> for HallGreenberg<'_, S> {
    type Weight = Rgb<S::Unit>;
    const ATTENUATION: bool = false;
    const REFRACTS_LAMPS: bool = true;
    const ALONG: bool = true;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        self.surface.ambient::<N>(surface, ambient)
    }

    fn is_lit<N: Needs>(&self, _surface: &Surface<S>) -> bool {
        true
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        let zero = S::Unit::ZERO;
        let (kd, ..) = self.surface.coefficients::<N>(surface.material, |finish| finish.exponent);
        let diffuse = if incident.cosine <= zero { zero } else { kd.times(incident.cosine) };
        let row = self.row_of(surface);
        let shine =
            row.map_or(Rgb::new(zero, zero, zero), |row| Self::highlight::<N>(row, surface, incident));
        let light = incident.light::<N>(false);
        let light = incident.lamp.tint.map(|tint| light.times(tint));
        let diffuse = light.zip(surface.color, |light, color| light.times(color.times(diffuse)));
        diffuse.zip(light.zip(shine, Light::times), Light::plus)
    }

    fn cutoff(&self) -> S::Unit {
        self.cutoff
    }

    fn diffuse<N: Needs>(&self, surface: &Surface<S>) -> Rgb<S::Unit> {
        self.surface.diffuse::<N>(surface)
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<Self::Weight> {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        let Some(row) = self.row_of(surface) else { return Secondary::NONE };
        let part = row.reflection.at(surface.color, surface.inside, -surface.normal.dot(surface.incoming));
        let asked = |weight: Rgb<S::Unit>| [weight.r, weight.g, weight.b].iter().any(|w| *w > zero);
        let reflected = part.map(|part| part.times(row.specular));
        let transmitted = part.map(|part| (one - part).times(row.transmit));
        Secondary {
            reflected: Some(reflected).filter(|weight| asked(*weight)),
            transmitted: Some(transmitted).filter(|weight| asked(*weight)),
            bend: if row.reflection.is_thin { Bend::Straight } else { Bend::Refracted },
        }
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
