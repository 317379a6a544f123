//! The ellipsoid with axes parallel to x, y and z.
//!
//! The hit is computed relative to the centre, in units of the largest radius, which keeps the precision for distant
//! ellipsoids. Then each axis is scaled down to the smallest radius. That makes the ellipsoid a sphere and never enlarges a
//! number, and the ray is intersected with that sphere.

use super::{Look, Move, Primitive, SurfacePoint, ahead};
use crate::color::Rgb;
use crate::light::cone::{Hidden, LampCone};
use crate::needs::Needs;
use crate::ray::Ray;
use crate::sampling::mapping::Frame;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};
use crate::scalar::{Scalar, Unit};

/// An ellipsoid with axes parallel to x, y and z.
#[derive(Clone, Copy, Debug)]
pub struct Ellipsoid<S: Scalar> {
    /// Centre.
    pub center: Vec3<S>,
    /// Radii along x, y and z, more than 0.
    pub radii: Vec3<S>,
    /// The largest radius.
    pub extent: S,
    /// Reciprocal of the largest radius.
    pub inverse_extent: S::Inverse,
    /// The smallest radius over each radius: 0 to 1.
    pub squash: UnitVec3<S>,
    /// The smallest radius over the largest: 0 to 1.
    pub thickness: S::Unit,
    /// Whether only the inside of the surface is visible.
    pub inside_only: bool,
    /// Reflectance of the surface.
    pub color: Rgb<S::Unit>,
    /// Number of its material in the scene's list, from 0.
    pub material: u16,
}

/// The radius of an octagon that is as large as a circle of the radius 1, times 2^30: the root of 2 pi / (8 sin 45 degrees).
const OCTAGON: i64 = 1_131_624_417;

/// A ray in the space where an ellipsoid is a sphere of radius [`Ellipsoid::thickness`] around 0.
struct Squashed<S: Scalar> {
    /// Distance along the ray to the perpendicular foot of the centre, before squashing.
    b: S,
    direction: UnitVec3<S>,
    /// Reciprocal of the length the squashed direction had.
    stretch: <S::Unit as Unit>::Inverse,
    foot: UnitVec3<S>,
    /// From the squashed ray's foot point to the place at `b`.
    past: S::Unit,
    half: S::Unit,
}

impl<S: Scalar> Ellipsoid<S> {
    /// Returns an ellipsoid from its centre and its radii along x, y and z.
    pub fn new(center: Vec3<S>, radii: Vec3<S>, color: Rgb<S::Unit>, material: u16) -> Self {
        let larger = |a: S, b: S| if a > b { a } else { b };
        let smaller = |a: S, b: S| if a < b { a } else { b };
        let (x, y, z) = (radii.x(), radii.y(), radii.z());
        let extent = larger(x, larger(y, z));
        let least = smaller(x, smaller(y, z));
        let part = |radius: S| if radius > least { least.fraction(radius.inverse()) } else { S::Unit::ONE };
        Self {
            center,
            radii,
            extent,
            inverse_extent: extent.inverse(),
            squash: Vector::new(part(x), part(y), part(z)),
            thickness: part(extent),
            inside_only: false,
            color,
            material,
        }
    }

    /// Returns the unit vector from the centre to a place in the space where the ellipsoid is the unit sphere, and one over its distance there;
    /// `None` for a place within the ellipsoid.
    fn view(&self, place: Vec3<S>) -> Option<(UnitVec3<S>, S::Unit)> {
        let (direction, distance, inverse) = (place - self.center).normalize()?;
        let least = self.extent.scale(self.thickness);
        let least = if least < distance { least.fraction(inverse) } else { return None };
        let (direction, stretch) = direction.times(self.squash).normalize()?;
        let sine = least.over(stretch);
        (sine < S::Unit::ONE).then_some((direction, sine))
    }

