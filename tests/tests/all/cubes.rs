//! Wherever eye and lamps are, the direction cubes about them hide nothing, and neither do rays that are searched for four by
//! four: pictures of random scenes are the same, to the last bit of light, as those of firmware's search.

#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use fastrand::Rng;
use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, Phong, Rta, Whitted};
use rta_core::lanes::LANES;
use rta_core::needs::Everything;
use rta_core::raster::{Pixels, Raster};
use rta_core::trace::Tracer;
use rta_core::{Q16, Q20};
use rta_scenes::description::{
    Camera, Cone, Cylinder, Description, Ellipsoid, Floor, Lamp, Sphere, Surface, Triangle,
};
use rta_scenes::narrow::{Narrow, Narrowed, narrow};

/// Scenes of each number format.
const SCENES: u64 = 60;
/// Not all rays of a row have three others beside them.
const SIDE: u32 = 46;

/// A place up to `reach` about another along each axis.
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

/// Clusters of all sizes, up to 400 objects of every kind, but in each third scene up to 8; the eye is among them or before them,
/// lamps are among them or up to 60 times as far away; there may be a floor of two triangles, or a chequered one with cylinders.
fn scene(seed: u64) -> Description {
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
            0 => scene.triangles.push(Triangle { vertices: [a, b, c], normals: None, color, surface, line }),
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
                scene.ellipsoids.push(Ellipsoid { position: a, radii, color, surface, line });
            }
            _ => scene.spheres.push(Sphere { position: a, radius, color, surface, line }),
        }
    }
    if rng.bool() {
        let (wide, z) = (8.0 * spread, -spread);
        let [a, b, c, d] = [[-wide, -wide, z], [wide, -wide, z], [wide, wide, z], [-wide, wide, z]];
        for vertices in [[a, b, c], [a, c, d]] {
            let (color, surface) = ([0.5; 3], surface(rng));
            scene.triangles.push(Triangle { vertices, normals: None, color, surface, line: 0 });
        }
    }
    if rng.u8(..4) == 0 {
        scene.floor = Some(Floor { colors: [[0.9; 3], [0.2; 3]] });
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
        scene.lamps.push(Lamp { position, radius, color: [0.3 * far * far; 3], line: 0 });
    }
    scene
}

/// Whether rays are followed one by one, or those of four pixels beside each other.
#[derive(Clone, Copy)]
enum Rays {
    Single,
    Four,
}

fn picture<S: Narrow>(scene: &Narrowed<S>, seed: u64, rays: Rays) -> Vec<Rgb<S::Light>> {
    match seed / 3 % 3 {
        0 => modelled(scene, Phong::default(), rays),
        1 => modelled(scene, Whitted::default(), rays),
        _ => modelled(scene, Rta, rays),
    }
}

fn modelled<S: Narrow, M: Illumination<S>>(scene: &Narrowed<S>, model: M, rays: Rays) -> Vec<Rgb<S::Light>> {
    let admitted = scene.scene().admit(&scene.camera).expect("it fits");
    let tracer: Tracer<S, _, Everything, 3> = Tracer::new(admitted, model, 3).expect("a depth");
    let pixels = Pixels::new(&tracer, &scene.camera, Raster::new(SIDE, SIDE).expect("a raster"));
    let mut picture = Vec::new();
    match rays {
        Rays::Single => {
            for light in pixels {
                picture.push(light);
            }
        }
        Rays::Four => pixels.for_each(|light| picture.push(light)),
    }
    picture
}

fn compare<S: Narrow>() {
    let (mut drawn, mut served) = (0, 0);
    for seed in 0..SCENES {
        let scene = scene(seed);
        // Some lamps are too strong for a format, some triangles too flat.
        let Ok(lanes) = narrow::<S>(&scene, 1.0) else { continue };
        if lanes.scene().admit(&lanes.camera).is_err() {
            continue;
        }
        let firmware = lanes.clone().without_lanes(&scene);
        let (right, single) = (picture(&firmware, seed, Rays::Single), picture(&lanes, seed, Rays::Single));
        assert!(single == right, "scene {seed} in {}", S::NAME);
        assert!(picture(&lanes, seed, Rays::Four) == right, "scene {seed} in {}, four by four", S::NAME);
        drawn += 1;
        served += usize::from(lanes.lanes.cubes.iter().any(|cube| cube.slack > 0.0));
    }
    assert!(drawn > 30, "only {drawn} scenes fit {}", S::NAME);
    assert!(!LANES || served > 30, "only {served} scenes have a cube in {}", S::NAME);
}

#[test]
fn pictures_are_the_same_in_floating_point() {
    compare::<f32>();
    compare::<f64>();
}

#[test]
fn pictures_are_the_same_in_fixed_point() {
    compare::<Q16>();
    compare::<Q20>();
}
