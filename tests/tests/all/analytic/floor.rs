//! The sky, the tiles of the floor, and a shadow on it.

#![allow(clippy::indexing_slicing, reason = "arrays of three")]

use rta_core::illumination::Rta;
use rta_core::material::Material;
use rta_core::scene::{Scene, Sky};
use rta_core::shape::Floor;
use rta_core::vector::Vector;
use rta_tests::assert_close;
use rta_tests::measure::{Measure, direction, light, place, read_direction};

use super::{RADIANCE, WHITE, assert_light, dark, dot, floor, glass, lamp, minus, see, sphere};

in_every_format! {
    sky tiles far_floor shadow_of_a_sphere
}

fn sky<S: Measure>() {
    let (horizon, zenith) = ([0.75, 0.82, 0.95], [0.1, 0.22, 0.6]);
    let scene =
        Scene { sky: Sky { horizon: light::<S>(horizon), zenith: light::<S>(zenith) }, ..dark::<S>() };
    for elevation in [-90.0_f64, -45.0, 0.0, 10.0, 30.0, 60.0, 90.0] {
        let (sine, cosine) = elevation.to_radians().sin_cos();
        let s = sine * sine;
        let want = [0, 1, 2].map(|i| (1.0 - s) * horizon[i] + s * zenith[i]);
        for towards in [[cosine, 0.0, sine], [-0.6 * cosine, 0.8 * cosine, sine]] {
            let got = see(scene, Rta, 5, [1.0, 2.0, 3.0], towards);
            for (got, want) in got.into_iter().zip(want) {
                assert_close!(got, want, 4.0 * S::LIGHT, RADIANCE, "elevation {elevation}");
            }
        }
    }
}

/// The edge of a sphere's shadow on the floor is where the cone from the lamp around the sphere meets the floor: a
/// circle below the lamp, an ellipse aside of it.
fn shadow_of_a_sphere<S: Measure>() {
    let (center, radius) = ([0.0, 0.0, 5.0], 1.0);
    let eye = [14.0, -17.0, 2.5];
    for position in [[0.0, 0.0, 10.0], [-4.0, 3.0, 10.0]] {
        let axis = minus(center, position);
        let d = dot(axis, axis).sqrt();
        let axis = axis.map(|c| c / d);
        // Two directions across the axis, which is not parallel to x.
        let u = [axis[2], 0.0, -axis[0]];
        let u = u.map(|c| c / dot(u, u).sqrt());
        let v = [
            axis[1] * u[2] - axis[2] * u[1],
            axis[2] * u[0] - axis[0] * u[2],
            axis[0] * u[1] - axis[1] * u[0],
        ];
        let edge = (radius / d).asin();
        for (material, part) in [
            (Material::Opaque, 0.0),
            (Material::Shiny, 0.0),
            (Material::Mirror, 0.0),
            // Once for the whole sphere, though the ray goes in and out.
            (Material::Transparent(glass::<S>(0.4, 1.5)), 0.6),
        ] {
            let balls = [sphere::<S>(center, radius, WHITE)];
            let (materials, floor) = ([material], Some(floor(WHITE, WHITE)));
            let lamps = [lamp::<S>(position, 0.0, [50.0; 3])];
            let scene = Scene { spheres: &balls, materials: &materials, lamps: &lamps, floor, ..dark::<S>() };
            for step in 0..16 {
                let (sine, cosine) = (f64::from(step) * core::f64::consts::TAU / 16.0).sin_cos();
                for (share, through) in [(0.5, part), (0.999, part), (1.001, 1.0), (1.5, 1.0)] {
                    let (s, c) = (share * edge).sin_cos();
                    let ray = [0, 1, 2].map(|i| c * axis[i] + s * (cosine * u[i] + sine * v[i]));
                    let way = -position[2] / ray[2];
                    let target = [position[0] + way * ray[0], position[1] + way * ray[1], 0.0];
                    let want = through * 50.0 * -ray[2] / (way * way);
                    let got = see(scene, Rta, 0, eye, minus(target, eye));
                    let case = format!("lamp at {position:?}, {share} of the way to the edge at step {step}");
                    assert_light::<S>(got, [want; 3], &case);
                }
            }
        }
    }
}

