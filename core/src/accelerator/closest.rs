//! Which hit of a ray is seen: the nearest, or the first of several surfaces at one place.

use core::marker::PhantomData;
use core::ops::ControlFlow;

use heapless::Vec;

use super::Accelerator;
use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::vector::{UnitVector, Vector};
use crate::scalar::{Scalar, Unit};
use crate::scene::{Hit, Object, Scene, Visit, index};
use crate::shape::{Primitive, Sphere};

/// The hits of a ray that may be seen, of objects that come in any order.
///
/// Flat surfaces at one place, such as polygons of one plane, are hit at distances that differ by roundings. If the nearest
/// alone counted, their colours would alternate at random. So of all flat objects that lie no farther behind the nearest flat one
/// than [`Scalar::at_one_place`], and before any curved one, the first in order of [`Object`] is seen. That does not depend on the
/// order of the search, unless more than `OTHERS` + 1 flat objects lie there. Curved surfaces cross along a line, and need no
/// such rule; a program that draws nothing else takes no `OTHERS`.
#[derive(Clone, Debug)]
pub struct Closest<S: Scalar, const OTHERS: usize = 3> {
    /// The nearest hit of a curved object; of equally near ones, the first in order.
    curved: Option<Hit<S>>,
    /// The nearest hit of a flat one, likewise.
    flat: Option<Hit<S>>,
    /// Hits of flat ones that may lie at its place; of too many, those that are first in order.
    others: Vec<Hit<S>, OTHERS>,
    limit: S,
}

impl<S: Scalar, const OTHERS: usize> Closest<S, OTHERS> {
    /// Starts with no hit.
    #[allow(clippy::new_without_default, reason = "one way is enough")]
    pub const fn new() -> Self {
        Self { curved: None, flat: None, others: Vec::new(), limit: S::FAR }
    }

    /// Returns the distance from which on hits are of no interest.
    pub const fn limit(&self) -> S {
        self.limit
    }

    /// Adds a hit nearer than [`Closest::limit`].
    #[inline]
    pub fn offer(&mut self, hit: Hit<S>) {
        if OTHERS > 0 && is_flat(hit.object) {
            self.offer_flat(hit);
        } else if self.curved.is_none_or(|curved| !comes_first(curved, hit)) {
            self.curved = Some(hit);
            // An equally near object may come first in order.
            self.shorten(hit.distance.next_up());
        }
    }

    /// Adds a hit nearer than [`Closest::limit`] of an object that comes after all others so far in order of [`Object`].
    #[inline]
    fn offer_last(&mut self, hit: Hit<S>) {
        if OTHERS == 0 {
            (self.curved, self.limit) = (Some(hit), hit.distance);
        } else {
            self.offer(hit);
        }
    }

    fn offer_flat(&mut self, hit: Hit<S>) {
        match self.flat {
            Some(flat) if comes_first(flat, hit) => self.keep(hit),
            flat => {
                self.flat = Some(hit);
                let end = hit.distance.at_one_place(S::ZERO, S::Unit::ratio(1, STEEPEST));
                self.shorten(end);
                if let Some(flat) = flat {
                    // What is as far away as the old one, or farther, counts only if that does.
                    if flat.distance < end { self.keep(flat) } else { self.others.clear() }
                }
            }
        }
    }

    #[inline]
    fn shorten(&mut self, limit: S) {
        if limit < self.limit {
            self.limit = limit;
        }
    }

    fn keep(&mut self, hit: Hit<S>) {
        if self.others.is_full() {
            let limit = self.limit;
            self.others.retain(|other| other.distance < limit);
        }
        if let Err(hit) = self.others.push(hit)
            && let Some(last) = self.others.iter_mut().max_by_key(|hit| hit.object)
            && hit.object < last.object
        {
            *last = hit;
        }
    }

    /// Returns the hit that is seen, if there is one.
    #[inline]
    pub fn seen(&self, scene: &Scene<'_, S>, ray: &Ray<S>) -> Option<Hit<S>> {
        if OTHERS == 0 {
            return self.curved;
        }
        match (self.curved, self.flat) {
            (curved, None) => curved,
            (Some(curved), Some(flat)) if comes_first(curved, flat) => Some(curved),
            (_, Some(flat)) if self.others.is_empty() => Some(flat),
            (_, Some(flat)) => Some(self.first(flat, scene, ray)),
        }
    }

