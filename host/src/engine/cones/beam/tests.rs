//! Parts of cones against exact values and against many rays, and what mirrors and lenses make of cones against the rays that they are made of.
#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use core::f64::consts::PI;

use rta_core::color::Rgb;
use rta_core::ray::Ray;
use rta_core::scalar::Scalar;
use rta_core::shape::{Primitive, Sphere};
use rta_core::vector::{UnitVec3, Vec3};

use super::{Beam, Bend, Covered};
use crate::engine::cones::cover::{lens, seg};

fn close(found: f64, exact: f64, error: f64) {
    assert!((found - exact).abs() <= error, "{found}, not {exact}");
}

/// A cone from 0 along z.
fn upright(angle: f64) -> Beam {
    Beam::new(Vec3::<f64>::ZERO, UnitVec3::<f64>::Z, 0.0, angle)
}

/// The part of its rays, spread evenly over the disc, that meet something; and the place of their mean.
fn found(beam: &Beam, meets: impl Fn(&Ray<f64>) -> bool) -> (f64, [f64; 2]) {
    let (mut all, mut hits, mut sum) = (0u32, 0u32, [0.0; 2]);
    for i in 0..400 {
        for k in 0..400 {
            let place = [f64::from(2 * i + 1) / 400.0 - 1.0, f64::from(2 * k + 1) / 400.0 - 1.0];
            if place[0].hypot(place[1]) <= 1.0 {
                all += 1;
                if meets(&beam.ray(place)) {
                    hits += 1;
                    sum = [sum[0] + place[0], sum[1] + place[1]];
                }
            }
        }
    }
    (f64::from(hits) / f64::from(all), sum.map(|side| side / f64::from(hits.max(1))))
}

#[test]
fn discs_and_caps() {
    // Of caps of .1 and .2 radians, .15 apart: .762035098 of the first is exact.
    close(lens(0.1, 0.2, 0.15), 0.761_572_276, 1e-9);
    close(lens(0.1f64.tan(), 0.2f64.tan(), 0.15f64.tan()), 0.770_734_644, 1e-9);
    close(lens(0.05, 0.05, 0.05), 2.0 / 3.0 - 3f64.sqrt() / (2.0 * PI), 1e-12);
    close(seg(0.5), 0.195_501_109, 1e-9);
    // A cone and a sphere, as discs in one cross section.
    let part = |angle: f64, other: f64, apart: f64| {
        let center = Vec3::<f64>::new(apart.sin(), 0.0, apart.cos()) * 7.0;
        upright(angle).sphere(center, 7.0 * other.sin()).map_or(0.0, |covered| covered.part)
    };
    let wide = part(0.1, 0.2, 0.15);
    close(wide, 0.762_035_098, 3e-3);
    assert!((wide - 0.762_035_098).abs() > 2e-3, "{wide}: it is known to be wrong by .0027");
    close(part(0.05, 0.05, 0.05), 0.391_088_382, 1e-3);
    // As wide as a pixel it is right: the angles are a fiftieth, the error that squared.
    close(part(0.002, 0.004, 0.003), lens(2.0, 4.0, 3.0), 2e-6);
    // Within, about and beside it.
    close(part(0.1, 0.02, 0.03), (0.02f64.sin() / (0.1f64.tan() * 0.03f64.cos())).powi(2), 1e-12);
    close(part(0.1, 0.3, 0.1), 1.0, 0.0);
    close(part(0.1, 0.3, 0.45), 0.0, 0.0);
}

#[test]
fn spheres_and_their_middles() {
    for (angle, radius) in [(0.05, 0.0), (0.03, 0.4), (-0.05, 0.6), (-0.12, 0.5)] {
        let beam = Beam::new(Vec3::<f64>::ZERO, UnitVec3::<f64>::Z, radius, angle);
        for x in [0.0, 0.3, 0.5, 0.9] {
            let ball = Sphere::new(Vec3::<f64>::new(x, 0.2 * x, 9.0), 0.5, Rgb::new(0.0, 0.0, 0.0), 0);
            let (part, _) = found(&beam, |ray| ball.intersect(ray, f64::FAR).is_some());
            let covered = beam.sphere(ball.center, ball.radius);
            close(covered.map_or(0.0, |covered| covered.part), part, 8e-3);
            if let Some(Covered { place, .. }) = covered {
                assert!(ball.intersect(&beam.ray(place), f64::FAR).is_some(), "{angle} {x}: {place:?}");
            }
        }
    }
}

