//! The truncated cone between two points, with or without end discs; a cylinder where the radii are equal.
//!
//! The hit is computed relative to the middle of the axis, in units of the diameter of the bounding sphere. There the side
//! is `cos^2 |x|^2 = (r cos + z sin)^2`, with `x` across the axis, `z` along it, `r` the radius in the middle, and cosine
//! and sine of the angle between side and axis; no number exceeds 2, whatever the shape.

use super::{Look, Move, Primitive, SurfacePoint};
use crate::color::Rgb;
use crate::light::cone::{Hidden, LampCone};
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};
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
    /// Number of its material in the scene's list, from 0.
    pub material: u16,
}

/// A ray relative to the middle of the axis, in spans.
struct Local<S: Scalar> {
    /// Distance along the ray to the perpendicular foot of the middle, rounded.
    b: S,
    /// From the exact foot point to that place, in spans: what rounding left.
    past: S::Unit,
    foot: UnitVec3<S>,
    /// Components of foot point and direction along the axis.
    foot_along: S::Unit,
    along: S::Unit,
    /// Components of foot point and direction across the axis.
    foot_across: UnitVec3<S>,
    across: UnitVec3<S>,
    /// Unit vector across the axis, in which the ray moves across it.
    heading: UnitVec3<S>,
    /// Reciprocal of the length of `across`; `None` where it is too short to have been rounded well.
    stretch: Option<<S::Unit as Unit>::Inverse>,
}

/// Where a ray meets the endless side, both parts of a double cone.
struct Crossings<S: Scalar> {
    /// Offsets from the foot point along the ray in spans.
    offsets: [Option<S::Unit>; 2],
    /// By how much the ends are moved, because the offsets are rounded.
    margin: S::Unit,
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
    /// Returns whether a place is between the ends and nearer to the axis than the side.
    fn holds(&self, place: Vec3<S>) -> bool {
        let way = place - self.center;
        let (along, half) = (way.dot(self.axis), self.span.scale(self.half_height));
        if along <= -half || along >= half {
            return false;
        }
        // The radius from the axis times the cosine, as the side has it.
        let radius = self.span.scale(self.waist) + along.scale(self.sine);
        let away = S::sqrt(way.reject(self.axis, along).norm_squared()).scale(self.cosine);
        away < radius
    }

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
        let foot_across = foot.plus(self.axis, -foot_along);
        let across = ray.direction.plus(self.axis, -along);
        let short = S::Unit::ratio(255, 256);
        let (heading, stretch) = match across.normalize() {
            Some((heading, stretch)) if along < short && along > -short => (heading, Some(stretch)),
            leaning => (self.heading(leaning.map(|(heading, _)| heading), foot_across), None),
        };
        Some(Local { b, past, foot, foot_along, along, foot_across, across, heading, stretch })
    }

    /// Returns the heading of a ray almost along the axis: `leaning`, the unit vector along a short `across`, leans along the axis,
    /// because the short vector was rounded. Where it is 0, the heading is along `foot_across`, or any across the axis.
    fn heading(&self, leaning: Option<UnitVec3<S>>, foot_across: UnitVec3<S>) -> UnitVec3<S> {
        let unit = |v: UnitVec3<S>| v.normalize().map(|(unit, _)| unit);
        let upright = |v: UnitVec3<S>| unit(v.plus(self.axis, -v.dot(self.axis)));
        let any = || unit(self.axis.cross(UnitVec3::<S>::X)).unwrap_or(UnitVec3::<S>::Y);
        leaning.or_else(|| unit(foot_across)).and_then(upright).unwrap_or_else(any)
    }

    /// Returns the two places, if any, at which the ray meets the endless side.
    ///
    /// In the plane across the axis, with `B` along [`Local::heading`] and `H` beside it, the side is
    /// `(B + K s)^2 + H^2 = (g + M s)^2`. `K` and `M`, how fast the ray moves across the axis and how fast the radius grows, are
    /// scaled to `K^2 + M^2 = 1`, so that no digit is lost for a ray almost along the axis. A fourth of the discriminant is
    /// `(K g - M B)^2 - (K^2 - M^2) H^2`: the distance along the axis has been cancelled in it by hand, so the hit errs by some
    /// roundings of a span, however thin the cone is and wherever along it the ray passes.
    fn side(&self, local: &Local<S>) -> Option<Crossings<S>> {
        let (zero, heading) = (S::Unit::ZERO, local.heading);
        let beside = self.cosine.times(local.foot_across.dot(self.axis.cross(heading)));
        let [base, apex] = self.radii;
        let widest = self.cosine.times(if base > apex { base } else { apex }) + S::Unit::ROUNDING;
        if beside > widest || beside < -widest {
            return None;
        }
        let before = self.cosine.times(local.foot_across.dot(heading));
        let g = self.waist + self.sine.times(local.foot_along);
        if self.sine == zero
            && let Some(stretch) = local.stretch
        {
            // A cylinder: K is 1, M is 0.
            let root = S::Unit::radical(g, zero, beside)?;
            let roots = [-(before + root), root - before];
            let offsets = roots.map(|root| Some(root.over(stretch)));
            return Some(Crossings { offsets, margin: S::Unit::ROUNDING.over(stretch) });
        }
        let slopes: UnitVec3<S> =
            Vector::new(self.cosine.times(local.across.dot(heading)), self.sine.times(local.along), zero);
        let (slopes, stretch) = slopes.normalize()?;
        let (k, m) = (slopes.x(), slopes.y());
        let root = S::Unit::radical(k.times(g) - m.times(before), m.times(beside), k.times(beside))?;
        let h = before.times(k) - g.times(m);
        let a = (k - m).times(k + m);
        let sixteenth = S::Unit::ratio(1, 16);
        let roots = if a >= sixteenth || a <= -sixteenth {
            [Some((-h - root).quotient(a)), Some((root - h).quotient(a))]
        } else {
            // The ray is almost parallel to the side: one root is far away, the other must not be a difference.
            let q = if h > zero { -(h + root) } else { root - h };
            let c = (before - g).times(before + g) + beside.times(beside);
            [(a != zero).then(|| q.quotient(a)), (q != zero).then(|| c.quotient(q))]
        };
        let offset = |root: Option<S::Unit>| root.map(|root| root.over(stretch));
        Some(Crossings { offsets: roots.map(offset), margin: S::Unit::ROUNDING.over(stretch) })
    }

    /// Returns the nearest hit at a distance above 0 and below `t_max`, if there is one.
    fn meet(&self, ray: &Ray<S>, local: &Local<S>, t_max: S) -> Option<Meeting<S>> {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        let mut nearest: Option<Meeting<S>> = None;
        let mut see = |offset: S::Unit, part: Part| {
            let distance = local.b + self.span.scale(offset - local.past);
            let limit = nearest.map_or(t_max, |nearest| nearest.distance);
            if distance > S::ZERO && distance < limit {
                nearest = Some(Meeting { offset, distance, part });
            }
        };
        // What saturates lies outside the bounding sphere.
        let within = |offset: S::Unit| offset > -one && offset < one;
        if let Some(Crossings { offsets, margin }) = self.side(local) {
            for offset in offsets.into_iter().flatten().filter(|&offset| within(offset)) {
                let z = local.foot_along + offset.times(local.along);
                let beyond = if z < zero { -z } else { z } - self.half_height;
                if beyond <= margin
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
                if within(offset) && (!self.inside_only || outwards) {
                    let across = local.foot_across.plus(local.across, offset);
                    if across.half_chord(radius + S::Unit::ROUNDING).is_some() {
                        see(offset, part);
                    }
                }
            }
        }
        nearest
    }

    /// Returns the outward unit normal of the side at an offset from the foot point; at the apex, one that faces the ray.
    fn side_normal(&self, local: &Local<S>, offset: S::Unit) -> UnitVec3<S> {
        let across = local.foot_across.plus(local.across, offset);
        let is_axis = across.half_chord(S::Unit::ROUNDING).is_some();
        let radial = if is_axis { None } else { across.normalize() };
        let radial = radial.map_or(-local.heading, |(radial, _)| radial);
        radial.scale(self.cosine).plus(self.axis, -self.sine).tighten()
    }
}

