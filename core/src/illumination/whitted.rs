//! T. Whitted, "An Improved Illumination Model for Shaded Display", Communications of the ACM 23 (1980), section 2.

use super::{Illumination, Secondary, Surface};
use crate::color::Rgb;
use crate::light::Incident;
use crate::material::Material;
use crate::needs::Needs;
use crate::scalar::{Light, Scalar, Unit};
use crate::vector::UnitVector;

/// `I = Ia C ka + kd sum (N.L) C I + ks (I_ref + sum (N.H)^n I) + kt I_tra`
///
/// Lamps are not attenuated; an intensity above 1, as an attenuated lamp needs it, counts as 1. Mirrors are colourless.
/// The thesis's materials say only what kind they are, so the coefficients of the kinds are the model's:
///
/// | material | ka | kd | ks | kt |
/// | --- | --- | --- | --- | --- |
/// | opaque | `ka` | 1 | 0 | 0 |
/// | shiny | `ka` | 1 - `shine` | `shine` | 0 |
/// | mirror | 0 | 0 | 1 | 0 |
/// | transparent | 0 | 0 | ks of the scene | kt of the scene |
#[derive(Clone, Copy, Debug)]
pub struct Whitted<S: Scalar> {
    /// Ambient coefficient of diffuse surfaces, 0 to 1.
    pub ka: S::Unit,
    /// Specular coefficient of shiny surfaces, 0 to 1; the rest of their light is diffuse.
    pub shine: S::Unit,
    /// Exponent of the highlight: the larger, the smaller.
    pub exponent: u32,
}

impl<S: Scalar> Default for Whitted<S> {
    /// ka = 1, shine = 0.2, exponent = 50.
    fn default() -> Self {
        Self { ka: S::Unit::ONE, shine: S::Unit::ratio(1, 5), exponent: 50 }
    }
}

impl<S: Scalar> Whitted<S> {
    /// kd and ks.
    fn coefficients(&self, material: &Material<S>) -> (S::Unit, S::Unit) {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        match material {
            Material::Opaque => (one, zero),
            Material::Shiny => (one - self.shine, self.shine),
            Material::Mirror => (zero, one),
            Material::Transparent(glass) => (zero, glass.ks),
        }
    }
}

impl<S: Scalar> Illumination<S> for Whitted<S> {
    type Weight = S::Unit;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        match surface.material {
            Material::Opaque | Material::Shiny => {
                ambient.zip(surface.color, |light, color| light.times(color.times(self.ka)))
            }
            Material::Mirror | Material::Transparent(_) => {
                Rgb::new(S::Light::ZERO, S::Light::ZERO, S::Light::ZERO)
            }
        }
    }

    fn is_lit(&self, _surface: &Surface<S>) -> bool {
        true
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        let (kd, ks) = self.coefficients(surface.material);
        let intensity = incident.intensity();
        let intensity = if intensity > S::Light::WHITE { S::Light::WHITE } else { intensity };
        let diffuse = kd.times(incident.cosine);
        let specular = if N::GLINT && ks > S::Unit::ZERO {
            let halfway = incident.direction.halfway(-surface.incoming);
            let cosine = halfway.map_or(S::Unit::ZERO, |h| surface.normal.dot(h));
            let cosine = if cosine < S::Unit::ZERO { S::Unit::ZERO } else { cosine };
            ks.times(cosine.power(self.exponent))
        } else {
            S::Unit::ZERO
        };
        surface.color.zip(incident.lamp.tint, |color, part| {
            let light = intensity.times(part);
            light.times(color.times(diffuse)).plus(light.times(specular))
        })
    }

    fn secondary(&self, surface: &Surface<S>) -> Secondary<S::Unit> {
        let (_, ks) = self.coefficients(surface.material);
        Secondary {
            reflected: (ks > S::Unit::ZERO).then_some(ks),
            transmitted: match surface.material {
                Material::Transparent(glass) => Some(glass.kt),
                _ => None,
            },
        }
    }
}
