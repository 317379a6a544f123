//! Random rays and shapes, in each number format: hit points lie on the surface, normals are unit vectors, hit and miss
//! are those of `f64` outside a margin about the silhouette, no convex object is met again by a ray that leaves it,
//! refraction obeys Snell's law and reflection keeps lengths. Bounds are counted in roundings of the format.

#![allow(clippy::indexing_slicing, reason = "arrays of three")]

mod snell;

use core::f64::consts::TAU;
use core::fmt::Debug;

use proptest::prelude::*;
use rta_core::needs::Everything;
use rta_core::ray::Ray;
use rta_core::scalar::{Scalar, Unit};
use rta_core::scene::PLAIN;
use rta_core::shape::{Cylinder, Ellipsoid, Primitive, Sphere, SurfacePoint};
use rta_core::vector::{LengthVector, UnitVec3, UnitVector, Vec3, Vector};
use rta_core::{Q16, Q20};
use rta_tests::measure::{Measure, color, direction, place, read_direction};

type Triple = [f64; 3];

/// Height at which cylinders end, in units of length.
const CYLINDER_END: f64 = 500.0;

/// Returns the size of one rounding of a length of that size.
fn rounding<S: Measure>(size: f64) -> f64 {
    if S::CLEARANCE > rta_core::scalar::Magnitude::ZERO { S::LENGTH } else { S::UNIT * size }
}

fn read<S: Measure>(v: Vec3<S>) -> Triple {
    [v.x(), v.y(), v.z()].map(S::to_f64)
}

fn minus(a: Triple, b: Triple) -> Triple {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(v: Triple) -> f64 {
    dot(v, v).sqrt()
}

fn size(v: Triple) -> f64 {
    v.iter().fold(0.0, |most: f64, c| most.max(c.abs()))
}

/// The shape under test.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Sphere,
    Ellipsoid,
    Cylinder,
}

/// A shape with a ray that passes it at `offset` radii, from `distance` radii away.
#[derive(Clone, Debug)]
struct Aimed {
    kind: Kind,
    center: Triple,
    radii: Triple,
    origin: Triple,
    direction: Triple,
    /// Direction of a ray that leaves the surface: any.
    away: Triple,
}

fn unit_vector() -> impl Strategy<Value = Triple> {
    (-1.0..=1.0_f64, 0.0..TAU).prop_map(|(z, turn)| {
        let flat = (1.0 - z * z).sqrt();
        [flat * turn.cos(), flat * turn.sin(), z]
    })
}

/// Returns a unit vector at right angles to another, turned about it by `turn` radians.
fn across([x, y, z]: Triple, turn: f64) -> Triple {
    // Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6, 2017.
    let sign = 1.0_f64.copysign(z);
    let (a, b) = (-1.0 / (sign + z), -x * y / (sign + z));
    let (first, second) = ([1.0 + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y]);
    let (sine, cosine) = turn.sin_cos();
    [0, 1, 2].map(|i| first[i] * cosine + second[i] * sine)
}

fn aimed(kind: Kind) -> impl Strategy<Value = Aimed> {
    let offset = prop_oneof![
        0.0..1.2,
        // Close to the silhouette, on either side.
        (1.0..7.0_f64, any::<bool>())
            .prop_map(|(k, out)| 1.0 + 10f64.powf(-k) * if out { 1.0 } else { -1.0 }),
    ];
    let center = prop::array::uniform3(-50.0..=50.0);
    let radii = prop::array::uniform3((-1.5..1.0_f64).prop_map(|k| 10f64.powf(k)));
    let distance = prop_oneof![0.0..0.99, 1.01..30.0];
    (center, radii, unit_vector(), 0.0..TAU, offset, distance, unit_vector()).prop_map(
        move |(center, radii, way, turn, offset, distance, away)| {
            let radii = match kind {
                Kind::Ellipsoid => radii,
                Kind::Sphere | Kind::Cylinder => [radii[0]; 3],
            };
            let side = across(way, turn);
            let sine: f64 = if distance > offset { offset / distance } else { 0.5 };
            let cosine = (1.0 - sine * sine).sqrt();
            // In the space where the shape is a unit sphere, then back.
            let mut aimed = Aimed { kind, center, radii, origin: center, direction: way, away };
            for i in 0..3 {
                aimed.origin[i] = center[i] - way[i] * distance * radii[i];
                aimed.direction[i] = (way[i] * cosine + side[i] * sine) * radii[i];
            }
            aimed
        },
    )
}

