//! The facets of a rough surface that a ray sees: which of them it meets, by chance, and what their neighbours hide.

use super::{Beckmann, Distribution, Roughness, Slope, Trowbridge};
use crate::sampling::mapping::{Facets, Frame, turn};
use crate::scalar::vector::{UnitVec3, UnitVector};
use crate::scalar::{Positive, Scalar, Unit};

/// The facets of a rough surface.
#[derive(Clone, Copy, Debug)]
pub enum Visible<'a, U: Unit> {
    /// As T. Trowbridge and K. Reitz spread them, hidden as B. Smith has it.
    Round(Facets<U>),
    /// As P. Beckmann spreads them, of these slopes, at least one, whose shares add up to 1; they are the sides of V-shaped grooves
    /// (Torrance and Sparrow 1967), as in Cook's and Torrance's model.
    Grooved(&'a [Roughness<U>]),
}

/// How a facet is seen: the cosines of three angles, each above 0.
#[derive(Clone, Copy, Debug)]
pub struct Sight<U> {
    /// Between the surface's normal and the facet's, N.H.
    pub slope: U,
    /// Between the surface's normal and the direction to the eye, N.V.
    pub view: U,
    /// Between the facet's normal and the direction to the eye, V.H.
    pub incidence: U,
}

impl<U: Unit> Sight<U> {
    /// Returns half of V.H, times the part of the facets that is not hidden in grooves from a direction at the cosine `cosine` with the
    /// surface's normal: `G = min(1, 2 (N.H)(N.V) / (V.H))`.
    fn in_grooves(&self, cosine: U) -> U {
        let (half, most) = (self.slope.times(cosine), self.incidence.times(U::of_word(1 << 31)));
        if half < most { half } else { most }
    }
}

impl<U: Unit> Visible<'_, U> {
    /// Returns the unit normal of a facet that is seen from `view`, the unit vector towards the eye, on a surface with the unit normal
    /// `normal`, as often as its size and what is hidden of it have it. `words` are two numbers of 32 bits behind the point.
    pub fn seen<S: Scalar<Unit = U>>(
        self,
        normal: UnitVec3<S>,
        view: UnitVec3<S>,
        words: [u32; 2],
    ) -> UnitVec3<S> {
        match self {
            Self::Round(facets) => facets.seen::<S>(normal, view, words),
            Self::Grooved(slopes) => grooved::<S>(slopes, normal, view, words),
        }
    }

    /// Returns the part, 0 to 1, of the light of the facets that are seen so that is not hidden on its way out at the cosine `out` with
    /// the surface's normal.
    pub fn passed(self, sight: &Sight<U>, out: U) -> U {
        match self {
            Self::Round(facets) => facets.passed(sight.view, out),
            Self::Grooved(_) => {
                let (seen, left) = (sight.in_grooves(sight.view), sight.in_grooves(out));
                if left >= seen { U::ONE } else { left.quotient(seen) }
            }
        }
    }

    /// Returns how often the facets that a ray sees reflect it into a direction: the density over the solid angle, times pi. `slope` is the
    /// angle of the facets that do.
    pub fn density(self, slope: Slope<U>, sight: &Sight<U>) -> U::Positive {
        // D G / (4 N.V), with the D of the models, whose cosine-weighted mean over the hemisphere is 1 where it is divided by pi.
        match self {
            Self::Round(Facets { roughness: alpha }) => {
                let view = sight.view;
                let hidden = U::radical(view, alpha, alpha.times(view)).unwrap_or(view);
                let facing = Trowbridge { roundness: alpha }.density(&slope);
                let alpha = alpha.positive();
                let divisor = view.positive().plus(hidden.positive()).times(U::Positive::new(2, 0));
                facing.over(alpha.times(alpha).times(divisor))
            }
            Self::Grooved(slopes) => {
                let seen = sight.in_grooves(sight.view).positive();
                let divisor = sight.incidence.positive().times(sight.view.positive());
                Beckmann(slopes).density(&slope).times(seen).over(divisor).times(U::Positive::new(1, -1))
            }
        }
    }
}

/// Returns `-log2(x / 2^32)` in units of 2^-26, for an x from 1 to 2^32: by integers alone, the same in every format.
fn minus_log2(x: u64) -> u32 {
    let places = x.leading_zeros().saturating_sub(31);
    // In [1, 2), in units of 2^-31; its square says the next bit of its logarithm.
    let (mut mantissa, mut part) = (x << places >> 1, 0);
    for _ in 0..26 {
        mantissa = (mantissa * mantissa) >> 31;
        part <<= 1;
        if mantissa >> 32 > 0 {
            mantissa >>= 1;
            part += 1;
        }
    }
    (places << 26) - part
}

