//! T. Whitted, "An Improved Illumination Model for Shaded Display", Communications of the ACM 23 (1980), section 2.

use super::{Bend, Illumination, Secondary, rowless};
use crate::color::Rgb;
use crate::light::Incident;
use crate::material::{Finish, Material};
use crate::needs::Needs;
use crate::scalar::vector::UnitVector;
use crate::scalar::{Exponent, Light, Scalar, Unit};
use crate::surface::Surface;

/// `I = Ia C ka + kd sum (N.L) C I + ks (I_ref + sum (N.H)^n I) + kt I_tra`
///
/// Lamps are not attenuated, unless they say so ([`FallOff`](crate::light::FallOff)). Mirrors are colourless. The thesis's materials have no
/// coefficients, so the model supplies them:
///
/// | material | ka | kd | ks | kt |
/// | --- | --- | --- | --- | --- |
/// | opaque | `ka` | 1 | 0 | 0 |
/// | shiny | `ka` | 1 - `shine` | `shine` | 0 |
/// | mirror | 0 | 0 | 1 | 0 |
/// | transparent | 0 | 0 | ks of the scene | kt of the scene |
/// | a finish of its own | `ka` kd | its kd | its ks | its kt |
#[derive(Clone, Copy, Debug)]
pub struct Whitted<S: Scalar> {
    /// Ambient coefficient of diffuse surfaces, 0 to 1.
    pub ka: S::Unit,
    /// Specular coefficient of shiny surfaces, 0 to 1; the rest of their light is diffuse.
    pub shine: S::Unit,
    /// Exponent of the highlight: the larger the exponent, the smaller the highlight.
    pub exponent: Exponent,
}

impl<S: Scalar> Default for Whitted<S> {
    /// ka = 1, shine = 0.2, exponent = 50.
    fn default() -> Self {
        Self { ka: S::Unit::ONE, shine: S::Unit::ratio(1, 5), exponent: Exponent::new(50, 0) }
    }
}

impl<S: Scalar> Whitted<S> {
    /// Returns kd, ks and the exponent of highlights for a material; `exponent` chooses that of a finish.
    pub(super) fn coefficients<N: Needs>(
        &self,
        material: &Material<S>,
        exponent: impl FnOnce(&Finish<S>) -> Exponent,
    ) -> (S::Unit, S::Unit, Exponent) {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        if let Some(finish) = material.finish::<N>() {
            return (finish.kd, finish.glass.ks, exponent(finish));
        }
        let (kd, ks) = match material {
            Material::Shiny => (one - self.shine, self.shine),
            Material::Mirror => (zero, one),
            Material::Transparent(glass) => (zero, glass.ks),
            _ => (one, zero),
        };
        (kd, ks, self.exponent)
    }

    /// Returns the radiance that the point sends back of one lamp; `highlight` computes the cosine whose power the
    /// highlight is, `exponent` chooses the exponent of a finish.
    pub(super) fn lit<N: Needs>(
        &self,
        surface: &Surface<S>,
        incident: &Incident<S>,
        exponent: impl FnOnce(&Finish<S>) -> Exponent,
        highlight: impl FnOnce() -> S::Unit,
    ) -> Rgb<S::Light> {
        let (kd, ks, exponent) = self.coefficients::<N>(surface.material, exponent);
        let intensity = incident.light::<N>(false);
        let diffuse = kd.times(incident.cosine);
        let specular = if N::GLINT && ks > S::Unit::ZERO {
            let cosine = highlight();
            let cosine = if cosine < S::Unit::ZERO { S::Unit::ZERO } else { cosine };
            ks.times(cosine.power(exponent))
        } else {
            S::Unit::ZERO
        };
        surface.color.zip(incident.lamp.tint, |color, part| {
            let light = intensity.times(part);
            light.times(color.times(diffuse)).plus(light.times(specular))
        })
    }
}

impl<S: Scalar> Illumination<S> for Whitted<S> {
    type Weight = S::Unit;
    const ATTENUATION: bool = false;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        let part = match surface.material {
            Material::Opaque | Material::Shiny => self.ka,
            material => match material.finish::<N>() {
                Some(finish) => self.ka.times(finish.ka),
                None => return Rgb::BLACK,
            },
        };
        ambient.zip(surface.color, |light, color| light.times(color.times(part)))
    }

    fn is_lit<N: Needs>(&self, _surface: &Surface<S>) -> bool {
        true
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        let exponent = |finish: &Finish<S>| finish.exponent;
        self.lit::<N>(surface, incident, exponent, || {
            let halfway = incident.direction.halfway(-surface.incoming);
            halfway.map_or(S::Unit::ZERO, |h| surface.normal.dot(h))
        })
    }

    fn diffuse<N: Needs>(&self, surface: &Surface<S>) -> Rgb<S::Unit> {
        let (kd, ..) = self.coefficients::<N>(surface.material, |finish| finish.exponent);
        surface.color.map(|color| color.times(kd))
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<S::Unit> {
        let (_, ks, _) = self.coefficients::<N>(surface.material, |finish| finish.exponent);
        Secondary {
            reflected: (ks > S::Unit::ZERO).then_some(ks),
            transmitted: surface.material.glass::<N>().map(|glass| glass.kt),
            bend: Bend::Refracted,
        }
    }
}

rowless!(Whitted<S>);
