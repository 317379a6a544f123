//! Vectors of lengths, and unit vectors.
//!
//! Coordinates are right-handed, with z up. Floats use glam's vectors, so that a program which has those need not convert
//! them; every other scalar uses [`Xyz`].

use core::fmt::Debug;
use core::ops::{Add, Neg, Sub};

mod xyz;

use super::{Scalar, Unit};
pub use xyz::Xyz;

/// A place or a displacement: three lengths.
pub type Vec3<S> = <S as Scalar>::Vector;
/// A direction: three components in [-1, 1] whose squares add up to 1.
pub type UnitVec3<S> = <S as Scalar>::UnitVector;

/// A vector of three components.
pub trait Vector:
    Copy
    + Debug
    + PartialEq
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// A length or a component of a unit vector.
    type Component: Copy;
    /// Returns a vector from its components.
    fn new(x: Self::Component, y: Self::Component, z: Self::Component) -> Self;
    /// Returns the component to the east.
    fn x(self) -> Self::Component;
    /// Returns the component to the north.
    fn y(self) -> Self::Component;
    /// Returns the component upwards.
    fn z(self) -> Self::Component;
}

/// The operations of a vector of lengths.
pub trait LengthVector: Vector {
    /// The scalar whose vector this is.
    type Scalar: Scalar<Vector = Self>;
    /// Returns the dot product `self . direction`, rounded once.
    fn dot(self, direction: UnitVec3<Self::Scalar>) -> Self::Scalar;
    /// Returns `|self|^2`, exact in fixed point.
    fn norm_squared(self) -> <Self::Scalar as Scalar>::Wide;
    /// Returns the place `self + distance * direction`.
    fn along(self, direction: UnitVec3<Self::Scalar>, distance: Self::Scalar) -> Self;
    /// Returns `self - distance * direction`, each component rounded once: the part of a displacement normal to a ray.
    fn reject(self, direction: UnitVec3<Self::Scalar>, distance: Self::Scalar) -> Self {
        self.along(direction, -distance)
    }
    /// Returns `(distance * direction - self) / radius`, to the precision of a unit vector: a place on a ray relative to an
    /// object whose centre is `self` away from the ray's origin, in units of its radius. The place lies within the radius.
    fn local(
        self,
        direction: UnitVec3<Self::Scalar>,
        distance: Self::Scalar,
        radius: <Self::Scalar as Scalar>::Inverse,
    ) -> UnitVec3<Self::Scalar>;
    /// Returns direction, length and reciprocal of the length; `None` for the zero vector.
    #[allow(clippy::type_complexity)] // three values that cost one reciprocal square root together
    fn normalize(self) -> Option<(UnitVec3<Self::Scalar>, Self::Scalar, <Self::Scalar as Scalar>::Inverse)>;
    /// Returns the origin of a ray that leaves a surface at the place `self`: pushed off by more than the place's rounding error,
    /// so that the ray does not meet the surface again; and the length by which a shadow ray is to be shortened for that.
    ///
    /// A steep ray is pushed off along its direction, since a mirror magnifies a sideways step; a flat one along the `normal`,
    /// which is on the ray's side. `extent` is the size of the object.
    fn leave(
        self,
        normal: UnitVec3<Self::Scalar>,
        direction: UnitVec3<Self::Scalar>,
        extent: Self::Scalar,
    ) -> (Self, Self::Scalar) {
        let ratio = <Self::Scalar as Scalar>::Unit::ratio;
        let (step, most) = self.clearance(extent);
        let cosine = normal.dot(direction);
        let start = if cosine >= ratio(1, 2) {
            self.along(direction, step + step)
        } else if cosine >= ratio(1, 4) {
            self.along(direction, step + step + step + step)
        } else {
            self.along(normal, step)
        };
        (start, most)
    }
    /// Returns the distance by which a place is pushed off the surface of an object of that extent, and six times that.
    fn clearance(self, extent: Self::Scalar) -> (Self::Scalar, Self::Scalar);
    /// Returns `x * ex + y * ey`: the dot product in the ground plan.
    fn dot_plan(self, plan: Plan<Self::Scalar>) -> Self::Scalar;
    /// Returns `x * ey - y * ex`: the signed distance in the ground plan by which the ray misses `self`.
    fn cross_plan(self, plan: Plan<Self::Scalar>) -> Self::Scalar;
    /// Returns that distance over a radius that is no smaller, to the precision of a unit vector; saturates.
    fn cross_plan_over(
        self,
        plan: Plan<Self::Scalar>,
        radius: <Self::Scalar as Scalar>::Inverse,
    ) -> <Self::Scalar as Scalar>::Unit;
}

/// The operations of a unit vector.
pub trait UnitVector: Vector<Component: Unit> {
    /// East.
    const X: Self;
    /// North.
    const Y: Self;
    /// Up, the thesis's CENIT.
    const Z: Self;
    /// Returns the dot product: the cosine of the angle between two directions.
    fn dot(self, other: Self) -> Self::Component;
    /// Returns the cross product.
    fn cross(self, other: Self) -> Self;
    /// Returns the vector with each component times `factor`.
    fn scale(self, factor: Self::Component) -> Self {
        self.times(Self::new(factor, factor, factor))
    }
    /// Returns the products of the components of both vectors.
    fn times(self, other: Self) -> Self {
        Self::new(self.x().times(other.x()), self.y().times(other.y()), self.z().times(other.z()))
    }
    /// Returns `self + factor * other`, each component rounded once.
    fn plus(self, other: Self, factor: Self::Component) -> Self;
    /// Returns the unit vector along a vector of any length below 2, and the reciprocal of that length; `None` for 0.
    fn normalize(self) -> Option<(Self, <Self::Component as Unit>::Inverse)>;
    /// Returns a vector that is almost of length 1, closer to that length by a step of Newton's iteration. Each reflection
    /// would magnify the error up to five times.
    fn tighten(self) -> Self {
        let excess = self.dot(self) - Self::Component::ONE;
        self.plus(self, excess.times(Self::Component::ratio(-1, 2)))
    }
    /// Returns the reflection `self - 2 (self . normal) normal` (Whitted 1980).
    fn reflect(self, normal: Self) -> Self;
    /// Returns the unit vector halfway between two directions (Blinn's H); `None` for opposite ones.
    fn halfway(self, other: Self) -> Option<Self>;
    /// Returns `sqrt(radius^2 - |self|^2)`, the difference exact in fixed point: half the chord of a ray with the foot point
    /// `self` in a sphere about 0; `None` where the ray misses the sphere.
    fn half_chord(self, radius: Self::Component) -> Option<Self::Component>;
    /// Returns the direction as seen from above; `None` for a vertical one.
    fn plan<S: Scalar<Unit = Self::Component>>(self) -> Option<Plan<S>> {
        let (flat, stretch) = Self::new(self.x(), self.y(), Unit::ZERO).normalize()?;
        Some(Plan { x: flat.x(), y: flat.y(), stretch })
    }
}

/// A direction seen from above: the unit vector of its x and y, and the reciprocal of their length.
#[derive(Clone, Copy, Debug)]
pub struct Plan<S: Scalar> {
    /// x of the unit vector in the plan.
    pub x: S::Unit,
    /// y of the unit vector in the plan.
    pub y: S::Unit,
    /// Reciprocal of the length of (x, y) before it was normalised: the length in space of one unit in the plan.
    pub stretch: <S::Unit as Unit>::Inverse,
}
