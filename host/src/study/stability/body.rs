//! The objects that rays are aimed at: convex ones, and cones and cylinders between two points.

use fastrand::Rng;
use rta_scenes::description::Description;

use super::triple::{Triple, across, add, dot, length, magnitude, sign, signed, sphere, times, unit};

/// An object of a scene that, but for its own inside, no ray that leaves it outwards meets again.
#[derive(Clone, Copy, Debug)]
pub struct Body(Kind);

#[derive(Clone, Copy, Debug)]
enum Kind {
    Round(Round),
    Rod(Rod),
}

impl Body {
    /// Returns the spheres of a scene, its ellipsoids, its vertical cylinders and its cones.
    pub fn all(scene: &Description) -> impl Iterator<Item = Self> {
        let spheres = scene.spheres.iter().map(|s| Round { center: s.position, radii: [s.radius; 3] });
        let ellipsoids = scene.ellipsoids.iter().map(|e| Round { center: e.position, radii: e.radii });
        let cylinders = scene
            .cylinders
            .iter()
            .map(|c| Round { center: c.position, radii: [c.radius, c.radius, f64::INFINITY] });
        let rounds = spheres.chain(ellipsoids).chain(cylinders).map(Kind::Round);
        rounds.chain(Rod::all(scene).map(Kind::Rod)).map(Self)
    }

    /// Returns its largest radius that is finite; of a cone, half of its length where that is more.
    #[must_use]
    pub fn extent(&self) -> f64 {
        match &self.0 {
            Kind::Round(round) => round.extent(),
            Kind::Rod(rod) => (length(rod.axis()) / 2.0).max(rod.radii[0]),
        }
    }

    /// Returns the place of the surface in a direction, seen from the centre in the space where the object is a unit sphere; of a
    /// cone, the place of the side at the height z between its ends and in the direction of x and y about its axis.
    #[must_use]
    pub fn surface(&self, direction: Triple) -> Triple {
        match &self.0 {
            Kind::Round(round) => round.surface(direction),
            Kind::Rod(rod) => rod.surface(direction),
        }
    }

    /// Returns the normal of a sphere where it is halfway between the directions to two places, which are farther away than its
    /// radius.
    #[must_use]
    pub fn mirror(&self, one: Triple, other: Triple) -> Triple {
        // Each step comes nearer by the radius over the distance.
        (0..64).fold([0.0, 0.0, 1.0], |normal, _| {
            let place = self.surface(normal);
            unit(add(unit(add(one, place, -1.0)), unit(add(other, place, -1.0)), 1.0))
        })
    }

    /// Returns whether a place is within the object.
    #[must_use]
    pub fn holds(&self, place: Triple) -> bool {
        match &self.0 {
            Kind::Round(round) => length(round.seen(place)) < 1.0,
            Kind::Rod(rod) => rod.holds(place),
        }
    }

    /// Returns a direction from `eye` that passes the centre at `offset` radii, or an axis between its ends; anywhere, if the eye
    /// is too near for that.
    #[must_use]
    pub fn past(&self, eye: Triple, offset: f64, rng: &mut Rng) -> Triple {
        match &self.0 {
            Kind::Round(round) => round.past(eye, offset, rng),
            Kind::Rod(rod) => rod.past(eye, offset, rng),
        }
    }

    /// Returns a place of the surface near the border between light and dark, on the side of the light, if there is a border.
    #[must_use]
    pub fn border(&self, lamp: Triple, rng: &mut Rng) -> Option<Triple> {
        match &self.0 {
            Kind::Round(round) => round.border(lamp, rng),
            Kind::Rod(rod) => rod.border(lamp, rng),
        }
    }
}

/// The side of a cone, or of a cylinder, between two points.
#[derive(Clone, Copy, Debug)]
pub struct Rod {
    /// Centre of the wider end.
    pub base: Triple,
    /// Centre of the other.
    pub apex: Triple,
    /// Radii there.
    pub radii: [f64; 2],
}

impl Rod {
    /// Returns the cones of a scene.
    pub fn all(scene: &Description) -> impl Iterator<Item = Self> {
        scene.cones.iter().map(|cone| {
            let (base, apex) = ((cone.base, cone.base_radius), (cone.apex, cone.apex_radius));
            let (wide, narrow) = if base.1 < apex.1 { (apex, base) } else { (base, apex) };
            Self { base: wide.0, apex: narrow.0, radii: [wide.1, narrow.1] }
        })
    }

    /// Returns the vector from the centre of the wider end to that of the other.
    #[must_use]
    pub fn axis(&self) -> Triple {
        add(self.apex, self.base, -1.0)
    }

    /// The centre and the radius at a height, 0 at the wider end to 1.
    fn slice(&self, height: f64) -> (Triple, f64) {
        let [wide, narrow] = self.radii;
        (add(self.base, self.axis(), height), wide + (narrow - wide) * height)
    }

