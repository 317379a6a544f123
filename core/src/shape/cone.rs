//! The truncated cone between two points, with or without end discs; a cylinder where the radii are equal.
//!
//! The hit is computed relative to the middle of the axis, in units of the diameter of the bounding sphere. There the side
//! is `cos^2 |x|^2 = (r cos + z sin)^2`, with `x` across the axis, `z` along it, `r` the radius in the middle, and cosine
//! and sine of the angle between side and axis; no number exceeds 2, whatever the shape.

use super::{Look, Primitive, SurfacePoint};
use crate::color::Rgb;
use crate::material::Material;
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3};
use crate::scalar::{Scalar, Unit};

/// A truncated cone, or a cylinder, between two points.
#[derive(Clone, Copy, Debug)]
pub struct Cone<S: Scalar> {
    /// The middle of the axis.
    pub center: Vec3<S>,
    /// Unit vector along the axis, from the base to the apex.
    pub axis: UnitVec3<S>,
    /// Diameter of the smallest sphere about [`Cone::center`] that contains the cone: the unit "span" of other fields.
    pub span: S,
    /// Reciprocal of the span.
    pub inverse_span: S::Inverse,
    /// Half the height, in spans.
    pub half_height: S::Unit,
    /// Radius in the middle times [`Cone::cosine`], in spans.
    pub waist: S::Unit,
    /// Cosine of the angle between side and axis.
    pub cosine: S::Unit,
    /// Sine of that angle: above 0 where the cone widens towards its apex.
    pub sine: S::Unit,
    /// Radii of base and apex, in spans.
    pub radii: [S::Unit; 2],
    /// Whether discs close the ends.
    pub capped: bool,
    /// Whether only the inside of the surface is visible.
    pub inside_only: bool,
    /// Reflectance of the surface.
    pub color: Rgb<S::Unit>,
    /// What the surface does with light.
    pub material: Material<S>,
}

/// A ray relative to the middle of the axis, in spans.
struct Local<S: Scalar> {
    /// Distance along the ray to the perpendicular foot of the middle, rounded.
    b: S,
    /// From the exact foot point to that place, in spans: what rounding left.
    past: S::Unit,
    foot: UnitVec3<S>,
    /// Components of foot point and direction normal to the axis.
    foot_across: UnitVec3<S>,
    across: UnitVec3<S>,
    /// Components of foot point and direction along the axis.
    foot_along: S::Unit,
    along: S::Unit,
}

/// A hit: its offset from the foot point along the ray in spans, its distance, and which part of the cone it is on.
#[derive(Clone, Copy)]
struct Meeting<S: Scalar> {
    offset: S::Unit,
    distance: S,
    part: Part,
}

#[derive(Clone, Copy)]
enum Part {
    Side,
    Base,
    Apex,
}

impl<S: Scalar> Cone<S> {
    fn local(&self, ray: &Ray<S>, t_max: S) -> Option<Local<S>> {
        let displacement = self.center - ray.origin;
        let b = displacement.dot(ray.direction);
        let radius = self.span.scale(S::Unit::ratio(1, 2)).padded(b);
        if b + radius <= S::ZERO || b - radius >= t_max {
            return None;
        }
        if displacement.reject(ray.direction, b).norm_squared() > radius.square() {
            return None;
        }
        let beside = displacement.local(ray.direction, b, self.inverse_span);
        let past = beside.dot(ray.direction);
        let foot = beside.plus(ray.direction, -past);
        let (foot_along, along) = (foot.dot(self.axis), ray.direction.dot(self.axis));
        Some(Local {
            b,
            past,
            foot,
            foot_across: foot.plus(self.axis, -foot_along),
            across: ray.direction.plus(self.axis, -along),
            foot_along,
            along,
        })
    }

