//! The primitives, each its own file: where a ray meets it, and what the surface is like there.
//!
//! The search for the nearest hit asks each primitive for a distance, in the length's own format. What it finds is then
//! looked at once more, from nearby: the place is computed relative to the object and its size, so that the normal has
//! the precision of a unit vector, and the hit point lies on the surface to within its own rounding.

mod cone;
mod cylinder;
mod ellipsoid;
mod floor;
pub(crate) mod sphere;
mod triangle;

pub use cone::Cone;
pub use cylinder::Cylinder;
pub use ellipsoid::Ellipsoid;
pub use floor::Floor;
pub use sphere::Sphere;
pub use triangle::Triangle;

use crate::scalar::Scalar;
use crate::vector::{UnitVec3, Vec3};

/// A place on a surface.
#[derive(Clone, Copy, Debug)]
pub struct Spot<S: Scalar> {
    /// Distance from the ray's origin.
    pub distance: S,
    /// The place, on the surface to within its rounding.
    pub point: Vec3<S>,
    /// The unit normal on the outside.
    pub normal: UnitVec3<S>,
}

/// The nearer of two distances along a ray that lies ahead, if it is short of `t_max`.
fn ahead<S: Scalar>(near: S, far: S, t_max: S) -> Option<S> {
    let t = if near > S::ZERO { near } else { far };
    (t > S::ZERO && t < t_max).then_some(t)
}
