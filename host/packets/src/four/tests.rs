//! Each of four is what one is by itself, to the last bit.

use glam::{Vec3, Vec4};
use rta_core::Scalar;
use rta_core::camera::{Camera, Lens};
use rta_core::color::Rgb;
use rta_core::material::{Glass, Material};
use rta_core::needs::Everything;
use rta_core::ray::Ray;
use rta_core::scene::PLAIN;
use rta_core::shape::{Floor, Primitive, Sphere, Triangle};
use rta_core::surface::Surface;
use rta_core::trace::decision;
use rta_core::vector::{LengthVector, UnitVector};

use super::geometry::{
    Ray4, SurfacePoint4, leave, normalize, on_floor, reflect, refract, through_plane, to_floor,
};
use super::vector::{Vec3x4, lane, mask};

const RUNS: u32 = 20_000;
const GREY: Rgb<f32> = Rgb::new(0.5, 0.5, 0.5);

/// Random numbers (G. Marsaglia, "Xorshift RNGs", Journal of Statistical Software 8, 2003).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// From -1 to 1.
    #[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss)] // 24 bits
    fn number(&mut self) -> f32 {
        (self.bits() >> 40) as f32 / (1 << 23) as f32 - 1.0
    }

    fn place(&mut self) -> Vec3 {
        let size = [1.0, 1.0, 1e-3, 50.0][self.below(4)];
        size * Vec3::new(self.number(), self.number(), self.number())
    }

    /// Some lie in an axis.
    fn direction(&mut self) -> Vec3 {
        let axes = [Vec3::X, -Vec3::Y, Vec3::Z, -Vec3::Z];
        match self.below(16) {
            n @ 0..4 => axes[n],
            _ => self.place().try_normalize().unwrap_or(Vec3::X),
        }
    }

    fn ray(&mut self) -> Ray<f32> {
        Ray::new(self.place(), self.direction())
    }

    fn below(&mut self, end: u64) -> usize {
        usize::try_from(self.bits() % end).expect("a small number")
    }

    fn four<T>(&mut self, mut one: impl FnMut(&mut Self) -> T) -> [T; 4] {
        [one(self), one(self), one(self), one(self)]
    }
}

/// Runs a test with many random numbers.
fn often(mut test: impl FnMut(&mut Random)) {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for _ in 0..RUNS {
        test(&mut random);
    }
}

fn together(rays: &[Ray<f32>; 4]) -> Ray4 {
    Ray4 {
        origin: Vec3x4::new(rays.map(|ray| ray.origin)),
        direction: Vec3x4::new(rays.map(|ray| ray.direction)),
    }
}

fn numbers(four: [f32; 4]) -> Vec4 {
    Vec4::from_array(four)
}

/// What of four is met.
fn met((is_met, t): (glam::BVec4A, Vec4), k: usize) -> Option<f32> {
    is_met.test(k).then(|| lane(&t, k))
}

#[test]
fn places_on_spheres() {
    let mut grazing = 0;
    often(|random| {
        let rays = random.four(Random::ray);
        let spheres =
            random.four(|random| Sphere::new(random.place(), random.number().abs() + 1e-3, GREY, PLAIN));
        let four = together(&rays);
        let t = numbers(random.four(|random| 2.0 * random.number()));
        let points = SurfacePoint4::on_spheres(spheres.each_ref(), 15, &four, t);
        for (k, (ray, sphere)) in rays.iter().zip(&spheres).enumerate() {
            let point = sphere.point::<Everything>(ray, lane(&t, k));
            assert_eq!(lane(&points.distance, k), point.distance);
            assert_eq!((points.point.lane(k), points.normal.lane(k)), (point.point, point.normal));
            grazing += u32::from(sphere.intersect(ray, f32::FAR).is_none());
        }
    });
    assert!(grazing > RUNS / 10);
}

#[test]
fn distances_of_spheres() {
    let mut hits = 0;
    often(|random| {
        let rays = random.four(Random::ray);
        let sphere = Sphere::new(random.place(), random.number().abs() + 0.3, GREY, PLAIN);
        let four = together(&rays);
        let found = four.meet_sphere(Vec3x4::splat(sphere.center), Vec4::splat(sphere.radius));
        for (k, ray) in rays.iter().enumerate() {
            let right = sphere.intersect(ray, f32::FAR);
            assert_eq!(met(found, k), right);
            hits += u32::from(right.is_some());
        }
    });
    assert!(hits > RUNS / 10);
    // What touches is met.
    let ray = Ray::new(Vec3::new(0.5, -2.0, 0.0), Vec3::Y);
    let found = together(&[ray; 4]).meet_sphere(Vec3x4::splat(Vec3::ZERO), Vec4::splat(0.5));
    assert_eq!(met(found, 0), Some(2.0));
}

