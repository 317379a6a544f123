//! Where a ray meets a cone or cylinder between two points, which has no end caps.

use super::super::vector::{Vector, cross, difference, dot, length, scale, sum, unit};
use super::crossing::{Crossing, Crossings, Departure, Ray, around, departed};

pub(super) struct Tube {
    ends: [Vector; 2],
    radii: [f64; 2],
    center: Vector,
    /// From the base to the apex, of length 1.
    axis: Vector,
    half_height: f64,
    /// Growth of the radius for each unit along the axis.
    slope: f64,
    /// Whether it is there for rays from inside alone.
    inside_only: bool,
}

impl Tube {
    /// Returns the tube; negative radii make one that is seen from inside alone. Nothing where it has no height.
    pub(super) fn new(ends: [Vector; 2], radii: [f64; 2]) -> Option<Self> {
        let inside_only = radii.iter().all(|radius| *radius <= 0.0) && radii != [0.0; 2];
        let radii = radii.map(f64::abs);
        let [base, apex] = ends;
        let height = length(difference(apex, base));
        (height > 0.0).then(|| Self {
            ends,
            radii,
            center: scale(0.5, sum([base, apex])),
            axis: unit(difference(apex, base)),
            half_height: 0.5 * height,
            slope: (radii[1] - radii[0]) / height,
            inside_only,
        })
    }

    pub(super) fn bounds(&self) -> [Vector; 2] {
        let [[base_low, base_high], [apex_low, apex_high]] = [0, 1].map(|end: usize| {
            let (center, radius) =
                if end == 0 { (self.ends[0], self.radii[0]) } else { (self.ends[1], self.radii[1]) };
            [center.map(|part| part - radius), center.map(|part| part + radius)]
        });
        around(&[base_low, base_high, apex_low, apex_high])
    }

    /// Returns where the ray goes through the wall.
    ///
    /// Everything is measured from the foot of the perpendicular that falls on the ray from the tube's centre. Across the
    /// axis the ray is `x + s y`, and with `e` along `y` its place is `B + k s` along `e` and `H` beside it; the radius
    /// there is `g + m s`. The wall is where `(B + k s)^2 + H^2 = (g + m s)^2`. Its discriminant, with all that cancels
    /// cancelled by hand, is `(k g - m B)^2 - (k^2 - m^2) H^2`, which knows neither the distance of the ray nor the tube's length:
    /// a tube may be as slim as a hair.
    pub(super) fn crossings(&self, ray: Ray, left: Option<Departure>) -> Crossings {
        let (axis, direction) = (self.axis, ray.direction);
        let from_center = difference(ray.origin, self.center);
        let start = -dot(from_center, direction);
        let foot = sum([from_center, scale(start, direction)]);
        let split = |vector: Vector| {
            let along = dot(vector, axis);
            (along, difference(vector, scale(along, axis)))
        };
        let ((foot_along, x), (direction_along, y)) = (split(foot), split(direction));
        let k = length(y);
        // Along the axis any direction across it will do; a ray on the axis itself meets no wall but an apex.
        let e = if k > 0.0 { scale(1.0 / k, y) } else { unit(x) };
        if e[0].is_nan() {
            return [None; 2];
        }
        let (b, h) = (dot(x, e), dot(x, cross(axis, e)));
        let g = 0.5 * (self.radii[0] + self.radii[1]) + self.slope * foot_along;
        let m = self.slope * direction_along;
        let Some(roots) = roots(k, m, b, h, g) else { return [None; 2] };
        departed(roots, start, left).map(|s| {
            let s = s?;
            let radial = sum([x, scale(s, y)]);
            let is_between = (foot_along + s * direction_along).abs() <= self.half_height;
            let outward = unit(difference(unit(radial), scale(self.slope, axis)));
            let is_there = is_between
                && g + m * s >= 0.0
                && outward[0].is_finite()
                && !(self.inside_only && dot(outward, direction) < 0.0);
            is_there.then_some(Crossing { t: start + s, outward, shading: outward })
        })
    }
}

/// Returns the roots of `(b + k s)^2 + h^2 = (g + m s)^2`.
fn roots(k: f64, m: f64, b: f64, h: f64, g: f64) -> Option<[f64; 2]> {
    let square = (k - m) * (k + m);
    let middle = k * g - m * b;
    let discriminant = if square > 0.0 {
        let side = square.sqrt() * h;
        (middle - side) * (middle + side)
    } else {
        middle * middle - square * h * h
    };
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    let linear = b * k - g * m;
    let roots = if square.abs() > (k * k + m * m) / 16.0 {
        [(-linear - root) / square, (-linear + root) / square]
    } else {
        // Nearly along the wall, where one root is far away: the product of the two, without cancellation.
        let q = -(linear + root.copysign(linear));
        [q / square, ((b - g) * (b + g) + h * h) / q]
    };
    Some(roots)
}
