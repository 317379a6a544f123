//! A ray: a place and a direction.

use crate::scalar::Scalar;
use crate::scalar::vector::{Plan, UnitVec3, UnitVector, Vec3};

/// What a ray is traced for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RayKind {
    /// From the eye.
    Primary,
    /// Reflected, also by total internal reflection.
    Reflected,
    /// Transmitted.
    Transmitted,
    /// To a lamp.
    Shadow,
}

/// The places `origin + t direction`, `t > 0`.
#[derive(Clone, Copy, Debug)]
pub struct Ray<S: Scalar> {
    /// Where it starts.
    pub origin: Vec3<S>,
    /// Where it goes: a unit vector.
    pub direction: UnitVec3<S>,
    /// The ray seen from above, for cylinders without ends; nothing for a vertical ray, which meets none of them, and where
    /// nobody will ask them.
    pub plan: Option<GroundPlan<S>>,
}

/// A ray seen from above.
#[derive(Clone, Copy, Debug)]
pub struct GroundPlan<S: Scalar> {
    /// Its direction.
    pub direction: Plan<S>,
    /// Cylinders are seen between this height and its negative.
    pub cylinder_end: S,
}

impl<S: Scalar> Ray<S> {
    /// Returns a ray that no cylinder without ends will be asked about.
    pub const fn new(origin: Vec3<S>, direction: UnitVec3<S>) -> Self {
        Self { origin, direction, plan: None }
    }

    /// Returns the ray made ready for cylinders without ends, which are seen between the height `cylinder_end` and its
    /// negative.
    pub fn with_plan(self, cylinder_end: S) -> Self {
        let plan = self.direction.plan().map(|direction| GroundPlan { direction, cylinder_end });
        Self { plan, ..self }
    }
}
