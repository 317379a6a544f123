//! An independent renderer of NFF, written from documents alone: the format's text, the formula of the illumination model
//! `phong` and the ray tree of the thesis's model. It shares nothing with the tracer or its readers, and computes all in `f64`.
//!
//! # The rules
//! - **View.** `angle` lies between the centres of the first and the last row of pixels; pixels are square. `hither` cuts nothing off.
//! - **Light.** A lamp is a point, as bright as it says at any distance; one without a colour has 1/sqrt(n), where n is the number
//!   of all lamps. There is no ambient light, and lamps are not seen.
//! - **Surfaces** are seen from both sides and are thin: cones have no caps. A sphere with a negative radius, and a cone of which no
//!   radius is positive, are there for rays from inside alone, also for those to a lamp.
//! - **Polygons** (`p`) are what their outline winds around (the non-zero rule).
//! - **Radiance** that a ray brings, with C the fill's colour, N the unit normal on the ray's side, L the unit vector to a lamp
//!   of colour E, V that to the ray's origin and R = 2 (N.L) N - L:
//!   `sum S E [Kd C (N.L) + Ks max(0, R.V)^Shine] + Ks I_reflected + T I_transmitted`, summed over the lamps with N.L > 0.
//! - **Shadows.** S is the product of T over all surfaces between the place and the lamp, once for each object, straight on.
//! - **Transmission** after Snell; inside is where the outward normal points away from: a sphere's inside, a cone's axis, the side
//!   from which a polygon is clockwise. An index of 0 is one of 1. In total internal reflection the weight T goes to the
//!   reflected ray.
//! - **Ray tree.** An eye ray has depth 0, and a ray of the largest depth spawns no other.
//! - **Patches** (`pp`) are cut to triangles from the first corner on, each an object, which mixes the normals of its corners. The
//!   mixed normal shades and bends rays; where the ray sees it from behind, the triangle's own does. A reflected ray that
//!   would lead behind the triangle is mirrored at it, and so is a transmitted one that would stay before it. A lamp behind
//!   the triangle gives nothing.

use crossing::{Crossing, Departure, Ray};
use search::Boxes;

use super::Color;
use super::vector::{Vector, cross, difference, dot, largest, length, product, scale, sum, unit};

mod crossing;
mod scene;
mod search;
mod shape;
#[cfg(test)]
mod tests;
mod tube;

pub use scene::{Scene, read};

/// Hits of other objects that are nearer than this share of the scene's size do not count: where two surfaces touch,
/// rounding decides which is first.
const TOUCHING: f64 = 1e-12;

/// Returns a picture of the size that the scene asks for, in linear RGB that is not clamped, row by row from the top. A ray of
/// depth `depth` spawns no other.
#[must_use]
pub fn render(scene: &Scene, depth: u32) -> Vec<Color> {
    let oracle = Oracle::new(scene, depth);
    let view = &scene.view;
    let forward = unit(difference(view.at, view.from));
    let right = unit(cross(forward, view.up));
    let up = cross(right, forward);
    let [width, height] = view.resolution;
    let pitch = 2.0 * (view.angle.to_radians() / 2.0).tan() / (height as f64 - 1.0);
    let centered = |number: usize, count: usize| (number as f64 - (count as f64 - 1.0) / 2.0) * pitch;
    let mut picture = Vec::with_capacity(width * height);
    for j in 0..height {
        for i in 0..width {
            let (x, y) = (centered(i, width), -centered(j, height));
            let direction = unit(sum([forward, scale(x, right), scale(y, up)]));
            picture.push(oracle.trace(Ray { origin: view.from, direction }, None, 0));
        }
    }
    picture
}

/// The object that a ray starts on, by number, and to which side it goes.
type Left = Option<(usize, Departure)>;

struct Oracle<'a> {
    scene: &'a Scene,
    boxes: Boxes,
    /// The least distance of a hit.
    least: f64,
    max_depth: u32,
}

impl<'a> Oracle<'a> {
    fn new(scene: &'a Scene, max_depth: u32) -> Self {
        let bounds: Vec<_> = scene.objects.iter().map(|object| object.shape.bounds()).enumerate().collect();
        let ends = bounds.iter().flat_map(|(_, bounds)| bounds);
        let size = ends.fold(largest(scene.view.from), |size, end| size.max(largest(*end)));
        let least = TOUCHING * size;
        Self { scene, boxes: Boxes::new(bounds, least), least, max_depth }
    }