    fn surface(&self, direction: Triple) -> Triple {
        let [x, y, z] = direction;
        let (center, radius) = self.slice((z + 1.0) / 2.0);
        let axis = unit(self.axis());
        let u = perpendicular(axis);
        let v = cross(axis, u);
        let length = x.hypot(y).max(1e-9);
        add(add(center, u, radius * x / length), v, radius * y / length)
    }

    fn holds(&self, place: Triple) -> bool {
        let (axis, way) = (self.axis(), add(place, self.base, -1.0));
        let height = dot(way, axis) / dot(axis, axis);
        let (center, radius) = self.slice(height);
        (0.0..=1.0).contains(&height) && length(add(place, center, -1.0)) < radius
    }

    fn past(&self, eye: Triple, offset: f64, rng: &mut Rng) -> Triple {
        let (center, radius) = self.slice(rng.f64());
        let way = add(center, eye, -1.0);
        let side = cross(way, self.axis());
        if length(side) <= 1e-9 * dot(way, way).max(1e-9) {
            return sphere(rng);
        }
        unit(add(way, unit(side), sign(rng) * offset * radius))
    }

    fn border(&self, lamp: Triple, rng: &mut Rng) -> Option<Triple> {
        if self.holds(lamp) {
            return None;
        }
        let (center, radius) = self.slice(rng.f64());
        let axis = unit(self.axis());
        let way = add(lamp, center, -1.0);
        let across = add(way, axis, -dot(way, axis));
        let distance = length(across);
        if distance <= radius {
            return None;
        }
        let towards = unit(across);
        let cosine = (radius / distance + magnitude(rng, -9.0, -1.0)).min(1.0);
        let side = sign(rng) * (1.0 - cosine * cosine).sqrt();
        let normal = add(towards.map(|part| part * cosine), cross(axis, towards), side);
        Some(add(center, normal, radius))
    }
}

fn cross([x, y, z]: Triple, [u, v, w]: Triple) -> Triple {
    [y * w - z * v, z * u - x * w, x * v - y * u]
}

/// A unit vector at right angles to one.
fn perpendicular(axis: Triple) -> Triple {
    let [x, y, z] = axis;
    unit(if z.abs() < 0.9 { [y, -x, 0.0] } else { [0.0, z, -y] })
}

/// A sphere, an ellipsoid or a cylinder, as its centre and radii; a cylinder is seen in the ground plan.
#[derive(Clone, Copy, Debug)]
struct Round {
    /// Centre, or a place on the axis.
    center: Triple,
    /// Half axes; that of a cylinder along z is infinite.
    radii: Triple,
}

impl Round {
    fn extent(&self) -> f64 {
        self.radii.iter().filter(|r| r.is_finite()).fold(0.0, |most, &r| most.max(r))
    }

    fn surface(&self, direction: Triple) -> Triple {
        let [x, y, z] = direction;
        if self.is_cylinder() {
            let length = x.hypot(y).max(1e-9);
            let [rx, ry, _] = self.radii;
            let [cx, cy, cz] = self.center;
            [cx + rx * x / length, cy + ry * y / length, cz + rx * z]
        } else {
            add(self.center, times(self.radii, direction), 1.0)
        }
    }

    /// Returns the vector from the centre to a place, in the space where the object is a unit sphere or a unit circle.
    fn seen(&self, mut place: Triple) -> Triple {
        for ((place, center), radius) in place.iter_mut().zip(self.center).zip(self.radii) {
            *place = (*place - center) / radius; // 0 along an infinite axis
        }
        place
    }

    fn past(&self, eye: Triple, offset: f64, rng: &mut Rng) -> Triple {
        let flat = self.is_cylinder();
        let way = self.seen(eye).map(|part| -part);
        let distance = length(way);
        if distance.is_nan() || distance <= offset {
            return sphere(rng);
        }
        let axis = way.map(|part| part / distance);
        let side = if flat {
            let [x, y, _] = axis;
            if rng.bool() { [-y, x, 0.0] } else { [y, -x, 0.0] }
        } else {
            across(axis, rng)
        };
        let sine = offset / distance;
        let bent = add(axis.map(|part| part * (1.0 - sine * sine).sqrt()), side, sine);
        if flat {
            let [x, y, _] = bent;
            unit([x, y, signed(rng)])
        } else {
            unit(times(bent, self.radii))
        }
    }

    fn border(&self, lamp: Triple, rng: &mut Rng) -> Option<Triple> {
        // In the space where the object is a unit sphere, a tangent from the lamp touches at cos = 1 / distance.
        let way = self.seen(lamp);
        let distance = length(way);
        if distance.is_nan() || distance <= 1.0 {
            return None;
        }
        let axis = way.map(|part| part / distance);
        let cosine = (1.0 / distance + magnitude(rng, -9.0, -1.0)).min(1.0);
        let side = across(axis, rng);
        Some(self.surface(add(axis.map(|part| part * cosine), side, (1.0 - cosine * cosine).sqrt())))
    }

    fn is_cylinder(&self) -> bool {
        self.radii.iter().any(|r| r.is_infinite())
    }
}
