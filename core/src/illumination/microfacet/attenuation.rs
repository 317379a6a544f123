//! How many facets are neither in shadow nor hidden.

use super::{Facet, Roughness};
use crate::scalar::{Positive, Unit};

/// What the facets of a rough surface leave of one another's light.
pub trait Attenuation<U: Unit> {
    /// Returns G, the part of the facets that are lit and seen, 0 to 1; symmetric in lamp and eye.
    fn passed(&self, facet: &Facet<U>) -> U;
}

/// `G = min(1, 2 (N.H)(N.V) / (V.H), 2 (N.H)(N.L) / (V.H))`: facets are the sides of V-shaped grooves (Torrance and Sparrow 1967).
#[derive(Clone, Copy, Debug, Default)]
pub struct TorranceSparrow;

impl<U: Unit> Attenuation<U> for TorranceSparrow {
    fn passed(&self, facet: &Facet<U>) -> U {
        let flatter = if facet.light < facet.view { facet.light } else { facet.view };
        let product = facet.slope.cosine.positive().times(flatter.positive());
        let passed = product.times(U::Positive::new(2, 0)).over(facet.incidence.positive()).unit();
        if passed > U::ONE { U::ONE } else { passed }
    }
}

/// `G = 1 / (1 + U(N.L) + U(N.V))` with `U(c) = exp(-A^2) / (2 A sqrt pi) - erfc(A) / 2`, `A = c / (m sqrt(1 - c^2))`: facets of a
/// rough surface whose slopes are Beckmann's (Sancer 1969). U of several slopes is their mean by their shares.
///
/// In fixed point A U errs by 1e-6, so that G does by no more than 1e-6 / A, and by less than 4e-6.
#[derive(Clone, Copy, Debug)]
pub struct Sancer<'a, U: Unit>(pub &'a [Roughness<U>]);

impl<U: Unit> Sancer<'_, U> {
    /// Returns U of a direction by its cosine with the normal, above 0: what is hidden from there, as a part of what is seen.
    pub fn hidden(&self, cosine: U) -> U::Positive {
        let none = U::ZERO.positive();
        let sine = U::radical(U::ONE, U::ZERO, cosine).unwrap_or(U::ZERO);
        if sine <= U::ZERO {
            return none;
        }
        let cotangent = cosine.positive().over(sine.positive());
        self.0.iter().fold(none, |sum, part| {
            let a = cotangent.times(part.inverse);
            sum.plus(a.shadow().positive().over(a).times(part.share.positive()))
        })
    }
}

impl<U: Unit> Attenuation<U> for Sancer<'_, U> {
    fn passed(&self, facet: &Facet<U>) -> U {
        let one = U::ONE.positive();
        one.over(one.plus(self.hidden(facet.light)).plus(self.hidden(facet.view))).unit()
    }
}
