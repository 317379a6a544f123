//! Single rays at single objects, against f64 on the numbers as the format has rounded them: the errors of the
//! arithmetic alone.
//!
//! Rays go from a place at a distance to a place on a disc that is slightly wider than the silhouette, so grazing ones
//! are among them. Two distances are compared with the exact root: that of the search, `intersect`, and that of the
//! second look, `point`, from which the tracer goes on. The limits are those of `point`; `intersect` decides hit or miss.

#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use fastrand::Rng;
use rta_core::color::Rgb;
use rta_core::needs::Everything;
use rta_core::ray::Ray;
use rta_core::scalar::Unit;
use rta_core::scene::PLAIN;
use rta_core::shape::{Cylinder, Ellipsoid, Primitive, Sphere};
use rta_core::vector::{UnitVec3, Vec3, Vector};
use rta_core::{Q16, Q20};
use rta_paired::{Format, Value};

/// Number of rays at a sphere.
const RAYS: u32 = 400_000;
/// Number of rays at an ellipsoid or a cylinder.
const FEWER: u32 = 100_000;

/// How much wider than the object the disc is at which rays are aimed.
const WIDER: f64 = 1.02;

/// An object that rays are shot at.
#[derive(Clone, Copy, Debug)]
enum Target {
    Sphere(f64),
    Ellipsoid([f64; 3]),
    Cylinder(f64),
}

/// The errors of all rays at one object.
#[derive(Debug)]
struct Row {
    /// Root mean square error of the distance by the search, and by the second look.
    search: f64,
    spot: f64,
    /// Median of the second look's errors.
    median: f64,
    /// Number of hits that f64 does not have, and of those that only f64 has.
    wrong: u32,
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn over(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] / b[0], a[1] / b[1], a[2] / b[2]]
}

fn along(a: [f64; 3], b: [f64; 3], t: f64) -> [f64; 3] {
    [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]]
}

/// Returns a random place in the ball of radius 1.
fn in_ball(rng: &mut Rng) -> [f64; 3] {
    loop {
        let p = [0; 3].map(|_| 2.0 * rng.f64() - 1.0);
        if dot(p, p) <= 1.0 && dot(p, p) > 1e-6 {
            return p;
        }
    }
}

/// Returns an eye and a centre at this distance; where it is 1000, at opposite ends of the shortest format's range. If
/// `flat`, the line between them has an elevation of at most 60 degrees.
fn viewpoint(rng: &mut Rng, distance: f64, flat: bool) -> ([f64; 3], [f64; 3]) {
    if distance > 500.0 {
        let mut side = || 20.0 * rng.f64() - 10.0;
        return ([-500.0, side(), side()], [500.0, side(), side()]);
    }
    let center = along([0.0; 3], in_ball(rng), 10.0);
    let mut v = in_ball(rng);
    if flat {
        // Up to 60 degrees of elevation.
        v[2] = v[2].clamp(-1.0, 1.0) * 1.7 * v[0].hypot(v[1]);
    }
    (along(center, v, distance / dot(v, v).sqrt()), center)
}

/// Returns the place that a ray from `origin` is aimed at: on the disc through the centre that faces the eye, in the
/// space where the object is a sphere of radius 1 (an affine map takes silhouettes to silhouettes); for a cylinder, on
/// the line across it.
fn aim(rng: &mut Rng, target: Target, origin: [f64; 3], center: [f64; 3]) -> [f64; 3] {
    let radii = match target {
        Target::Sphere(radius) => [radius; 3],
        Target::Ellipsoid(radii) => radii,
        Target::Cylinder(radius) => {
            let (dx, dy) = (center[0] - origin[0], center[1] - origin[1]);
            let off = WIDER * radius * (2.0 * rng.f64() - 1.0) / dx.hypot(dy);
            return [center[0] - dy * off, center[1] + dx * off, center[2]];
        }
    };
    let axis = over(minus(center, origin), radii);
    let p = in_ball(rng);
    let p = along(p, axis, -dot(p, axis) / dot(axis, axis));
    let size = WIDER * rng.f64().sqrt() / dot(p, p).sqrt().max(1e-9);
    [0, 1, 2].map(|i| center[i] + radii[i] * size * p[i])
}