    /// Returns the first in order of the hits at the place of the nearest one, `flat`.
    #[inline(never)] // few rays need it
    fn first(&self, flat: Hit<S>, scene: &Scene<'_, S>, ray: &Ray<S>) -> Hit<S> {
        let is_behind = |hit| self.curved.is_some_and(|curved| comes_first(curved, hit));
        let mut first = flat;
        for &hit in self.others.iter().filter(|hit| !is_behind(**hit)) {
            let (cosine, extent) = slope(scene, hit, ray);
            if hit.object < first.object && hit.distance <= flat.distance.at_one_place(extent, cosine) {
                first = hit;
            }
        }
        first
    }
}

/// Returns whether the first of two hits is nearer, or comes first in order of two that are equally near.
#[inline]
fn comes_first<S: Scalar>(hit: Hit<S>, other: Hit<S>) -> bool {
    hit.distance < other.distance || (hit.distance == other.distance && hit.object <= other.object)
}

/// A surface that is seen at a smaller cosine than one over this counts as if it were seen at that.
pub const STEEPEST: i64 = 128;

/// Returns whether an object is flat.
#[inline]
pub const fn is_flat(object: Object) -> bool {
    matches!(object, Object::Triangle(_) | Object::Plane(_) | Object::Floor)
}

/// Returns the size of the cosine of the angle between a ray and the normal of a flat object, and the object's size.
fn slope<S: Scalar>(scene: &Scene<'_, S>, hit: Hit<S>, ray: &Ray<S>) -> (S::Unit, S) {
    let (cosine, extent) = match hit.object {
        Object::Triangle(i) => scene.triangles.get(index(i)).map_or((S::Unit::ONE, S::ZERO), |triangle| {
            (triangle.normal.dot(ray.direction), triangle.extent)
        }),
        Object::Plane(i) => scene
            .planes
            .get(index(i))
            .map_or((S::Unit::ONE, S::ZERO), |plane| (plane.normal.dot(ray.direction), hit.distance)),
        _ => (ray.direction.z(), hit.distance),
    };
    let size = if cosine < S::Unit::ZERO { -cosine } else { cosine };
    let least = S::Unit::ratio(1, STEEPEST);
    (if size > least { size } else { least }, extent)
}

/// Returns the hit that is seen along a ray, if there is one, of the floor, which the ray meets at the distance `floor`, of the
/// candidates of an accelerator, and of visible lamps.
pub(super) fn closest<S: Scalar, N: Needs, A: Accelerator<S>>(
    accelerator: &A,
    scene: &Scene<'_, S>,
    ray: &Ray<S>,
    floor: Option<S>,
) -> Option<Hit<S>> {
    // Whether a program can draw two flat objects at one place: the floor and another, or two others.
    if N::TRIANGLES || N::PLANES {
        search::<S, N, A, 3>(accelerator, scene, ray, floor)
    } else {
        search::<S, N, A, 0>(accelerator, scene, ray, floor)
    }
}

fn search<S: Scalar, N: Needs, A: Accelerator<S>, const OTHERS: usize>(
    accelerator: &A,
    scene: &Scene<'_, S>,
    ray: &Ray<S>,
    floor: Option<S>,
) -> Option<Hit<S>> {
    let mut search = Search::<S, A, OTHERS> { ray, closest: Closest::new(), accelerator: PhantomData };
    if let Some(distance) = floor {
        search.closest.offer_last(Hit { distance, object: Object::Floor });
    }
    let _ = accelerator.candidates::<N>(scene, ray, &mut search);
    if N::VISIBLE_LAMPS {
        for (i, lamp) in (0..).zip(scene.lamps) {
            if lamp.radius > S::ZERO
                && let Some(distance) =
                    Sphere::distance(lamp.position, lamp.radius, ray, search.closest.limit())
            {
                // Lamps are last in order.
                search.closest.offer_last(Hit { distance, object: Object::Lamp(i) });
            }
        }
    }
    search.closest.seen(scene, ray)
}

/// The visitor that finds the nearest hit of the candidates of an accelerator.
struct Search<'r, S: Scalar, A, const OTHERS: usize> {
    ray: &'r Ray<S>,
    closest: Closest<S, OTHERS>,
    accelerator: PhantomData<A>,
}

impl<S: Scalar, A: Accelerator<S>, const OTHERS: usize> Visit<S> for Search<'_, S, A, OTHERS> {
    fn t_max(&self) -> S {
        self.closest.limit()
    }

    fn run<P: Primitive<S>>(&mut self, first: Object, run: &[P]) -> ControlFlow<()> {
        for (i, primitive) in (0..).zip(run) {
            if let Some(distance) = primitive.intersect(self.ray, self.closest.limit()) {
                let hit = Hit { distance, object: first.after(i) };
                if A::IN_ORDER {
                    self.closest.offer_last(hit);
                } else {
                    self.closest.offer(hit);
                }
            }
        }
        ControlFlow::Continue(())
    }
}
