//! Where a ray meets a sphere, a flat polygon and a triangle with normals at its corners.

use super::super::vector::{Vector, cross, difference, dot, length, scale, sum, unit};
use super::crossing::{Crossing, Crossings, Departure, Ray, around, departed};
use super::tube::Tube;

pub(super) enum Shape {
    Ball(Ball),
    Tube(Tube),
    Outline(Outline),
    Triangle(Triangle),
}

impl Shape {
    /// Returns the crossings of a ray with the surface. A ray that `left` this very surface does not meet it where it
    /// starts: out of a convex body it never comes back, into it it meets the far side, and a plane it leaves for good.
    /// So no distance has to be small.
    pub(super) fn crossings(&self, ray: Ray, left: Option<Departure>) -> Crossings {
        match self {
            Self::Ball(ball) => ball.crossings(ray, left),
            Self::Tube(tube) => tube.crossings(ray, left),
            Self::Outline(_) | Self::Triangle(_) if left.is_some() => [None; 2],
            Self::Outline(outline) => [outline.crossing(ray), None],
            Self::Triangle(triangle) => [triangle.crossing(ray), None],
        }
    }

    /// Returns the two opposite corners of a box around the surface.
    pub(super) fn bounds(&self) -> [Vector; 2] {
        match self {
            Self::Ball(Ball { center, radius, .. }) => {
                [center.map(|part| part - radius), center.map(|part| part + radius)]
            }
            Self::Tube(tube) => tube.bounds(),
            Self::Outline(outline) => around(&outline.corners),
            Self::Triangle(triangle) => around(&triangle.corners),
        }
    }
}

pub(super) struct Ball {
    pub(super) center: Vector,
    pub(super) radius: f64,
    /// Whether it is there for rays from inside alone.
    pub(super) inside_only: bool,
}

impl Ball {
    fn crossings(&self, ray: Ray, left: Option<Departure>) -> Crossings {
        // The foot of the perpendicular from the centre, at which nothing large cancels.
        let from_center = difference(ray.origin, self.center);
        let along = -dot(from_center, ray.direction);
        let foot = sum([from_center, scale(along, ray.direction)]);
        let off = length(foot);
        if off >= self.radius {
            return [None; 2];
        }
        let half = ((self.radius - off) * (self.radius + off)).sqrt();
        departed([-half, half], along, left).map(|root| {
            let root = root?;
            let outward = unit(sum([foot, scale(root, ray.direction)]));
            let is_there = !(self.inside_only && dot(outward, ray.direction) < 0.0);
            is_there.then_some(Crossing { t: along + root, outward, shading: outward })
        })
    }
}

/// An area that is smaller than this share of the largest between two sides is 0 but for rounding.
const FLAT: f64 = 1e-9;

/// A flat polygon, convex or not: it is what its outline winds around (the non-zero rule).
pub(super) struct Outline {
    corners: Vec<Vector>,
    center: Vector,
    normal: Vector,
    /// Two directions across the normal.
    across: [Vector; 2],
}

impl Outline {
    /// Returns the polygon; nothing where it has no area.
    pub(super) fn new(corners: Vec<Vector>) -> Option<Self> {
        let share = 1.0 / corners.len() as f64;
        let center = corners.iter().fold([0.0; 3], |so_far, corner| sum([so_far, scale(share, *corner)]));
        let sides = || edges(&corners).map(|(from, to)| difference(to, from));
        let crosses = sides().flat_map(|one| sides().map(move |other| cross(one, other)));
        let steepest = crosses.max_by(|one, other| length(*one).total_cmp(&length(*other)))?;
        // Newell's normal: the sum of the corners' cross products. It is 0 for an even bow tie, which has two sides alike.
        let newell = edges(&corners).fold([0.0; 3], |so_far, (from, to)| {
            sum([so_far, cross(difference(from, center), difference(to, center))])
        });
        let normal = unit(if length(newell) > FLAT * length(steepest) { newell } else { steepest });
        let [x, y, z] = normal.map(f64::abs);
        let least = if x <= y && x <= z {
            [1.0, 0.0, 0.0]
        } else if y <= z {
            [0.0, 1.0, 0.0]
        } else {
            [0.0, 0.0, 1.0]
        };
        let u = unit(cross(normal, least));
        let outline = Self { corners, center, normal, across: [u, cross(normal, u)] };
        outline.normal.iter().all(|part| part.is_finite()).then_some(outline)
    }

    fn crossing(&self, ray: Ray) -> Option<Crossing> {
        let slope = dot(self.normal, ray.direction);
        let to_center = difference(self.center, ray.origin);
        let t = dot(self.normal, to_center) / slope;
        if !t.is_finite() {
            return None;
        }
        let place = difference(scale(t, ray.direction), to_center);
        let flat = |corner| {
            let from_place = difference(difference(corner, self.center), place);
            self.across.map(|axis| dot(axis, from_place))
        };
        // An edge counts where it goes through the half line u > 0, v = 0.
        let winding: i32 = edges(&self.corners)
            .map(|(from, to)| {
                let ([u0, v0], [u1, v1]) = (flat(from), flat(to));
                let turn = (u0 * v1 - u1 * v0) * (v1 - v0);
                match (v0 <= 0.0, v1 <= 0.0) {
                    (true, false) if turn > 0.0 => 1,
                    (false, true) if turn > 0.0 => -1,
                    _ => 0,
                }
            })
            .sum();
        (winding != 0).then_some(Crossing { t, outward: self.normal, shading: self.normal })
    }
}

/// Returns the edges of a closed outline.
fn edges(corners: &[Vector]) -> impl Iterator<Item = (Vector, Vector)> {
    corners.iter().copied().zip(corners.iter().copied().cycle().skip(1))
}

/// A triangle with a normal at each corner, which are mixed between them.
pub(super) struct Triangle {
    corners: [Vector; 3],
    normals: [Vector; 3],
    /// Of the side that it is counter-clockwise from.
    outward: Vector,
}

impl Triangle {
    /// Returns the triangle; nothing where it has no area.
    pub(super) fn new(corners: [Vector; 3], normals: [Vector; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let outward = unit(cross(difference(b, a), difference(c, a)));
        outward.iter().all(|part| part.is_finite()).then_some(Self {
            corners,
            normals: normals.map(unit),
            outward,
        })
    }

    fn crossing(&self, ray: Ray) -> Option<Crossing> {
        let [a, b, c] = self.corners.map(|corner| difference(corner, ray.origin));
        // Six times the volumes between the ray and the edges; of a shared edge it is the same number with the other sign.
        let volume = |from, to| dot(ray.direction, cross(from, to));
        let weights = [volume(b, c), volume(c, a), volume(a, b)];
        let is_within = weights.iter().all(|w| *w >= 0.0) || weights.iter().all(|w| *w <= 0.0);
        let whole: f64 = weights.iter().sum();
        if !is_within || whole == 0.0 {
            return None;
        }
        let t = dot(self.outward, a) / dot(self.outward, ray.direction);
        let [u, v, w] = weights.map(|weight| weight / whole);
        let [p, q, r] = self.normals;
        let mixed = unit(sum([scale(u, p), scale(v, q), scale(w, r)]));
        t.is_finite().then_some(Crossing { t, outward: self.outward, shading: mixed })
    }
}
