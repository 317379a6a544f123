//! Bumps: a pattern as a height that tilts the normals (J. Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978).

use super::Texture;
use crate::needs::Needs;
use crate::scalar::vector::{LengthVector, UnitVec3, Vec3, Vector};
use crate::scalar::{Magnitude, Scalar, Unit};

/// A slope of 1 as a length of a gradient, which leaves room for steep slopes in every format, and 18 bits for that of 1 in `Q16`.
pub const STEEP: u64 = 4;

/// A pattern that tilts normals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bump<S: Scalar> {
    /// The pattern, whose second colour is the top.
    pub texture: Texture<S>,
    /// The slope, as a length of which [`STEEP`] is 1, where the pattern goes from the bottom to the top within 1/256 of its unit: 256 times
    /// the height of the top, times the texture's frequency.
    pub height: S,
}

impl<S: Scalar> Bump<S> {
    /// Returns the gradient of a solid pattern at a place in its coordinates, by differences of 1/256.
    pub(crate) fn gradient<N: Needs>(&self, place: [i32; 3]) -> Vec3<S> {
        let here = i32::from(self.texture.mix::<N>(place));
        let [x, y, z] = [0, 1, 2].map(|axis| {
            let mut beside = place;
            if let Some(part) = beside.get_mut(axis) {
                *part = part.wrapping_add(256);
            }
            self.slope(i32::from(self.texture.mix::<N>(beside)) - here)
        });
        Vec3::<S>::new(x, y, z)
    }

    /// Returns the gradient of an image, from its differences along two directions.
    pub(crate) fn along(&self, [right, below]: [UnitVec3<S>; 2], [across, down]: [i32; 2]) -> Vec3<S> {
        let zero = Vec3::<S>::new(S::ZERO, S::ZERO, S::ZERO);
        zero.along(right, self.slope(across)).along(below, self.slope(down))
    }

    fn slope(&self, difference: i32) -> S {
        self.height.scale(S::Unit::of_level(difference))
    }
}

/// Returns the unit normal `N - (G - (N . G) N)` of a surface with the unit normal `normal`, whose height has the `gradient` G: lengths of which
/// [`STEEP`] is a slope of 1.
pub fn tilt<S: Scalar>(normal: UnitVec3<S>, gradient: Vec3<S>) -> UnitVec3<S> {
    let steep = S::at_most(Magnitude::new(STEEP, 0));
    let tangent = gradient.reject(normal, gradient.dot(normal));
    (-tangent).along(normal, steep).normalize().map_or(normal, |(tilted, ..)| tilted)
}