/// Returns the normal of a facet of grooves that is seen: E. Heitz and E. d'Eon, "Importance Sampling Microfacet-Based BSDFs using the
/// Distribution of Visible Normals", EGSR 2014, section 5. A facet of Beckmann's, or that of the other side of its groove.
fn grooved<S: Scalar>(
    slopes: &[Roughness<S::Unit>],
    normal: UnitVec3<S>,
    view: UnitVec3<S>,
    [u, v]: [u32; 2],
) -> UnitVec3<S> {
    let (zero, one, half) = (S::Unit::ZERO, S::Unit::ONE, S::Unit::of_word(1 << 31));
    // The upper bits of the second number turn the groove by up to half a turn; the lower ones choose its slope, and which side is seen.
    let (turned, mut number) = (v >> 16 << 15, S::Unit::of_word(v << 16));
    let mut inverse = one.positive();
    for part in slopes {
        inverse = part.inverse;
        if number < part.share {
            number = number.quotient(part.share);
            break;
        }
        number = number - part.share;
    }
    // tan^2 = -m^2 ln(1 - u), and ln 2 in units of 2^-64.
    let logarithm = minus_log2((1 << 32) - u64::from(u)).into();
    let logarithm = S::Power::new(logarithm, -26).times(S::Power::new(0xb172_17f7_d1cf_79ac, -64));
    let tangent = logarithm.over(inverse.times(inverse));
    let whole = one.positive().plus(tangent);
    let (sine, z) = (tangent.over(whole).root().unit(), one.positive().over(whole).root().unit());
    let [cosine, across] = turn::<S::Unit>(turned);
    let (x, y) = (sine.times(cosine), sine.times(across));
    let frame = Frame::about(normal);
    let [a, b, c] = frame.components(view);
    // Halves, so that their sum has room: the facet's V.H, and that of the other side.
    let (aside, up) = ((x.times(a) + y.times(b)).times(half), z.times(c).times(half));
    let above = |cosine: S::Unit| if cosine > zero { cosine } else { zero };
    let (first, second) = (above(up + aside), above(up - aside));
    let is_first = number.times(first + second) < first;
    let (x, y) = if is_first { (x, y) } else { (-x, -y) };
    frame.vector([x, y, z]).normalize().map_or(normal, |(facet, _)| facet)
}

#[cfg(test)]
#[cfg(feature = "f64")]
mod tests {
    use core::f64::consts::PI;

    use super::super::{Facet, TorranceSparrow};
    use super::*;
    use crate::Q16;
    use crate::sampling::pairs::pair;
    use crate::scalar::vector::Vector;

    const N: UnitVec3<f64> = UnitVec3::<f64>::Z;

    fn slopes<S: Scalar>(parts: &[(i64, i64)]) -> heapless::Vec<Roughness<S::Unit>, 4> {
        let one = |&(share, slope): &(i64, i64)| {
            let inverse = S::Power::new(10, 0).over(S::Power::new(slope.cast_unsigned(), 0));
            Roughness { share: S::Unit::ratio(share, 4), inverse }
        };
        parts.iter().map(one).collect()
    }

    fn direction(theta: f64, phi: f64) -> UnitVec3<f64> {
        Vector::new(libm::sin(theta) * libm::cos(phi), libm::sin(theta) * libm::sin(phi), libm::cos(theta))
    }

    /// Returns the integral over the hemisphere.
    fn integral(of: impl Fn(UnitVec3<f64>) -> f64) -> f64 {
        const STEPS: u32 = 500;
        let (high, wide) = (PI / 2.0 / f64::from(STEPS), 2.0 * PI / f64::from(STEPS));
        let mut sum = 0.0;
        for i in 0..STEPS {
            let theta = (f64::from(i) + 0.5) * high;
            for j in 0..STEPS {
                sum += of(direction(theta, (f64::from(j) + 0.5) * wide)) * libm::sin(theta);
            }
        }
        sum * high * wide
    }

    /// Returns mean and standard deviation, over 32 seeds, of the means of 256 facets each.
    fn sampled(of: impl Fn([u32; 2]) -> f64) -> (f64, f64) {
        let mut moments = [0.0; 2];
        for seed in 0..32 {
            let mean = (0..256).map(|i| of(pair(3, 5, 7, seed, i))).sum::<f64>() / 256.0;
            moments = [moments[0] + mean, moments[1] + mean * mean];
        }
        let [mean, square] = moments.map(|moment| moment / 32.0);
        (mean, libm::sqrt((square - mean * mean).max(0.0)))
    }

