//! Random scenes of every kind of object, that are hard on a search: sizes that differ a thousandfold, objects that touch and
//! coincide, rays through many glasses. Each seed is another scene, and the same each time.

#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use fastrand::Rng;
use rta_scenes::description::{
    Camera, Cone, Cylinder, Description, Ellipsoid, FallOff, Floor, Lamp, Plane, Sphere, Surface, Triangle,
};
use rta_scenes::{dat, shipped};

/// Returns `count` spheres of sizes that differ a thousandfold, in clusters and far from each other; two of them coincide.
pub(crate) fn cloud(count: usize, spread: f64, seed: u64) -> Description {
    let mut rng = Rng::with_seed(seed);
    let mut scene = dat::read(shipped::JUGGLER.as_bytes(), "juggler.dat").expect("a shipped scene");
    let mut center = [0.0; 3];
    scene.spheres = (0..count)
        .map(|i| {
            if i % 7 == 0 {
                center = [(); 3].map(|()| spread * (rng.f64() - 0.5));
            }
            let radius = spread * 0.05 * 10f64.powf(-3.0 * rng.f64());
            let position = center.map(|c| c + spread * 0.05 * (rng.f64() - 0.5));
            // Rays that go through many glasses, each of which lets another part through.
            let kt = 0.5 + 0.5 * rng.f64();
            let glass = Surface::Transparent { ks: 1.0 - kt, kt, ior: 1.5 };
            let surface = if i % 5 == 0 { Surface::Opaque } else { glass };
            Sphere { position, color: [0.8, 0.5, 0.3], radius, surface, line: 0 }
        })
        .collect();
    let twin = scene.spheres[count / 2].clone();
    scene.spheres.insert(count / 3, twin);
    scene
}

/// Returns a [`cloud`] with a cone, a triangle and an ellipsoid beside every other larger sphere.
pub(crate) fn medley(count: usize, spread: f64, seed: u64) -> Description {
    let mut scene = cloud(count, spread, seed);
    let mut rng = Rng::with_seed(seed + 1);
    for sphere in scene.spheres.iter().filter(|sphere| sphere.radius > 0.02).step_by(2) {
        let (radius, position, color) = (sphere.radius, sphere.position, sphere.color);
        let side = rng.u8(..4);
        let mut near = |size: f64| position.map(|c| c + size * radius * (2.0 * rng.f64() - 1.0));
        let (surface, line) = (Surface::Opaque, 0);
        let vertices = [near(2.0), near(2.0), near(2.0)];
        scene.triangles.push(Triangle {
            vertices,
            normals: None,
            one_sided: side == 0,
            color,
            surface,
            line,
        });
        let [base, apex] = [near(2.0), near(2.0)];
        let radii = [radius, 0.2 * radius, 0.0];
        let (base_radius, apex_radius) = (radii[rng.usize(..2)], radii[rng.usize(..3)]);
        let (capped, inside_only) = (rng.bool(), rng.u8(..4) == 0);
        scene.cones.push(Cone {
            base,
            base_radius,
            apex,
            apex_radius,
            capped,
            inside_only,
            color,
            surface,
            line,
        });
        let radii = [radius, 0.5 * radius, 0.7 * radius];
        scene.ellipsoids.push(Ellipsoid {
            position: base,
            radii,
            inside_only: side == 1,
            color,
            surface,
            line,
        });
    }
    scene
}

/// Returns a place up to `reach` about another along each axis.
fn about(place: [f64; 3], reach: f64, rng: &mut Rng) -> [f64; 3] {
    place.map(|c| c + reach * (2.0 * rng.f64() - 1.0))
}

fn surface(rng: &mut Rng) -> Surface {
    match rng.u8(..8) {
        0 => return Surface::Opaque,
        1 => return Surface::Shiny,
        2 => return Surface::Mirror,
        3 => return Surface::Transparent { ks: 0.2, kt: 0.8, ior: [0.8, 1.0, 1.5][rng.usize(..3)] },
        _ => {}
    }
    let (kd, ks, kt) = [(1.0, 0.0, 0.0), (0.6, 0.3, 0.0), (0.3, 0.2, 0.5)][rng.usize(..3)];
    Surface::Finish { kd, ks, exponent: 20.0, kt, ior: 1.1 }
}

