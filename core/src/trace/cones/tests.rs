//! Shadows by cones, against exact values and against shadow rays to many places of the lamp: also where they are wrong, and by how much.

use crate::camera::{Camera, Lens};
use crate::color::Rgb;
use crate::illumination::Lambert;
use crate::light::Lamp;
use crate::material::{Glass, Material};
use crate::needs::Everything;
use crate::range::Admitted;
use crate::scalar::read::{Read, direction, place};
use crate::scalar::{Scalar, Unit};
use crate::scene::{Floor, PLAIN, Scene, Sky};
use crate::shape::{Sphere, Triangle};
use crate::trace::dice::{Lamps, Sample, Spread};
use crate::trace::{Distributed, Trace, Tracer};
use crate::{Q16, Q20};

/// What stands between a white floor and a lamp of the radius .5 above 0, at the height 10.
#[derive(Clone, Copy)]
struct Between<'a, S: Scalar> {
    spheres: &'a [Sphere<S>],
    triangles: &'a [Triangle<S>],
    materials: &'a [Material<S>],
    bodies: &'a [u32],
}

impl<S: Scalar> Default for Between<'_, S> {
    fn default() -> Self {
        Self { spheres: &[], triangles: &[], materials: &[], bodies: &[] }
    }
}

/// Returns the part of the lamp's light that arrives on the floor at `x`: by cones, or the mean of shadow rays to 4096 places.
fn part<S: Read>(between: Between<S>, (x, radius): (f64, f64), lamps: Lamps) -> f64 {
    let black = Rgb::BLACK;
    let one = S::Unit::ONE;
    let white = Rgb::new(one, one, one);
    let lamp = [Lamp::white(place::<S>([0.0, 0.0, 10.0]), S::length(radius), 100)];
    let floor = Some(Floor { colors: [white, white], tile: None, material: PLAIN });
    let Between { spheres, triangles, materials, bodies } = between;
    let bare = Scene { lamps: &lamp, floor, ..Scene::empty(Sky { horizon: black, zenith: black }, black) };
    let full = Scene { spheres, triangles, materials, ..bare };
    let eye = place::<S>([x, 0.0, 1.5]);
    let camera = Camera::new(eye, direction::<S>([0.0, 0.0, -1.0]), Lens::new(1, 1, (1, 1)));
    let count = if lamps == Lamps::Area { 4096 } else { 1 };
    let spread = Spread { lamps, bodies, ..Spread::NONE };
    let [open, left] = [bare, full].map(|scene| {
        let admitted: Admitted<'_, S> = scene.admit(&camera).expect("it is small");
        let tracer: Tracer<'_, S, _, Everything, 1> =
            Tracer::new(&admitted, Lambert::default(), 0).expect("not deep");
        let spread = Distributed { tracer, spread: &spread, seed: 3 };
        let light = |number| {
            let sample = Sample { x: 3, y: 5, number };
            S::shine(spread.sample(&camera, (S::Unit::ZERO, S::Unit::ZERO), sample, &mut (), &mut ()).r)
        };
        (0..count).map(light).sum::<f64>() / f64::from(count)
    });
    left / open
}

fn black<S: Read>() -> Rgb<S::Unit> {
    let none = S::Unit::ZERO;
    Rgb::new(none, none, none)
}

fn ball<S: Read>(center: [f64; 3], radius: f64, material: u16) -> Sphere<S> {
    Sphere::new(place::<S>(center), S::length(radius), black::<S>(), material)
}

/// All of a plane at that height on one side of x = 0: that where x has the sign of `side`. It is seen from below from the front, or from behind.
fn half<S: Read>(height: f64, side: f64, from_behind: bool) -> Triangle<S> {
    let corners = [[0.0, -90.0, height], [0.0, 90.0, height], [90.0 * side, 0.0, height]];
    Triangle {
        vertices: corners.map(place::<S>),
        extent: S::length(180.0),
        normal: direction::<S>([0.0, 0.0, if from_behind { 1.0 } else { -1.0 }]),
        normals: None,
        one_sided: false,
        color: black::<S>(),
        material: PLAIN,
    }
}

/// The part of a disc beyond a straight edge, `s` radii from its middle.
fn seg(s: f64) -> f64 {
    let s = s.clamp(-1.0, 1.0);
    (libm::acos(s) - s * libm::sqrt(1.0 - s * s)) / core::f64::consts::PI
}

fn penumbra<S: Read>(rounding: f64) {
    let triangles = [half::<S>(4.0, -1.0, false)];
    for k in 0..40u32 {
        let x = -0.39 + 0.02 * f64::from(k);
        let found = part(Between { triangles: &triangles, ..Between::default() }, (x, 0.5), Lamps::Cone);
        let exact = seg(-x * 6.0 / (4.0 * 0.5));
        assert!((found - exact).abs() < rounding, "at {x}: {found}, {exact}");
    }
}

#[test]
fn a_penumbra_is_as_wide_as_it_should_be_without_noise() {
    // The lamp is a sphere: its outline, seen aslant, is no circle by some thousandths.
    penumbra::<f64>(2e-3);
    penumbra::<f32>(2e-3);
    penumbra::<Q16>(2e-3);
    penumbra::<Q20>(2e-3);
}

/// Returns the part by cones, and that by shadow rays.
fn both<S: Read>(between: Between<S>) -> [f64; 2] {
    [Lamps::Cone, Lamps::Area].map(|lamps| part(between, (0.0, 0.5), lamps))
}

