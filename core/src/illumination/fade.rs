//! What becomes of light on its way: parts from 0 to 1 by which it is multiplied.

mod airlight;

pub use airlight::{Sight, airlight};

use crate::scalar::{Exponent, Positive, Scalar, Unit};

/// Returns `min(1, (reference / distance)^exponent)`, what of a surface's light arrives in the eye (Warnock 1969, exponent 1;
/// Romney 1970, 2 or 4). Both lengths are above 0.
pub fn fade<S: Scalar>(distance: S, reference: S, exponent: Exponent) -> S::Unit {
    if distance <= reference { S::Unit::ONE } else { reference.fraction(distance.inverse()).power(exponent) }
}

/// Returns the part of a ray's light that haze replaces by its own colour: 0 up to the distance `near`, 1 from `far` on, linear
/// between them.
pub fn haze<S: Scalar>(distance: S, near: S, far: S) -> S::Unit {
    if distance <= near {
        S::Unit::ZERO
    } else if distance >= far {
        S::Unit::ONE
    } else {
        (distance - near).fraction((far - near).inverse())
    }
}

/// Returns `2^-(density length)`, what of a ray's light a material leaves over a length of 0 or more (Bouguer, Beer). The density is
/// -log2 of what it leaves over the length 1: `s log2 e` for an extinction s.
///
/// In fixed point it errs by at most 3e-9 and 2^-28 of the logarithm.
pub fn transmittance<S: Scalar>(density: S::Power, length: S) -> S::Unit {
    density.times(length.positive()).exp2_minus()
}

/// Returns what a thin thing lets through of what is behind it (Kay 1979): `least + (most - least) (1 - (1 - N.V)^n)`, denser at its
/// edges, which are seen at a small cosine N.V.
pub fn edge<U: Unit>(least: U, most: U, exponent: Exponent, cosine: U) -> U {
    least + (most - least).times(U::ONE - (U::ONE - cosine).power(exponent))
}

/// How a medium scatters light (Henyey and Greenstein 1941), by g: forward above 0, backward below, evenly at 0.
#[derive(Clone, Copy, Debug)]
pub struct Phase<U: Unit> {
    /// g, from -0.9 to 0.9.
    pub forward: U,
}

impl<U: Unit> Phase<U> {
    /// Returns `(1 - g^2) / (1 + g^2 - 2 g cos t)^1.5`, from 0.027 to 190, whose mean over all directions is 1; t is the angle
    /// between a ray and the direction to the lamp, by its cosine.
    pub fn scattered(&self, cosine: U) -> U::Positive {
        if self.forward == U::ZERO {
            return U::ONE.positive();
        }
        // Half the bracket, (1 - g)^2 / 2 + g (1 - cos t) for a g of 0 or more, in range.
        let g = self.forward;
        let (size, cosine) = if g < U::ZERO { (-g, -cosine) } else { (g, cosine) };
        let less = U::ONE - size;
        let away = U::ratio(1, 2) - cosine.times(U::ratio(1, 2));
        let bracket = less.positive().times(less.positive());
        let bracket = bracket.plus(size.positive().times(away.positive()).times(U::Positive::new(4, 0)));
        (U::ONE - g.times(g)).positive().over(bracket.times(bracket.root()))
    }

    /// Returns the light that a medium scatters into a ray as a part of that of a distant lamp that lights all of it:
    /// `w p (1 - T) / 4` for the part w of the light that is scattered, not absorbed, and the part T that the medium leaves of
    /// light over the length of the ray.
    pub fn sunbeam(&self, albedo: U, cosine: U, left: U) -> U::Positive {
        let part = (U::ONE - left).positive().times(albedo.positive());
        part.times(self.scattered(cosine)).times(U::Positive::new(1, -2))
    }
}
