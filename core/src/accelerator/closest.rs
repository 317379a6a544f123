//! The visitor that finds the nearest hit.

use core::ops::ControlFlow;

use crate::light::Lamp;
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::Scalar;
use crate::scene::{Hit, Object, Visit};
use crate::shape::{Primitive, Sphere};

/// The nearest hit of a ray so far. Where objects come `IN_ORDER` of [`Object`], a later one counts only if it is nearer.
pub(super) struct Closest<'r, S: Scalar, const IN_ORDER: bool> {
    ray: &'r Ray<S>,
    /// Only hits nearer than this are of interest.
    t_max: S,
    hit: Option<Hit<S>>,
}

impl<'r, S: Scalar, const IN_ORDER: bool> Closest<'r, S, IN_ORDER> {
    /// Starts the search for a ray that meets the floor at the distance `floor`, if at all.
    pub(super) fn new(ray: &'r Ray<S>, floor: Option<S>) -> Self {
        let mut closest = Self { ray, t_max: S::FAR, hit: None };
        if let Some(distance) = floor {
            closest.take(Hit { distance, object: Object::Floor });
        } else if !IN_ORDER {
            closest.t_max = S::FAR.next_up();
        }
        closest
    }

    fn take(&mut self, hit: Hit<S>) {
        // Out of order, an equally near object may come first in order of `Object`.
        self.t_max = if IN_ORDER { hit.distance } else { hit.distance.next_up() };
        self.hit = Some(hit);
    }

    /// Returns the nearest hit, visible lamps included.
    pub(super) fn with_lamps<N: Needs>(mut self, lamps: &[Lamp<S>]) -> Option<Hit<S>> {
        if N::VISIBLE_LAMPS {
            for (i, lamp) in (0..).zip(lamps) {
                // Lamps are last in order: one has to be nearer.
                let t_max = self.hit.map_or(S::FAR, |hit| hit.distance);
                if lamp.radius > S::ZERO
                    && let Some(distance) = Sphere::distance(lamp.position, lamp.radius, self.ray, t_max)
                {
                    self.hit = Some(Hit { distance, object: Object::Lamp(i) });
                }
            }
        }
        self.hit
    }
}

impl<S: Scalar, const IN_ORDER: bool> Visit<S> for Closest<'_, S, IN_ORDER> {
    fn t_max(&self) -> S {
        self.t_max
    }

    fn run<P: Primitive<S>>(&mut self, first: Object, run: &[P]) -> ControlFlow<()> {
        for (i, primitive) in (0..).zip(run) {
            if let Some(distance) = primitive.intersect(self.ray, self.t_max) {
                let object = first.after(i);
                let is_first = |hit: Hit<S>| distance < hit.distance || object < hit.object;
                if IN_ORDER || self.hit.is_none_or(is_first) {
                    self.take(Hit { distance, object });
                }
            }
        }
        ControlFlow::Continue(())
    }
}
