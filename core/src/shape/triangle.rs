//! The triangle: its plane, and three planes that stand on it along the edges.
//!
//! The hit is computed relative to a corner, so that no length exceeds the triangle's. A place on an edge belongs to both
//! triangles that share it.

use super::{Look, Primitive, SurfacePoint};
use crate::color::Rgb;
use crate::material::Material;
use crate::needs::{Needs, Used};
use crate::ray::Ray;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3};
use crate::scalar::{Scalar, Unit};

/// A triangle.
#[derive(Clone, Copy, Debug)]
pub struct Triangle<S: Scalar> {
    /// The first vertex.
    pub corner: Vec3<S>,
    /// The length of the longer edge at that vertex.
    pub extent: S,
    /// Unit normal on the side from which the vertices run counterclockwise.
    pub normal: UnitVec3<S>,
    /// For each vertex, the unit vector in the plane that is normal to the opposite edge and points to the vertex.
    pub inward: [UnitVec3<S>; 3],
    /// For each vertex, its distance from the opposite edge.
    pub heights: [S; 3],
    /// Unit normals at the vertices, interpolated for a surface that is shaded as if it were curved (Phong 1975).
    pub normals: Option<[UnitVec3<S>; 3]>,
    /// Whether it is visible only from where the vertices run counterclockwise. A ray that meets it from behind passes, a
    /// shadow ray too.
    pub one_sided: bool,
    /// Reflectance of the surface.
    pub color: Rgb<S::Unit>,
    /// What the surface does with light.
    pub material: Material<S>,
}

impl<S: Scalar> Triangle<S> {
    /// Returns the distance of the hit and its place relative to the corner, if there is one below `t_max`.
    #[inline]
    fn meet(&self, ray: &Ray<S>, t_max: S) -> Option<(S, Vec3<S>)> {
        let displacement = self.corner - ray.origin;
        // A ray that leads away from the plane, as most do that begin on it.
        let (height, cosine) = (displacement.dot(self.normal), self.normal.dot(ray.direction));
        let is_ahead =
            if cosine > S::Unit::ZERO { height > S::ZERO && !self.one_sided } else { height < S::ZERO };
        if !is_ahead {
            return None;
        }
        let b = displacement.dot(ray.direction);
        if b + self.extent <= S::ZERO || b - self.extent >= t_max {
            return None;
        }
        // The slack covers the rounding of this test and of the neighbours', so that shared edges have no gaps.
        let reach = self.extent.padded(b);
        let slack = self.extent - reach;
        let foot = displacement.reject(ray.direction, b);
        if foot.norm_squared() > reach.square() {
            return None;
        }
        // `way` leads from the foot point of the corner along the ray to the plane.
        let height = foot.dot(self.normal);
        let (rise, is_ahead) = (if height < S::ZERO { -height } else { height }, height > S::ZERO);
        let way = if cosine > S::Unit::ZERO {
            let way = rise.over(cosine);
            if is_ahead { way } else { -way }
        } else if cosine < S::Unit::ZERO {
            let way = rise.over(-cosine);
            if is_ahead { -way } else { way }
        } else {
            return None;
        };
        if way > reach || way < -reach {
            return None;
        }
        let t = b + way;
        if !(t > S::ZERO && t < t_max) {
            return None;
        }
        let place = (-foot).along(ray.direction, way);
        let [first, second, third] = self.inward;
        let inside = self.heights[0] + place.dot(first) >= slack
            && place.dot(second) >= slack
            && place.dot(third) >= slack;
        inside.then_some((t, place))
    }

    /// Returns the vertices' normals, interpolated by barycentric coordinates; `None` where they cancel out.
    fn curved(&self, place: Vec3<S>, [first, second, third]: [UnitVec3<S>; 3]) -> Option<UnitVec3<S>> {
        let part = |away: S, height: S| {
            let away = if away < S::ZERO { S::ZERO } else { away };
            if away < height { away.fraction(height.inverse()) } else { S::Unit::ONE }
        };
        let [_, over_second, over_third] = self.heights;
        let (b, c) =
            (part(place.dot(self.inward[1]), over_second), part(place.dot(self.inward[2]), over_third));
        let a = S::Unit::ONE - b - c;
        let half = S::Unit::ratio(1, 2);
        let mixed = first.scale(a.times(half)).plus(second, b.times(half)).plus(third, c.times(half));
        mixed.normalize().map(|(normal, _)| normal)
    }
}

impl<S: Scalar> Primitive<S> for Triangle<S> {
    #[inline]
    fn intersect(&self, ray: &Ray<S>, t_max: S) -> Option<S> {
        self.meet(ray, t_max).map(|(t, _)| t)
    }

    fn point<N: Needs>(&self, ray: &Ray<S>, t: S) -> SurfacePoint<S> {
        let Some((distance, place)) = self.meet(ray, S::FAR) else {
            return SurfacePoint {
                distance: t,
                point: ray.origin.along(ray.direction, t),
                normal: self.normal,
            };
        };
        // Project the place back into the plane, which rounding has left.
        let place = place.reject(self.normal, place.dot(self.normal));
        let mut normal = self.normal;
        if N::NORMALS
            && let Some(normals) = self.normals
            && let Some(curved) = self.curved(place, normals)
            // Use the flat normal where the interpolated one is on the other side of the ray.
            && (curved.dot(ray.direction) > S::Unit::ZERO) == (normal.dot(ray.direction) > S::Unit::ZERO)
        {
            normal = curved;
        }
        SurfacePoint { distance, point: self.corner + place, normal }
    }

    #[inline]
    fn look(&self) -> Look<'_, S> {
        let Self { corner, extent, color, ref material, .. } = *self;
        Look { color, material, extent, center: corner, radius: extent, least: extent }
    }

    fn note_needs(&self, used: &mut Used) {
        used.normals |= self.normals.is_some();
    }
}
