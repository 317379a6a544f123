//! How triangles with normals are shaded, where not by mixing the normals at the hit (Phong 1975).

use crate::color::Rgb;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};
use crate::scalar::{Light, Scalar, Unit};
use crate::shape::{Triangle, half_sum};

/// How a triangle with normals is shaded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Shading {
    /// The normals of its vertices are mixed (B. T. Phong, "Illumination for Computer Generated Pictures", CACM 18, 1975).
    #[default]
    Normals,
    /// The light of its vertices is mixed (H. Gouraud, "Continuous Shading of Curved Surfaces", IEEE Trans. Computers 20, 1971).
    Gouraud,
    /// Cosines are expanded to the second order about its middle (G. Bishop and D. Weimer, "Fast Phong Shading", SIGGRAPH 1986).
    BishopWeimer,
}

/// A triangle that is not shaded as one with mixed normals, at a point of which the light is wanted.
#[derive(Clone, Copy, Debug)]
pub struct Mesh<'a, S: Scalar> {
    /// The triangle.
    pub triangle: &'a Triangle<S>,
    /// How it is shaded.
    pub shading: Shading,
    /// The unit direction of view, where what is mixed is mixed on the screen.
    pub view: Option<&'a UnitVec3<S>>,
}

impl<S: Scalar> Mesh<'_, S> {
    /// Returns the parts that the vertices have in a point, for a ray that comes from `origin`: barycentric coordinates in space, or on the
    /// screen.
    pub fn weights(&self, origin: Vec3<S>, point: Vec3<S>) -> [S::Unit; 3] {
        let weights = self.triangle.weights(point);
        let seen = self.view.and_then(|&view| {
            on_screen::<S>(weights, self.triangle.vertices.map(|vertex| (vertex - origin).dot(view)))
        });
        seen.unwrap_or(weights)
    }
}

/// Returns the barycentric coordinates on the screen of a point with the `weights` in space, where the vertices are `depths` along the
/// direction of view away: `b z / (b0 z0 + b1 z1 + b2 z2)` for each. `None` where a vertex is not in front of the eye.
pub fn on_screen<S: Scalar>(weights: [S::Unit; 3], depths: [S; 3]) -> Option<[S::Unit; 3]> {
    let farthest = depths.into_iter().fold(S::ZERO, |most, depth| if depth > most { depth } else { most });
    if depths.into_iter().any(|depth| depth <= S::ZERO) {
        return None;
    }
    let farthest = farthest.inverse();
    let [b0, b1, b2] = weights;
    let [z0, z1, z2] = depths.map(|depth| depth.fraction(farthest));
    let parts = [b0.times(z0), b1.times(z1), b2.times(z2)];
    let whole = parts.into_iter().fold(S::Unit::ZERO, |sum, part| sum + part);
    let [_, second, third] = parts.map(|part| part.quotient(whole));
    Some([S::Unit::ONE - second - third, second, third])
}

/// Returns the light of three vertices, mixed by their weights.
pub fn gouraud<S: Scalar>(weights: [S::Unit; 3], lights: [Rgb<S::Light>; 3]) -> Rgb<S::Light> {
    let parts = lights.into_iter().zip(weights);
    parts.fold(Rgb::BLACK, |sum, (light, weight)| sum.plus(light.map(|register| register.times(weight))))
}

/// Returns the normals of three vertices, mixed by their weights to a unit vector; `None` where they cancel out.
pub fn mixed_normal<S: Scalar>(weights: [S::Unit; 3], normals: [UnitVec3<S>; 3]) -> Option<UnitVec3<S>> {
    half_sum::<S>(weights, normals).normalize().map(|(normal, _)| normal)
}

/// Returns what stands for the normal of a point of a triangle by Bishop and Weimer: the unit vector along the mixed normals, expanded to
/// the second order about the triangle's middle. Its length is 1 up to the third order, and its cosines with fixed directions are the
/// polynomials of the paper. `None` where the normals are too far apart for the expansion.
///
/// With n the unit normal in the middle, and d what the mixed normals differ from those of the middle, in units of their length there:
/// `n (1 - n.d + 3/2 (n.d)^2 - 1/2 d.d) + d (1 - n.d)`.
pub fn bishop_weimer<S: Scalar>(weights: [S::Unit; 3], normals: [UnitVec3<S>; 3]) -> Option<UnitVec3<S>> {
    let ratio = S::Unit::ratio;
    let (one, half) = (S::Unit::ONE, ratio(1, 2));
    let (middle, length) = half_sum::<S>([ratio(1, 3); 3], normals).normalize()?;
    let apart = half_sum::<S>(weights.map(|weight| weight - ratio(1, 3)), normals);
    // Half of d. The expansion is used up to d.d = 1/2.
    let away = UnitVec3::<S>::new(
        apart.x().times(half).over(length),
        apart.y().times(half).over(length),
        apart.z().times(half).over(length),
    );
    let is_far = |part: S::Unit| part > ratio(3, 8) || part < ratio(-3, 8);
    if is_far(away.x()) || is_far(away.y()) || is_far(away.z()) {
        return None; // and a square might be too large
    }
    let square = away.dot(away);
    if square > ratio(1, 8) {
        return None;
    }
    let along = middle.dot(away);
    let (along, square) = (along + along, square + square);
    // Half of the sum, which may exceed 2 on the way.
    let own = half - along.times(half) + along.times(along).times(ratio(3, 4)) - square.times(half);
    let sum = middle.scale(own).plus(away, one - along);
    let twice = |part: S::Unit| part + part;
    Some(UnitVec3::<S>::new(twice(sum.x()), twice(sum.y()), twice(sum.z())))
}