#[test]
fn triangles() {
    let (mut hits, mut ends) = (0, 0);
    often(|random| {
        let [a, b, c] = [random.place(), random.place(), random.place()];
        let Some(normal) = (b - a).cross(c - a).try_normalize() else { return };
        let extent = (b - a).length().max((c - a).length());
        let triangle = Triangle {
            vertices: [a, b, c],
            extent,
            normal,
            normals: None,
            one_sided: false,
            color: GREY,
            material: PLAIN,
        };
        // Rays to places on it, and beside it.
        let rays = random.four(|random| {
            let (u, v) = (random.number(), random.number());
            let origin = random.place();
            let to = a + (b - a) * u.abs() + (c - a) * (v * (1.0 - u.abs()));
            Ray::new(origin, (to - origin).try_normalize().unwrap_or(Vec3::X))
        });
        let four = together(&rays);
        let free = four.meet_triangle(&triangle, Vec4::splat(f32::FAR), Vec4::INFINITY);
        let points = SurfacePoint4::on_triangles([&triangle; 4], &four);
        for (k, ray) in rays.iter().enumerate() {
            let right = triangle.intersect(ray, f32::FAR);
            assert_eq!(met(free, k), right);
            let Some(t) = right else { continue };
            hits += 1;
            // Its own distance is not before itself.
            let end = Vec4::splat(t);
            assert_eq!(
                met(four.meet_triangle(&triangle, end, Vec4::INFINITY), k),
                triangle.intersect(ray, t)
            );
            let at = triangle.intersect(ray, t.next_up());
            assert_eq!(met(four.meet_triangle(&triangle, Vec4::splat(t.next_up()), Vec4::INFINITY), k), at);
            ends += u32::from(at.is_some());
            let point = triangle.point::<Everything>(ray, t);
            assert_eq!(lane(&points.distance, k), point.distance);
            assert_eq!((points.point.lane(k), points.normal.lane(k)), (point.point, point.normal));
        }
    });
    assert!(hits > RUNS / 10 && ends > RUNS / 10);
}

#[test]
fn the_floor() {
    for tile in [None, Some(0.7), Some(10.0)] {
        assert!(odd_tiles(tile) > RUNS / 10, "{tile:?}");
    }
}

/// Returns how many of many rays see a tile of the second colour.
fn odd_tiles(tile: Option<f32>) -> u32 {
    let floor = Floor { colors: [GREY, GREY.map(|c| 2.0 * c)], tile, material: PLAIN };
    let mut odd_tiles = 0;
    often(|random| {
        let rays = random.four(Random::ray);
        let four = together(&rays);
        let found = to_floor(&four);
        let (points, odd) = on_floor(&floor, &four, found.1);
        for (k, ray) in rays.iter().enumerate() {
            let right = floor.intersect(ray);
            assert_eq!(met(found, k), right);
            let Some(t) = right.filter(|&t| t < 1e6) else { continue };
            let (point, color) = floor.point::<Everything>(ray, t, f32::FAR);
            assert_eq!(points.lane(k), point.point);
            assert_eq!(odd >> k & 1 == 1, color == floor.colors[1], "{}", point.point);
            odd_tiles += odd >> k & 1;
        }
    });
    odd_tiles
}

#[test]
fn rays_that_leave() {
    let mut total = [0; 2];
    often(|random| {
        let point = random.four(Random::place);
        let (normal, direction) = (random.four(Random::direction), random.four(Random::direction));
        let extent = random.four(|random| random.number().abs());
        let (points, normals, directions) = (Vec3x4::new(point), Vec3x4::new(normal), Vec3x4::new(direction));
        let (starts, used) = leave(points, normals, directions, numbers(extent));
        let mirrored = reflect(directions, normals);
        let glasses = random.four(|random| Glass::new(0.1, 2, [1, 3, 4][random.below(3)]));
        let inside = u32::try_from(random.below(16)).expect("four bits");
        let (through, none) = refract(directions, normals, mask(inside), glasses.each_ref());
        for k in 0..4 {
            let (start, way) = point[k].leave(normal[k], direction[k], extent[k]);
            assert_eq!((starts.lane(k), lane(&used, k)), (start, way));
            assert_eq!(mirrored.lane(k), UnitVector::reflect(direction[k], normal[k]));
            let surface = Surface {
                point: point[k],
                normal: normal[k],
                face: None,
                incoming: direction[k],
                distance: 1.0,
                inside: inside >> k & 1 == 1,
                extent: 1.0,
                color: GREY,
                material: &Material::Opaque,
                surroundings: false,
                mesh: None,
                number: PLAIN,
            };
            let right = decision::refract(&surface, &glasses[k]);
            assert_eq!((none >> k & 1 == 0).then(|| through.lane(k)), right);
            total[usize::from(right.is_none())] += 1;
        }
    });
    assert!(total[0] > RUNS / 10 && total[1] > RUNS / 10, "{total:?}");
}

#[test]
fn unit_vectors() {
    let camera = Camera::<f32>::new(Vec3::ZERO, Vec3::new(0.3, 0.9, -0.2), Lens::new(3, 4, (4, 3)));
    often(|random| {
        let vectors = random.four(|random| if random.below(8) == 0 { Vec3::ZERO } else { random.place() });
        let (units, lengths, inverses, none) = normalize(Vec3x4::new(vectors));
        let x = random.four(|random| random.number() / 2.0);
        let y = random.four(|random| random.number() / 2.0);
        let directions = through_plane(camera.forward, camera.right, camera.up, numbers(x), numbers(y));
        for k in 0..4 {
            let found = (none >> k & 1 == 0).then(|| (units.lane(k), lane(&lengths, k), lane(&inverses, k)));
            assert_eq!(found, LengthVector::normalize(vectors[k]));
            assert_eq!(directions.lane(k), camera.direction(x[k], y[k]));
        }
    });
}
