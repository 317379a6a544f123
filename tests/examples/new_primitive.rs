//! A new primitive, outside the core: a disc, met and lit through its trait.
//!
//! The lists of a scene are closed. What puts the disc into a scene is this file in `core/src/shape/`, its `mod` and `use` in
//! `core/src/shape.rs`, a line in the list of `core/src/needs.rs`, and the one line in the list of `core/src/scene.rs`:
//!
//! ```text
//! /// Discs.
//! discs: Disc if DISCS, "disc";
//! ```

use rta_core::light::Incident;
use rta_core::prelude::*;
use rta_core::ray::Ray;
use rta_core::scene::PLAIN;
use rta_core::shape::Look;
use rta_core::surface::Surface;

/// A flat disc, seen from both sides.
struct Disc<S: Scalar> {
    center: Vec3<S>,
    /// Unit normal of its plane.
    normal: UnitVec3<S>,
    radius: S,
    color: Rgb<S::Unit>,
    material: u16,
}

impl<S: Scalar> Primitive<S> for Disc<S> {
    fn intersect(&self, ray: &Ray<S>, t_max: S) -> Option<S> {
        let displacement = self.center - ray.origin;
        let (height, cosine) = (displacement.dot(self.normal), self.normal.dot(ray.direction));
        // Towards the plane, with both of one sign.
        let t = if height > S::ZERO && cosine > S::Unit::ZERO {
            height.over(cosine)
        } else if height < S::ZERO && cosine < S::Unit::ZERO {
            (-height).over(-cosine)
        } else {
            return None;
        };
        // Only now is the distance known to be within the scene.
        let is_near = t > S::ZERO && t < t_max;
        let across = || ray.origin.along(ray.direction, t) - self.center;
        (is_near && across().norm_squared() <= self.radius.square()).then_some(t)
    }

    fn point<N: Needs>(&self, ray: &Ray<S>, t: S) -> SurfacePoint<S> {
        let place = ray.origin.along(ray.direction, t) - self.center;
        // Back into the plane by what the roundings have left.
        let place = place.reject(self.normal, place.dot(self.normal));
        SurfacePoint { distance: t, point: self.center + place, normal: self.normal }
    }

    fn look(&self) -> Look<S> {
        let Self { center, radius, color, material, .. } = *self;
        Look { color, material, extent: radius, center, radius, least: radius }
    }
}

/// What the disc sends back of a lamp along a ray: the tracer's steps for one ray.
fn seen<S: Scalar>(disc: &Disc<S>, ray: &Ray<S>, lamp: &Lamp<S>) -> Option<Rgb<S::Light>> {
    let t = disc.intersect(ray, S::FAR)?;
    let SurfacePoint { distance, point, normal } = disc.point::<Everything>(ray, t);
    let inside = normal.dot(ray.direction) > S::Unit::ZERO;
    let normal = if inside { -normal } else { normal };
    let Look { color, material: number, extent, .. } = disc.look();
    let surface = Surface {
        point,
        normal,
        face: disc.face(),
        incoming: ray.direction,
        distance,
        inside,
        extent,
        color,
        material: &Material::Opaque, // a scene knows it by its number
        surroundings: false,
        mesh: None,
        number,
    };
    let incident = Incident::new(lamp, point, normal)?;
    Some(rta_core::trace::decision::direct::<S, _, Everything>(&Rta, &surface, &incident))
}

/// Looks straight down on a disc under a lamp at a distance of 2.
pub(crate) fn main() {
    let white = Rgb::new(1.0, 1.0, 1.0);
    let up = UnitVec3::<f32>::Z;
    let disc = Disc::<f32> {
        center: Vector::new(0.0, 0.0, 0.0),
        normal: up,
        radius: 1.0,
        color: white,
        material: PLAIN,
    };
    let lamp = Lamp::new(Vector::new(0.0, 0.0, 2.0), 0.0, 4.0, white);
    let down = |x: f32| Ray::new(Vector::new(x, 0.0, 3.0), -up);
    let light = seen(&disc, &down(0.0), &lamp).expect("the ray meets the disc");
    println!("the middle of the disc sends back {}", light.g);
    assert!((light.g - 1.0).abs() < 1e-6, "4 over the square of 2");
    assert!(seen(&disc, &down(1.5), &lamp).is_none(), "beside the disc");
}