    /// Returns the nearest hit at a distance above 0 and below `t_max`, if there is one.
    fn meet(&self, ray: &Ray<S>, local: &Local<S>, t_max: S) -> Option<Meeting<S>> {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        let mut nearest: Option<Meeting<S>> = None;
        let mut see = |offset: S::Unit, part: Part| {
            if !(offset > -one && offset < one) {
                return;
            }
            let distance = local.b + self.span.scale(offset - local.past);
            let limit = nearest.map_or(t_max, |nearest| nearest.distance);
            if distance > S::ZERO && distance < limit {
                nearest = Some(Meeting { offset, distance, part });
            }
        };
        let (cosine_squared, slope) = (self.cosine.times(self.cosine), self.sine.times(local.along));
        let g = self.waist + self.sine.times(local.foot_along);
        let a = cosine_squared.times(local.across.dot(local.across)) - slope.times(slope);
        let b = cosine_squared.times(local.foot_across.dot(local.across)) - g.times(slope);
        let c = cosine_squared.times(local.foot_across.dot(local.foot_across)) - g.times(g);
        if let Some(root) = S::Unit::discriminant(b, a, c) {
            let q = if b > zero { -(b + root) } else { root - b };
            for offset in [q.quotient(a), c.quotient(q)] {
                // A quotient that saturates lies outside the bounding sphere.
                let within = offset > -one && offset < one;
                let z = if within { local.foot_along + offset.times(local.along) } else { one };
                if z >= -self.half_height
                    && z <= self.half_height
                    && (!self.inside_only || self.side_normal(local, offset).dot(ray.direction) > zero)
                {
                    see(offset, Part::Side);
                }
            }
        }
        if self.capped {
            for (part, z, radius) in [
                (Part::Base, -self.half_height, self.radii[0]),
                (Part::Apex, self.half_height, self.radii[1]),
            ] {
                let offset = (z - local.foot_along).quotient(local.along);
                let outwards = (local.along > zero) == matches!(part, Part::Apex);
                if offset > -one && offset < one && (!self.inside_only || outwards) {
                    let across = local.foot_across.plus(local.across, offset);
                    if across.half_chord(radius).is_some() {
                        see(offset, part);
                    }
                }
            }
        }
        nearest
    }

    /// Returns the outward unit normal of the side at an offset from the foot point.
    fn side_normal(&self, local: &Local<S>, offset: S::Unit) -> UnitVec3<S> {
        let across = local.foot_across.plus(local.across, offset);
        let Some((radial, _)) = across.normalize() else { return self.axis };
        radial.scale(self.cosine).plus(self.axis, -self.sine).tighten()
    }
}

impl<S: Scalar> Primitive<S> for Cone<S> {
    fn intersect(&self, ray: &Ray<S>, t_max: S) -> Option<S> {
        let local = self.local(ray, t_max)?;
        self.meet(ray, &local, t_max).map(|meeting| meeting.distance)
    }

    fn point<N: Needs>(&self, ray: &Ray<S>, t: S) -> SurfacePoint<S> {
        let lost =
            SurfacePoint { distance: t, point: ray.origin.along(ray.direction, t), normal: -ray.direction };
        let Some(local) = self.local(ray, S::FAR) else { return lost };
        let Some(Meeting { offset, distance, part }) = self.meet(ray, &local, S::FAR) else { return lost };
        let place = local.foot.plus(ray.direction, offset);
        let z = local.foot_along + offset.times(local.along);
        // `off` is the distance of the place from the surface, due to rounding, along the normal.
        let (normal, off) = match part {
            Part::Side => {
                let normal = self.side_normal(&local, offset);
                let across = local.foot_across.plus(local.across, offset);
                (normal, across.dot(normal) + z.times(-self.sine) - self.waist)
            }
            Part::Base => (-self.axis, -z - self.half_height),
            Part::Apex => (self.axis, z - self.half_height),
        };
        let place = place.plus(normal, -off);
        SurfacePoint { distance, point: self.center.along(place, self.span), normal }
    }

    fn look(&self) -> Look<'_, S> {
        let [base, apex] = self.radii;
        let radius = self.span.scale(S::Unit::ratio(1, 2));
        Look {
            color: self.color,
            material: &self.material,
            extent: self.span.squashed(if base > apex { base } else { apex }),
            center: self.center,
            radius,
            least: radius,
        }
    }
}
