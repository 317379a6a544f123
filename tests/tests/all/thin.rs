//! Thin cones, cylinders and triangles in every number format: they do not shadow themselves, rays along an axis and at a rim
//! are told right, and triangles that share an edge leave no gap and have the width that they should have.

#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use fastrand::Rng;
use rta_core::needs::Everything;
use rta_core::ray::Ray;
use rta_core::scalar::{Q16, Q20, Unit};
use rta_core::shape::Primitive;
use rta_core::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};
use rta_scenes::description::{Camera, Cone, Description, Surface, Triangle};
use rta_scenes::narrow::{Narrowed, narrow};
use rta_tests::measure::{Measure, direction, place};

type Triple = [f64; 3];

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
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / length)
}

/// Returns a random direction.
fn random(rng: &mut Rng) -> Triple {
    loop {
        let v = [(); 3].map(|()| 2.0 * rng.f64() - 1.0);
        let square = v.iter().map(|c| c * c).sum::<f64>();
        if square > 0.01 && square < 1.0 {
            return unit(v);
        }
    }
}

fn ray<S: Measure>(from: Triple, to: Triple) -> Ray<S> {
    let way: UnitVec3<S> = direction::<S>(minus(to, from));
    Ray::new(place::<S>(from), way.normalize().expect("it has a length").0)
}

fn empty() -> Description {
    Description::empty(Camera::upright([0.0, -60.0, 0.0], [0.0, 1.0, 0.0], 1.0))
}

/// Returns a scene of one cone, 16 long about 0, and its axis.
fn cone<S: Measure>(rng: &mut Rng, radii: [f64; 2], capped: bool) -> (Narrowed<S>, Triple) {
    let axis = random(rng);
    let [base_radius, apex_radius] = radii;
    let mut scene = empty();
    scene.cones.push(Cone {
        base: axis.map(|c| -8.0 * c),
        apex: axis.map(|c| 8.0 * c),
        base_radius,
        apex_radius,
        capped,
        inside_only: false,
        color: [0.5; 3],
        surface: Surface::Opaque,
        line: 0,
    });
    (narrow::<S>(&scene, 1.0).expect("it fits"), axis)
}

/// Rays at random places of the length, and at small angles to the axis: from where they meet the outside, no ray that leaves
/// outwards meets the cone again.
fn no_cone_meets_itself<S: Measure>(name: &str) {
    let mut rng = Rng::with_seed(1);
    let (mut hits, mut wrong) = (0, 0);
    for (ratio, taper, capped) in [1.0, 16.0, 256.0, 4096.0]
        .into_iter()
        .flat_map(|ratio| [1.0, 0.5, 0.0].map(|taper| (ratio, taper)))
        .flat_map(|(ratio, taper)| [false, true].map(|capped| (ratio, taper, capped)))
    {
        let radius = 8.0 / ratio;
        for _ in 0..20 {
            let (scene, axis) = cone::<S>(&mut rng, [radius, radius * taper], capped);
            let cone = &scene.scene().cones[0];
            for k in 0..50 {
                let at = along(
                    along([0.0; 3], axis, 16.0 * rng.f64() - 8.0),
                    random(&mut rng),
                    0.9 * radius * rng.f64(),
                );
                let from = if k % 2 == 0 {
                    random(&mut rng).map(|c| 30.0 * c)
                } else {
                    let angle = [0.0, 1e-7, 1e-5, 1e-3, 0.05, 0.3][k / 2 % 6];
                    along(along(at, axis, 30.0), cross(axis, random(&mut rng)), 30.0 * angle)
                };
                let ray = ray::<S>(from, at);
                let Some(t) = cone.intersect(&ray, S::FAR) else { continue };
                let spot = cone.point::<Everything>(&ray, t);
                let zero = <S::Unit as Unit>::ZERO;
                if spot.normal.dot(ray.direction) > zero {
                    continue; // It is the inside.
                }
                hits += 1;
                let away = direction::<S>(random(&mut rng)).normalize().expect("it has a length").0;
                let away = if away.dot(spot.normal) < zero { -away } else { away };
                let (start, _) = spot.point.leave(spot.normal, away, cone.look().extent);
                wrong += u32::from(cone.intersect(&Ray::new(start, away), S::FAR).is_some());
            }
        }
    }
    assert!(hits > 10_000, "{name}: {hits} hits");
    assert_eq!(wrong, 0, "{name}: of {hits} rays that leave a cone, so many meet it again");
}

#[test]
fn cones_do_not_meet_themselves() {
    no_cone_meets_itself::<f32>("f32");
    no_cone_meets_itself::<f64>("f64");
    no_cone_meets_itself::<Q16>("q16");
    no_cone_meets_itself::<Q20>("q20");
}

