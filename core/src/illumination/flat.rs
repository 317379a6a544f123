//! No model at all: each surface looks as if it were lit evenly from everywhere.

use super::{Illumination, Secondary, rowless};
use crate::color::Rgb;
use crate::light::Incident;
use crate::needs::Needs;
use crate::scalar::{Light, Scalar};
use crate::surface::Surface;

/// `I = C`: the colour of the surface, whatever its material, without lamps, ambient light or secondary rays.
#[derive(Clone, Copy, Debug, Default)]
pub struct Flat;

impl<S: Scalar> Illumination<S> for Flat {
    /// The model has no secondary rays, so any weight type would do.
    type Weight = S::Unit;
    const REFRACTS: bool = false;
    const ATTENUATION: bool = false;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, _ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        surface.color.map(|color| S::Light::WHITE.times(color))
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

rowless!(Flat);
