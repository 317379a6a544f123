//! A picture of all directions without arc functions: the sphere as an octahedron, folded open into a square.

use super::image::{Image, bilinear, word};
use crate::color::Rgb;
use crate::scalar::vector::{UnitVec3, Vector};
use crate::scalar::{Light, Magnitude, Scalar, Unit};

/// Returns the place of a direction in the square, both coordinates from 0 to 1. The zenith is in its middle, the nadir in its corners.
pub fn fold<S: Scalar>(direction: UnitVec3<S>) -> [S::Unit; 2] {
    let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
    let size = |part: S::Unit| if part < zero { -part } else { part };
    let half = |part: S::Unit| part.times(S::Unit::ratio(1, 2));
    let (x, y, z) = (half(direction.x()), half(direction.y()), half(direction.z()));
    // Half the sum, at most .87.
    let sum = size(x) + size(y) + size(z);
    let (u, v) = (x.quotient(sum), y.quotient(sum));
    let turned = |size: S::Unit, sign: S::Unit| if sign < zero { size - one } else { one - size };
    let (u, v) = if z < zero { (turned(size(v), u), turned(size(u), v)) } else { (u, v) };
    [u, v].map(|part| half(part) + half(one))
}

impl Image {
    /// Returns the light that a picture of all directions has in one of them. Its pixels are the nodes of a grid that reaches from edge to edge of
    /// the square, so that no pixel beyond an edge is asked for.
    pub(crate) fn sky<S: Scalar>(&self, pool: &[u32], direction: UnitVec3<S>) -> Rgb<S::Light> {
        let last = i32::from(self.width) - 1;
        let one = S::at_most(Magnitude::new(1, 0));
        // 2^24 is 1.
        let place = fold::<S>(direction).map(|part| one.scale(part).lattice(1 << 24) * last);
        let at = |[column, row]: [i32; 2]| {
            let [column, row] = [column, row].map(|part| part.clamp(0, last).cast_unsigned());
            let at = self.first.saturating_add(row * u32::from(self.width) + column);
            word(pool, at)
        };
        let [r, g, b] = bilinear(place, at).map(|level| S::Light::WHITE.times(S::Unit::of_level(level)));
        Rgb::new(r, g, b)
    }
}