/// Returns clusters of all sizes, up to 400 objects of every kind, but in each third scene up to 8; the eye is among them or before
/// them, lamps are among them or up to 60 times as far away; there may be a floor of two triangles, or a chequered one with
/// cylinders.
pub(crate) fn clusters(seed: u64) -> Description {
    let rng = &mut Rng::with_seed(seed);
    let spread = 10f64.powf(2.0 * rng.f64() - 0.5);
    let (eye, at) = (about([0.0; 3], 1.5 * spread, rng), about([0.0; 3], 0.5 * spread, rng));
    let way = [0, 1, 2].map(|axis| at[axis] - eye[axis]);
    let length = way.iter().map(|c| c * c).sum::<f64>().sqrt();
    let camera = Camera::upright(eye, way.map(|c| c / length), 0.7);
    let mut scene = Description { ambient: [0.3; 3], ..Description::empty(camera) };
    let (mut center, mut size) = ([0.0; 3], spread);
    let few = seed % 3 == 2;
    for number in 0..rng.usize(if few { 1..9 } else { 9..400 }) {
        if number % 9 == 0 {
            center = about([0.0; 3], spread, rng);
            size = spread * 10f64.powf(-1.5 * rng.f64());
        }
        let [a, b, c] = [1.0, 0.5, 1.0].map(|reach| about(center, reach * size, rng));
        let radius = size * (0.02 + 0.2 * rng.f64());
        let (color, surface, line) = ([0.3 + 0.6 * rng.f64(), 0.5, 0.7], surface(rng), 0);
        match rng.u8(..6) {
            0 => scene.triangles.push(Triangle {
                vertices: [a, b, c],
                normals: None,
                one_sided: number % 3 == 0,
                color,
                surface,
                line,
            }),
            1 => scene.cones.push(Cone {
                base: a,
                base_radius: 0.3 * radius,
                apex: b,
                apex_radius: 0.3 * radius * rng.f64(),
                capped: rng.bool(),
                inside_only: false,
                color,
                surface,
                line,
            }),
            2 => {
                let radii = [radius, 0.6 * radius, 0.8 * radius];
                scene.ellipsoids.push(Ellipsoid {
                    position: a,
                    radii,
                    inside_only: number % 3 == 0,
                    color,
                    surface,
                    line,
                });
            }
            _ => scene.spheres.push(Sphere { position: a, radius, color, surface, line }),
        }
    }
    for _ in 0..seed % 4 / 2 * (1 + seed % 2) {
        let (point, normal) = (about([0.0; 3], spread, rng), about([0.0; 3], 1.0, rng));
        scene.planes.push(Plane { point, normal, color: [0.5; 3], surface: surface(rng), line: 0 });
    }
    if rng.bool() {
        let (wide, z) = (8.0 * spread, -spread);
        let [a, b, c, d] = [[-wide, -wide, z], [wide, -wide, z], [wide, wide, z], [-wide, wide, z]];
        for vertices in [[a, b, c], [a, c, d]] {
            let (color, surface) = ([0.5; 3], surface(rng));
            scene.triangles.push(Triangle {
                vertices,
                normals: None,
                one_sided: false,
                color,
                surface,
                line: 0,
            });
        }
    }
    if rng.u8(..4) == 0 {
        scene.floor = Some(Floor { colors: [[0.9; 3], [0.2; 3]], surface: Surface::Opaque });
        for _ in 0..rng.usize(..6) {
            let (position, surface) = (about([0.0; 3], spread, rng), surface(rng));
            let radius = 0.2 * spread * rng.f64() + 0.001 * spread;
            scene.cylinders.push(Cylinder { position, radius, color: [0.6; 3], surface, line: 0 });
        }
    }
    for _ in 0..rng.usize(1..4) {
        let far = [0.5, 2.0, 10.0, 60.0][rng.usize(..4)] * spread;
        let radius = if rng.bool() { 0.05 * spread } else { 0.0 };
        let position = about([0.0; 3], far, rng);
        scene.lamps.push(Lamp {
            position,
            radius,
            color: [0.3 * far * far; 3],
            fall_off: FallOff::OfModel,
            line: 0,
        });
    }
    scene
}
