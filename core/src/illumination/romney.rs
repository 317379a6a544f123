//! G. W. Romney, "Computer Assisted Assembly and Rendering of Solids", University of Utah (1970).

use super::fade::fade;
use super::{Illumination, Secondary, rowless};
use crate::color::Rgb;
use crate::light::Incident;
use crate::needs::Needs;
use crate::scalar::vector::UnitVector;
use crate::scalar::{Exponent, Light, Scalar, Unit};
use crate::surface::Surface;

/// `I = C (N.V)^p min(1, d0/d)^4`
///
/// The only lamp is in the eye and has the intensity 1, so there are no shadows. Light fades with the distance d from the eye, beyond
/// a distance d0. Every surface is diffuse, whatever its material; no ray is reflected or transmitted.
#[derive(Clone, Copy, Debug)]
pub struct Romney<S: Scalar> {
    /// p, from 1 to 100.
    pub exponent: Exponent,
    /// d0, the distance up to which nothing fades.
    pub reference: S,
}

impl<S: Scalar> Default for Romney<S> {
    /// p = 2; nothing fades, as only a scene can tell what is far in it.
    fn default() -> Self {
        Self { exponent: Exponent::new(2, 0), reference: S::FAR }
    }
}

impl<S: Scalar> Romney<S> {
    /// Returns the model with another exponent of the cosine, 1 to 100.
    pub fn with_exponent(exponent: Exponent) -> Self {
        Self { exponent, ..Self::default() }
    }
}

impl<S: Scalar> Illumination<S> for Romney<S> {
    /// The model has no secondary rays, so any weight type would do.
    type Weight = S::Unit;
    const REFRACTS: bool = false;
    const ATTENUATION: bool = false;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, _ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        let cosine = -surface.normal.dot(surface.incoming);
        if cosine <= S::Unit::ZERO {
            return Rgb::BLACK;
        }
        let cosine = if cosine > S::Unit::ONE { S::Unit::ONE } else { cosine };
        let left = fade(surface.distance, self.reference, Exponent::new(4, 0));
        let part = cosine.power(self.exponent).times(left);
        surface.color.map(|color| S::Light::WHITE.times(color.times(part)))
    }

    fn is_lit<N: Needs>(&self, _surface: &Surface<S>) -> bool {
        false
    }

    fn direct<N: Needs>(&self, _surface: &Surface<S>, _incident: &Incident<S>) -> Rgb<S::Light> {
        Rgb::BLACK
    }

    fn secondary<N: Needs>(&self, _surface: &Surface<S>) -> Secondary<S::Unit> {
        Secondary::NONE
    }
}

rowless!(
    Romney<S>,
    fn focused(self, reference: S) -> Self {
        Self { reference, ..self }
    }
);
