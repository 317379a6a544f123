//! The infinite vertical cylinder. Seen from above, in the ground plan, it is a circle that the ray meets or not.

use super::{Look, Move, Primitive, SurfacePoint, ahead};
use crate::color::Rgb;
use crate::light::cone::{Hidden, LampCone};
use crate::needs::Needs;
use crate::ray::{GroundPlan, Ray};
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};
use crate::scalar::{Scalar, Unit};

/// An infinite vertical cylinder. It is visible at any height; a hit above the height
/// [`Limits::cylinder_end`](crate::scene::Limits::cylinder_end), or below its negative, is lit as if it were there.
#[derive(Clone, Copy, Debug)]
pub struct Cylinder<S: Scalar> {
    /// A place on the axis.
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

impl<S: Scalar> Cylinder<S> {
    /// Returns a cylinder from a place on its axis and its radius.
    pub fn new(center: Vec3<S>, radius: S, color: Rgb<S::Unit>, material: u16) -> Self {
        Self { center, radius, inverse_radius: radius.inverse(), color, material }
    }
}

impl<S: Scalar> Move<S> for Cylinder<S> {
    fn moved(&self, by: Vec3<S>) -> Self {
        Self { center: self.center + by, ..*self }
    }
}

impl<S: Scalar> Primitive<S> for Cylinder<S> {
    const IS_FINITE: bool = false;

    /// Returns `None` also where the ray has no [`plan`](Ray::plan).
    fn intersect(&self, ray: &Ray<S>, t_max: S) -> Option<S> {
        let plan = ray.plan?.direction;
        let displacement = self.center - ray.origin;
        let b = displacement.dot_plan(plan);
        if b + self.radius <= S::ZERO {
            return None;
        }
        let across = displacement.cross_plan(plan).square();
        let square = self.radius.square();
        if across > square {
            return None;
        }
        let half = S::sqrt(square - across);
        ahead((b - half).stretch(plan.stretch), (b + half).stretch(plan.stretch), t_max)
    }

    fn point<N: Needs>(&self, ray: &Ray<S>, t: S) -> SurfacePoint<S> {
        let Some(GroundPlan { direction: plan, cylinder_end: end }) = ray.plan else {
            // It is vertical, or was never to meet a cylinder.
            return SurfacePoint {
                distance: t,
                point: ray.origin.along(ray.direction, t),
                normal: -ray.direction,
            };
        };
        let displacement = self.center - ray.origin;
        let b = displacement.dot_plan(plan);
        let across = displacement.cross_plan_over(plan, self.inverse_radius);
        let half = S::Unit::radical(S::Unit::ONE, S::Unit::ZERO, across).unwrap_or(S::Unit::ZERO);
        let near = (b - self.radius.scale(half)).stretch(plan.stretch);
        let (distance, offset) = if near > S::ZERO {
            (near, -half)
        } else {
            ((b + self.radius.scale(half)).stretch(plan.stretch), half)
        };
        let normal: UnitVec3<S> = Vector::new(
            plan.x.times(offset) - plan.y.times(across),
            plan.y.times(offset) + plan.x.times(across),
            S::Unit::ZERO,
        );
        let normal = normal.tighten();
        // The hit may lie where the format has no numbers. Neither normal nor colour depends on the height.
        let (z, rise) = (ray.origin.z(), distance.scale(ray.direction.z()));
        let height = if rise >= end - z {
            end
        } else if rise <= -end - z {
            -end
        } else {
            z + rise
        };
        let axis = Vec3::<S>::new(self.center.x(), self.center.y(), height);
        SurfacePoint { distance, point: axis.along(normal, self.radius), normal }
    }

    /// As the strip between the two lines where it ends to the eye.
    fn hidden(&self, cone: &LampCone<S>) -> Hidden<S::Unit> {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        let flat = |way: Vec3<S>| Vec3::<S>::new(way.x(), way.y(), S::ZERO);
        let way = flat(self.center - cone.apex);
        let holds_lamp = flat(cone.lamp - self.center).norm_squared() < self.radius.square();
        let seen = way.normalize().filter(|way| way.1 > self.radius);
        let Some((direction, _, inverse)) = seen else { return if holds_lamp { zero } else { one }.into() };
        if holds_lamp {
            return one.into();
        }
        let lamps = flat(cone.lamp - cone.apex).normalize();
        if lamps.is_none_or(|(ahead, distance, _)| {
            way.dot(ahead) >= distance || way.dot(ahead) + self.radius <= S::ZERO
        }) {
            return zero.into();
        }
        let sine = self.radius.fraction(inverse);
        let cosine = S::Unit::radical(one, zero, sine).unwrap_or(zero);
        let (x, y) = (direction.x(), direction.y());
        // The planes that touch it, by their normals away from it.
        let ends = [cosine, -cosine].map(|cosine| {
            let normal =
                UnitVec3::<S>::new(-y.times(cosine) - x.times(sine), x.times(cosine) - y.times(sine), zero);
            cone.beside(normal)
        });
        let part = ends[0] + ends[1] - one;
        if part < zero { zero } else { part }.into()
    }

    /// The look's centre is where the axis meets the floor.
    fn look(&self) -> Look<S> {
        let Self { radius, color, material, .. } = *self;
        let center = Vec3::<S>::new(self.center.x(), self.center.y(), S::ZERO);
        Look { color, material, extent: radius, center, radius, least: radius }
    }
}
