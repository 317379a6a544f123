//! What is hidden of a lamp, against exact values.

use super::LampCone;
use crate::color::Rgb;
use crate::light::{Incident, Lamp};
use crate::ray::Ray;
use crate::sampling::mapping::Frame;
use crate::scalar::read::{Read, place};
use crate::scalar::vector::{UnitVec3, UnitVector};
use crate::shape::{Cone, Cylinder, Ellipsoid, Move, Primitive, Sphere, Triangle};
use crate::{Q16, Q20};

/// Returns what `hidden` says of the cone from 0 to a lamp of the half angle `angle`, 10 above.
fn seen<S: Read>(angle: f64, hidden: impl FnOnce(&LampCone<S>) -> S::Unit) -> f64 {
    let lamp = Lamp::white(place::<S>([0.0, 0.0, 10.0]), S::ZERO, 1);
    let incident = Incident::new(&lamp, place::<S>([0.0; 3]), UnitVec3::<S>::Z).expect("it is far away");
    let cone = LampCone::new(place::<S>([0.0; 3]), &incident, S::length(10.0 * libm::sin(angle)));
    S::read(hidden(&cone.expect("the point is outside")))
}

/// Checks a part in all formats, and returns it in `f64`.
macro_rules! check {
    ($angle:expr, $exact:expr, $own:expr, [$f32:expr, $q16:expr, $q20:expr], $S:ident, $hidden:expr) => {{
        fn hidden<$S: Read>() -> f64 {
            seen::<$S>($angle, $hidden)
        }
        let exact: f64 = $exact;
        let own = hidden::<f64>();
        assert!((own - exact).abs() <= $own, "{own}, not {exact}");
        for (part, error, name) in
            [(hidden::<f32>(), $f32, "f32"), (hidden::<Q16>(), $q16, "q16"), (hidden::<Q20>(), $q20, "q20")]
        {
            assert!((part - own).abs() <= error, "{name}: {part}, {own} in f64");
        }
        own
    }};
}

/// A place of that distance whose direction is at that angle from the lamp's.
fn at(distance: f64, angle: f64) -> [f64; 3] {
    [distance * libm::sin(angle), 0.0, distance * libm::cos(angle)]
}

#[test]
fn spheres_hide_what_caps_do() {
    // The exact part of a cap, and by how much discs differ from it; flat discs of the angles by 0.000463, of the tangents by 0.0087.
    let cap = 0.762_035_098;
    let part = check!(0.1, cap, 1.7e-3, [1e-5, 1e-4, 1e-5], S, |cone| {
        cone.sphere(place::<S>(at(5.0, 0.15)), S::length(5.0 * libm::sin(0.2)))
    });
    assert!((part - cap).abs() > 1e-3, "{part}");
    check!(0.05, 0.391_088_382, 1e-4, [1e-5, 1e-4, 1e-5], S, |cone| {
        cone.sphere(place::<S>(at(5.0, 0.05)), S::length(5.0 * libm::sin(0.05)))
    });
    // One before the lamp's middle hides what its solid angle is of the lamp's: exactly.
    let caps = libm::pow(libm::sin(0.05) / libm::sin(0.2), 2.0);
    check!(0.4, caps, 1e-9, [1e-6, 1e-5, 1e-6], S, |cone| {
        cone.sphere(place::<S>(at(4.0, 0.1)), S::length(4.0 * libm::sin(0.1)))
    });
}

#[test]
fn places_between_point_and_lamp_decide() {
    for (center, radius, part) in [
        ([0.0, 0.0, 5.0], 2.0, 1.0),
        // Behind the lamp, behind the point, beside the cone.
        ([0.0, 0.0, 14.0], 2.0, 0.0),
        ([0.0, 0.0, -3.0], 2.0, 0.0),
        ([4.0, 0.0, 5.0], 2.0, 0.0),
        // About the point alone, about the lamp alone, about both.
        ([0.0, 1.0, 0.0], 3.0, 1.0),
        ([0.0, 0.0, 11.0], 3.0, 1.0),
        ([0.0, 0.0, 5.0], 8.0, 0.0),
    ] {
        let found = seen::<f64>(0.1, |cone| cone.sphere(place::<f64>(center), radius));
        assert!((found - part).abs() < 1e-12, "{center:?}: {found}");
    }
}

