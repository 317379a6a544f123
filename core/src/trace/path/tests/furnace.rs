//! Furnaces: closed rooms that emit everywhere, whose light is a geometric sum.

use core::f64::consts::PI;

use super::{
    Asked, Emitter, PLAIN, Read, Rules, Traced, assert_one_mean, black_sky, coat, cube, grey, light, place,
    sides,
};
use crate::illumination::{Lambert, Whitted};
use crate::light::Lamp;
use crate::light::area::Square;
use crate::material::Material;
use crate::ray::RayKind;
use crate::sampling::pairs::Purpose;
use crate::scalar::read::direction;
use crate::scalar::{Positive, Q16, Q20, Scalar};
use crate::scene::{PLAIN as PLAIN_MATERIAL, Scene, Sky};
use crate::shape::Sphere;
use crate::trace::Observer;
use crate::trace::decision::Start;
use crate::trace::dice::{Sample, Spread, Thrown};

/// What paths in a cube of this reflectance and this radiance count.
fn furnace<S: Read, O: Observer<S>>(
    (reflectance, radiance): (f64, f64),
    paths: (Rules, u32, u32),
    observer: &mut O,
    see: impl FnMut(f64),
) {
    let (triangles, materials, coats) =
        (cube::<S>(reflectance, 0), [Material::Opaque], [coat::<S>(radiance)]);
    let scene = Scene { triangles: &triangles, materials: &materials, coats: &coats, ..black_sky() };
    let (eye, towards) = ([0.1, -0.2, 0.3], [0.6, 0.0, 0.8]);
    let traced = Traced { scene, spread: Spread::NONE, emitters: &[], eye, towards };
    traced.paths(Lambert::default(), paths, observer, see);
}

#[test]
fn each_path_is_a_geometric_sum() {
    let sums = [(0, 1.0), (1, 1.5), (5, 1.968_75), (64, 2.0)];
    for (bounces, exact) in sums {
        let rules = Rules { bounces, ..PLAIN };
        furnace::<f64, _>((0.5, 1.0 / PI), (rules, 1, 64), &mut (), |light| {
            // The emission is a whole number of 2^-30.
            assert!((light * PI - exact).abs() < 1e-8, "{bounces}: {}", light * PI);
        });
        // Powers of two: exact.
        furnace::<f64, _>((0.5, 1.0), (rules, 2, 64), &mut (), |light| {
            assert!((light - exact).abs() < 1e-12, "{bounces}: {light}");
        });
        for error in
            [formats::<f32>(rules, exact), formats::<Q16>(rules, exact), formats::<Q20>(rules, exact)]
        {
            assert!(error < 1e-3, "{bounces}: {error}");
        }
    }
}

fn formats<S: Read>(rules: Rules, exact: f64) -> f64 {
    let mut most = 0.0f64;
    furnace::<S, _>((0.5, 1.0), (rules, 2, 16), &mut (), |light| most = most.max((light - exact).abs()));
    most
}

#[test]
fn bright_walls_need_many_bounces() {
    for (bounces, exact) in [(5, 0.234_866_859), (64, 1.0 / PI)] {
        let rules = Rules { bounces, ..PLAIN };
        furnace::<f64, _>((0.8, 0.2 / PI), (rules, 1, 16), &mut (), |light| {
            assert!((light - exact).abs() < 2e-7, "{bounces}: {light}");
        });
    }
}

/// Counts rays, and paths that are cut.
#[derive(Default)]
struct Count {
    rays: u32,
    cut: u32,
}

impl<S: Scalar> Observer<S> for Count {
    fn ray(&mut self, _kind: RayKind, _depth: u8, _start: &Start<S>) {
        self.rays += 1;
    }

    fn cut(&mut self) {
        self.cut += 1;
    }
}

#[test]
fn roulette_ends_a_path_as_often_as_its_weight_says() {
    let mut count = Count::default();
    let rules = Rules { roulette: Some(1), ..PLAIN };
    let mut sum = 0.0;
    furnace::<f64, _>((0.8, 0.25), (rules, 5, 1 << 15), &mut count, |light| sum += light);
    let paths = f64::from(1 << 15);
    let bounces = f64::from(count.rays) / paths - 1.0;
    // The weight falls to .8, over the chance .95; then to .8 of that, over 4/3 of as much. From then on it is 3/4 after each bounce, and the
    // number of further ones geometric: of the standard deviation sqrt(.8) / .2.
    let second = 4.0 / 3.0 * 0.8 * 0.8 / 0.95;
    let exact = 0.95 * (1.0 + second * (1.0 + 0.8 / 0.2));
    let error = libm::sqrt(0.8) / 0.2 / libm::sqrt(paths);
    assert!((bounces - exact).abs() < 5.0 * error, "{bounces}, not {exact}");
    assert!((sum / paths - 1.25).abs() < 5.0 * 0.25 * error, "{}", sum / paths);
    assert_eq!(count.cut, 0);
    // Without it, each path is cut.
    let mut count = Count::default();
    furnace::<f64, _>((0.8, 0.25), (Rules { bounces: 3, ..PLAIN }, 5, 100), &mut count, |_| {});
    assert_eq!((count.rays, count.cut), (400, 100));
}

