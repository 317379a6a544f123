//! J. H. Lambert, "Photometria" (1760): a surface that looks equally bright from everywhere.

use super::{Illumination, Secondary, rowless};
use crate::color::Rgb;
use crate::light::Incident;
use crate::needs::Needs;
use crate::scalar::{Light, Scalar, Unit};
use crate::surface::Surface;

/// `I = C Ia + C sum (N.L) E`
///
/// Every surface is diffuse, whatever its material, with the diffuse coefficient of its finish where it has one. Lamps are
/// attenuated with the square of the distance: `E` is the irradiance. No ray is reflected or transmitted.
#[derive(Clone, Copy, Debug, Default)]
pub struct Lambert;

impl<S: Scalar> Illumination<S> for Lambert {
    /// The model has no secondary rays, so any weight type would do.
    type Weight = S::Unit;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        ambient.zip(surface.diffuse::<N>(), Light::times)
    }

    fn is_lit<N: Needs>(&self, _surface: &Surface<S>) -> bool {
        true
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        let light = incident.light::<N>(true);
        let light = light.times(incident.cosine);
        surface.diffuse::<N>().zip(incident.lamp.tint, |color, part| light.times(color.times(part)))
    }

    fn secondary<N: Needs>(&self, _surface: &Surface<S>) -> Secondary<S::Unit> {
        Secondary::NONE
    }
}

rowless!(Lambert);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::light::Lamp;
    use crate::material::Material;
    use crate::needs::Everything;
    use crate::scalar::Q16;
    use crate::scalar::vector::{UnitVec3, UnitVector, Xyz};

    #[test]
    fn light_goes_with_the_cosine() {
        let unit = |n| <Q16 as Scalar>::Unit::ratio(n, 1_000_000_000);
        let one = unit(1_000_000_000);
        let white = Rgb::new(one, one, one);
        let lamp = Lamp::<Q16>::white(Xyz::new(Q16::ZERO, Q16::ZERO, Q16::ONE), Q16::ZERO, 1);
        // The cosine of 0, 60 and 89 degrees.
        for (cosine, want) in [(1_000_000_000, 65_536), (500_000_000, 32_768), (17_452_406, 1144)] {
            let surface = Surface {
                point: Xyz::new(Q16::ZERO, Q16::ZERO, Q16::ZERO),
                normal: UnitVec3::<Q16>::Z,
                face: None,
                incoming: -UnitVec3::<Q16>::Z,
                distance: Q16::ONE,
                inside: false,
                extent: Q16::ONE,
                color: white,
                material: &Material::Opaque,
                number: 0,
            };
            let mut incident = Incident::new(&lamp, surface.point, surface.normal).expect("it is above");
            incident.cosine = unit(cosine);
            let got = Lambert.direct::<Everything>(&surface, &incident).g.0.to_bits();
            assert!((got - want).abs() <= 1, "a cosine of {cosine} billionths: {got}, want {want}");
        }
    }
}