/// Sides of tiles; the first is that of a floor that says nothing.
const SIDES: [f64; 4] = [3.0, 0.25, 1.0, 7.3];

/// Returns a floor of red and green tiles.
fn tiled<S: Measure>(side: f64) -> Scene<'static, S> {
    let tile = Some(S::length(side)).filter(|_| side != 3.0);
    let floor = Some(Floor { tile, ..floor([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]) });
    Scene { floor, ambient: light::<S>(WHITE), ..dark::<S>() }
}

/// Returns the colour of a tile of the floors here, which have this side: red where it is even, green where it is odd.
fn tile(side: f64, x: f64, y: f64) -> [f64; 3] {
    // From -1 to 1 for an odd sum, whatever its sign.
    let odd = ((x / side).floor() + (y / side).floor()).rem_euclid(2.0) > 0.5;
    if odd { [0.0, 1.0, 0.0] } else { [1.0, 0.0, 0.0] }
}

fn tiles<S: Measure>() {
    for side in SIDES {
        let scene = tiled::<S>(side);
        let edges = (-3..=3).map(|edge| f64::from(edge) * side);
        let places: Vec<f64> = edges.flat_map(|e| [e - 0.01, e + 0.01, e + side / 2.0]).collect();
        // From below the normal points down, and the ambient term is 0.2.
        for (eye, ambient) in [([0.3, 0.4, 20.0], 1.0), ([-5.0, 7.0, -11.0], 0.2)] {
            for &x in &places {
                for &y in &places {
                    let got = see(scene, Rta, 0, eye, minus([x, y, 0.0], eye));
                    let want = tile(side, x, y).map(|register| ambient * register);
                    assert_light::<S>(got, want, &format!("at {x}, {y} from {eye:?}, tiles of {side}"));
                }
            }
        }
    }
}

/// A place has the colour of its tile up to a million units away, which is farther than Q16.16 can hold.
fn far_floor<S: Measure>() {
    let mut dice = fastrand::Rng::with_seed(3);
    let (mut looked, mut odd) = (0, 0);
    for side in SIDES.into_iter().cycle().take(4000) {
        let scene = tiled::<S>(side);
        let height = 1.0 + 99.0 * dice.f64();
        let eye = [200.0 * dice.f64() - 100.0, 200.0 * dice.f64() - 100.0, height];
        // From 1000 to 1 000 000 units away.
        let way = 1000.0 * 1000.0_f64.powf(dice.f64());
        let (sine, cosine) = (core::f64::consts::TAU * dice.f64()).sin_cos();
        let towards = [way * sine, way * cosine, -height];
        // Where the ray goes that the format has made of it, from the eye that it has made of it.
        let ray = read_direction::<S>(direction::<S>(towards));
        let from = place::<S>(eye);
        let from = [from.x(), from.y(), from.z()].map(S::to_f64);
        let t = from[2] / -ray[2];
        let target = [from[0] + t * ray[0], from[1] + t * ray[1]];
        // Not where a rounding on the way decides.
        let blur = 0.01 + 4.0 * (t * S::UNIT + S::LENGTH);
        // A side in the format is rounded too, which adds up over many tiles.
        let blur = blur + way / side * (S::length(side).to_f64() - side).abs();
        let edge = |c: f64| (c / side - (c / side).round()).abs() * side;
        if edge(target[0]) < blur || edge(target[1]) < blur {
            continue;
        }
        let got = see(scene, Rta, 0, eye, towards);
        let want = tile(side, target[0], target[1]);
        assert_light::<S>(got, want, &format!("{t} units away at {target:?}"));
        looked += 1;
        odd += u32::from(want[1] > 0.5);
    }
    assert!(looked > 1000 && odd > looked / 3 && odd < looked * 2 / 3, "{odd} odd tiles of {looked}");
}