/// Lamps as they are asked, as lamps of a scene, and as what paths meet.
type Panels = ([Option<Square<f64>>; 6], [Lamp<f64>; 6], [Emitter<f64>; 6]);

/// The sides of the cube as lamps: parallelograms, and what says that they are the cube's triangles.
fn panels(radiance: f64) -> Panels {
    let area = 4.0;
    let squares = sides().map(|([corner, first, second], normal)| {
        let corner = place::<f64>(corner);
        let edges = [place::<f64>(first) - corner, place::<f64>(second) - corner];
        let least = 2.0 / 64.0;
        let middle = place::<f64>(normal.map(|c| -c));
        Some(Square { corner, middle, edges, normal: direction::<f64>(normal), least: (least, 1.0 / least) })
    });
    let lamps = sides().map(|(_, normal)| {
        let middle = normal.map(|c| -c);
        let mut lamp = Lamp::white(place::<f64>(middle), 0.0, 1);
        lamp.power = <f64 as Positive>::new(1, 0) * radiance * area / PI;
        lamp
    });
    let emitters = [0, 1, 2, 3, 4, 5].map(|lamp| Emitter { lamp, triangle: 2 * lamp, area });
    (squares, lamps, emitters)
}

#[test]
fn roulette_and_weights_change_no_mean() {
    let (triangles, materials, coats) = (cube::<f64>(0.98, 0), [Material::Opaque], [coat::<f64>(0.25)]);
    let (squares, lamps, emitters) = panels(0.25);
    let scene =
        Scene { triangles: &triangles, materials: &materials, coats: &coats, lamps: &lamps, ..black_sky() };
    let spread = Spread { squares: &squares, ..Spread::NONE };
    let (eye, towards) = ([0.1, -0.2, 0.3], [0.6, 0.0, 0.8]);
    let traced = Traced { scene, spread, emitters: &emitters, eye, towards };
    let exact = 0.25 * (1.0 - libm::pow(0.98, 65.0)) / (1.0 - 0.98);
    let mut means = [[0.0; 2]; 10];
    let ways = [
        (Asked::None, false),
        (Asked::One, false),
        (Asked::All, false),
        (Asked::One, true),
        (Asked::All, true),
    ];
    for (i, (asked, weighs)) in ways.into_iter().enumerate() {
        for (j, roulette) in [None, Some(4)].into_iter().enumerate() {
            let rules = Rules { roulette, lamps: asked, weighs, ..PLAIN };
            means[2 * i + j] = traced.mean(&Lambert::default(), rules, 64);
        }
    }
    assert!((means[0][0] - exact).abs() < 1e-9, "without any chance: {means:?}");
    assert!(means[1..].iter().all(|[_, error]| *error > 0.0 && *error < 0.05 * exact), "{means:?}");
    assert_one_mean(&means, exact);
}

/// Returns by how much a white ball in a white sky, with ambient light that paths have not, is seen at most.
fn seen<S: Read>(rules: Rules) -> f64 {
    let white = light::<S>(1.0);
    let spheres = [Sphere::new(place::<S>([0.0, 4.0, 0.0]), S::length(1.0), grey::<S>(1.0), PLAIN_MATERIAL)];
    let sky = Sky { horizon: white, zenith: white };
    let scene = Scene { spheres: &spheres, ..Scene::empty(sky, light::<S>(0.5)) };
    let mut most = 0.0f64;
    for k in 0..32u32 {
        // From the middle to beyond the rim.
        let right = f64::from(k) / 31.0 * 0.3;
        let length = libm::sqrt(1.0 + right * right);
        let towards = [right / length, 1.0 / length, 0.0];
        let traced = Traced { scene, spread: Spread::NONE, emitters: &[], eye: [0.0; 3], towards };
        let mut see = |light: f64| most = most.max((light - 1.0).abs());
        traced.paths(Whitted::default(), (rules, k, 4), &mut (), &mut see);
        traced.paths(Lambert::default(), (rules, k, 4), &mut (), &mut see);
    }
    most
}

#[test]
fn a_white_ball_vanishes_in_a_white_sky() {
    for rules in [PLAIN, Rules::default()] {
        assert!(seen::<f64>(rules) < 1e-12 && seen::<f32>(rules) < 1e-6);
        let lsb = 1.0 / 65_536.0;
        let seen = [seen::<Q16>(rules), seen::<Q20>(rules)];
        assert!(seen.iter().all(|seen| *seen <= lsb), "{seen:?}");
    }
}

#[test]
fn no_two_bounces_use_the_same_numbers() {
    let spread = Spread::<f64>::NONE;
    let dice = Thrown { spread: &spread, sample: Sample { x: 7, y: 9, number: 3 }, seed: 5 };
    let purposes = [Purpose::Lobe, Purpose::Lamp, Purpose::Choice];
    let pairs: [[u32; 2]; 123] = core::array::from_fn(|i| {
        let node = u32::try_from(i / 3).expect("small") + 1;
        dice.words(purposes[i % 3], node)
    });
    for (i, pair) in pairs.iter().enumerate() {
        assert!(!pairs[..i].contains(pair), "pair {i}");
    }
}