impl<S: Scalar> Move<S> for Cone<S> {
    fn moved(&self, by: Vec3<S>) -> Self {
        Self { center: self.center + by, ..*self }
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

    /// As its section along the axis that is seen at its widest, and its end discs as discs of the size at which they are seen. From
    /// within, one ray to the middle of the lamp decides.
    fn hidden(&self, cone: &LampCone<S>) -> Hidden<S::Unit> {
        let (zero, one) = (S::Unit::ZERO, S::Unit::ONE);
        if self.holds(cone.apex) {
            let ray = Ray::new(cone.apex, cone.axis);
            return if self.intersect(&ray, cone.distance).is_some() { one } else { zero }.into();
        }
        let way = self.center - cone.apex;
        let Some((direction, ..)) = way.normalize() else { return zero.into() };
        if way.dot(cone.axis) >= cone.distance && !self.holds(cone.lamp) {
            return zero.into();
        }
        let half = self.span.scale(self.half_height);
        let [base, apex] = [-half, half].map(|along| self.center.along(self.axis, along));
        let [wide, narrow] = self.radii.map(|radius| self.span.scale(radius));
        let mut part = zero;
        if let Some((across, _)) = self.axis.cross(direction).normalize() {
            let side = |end: Vec3<S>, radius: S| end.along(across, radius);
            let corners = [side(base, wide), side(apex, narrow), side(apex, -narrow), side(base, -wide)];
            part = cone.polygon(corners);
        }
        if self.capped {
            for (end, radius) in [(base, wide), (apex, narrow)] {
                let cosine = self.axis.dot(direction);
                let seen = radius.scale(if cosine < zero { -cosine } else { cosine }.sqrt());
                let disc = cone.disc(end, seen);
                part = if disc > part { disc } else { part };
            }
        }
        part.into()
    }

    fn look(&self) -> Look<S> {
        let Self { center, span, color, material, .. } = *self;
        let radius = span.scale(S::Unit::ratio(1, 2));
        Look { color, material, extent: span, center, radius, least: radius }
    }
}