    /// Returns the radiance that a ray brings.
    fn trace(&self, ray: Ray, left: Left, depth: u32) -> Color {
        let Some((number, crossing)) = self.nearest(ray, left) else { return self.scene.background };
        let Some(object) = self.scene.objects.get(number) else { return self.scene.background };
        let fill = &object.fill;
        let Crossing { t, outward, shading } = crossing;
        let going_in = dot(outward, ray.direction) < 0.0;
        let to_ray = |normal| if going_in { normal } else { scale(-1.0, normal) };
        let (flat, normal) = (to_ray(outward), facing(to_ray(shading), to_ray(outward), ray.direction));
        let place = sum([ray.origin, scale(t, ray.direction)]);
        let leaving = |direction: Vector| {
            let departure = if dot(direction, outward) > 0.0 { Departure::Out } else { Departure::In };
            (Ray { origin: place, direction }, Some((number, departure)))
        };

        let mut light = [0.0; 3];
        for lamp in &self.scene.lamps {
            let to_lamp = difference(lamp.position, place);
            let toward = unit(to_lamp);
            let cosine = dot(normal, toward);
            if cosine <= 0.0 || dot(flat, toward) <= 0.0 {
                continue;
            }
            let (shadow_ray, left) = leaving(toward);
            let share = self.arriving(shadow_ray, left, length(to_lamp));
            let mirrored = -dot(mirror(scale(-1.0, toward), normal), ray.direction);
            let highlight = if mirrored > 0.0 { fill.ks * mirrored.powf(fill.shine) } else { 0.0 };
            let surface = fill.color.map(|part| fill.kd * part * cosine + highlight);
            light = sum([light, scale(share, product(lamp.color, surface))]);
        }
        if depth >= self.max_depth {
            return light;
        }
        let bring = |weight: f64, direction: Vector| {
            let (ray, left) = leaving(unit(direction));
            scale(weight, self.trace(ray, left, depth + 1))
        };
        let mut reflected = mirror(ray.direction, normal);
        if dot(reflected, flat) < 0.0 {
            reflected = mirror(reflected, flat);
        }
        let mut reflected_weight = fill.ks;
        if fill.kt > 0.0 {
            let eta = if going_in { 1.0 / fill.ior } else { fill.ior };
            let cos_i = -dot(normal, ray.direction);
            let radicand = 1.0 + eta * eta * (cos_i * cos_i - 1.0);
            if radicand < 0.0 {
                reflected_weight += fill.kt;
            } else {
                let along = scale(eta * cos_i - radicand.sqrt(), normal);
                let mut transmitted = sum([scale(eta, ray.direction), along]);
                if dot(transmitted, flat) > 0.0 {
                    transmitted = mirror(transmitted, flat);
                }
                light = sum([light, bring(fill.kt, transmitted)]);
            }
        }
        if reflected_weight > 0.0 {
            light = sum([light, bring(reflected_weight, reflected)]);
        }
        light
    }

    /// Returns the share of a lamp's light that arrives along a ray to it.
    fn arriving(&self, ray: Ray, left: Left, distance: f64) -> f64 {
        let mut share = 1.0;
        self.boxes.visit(ray, &mut distance.clone(), &mut |number| {
            let Some(object) = self.scene.objects.get(number) else { return distance };
            let crossings = object.shape.crossings(ray, departure(left, number));
            if crossings.iter().flatten().any(|crossing| crossing.t > self.least && crossing.t < distance) {
                share *= object.fill.kt;
            }
            if share == 0.0 { 0.0 } else { distance }
        });
        share
    }

    /// Returns the nearest crossing of a ray, and the number of the object.
    fn nearest(&self, ray: Ray, left: Left) -> Option<(usize, Crossing)> {
        let mut nearest: Option<(usize, Crossing)> = None;
        let mut before = f64::INFINITY;
        self.boxes.visit(ray, &mut before, &mut |number| {
            let crossings = self
                .scene
                .objects
                .get(number)
                .map(|object| object.shape.crossings(ray, departure(left, number)));
            for crossing in crossings.into_iter().flatten().flatten() {
                if crossing.t > self.least && nearest.is_none_or(|(_, nearest)| crossing.t < nearest.t) {
                    nearest = Some((number, crossing));
                }
            }
            nearest.map_or(f64::INFINITY, |(_, nearest)| nearest.t)
        });
        nearest
    }
}

/// Returns how a ray left this object, if it did.
fn departure(left: Left, number: usize) -> Option<Departure> {
    left.filter(|(object, _)| *object == number).map(|(_, departure)| departure)
}

/// Returns the mixed normal, or the flat one where the ray sees the mixed one from behind.
fn facing(mixed: Vector, flat: Vector, direction: Vector) -> Vector {
    if dot(mixed, direction) < 0.0 { mixed } else { flat }
}

/// Returns a direction mirrored at a plane with this normal.
fn mirror(direction: Vector, normal: Vector) -> Vector {
    sum([direction, scale(-2.0 * dot(normal, direction), normal)])
}
