//! J. H. Lambert, "Photometria" (1760): a surface that looks equally bright from everywhere.

use super::table::{Properties, Row, Tabled, Value};
use super::{Illumination, Secondary};
use crate::color::Rgb;
use crate::light::Incident;
use crate::needs::Needs;
use crate::scalar::{Light, Scalar, Unit};
use crate::surface::Surface;

/// `I = ka C Ia + kd C sum (N.L) E + kdt C sum' (-N.L) E`
///
/// Every surface is diffuse, whatever its material, with the coefficients of its finish where it has one, else ka = kd = 1. A
/// surface that light shines through diffusely (kdt, the thesis's section 2.3.4) is lit by the lamps behind it too (sum'). Lamps are
/// attenuated with the square of the distance: `E` is the irradiance. No ray is reflected or transmitted.
#[derive(Clone, Copy, Debug)]
pub struct Lambert<'a, S: Scalar> {
    /// The materials.
    pub rows: &'a [LambertRow<S>],
}

impl<S: Scalar> Default for Lambert<'static, S> {
    fn default() -> Self {
        Self { rows: &[] }
    }
}

/// What Lambert's model must know of a material.
#[derive(Clone, Copy, Debug)]
pub struct LambertRow<S: Scalar> {
    /// kdt, the coefficient of light that shines through from behind, 0 to 1.
    pub back: S::Unit,
}

impl<S: Scalar> Row<S> for LambertRow<S> {
    const NAME: &'static str = "LambertRow";
    fn fields(&self, mut see: impl FnMut(&'static str, Value<S>)) {
        see("back", Value::Unit(self.back));
    }
}

impl<S: Scalar> Tabled<S> for Lambert<'_, S> {
    type Row = LambertRow<S>;
    type Over<'r> = Lambert<'r, S>;

    fn row(&self, material: &impl Properties<S>) -> LambertRow<S> {
        LambertRow { back: material.back().unwrap_or(S::Unit::ZERO) }
    }

    fn over<'r>(&self, rows: &'r [LambertRow<S>]) -> Lambert<'r, S> {
        Lambert { rows }
    }
}

impl<S: Scalar> Illumination<S> for Lambert<'_, S> {
    /// The model has no secondary rays, so any weight type would do.
    type Weight = S::Unit;
    const REFRACTS: bool = false;
    const BOTH_SIDES: bool = true;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        let ka = surface.material.finish::<N>().map_or(S::Unit::ONE, |finish| finish.ka);
        ambient.zip(surface.color, |light, color| light.times(color.times(ka)))
    }

    fn is_lit<N: Needs>(&self, _surface: &Surface<S>) -> bool {
        true
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        let zero = S::Unit::ZERO;
        let is_behind = surface.is_behind::<N>(incident);
        let color = if is_behind {
            let back = self.rows.get(usize::from(surface.number)).map_or(zero, |row| row.back);
            if back <= zero || incident.cosine >= zero {
                return Rgb::BLACK;
            }
            surface.color.map(|color| color.times(back))
        } else {
            surface.diffuse::<N>()
        };
        let light = incident.light::<N>(true);
        let light = light.times(if is_behind { -incident.cosine } else { incident.cosine });
        color.zip(incident.lamp.tint, |color, part| light.times(color.times(part)))
    }

    fn diffuse<N: Needs>(&self, surface: &Surface<S>) -> Rgb<S::Unit> {
        surface.diffuse::<N>()
    }

    fn secondary<N: Needs>(&self, _surface: &Surface<S>) -> Secondary<S::Unit> {
        Secondary::NONE
    }
}

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
                surroundings: false,
                mesh: None,
            };
            let mut incident = Incident::new(&lamp, surface.point, surface.normal).expect("it is above");
            incident.cosine = unit(cosine);
            let got = Lambert::default().direct::<Everything>(&surface, &incident).g.0.to_bits();
            assert!((got - want).abs() <= 1, "a cosine of {cosine} billionths: {got}, want {want}");
        }
    }
}