#[test]
fn what_lies_behind_is_hidden_twice() {
    // The second is half as far again and half as large again, so that it hides just what the first does.
    let near = ball::<f64>([-2.0, 0.0, 4.0], 2.0, PLAIN);
    let far = ball::<f64>([-3.0, 0.0, 6.0], 3.0, PLAIN);
    let of = |spheres: &[Sphere<f64>]| both(Between { spheres, ..Between::default() });
    let ([one, truth], [two, still]) = (of(&[near]), of(&[near, far]));
    assert!((truth - 0.5).abs() < 0.02 && (truth - still).abs() < 1e-9, "{truth} {still}");
    assert!((one - truth).abs() < 1e-2, "{one}, not {truth}");
    assert!((two - one * one).abs() < 1e-6 && two < 0.27, "{two}");
}

#[test]
fn faces_of_two_bodies_leak_and_those_of_one_do_not() {
    let faces = [half::<f64>(4.0, -1.0, false), half::<f64>(4.0, 1.0, false)];
    let of = |bodies: &[u32]| both(Between { triangles: &faces, bodies, ..Between::default() });
    let ([leak, truth], [whole, _]) = (of(&[]), of(&[5, 5]));
    assert!(truth < 1e-9, "{truth}");
    assert!((leak - 0.25).abs() < 1e-6, "{leak}");
    assert!(whole < 1e-6, "{whole}");
}

#[test]
fn a_body_hides_once_with_its_front_and_its_back() {
    let faces = [half::<f64>(4.0, -1.0, false), half::<f64>(4.001, -1.0, true)];
    let [cone, truth] = both(Between { triangles: &faces, bodies: &[0, 0], ..Between::default() });
    assert!((truth - 0.5).abs() < 2e-3 && (cone - 0.5).abs() < 2e-3, "{cone}, not {truth}");
}

#[test]
fn glass_dims_what_it_covers() {
    let materials = [Material::Transparent(Glass::new(0.25, 3, 2))];
    let of = |material| {
        let spheres = [ball::<f64>([-1.9, 0.0, 4.0], 2.0, material)];
        both(Between { spheres: &spheres, materials: &materials, ..Between::default() })
    };
    let ([opaque, _], [clear, truth]) = (of(PLAIN), of(0));
    assert!((clear - (1.0 - 0.25 * (1.0 - opaque))).abs() < 1e-9, "{clear}, {opaque}");
    assert!((clear - truth).abs() < 1e-2, "{clear}, not {truth}");
}

fn like_a_point<S: Read>() {
    for (x, hidden) in [(0.0, 1.0), (0.9, 1.0), (3.0, 0.0)] {
        let spheres = [ball::<S>([0.0, 0.0, 4.0], 1.0, PLAIN)];
        let between = Between { spheres: &spheres, ..Between::default() };
        let [cone, point] = [Lamps::Cone, Lamps::Point].map(|lamps| part(between, (x, 0.0), lamps));
        assert!(
            cone.to_bits() == point.to_bits() && (point + hidden - 1.0).abs() < 1e-9,
            "{x}: {cone}, {point}"
        );
    }
}

#[test]
fn the_cone_to_a_lamp_without_a_size_is_a_shadow_ray() {
    like_a_point::<f64>();
    like_a_point::<f32>();
    like_a_point::<Q16>();
    like_a_point::<Q20>();
}

#[test]
fn a_ball_casts_the_shadow_that_many_rays_find_but_for_a_bias() {
    let spheres = [ball::<f64>([0.0, 0.0, 4.0], 0.4, PLAIN)];
    let (mut sum, mut worst) = (0.0, 0.0f64);
    for k in 0..40u32 {
        let between = Between { spheres: &spheres, ..Between::default() };
        let [cone, truth] =
            [Lamps::Cone, Lamps::Area].map(|lamps| part(between, (0.03 * f64::from(k), 0.5), lamps));
        let error = cone - truth;
        (sum, worst) = (sum + error * error, worst.max(error.abs()));
    }
    let rms = libm::sqrt(sum / 40.0);
    // Measured: 6e-4 and 1.9e-3, of which the 4096 places have some 3e-4.
    assert!(rms < 1e-3 && worst < 3e-3 && rms > 1e-5, "rms {rms}, at most {worst}");
}

fn same_in_all_formats<S: Read>(error: f64) {
    fn of<S: Read>(x: f64) -> f64 {
        let spheres = [ball::<S>([-0.25, 0.0, 4.0], 0.5, PLAIN), ball::<S>([0.5, 0.25, 6.0], 0.25, PLAIN)];
        let triangles = [half::<S>(2.0, -1.0, false)];
        let between = Between { spheres: &spheres, triangles: &triangles, ..Between::default() };
        part(between, (x, 0.5), Lamps::Cone)
    }
    for k in 0..40u32 {
        let x = -0.4 + 0.03125 * f64::from(k);
        let (exact, found) = (of::<f64>(x), of::<S>(x));
        assert!((exact - found).abs() < error, "{x}: {found}, {exact} in f64");
    }
}

#[test]
fn formats_agree() {
    same_in_all_formats::<f32>(1e-6);
    same_in_all_formats::<Q16>(1e-4);
    same_in_all_formats::<Q20>(1e-4);
}
