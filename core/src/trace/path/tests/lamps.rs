//! Paths and lamps: shadow rays and paths find the same light.

use core::f64::consts::PI;

use super::{
    Asked, Emitter, PLAIN, Rules, Traced, assert_one_mean, black_sky, coat, direction, grey, halves, place,
};
use crate::illumination::{Lambert, Rta};
use crate::light::Lamp;
use crate::light::area::Square;
use crate::material::{Finish, Glass, Material};
use crate::scalar::{Exponent, Positive};
use crate::scene::{PLAIN as PLAIN_MATERIAL, Scene};
use crate::shape::{Floor, Sphere};
use crate::trace::dice::Spread;

/// The ways in which lamps are asked.
const WAYS: [Rules; 4] = [
    PLAIN,
    Rules { lamps: Asked::One, ..PLAIN },
    Rules { lamps: Asked::One, weighs: true, ..PLAIN },
    Rules { lamps: Asked::All, weighs: true, roulette: Some(1), ..PLAIN },
];

/// Returns the light of a white floor under a sphere lamp of the radiance 1, whose middle is in that direction, by each way.
fn under(way: [f64; 3], radius: f64) -> [[f64; 2]; 4] {
    let mut lamp = [Lamp::white(place::<f64>(way), radius, 1)];
    lamp[0].power = radius * radius;
    let floor = Some(Floor { colors: [grey::<f64>(1.0); 2], tile: None, material: PLAIN_MATERIAL });
    let scene = Scene { lamps: &lamp, floor, ..black_sky() };
    // The eye sees the floor at 0.
    let traced = Traced {
        scene,
        spread: Spread::NONE,
        emitters: &[],
        eye: [0.0, -0.6, 0.8],
        towards: [0.0, 0.6, -0.8],
    };
    WAYS.map(|rules| traced.mean(&Lambert::default(), rules, 1024))
}

#[test]
fn a_sphere_lamp_is_as_bright_as_it_should_be() {
    // r .5, d 3, cosine .6: (r/d)^2 cos. And one that sets, r .5, d 1.
    let set = under([1.0, 0.0, 0.0], 0.5);
    let above = under([2.4, 0.0, 1.8], 0.5);
    assert_one_mean(&above, 0.016_666_667);
    assert_one_mean(&set, 0.028_834_443);
    for [mean, error] in above.into_iter().chain(set) {
        assert!(error < 0.05 * mean, "{mean} +- {error}");
    }
}

/// Returns the light of a floor of that material under a square lamp and a ball, by each way of the rules.
fn room(material: Material<f64>, roughness: f64, ways: &[Rules]) -> [[f64; 2]; 4] {
    // The lamp, of the radiance 3 and the side 2, at the height 2, and a white ball beside the place that is seen.
    let corners = [[-1.0, 0.5, 2.0], [-1.0, 2.5, 2.0], [1.0, 0.5, 2.0]];
    let down = [0.0, 0.0, -1.0];
    let triangles = halves::<f64>(corners, down, (0.4, 1));
    let corner = place::<f64>(corners[0]);
    let edges = [place::<f64>(corners[1]) - corner, place::<f64>(corners[2]) - corner];
    let least = 2.0 / 64.0;
    let squares = [Some(Square {
        corner,
        middle: place::<f64>([0.0, 1.5, 2.0]),
        edges,
        normal: direction::<f64>(down),
        least: (least, 1.0 / least),
    })];
    let mut lamp = [Lamp::white(place::<f64>([0.0, 1.5, 2.0]), 0.0, 1)];
    lamp[0].power = <f64 as Positive>::new(3, 0) * 4.0 / PI;
    let emitters = [Emitter { lamp: 0, triangle: 0, area: 4.0 }];
    let floor = Some(Floor { colors: [grey::<f64>(0.5); 2], tile: None, material: 0 });
    let spheres = [Sphere::new(place::<f64>([0.9, 0.4, 0.4]), 0.4, grey::<f64>(0.8), PLAIN_MATERIAL)];
    let materials = [material, Material::Opaque];
    let coats = [coat::<f64>(0.0), coat::<f64>(3.0)];
    let scene = Scene {
        triangles: &triangles,
        spheres: &spheres,
        materials: &materials,
        coats: &coats,
        lamps: &lamp,
        floor,
        ..black_sky()
    };
    let rough = [roughness];
    let spread = Spread { squares: &squares, roughness: &rough, ..Spread::NONE };
    let traced =
        Traced { scene, spread, emitters: &emitters, eye: [0.0, -0.6, 0.8], towards: [0.0, 0.6, -0.8] };
    core::array::from_fn(|i| traced.mean(&Rta, ways[i], 512))
}

fn finish(kd: f64, ks: f64, kt: f64) -> Material<f64> {
    let exponent = Exponent::new(10, 0);
    let glass = Glass { ks, kt, eta: 1.0 / 1.5, denser: true };
    Material::Finish(Finish { ka: 0.0, kd, exponent, reflected: exponent, glass })
}

#[test]
fn weights_change_no_mean_of_a_rough_mirror() {
    for (roughness, kd, ks) in [(0.3, 0.4, 0.5), (0.1, 0.0, 0.9), (0.7, 0.3, 0.6)] {
        let means = room(finish(kd, ks, 0.0), roughness, &WAYS);
        // Against the mean that is surest.
        let [best, error] = means.into_iter().fold([0.0, 1.0], |a, b| if b[1] < a[1] { b } else { a });
        assert!(best > 0.01 && error < 0.02 * best, "{means:?}");
        for [mean, own] in means {
            let both = libm::sqrt(own * own + error * error);
            assert!((mean - best).abs() < 5.0 * both, "roughness {roughness}: {means:?}");
        }
    }
}

#[test]
fn smooth_mirrors_and_glass_see_the_lamp_by_the_path_alone() {
    // The ray is reflected at right angles to where the lamp is, and the ball is seen as well.
    let means = room(finish(0.3, 0.3, 0.3), 0.0, &WAYS);
    let [best, error] = means.into_iter().fold([0.0, 1.0], |a, b| if b[1] < a[1] { b } else { a });
    for [mean, own] in means {
        assert!((mean - best).abs() < 5.0 * libm::sqrt(own * own + error * error), "{means:?}");
    }
    // The mirror's image of the lamp alone is .3 of the radiance 3, of a floor of the colour .5.
    assert!(best > 0.3 * 0.5 * 3.0, "{means:?}");
}

#[test]
fn weighing_makes_less_noise_where_either_way_makes_much() {
    let [_, path, both, _] = room(finish(0.0, 0.9, 0.0), 0.7, &WAYS);
    assert!(both[1] < 0.2 * path[1], "{both:?}, {path:?}");
}
