//! The infinite plane.
//!
//! It is seen as far as there are numbers. Its places are computed relative to [`Plane::center`] and end at [`Plane::reach`]:
//! what is farther away is lit as the plane's rim is, so that the next ray starts where the range proof expects it.

use super::{Look, Move, Primitive, SurfacePoint};
use crate::color::Rgb;
use crate::light::cone::{Hidden, LampCone};
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3};
use crate::scalar::{Scalar, Unit};

/// An infinite plane, visible from both sides.
#[derive(Clone, Copy, Debug)]
pub struct Plane<S: Scalar> {
    /// A place of the plane, near to where the scene is.
    pub center: Vec3<S>,
    /// Unit normal.
    pub normal: UnitVec3<S>,
    /// Reflectance of the surface.
    pub color: Rgb<S::Unit>,
    /// Number of its material in the scene's list, from 0.
    pub material: u16,
}

impl<S: Scalar> Plane<S> {
    /// Returns the distance from [`Plane::center`] at which places of a plane end: an eighth of [`Scalar::FAR`], so that the
    /// plane takes a quarter of the format and leaves half of it to the scene.
    pub fn reach() -> S {
        S::FAR.scale(S::Unit::ratio(1, 8))
    }
}

impl<S: Scalar> Move<S> for Plane<S> {
    fn moved(&self, by: Vec3<S>) -> Self {
        Self { center: self.center + by, ..*self }
    }
}

impl<S: Scalar> Primitive<S> for Plane<S> {
    const IS_FINITE: bool = false;

    fn intersect(&self, ray: &Ray<S>, t_max: S) -> Option<S> {
        let height = (self.center - ray.origin).dot(self.normal);
        let cosine = self.normal.dot(ray.direction);
        let t = if height > S::ZERO && cosine > S::Unit::ZERO {
            height.over(cosine)
        } else if height < S::ZERO && cosine < S::Unit::ZERO {
            (-height).over(-cosine)
        } else {
            return None;
        };
        // A hit beyond the format is seen at its end.
        let last = S::FAR.scale(S::Unit::ratio(63, 64));
        let t = if t < last { t } else { last };
        (t < t_max).then_some(t)
    }

    fn point<N: Needs>(&self, ray: &Ray<S>, t: S) -> SurfacePoint<S> {
        let reach = Self::reach();
        let way = if t < reach { t } else { reach };
        let place = (-(self.center - ray.origin)).along(ray.direction, way);
        // Project the place back into the plane, which rounding has left, or which the ray does not reach by then.
        let place = place.reject(self.normal, place.dot(self.normal));
        let point = match place.normalize() {
            Some((direction, away, _)) if away > reach => self.center.along(direction, reach),
            _ => self.center + place,
        };
        SurfacePoint { distance: t, point, normal: self.normal }
    }

    fn hidden(&self, cone: &LampCone<S>) -> Hidden<S::Unit> {
        let height = |place: Vec3<S>| (place - self.center).dot(self.normal);
        cone.half_space(height(cone.apex), height(cone.lamp), self.normal).into()
    }

    /// The look is that of a disc, beyond which no place of the plane lies.
    fn look(&self) -> Look<S> {
        let Self { center, color, material, .. } = *self;
        let reach = Self::reach();
        Look { color, material, extent: S::ZERO, center, radius: reach, least: reach }
    }
}
