//! The primitives, each in its own file: where a ray meets it, and place and normal of the hit.
//!
//! The search for the nearest hit asks each primitive for a distance only. For the nearest one the hit is then computed once
//! more, relative to the object's centre and in units of its size, so that the normal has the precision of a unit vector and
//! the point lies on the surface to within its own rounding.
//!
//! To add a primitive: a file here that implements [`Primitive`], a line in [`scene`](crate::scene) that gives it a list, and a
//! line in [`needs`](crate::needs) that lets programs leave it out.

mod cone;
mod cylinder;
mod ellipsoid;
mod floor;
mod plane;
mod sphere;
mod triangle;

pub use cone::Cone;
pub use cylinder::Cylinder;
pub use ellipsoid::Ellipsoid;
pub use floor::Floor;
pub use plane::Plane;
pub use sphere::Sphere;
pub use triangle::Triangle;
pub(crate) use triangle::half_sum;

use crate::color::Rgb;
use crate::light::cone::{Hidden, LampCone};
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::scalar::vector::{UnitVec3, Vec3};

/// An object that can stand elsewhere.
pub trait Move<S: Scalar>: Copy {
    /// Returns the object, moved by a vector.
    fn moved(&self, by: Vec3<S>) -> Self;
}

/// A kind of object that a ray can meet.
pub trait Primitive<S: Scalar> {
    /// Whether the object is finite. An infinite one is in no hierarchy: every ray tests it.
    const IS_FINITE: bool = true;

    /// Returns the distance of the nearest hit along the ray, above 0 and below `t_max`, if there is one.
    fn intersect(&self, ray: &Ray<S>, t_max: S) -> Option<S>;

    /// Returns the surface point of the hit for which [`Primitive::intersect`] returned the distance `t`.
    fn point<N: Needs>(&self, ray: &Ray<S>, t: S) -> SurfacePoint<S>;

    /// Returns the object's colour, material and bounding sphere.
    fn look(&self) -> Look<S>;

    /// Returns what the object hides of a lamp that has a size; unless it says otherwise, what its bounding sphere does.
    fn hidden(&self, cone: &LampCone<S>) -> Hidden<S::Unit> {
        let Look { center, radius, .. } = self.look();
        cone.sphere(center, radius).into()
    }

    /// Returns the unit normal of a flat object whose [`SurfacePoint::normal`] is interpolated; `None` for others.
    fn face(&self) -> Option<UnitVec3<S>> {
        None
    }
}

/// A point on a surface.
#[derive(Clone, Copy, Debug)]
pub struct SurfacePoint<S: Scalar> {
    /// Distance from the ray's origin.
    pub distance: S,
    /// The place, which lies on the surface to within its rounding.
    pub point: Vec3<S>,
    /// The unit normal, which points outwards.
    pub normal: UnitVec3<S>,
}

/// An object's colour, material and bounding sphere.
#[derive(Clone, Copy, Debug)]
pub struct Look<S: Scalar> {
    /// Reflectance of the surface.
    pub color: Rgb<S::Unit>,
    /// Number of its material in the scene's list, from 0.
    pub material: u16,
    /// Size of the object, from which [`clearance`](crate::scalar::vector::LengthVector::clearance) is computed.
    pub extent: S,
    /// A place of the object, its centre where it has one.
    pub center: Vec3<S>,
    /// Radius of a sphere about `center` that contains the object; of an infinite one, its own radius.
    pub radius: S,
    /// The smallest radius of the object, which must be above 0.
    pub least: S,
}

/// Returns the smaller of `near` and `far` that is above 0, if it is below `t_max`; `near` is at most `far`.
fn ahead<S: Scalar>(near: S, far: S, t_max: S) -> Option<S> {
    let t = if near > S::ZERO { near } else { far };
    (t > S::ZERO && t < t_max).then_some(t)
}
