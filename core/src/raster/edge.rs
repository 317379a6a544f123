//! For tests: edges on the image plane, and the part of a pixel that they cover.

use crate::camera::{Camera, Lens};
use crate::color::Rgb;
use crate::sampling::pairs::Pairs;
use crate::scalar::vector::{UnitVec3, Vec3, Vector};
use crate::trace::{Observer, Trace};

/// White on one side of a line of the image plane, black on the other.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    pub(super) normal: [f64; 2],
    pub(super) distance: f64,
}

/// White on one side of an edge, another light on the other.
pub(super) struct Tinted {
    pub(super) edge: Edge,
    pub(super) dark: [f64; 3],
}

impl Trace<f64> for Edge {
    type Memory = ();

    fn trace<O: Observer<f64> + ?Sized>(
        &self,
        origin: Vec3<f64>,
        direction: UnitVec3<f64>,
        memory: &mut (),
        observer: &mut O,
    ) -> Rgb<f64> {
        Tinted { edge: *self, dark: [0.0; 3] }.trace(origin, direction, memory, observer)
    }
}

impl Trace<f64> for Tinted {
    type Memory = ();

    fn trace<O: Observer<f64> + ?Sized>(
        &self,
        _origin: Vec3<f64>,
        direction: UnitVec3<f64>,
        (): &mut (),
        _observer: &mut O,
    ) -> Rgb<f64> {
        let Edge { normal, distance } = self.edge;
        let [right, up] = [direction.x() / direction.y(), direction.z() / direction.y()];
        let [r, g, b] = if right * normal[0] + up * normal[1] < distance { [1.0; 3] } else { self.dark };
        Rgb::new(r, g, b)
    }
}

/// Returns the part of the unit square about 0 where `n.x < d`.
fn cover([a, b]: [f64; 2], d: f64) -> f64 {
    let (a, b) = (a.abs(), b.abs());
    let square = |t: f64| if t > 0.0 { t * t } else { 0.0 };
    let d = d + f64::midpoint(a, b);
    (square(d) - square(d - a) - square(d - b) + square(d - a - b)) / (2.0 * a * b)
}

/// Returns a camera whose image plane is a square of side 1 at the distance 1.
pub(super) fn camera() -> Camera<f64> {
    let lens = Lens { focal: 1.0, width: 1.0, height: 1.0 };
    Camera::new(Vec3::<f64>::new(0.0, 0.0, 0.0), UnitVec3::<f64>::new(0.0, 1.0, 0.0), lens)
}

/// Returns random edges through the unit square about 0 with the part of it that is white: of any angle, at any distance.
pub(super) fn random_edges() -> impl Iterator<Item = (Edge, f64)> {
    (0..40_000).filter_map(|i| {
        let [angle, distance] = Pairs::new(0, 0, 0, 3).units::<f64>(i);
        let angle = angle * core::f64::consts::TAU;
        let normal = [libm::cos(angle), libm::sin(angle)];
        let distance = (2.0 * distance - 1.0) * core::f64::consts::FRAC_1_SQRT_2;
        // One that misses the pixel is no edge.
        let is_through = distance.abs() < f64::midpoint(normal[0].abs(), normal[1].abs());
        is_through.then(|| (Edge { normal, distance }, cover(normal, distance)))
    })
}

#[test]
fn covers_are_exact() {
    for (degrees, d, want) in
        [(30.0, 0.2, 0.730_606_898), (45.0, 0.5, 0.957_106_781), (80.0, -0.3, 0.195_372_016)]
    {
        let angle: f64 = f64::to_radians(degrees);
        let got = cover([libm::cos(angle), libm::sin(angle)], d);
        assert!((got - want).abs() < 5e-10, "{got} instead of {want}");
    }
}
