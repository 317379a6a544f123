//! The primitives, each its own file: where a ray meets it, and what the surface is like there.
//!
//! The search for the nearest hit asks each primitive for a distance, in the length's own format. What it finds is then
//! looked at once more, from nearby: the point is computed relative to the object and its size, so that the normal has
//! the precision of a unit vector, and the point lies on the surface to within its own rounding.
//!
//! A new primitive is one file here that implements [`Primitive`], a line in [`scene`](crate::scene) that gives it a list, and one
//! in [`needs`](crate::needs) that lets programs leave it out.

mod cone;
mod cylinder;
mod ellipsoid;
mod floor;
mod sphere;
mod triangle;

pub use cone::Cone;
pub use cylinder::Cylinder;
pub use ellipsoid::Ellipsoid;
pub use floor::Floor;
pub use sphere::Sphere;
pub use triangle::Triangle;

use crate::color::Rgb;
use crate::material::Material;
use crate::needs::{Needs, Used};
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::scalar::vector::{UnitVec3, Vec3};

/// A thing that a ray can meet.
pub trait Primitive<S: Scalar> {
    /// Whether it has an end in every direction. What has none is not held by a hierarchy, but asked by every ray.
    const IS_FINITE: bool = true;

    /// Returns the distance of the nearest hit in ]0, `t_max`[ along the ray, if there is one.
    fn intersect(&self, ray: &Ray<S>, t_max: S) -> Option<S>;

    /// Returns the surface point where [`Primitive::intersect`] found the distance `t`.
    fn point<N: Needs>(&self, ray: &Ray<S>, t: S) -> SurfacePoint<S>;

    /// Returns its colour and material, and where it is.
    fn look(&self) -> Look<'_, S>;

    /// Notes what it needs of a program besides its own kind.
    fn note_needs(&self, _used: &mut Used) {}
}

/// A point on a surface.
#[derive(Clone, Copy, Debug)]
pub struct SurfacePoint<S: Scalar> {
    /// Distance from the ray's origin.
    pub distance: S,
    /// The place, on the surface to within its rounding.
    pub point: Vec3<S>,
    /// The unit normal on the outside.
    pub normal: UnitVec3<S>,
}

/// What an object looks like, and where it is.
#[derive(Clone, Copy, Debug)]
pub struct Look<'a, S: Scalar> {
    /// Reflectance of the surface.
    pub color: Rgb<S::Unit>,
    /// What the surface does with light.
    pub material: &'a Material<S>,
    /// The size that [`clearance`](crate::scalar::vector::LengthVector::clearance) is told where a ray leaves the surface.
    pub extent: S,
    /// A place of the object, its centre where it has one.
    pub center: Vec3<S>,
    /// Radius of a sphere about `center` that holds the object.
    pub radius: S,
    /// The smallest radius of the object.
    pub least: S,
}

/// The nearer of two distances along a ray that lies ahead, if it is short of `t_max`.
fn ahead<S: Scalar>(near: S, far: S, t_max: S) -> Option<S> {
    let t = if near > S::ZERO { near } else { far };
    (t > S::ZERO && t < t_max).then_some(t)
}
