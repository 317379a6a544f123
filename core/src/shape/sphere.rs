//! The sphere, by the perpendicular foot of its centre on the ray (Haines, Günther and Akenine-Möller, "Precision
//! Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019, chapter 7): the discriminant is `r^2 - |l|^2`
//! with `l` the displacement from the ray to the centre, and nothing large is subtracted from anything large.

use super::{Look, Move, Primitive, SurfacePoint, ahead};
use crate::color::Rgb;
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::vector::{LengthVector, UnitVector, Vec3};
use crate::scalar::{Scalar, Unit};

/// A sphere.
#[derive(Clone, Copy, Debug)]
pub struct Sphere<S: Scalar> {
    /// Centre.
    pub center: Vec3<S>,
    /// Radius, more than 0.
    pub radius: S,
    /// Reciprocal of the radius.
    pub inverse_radius: S::Inverse,
    /// Reflectance of the surface.
    pub color: Rgb<S::Unit>,
    /// Number of its material in the scene's list, from 0.
    pub material: u16,
}

impl<S: Scalar> Sphere<S> {
    /// Returns a sphere from its centre and radius.
    pub fn new(center: Vec3<S>, radius: S, color: Rgb<S::Unit>, material: u16) -> Self {
        Self { center, radius, inverse_radius: radius.inverse(), color, material }
    }

    /// Returns the distance of the nearest hit, above 0 and below `t_max`, of any sphere, such as a lamp's.
    #[cfg_attr(not(target_os = "none"), inline)]
    #[cfg_attr(target_os = "none", inline(never))] // rays, shadow rays and lamps share it where flash is short
    pub fn distance(center: Vec3<S>, radius: S, ray: &Ray<S>, t_max: S) -> Option<S> {
        let displacement = center - ray.origin;
        let b = displacement.dot(ray.direction);
        if b + radius <= S::ZERO || b - radius >= t_max {
            return None;
        }
        let across = displacement.reject(ray.direction, b).norm_squared();
        let square = radius.square();
        if across > square {
            return None;
        }
        let half = S::sqrt(square - across);
        ahead(b - half, b + half, t_max)
    }
}

impl<S: Scalar> Move<S> for Sphere<S> {
    fn moved(&self, by: Vec3<S>) -> Self {
        Self { center: self.center + by, ..*self }
    }
}

impl<S: Scalar> Primitive<S> for Sphere<S> {
    #[inline]
    fn intersect(&self, ray: &Ray<S>, t_max: S) -> Option<S> {
        Self::distance(self.center, self.radius, ray, t_max)
    }

    #[inline]
    fn point<N: Needs>(&self, ray: &Ray<S>, t: S) -> SurfacePoint<S> {
        let displacement = self.center - ray.origin;
        let b = displacement.dot(ray.direction);
        // The foot point, with the centre at 0 and the radius 1.
        let beside = displacement.local(ray.direction, b, self.inverse_radius);
        let past = beside.dot(ray.direction); // what the rounding of b left
        let foot = beside.plus(ray.direction, -past);
        let (normal, offset) = match foot.half_chord(S::Unit::ONE) {
            Some(half) => {
                let offset = if t > b { half } else { -half };
                (foot.plus(ray.direction, offset).tighten(), offset - past)
            }
            // The search saw a tangent where there is a miss by less than its rounding.
            None => (foot.normalize().map_or(-ray.direction, |(normal, _)| normal), -past),
        };
        let point = self.center.along(normal, self.radius);
        SurfacePoint { distance: b + self.radius.scale(offset), point, normal }
    }

    #[inline]
    fn look(&self) -> Look<S> {
        let Self { center, radius, color, material, .. } = *self;
        Look { color, material, extent: radius, center, radius, least: radius }
    }
}
