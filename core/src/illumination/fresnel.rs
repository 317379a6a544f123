//! Fresnel's equations: what the border of two materials reflects of unpolarised light.
//!
//! Cosines are those of the angle between the ray and the normal of the border, 0 to 1; reflectances are 0 to 1.

use crate::scalar::{Positive, Unit};

/// Returns `((a - b) / (a + b))^2` for a and b of 0 or more; 1 where both are 0.
fn contrast<U: Unit>(a: U, b: U) -> U {
    let sum = a.positive().plus(b.positive());
    if sum == U::ZERO.positive() {
        return U::ONE;
    }
    let part = if a < b { b - a } else { a - b }.positive().over(sum);
    part.times(part).unit()
}

/// Returns the mean of two reflectances.
fn mean<U: Unit>(a: U, b: U) -> U {
    a.times(U::ratio(1, 2)) + b.times(U::ratio(1, 2))
}

/// Returns the reflectance of a border without absorption. `q` is the smaller of the two indices of refraction over the larger,
/// `denser` tells whether the larger is beyond the border, as seen from the ray. 1 for total internal reflection, and where both `q`
/// and the cosine are below 2^-15.
///
/// With the cosine c and y, that of the refracted ray, all on the way is a share, 0 to 1: the divisors are `q c + y`, which is at least
/// the larger of c and `sqrt(1 - q^2)`, and `c + q y`, which is not formed where c and q are little more than rounding.
///
/// In fixed point it errs by at most 1e-8 where the reflected ray is not within a degree of grazing.
pub fn dielectric<U: Unit>(q: U, denser: bool, cosine: U) -> U {
    if denser {
        let least = U::ratio(1, 1 << 15);
        if q < least && cosine < least {
            return U::ONE;
        }
        let flat = q.times(cosine);
        let refracted = U::radical(U::ONE, flat, q).unwrap_or(U::ZERO);
        return mean(contrast(flat, refracted), contrast(cosine, q.times(refracted)));
    }
    match U::radical(q, cosine, U::ONE) {
        None => U::ONE,
        Some(refracted) => mean(contrast(cosine, refracted), contrast(q.times(q).times(cosine), refracted)),
    }
}

/// A metal by its complex index of refraction n - i k, in terms that stay in range: `M = n^2 + k^2 + 1`.
#[derive(Clone, Copy, Debug)]
pub struct Conductor<U: Unit> {
    /// `(n^2 - k^2) / M`.
    pub difference: U,
    /// `2 n k / M`.
    pub product: U,
    /// `1 / sqrt M`.
    pub scale: U,
}

impl<U: Unit> Conductor<U> {
    /// Returns the reflectance. In fixed point it errs by at most 1e-7.
    pub fn reflectance(&self, cosine: U) -> U {
        let two = U::Positive::new(2, 0);
        let sine_squared = U::ONE - cosine.times(cosine);
        // t0, w and a^2 of the usual form, over M. Where t0 is negative, w + t0 is taken as (2 n k)^2 / (w - t0).
        let t = self.difference - sine_squared.times(self.scale).times(self.scale);
        let w = U::radical(t, self.product, U::ZERO).unwrap_or(U::ZERO);
        let product = self.product.positive();
        let square = if t < U::ZERO {
            product.times(product).over(w.positive().plus((-t).positive()).times(two))
        } else {
            w.positive().plus(t.positive()).over(two)
        };
        let flat = cosine.times(self.scale);
        let cross = square.root().times(flat.positive()).times(two); // 2 a c / M
        let across = split(w + flat.times(flat), cross.unit());
        let edge = sine_squared.times(self.scale);
        let along = split(cosine.times(cosine).times(w) + edge.times(edge), cross.unit().times(sine_squared));
        mean(across, across.times(along))
    }
}

/// Returns `(sum - cross) / (sum + cross)`, for 0 <= cross <= sum; 1 where both are 0.
fn split<U: Unit>(sum: U, cross: U) -> U {
    let whole = sum.positive().plus(cross.positive());
    if whole == U::ZERO.positive() { U::ONE } else { (sum - cross).positive().over(whole).unit() }
}

/// Returns F0, the reflectance at perpendicular incidence, of a material with the index of refraction n - i k: 1 - 4 n / ((n + 1)^2
/// + k^2).
pub fn f0<U: Unit>(n: U::Positive, k: U::Positive) -> U {
    let more = n.plus(U::Positive::new(1, 0));
    U::ONE - n.times(U::Positive::new(4, 0)).over(more.times(more).plus(k.times(k))).unit()
}

/// Returns the index of refraction of a material without absorption that reflects `f0`, below 1, at perpendicular incidence:
/// `(1 + sqrt f0) / (1 - sqrt f0)`.
pub fn index<U: Unit>(f0: U) -> U::Positive {
    let root = f0.sqrt();
    U::ONE.positive().plus(root.positive()).over((U::ONE - root).positive())
}

/// Returns the reciprocal of [`index`], also for an `f0` of 1: 0 to 1.
pub fn inverse_index<U: Unit>(f0: U) -> U {
    let root = f0.sqrt();
    (U::ONE - root).positive().over(U::ONE.positive().plus(root.positive())).unit()
}

/// Cook's approximation of a coloured metal: all registers change with the angle as their mean does, towards white.
#[derive(Clone, Copy, Debug)]
pub struct Shift<U: Unit> {
    /// The reflectance at perpendicular incidence of a grey surface, the mean of the three registers.
    pub mean: U,
    /// The reciprocal of the index of refraction that belongs to it, [`inverse_index`].
    pub q: U,
}

impl<U: Unit> Shift<U> {
    /// Returns the approximation for a surface whose registers have the mean `mean` at perpendicular incidence.
    pub fn new(mean: U) -> Self {
        Self { mean, q: inverse_index(mean) }
    }

    /// Returns the part of the way to white that the surface has gone, 0 to 1: 0 up to the angle where the mean's reflectance
    /// exceeds that at perpendicular incidence.
    pub fn white(&self, cosine: U) -> U {
        let more = dielectric(self.q, true, cosine) - self.mean;
        let left = U::ONE - self.mean;
        if more <= U::ZERO || left <= U::ZERO {
            U::ZERO
        } else {
            more.positive().over(left.positive()).unit()
        }
    }

    /// Returns the reflectance of a register that is `f0` at perpendicular incidence.
    pub fn reflectance(&self, f0: U, cosine: U) -> U {
        f0 + (U::ONE - f0).times(self.white(cosine))
    }
}
