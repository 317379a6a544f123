//! Surfaces of small mirrors: those that face halfway between the directions to the lamp and to the eye reflect the lamp's light.
//!
//! Three factors tell how much of it arrives: how many of the facets face that way ([`Distribution`]), how many of these are
//! neither in the shadow of others nor hidden behind them ([`Attenuation`]), and what a facet reflects
//! ([`fresnel`](super::fresnel)). They are types, so that a program that uses one of each contains no other.

use crate::scalar::vector::{UnitVec3, UnitVector};
use crate::scalar::{Exponent, Positive, Scalar, Unit};

mod attenuation;
mod distribution;
mod visible;

pub use attenuation::{Attenuation, Sancer, TorranceSparrow};
pub use distribution::{Beckmann, Distribution, Gauss, Power, Trowbridge};
pub use visible::{Sight, Visible};

/// A part of the facets of a rough surface, with the root of the mean square of their slopes, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roughness<U: Unit> {
    /// The part, 0 to 1; those of a surface add up to 1.
    pub share: U,
    /// 1/m, for m from 0.01 to 1.
    pub inverse: U::Positive,
}

impl<U: Unit> Roughness<U> {
    /// Returns those before the first of a share of 0.
    pub fn used(all: &[Self]) -> &[Self] {
        let count = all.iter().take_while(|own| own.share > U::ZERO).count();
        all.get(..count).unwrap_or_default()
    }
}

/// The angle between the normal of a surface and that of a facet.
#[derive(Clone, Copy, Debug)]
pub struct Slope<U: Unit> {
    /// Its cosine, N.H.
    pub cosine: U,
    /// The square of its sine. The cosine alone would lose it where the angle is small.
    pub sine_squared: U::Positive,
}

impl<U: Unit> Slope<U> {
    /// Returns the angle between two unit vectors.
    pub fn between<V: UnitVector<Component = U>>(normal: V, facet: V) -> Self {
        let sine = normal.cross(facet);
        let square = |c: U| {
            let size = if c < U::ZERO { -c } else { c }.positive();
            size.times(size)
        };
        let sine_squared = square(sine.x()).plus(square(sine.y())).plus(square(sine.z()));
        Self { cosine: normal.dot(facet), sine_squared }
    }

    /// Returns the square of the tangent, for a cosine above 0.
    pub fn tangent_squared(&self) -> U::Positive {
        let cosine = self.cosine.positive();
        self.sine_squared.over(cosine.times(cosine))
    }
}

/// The facets that reflect light from one direction into another, and all cosines that belong to them.
#[derive(Clone, Copy, Debug)]
pub struct Facet<U: Unit> {
    /// The angle between the surface's normal and theirs.
    pub slope: Slope<U>,
    /// N.L: the cosine between normal and lamp, above 0.
    pub light: U,
    /// N.V: the cosine between normal and eye, above 0.
    pub view: U,
    /// V.H = L.H: the cosine between a facet's normal and the eye, above 0.
    pub incidence: U,
}

/// The least cosine that reflected light is divided by, 2^-10.
const LEAST_COSINE: (i64, i64) = (1, 1 << 10);

impl<U: Unit> Facet<U> {
    /// Returns the facets between the unit directions to the lamp and to the eye; `None` where one of these is not above the
    /// surface, or where they are opposite.
    pub fn between<S: Scalar<Unit = U>>(
        normal: UnitVec3<S>,
        light: UnitVec3<S>,
        view: UnitVec3<S>,
    ) -> Option<Self> {
        let halfway = light.halfway(view)?;
        let facet = Self {
            slope: Slope::between(normal, halfway),
            light: normal.dot(light),
            view: normal.dot(view),
            incidence: view.dot(halfway),
        };
        let is_above =
            [facet.light, facet.view, facet.slope.cosine, facet.incidence].iter().all(|c| *c > U::ZERO);
        is_above.then_some(facet)
    }

    /// Returns `D G F / (N.V)`, the divisor at least 2^-10: the reflectance of Blinn's surface (1977), at most 1024 D. `reflected` is F,
    /// what a facet reflects. By [`TorranceSparrow`], it is at most `2 D (N.H) / (V.H)`, large only where lamp and eye both
    /// graze the surface.
    pub fn reflectance(
        &self,
        distribution: &impl Distribution<U>,
        attenuation: &impl Attenuation<U>,
        reflected: U,
    ) -> U::Positive {
        let least = U::ratio(LEAST_COSINE.0, LEAST_COSINE.1);
        let view = if self.view < least { least } else { self.view };
        let passed = attenuation.passed(self).positive().times(reflected.positive());
        distribution.density(&self.slope).times(passed).over(view.positive())
    }

    /// Returns `D G F / (4 N.V)`: the reflectance of Cook's and Torrance's surface (1982), with the constant for which a surface
    /// never returns more light than it gets; the paper prints four times as much. By [`Beckmann`] it is at most 256 / m^2, or
    /// 377 / m^2 above m = 0.7071; as a radiance that saturates.
    pub fn balanced_reflectance(
        &self,
        distribution: &impl Distribution<U>,
        attenuation: &impl Attenuation<U>,
        reflected: U,
    ) -> U::Positive {
        self.reflectance(distribution, attenuation, reflected).times(U::Positive::new(1, -2))
    }
}

/// Returns the unit normal of the facets that refract light from the direction `light`, beyond the surface, into the direction
/// `view` (Hall and Greenberg 1983): `-(L + k V) / (k - 1)`, normalised, where k is the index of refraction on the side of the
/// eye over that on the lamp's. `q` is the smaller of k and 1/k, `denser` tells whether k is above 1. `None` where no facet
/// does: for `-L.V <= q` and k = 1.
pub fn refracting<V: UnitVector>(light: V, view: V, q: V::Component, denser: bool) -> Option<V> {
    if q >= V::Component::ONE || -light.dot(view) <= q {
        return None;
    }
    let sum = if denser { -view.plus(light, q) } else { light.plus(view, q) };
    sum.normalize().map(|(facet, _)| facet)
}

/// Returns a highlight of facets that reflect the part `reflected`: `F (N.H)^n`, 0 for an N.H that is not above 0.
pub fn highlight<U: Unit>(cosine: U, exponent: Exponent, reflected: U) -> U {
    if cosine > U::ZERO { cosine.power(exponent).times(reflected) } else { U::ZERO }
}

/// Returns the reflectance of a surface of which the share s mirrors by facets of the reflectance R and the rest is diffuse (Cook
/// and Torrance 1982): `s R + (1 - s) C (N.L)`, with the diffuse reflectance C and the cosine N.L of the lamp, above 0.
pub fn mixed<U: Unit>(share: U, mirrored: U::Positive, color: U, cosine: U) -> U::Positive {
    let diffuse = (U::ONE - share).times(color).times(cosine);
    diffuse.positive().plus(mirrored.times(share.positive()))
}
