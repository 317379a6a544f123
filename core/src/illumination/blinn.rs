//! J. F. Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977, in its simple form: the highlight of
//! Phong's model by the vector halfway between lamp and eye, with the secondary rays of Whitted.

use super::{Illumination, Secondary, Whitted, rowless};
use crate::color::Rgb;
use crate::light::Incident;
use crate::needs::Needs;
use crate::scalar::Scalar;
use crate::surface::Surface;

/// `I = Ia C ka + sum [kd (N.L) C + ks (N.H)^n] I + ks I_ref + kt I_tra`
///
/// Whitted took this formula over, so everything is as in [`Whitted`], and both draw the same pictures until the exponent or a
/// coefficient of one of them is changed.
#[derive(Clone, Copy, Debug)]
pub struct Blinn<S: Scalar>(pub Whitted<S>);

impl<S: Scalar> Default for Blinn<S> {
    fn default() -> Self {
        Self(Whitted::default())
    }
}

impl<S: Scalar> Illumination<S> for Blinn<S> {
    type Weight = S::Unit;
    const ATTENUATION: bool = false;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        self.0.ambient::<N>(surface, ambient)
    }

    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool {
        self.0.is_lit::<N>(surface)
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        self.0.direct::<N>(surface, incident)
    }

    fn diffuse<N: Needs>(&self, surface: &Surface<S>) -> Rgb<S::Unit> {
        self.0.diffuse::<N>(surface)
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<S::Unit> {
        self.0.secondary::<N>(surface)
    }
}

rowless!(Blinn<S>);