/// A shape in a number format.
enum Shape<S: Scalar> {
    Sphere(Sphere<S>),
    Ellipsoid(Ellipsoid<S>),
    Cylinder(Cylinder<S>),
}

impl<S: Measure> Shape<S> {
    fn new(aimed: &Aimed) -> Self {
        let (center, radii) = (place::<S>(aimed.center), aimed.radii);
        let (grey, radius) = (color::<S>([0.5; 3]), S::length(radii[0]));
        match aimed.kind {
            Kind::Sphere => Self::Sphere(Sphere::new(center, radius, grey, PLAIN)),
            Kind::Ellipsoid => Self::Ellipsoid(Ellipsoid::new(center, place::<S>(radii), grey, PLAIN)),
            Kind::Cylinder => Self::Cylinder(Cylinder::new(center, radius, grey, PLAIN)),
        }
    }

    fn intersect(&self, ray: &Ray<S>) -> Option<S> {
        match self {
            Self::Sphere(sphere) => sphere.intersect(ray, S::FAR),
            Self::Ellipsoid(ellipsoid) => ellipsoid.intersect(ray, S::FAR),
            Self::Cylinder(cylinder) => cylinder.intersect(ray, S::FAR),
        }
    }

    /// Returns the point at a distance, and the size that the clearance is told of the object.
    fn point(&self, ray: &Ray<S>, t: S) -> (SurfacePoint<S>, S) {
        fn of<S: Scalar>(shape: &impl Primitive<S>, ray: &Ray<S>, t: S) -> (SurfacePoint<S>, S) {
            (shape.point::<Everything>(ray, t), shape.look().extent)
        }
        match self {
            Self::Sphere(sphere) => of(sphere, ray, t),
            Self::Ellipsoid(ellipsoid) => of(ellipsoid, ray, t),
            Self::Cylinder(cylinder) => of(cylinder, ray, t),
        }
    }

    /// Returns the distance of a place from the centre in radii, which is 1 on the surface.
    fn level(aimed: &Aimed, at: Triple) -> f64 {
        let radii = read::<S>(place::<S>(aimed.radii));
        let mut v = minus(at, read::<S>(place::<S>(aimed.center)));
        for (c, radius) in v.iter_mut().zip(radii) {
            *c /= radius;
        }
        if aimed.kind == Kind::Cylinder {
            v[2] = 0.0;
        }
        length(v)
    }
}

fn ray<S: Measure>(aimed: &Aimed) -> Ray<S> {
    shot(place::<S>(aimed.origin), direction::<S>(aimed.direction))
}

/// Returns a ray that cylinders can be asked about too.
fn shot<S: Measure>(origin: Vec3<S>, direction: UnitVec3<S>) -> Ray<S> {
    Ray::new(origin, direction).with_plan(S::length(CYLINDER_END))
}

/// Returns whether the ray hits according to `f64`, from the numbers as the format has rounded them; nothing where it
/// is too close to say.
fn expected<S: Measure>(aimed: &Aimed, ray: &Ray<S>, margin: f64) -> Option<bool> {
    let origin = read::<S>(ray.origin);
    let mut d = read_direction::<S>(ray.direction);
    let radii = read::<S>(place::<S>(aimed.radii));
    let mut way = minus(read::<S>(place::<S>(aimed.center)), origin);
    for i in 0..3 {
        way[i] /= radii[i];
        d[i] /= radii[i];
    }
    let rise = d[2] * radii[2];
    if aimed.kind == Kind::Cylinder {
        (way[2], d[2]) = (0.0, 0.0);
    }
    let b = dot(way, d) / dot(d, d);
    // The cylinder's end may decide: not tested here.
    let farthest = b.abs() + 1.1 / length(d);
    if aimed.kind == Kind::Cylinder && origin[2].abs() + (farthest * rise).abs() > 0.9 * CYLINDER_END {
        return None;
    }
    let across = length(minus(way, d.map(|c| c * b)));
    let inside = length(way);
    // Both the silhouette and the surface itself, where the ray starts, are limits.
    if (across - 1.0).abs() < margin || (inside - 1.0).abs() < margin {
        return None;
    }
    Some(inside < 1.0 || (across < 1.0 && b > 0.0))
}

