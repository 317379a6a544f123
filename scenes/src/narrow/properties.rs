//! What a scene says of a material, in the numbers of a format.

use rta_core::color::Rgb;
use rta_core::illumination::fresnel::Conductor;
use rta_core::illumination::microfacet::Roughness;
use rta_core::illumination::table::{PositiveOf, Properties};
use rta_core::scalar::Exponent;

use super::Narrow;
use super::check::exponent;
use crate::description::{Kind, Material};
use crate::gloss;

/// The slopes and exponents that models are made for.
const SLOPES: (f64, f64) = (0.01, 1.0);
const EXPONENTS: (f64, f64) = (1.0, 1000.0);

fn unit<S: Narrow>(value: f64) -> S::Unit {
    S::unit(value.clamp(0.0, S::LARGEST_COLOR))
}

fn positive<S: Narrow>(value: f64) -> PositiveOf<S> {
    <S as Narrow>::power(value)
}

fn color<S: Narrow>(color: [f64; 3]) -> Rgb<S::Unit> {
    let [r, g, b] = color.map(unit::<S>);
    Rgb::new(r, g, b)
}

/// Returns the reflectance at perpendicular incidence of a material with the index n - i k.
fn f0([n, k]: [f64; 2]) -> f64 {
    // Squares of large numbers would be infinite.
    ((n - 1.0).hypot(k) / (n + 1.0).hypot(k)).powi(2)
}

/// Returns a metal with the index n - i k.
pub fn conductor<S: Narrow>([n, k]: [f64; 2]) -> Conductor<S::Unit> {
    let sum = n * n + k * k + 1.0;
    Conductor {
        difference: S::unit((n * n - k * k) / sum),
        product: S::unit(2.0 * n * k / sum),
        scale: S::unit(sum.sqrt().recip()),
    }
}

impl<S: Narrow> Properties<S> for Material {
    fn ambient(&self) -> Option<S::Unit> {
        self.ambient.map(unit::<S>)
    }
    fn diffuse(&self) -> Option<S::Unit> {
        self.diffuse.map(unit::<S>)
    }
    fn back(&self) -> Option<S::Unit> {
        self.back.map(unit::<S>)
    }
    fn specular(&self) -> Option<S::Unit> {
        self.specular.map(unit::<S>)
    }
    fn transmit(&self) -> Option<S::Unit> {
        self.transmit.map(unit::<S>)
    }
    fn mirror(&self) -> Option<S::Unit> {
        self.mirror.map(unit::<S>)
    }
    fn exponent(&self) -> Option<Exponent> {
        let (least, most) = EXPONENTS;
        let by_gloss = || self.gloss.map(|angle| gloss::blinn(angle).clamp(least, most));
        self.exponent.or_else(by_gloss).map(exponent)
    }
    fn narrowness(&self) -> Option<PositiveOf<S>> {
        self.gloss.map(|angle| positive::<S>(gloss::gauss(angle)))
    }
    fn roundness(&self) -> Option<S::Unit> {
        self.gloss.map(|angle| unit::<S>(gloss::trowbridge(angle)))
    }
    fn slope(&self, index: usize) -> Option<Roughness<S::Unit>> {
        let roughness = |share: f64, slope: f64| Roughness {
            share: unit::<S>(share),
            inverse: positive::<S>(1.0 / slope.clamp(SLOPES.0, SLOPES.1)),
        };
        if !self.slopes.is_empty() {
            return self.slopes.get(index).map(|slope| roughness(slope.share, slope.slope));
        }
        self.gloss.filter(|_| index == 0).map(|angle| roughness(1.0, gloss::beckmann(angle)))
    }
    fn kind(&self) -> Kind {
        self.kind
    }
    fn reflectance(&self) -> Option<Rgb<S::Unit>> {
        let by_nk = || self.nk.map(|registers| registers.map(f0));
        let by_index = || self.index.map(|n| [f0([n, 0.0]); 3]);
        self.metal.or_else(by_nk).or_else(by_index).map(color::<S>)
    }
    fn conductor(&self) -> Option<Rgb<Conductor<S::Unit>>> {
        let [r, g, b] = self.nk?.map(conductor::<S>);
        Some(Rgb::new(r, g, b))
    }
    fn index(&self) -> Option<(S::Unit, bool)> {
        self.index.map(|n| (unit::<S>(n.min(1.0 / n)), n >= 1.0))
    }
    fn absorption(&self) -> Option<Rgb<PositiveOf<S>>> {
        let left = self.absorb?.map(|a| positive::<S>(-a.clamp(2_f64.powi(-31), 1.0).log2()));
        let [r, g, b] = left;
        Some(Rgb::new(r, g, b))
    }
    fn edge(&self) -> Option<(Exponent, S::Unit, S::Unit)> {
        self.edge.map(|edge| (exponent(edge.exponent.into()), unit::<S>(edge.least), unit::<S>(edge.most)))
    }
    fn is_thin(&self) -> bool {
        self.thin
    }
}