/// Returns the smallest positive root of a sphere of radius 1 about 0, for a direction of any length.
fn root(origin: [f64; 3], direction: [f64; 3]) -> Option<f64> {
    let square = dot(direction, direction);
    let past = -dot(origin, direction) / square;
    let foot = along(origin, direction, past);
    let rest = 1.0 - dot(foot, foot);
    if rest < 0.0 {
        return None;
    }
    let half = (rest / square).sqrt();
    [past - half, past + half].into_iter().find(|t| *t > 0.0)
}

fn place<S: Format>(p: [f64; 3]) -> (Vec3<S>, [f64; 3]) {
    let p = p.map(S::length);
    (Vec3::<S>::new(p[0], p[1], p[2]), p.map(Value::value))
}

fn shoot<S: Format>(target: Target, distance: f64) -> Row {
    let rays = if matches!(target, Target::Sphere(_)) { RAYS } else { FEWER };
    let mut rng = Rng::with_seed(1987);
    let (mut search, mut spot, mut wrong, mut errors) = (0.0, 0.0, 0, Vec::new());
    for _ in 0..rays {
        let (origin, center) = viewpoint(&mut rng, distance, matches!(target, Target::Cylinder(_)));
        let way = minus(aim(&mut rng, target, origin, center), origin);
        let direction = way.map(|c| S::unit(c / dot(way, way).sqrt()));
        let (d, (o, origin), (c, center)) =
            (direction.map(Value::value), place::<S>(origin), place::<S>(center));
        let ray: Ray<S> = Ray::new(o, UnitVec3::<S>::new(direction[0], direction[1], direction[2]));
        let (found, exact) = meet(target, &ray, c, minus(origin, center), d);
        match (found, exact) {
            (Some((near, second)), Some(exact)) => {
                let error = (second.value() - exact).abs();
                search += (near.value() - exact).powi(2);
                spot += error * error;
                errors.push(error);
            }
            (None, None) => (),
            _ => wrong += 1,
        }
    }
    let hits = errors.len();
    assert!(hits > rays as usize / 2, "most rays hit: {hits}");
    let (_, &mut median, _) = errors.select_nth_unstable_by(hits / 2, f64::total_cmp);
    let rms = |sum: f64| (sum / hits as f64).sqrt();
    Row { search: rms(search), spot: rms(spot), median, wrong }
}

/// Returns the distances of the search and of the second look in the format, and the exact one for these radii, origin
/// (from the centre) and direction.
fn meet<S: Format>(
    target: Target,
    ray: &Ray<S>,
    center: Vec3<S>,
    origin: [f64; 3],
    direction: [f64; 3],
) -> (Option<(S, S)>, Option<f64>) {
    let gray = Rgb::new(S::Unit::ONE, S::Unit::ONE, S::Unit::ONE);
    match target {
        Target::Sphere(radius) => {
            let radius = S::length(radius);
            let sphere = Sphere::new(center, radius, gray, PLAIN);
            let found =
                sphere.intersect(ray, S::FAR).map(|t| (t, sphere.point::<Everything>(ray, t).distance));
            let r = [radius.value(); 3];
            (found, root(over(origin, r), over(direction, r)))
        }
        Target::Ellipsoid(radii) => {
            let (radii, r) = place::<S>(radii);
            let ellipsoid = Ellipsoid::new(center, radii, gray, PLAIN);
            let found =
                ellipsoid.intersect(ray, S::FAR).map(|t| (t, ellipsoid.point::<Everything>(ray, t).distance));
            (found, root(over(origin, r), over(direction, r)))
        }
        Target::Cylinder(radius) => {
            let radius = S::length(radius);
            let cylinder = Cylinder::new(center, radius, gray, PLAIN);
            let found = cylinder
                .intersect(&ray.with_plan(S::length(600.0)), S::FAR)
                .map(|t| (t, cylinder.point::<Everything>(ray, t).distance));
            let flat = |[x, y, _]: [f64; 3]| [x / radius.value(), y / radius.value(), 0.0];
            (found, root(flat(origin), flat(direction)))
        }
    }
}

