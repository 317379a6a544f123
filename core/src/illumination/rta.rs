//! The modified Whitted model of the thesis (Graham 1987).

use super::{Bend, Illumination, Secondary, rowless};
use crate::color::Rgb;
use crate::light::Incident;
use crate::material::{Finish, Material};
use crate::needs::Needs;
use crate::scalar::vector::{UnitVector, Vector};
use crate::scalar::{Light, Scalar, Unit};
use crate::surface::Surface;

/// `I = kd { [(N.CENIT + k1) k2] Ia C + sum S [(1 - B) (L.N) / d^2 C + B] I } + ks I_ref C + kt I_tra`
///
/// Lamps are attenuated with the square of the distance. The highlight `B` is 1 or 0: a shiny surface shows the lamp's full
/// intensity where the reflected ray is within 13 degrees of the direction to the lamp. Mirrors colour the light that they
/// reflect; glass colours the reflected light, not the transmitted.
#[derive(Clone, Copy, Debug, Default)]
pub struct Rta;

/// k1 k2 = 1.5 x 0.4 of the ambient term (Graham 1987).
const AMBIENT_BASE: (i64, i64) = (6, 10);
/// k2 = 0.4 of the ambient term (Graham 1987).
const AMBIENT_SLOPE: (i64, i64) = (4, 10);
/// cos 13 degrees, the edge of a highlight.
const GLINT_COSINE: (i64, i64) = (974_370_064_785_235_229, 1_000_000_000_000_000_000);

impl<S: Scalar> Illumination<S> for Rta {
    /// Mirrors colour their light, so the weight has three registers.
    type Weight = Rgb<S::Unit>;

    /// Only mirrors and glass reflect, and only what is shiny has highlights.
    const SPECULAR: bool = false;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        if !Illumination::<S>::is_lit::<N>(self, surface) {
            return Rgb::BLACK;
        }
        let color = surface.diffuse::<N>();
        let (base, slope) = (
            S::Unit::ratio(AMBIENT_BASE.0, AMBIENT_BASE.1),
            S::Unit::ratio(AMBIENT_SLOPE.0, AMBIENT_SLOPE.1),
        );
        let factor = surface.normal.z().times(slope) + base;
        ambient.zip(color, |light, color| light.times(color.times(factor)))
    }

    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool {
        matches!(surface.material, Material::Opaque | Material::Shiny)
            || surface.material.finish::<N>().is_some_and(|finish| finish.kd > S::Unit::ZERO)
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        let tint = incident.lamp.tint;
        if N::GLINT && *surface.material == Material::Shiny {
            let reflected = surface.incoming.reflect(surface.normal);
            if incident.direction.dot(reflected) > S::Unit::ratio(GLINT_COSINE.0, GLINT_COSINE.1) {
                let light = incident.intensity();
                return tint.map(|part| light.times(part));
            }
        }
        let light = incident.light::<N>(true);
        let light = light.times(incident.cosine);
        surface.diffuse::<N>().zip(tint, |color, part| light.times(color.times(part)))
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<Rgb<S::Unit>> {
        let white = |part| Rgb::new(part, part, part);
        if let Some(Finish { glass, .. }) = surface.material.finish::<N>() {
            return Secondary {
                reflected: (glass.ks > S::Unit::ZERO).then(|| surface.color.map(|c| c.times(glass.ks))),
                transmitted: surface.material.glass::<N>().map(|glass| white(glass.kt)),
                bend: Bend::Refracted,
            };
        }
        match surface.material {
            Material::Mirror => Secondary { reflected: Some(surface.color), ..Secondary::NONE },
            Material::Transparent(glass) => Secondary {
                reflected: Some(surface.color.map(|c| c.times(glass.ks))),
                transmitted: Some(white(glass.kt)),
                bend: Bend::Refracted,
            },
            _ => Secondary::NONE,
        }
    }
}

rowless!(Rta);
