//! Edges through a pixel, against the exact part of it that they cover.

use super::{Corners, Cutting};
use crate::camera::{Camera, Lens};
use crate::color::Rgb;
use crate::raster::Raster;
use crate::sampling::pairs::Pairs;
use crate::scalar::vector::{UnitVec3, Vec3, Vector};
use crate::trace::{Observer, Trace};

/// White on one side of a line of the image plane, black on the other.
struct Edge {
    normal: [f64; 2],
    distance: f64,
}

impl Trace<f64> for Edge {
    type Memory = ();

    fn trace<O: Observer<f64> + ?Sized>(
        &self,
        _origin: Vec3<f64>,
        direction: UnitVec3<f64>,
        (): &mut (),
        _observer: &mut O,
    ) -> Rgb<f64> {
        let [right, up] = [direction.x() / direction.y(), direction.z() / direction.y()];
        let light = if right * self.normal[0] + up * self.normal[1] < self.distance { 1.0 } else { 0.0 };
        Rgb::new(light, light, light)
    }
}

/// The part of the unit square about 0 where `n.x < d`.
fn cover([a, b]: [f64; 2], d: f64) -> f64 {
    let (a, b) = (a.abs(), b.abs());
    let square = |t: f64| if t > 0.0 { t * t } else { 0.0 };
    let d = d + f64::midpoint(a, b);
    (square(d) - square(d - a) - square(d - b) + square(d - a - b)) / (2.0 * a * b)
}

fn camera() -> Camera<f64> {
    let lens = Lens { focal: 1.0, width: 1.0, height: 1.0 };
    Camera::new(Vec3::<f64>::new(0.0, 0.0, 0.0), UnitVec3::<f64>::new(0.0, 1.0, 0.0), lens)
}

/// Returns rms error, mean error and mean number of rays of 20000 random edges through a picture of one pixel.
fn measured<const PLACES: usize>(depth: u8) -> [f64; 3] {
    let (camera, raster) = (camera(), Raster::new(1, 1).expect("a pixel"));
    let cutting = Cutting::new(depth, 16).expect("not deep");
    let (mut n, mut sums) = (0.0, [0.0; 3]);
    for i in 0..40_000 {
        let [angle, distance] = Pairs::new(0, 0, 0, 3).units::<f64>(i);
        let (sine, cosine) = (libm::sin(angle * 6.283_185_307), libm::cos(angle * 6.283_185_307));
        let edge = Edge { normal: [cosine, sine], distance: (2.0 * distance - 1.0) * 0.707_106_781 };
        // One that misses the pixel is no edge.
        if edge.distance.abs() >= f64::midpoint(cosine.abs(), sine.abs()) {
            continue;
        }
        let mut above = [Rgb::BLACK; 2];
        let rows = Corners::<_, _, PLACES>::new(&edge, (&camera, raster), cutting, &mut above, 0);
        let mut rows = rows.expect("room");
        let mut light = 0.0;
        assert!(rows.next_row(|pixel| light = pixel.r));
        let error = light - cover(edge.normal, edge.distance);
        let rays = u32::try_from(rows.rays()).expect("few");
        sums = [sums[0] + error * error, sums[1] + error, sums[2] + f64::from(rays)];
        n += 1.0;
    }
    [libm::sqrt(sums[0] / n), sums[1] / n, sums[2] / n]
}

#[test]
fn errors_and_rays_are_those_of_theory() {
    let cases = [
        (measured::<4>(0), 0.197, 4.0),
        (measured::<9>(1), 0.0804, 9.0),
        (measured::<25>(2), 0.0298, 18.0),
        (measured::<81>(3), 0.0107, 35.0),
        (measured::<289>(4), 0.0038, 68.0),
    ];
    for ([rms, mean, rays], want, count) in cases {
        assert!((rms / want - 1.0).abs() < 0.05, "{rms} instead of {want}");
        assert!(mean.abs() < 1e-3, "{mean}");
        assert!((rays / count - 1.0).abs() < 0.05, "{rays} instead of {count}");
    }
}

#[test]
fn a_pixel_without_an_edge_costs_one_ray() {
    let edge = Edge { normal: [1.0, 0.0], distance: 9.0 };
    let (camera, raster) = (camera(), Raster::new(40, 30).expect("small"));
    let mut above = [Rgb::BLACK; 41];
    let rows = Corners::<_, _>::new(&edge, (&camera, raster), Cutting::default(), &mut above, 0);
    let mut rows = rows.expect("room");
    let mut pixels = 0;
    while rows.next_row(|light| {
        assert!((light.g - 1.0).abs() < 1e-12);
        pixels += 1;
    }) {}
    assert_eq!((pixels, rows.rays()), (1200, 41 * 31));
}

#[test]
fn what_has_no_room_is_refused() {
    let edge = Edge { normal: [1.0, 0.0], distance: 0.0 };
    let (camera, raster) = (camera(), Raster::new(2, 2).expect("small"));
    let deep = Cutting::new(3, 16).expect("not deep");
    let mut above = [Rgb::BLACK; 3];
    assert!(Corners::<_, _, 80>::new(&edge, (&camera, raster), deep, &mut above, 0).is_none());
    assert!(Corners::<_, _, 81>::new(&edge, (&camera, raster), deep, &mut above[..2], 0).is_none());
    assert!(Cutting::new(5, 16).is_none());
}
