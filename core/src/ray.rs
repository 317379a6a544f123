//! A ray: an origin and a direction.

use crate::scalar::Scalar;
use crate::scalar::vector::{Plan, UnitVec3, UnitVector, Vec3};

/// The kinds of rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RayKind {
    /// A ray from the eye.
    Primary,
    /// A reflected ray, also by total internal reflection.
    Reflected,
    /// A transmitted ray.
    Transmitted,
    /// A ray from a surface to a lamp.
    Shadow,
}

/// Where a ray starts and where it goes.
#[derive(Clone, Copy, Debug)]
pub struct Start<S: Scalar> {
    /// The place where it starts.
    pub origin: Vec3<S>,
    /// The unit vector along it.
    pub direction: UnitVec3<S>,
}

/// The places `origin + t direction`, `t > 0`.
#[derive(Clone, Copy, Debug)]
pub struct Ray<S: Scalar> {
    /// Where it starts.
    pub origin: Vec3<S>,
    /// Its direction, a unit vector.
    pub direction: UnitVec3<S>,
    /// The ray seen from above, for infinite cylinders; `None` for a vertical ray, which meets none of them, and where they are
    /// not tested.
    pub plan: Option<GroundPlan<S>>,
}

/// A ray seen from above.
#[derive(Clone, Copy, Debug)]
pub struct GroundPlan<S: Scalar> {
    /// Its direction in the plan.
    pub direction: Plan<S>,
    /// Infinite cylinders are lit above this height, and below its negative, as if they were there.
    pub cylinder_end: S,
}

impl<S: Scalar> Ray<S> {
    /// Returns a ray without a plan, which misses infinite cylinders.
    pub const fn new(origin: Vec3<S>, direction: UnitVec3<S>) -> Self {
        Self { origin, direction, plan: None }
    }

    /// Returns the ray with its plan, for infinite cylinders, which are lit above the height `cylinder_end` and below its
    /// negative as if they were there.
    pub fn with_plan(self, cylinder_end: S) -> Self {
        let plan = self.direction.plan().map(|direction| GroundPlan { direction, cylinder_end });
        Self { plan, ..self }
    }
}
