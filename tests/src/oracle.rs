//! Independent renderers in `f64`, to judge the tracer by: of the thesis's scenes here, and of NFF in [`nff`].
//!
//! It is written from the model's text alone and shares no code with the core: recursion, the general quadric
//! a(x-x0)^2 + b(y-y0)^2 + c(z-z0)^2 + d = 0 for every primitive, schoolbook roots, nothing clever and nothing
//! fast. Where it and the tracer differ, one of them has misread the model.

use rta_scenes::description::{Description, Surface};

use vector::{Vector, cross, difference, dot, largest, product, scale, sum, unit};

pub mod nff;
#[cfg(test)]
mod tests;
mod vector;

type Color = [f64; 3];

/// The model's k1 and k2: a surface takes `(n.z + k1) k2` of the ambient light, where n is its normal.
const AMBIENT: (f64, f64) = (1.5, 0.4);
/// Half of a highlight's opening angle, in degrees.
const HIGHLIGHT_DEGREES: f64 = 13.0;
/// Side of a floor tile where a scene says nothing else, in units of length.
const TILE: f64 = 3.0;
/// A hit that is nearer than this share of the scene's size is taken for the surface that the ray leaves.
const SELF_HIT: f64 = 1e-10;

/// Returns a picture of `width` x `height` pixels for a screen of shape `aspect` : 1, in linear RGB that is not
/// clamped, row by row from the top; nothing if the direction of view is zero. A ray of depth `depth` spawns no other.
#[must_use]
pub fn render(scene: &Description, width: usize, height: usize, aspect: f64, depth: u32) -> Vec<Color> {
    let Some(forward) = scene.camera.direction() else { return Vec::new() };
    let oracle = Oracle::new(scene, depth);
    // Of a direction of view that is vertical, "right" is x.
    let right = if forward[0] == 0.0 && forward[1] == 0.0 {
        [1.0, 0.0, 0.0]
    } else {
        unit(cross(forward, [0.0, 0.0, 1.0]))
    };
    let up = cross(right, forward);
    let mut picture = Vec::with_capacity(width * height);
    for j in 0..height {
        for i in 0..width {
            let x = (i as f64 + 0.5) / width as f64 - 0.5;
            let y = (0.5 - (j as f64 + 0.5) / height as f64) / aspect;
            let direction = sum([scale(scene.camera.focal, forward), scale(x, right), scale(y, up)]);
            picture.push(oracle.trace(scene.camera.eye, unit(direction), 0));
        }
    }
    picture
}

/// Returns the radiance along the ray from `origin` in `direction`, which has any length but zero.
#[must_use]
pub fn radiance(scene: &Description, origin: [f64; 3], direction: [f64; 3], depth: u32) -> [f64; 3] {
    Oracle::new(scene, depth).trace(origin, unit(direction), 0)
}

/// The surface a(x-x0)^2 + b(y-y0)^2 + c(z-z0)^2 + d = 0.
struct Quadric {
    center: Vector,
    abc: [f64; 3],
    d: f64,
    color: Color,
    surface: Surface,
}

struct Hit {
    t: f64,
    point: Vector,
    /// Outward normal, of length 1.
    outward: Vector,
    color: Color,
    /// `None` for a lamp, whose colour is its radiance.
    surface: Option<Surface>,
}

struct Oracle<'a> {
    scene: &'a Description,
    objects: Vec<Quadric>,
    lamps: Vec<Quadric>,
    /// Largest coordinate of anything in the scene.
    size: f64,
    max_depth: u32,
}

impl<'a> Oracle<'a> {
    fn new(scene: &'a Description, max_depth: u32) -> Self {
        let mut objects = Vec::new();
        let mut size = largest(scene.camera.eye);
        for c in &scene.cylinders {
            let quadric = Quadric::new(c.position, [1.0, 1.0, 0.0], -c.radius * c.radius, c.color, c.surface);
            objects.push(quadric);
            size = size.max(largest(c.position) + c.radius);
        }
        for e in &scene.ellipsoids {
            let abc = e.radii.map(|radius| 1.0 / (radius * radius));
            objects.push(Quadric::new(e.position, abc, -1.0, e.color, e.surface));
            size = size.max(largest(e.position) + largest(e.radii));
        }
        for s in &scene.spheres {
            objects.push(Quadric::new(s.position, [1.0; 3], -s.radius * s.radius, s.color, s.surface));
            size = size.max(largest(s.position) + s.radius);
        }
        let mut lamps = Vec::new();
        for l in &scene.lamps {
            size = size.max(largest(l.position) + l.radius);
            if l.radius > 0.0 {
                let square = l.radius * l.radius;
                lamps.push(Quadric::new(
                    l.position,
                    [1.0; 3],
                    -square,
                    scale(1.0 / square, l.color),
                    Surface::Opaque,
                ));
            }
        }
        Self { scene, objects, lamps, size, max_depth }
    }

    /// Returns the least t that counts as a hit of a ray from `origin`.
    fn least(&self, origin: Vector) -> f64 {
        SELF_HIT * self.size.max(largest(origin))
    }

