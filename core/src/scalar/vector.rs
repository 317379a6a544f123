//! Vectors of three lengths and of three components of a unit vector.
//!
//! Right-handed, z up. A float's vectors are glam's, so that a program which already has those need not convert; every
//! other scalar uses [`Xyz`].

use core::fmt::Debug;
use core::ops::{Add, Neg, Sub};

mod xyz;

use super::{Scalar, Unit};
pub use xyz::Xyz;

/// A place or a displacement: three lengths.
pub type Vec3<S> = <S as Scalar>::Vector;
/// A direction: three components in [-1, 1] whose squares add up to 1.
pub type UnitVec3<S> = <S as Scalar>::UnitVector;

/// Three components.
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
    /// A vector from its components.
    fn new(x: Self::Component, y: Self::Component, z: Self::Component) -> Self;
    /// East.
    fn x(self) -> Self::Component;
    /// North.
    fn y(self) -> Self::Component;
    /// Up.
    fn z(self) -> Self::Component;
}

/// What a vector of lengths can do.
pub trait LengthVector: Vector {
    /// The scalar whose vector this is.
    type Scalar: Scalar<Vector = Self>;
    /// `self . direction`, rounded once.
    fn dot(self, direction: UnitVec3<Self::Scalar>) -> Self::Scalar;
    /// `|self|^2`, exact in fixed point.
    fn norm_squared(self) -> <Self::Scalar as Scalar>::Wide;
    /// The place `self + distance * direction`.
    fn along(self, direction: UnitVec3<Self::Scalar>, distance: Self::Scalar) -> Self;
    /// `self - distance * direction`, each component rounded once: what is left of a displacement across a ray.
    fn reject(self, direction: UnitVec3<Self::Scalar>, distance: Self::Scalar) -> Self;
    /// `(distance * direction - self) / radius`, to the precision of a unit vector: a place on a ray as an object of
    /// that radius sees it whose centre is `self` away from the ray's origin. The place lies within the radius.
    fn local(
        self,
        direction: UnitVec3<Self::Scalar>,
        distance: Self::Scalar,
        radius: <Self::Scalar as Scalar>::Inverse,
    ) -> UnitVec3<Self::Scalar>;
    /// Direction, length and reciprocal of the length; nothing for the zero vector.
    #[allow(clippy::type_complexity)] // three values that cost one reciprocal square root together
    fn normalize(self) -> Option<(UnitVec3<Self::Scalar>, Self::Scalar, <Self::Scalar as Scalar>::Inverse)>;
    /// Where a ray starts that leaves a surface at the place `self`: pushed off by more than the place can be wrong, so
    /// that it does not meet the surface again; and how much of the ray that uses up, with what its end can be wrong.
    ///
    /// The start stays on the ray as long as that is not too flat, since a mirror magnifies a sideways step; a flat one
    /// is pushed off along the `normal`, which is on the ray's side. `extent` is the size of the object.
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
    /// How far a place on a surface of that extent is to be pushed off it; and six times that.
    fn clearance(self, extent: Self::Scalar) -> (Self::Scalar, Self::Scalar);
    /// `x * ex + y * ey`: the dot product in the ground plan.
    fn dot_plan(self, plan: Plan<Self::Scalar>) -> Self::Scalar;
    /// `x * ey - y * ex`: how far the ray of that plan passes by `self`, with a sign.
    fn cross_plan(self, plan: Plan<Self::Scalar>) -> Self::Scalar;
    /// The same over a radius that is no smaller in size, to the precision of a unit vector; saturates.
    fn cross_plan_over(
        self,
        plan: Plan<Self::Scalar>,
        radius: <Self::Scalar as Scalar>::Inverse,
    ) -> <Self::Scalar as Scalar>::Unit;
}

/// What a unit vector can do.
pub trait UnitVector: Vector<Component: Unit> {
    /// East.
    const X: Self;
    /// North.
    const Y: Self;
    /// Up, the thesis's CENIT.
    const Z: Self;
    /// Cosine of the angle between two directions.
    fn dot(self, other: Self) -> Self::Component;
    /// The cross product.
    fn cross(self, other: Self) -> Self;
    /// Each component times `factor`.
    fn scale(self, factor: Self::Component) -> Self;
    /// Each component times that of `other`.
    fn times(self, other: Self) -> Self;
    /// `self + factor * other`, each component rounded once.
    fn plus(self, other: Self, factor: Self::Component) -> Self;
    /// The unit vector along a vector of any length below 2, and the reciprocal of that length; nothing for zero.
    fn normalize(self) -> Option<(Self, <Self::Component as Unit>::Inverse)>;
    /// A vector whose length is 1 but for some roundings, with length 1 but for one: a step of Newton's iteration. What
    /// is not mended here grows with each reflection, up to five times.
    fn tighten(self) -> Self {
        let excess = self.dot(self) - Self::Component::ONE;
        self.plus(self, excess.times(Self::Component::ratio(-1, 2)))
    }
    /// The reflection `self - 2 (self . normal) normal` (Whitted 1980).
    fn reflect(self, normal: Self) -> Self;
    /// The unit vector halfway between two directions (Blinn's H); nothing for opposite ones.
    fn halfway(self, other: Self) -> Option<Self>;
    /// `sqrt(radius^2 - |self|^2)`, the difference exact in fixed point: half the chord of a sphere whose foot point
    /// is `self`; nothing where it is negative.
    fn half_chord(self, radius: Self::Component) -> Option<Self::Component>;
    /// The direction's ground plan; nothing for one that is vertical.
    fn plan<S: Scalar<Unit = Self::Component>>(self) -> Option<Plan<S>>;
}

/// A direction seen from above: the unit vector of its x and y, and the reciprocal of their length.
#[derive(Clone, Copy, Debug)]
pub struct Plan<S: Scalar> {
    /// x of the unit vector in the plan.
    pub x: S::Unit,
    /// y of the unit vector in the plan.
    pub y: S::Unit,
    /// Reciprocal of the length of (x, y) before: one unit in the plan is that long in space.
    pub stretch: <S::Unit as Unit>::Inverse,
}
