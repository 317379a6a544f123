//! W. J. Bouknight, "A Procedure for Generation of Three-dimensional Half-toned Computer Graphics Presentations",
//! Communications of the ACM 13 (1970).

use super::{Illumination, Secondary, rowless};
use crate::color::Rgb;
use crate::light::Incident;
use crate::needs::Needs;
use crate::scalar::{Exponent, Light, Scalar, Unit};
use crate::surface::Surface;

/// `I = C (ka Ia + kd sum (N.L)^p I)`
///
/// Lamps are not attenuated. With an exponent above 1 the light begins at the shadow's edge with a slope of 0, so that the eye sees no
/// Mach band there. Every surface is diffuse, whatever its material, with the diffuse coefficient of its finish where it has one.
#[derive(Clone, Copy, Debug)]
pub struct Bouknight<S: Scalar> {
    /// Ambient coefficient, 0 to 1.
    pub ka: S::Unit,
    /// Diffuse coefficient of surfaces without one of their own, 0 to 1.
    pub kd: S::Unit,
    /// Exponent of the cosine, 1 to 2.
    pub exponent: Exponent,
}

impl<S: Scalar> Default for Bouknight<S> {
    /// ka = 0.3, kd = 0.6, an exponent of 1.25.
    fn default() -> Self {
        Self { ka: S::Unit::ratio(3, 10), kd: S::Unit::ratio(6, 10), exponent: Exponent::new(5, 2) }
    }
}

impl<S: Scalar> Bouknight<S> {
    /// Returns the model with another exponent of the cosine, 1 to 2.
    pub fn with_exponent(exponent: Exponent) -> Self {
        Self { exponent, ..Self::default() }
    }
}

impl<S: Scalar> Illumination<S> for Bouknight<S> {
    /// The model has no secondary rays, so any weight type would do.
    type Weight = S::Unit;
    const REFRACTS: bool = false;
    const ATTENUATION: bool = false;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        ambient.zip(surface.color, |light, color| light.times(color.times(self.ka)))
    }

    fn is_lit<N: Needs>(&self, _surface: &Surface<S>) -> bool {
        true
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        let kd = surface.material.finish::<N>().map_or(self.kd, |finish| finish.kd);
        let light = incident.light::<N>(false);
        let part = kd.times(incident.cosine.power(self.exponent));
        surface.color.zip(incident.lamp.tint, |color, tint| light.times(tint).times(color.times(part)))
    }

    fn secondary<N: Needs>(&self, _surface: &Surface<S>) -> Secondary<S::Unit> {
        Secondary::NONE
    }
}

rowless!(Bouknight<S>);