    const CASES: [(&[(i64, i64)], f64); 6] = [
        (&[(4, 2)], 0.0),
        (&[(4, 3)], 1.0),
        (&[(4, 5)], 1.4),
        (&[(4, 10)], 1.2),
        (&[(1, 2), (3, 6)], 0.9),
        (&[(2, 5), (2, 3)], 1.3),
    ];

    #[test]
    fn grooves_reflect_what_the_models_highlights_do() {
        for (parts, angle) in CASES {
            let (own, view) = (slopes::<f64>(parts), direction(angle, 0.4));
            let facets = Visible::Grooved(&own);
            let exact = integral(|light| {
                let facet = Facet::between::<f64>(N, light, view);
                facet.map_or(0.0, |facet| facet.balanced_reflectance(&Beckmann(&own), &TorranceSparrow, 1.0))
            }) / PI;
            let (mean, spread) = sampled(|words| {
                let facet = facets.seen::<f64>(N, view, words);
                let out = (-view).reflect(facet).dot(N);
                let sight = Sight { slope: N.dot(facet), view: N.dot(view), incidence: facet.dot(view) };
                if out > 0.0 { facets.passed(&sight, out) } else { 0.0 }
            });
            let error = (mean - exact).abs();
            assert!(
                error < 5.0 * spread / libm::sqrt(32.0) + 2e-4,
                "{parts:?} {angle}: {mean}, {exact}, {spread}"
            );
            assert!(spread < 0.02, "{parts:?} {angle}: {spread}");
        }
    }

    #[test]
    fn facets_are_seen_as_often_as_their_density_has_it() {
        for (parts, angle) in CASES {
            let (own, view) = (slopes::<f64>(parts), direction(angle, 0.4));
            let facets = Visible::Grooved(&own);
            // The density of reflected directions is that of facets over 4 V.H.
            let density = |facet: UnitVec3<f64>| {
                let sight = Sight { slope: N.dot(facet), view: N.dot(view), incidence: facet.dot(view) };
                if sight.incidence <= 0.0 {
                    return 0.0;
                }
                facets.density(Slope::between(N, facet), &sight) * 4.0 * sight.incidence / PI
            };
            let whole = integral(density);
            assert!((whole - 1.0).abs() < 2e-3, "{parts:?} {angle}: {whole}");
            let toward = |facet: UnitVec3<f64>| (facet.dot(view), N.dot(facet) * N.dot(facet));
            for (name, of) in [("V.H", false), ("N.H squared", true)] {
                let value = |facet| if of { toward(facet).1 } else { toward(facet).0 };
                let exact = integral(|facet| density(facet) * value(facet)) / whole;
                let (mean, spread) = sampled(|words| value(facets.seen::<f64>(N, view, words)));
                let error = (mean - exact).abs();
                assert!(
                    error < 5.0 * spread / libm::sqrt(32.0) + 1e-3,
                    "{name}, {parts:?} {angle}: {mean}, {exact}"
                );
            }
        }
    }

    #[test]
    fn every_format_sees_the_same_facets() {
        type Fixed = <Q16 as Scalar>::Unit;
        let (own, fixed) = (slopes::<f64>(&[(1, 2), (3, 6)]), slopes::<Q16>(&[(1, 2), (3, 6)]));
        let view = direction(1.1, 0.4);
        let narrowed = UnitVec3::<Q16>::new(
            Fixed::from_num(view.x()),
            Fixed::from_num(view.y()),
            Fixed::from_num(view.z()),
        );
        let mut apart = 0;
        for i in 0..4096 {
            let words = pair(1, 2, 3, 4, i);
            let one = Visible::Grooved(&own).seen::<f64>(N, view, words);
            let other = Visible::Grooved(&fixed).seen::<Q16>(UnitVec3::<Q16>::Z, narrowed, words);
            let off = [other.x(), other.y(), other.z()].map(|c| c.to_num::<f64>());
            let off = (off[0] - one.x()).abs().max((off[1] - one.y()).abs()).max((off[2] - one.z()).abs());
            // Where a number falls on the other side of a limit, the other side of the groove is seen, or another slope.
            apart += u32::from(off > 1e-7);
        }
        assert!(apart <= 2, "{apart} of 4096");
        for x in [1, 2, 3, 0x1234_5678, 0x8000_0000, 0xffff_ffff, 1 << 32] {
            #[allow(clippy::cast_precision_loss, reason = "it has 33 bits")]
            let exact = 32.0 - libm::log2(x as f64);
            assert!((f64::from(minus_log2(x)) / f64::from(1 << 26) - exact).abs() < 1e-7, "{x}");
        }
    }
}
