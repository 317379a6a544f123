//! A cone of rays: from the eye over a pixel, or what a surface makes of one.
//!
//! Its rays are named by the places of a disc of the radius 1: the ray at such a place, (0, 0) the axis, goes through the same place of each
//! cross section, whose radius is `radius + t tangent` at the distance t along the axis. Where that is negative, behind a focus, the cross
//! section is upside down, and everything below still holds.

use core::f64::consts::{FRAC_PI_2, PI};

use rta_core::ray::Ray;
use rta_core::sampling::mapping::Frame;
use rta_core::vector::{UnitVec3, Vec3};

use super::cover::{Covered, Polygon, lens, seg};

/// The largest half angle of a cone, in radians: a wider one has no flat cross section.
const WIDEST: f64 = 0.45 * PI;

/// A cone of rays.
#[derive(Clone, Copy, Debug)]
pub struct Beam {
    /// Where its axis begins.
    pub origin: Vec3<f64>,
    /// Unit vector along its axis.
    pub axis: UnitVec3<f64>,
    /// Radius of its cross section there, 0 or more.
    pub radius: f64,
    /// Its half angle in radians, negative where it narrows.
    pub angle: f64,
    tangent: f64,
    across: [Vec3<f64>; 2],
}

impl Beam {
    /// Returns a cone from a cross section of the radius `radius` on, whose half angle is `angle` radians.
    pub fn new(origin: Vec3<f64>, axis: UnitVec3<f64>, radius: f64, angle: f64) -> Self {
        let angle = angle.clamp(-WIDEST, WIDEST);
        let frame = Frame::about(axis);
        let across = [frame.vector([1.0, 0.0, 0.0]), frame.vector([0.0, 1.0, 0.0])];
        Self { origin, axis, radius, angle, tangent: angle.tan(), across }
    }

    /// Returns the radius of the cross section at a distance along the axis, negative behind a focus.
    pub fn signed_radius(&self, t: f64) -> f64 {
        self.radius + t * self.tangent
    }

    /// Returns the ray at a place of the disc.
    pub fn ray(&self, [x, y]: [f64; 2]) -> Ray<f64> {
        if x == 0.0 && y == 0.0 {
            return Ray::new(self.origin, self.axis);
        }
        let [right, up] = self.across;
        let aside = right * x + up * y;
        Ray::new(self.origin + aside * self.radius, (self.axis + aside * self.tangent).normalize())
    }

    /// Returns the place of a vector across the axis.
    fn components(&self, vector: Vec3<f64>) -> [f64; 2] {
        self.across.map(|axis| axis.dot(vector))
    }

    /// Returns where the ray to a place ahead is named.
    pub fn toward(&self, place: Vec3<f64>) -> [f64; 2] {
        let way = place - self.origin;
        let own = self.signed_radius(way.dot(self.axis).max(0.0));
        if own == 0.0 { [0.0; 2] } else { self.components(way).map(|side| side / own) }
    }

    /// Returns whether a thing within a sphere may be in the cone.
    pub fn may_meet(&self, center: Vec3<f64>, radius: f64) -> bool {
        let way = center - self.origin;
        let along = way.dot(self.axis);
        if along + radius <= 0.0 {
            return false;
        }
        let apart = (way - self.axis * along).length();
        // A cross section may be wider at either end of the thing.
        let wide = self.signed_radius((along - radius).max(0.0)).abs();
        let wider = self.signed_radius(along + radius).abs();
        apart - radius < wide.max(wider)
    }

    /// Returns what a sphere covers: a disc of its radius in the cross section next to its centre.
    pub fn sphere(&self, center: Vec3<f64>, radius: f64) -> Option<Covered> {
        let way = center - self.origin;
        let along = way.dot(self.axis);
        if along + radius <= 0.0 {
            return None;
        }
        let [x, y] = self.components(way - self.axis * along);
        let (apart, own) = (x.hypot(y), self.signed_radius(along.max(0.0)));
        if way.length() <= radius || (own == 0.0 && apart < radius) {
            return Some(Covered::WHOLE);
        }
        if own == 0.0 || apart >= own.abs() + radius {
            return None;
        }
        let part = lens(own.abs(), radius, apart);
        // The middle of what both have of the line through their centres.
        let [near, far] = [((apart - radius) / own.abs()).max(-1.0), ((apart + radius) / own.abs()).min(1.0)];
        let middle = f64::midpoint(near, far) * own.signum();
        let direction = if apart > 0.0 { [x / apart, y / apart] } else { [0.0; 2] };
        Covered::new(part, direction.map(|side| side * middle))
    }