    /// Returns the radiance along a ray; `direction` has length 1.
    fn trace(&self, origin: Vector, direction: Vector, depth: u32) -> Color {
        let Some(hit) = self.nearest(origin, direction) else {
            let s = direction[2] * direction[2];
            return sum([scale(1.0 - s, self.scene.sky.horizon), scale(s, self.scene.sky.zenith)]);
        };
        let Some(surface) = hit.surface else { return hit.color };

        let going_in = dot(hit.outward, direction) < 0.0;
        let normal = if going_in { hit.outward } else { scale(-1.0, hit.outward) };
        let reflected = sum([direction, scale(-2.0 * dot(normal, direction), normal)]);
        let bring = |along: Vector| {
            if depth < self.max_depth { self.trace(hit.point, unit(along), depth + 1) } else { [0.0; 3] }
        };
        match surface {
            Surface::Opaque | Surface::Shiny => {
                self.lit(hit.point, normal, reflected, hit.color, surface == Surface::Shiny)
            }
            Surface::Mirror => product(bring(reflected), hit.color),
            Surface::Transparent { ks, kt, ior } => {
                let i_ref = bring(reflected);
                let eta = if going_in { 1.0 / ior } else { ior };
                let cos_i = -dot(normal, direction);
                let radicand = 1.0 + eta * eta * (cos_i * cos_i - 1.0);
                let i_tra = if radicand < 0.0 {
                    i_ref
                } else {
                    bring(sum([scale(eta, direction), scale(eta * cos_i - radicand.sqrt(), normal)]))
                };
                sum([scale(ks, product(i_ref, hit.color)), scale(kt, i_tra)])
            }
            // Scenes in NFF have another model, and an oracle of their own.
            Surface::Finish { .. } | Surface::Of(_) => [0.0; 3],
        }
    }

    /// Returns the term with kd: ambient light and the light of each lamp.
    fn lit(&self, point: Vector, normal: Vector, reflected: Vector, color: Color, shiny: bool) -> Color {
        let (k1, k2) = AMBIENT;
        let mut light = scale((normal[2] + k1) * k2, product(self.scene.ambient, color));
        for lamp in &self.scene.lamps {
            let to_lamp = difference(lamp.position, point);
            let distance = dot(to_lamp, to_lamp).sqrt();
            let lp = unit(to_lamp);
            let cosine = dot(lp, normal);
            if cosine > 0.0 {
                let s = self.arriving(point, lp, distance);
                let highlight = shiny && dot(lp, reflected) > HIGHLIGHT_DEGREES.to_radians().cos();
                let share = if highlight { [1.0; 3] } else { scale(cosine / (distance * distance), color) };
                light = sum([light, scale(s, product(share, lamp.color))]);
            }
        }
        light
    }

    /// Returns S_n: the share of a lamp's light that arrives at `point`.
    fn arriving(&self, point: Vector, to_lamp: Vector, distance: f64) -> f64 {
        let least = self.least(point);
        let between = |t: f64| t > least && t < distance - least;
        if self.floor_root(point, to_lamp).is_some_and(between) {
            return 0.0;
        }
        let mut share = 1.0;
        for object in &self.objects {
            if object.roots(point, to_lamp).into_iter().flatten().any(between) {
                share *= match object.surface {
                    Surface::Transparent { kt, .. } => kt,
                    _ => 0.0,
                };
            }
        }
        share
    }

    fn nearest(&self, origin: Vector, direction: Vector) -> Option<Hit> {
        let least = self.least(origin);
        let mut nearest: Option<Hit> = None;
        let nearer =
            |t: f64, nearest: &Option<Hit>| t > least && nearest.as_ref().is_none_or(|hit| t < hit.t);
        for (object, is_lamp) in self
            .objects
            .iter()
            .map(|object| (object, false))
            .chain(self.lamps.iter().map(|lamp| (lamp, true)))
        {
            for t in object.roots(origin, direction).into_iter().flatten() {
                if nearer(t, &nearest) {
                    let point = sum([origin, scale(t, direction)]);
                    let outward = object.outward(point);
                    let surface = (!is_lamp).then_some(object.surface);
                    nearest = Some(Hit { t, point, outward, color: object.color, surface });
                }
            }
        }
        if let (Some(floor), Some(t)) = (&self.scene.floor, self.floor_root(origin, direction))
            && nearer(t, &nearest)
        {
            let [x, y, _] = sum([origin, scale(t, direction)]);
            let tile = self.scene.details.tile.unwrap_or(TILE);
            let even = ((x / tile).floor() + (y / tile).floor()).rem_euclid(2.0) == 0.0;
            let color = if even { floor.colors[0] } else { floor.colors[1] };
            let surface = Some(Surface::Opaque);
            nearest = Some(Hit { t, point: [x, y, 0.0], outward: [0.0, 0.0, 1.0], color, surface });
        }
        nearest
    }

    /// Returns the t at which a ray meets the plane z = 0, if there is a floor.
    fn floor_root(&self, origin: Vector, direction: Vector) -> Option<f64> {
        (self.scene.floor.is_some() && direction[2] != 0.0).then(|| -origin[2] / direction[2])
    }
}

impl Quadric {
    fn new(center: Vector, abc: [f64; 3], d: f64, color: Color, surface: Surface) -> Self {
        Self { center, abc, d, color, surface }
    }

    /// Returns the roots of A t^2 + 2 B t + C = 0, of either sign.
    fn roots(&self, origin: Vector, direction: Vector) -> Option<[f64; 2]> {
        let from_center = difference(origin, self.center);
        let a = dot(self.abc, product(direction, direction));
        let b = dot(self.abc, product(direction, from_center));
        let c = dot(self.abc, product(from_center, from_center)) + self.d;
        let discriminant = b * b - a * c;
        if a == 0.0 || discriminant < 0.0 {
            return None;
        }
        // One root without cancellation, the other from the product of the two, which is C/A.
        let q = -(b + discriminant.sqrt().copysign(b));
        if q == 0.0 { None } else { Some([q / a, c / q]) }
    }

    fn outward(&self, point: Vector) -> Vector {
        unit(product(self.abc, difference(point, self.center)))
    }
}