fn check<S: Measure + Debug>(aimed: &Aimed) -> Result<(), TestCaseError> {
    let (shape, ray) = (Shape::<S>::new(aimed), ray::<S>(aimed));
    let (least, extent) = (
        aimed.radii.iter().fold(f64::MAX, |least, &r| least.min(r)),
        aimed.radii.iter().fold(0.0, |most: f64, &r| most.max(r)),
    );
    let reach = size(aimed.origin).max(size(aimed.center)) + 2.0 * extent;
    let lsb = rounding::<S>(reach);
    // The foot point is rounded by one and a half, in units of the smallest radius. In a cylinder's plan a rounding of
    // the direction counts over all of the way.
    let margin = (4.0 * lsb + 4.0 * S::UNIT * reach) / least;
    let hit = shape.intersect(&ray);
    if let Some(expected) = expected::<S>(aimed, &ray, margin) {
        prop_assert_eq!(hit.is_some(), expected, "{} {:?}: hit or miss", S::NAME, hit);
    }
    let Some(t) = hit else { return Ok(()) };
    let (SurfacePoint { point, normal, .. }, extent) = shape.point(&ray, t);
    let level = Shape::<S>::level(aimed, read::<S>(point));
    prop_assert!((level - 1.0).abs() <= 2.0 * lsb / least, "{}: {} off the surface", S::NAME, level - 1.0);
    let excess = length(read_direction::<S>(normal)) - 1.0;
    prop_assert!(excess.abs() <= 3.0 * S::UNIT, "{}: a normal is {} too long", S::NAME, excess);

    // Any way out, and those that are as flat as can be.
    let side = if normal.dot(ray.direction) > S::Unit::ZERO { -normal } else { normal };
    let out = direction::<S>(aimed.away);
    let out = if side.dot(out) < S::Unit::ZERO { -out } else { out };
    let flat = out.plus(side, -side.dot(out)).normalize().map(|(flat, _)| flat);
    let mirrored = ray.direction.reflect(side);
    for out in [Some(out), flat, Some(mirrored)].into_iter().flatten() {
        if side == normal && side.dot(out) > S::Unit::ZERO {
            let (start, _) = point.leave(side, out, extent);
            let again = shape.intersect(&shot::<S>(start, out));
            prop_assert!(again.is_none(), "{}: met again at {:?} along {:?}", S::NAME, again, out);
        }
    }
    let excess = length(read_direction::<S>(mirrored)) - length(read_direction::<S>(ray.direction));
    prop_assert!(excess.abs() <= 8.0 * S::UNIT, "{}: a reflection is {} too long", S::NAME, excess);
    Ok(())
}

/// Each run has one seed and so the same shapes; `PROPTEST_RNG_SEED` in the environment asks for others, and
/// `PROPTEST_CASES` for more.
fn config() -> ProptestConfig {
    let default = ProptestConfig::default();
    let cases = if std::env::var_os("PROPTEST_CASES").is_some() { default.cases } else { 20_000 };
    let rng_seed = match default.rng_seed {
        proptest::test_runner::RngSeed::Random => proptest::test_runner::RngSeed::Fixed(1990),
        told @ proptest::test_runner::RngSeed::Fixed(_) => told,
    };
    ProptestConfig { cases, rng_seed, failure_persistence: None, ..default }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn spheres(aimed in aimed(Kind::Sphere)) {
        check::<f32>(&aimed)?;
        check::<Q16>(&aimed)?;
        check::<Q20>(&aimed)?;
    }

    #[test]
    fn ellipsoids(aimed in aimed(Kind::Ellipsoid)) {
        check::<f32>(&aimed)?;
        check::<Q16>(&aimed)?;
        check::<Q20>(&aimed)?;
    }

    #[test]
    fn cylinders(aimed in aimed(Kind::Cylinder)) {
        check::<f32>(&aimed)?;
        check::<Q16>(&aimed)?;
        check::<Q20>(&aimed)?;
    }

    #[test]
    fn refraction(incoming in unit_vector(), normal in unit_vector(), ior in 0.25..4.0_f64, inside: bool) {
        snell::check::<f32>(incoming, normal, ior, inside)?;
        snell::check::<Q16>(incoming, normal, ior, inside)?;
        snell::check::<Q20>(incoming, normal, ior, inside)?;
    }
}