/// Limits of a format at a target: rms error of the second look, and number of wrong hits or misses.
type Limit = (f64, u32);

/// A row of the table: name, target, distance, and the limits of q16, q20 and f32.
type Case = (&'static str, Target, f64, [Limit; 3]);

fn check(cases: &[Case]) {
    println!("target                 distance format  rms search    rms spot      median  wrong     limits");
    let mut failures = Vec::new();
    for &(name, target, distance, limits) in cases {
        let rows = std::thread::scope(|threads| {
            let q16 = threads.spawn(|| shoot::<Q16>(target, distance));
            let q20 = threads.spawn(|| shoot::<Q20>(target, distance));
            let f32 = shoot::<f32>(target, distance);
            let row = |thread: std::thread::ScopedJoinHandle<Row>| thread.join().expect("no panic");
            [("q16", row(q16)), ("q20", row(q20)), ("f32", f32)]
        });
        for ((format, row), (most, wrongs)) in rows.into_iter().zip(limits) {
            let Row { search, spot, median, wrong } = row;
            println!(
                "{name:22} {distance:8} {format:6} {search:11.2e} {spot:11.2e} {median:11.2e} {wrong:6} {most:10.1e} {wrongs}"
            );
            if spot > most || wrong > wrongs {
                failures.push(format!("{name} at {distance} in {format}: {row:?}"));
            }
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

/// In fixed point the difference of two places is exact and the second look rounds the distance once: an LSB over the
/// root of 12, whatever the distance. In f32 that difference is rounded to the size of the coordinates, and it shows.
/// Wrong hits and misses are those of the search: its foot point is rounded to an LSB, which is a larger part of a
/// small radius.
#[test]
fn spheres() {
    let ball = Target::Sphere(1.0);
    check(&[
        ("sphere 1", ball, 5.0, [(2e-5, 10), (2e-6, 1), (1e-6, 1)]),
        ("sphere 1", ball, 50.0, [(2e-5, 10), (2e-6, 1), (1e-5, 2)]),
        ("sphere 1", ball, 1000.0, [(2e-5, 10), (2e-6, 1), (6e-5, 1)]),
        ("sphere 0.05", Target::Sphere(0.05), 30.0, [(2e-5, 100), (2e-6, 10), (5e-6, 20)]),
    ]);
}

/// Axes of 1 : 1000, a coin and a needle. The ray is looked at from beside the centre with the largest radius as the
/// unit and then squashed, in units of 2^-30: a thin axis of 0.001 keeps 20 bits of its size. What is lost along a ray
/// that runs in the plane of a coin comes back divided by the squashed direction's length, so the bounds are those of
/// spheres, not smaller, though the search already has the second look's precision.
#[test]
fn ellipsoids() {
    let (coin, needle) = (Target::Ellipsoid([1.0, 1.0, 0.001]), Target::Ellipsoid([0.01, 0.01, 10.0]));
    check(&[
        ("ellipsoid 1 1 0.001", coin, 5.0, [(2e-5, 2), (2e-6, 1), (1e-6, 1)]),
        (
            "ellipsoid 10 0.01 10",
            Target::Ellipsoid([10.0, 0.01, 10.0]),
            50.0,
            [(2e-5, 2), (2e-6, 1), (5e-6, 2)],
        ),
        ("ellipsoid .01 .01 10", needle, 50.0, [(2e-5, 2), (2e-6, 1), (5e-6, 15)]),
    ]);
}

/// Rays of up to 60 degrees of elevation: the distance in the ground plan and its error are stretched by up to 2. The
/// stretch is the reciprocal of a unit vector's length in the plan and errs by 2^-30 of the way, which is 1e-6 at 1000
/// and shows in q20.
#[test]
fn cylinders() {
    let pillar = Target::Cylinder(1.0);
    check(&[
        ("cylinder 1", pillar, 5.0, [(2e-5, 2), (2e-6, 1), (1e-6, 1)]),
        ("cylinder 1", pillar, 50.0, [(2e-5, 4), (2e-6, 1), (1e-5, 1)]),
        ("cylinder 1", pillar, 1000.0, [(2e-5, 6), (2e-6, 1), (2e-4, 2)]),
    ]);
}
