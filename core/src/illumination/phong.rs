//! B. T. Phong, "Illumination for Computer Generated Pictures", Communications of the ACM 18 (1975), with the secondary
//! rays of Whitted: the model that the scene format NFF assumes.

use super::{Illumination, Secondary, Whitted, rowless};
use crate::color::Rgb;
use crate::light::Incident;
use crate::material::Finish;
use crate::needs::Needs;
use crate::scalar::Scalar;
use crate::scalar::vector::UnitVector;
use crate::surface::Surface;

/// `I = Ia C ka kd + sum [kd (N.L) C + ks (R.L)^n] I + ks I_ref + kt I_tra`
///
/// R is the direction of the reflected ray. Everything else is as in [`Whitted`]: lamps are not attenuated, and coefficients
/// are those of the finish, or for the thesis's materials those of `Whitted`.
#[derive(Clone, Copy, Debug)]
pub struct Phong<S: Scalar>(pub Whitted<S>);

impl<S: Scalar> Default for Phong<S> {
    fn default() -> Self {
        Self(Whitted::default())
    }
}

impl<S: Scalar> Illumination<S> for Phong<S> {
    type Weight = S::Unit;
    const ATTENUATION: bool = false;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        self.0.ambient::<N>(surface, ambient)
    }

    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool {
        self.0.is_lit::<N>(surface)
    }

    // By itself it is 5 % more instructions of balls2.nff in f32.
    #[cfg_attr(not(target_os = "none"), inline(always))]
    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        let exponent = |finish: &Finish<S>| finish.reflected;
        let cosine = || incident.direction.dot(surface.incoming.reflect(surface.normal));
        self.0.lit::<N>(surface, incident, exponent, cosine)
    }

    fn diffuse<N: Needs>(&self, surface: &Surface<S>) -> Rgb<S::Unit> {
        self.0.diffuse::<N>(surface)
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<S::Unit> {
        self.0.secondary::<N>(surface)
    }
}

rowless!(Phong<S>);