/// The part of a disc beyond a straight edge, `s` radii from its middle.
fn seg(s: f64) -> f64 {
    (libm::acos(s) - s * libm::sqrt(1.0 - s * s)) / core::f64::consts::PI
}

#[test]
fn polygons_hide_what_lies_in_their_edges() {
    let tangent = libm::tan(0.1);
    // A triangle so large that one of its edges alone is seen, at s radii, at a height of 4, and behind the point as well.
    for s in [-0.9, -0.5, -0.1, 0.0, 0.3, 0.7] {
        let part = seen::<f64>(0.1, |cone| {
            let x = s * 4.0 * tangent;
            cone.polygon([[x, -90.0, 4.0], [x, 90.0, 4.0], [90.0, 0.0, 4.0]].map(place::<f64>))
        });
        assert!((part - seg(s)).abs() < 1e-9, "{s}: {part}, {}", seg(s));
    }
    let half = check!(0.1, 0.5, 1e-9, [1e-6, 1e-5, 1e-5], S, |cone| {
        cone.polygon([[0.0, -90.0, 4.0], [0.0, 90.0, 4.0], [90.0, 0.0, 4.0]].map(place::<S>))
    });
    assert!(half > 0.49);
    // A square within the lamp, and one about it; a corner in its middle; one that runs by the point to behind it.
    let square = |a: f64| [[-a, -a, 4.0], [a, -a, 4.0], [a, a, 4.0], [-a, a, 4.0]];
    let inner = 0.16 / (core::f64::consts::PI * 16.0 * tangent * tangent);
    assert!(inner < 0.5);
    let within = seen::<f64>(0.1, |cone| cone.polygon(square(0.2).map(place::<f64>)));
    assert!((within - inner).abs() < 1e-9, "{within}, {inner}");
    let about = seen::<f64>(0.1, |cone| cone.polygon(square(2.0).map(place::<f64>)));
    assert!((about - 1.0).abs() < 1e-9, "{about}");
    for [x, y, z] in [[90.0, 90.0, 4.0], [90.0, 90.0, -40.0]] {
        check!(0.1, 0.25, 1e-9, [1e-6, 1e-4, 1e-4], S, |cone| {
            cone.polygon(
                [[0.0, 0.0, 4.0], [90.0, 0.0, 4.0], [90.0, 90.0, 4.0], [0.0, 90.0, 4.0]].map(place::<S>),
            )
        });
        let part = seen::<f64>(0.1, |cone| {
            cone.polygon([[0.0, 0.0, 4.0], [90.0, 0.0, 4.0], [x, y, z], [0.0, 90.0, 4.0]].map(place::<f64>))
        });
        assert!((part - 0.25).abs() < 1e-9, "{z}: {part}");
    }
}

#[test]
fn halves_of_space_hide_what_is_beyond_them() {
    let radius = 10.0 * libm::sin(0.1);
    for s in [-0.9, -0.5, -0.1, 0.0, 0.3, 0.7] {
        // The plane is upright: the lamp is s of its radii from it.
        let part = seen::<f64>(0.1, |cone| cone.half_space(1.0, s * radius, UnitVec3::<f64>::X));
        assert!((part - seg(s)).abs() < 1e-9, "{s}: {part}");
        let other = seen::<f64>(0.1, |cone| cone.half_space(-1.0, -s * radius, UnitVec3::<f64>::X));
        assert!((part - other).abs() < 1e-12, "{s}: {other}");
    }
    assert!(seen::<f64>(0.1, |cone| cone.half_space(3.0, -7.0, UnitVec3::<f64>::Z)) >= 1.0);
    assert!(seen::<f64>(0.1, |cone| cone.half_space(3.0, 13.0, UnitVec3::<f64>::Z)) <= 0.0);
}

