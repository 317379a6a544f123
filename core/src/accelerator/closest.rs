//! Which hit of a ray is seen: the nearest, or the first of several surfaces at one place.

use core::marker::PhantomData;
use core::ops::ControlFlow;

use heapless::Vec;

use crate::light::Lamp;
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::vector::{UnitVector, Vector};
use crate::scalar::{Scalar, Unit};
use crate::scene::{Hit, Object, Scene, Visit, index};
use crate::shape::{Primitive, Sphere};

/// How many hits are kept besides the nearest one.
const OTHERS: usize = 3;

/// The hits of a ray that may be seen, of objects that come in any order.
///
/// Flat surfaces at one place, such as polygons of one plane, are hit at distances that differ by roundings. If the nearest
/// alone counted, their colours would alternate at random. So of all flat objects that lie no farther behind the nearest hit,
/// itself of a flat object, than [`Scalar::at_one_place`], the first in order of [`Object`] is seen. Neither the set nor the
/// order depends on the order of the search. Curved surfaces cross along a line, and need no such rule.
#[derive(Clone, Debug)]
pub struct Closest<S: Scalar> {
    /// The nearest hit; of equally near ones, the first in order.
    nearest: Option<Hit<S>>,
    /// Hits that may lie at its place; of too many, those that are first in order.
    others: Vec<Hit<S>, OTHERS>,
    limit: S,
}

impl<S: Scalar> Closest<S> {
    /// Starts with no hit.
    #[allow(clippy::new_without_default, reason = "one way is enough")]
    pub const fn new() -> Self {
        Self { nearest: None, others: Vec::new(), limit: S::FAR }
    }

    /// Returns the distance from which on hits are of no interest.
    pub const fn limit(&self) -> S {
        self.limit
    }

    /// Adds a hit.
    #[inline]
    pub fn offer<N: Needs>(&mut self, hit: Hit<S>) {
        match self.nearest {
            Some(nearest) if (nearest.distance, nearest.object) <= (hit.distance, hit.object) => {
                self.keep::<N>(hit);
            }
            nearest => {
                self.nearest = Some(hit);
                self.limit = hit.distance.at_one_place(S::ZERO, S::Unit::ratio(1, STEEPEST));
                if let Some(nearest) = nearest {
                    // What is as far away as the old one, or farther, counts only if that does.
                    if nearest.distance >= self.limit {
                        self.others.clear();
                    } else {
                        self.keep::<N>(nearest);
                    }
                }
            }
        }
    }

    fn keep<N: Needs>(&mut self, hit: Hit<S>) {
        if N::TRIANGLES
            && is_flat(hit.object)
            && let Err(hit) = self.others.push(hit)
            && let Some(last) = self.others.iter_mut().max_by_key(|hit| hit.object)
            && hit.object < last.object
        {
            *last = hit;
        }
    }

    /// Returns the hit that is seen, if there is one.
    #[inline]
    pub fn seen<N: Needs>(&self, scene: &Scene<'_, S>, ray: &Ray<S>) -> Option<Hit<S>> {
        let nearest = self.nearest?;
        let is_alone = !N::TRIANGLES || self.others.is_empty() || !is_flat(nearest.object);
        Some(if is_alone { nearest } else { self.first(nearest, scene, ray) })
    }

    /// Returns the first in order of the hits at the place of the nearest one.
    #[inline(never)] // few rays need it
    fn first(&self, nearest: Hit<S>, scene: &Scene<'_, S>, ray: &Ray<S>) -> Hit<S> {
        let mut first = nearest;
        for &hit in &self.others {
            let (cosine, extent) = slope(scene, hit, ray);
            if hit.object < first.object && hit.distance <= nearest.distance.at_one_place(extent, cosine) {
                first = hit;
            }
        }
        first
    }
}

/// A surface that is seen at a smaller cosine than one over this counts as if it were seen at that.
const STEEPEST: i64 = 128;

/// Returns whether an object is flat.
const fn is_flat(object: Object) -> bool {
    matches!(object, Object::Triangle(_) | Object::Floor)
}

/// Returns the size of the cosine of the angle between a ray and the normal of a flat object, and the object's size.
fn slope<S: Scalar>(scene: &Scene<'_, S>, hit: Hit<S>, ray: &Ray<S>) -> (S::Unit, S) {
    let (cosine, extent) = match hit.object {
        Object::Triangle(i) => scene.triangles.get(index(i)).map_or((S::Unit::ONE, S::ZERO), |triangle| {
            (triangle.normal.dot(ray.direction), triangle.extent)
        }),
        _ => (ray.direction.z(), hit.distance),
    };
    let size = if cosine < S::Unit::ZERO { -cosine } else { cosine };
    let least = S::Unit::ratio(1, STEEPEST);
    (if size > least { size } else { least }, extent)
}

/// The visitor that finds the nearest hit.
pub(super) struct Search<'r, S: Scalar, N> {
    ray: &'r Ray<S>,
    pub(super) closest: Closest<S>,
    needs: PhantomData<N>,
}

impl<'r, S: Scalar, N: Needs> Search<'r, S, N> {
    /// Starts the search for a ray that meets the floor at the distance `floor`, if at all.
    pub(super) fn new(ray: &'r Ray<S>, floor: Option<S>) -> Self {
        let mut closest = Closest::new();
        if let Some(distance) = floor {
            closest.offer::<N>(Hit { distance, object: Object::Floor });
        }
        Self { ray, closest, needs: PhantomData }
    }

    /// Adds the hits of visible lamps.
    pub(super) fn add_lamps(&mut self, lamps: &[Lamp<S>]) {
        for (i, lamp) in (0..).zip(lamps) {
            if lamp.radius > S::ZERO
                && let Some(distance) =
                    Sphere::distance(lamp.position, lamp.radius, self.ray, self.closest.limit())
            {
                self.closest.offer::<N>(Hit { distance, object: Object::Lamp(i) });
            }
        }
    }
}

impl<S: Scalar, N: Needs> Visit<S> for Search<'_, S, N> {
    fn t_max(&self) -> S {
        self.closest.limit()
    }

    fn run<P: Primitive<S>>(&mut self, first: Object, run: &[P]) -> ControlFlow<()> {
        for (i, primitive) in (0..).zip(run) {
            if let Some(distance) = primitive.intersect(self.ray, self.closest.limit()) {
                self.closest.offer::<N>(Hit { distance, object: first.after(i) });
            }
        }
        ControlFlow::Continue(())
    }
}