    /// Returns the ray in the space where the ellipsoid is a sphere, if it meets that sphere.
    fn squash(&self, ray: &Ray<S>, t_max: S) -> Option<Squashed<S>> {
        let displacement = self.center - ray.origin;
        let b = displacement.dot(ray.direction);
        if b + self.extent <= S::ZERO || b - self.extent >= t_max {
            return None;
        }
        if displacement.reject(ray.direction, b).norm_squared() > self.extent.square() {
            return None;
        }
        let beside = displacement.local(ray.direction, b, self.inverse_extent).times(self.squash);
        let (direction, stretch) = ray.direction.times(self.squash).normalize()?;
        let past = beside.dot(direction);
        let foot = beside.plus(direction, -past);
        let half = foot.half_chord(self.thickness)?;
        Some(Squashed { b, direction, stretch, foot, past, half })
    }

    /// Returns the distances at which the ray enters and leaves; the first is 0 where the outside is not visible.
    fn roots(&self, s: &Squashed<S>) -> (S, S) {
        let at = |offset: S::Unit| s.b + self.extent.scale((offset - s.past).over(s.stretch));
        (if self.inside_only { S::ZERO } else { at(-s.half) }, at(s.half))
    }
}

impl<S: Scalar> Move<S> for Ellipsoid<S> {
    fn moved(&self, by: Vec3<S>) -> Self {
        Self { center: self.center + by, ..*self }
    }
}

impl<S: Scalar> Primitive<S> for Ellipsoid<S> {
    fn intersect(&self, ray: &Ray<S>, t_max: S) -> Option<S> {
        let s = self.squash(ray, t_max)?;
        let (near, far) = self.roots(&s);
        ahead(near, far, t_max)
    }

    fn point<N: Needs>(&self, ray: &Ray<S>, t: S) -> SurfacePoint<S> {
        let up =
            SurfacePoint { distance: t, point: ray.origin.along(ray.direction, t), normal: -ray.direction };
        let Some(s) = self.squash(ray, S::FAR) else { return up };
        let (near, far) = self.roots(&s);
        let (distance, offset) = if near > S::ZERO { (near, -s.half) } else { (far, s.half) };
        let Some((place, _)) = s.foot.plus(s.direction, offset).normalize() else { return up };
        // The gradient of the quadric: each component of the sphere's normal once more over its radius.
        let Some((normal, _)) = place.times(self.squash).normalize() else { return up };
        let (r, p) = (self.radii, place);
        let arm = Vec3::<S>::new(r.x().scale(p.x()), r.y().scale(p.y()), r.z().scale(p.z()));
        SurfacePoint { distance, point: self.center + arm, normal }
    }

    /// As an octagon about its outline, and as large.
    fn hidden(&self, cone: &LampCone<S>) -> Hidden<S::Unit> {
        let (one, zero) = (S::Unit::ONE, S::Unit::ZERO);
        let holds = |place| self.view(place).is_none();
        if let Some(part) = cone.before(self.center, holds) {
            return part.into();
        }
        // Of the unit sphere the outline is a circle about the way to the point.
        let Some((direction, sine)) = self.view(cone.apex) else { return one.into() };
        let radius =
            S::Unit::radical(one, zero, sine).unwrap_or(zero).times(S::Unit::ratio(OCTAGON, 1 << 30));
        let frame = Frame::about(direction);
        let diagonal = radius.times(S::Unit::ratio(759_250_125, 1 << 30));
        let corners = [[radius, zero], [diagonal, diagonal], [zero, radius], [-diagonal, diagonal]];
        let [a, b, c, d] = corners;
        let opposite = [a, b, c, d].map(|[x, y]| [-x, -y]);
        let [e, f, g, h] = opposite;
        let corners = [a, b, c, d, e, f, g, h].map(|[x, y]| {
            let place = frame.vector([x, y, sine]);
            let (r, p) = (self.radii, place);
            self.center + Vec3::<S>::new(r.x().scale(p.x()), r.y().scale(p.y()), r.z().scale(p.z()))
        });
        cone.polygon(corners).into()
    }

    fn look(&self) -> Look<S> {
        let Self { center, radii, extent: radius, thickness, color, material, .. } = *self;
        let smaller = |a: S, b: S| if a < b { a } else { b };
        let least = smaller(smaller(radii.x(), radii.y()), radii.z());
        Look { color, material, extent: radius.squashed(thickness), center, radius, least }
    }
}
