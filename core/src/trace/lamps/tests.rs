//! What of a lamp with a size reaches a place in the air.

use crate::camera::{Camera, Lens};
use crate::color::Rgb;
use crate::illumination::air::{Air, Through};
use crate::illumination::{Flat, Passage, Way};
use crate::light::Lamp;
use crate::light::area::Square;
use crate::needs::{Everything, Needs};
use crate::range::Admitted;
use crate::scalar::read::{Read, direction, place};
use crate::scalar::vector::Vec3;
use crate::scalar::{Light, Scalar, Unit};
use crate::scene::{PLAIN, Scene, Sky};
use crate::shape::Triangle;
use crate::trace::dice::{Lamps, Sample, Spread};
use crate::trace::{Distributed, Trace, Tracer};
use crate::{Q16, Q20};

/// Air that shows in the eye how much of a lamp reaches it.
#[derive(Clone, Copy)]
struct AtTheEye;

impl<S: Scalar> Air<S> for AtTheEye {
    fn passage<N: Needs>(
        &self,
        way: &Way<S>,
        _length: Option<S>,
        mut lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Rgb<S::Unit>>> {
        let (zero, part) = (S::Unit::ZERO, S::Light::WHITE.times(lit(way.start.origin, 0)));
        Some(Passage { weight: Rgb::new(zero, zero, zero), veil: Rgb::new(part, part, part) })
    }
}

/// Returns the part of a lamp of the radius .5 at the height 10, or of squares in its place, that reaches the height 0 at `x` by a half-plane
/// x < 0 at the height `edge`: its mean over 32 seeds and the standard error of that.
fn part<S: Read>(x: f64, edge: f64, lamps: Lamps, squares: &[Option<Square<S>>]) -> [f64; 2] {
    let (none, black) = (S::Unit::ZERO, Rgb::BLACK);
    let triangle = Triangle {
        vertices: [[0.0, -90.0, edge], [0.0, 90.0, edge], [-90.0, 0.0, edge]].map(place::<S>),
        extent: S::length(180.0),
        normal: direction::<S>([0.0, 0.0, -1.0]),
        normals: None,
        one_sided: false,
        color: Rgb::new(none, none, none),
        material: PLAIN,
    };
    let (lamp, triangles) = ([Lamp::white(place::<S>([0.0, 0.0, 10.0]), S::length(0.5), 1)], [triangle]);
    let sky = Sky { horizon: black, zenith: black };
    let scene = Scene { lamps: &lamp, triangles: &triangles, ..Scene::empty(sky, black) };
    let camera =
        Camera::new(place::<S>([x, 0.0, 0.0]), direction::<S>([0.0, 1.0, 0.0]), Lens::new(1, 1, (1, 1)));
    let admitted: Admitted<'_, S> = scene.admit(&camera).expect("it is small");
    let model = Through { model: Flat, air: AtTheEye };
    let tracer: Tracer<'_, S, _, Everything, 1> = Tracer::new(&admitted, model, 0).expect("not deep");
    let spread = Spread { lamps, squares, ..Spread::NONE };
    let mut sums = [0.0; 2];
    for seed in 0..32 {
        let spread = Distributed { tracer, spread: &spread, seed };
        let one = |number| {
            let sample = Sample { x: 3, y: 5, number };
            S::shine(spread.sample(&camera, (none, none), sample, &mut (), &mut ()).r)
        };
        let mean = (0..16).map(one).sum::<f64>() / 16.0;
        sums = [sums[0] + mean, sums[1] + mean * mean];
    }
    let mean = sums[0] / 32.0;
    [mean, libm::sqrt((sums[1] / 32.0 - mean * mean).max(0.0) / 31.0)]
}

/// The part of a disc beyond a straight edge, `s` radii from its middle.
fn seg(s: f64) -> f64 {
    let s = s.clamp(-1.0, 1.0);
    (libm::acos(s) - s * libm::sqrt(1.0 - s * s)) / core::f64::consts::PI
}

fn penumbra<S: Read>() {
    for k in 0..20u32 {
        let x = -0.39 + 0.04 * f64::from(k);
        let exact = seg(-x * 6.0 / (4.0 * 0.5));
        // The lamp is a sphere: its outline, seen aslant, is no circle by some thousandths.
        let [mean, error] = part::<S>(x, 4.0, Lamps::Area, &[]);
        assert!((mean - exact).abs() < 5.0 * error + 2e-3, "at {x}: {mean}, {exact}, {error}");
        let [mean, _] = part::<S>(x, 4.0, Lamps::Cone, &[]);
        assert!((mean - exact).abs() < 2e-3, "at {x}: {mean}, {exact}");
        let [mean, _] = part::<S>(x, 4.0, Lamps::Fixed(8), &[]);
        assert!((mean - exact).abs() < 0.07, "at {x}: {mean}, {exact}");
        // A point's shadow has a sharp edge.
        let [mean, _] = part::<S>(x, 4.0, Lamps::Point, &[]);
        assert!(mean == f64::from(u8::from(x > 0.0)), "at {x}: {mean}");
    }
}

#[test]
fn shadows_in_the_air_have_soft_edges() {
    penumbra::<f64>();
    penumbra::<f32>();
    penumbra::<Q16>();
    penumbra::<Q20>();
}

/// A square of the side 2 about the lamp's middle that shines down, or up: the mean of its cosine straight below, at 10 sides of a half.
fn square<S: Read>(edge: f64, down: bool) -> [f64; 2] {
    let edges = [[0.0, 2.0, 0.0], [2.0, 0.0, 0.0]].map(place::<S>);
    let least = S::length(1.0 / 32.0);
    let own = Square {
        corner: place::<S>([-1.0, -1.0, 10.0]),
        middle: place::<S>([0.0, 0.0, 10.0]),
        edges,
        normal: direction::<S>([0.0, 0.0, if down { -1.0 } else { 1.0 }]),
        least: (least, least.inverse()),
    };
    part::<S>(0.0, edge, Lamps::Area, &[Some(own)])
}

fn squares<S: Read>() {
    // The mean of 10 / sqrt(100 + x^2 + y^2) over the square, by the middles of 400 x 400 parts.
    let exact = 0.996_689_8;
    // The edge is above the lamp, and hides nothing; then it hides half.
    for (edge, exact) in [(20.0, exact), (4.0, exact / 2.0)] {
        let [mean, error] = square::<S>(edge, true);
        assert!((mean - exact).abs() < 5.0 * error + 1e-4, "{mean}, {exact}, {error}");
        assert!(square::<S>(edge, false)[0] == 0.0);
    }
}

#[test]
fn squares_light_the_air_on_one_side() {
    squares::<f64>();
    squares::<f32>();
    squares::<Q16>();
    squares::<Q20>();
}