#[test]
fn planes_up_to_their_horizon() {
    // A cone that looks aslant at the floor: its horizon is where the cone's rays are level.
    for fall in [-0.03f64, -0.01, 0.0, 0.02, 0.06] {
        let axis = UnitVec3::<f64>::new(0.0, fall.cos(), -fall.sin());
        let beam = Beam::new(Vec3::<f64>::new(0.0, 0.0, 2.0), axis, 0.0, 0.05);
        let (part, [x, y]) = found(&beam, |ray| ray.direction.z < 0.0);
        for (normal, height) in [(UnitVec3::<f64>::Z, 2.0), (-UnitVec3::<f64>::Z, -2.0)] {
            let covered = beam.plane(normal, height).expect("some of it looks down");
            close(covered.part, part, 3e-3);
            close(covered.part, seg(-(fall.tan() / 0.05f64.tan()).min(1.0)), 1e-12);
            close((covered.place[0] - x).hypot(covered.place[1] - y), 0.0, 5e-3);
            assert!(beam.ray(covered.place).direction.z < 0.0);
        }
    }
    let up = Beam::new(Vec3::<f64>::new(0.0, 0.0, 2.0), UnitVec3::<f64>::Z, 0.0, 0.05);
    assert_eq!(up.plane(UnitVec3::<f64>::Z, 2.0), None);
}

/// Whether a ray meets a convex polygon whose corners run about it.
fn meets(ray: &Ray<f64>, corners: &[Vec3<f64>]) -> bool {
    let before = corners.iter().cycle().skip(corners.len() - 1);
    let sides = before.zip(corners).map(|(a, b)| ray.direction.dot((*a - ray.origin).cross(*b - ray.origin)));
    let sides: Vec<f64> = sides.collect();
    let [a, b, c] = [corners[0], corners[1], corners[2]];
    let normal = (b - a).cross(c - a);
    let t = normal.dot(a - ray.origin) / normal.dot(ray.direction);
    t > 0.0 && (sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0))
}

#[test]
fn polygons() {
    let polygons = [
        [[-0.3, -0.4, 5.0], [0.4, -0.1, 4.0], [0.0, 0.5, 6.0]],
        [[0.1, -0.05, 5.0], [0.4, -0.1, 5.0], [0.3, 0.5, 5.0]],
        [[-0.05, -0.05, 5.0], [0.07, -0.06, 5.0], [0.0, 0.1, 5.0]],
        [[-9.0, -9.0, 5.0], [9.0, -9.0, 5.0], [0.0, 9.0, 6.0]],
        // By the cone's origin to behind it.
        [[0.1, -9.0, 6.0], [0.1, 9.0, 6.0], [9.0, 0.0, -8.0]],
        [[2.0, 2.0, 5.0], [3.0, 2.0, 5.0], [2.0, 3.0, 5.0]],
    ];
    for (angle, radius) in [(0.05, 0.0), (0.03, 0.2), (-0.05, 0.3), (-0.12, 0.6)] {
        let beam = Beam::new(Vec3::<f64>::ZERO, UnitVec3::<f64>::Z, radius, angle);
        for (number, polygon) in polygons.iter().enumerate() {
            let corners = polygon.map(|[x, y, z]| Vec3::<f64>::new(x, y, z));
            let (part, [x, y]) = found(&beam, |ray| meets(ray, &corners));
            let covered = beam.polygon(corners);
            close(covered.map_or(0.0, |covered| covered.part), part, 2e-3);
            let Some(covered) = covered else { continue };
            assert!(meets(&beam.ray(covered.place), &corners), "{number} {angle}: {:?}", covered.place);
            let is_through_focus = angle < 0.0 && number == 4;
            if covered.part > 0.01 && !is_through_focus {
                close((covered.place[0] - x).hypot(covered.place[1] - y), 0.0, 2e-2);
            }
        }
        let triangle = |[x, y, z]: [f64; 3]| Vec3::<f64>::new(x, y, z);
        // Two halves are the whole, to roundings.
        let whole = [[-0.1, -0.2, 5.0], [0.3, -0.2, 5.0], [0.3, 0.1, 5.0], [-0.1, 0.1, 5.0]].map(triangle);
        let halves = [[whole[0], whole[1], whole[2]], [whole[0], whole[2], whole[3]]];
        let sum =
            halves.iter().filter_map(|half| beam.polygon(*half)).map(|covered| covered.part).sum::<f64>();
        close(sum, beam.polygon(whole).map_or(0.0, |covered| covered.part), 1e-9);
    }
}

