//! Paths in the Cornell box, against what another program of paths finds there: the mean radiosity of its surfaces.

#![allow(clippy::indexing_slicing, reason = "a test may panic")]

use core::f64::consts::PI;

use rta_core::camera::{Camera, Lens};
use rta_core::illumination::Lambert;
use rta_core::needs::Everything;
use rta_core::range::Admitted;
use rta_core::sampling::pairs::Pairs;
use rta_core::trace::dice::{Lamps, Sample};
use rta_core::trace::path::{Asked, Rules};
use rta_core::trace::{Distributed, Paths, Trace, Tracer};
use rta_core::vector::Vector;
use rta_scenes::accelerator::bvh;
use rta_scenes::accelerator::search::Search;
use rta_scenes::description::{Description, Quad, bilinear};
use rta_scenes::narrow::{Narrow, narrow};
use rta_scenes::sampler::{Integrator, Sobol, Spreading};

/// By the number of a quad: its name, its radiosity, and the standard error of that of the first register.
const KNOWN: [(usize, &str, [f64; 3], f64); 7] = [
    (0, "floor", [0.3529, 0.2347, 0.0636], 0.0030),
    (2, "ceiling", [0.3053, 0.1820, 0.0427], 0.0001),
    (3, "back", [0.5307, 0.3479, 0.0938], 0.0013),
    (4, "green", [0.1100, 0.2385, 0.01434], 0.0003),
    (5, "red", [0.4451, 0.0297, 0.0068], 0.0034),
    (6, "short block's top", [0.9951, 0.6965, 0.2044], 0.0048),
    (11, "tall block's top", [2.2873, 1.5113, 0.4701], 0.0036),
];

/// Seeds of which each has as many points of each surface, with one path at each.
const SEEDS: u32 = 32;
const POINTS: u32 = if cfg!(debug_assertions) { 128 } else { 8192 };

/// How far the eye is from the place that it looks at: less than the lamp is from the ceiling.
const NEAR: f64 = 0.0002;

fn cornell() -> Description {
    rta_scenes::read(include_str!("../cornell.rta").as_bytes(), "cornell.rta").expect("it is one")
}

/// Returns a place of a quad for a pair of numbers, the normal there, and the area of the quad about it.
fn place(corners: [[f64; 3]; 4], [u, v]: [f64; 2]) -> ([f64; 3], [f64; 3], f64) {
    let [a, b, c, d] = corners;
    let along = |i: usize| (1.0 - v) * (b[i] - a[i]) + v * (c[i] - d[i]);
    let across = |i: usize| (1.0 - u) * (d[i] - a[i]) + u * (c[i] - b[i]);
    let normal = [0, 1, 2].map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        along(j) * across(k) - along(k) * across(j)
    });
    let area = normal.map(|c| c * c).iter().sum::<f64>().sqrt();
    (bilinear(corners, [u, v]), normal.map(|c| c / area), area)
}

/// Returns the mean radiosity of a surface and its standard error, for each register.
fn radiosity<S: Narrow>(scene: &Description, quad: &Quad, rules: Rules) -> [[f64; 2]; 3] {
    let narrowed = narrow::<S>(scene, 1.0).expect("it fits");
    let built = bvh::build::<S>(scene);
    let search = built.bvh().map_or(Search::Lists, Search::Hierarchy);
    let limits = narrowed.admit().expect("it fits").limits;
    let admitted = Admitted::baked(narrowed.scene(), limits, search);
    let tracer: Tracer<'_, S, _, Everything, 1, _> =
        Tracer::new(&admitted, Lambert::default(), 0).expect("not deep");
    let samples = Sobol::new(1, 0).expect("one");
    let asked = Spreading { samples, lamps: Lamps::Point, split: 1, integrator: Integrator::Whitted };
    let spread = narrowed.spread(&asked);
    let corners = quad.corners(&scene.triangles).expect("it has some");
    let mut sums = [[0.0; 2]; 3];
    for seed in 0..SEEDS {
        let rays = Distributed { tracer, spread: &spread, seed };
        let paths = Paths { spread: rays, emitters: &narrowed.spreads.emitters, rules };
        let pairs = Pairs::new(0, 0, 9, seed);
        let (mut light, mut whole) = ([0.0; 3], 0.0);
        for number in 0..POINTS {
            let (at, normal, area) = place(corners, pairs.units::<f64>(number));
            let vector = |of: [f64; 3]| of.map(S::length);
            let [x, y, z] = vector([0, 1, 2].map(|i| at[i] + NEAR * normal[i]));
            let [right, forward, up] = normal.map(|c| S::unit(-c));
            let camera =
                Camera::new(Vector::new(x, y, z), Vector::new(right, forward, up), Lens::new(1, 1, (1, 1)));
            let middle = (S::unit(0.0), S::unit(0.0));
            let sample = Sample { x: 1, y: 2, number };
            let own = paths.sample(&camera, middle, sample, &mut Default::default(), &mut ());
            for (sum, own) in light.iter_mut().zip([own.r, own.g, own.b]) {
                *sum += area * PI * S::light_to_f64(own);
            }
            whole += area;
        }
        for (sums, light) in sums.iter_mut().zip(light) {
            let mean = light / whole;
            *sums = [sums[0] + mean, sums[1] + mean * mean];
        }
    }
    let n = f64::from(SEEDS);
    sums.map(|[sum, squares]| {
        let mean = sum / n;
        [mean, ((squares / n - mean * mean).max(0.0) / (n - 1.0)).sqrt()]
    })
}

fn check<S: Narrow>(rules: Rules) {
    let scene = cornell();
    for (number, name, known, error) in KNOWN {
        let found = radiosity::<S>(&scene, &scene.quads[number], rules);
        println!("{name}: {found:.5?}, known {known:?} +- {error}");
        for ([mean, own], exact) in found.into_iter().zip(known) {
            // The known error of the others is as large a part of them; the numbers are rounded.
            let known_error = error * exact / known[0];
            let both = own.hypot(known_error);
            assert!((mean - exact).abs() < 4.0 * both + 6e-5, "{name}: {found:?}, known {known:?}");
            assert!(own < 0.1 * mean, "{name}: {found:?}");
        }
    }
}

#[test]
fn the_cornell_box_has_the_radiosity_that_others_find() {
    check::<f64>(Rules::default());
}

#[test]
fn so_it_has_in_f32_without_weights() {
    check::<f32>(Rules { weighs: false, lamps: Asked::All, ..Rules::default() });
}
