//! A bounding volume hierarchy over the spheres of a scene (J. Goldsmith and J. Salmon, "Automatic Creation of Object
//! Hierarchies for Ray Tracing", IEEE CG&A 7, 1987), made ahead and borrowed, walked without a stack.
//!
//! The volumes are spheres, so that a node costs what a sphere costs and no direction has to be inverted. A node stands for
//! a run of the scene's list; nodes lie in preorder, and each knows where the walk goes on if the ray misses it (B. Smits,
//! "Efficiency Issues for Ray Tracing", 1998). Spheres are met in the order of their list, and none is left out that
//! the search would find: a picture is the same with the hierarchy and without.

use core::marker::PhantomData;

use crate::needs::Needs;
use crate::ray::Ray;
use crate::scalar::{Scalar, Unit};
use crate::shape::Sphere;
use crate::vector::{LengthVector, Vec3};

/// A node: a sphere about a run of the scene's spheres.
#[derive(Clone, Copy, Debug)]
pub struct Node<S: Scalar> {
    /// Centre.
    pub center: Vec3<S>,
    /// Radius: the spheres of the run lie within.
    pub radius: S,
    /// The first sphere of the run.
    pub first: u32,
    /// The sphere after the last of the run.
    pub end: u32,
    /// The node after all that lie below this one; a leaf has none below.
    pub skip: u32,
}

impl<S: Scalar> Node<S> {
    /// Whether a ray may meet a sphere of the run nearer than `t_max`. The radius is [`Scalar::swollen`] by what this test
    /// and the search can be wrong together.
    #[inline]
    fn is_met(&self, ray: &Ray<S>, t_max: S) -> bool {
        let displacement = self.center - ray.origin;
        let b = displacement.dot(ray.direction);
        let radius = self.radius.swollen(b);
        if b < -radius || (b > S::ZERO && b - radius >= t_max) {
            return false;
        }
        displacement.reject(ray.direction, b).norm_squared() <= radius.square()
    }
}

/// The spheres that a ray may meet, one after the other in the order of their list.
pub(crate) struct Walk<'a, S: Scalar, N> {
    nodes: &'a [Node<S>],
    spheres: &'a [Sphere<S>],
    /// The node to be looked at next.
    node: usize,
    /// The run of the leaf that the walk is in.
    next: usize,
    end: usize,
    needs: PhantomData<fn() -> N>,
}

impl<'a, S: Scalar, N: Needs> Walk<'a, S, N> {
    /// Without a hierarchy the walk is in one leaf from the beginning, with all spheres.
    pub(crate) fn new(nodes: &'a [Node<S>], spheres: &'a [Sphere<S>]) -> Self {
        let nodes = if N::HIERARCHY { nodes } else { &[] };
        let end = if nodes.is_empty() { spheres.len() } else { 0 };
        Self { nodes, spheres, node: 0, next: 0, end, needs: PhantomData }
    }

    /// The next sphere that may be met nearer than `t_max`, which may shrink from call to call.
    #[inline]
    pub(crate) fn next(&mut self, ray: &Ray<S>, t_max: S) -> Option<(usize, &'a Sphere<S>)> {
        while N::HIERARCHY && self.next == self.end {
            let node = self.nodes.get(self.node)?;
            if node.is_met(ray, t_max) {
                self.node += 1;
                if index(node.skip) == self.node {
                    (self.next, self.end) = (index(node.first), index(node.end));
                }
            } else {
                self.node = index(node.skip);
            }
        }
        let number = self.next;
        self.next += 1;
        self.spheres.get(number).map(|sphere| (number, sphere))
    }
}

/// A number of a node or of a sphere as an index.
fn index(number: u32) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}

/// The first node that is wrong: that does not lead on, or whose runs are not within the list, in order and complete, or
/// that does not contain its spheres. A hierarchy without nodes is right.
pub(crate) fn first_wrong<S: Scalar>(nodes: &[Node<S>], spheres: &[Sphere<S>], most: S) -> Option<usize> {
    let mut covered = 0;
    for (number, node) in nodes.iter().enumerate() {
        let (first, end, skip) = (index(node.first), index(node.end), index(node.skip));
        let run = spheres.get(first..end);
        let contains = |sphere: &Sphere<S>| {
            let room = node.radius - sphere.radius;
            room >= S::ZERO && (sphere.center - node.center).norm_squared() <= room.square()
        };
        let sound = skip > number && skip <= nodes.len() && node.radius > S::ZERO && node.radius <= most;
        // Leaves follow each other through the list; what is above them begins where the next leaf does.
        if !sound || first != covered || !run.is_some_and(|run| !run.is_empty() && run.iter().all(contains)) {
            return Some(number);
        }
        if skip == number + 1 {
            covered = end;
        }
    }
    (!nodes.is_empty() && covered != spheres.len()).then(|| nodes.len() - 1)
}

/// Half of the largest length, the most that a node's radius may be.
pub(crate) fn largest_radius<S: Scalar>() -> S {
    S::FAR.scale(S::Unit::ratio(1, 2))
}