/// A ray that leads to a place well inside of a capped cylinder meets it, wherever it enters, also at a rim.
fn no_rim_leaks<S: Measure>(name: &str) {
    let mut rng = Rng::with_seed(2);
    for ratio in [1.0, 16.0, 256.0, 4096.0] {
        let radius = 8.0 / ratio;
        let mut leaks = 0;
        for _ in 0..50 {
            let (scene, axis) = cone::<S>(&mut rng, [radius, radius], true);
            for _ in 0..100 {
                let across = unit(cross(axis, random(&mut rng)));
                let rim = along(along([0.0; 3], axis, 8.0), across, radius);
                // From the rim inwards, by as much along the axis as across.
                let inner = along(along(rim, axis, -0.3 * radius), across, -0.5 * radius);
                let from = along(rim, minus(rim, inner), 20.0 / radius);
                let is_met = scene.scene().cones[0].intersect(&ray::<S>(from, inner), S::FAR).is_some();
                leaks += u32::from(!is_met);
            }
        }
        assert_eq!(leaks, 0, "{name}, ratio {ratio}: so many of 5000 rays at a rim leak in");
    }
}

#[test]
fn rims_do_not_leak() {
    no_rim_leaks::<f32>("f32");
    no_rim_leaks::<f64>("f64");
    no_rim_leaks::<Q20>("q20");
}

/// Returns a scene of triangles.
fn triangles<S: Measure>(all: impl IntoIterator<Item = [Triple; 3]>) -> Narrowed<S> {
    let mut scene = empty();
    scene.triangles = all
        .into_iter()
        .map(|vertices| Triangle {
            vertices,
            normals: None,
            color: [0.5; 3],
            surface: Surface::Opaque,
            line: 0,
        })
        .collect();
    narrow::<S>(&scene, 1.0).expect("it fits")
}

/// Returns how many triangles of a scene a ray meets.
fn met<S: Measure>(scene: &Narrowed<S>, ray: &Ray<S>) -> usize {
    scene.scene().triangles.iter().filter(|triangle| triangle.intersect(ray, S::FAR).is_some()).count()
}

/// Rays at the hub of a fan, and at its spokes: none passes between two triangles.
fn no_crack<S: Measure>(name: &str) {
    let mut rng = Rng::with_seed(3);
    for distance in [5.0, 30.0, 300.0] {
        for _ in 0..40 {
            let (axis, hub) = (random(&mut rng), random(&mut rng));
            let (u, v) = (unit(cross(axis, hub)), unit(cross(axis, unit(cross(axis, hub)))));
            let rim = |k: u32| {
                let angle = f64::from(k % 7) * core::f64::consts::TAU / 7.0;
                along(along(hub, u, angle.cos()), v, angle.sin())
            };
            let scene = triangles::<S>((0..7).map(|k| [hub, rim(k), rim(k + 1)]));
            // The places as the format has them.
            let corners = scene.scene().triangles;
            for k in 0..30 {
                let [hub, spoke, _] = corners[k % 7].vertices;
                let half = S::Unit::ratio(rng.i64(0..900), 1000);
                let scaled =
                    |v: Vec3<S>| Vec3::<S>::new(v.x().scale(half), v.y().scale(half), v.z().scale(half));
                let at = hub + scaled(spoke - hub);
                let side = random(&mut rng);
                let origin = place::<S>(side.map(|c| distance * c)) + at;
                let Some((way, ..)) = (at - origin).normalize() else { continue };
                let ray = Ray::new(origin, way);
                let grazing = corners[0].normal.dot(way);
                if grazing.times(grazing) < S::Unit::ratio(1, 100) {
                    continue; // The rounding of the direction is longer in the plane.
                }
                assert!(met(&scene, &ray) > 0, "{name}, distance {distance}: a ray at a spoke passes");
            }
        }
    }
}

#[test]
fn a_fan_has_no_cracks() {
    no_crack::<f32>("f32");
    no_crack::<f64>("f64");
    no_crack::<Q16>("q16");
    no_crack::<Q20>("q20");
}

/// A triangle 2 long and `width` wide is hit by as many rays as in `f64`, give or take a part of them.
fn slivers<S: Measure>(width: f64, distance: f64) -> (u32, u32) {
    let mut rng = Rng::with_seed(4);
    let (mut got, mut exact) = (0, 0);
    let vertices = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.3, 0.0, width]];
    let (scene, twin) = (triangles::<S>([vertices]), triangles::<f64>([vertices]));
    for _ in 0..4000 {
        let at = [2.0 * rng.f64() - 1.0, 0.0, width * (3.0 * rng.f64() - 1.0)];
        let from = [0.2 * distance * rng.f64(), -distance, 0.1 * distance * rng.f64()];
        got += u32::try_from(met(&scene, &ray::<S>(from, at))).expect("it is 0 or 1");
        exact += u32::try_from(met(&twin, &ray::<f64>(from, at))).expect("it is 0 or 1");
    }
    (got, exact)
}

#[test]
fn slivers_are_not_thickened() {
    let check = |name, (got, exact): (u32, u32)| {
        assert!(exact > 500 && got.abs_diff(exact) * 5 < exact, "{name}: {got} rays hit, {exact} in f64");
    };
    check("f32 at 30", slivers::<f32>(1e-3, 30.0));
    check("f32 at 1000", slivers::<f32>(1e-3, 1000.0));
    check("q16 at 30", slivers::<Q16>(1e-3, 30.0));
    check("q16 at 1000", slivers::<Q16>(1e-3, 1000.0));
    check("q20 at 1000", slivers::<Q20>(1e-4, 1000.0));
}
