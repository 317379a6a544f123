//! A ray: a place and a direction.

use crate::lanes::LANES;
use crate::needs::Needs;
use crate::scalar::Scalar;
use crate::vector::{Plan, UnitVec3, UnitVector, Vec3};

/// The places `origin + t direction`, `t > 0`.
#[derive(Clone, Copy, Debug)]
pub struct Ray<S: Scalar> {
    /// Where it starts.
    pub origin: Vec3<S>,
    /// Where it goes: a unit vector.
    pub direction: UnitVec3<S>,
    /// The direction seen from above, for cylinders; nothing for a vertical ray, where there are no cylinders, or where
    /// [`lanes`](crate::lanes) leave few of them to be asked.
    pub plan: Option<Plan<S>>,
}

impl<S: Scalar> Ray<S> {
    /// A ray through a scene that needs `N`.
    pub fn new<N: Needs>(origin: Vec3<S>, direction: UnitVec3<S>) -> Self {
        Self { origin, direction, plan: if N::CYLINDERS { direction.plan() } else { None } }
    }

    /// The direction seen from above; nothing for a vertical ray.
    #[inline]
    pub(crate) fn plan(&self) -> Option<Plan<S>> {
        if LANES { self.plan.or_else(|| self.direction.plan()) } else { self.plan }
    }
}
