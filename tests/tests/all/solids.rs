//! Cones and triangles against a walk along the ray in f64: where the walk goes through a surface there must be a hit,
//! and where a hit is, there must be the surface, with its normal.

#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use fastrand::Rng;
use rta_core::needs::Everything;
use rta_core::ray::Ray;
use rta_core::shape::SurfacePoint;
use rta_core::vector::{UnitVector, Vector};
use rta_scenes::description::{Camera, Cone, Description, Surface, Triangle};
use rta_scenes::narrow::{Narrowed, narrow};
use rta_tests::measure::{Measure, direction, place, read_direction};

type Triple = [f64; 3];

fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn minus(a: Triple, b: Triple) -> Triple {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn along(a: Triple, d: Triple, t: f64) -> Triple {
    [0, 1, 2].map(|i| a[i] + t * d[i])
}

fn cross(a: Triple, b: Triple) -> Triple {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(v: Triple) -> Triple {
    v.map(|c| c / dot(v, v).sqrt())
}

/// Returns a random place in a cube about 0.
fn within(rng: &mut Rng, half: f64) -> Triple {
    [(); 3].map(|()| half * (2.0 * rng.f64() - 1.0))
}

/// Returns origin and direction of a ray from some distance to a place near an object; one in four starts near it.
fn aim(rng: &mut Rng, center: Triple, size: f64) -> (Triple, Triple) {
    let far = if rng.u8(..4) == 0 { 1.2 * size } else { 30.0 };
    let from = along(center, within(rng, far), 1.0);
    let to = along(center, within(rng, size), 1.0);
    (from, unit(minus(to, from)))
}

/// A ray as the format has rounded it, and its nearest hit: distance, point and normal.
struct Shot {
    origin: Triple,
    direction: Triple,
    hit: Option<(f64, Triple, Triple)>,
}

fn shoot<S: Measure>(scene: &Narrowed<S>, from: Triple, towards: Triple) -> Shot {
    let (d, _) = direction::<S>(towards).normalize().expect("it has a length");
    let ray = Ray::new(place::<S>(from), d);
    let admitted = scene.admit().expect("it fits");
    let read = |v: rta_core::vector::Vec3<S>| [v.x(), v.y(), v.z()].map(S::to_f64);
    let hit = admitted.closest::<Everything>(&ray).map(|hit| {
        let found = admitted.scene.point::<Everything>(hit.object, &ray, hit.distance);
        let (SurfacePoint { distance, point, normal, .. }, _) = found.expect("it is of an object");
        let (search, distance) = (hit.distance.to_f64(), distance.to_f64());
        assert!((search - distance).abs() < 300.0 * S::LENGTH, "{search} and {distance}");
        (search, read(point), read_direction::<S>(normal))
    });
    Shot { origin: read(ray.origin), direction: unit(read_direction::<S>(d)), hit }
}

fn empty() -> Description {
    Description::empty(Camera::upright([0.0; 3], [0.0, 1.0, 0.0], 1.0))
}

const COLOR: Triple = [0.5; 3];
const SURFACE: Surface = Surface::Opaque;

/// A cone in f64: its unit axis and its height.
struct Profile<'a>(&'a Cone, Triple, f64);

impl<'a> Profile<'a> {
    fn new(cone: &'a Cone) -> Self {
        let way = minus(cone.apex, cone.base);
        Self(cone, unit(way), dot(way, way).sqrt())
    }
    /// Returns a place's height over the base, and how far it is outside of the cone's side, at right angles to the
    /// axis.
    fn at(&self, p: Triple) -> (f64, f64) {
        let from = minus(p, self.0.base);
        let z = dot(from, self.1);
        let across = along(from, self.1, -z);
        (z, dot(across, across).sqrt() - self.radius(z))
    }
    fn radius(&self, z: f64) -> f64 {
        self.0.base_radius + (self.0.apex_radius - self.0.base_radius) * z / self.2
    }
    /// Returns how far a place is off the nearest part of the surface; infinity beyond the ends of the cone.
    fn off(&self, p: Triple) -> f64 {
        let (z, outside) = self.at(p);
        let height = self.2;
        let side = if z > -1e-2 && z < height + 1e-2 { outside.abs() } else { f64::INFINITY };
        let disc = |z: f64, radius: f64| {
            if self.0.capped && outside + self.radius(z) < radius + 1e-2 { z.abs() } else { f64::INFINITY }
        };
        side.min(disc(z, self.0.base_radius)).min(disc(z - height, self.0.apex_radius))
    }
}

/// Returns two distances between which the ray surely goes through the cone for the first time.
fn passage(cone: &Cone, from: Triple, d: Triple, sure: f64) -> Option<[f64; 2]> {
    let profile = Profile::new(cone);
    let (center, reach) = (along(cone.base, minus(cone.apex, cone.base), 0.5), profile.2 + 2.0);
    let middle = dot(minus(center, from), d);
    let step = reach / 2000.0;
    let first = (middle - reach).max(0.0);
    let mut before: Option<(f64, f64, f64)> = None;
    for k in 0..4000 {
        let t = first + step * f64::from(k);
        let (z, outside) = profile.at(along(from, d, t));
        // A place too near to any surface is not sure.
        if outside.abs() < sure || z.abs() < sure || (z - profile.2).abs() < sure {
            continue;
        }
        let now = (t, z, outside);
        if let Some((t0, z0, outside0)) = before {
            let inner = |z: f64| z > 0.0 && z < profile.2;
            let side = inner(z0) && inner(z) && (outside0 < 0.0) != (outside < 0.0);
            let end = cone.capped && inner(z0) != inner(z) && outside0 < 0.0 && outside < 0.0;
            let outwards = outside > 0.0 || (end && !inner(z));
            if (side || end) && (!cone.inside_only || outwards) {
                return Some([t0, t]);
            }
        }
        before = Some(now);
    }
    None
}

fn cones<S: Measure>(seed: u64) {
    let mut rng = Rng::with_seed(seed);
    let (mut hits, mut sure) = (0, 0);
    for number in 0..200 {
        let base = within(&mut rng, 5.0);
        let apex = along(base, unit(within(&mut rng, 1.0)), [0.2, 1.0, 3.0][number % 3]);
        let radius = [0.05, 0.4, 1.0][number / 3 % 3];
        let other = [radius, 0.0, 2.0 * radius, 0.5 * radius][number % 4];
        let (capped, inside_only) = (number % 2 == 0, number % 5 == 0);
        let cone = Cone {
            base,
            apex,
            base_radius: radius,
            apex_radius: other,
            capped,
            inside_only,
            color: COLOR,
            surface: SURFACE,
            line: 0,
        };
        let scene = Description { cones: vec![cone.clone()], ..empty() };
        let scene = narrow::<S>(&scene, 1.0).expect("it fits");
        for _ in 0..50 {
            let (from, towards) = aim(&mut rng, along(base, minus(apex, base), 0.5), 1.0 + radius);
            let Shot { origin, direction, hit } = shoot(&scene, from, towards);
            let tolerance = 40.0 * S::LENGTH + 40.0 * S::UNIT;
            let passage = passage(&cone, origin, direction, 1e-3);
            if let Some((t, point, normal)) = hit {
                hits += 1;
                let p = along(origin, direction, t);
                // Flat rays slide along the surface before they are through.
                let flat = dot(normal, direction).abs().max(2e-3);
                let off = Profile::new(&cone).off(p);
                assert!(off < tolerance / flat, "{cone:?}: {off} off at {t}");
                let off = Profile::new(&cone).off(point);
                assert!(off < tolerance, "{cone:?}: the point is {off} off");
                assert!((dot(normal, normal) - 1.0).abs() < 4.0 * S::UNIT + 1e-12, "a normal of {normal:?}");
                // Along the normal the surface is left to the outside.
                let profile = Profile::new(&cone);
                let (z, outside) = profile.at(along(point, normal, 2e-2));
                assert!(outside > 0.0 || z < 0.0 || z > profile.2, "{cone:?}: a normal to the inside");
            }
            if let Some([first, last]) = passage {
                sure += 1;
                let Some((t, ..)) = hit else { panic!("{cone:?}: a miss at {first}") };
                assert!(t < last + tolerance, "{cone:?}: {t} and not {first} to {last}");
            }
        }
    }
    assert!(hits > 1500 && sure > 1400, "{hits} hits, {sure} of them sure");
}

fn triangles<S: Measure>(seed: u64) {
    let mut rng = Rng::with_seed(seed);
    let (mut hits, mut misses) = (0, 0);
    for number in 0..200 {
        let a = within(&mut rng, 5.0);
        let size = [0.1, 1.0, 4.0][number % 3];
        let vertices = [a, along(a, within(&mut rng, size), 1.0), along(a, within(&mut rng, size), 1.0)];
        let [_, b, c] = vertices;
        let area = cross(minus(b, a), minus(c, a));
        if dot(area, area).sqrt() < 0.05 * size * size {
            continue;
        }
        let normal = unit(area);
        let tilted = |by: Triple| unit(along(normal, by, 0.3));
        let normals = [tilted(minus(a, c)), tilted(minus(b, a)), tilted(minus(c, b))];
        let curved = number % 2 == 0;
        let triangle = Triangle {
            vertices,
            normals: curved.then_some(normals),
            one_sided: false,
            color: COLOR,
            surface: SURFACE,
            line: 0,
        };
        let scene = Description { triangles: vec![triangle], ..empty() };
        let scene = narrow::<S>(&scene, 1.0).expect("it fits");
        for _ in 0..50 {
            let (from, towards) = aim(&mut rng, [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0), 0.5 * size);
            let Shot { origin, direction, hit } = shoot(&scene, from, towards);
            let cosine = dot(normal, direction);
            if cosine.abs() < 0.05 {
                continue;
            }
            let t = dot(minus(a, origin), normal) / cosine;
            let p = along(origin, direction, t);
            // Barycentric coordinates, by areas.
            let part = |u: Triple, v: Triple| dot(cross(minus(v, u), minus(p, u)), area) / dot(area, area);
            let weights = [part(b, c), part(c, a), part(a, b)];
            let least = weights.into_iter().fold(1.0, f64::min);
            let tolerance = 100.0 * S::LENGTH / cosine.abs();
            if least.abs() < 2.0 * tolerance / size || t.abs() < tolerance {
                continue;
            }
            assert_eq!(hit.is_some(), least > 0.0 && t > 0.0, "{weights:?} at {t}");
            let Some((found, point, found_normal)) = hit else {
                misses += 1;
                continue;
            };
            hits += 1;
            assert!((found - t).abs() < tolerance, "{found} and not {t}");
            let off = dot(minus(point, a), normal);
            assert!(off.abs() < 4.0 * S::LENGTH, "the point is {off} off the plane");
            let mixed = [0, 1, 2].map(|i| (0..3).map(|k| weights[k] * normals[k][i]).sum());
            let mixed = unit(mixed);
            let faces = (dot(mixed, direction) > 0.0) == (cosine > 0.0);
            let want = if curved && faces { mixed } else { normal };
            let wrong = minus(found_normal, want).map(f64::abs).into_iter().fold(0.0, f64::max);
            let slack = 1e3 * S::LENGTH / (size * cosine.abs()) + 8.0 * S::UNIT;
            assert!(wrong < slack || dot(mixed, direction).abs() < slack, "{found_normal:?}, not {want:?}");
        }
    }
    assert!(hits > 500 && misses > 500, "{hits} hits, {misses} misses");
}

/// Two triangles that share an edge hide everything behind it.
fn seams<S: Measure>(seed: u64) {
    let mut rng = Rng::with_seed(seed);
    for _ in 0..100 {
        let (a, b) = (within(&mut rng, 8.0), within(&mut rng, 8.0));
        let edge = minus(b, a);
        let side = cross(edge, within(&mut rng, 1.0));
        let other = along(side.map(|c| -c), cross(edge, within(&mut rng, 1.0)), 0.3);
        let triangle = |c: Triple, vertices: [Triple; 2]| Triangle {
            vertices: [c, vertices[0], vertices[1]],
            normals: None,
            one_sided: false,
            color: COLOR,
            surface: SURFACE,
            line: 0,
        };
        let unit_to = |v: Triple| along(along(a, edge, 0.5), unit(v), 3.0);
        let pair = vec![triangle(unit_to(side), [a, b]), triangle(unit_to(other), [b, a])];
        let scene = narrow::<S>(&Description { triangles: pair, ..empty() }, 1.0).expect("it fits");
        for _ in 0..100 {
            let on = along(a, edge, 0.05 + 0.9 * rng.f64());
            // From above the ridge or below it, not from along either of the two.
            let from = along(on, unit(cross(edge, minus(unit(side), unit(other)))), 7.0);
            let from = along(from, within(&mut rng, 1.0), 1.0);
            let hit = shoot(&scene, from, unit(minus(on, from))).hit;
            assert!(hit.is_some(), "a gap at {on:?} seen from {from:?}");
        }
    }
}

macro_rules! formats {
    ($($name:ident: $f:ty),*) => {
        $(mod $name {
            #[test]
            fn cones() {
                super::cones::<$f>(1);
            }
            #[test]
            fn triangles() {
                super::triangles::<$f>(2);
            }
            #[test]
            fn seams() {
                super::seams::<$f>(3);
            }
        })*
    };
}

formats!(q16: rta_core::Q16, q20: rta_core::Q20, f32: f32, f64: f64);
