//! How many facets face one way.

use super::{Roughness, Slope};
use crate::scalar::{Exponent, Positive, Unit};

/// A distribution of facets.
pub trait Distribution<U: Unit> {
    /// Returns D, the relative number of facets that are tilted by the angle, 0 or more; 0 from 90 degrees on.
    fn density(&self, slope: &Slope<U>) -> U::Positive;
}

/// No facets.
fn none<U: Unit>() -> U::Positive {
    U::ZERO.positive()
}

/// `D = cos^n`, 0 to 1 (Blinn 1977, after Phong).
#[derive(Clone, Copy, Debug)]
pub struct Power(pub Exponent);

impl<U: Unit> Distribution<U> for Power {
    fn density(&self, slope: &Slope<U>) -> U::Positive {
        if slope.cosine <= U::ZERO {
            return none::<U>();
        }
        // Two unit vectors may be a little closer to each other than each is to itself.
        let cosine = if slope.cosine > U::ONE { U::ONE } else { slope.cosine };
        cosine.power(self.0).positive()
    }
}

/// `D = exp(-(c a)^2)`, a in radians, 0 to 1 (Blinn 1977, after Torrance and Sparrow).
#[derive(Clone, Copy, Debug)]
pub struct Gauss<U: Unit> {
    /// c, above 0.
    pub narrowness: U::Positive,
}

impl<U: Unit> Distribution<U> for Gauss<U> {
    fn density(&self, slope: &Slope<U>) -> U::Positive {
        if slope.cosine <= U::ZERO {
            return none::<U>();
        }
        // sin^2(a/2) = sin^2 a / (2 (1 + cos a)), without cancellation.
        let half = U::ratio(1, 2);
        let divisor = (half + slope.cosine.times(half)).positive().times(U::Positive::new(4, 0));
        let half_angle = slope.sine_squared.over(divisor).unit().arc_squared().positive();
        let c = self.narrowness;
        half_angle.times(c).times(c).times(U::Positive::new(4, 0)).exp_minus().positive()
    }
}

/// `D = (c^2 / (cos^2 (c^2 - 1) + 1))^2`, c^4 to 1 (Blinn 1977, after Trowbridge and Reitz).
#[derive(Clone, Copy, Debug)]
pub struct Trowbridge<U: Unit> {
    /// c, above 0, at most 1.
    pub roundness: U,
}

impl<U: Unit> Distribution<U> for Trowbridge<U> {
    fn density(&self, slope: &Slope<U>) -> U::Positive {
        if slope.cosine <= U::ZERO {
            return none::<U>();
        }
        // cos^2 (c^2 - 1) + 1 is c^2 cos^2 + sin^2, a sum without cancellation.
        let (c, cosine) = (self.roundness.positive(), slope.cosine.positive());
        let square = c.times(c);
        let part = square.over(square.times(cosine).times(cosine).plus(slope.sine_squared));
        part.times(part)
    }
}

/// `D = sum w exp(-tan^2 / m^2) / (m^2 cos^4)` (Beckmann 1963; Cook and Torrance 1982, who add up several slopes): 0 to 1/m^2, or above
/// m = 0.7071 to `4 m^2 exp(1/m^2 - 2)`, so that `m^2 D` is at most 1.4716.
///
/// In fixed point `m^2 D` errs by at most 3e-9 / cos^4 and, for its angle, 2^-29 of D by m^-2 sin cos^-3.
#[derive(Clone, Copy, Debug)]
pub struct Beckmann<'a, U: Unit>(pub &'a [Roughness<U>]);

impl<U: Unit> Distribution<U> for Beckmann<'_, U> {
    fn density(&self, slope: &Slope<U>) -> U::Positive {
        if slope.cosine <= U::ZERO {
            return none::<U>();
        }
        let square = slope.cosine.positive().times(slope.cosine.positive());
        let tangent = slope.tangent_squared();
        self.0.iter().fold(none::<U>(), |sum, part| {
            let steep = part.inverse.times(part.inverse);
            let density = tangent.times(steep).exp_minus().positive();
            if density == none::<U>() {
                return sum; // the cosine's fourth power may be too small to divide by
            }
            sum.plus(density.times(steep).times(part.share.positive()).over(square.times(square)))
        })
    }
}