/// The part of a lamp that 40,000 rays to places spread evenly over the cone find hidden.
fn found<P: Primitive<f64>>(cone: &LampCone<f64>, thing: &P, own: f64) -> f64 {
    let (frame, mut hits) = (Frame::about(cone.axis), 0);
    let cosine = libm::sqrt(1.0 - cone.sine * cone.sine);
    for i in 0..200u32 {
        for k in 0..200u32 {
            let z = 1.0 - (1.0 - cosine) * (f64::from(i) + 0.5) / 200.0;
            let angle = core::f64::consts::TAU * (f64::from(k) + 0.5 * f64::from(i % 2)) / 200.0;
            let across = libm::sqrt(1.0 - z * z);
            let way = frame.vector([across * libm::cos(angle), across * libm::sin(angle), z]);
            let ray = Ray::new(cone.apex, way).with_plan(1e6);
            hits += u32::from(thing.intersect(&ray, cone.distance * own).is_some());
        }
    }
    f64::from(hits) / 40_000.0
}

/// Returns by how much a thing's part of the lamp differs from the one found, at most, where it stands at `x` from -1 to 1 by steps.
fn worst<P: Primitive<f64> + Move<f64>>(thing: &P) -> f64 {
    let mut worst = 0.0f64;
    for step in -20..=20 {
        let moved = thing.moved(place::<f64>([f64::from(step) / 20.0, 0.1, 0.0]));
        let mut exact = 0.0;
        let part = seen::<f64>(0.1, |cone| {
            exact = found(cone, &moved, 0.9);
            moved.hidden(cone).part
        });
        worst = worst.max((part - exact).abs());
    }
    worst
}

#[test]
fn shapes_hide_what_rays_find() {
    let black = Rgb::new(0.0, 0.0, 0.0);
    let ball = Sphere::new(place::<f64>([0.0, 0.0, 5.0]), 0.4, black, 0);
    assert!(worst(&ball) < 6e-4, "{}", worst(&ball));
    for radii in [[0.2, 0.5, 0.3], [0.6, 0.2, 0.2], [2.0, 1.0, 0.3], [0.1, 0.1, 2.0]] {
        let egg = Ellipsoid::new(place::<f64>([0.0, 0.0, 5.0]), place::<f64>(radii), black, 0);
        assert!(worst(&egg) < 4e-3, "{radii:?}: {}", worst(&egg));
    }
    let corners = [[-0.3, -0.4, 5.0], [0.4, -0.1, 4.0], [0.0, 0.5, 6.0]];
    let triangle = Triangle {
        vertices: corners.map(place::<f64>),
        extent: 2.0,
        normal: {
            let [a, b, c] = corners.map(place::<f64>);
            let n = (b - a).cross(c - a);
            n / n.length()
        },
        normals: None,
        one_sided: false,
        color: black,
        material: 0,
    };
    assert!(worst(&triangle) < 3e-3, "{}", worst(&triangle));
    // 2 long along x: a cylinder, and a cone from a radius of .5 to one of .1, whose wide end is seen as a line.
    for ([base, apex], error) in [([0.3f64, 0.3], 0.02), ([0.5, 0.1], 0.04)] {
        let span = 2.0 * libm::sqrt(1.0 + base.max(apex) * base.max(apex));
        let side = libm::sqrt(4.0 + (apex - base) * (apex - base));
        let cosine = 2.0 / side;
        let rod = Cone {
            center: place::<f64>([0.0, 0.0, 5.0]),
            axis: UnitVec3::<f64>::X,
            span,
            inverse_span: 1.0 / span,
            half_height: 1.0 / span,
            waist: 0.5 * (base + apex) * cosine / span,
            cosine,
            sine: (apex - base) / side,
            radii: [base / span, apex / span],
            capped: true,
            inside_only: false,
            color: black,
            material: 0,
        };
        assert!(worst(&rod) < error, "{base}: {}", worst(&rod));
    }
    let lamp = Lamp::white(place::<f64>([8.0, 0.0, 6.0]), 0.0, 1);
    let apex = place::<f64>([0.0; 3]);
    let incident = Incident::new(&lamp, apex, UnitVec3::<f64>::Z).expect("it is far away");
    let cone = LampCone::new(apex, &incident, 1.0).expect("it is outside");
    let errors = (-20..=20).map(|step| {
        let y = f64::from(step) / 20.0;
        let column = Cylinder::new(place::<f64>([4.0, y, 0.0]), 0.3, black, 0);
        (column.hidden(&cone).part - found(&cone, &column, 0.9)).abs()
    });
    let error = errors.fold(0.0f64, f64::max);
    assert!(error < 4e-3, "{error}");
}