    /// Returns what a plane covers whose unit normal is `normal` and above which the cone begins at `height`, on either side: all rays that
    /// lead to it, on one side of its horizon.
    pub fn plane(&self, normal: UnitVec3<f64>, height: f64) -> Option<Covered> {
        let normal = if height < 0.0 { -normal } else { normal };
        let rise = normal.dot(self.axis);
        let [x, y] = self.components(normal).map(|side| side * self.tangent);
        let slope = x.hypot(y);
        if slope == 0.0 {
            return (rise < 0.0 && height != 0.0).then_some(Covered::WHOLE);
        }
        let horizon = rise / slope;
        let part = seg(horizon);
        if height == 0.0 || part <= 0.0 {
            return None;
        }
        // The centroid of a segment of the disc.
        let middle = -2.0 * (1.0 - horizon * horizon).max(0.0).powf(1.5) / (3.0 * PI * part);
        Covered::new(part, [x, y].map(|side| side / slope * middle))
    }

    /// Returns what a convex polygon covers.
    pub fn polygon<const N: usize>(&self, corners: [Vec3<f64>; N]) -> Option<Covered> {
        let seen = corners.map(|corner| {
            let way = corner - self.origin;
            let along = way.dot(self.axis);
            let [x, y] = self.components(way - self.axis * along);
            [x, y, self.signed_radius(along), along]
        });
        Polygon::seen(&seen).covered()
    }

    /// Returns the cone that a surface makes of this one at the distance `t`: from `origin` on along `axis`.
    pub fn after(&self, t: f64, bend: Bend, origin: Vec3<f64>, axis: UnitVec3<f64>) -> Self {
        let own = self.signed_radius(t);
        // Behind a focus it widens again.
        let angle = if own < 0.0 { self.angle.abs() } else { self.angle };
        let spread = bend.spread(angle, own.abs());
        Self::new(origin, axis, own.abs(), spread.mean)
    }
}

/// What a surface does with a cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bend {
    /// Its radius of curvature, negative where it is seen from inside, infinite where it is flat.
    pub curvature: f64,
    /// Cosine of the angle of incidence, above 0.
    pub cosine: f64,
    /// Of a refracted cone, the index of refraction where it comes from over that where it goes, and the cosine of the angle of refraction.
    pub refracted: Option<(f64, f64)>,
    /// By how much the surface's roughness widens it, in radians.
    pub gloss: f64,
}

/// The half angle of a cone that a surface reflects or refracts, in radians, in two directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Across the plane of incidence.
    pub across: f64,
    /// In the plane of incidence.
    pub along: f64,
    /// Of the circular cone that takes the place of the two.
    pub mean: f64,
}

impl Bend {
    /// Returns the spread of a cone of the half angle `angle`, in radians, whose cross section at the surface has the radius `radius`.
    ///
    /// A mirror turns its normals by `radius / K` across the beam and by `radius / (K cos)` along it, and what it reflects by twice that; of
    /// what is added, the geometric mean of both is taken, which does not depend on the angle. Of refracted cones it is the mean of both.
    pub fn spread(&self, angle: f64, radius: f64) -> Spread {
        let cosine = self.cosine.max(1e-3);
        let turned = radius / self.curvature;
        let (across, along, mean) = match self.refracted {
            None => (angle + 2.0 * cosine * turned, angle + 2.0 * turned / cosine, angle + 2.0 * turned),
            Some((eta, refracted)) => {
                let refracted = refracted.max(1e-3);
                let ratio = eta * cosine / refracted;
                let across = eta * angle + (eta * cosine - refracted) * turned;
                let along = ratio * angle + (ratio - 1.0) * turned / cosine;
                (across, along, f64::midpoint(across, along))
            }
        };
        let mean = if mean < 0.0 { mean - self.gloss } else { mean + self.gloss };
        Spread { across, along, mean: mean.clamp(-FRAC_PI_2, FRAC_PI_2) }
    }
}

#[cfg(test)]
mod tests;