fn ball(cosine: f64, refracted: Option<(f64, f64)>) -> Bend {
    Bend { curvature: 2.0, cosine, refracted, gloss: 0.0 }
}

#[test]
fn mirrors_and_lenses_spread_cones() {
    let eta = 1.0 / 1.5;
    let refracted = |angle: f64| Some((eta, (1.0 - (eta * angle.sin()).powi(2)).sqrt()));
    close(ball(1.0, None).spread(0.01, 0.1).mean, 0.11, 1e-12);
    close(ball(1.0, refracted(0.0)).spread(0.01, 0.1).mean, -0.01, 1e-12);
    let aslant = ball(0.6f64.cos(), None).spread(0.01, 0.1);
    close(aslant.across, 0.092_533_561, 1e-9);
    close(aslant.along, 0.131_162_831, 1e-9);
    close(aslant.mean, 0.11, 1e-12);
    let through = ball(0.6f64.cos(), refracted(0.6)).spread(0.01, 0.1);
    close(through.across, -0.012_144_434, 1e-9);
    close(through.along, -0.018_662_533, 1e-9);
    close(through.mean, (through.across + through.along) / 2.0, 1e-15);
    let flat = Bend { curvature: f64::INFINITY, ..ball(0.7, None) };
    close(flat.spread(0.01, 0.1).mean, 0.01, 0.0);
    // From inside a mirror gathers: to the focus at half its radius.
    let hollow = Bend { curvature: -2.0, ..ball(1.0, None) }.spread(0.0, 0.1);
    close(0.1 / -hollow.mean, 1.0, 1e-12);
}

#[test]
fn spreads_are_those_of_the_rays() {
    // Two rays of a narrow cone from .2 beside each other, reflected and refracted by a ball, against the formulas: to first order.
    let (radius, narrow) = (2.0, 1e-5);
    let eta = 1.0 / 1.5;
    for angle in [0.0f64, 0.3, 0.6, 0.9] {
        let normal = UnitVec3::<f64>::new(0.0, angle.sin(), angle.cos());
        let incoming = -UnitVec3::<f64>::Z;
        for side in [UnitVec3::<f64>::X, UnitVec3::<f64>::Y] {
            let bent = |aside: f64, is_refracted: bool| {
                let direction = (incoming + side * (aside * 0.3)).normalize();
                let ball = Sphere::new(Vec3::<f64>::ZERO, radius, Rgb::new(0.0, 0.0, 0.0), 0);
                let point = normal * radius;
                let start = point + side * aside - direction * 5.0;
                let ray = Ray::new(start, direction);
                let t = ball.intersect(&ray, f64::FAR).expect("it is met");
                let own = (start + direction * t) / radius;
                let cosine = -own.dot(direction);
                if is_refracted {
                    let root = (1.0 - eta * eta * (1.0 - cosine * cosine)).sqrt();
                    (direction * eta + own * (eta * cosine - root)).normalize()
                } else {
                    direction.reflect(own)
                }
            };
            for is_refracted in [false, true] {
                let turned = (bent(narrow, is_refracted) - bent(-narrow, is_refracted)).length() / 2.0;
                let refracted = is_refracted.then(|| (eta, (1.0 - (eta * angle.sin()).powi(2)).sqrt()));
                let bend = Bend { curvature: radius, cosine: angle.cos(), refracted, gloss: 0.0 };
                let spread = bend.spread(0.3 * narrow, narrow);
                let exact = if side == UnitVec3::<f64>::X { spread.across } else { spread.along };
                close(turned / exact.abs(), 1.0, 1e-3);
            }
        }
    }
}

#[test]
fn rays_go_through_the_focus() {
    let beam = Beam::new(Vec3::<f64>::ZERO, UnitVec3::<f64>::Z, 0.5, -0.1);
    let focus = 0.5 / 0.1f64.tan();
    for place in [[1.0, 0.0], [0.0, -1.0], [0.6, 0.8]] {
        let ray = beam.ray(place);
        let at = ray.origin + ray.direction * (focus / ray.direction.z);
        close(at.truncate().length(), 0.0, 1e-12);
    }
    // Behind it the cone is as wide as before it, and widens.
    let bend = Bend { curvature: f64::INFINITY, cosine: 1.0, refracted: None, gloss: 0.0 };
    let after = beam.after(2.0 * focus, bend, Vec3::<f64>::ZERO, UnitVec3::<f64>::Z);
    close(after.radius, 0.5, 1e-12);
    close(after.angle, 0.1, 1e-12);
}
