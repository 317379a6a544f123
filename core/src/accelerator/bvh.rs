//! A bounding volume hierarchy (J. Goldsmith and J. Salmon, "Automatic Creation of Object Hierarchies for Ray Tracing", IEEE
//! CG&A 7, 1987), built ahead and borrowed, walked without a stack.
//!
//! The volumes are spheres, so that no direction has to be inverted. Nodes lie in
//! preorder, and each knows where the walk goes on if the ray misses it (B. Smits, "Efficiency Issues for Ray Tracing", 1998).
//! A leaf holds a run of [`Bvh::order`], or of the scene's list of spheres. No hit is lost to rounding: the radius of a node is
//! [`Scalar::padded`] by the greatest error of its test and of the test of an object in it.

use core::hash::{Hash, Hasher};
use core::ops::ControlFlow;

use super::Accelerator;
use crate::error::Error;
use crate::needs::{Everything, Needs};
use crate::ray::Ray;
use crate::scalar::vector::{LengthVector, Vec3};
use crate::scalar::{Scalar, Unit};
use crate::scene::{Object, Scene, Visit, index};
use crate::shape::{Primitive, Sphere};

/// A node: a bounding sphere about a run of consecutive objects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node<S: Scalar> {
    /// Centre of the bounding sphere.
    pub center: Vec3<S>,
    /// Its radius, more than 0 and at most half of the largest length.
    pub radius: S,
    /// Index of the first object of the run.
    pub first: u32,
    /// Index after the last object of the run.
    pub end: u32,
    /// Index of the node after all descendants of this one, where the walk goes on after a miss.
    pub skip: u32,
}

impl<S: Scalar> Node<S> {
    /// Returns whether a ray may meet an object of the run nearer than `t_max`.
    fn is_met(&self, ray: &Ray<S>, t_max: S) -> bool {
        let displacement = self.center - ray.origin;
        let b = displacement.dot(ray.direction);
        let radius = self.radius.padded(b);
        if b < -radius || (b > S::ZERO && b - radius >= t_max) {
            return false;
        }
        displacement.reject(ray.direction, b).norm_squared() <= radius.square()
    }
}

/// A bounding volume hierarchy over the finite objects of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Bvh<'a, S: Scalar> {
    /// Nodes in preorder, the root first.
    pub nodes: &'a [Node<S>],
    /// Every finite object of the scene once; the nodes' runs are runs of this list. Where it is empty, they are runs of the
    /// scene's list of spheres, and the objects of the other lists are tested one after the other.
    pub order: &'a [Object],
}

impl<S: Scalar> Accelerator<S> for Bvh<'_, S> {
    type Memory = ();
    const IN_ORDER: bool = false;

    fn candidates<N: Needs>(
        &self,
        scene: &Scene<'_, S>,
        ray: &Ray<S>,
        visit: &mut impl Visit<S>,
    ) -> ControlFlow<()> {
        let over_spheres = self.order.is_empty();
        scene.each::<N>(&mut Rest { over_spheres, visit })?;
        let mut number = 0;
        while let Some(node) = self.nodes.get(number) {
            let (skip, run) = (index(node.skip), index(node.first)..index(node.end));
            if !node.is_met(ray, visit.t_max()) {
                number = skip;
                continue;
            }
            number += 1;
            if skip != number {
                continue;
            }
            if !over_spheres {
                let run = self.order.get(run).unwrap_or_default();
                run.iter().try_for_each(|&object| scene.one::<N>(object, visit))?;
            } else if N::SPHERES {
                visit.run(Object::Sphere(node.first), scene.spheres.get(run).unwrap_or_default())?;
            }
        }
        ControlFlow::Continue(())
    }

    /// Whether nodes contain their objects is checked only where [`Bvh::order`] is empty. Otherwise it is up to the builder: an
    /// object outside its node may be missing from the picture.
    fn check(&self, scene: &Scene<'_, S>) -> Result<(), Error> {
        let held = if self.order.is_empty() { scene.spheres.len() } else { self.order.len() };
        let (largest, mut covered) = (S::FAR.scale(S::Unit::ratio(1, 2)), 0);
        for (number, node) in self.nodes.iter().enumerate() {
            let (first, end, skip) = (index(node.first), index(node.end), index(node.skip));
            let leads_on = skip > number && skip <= self.nodes.len();
            let has_size = node.radius > S::ZERO && node.radius <= largest;
            // Leaves follow each other through the run; what is above them begins where the next leaf does.
            let has_run = first == covered && first < end && end <= held;
            if !(leads_on && has_size && has_run && self.contains_spheres(node, scene)) {
                return Err(Error::Hierarchy(number));
            }
            if skip == number + 1 {
                covered = end;
            }
        }
        let names_each_once = self.order.is_empty() || {
            let mut finite = Names::default();
            let _ = scene.each::<Everything>(&mut finite);
            let mut named = Names::default();
            self.order.iter().for_each(|&object| named.add(object));
            named == finite
        };
        let is_whole = covered == held && names_each_once;
        if is_whole { Ok(()) } else { Err(Error::Hierarchy(self.nodes.len().saturating_sub(1))) }
    }

    fn places(&self, see: impl FnMut(Vec3<S>)) {
        self.nodes.iter().map(|node| node.center).for_each(see);
    }
}

impl<S: Scalar> Bvh<'_, S> {
    /// Returns whether a node contains its run of spheres; true where [`Bvh::order`] is not empty.
    fn contains_spheres(&self, node: &Node<S>, scene: &Scene<'_, S>) -> bool {
        let run = scene.spheres.get(index(node.first)..index(node.end));
        let contains = |sphere: &Sphere<S>| {
            let room = node.radius - sphere.radius;
            room >= S::ZERO && (sphere.center - node.center).norm_squared() <= room.square()
        };
        !self.order.is_empty() || run.is_some_and(|run| run.iter().all(contains))
    }
}

/// A visitor that passes on the lists whose objects are in no node: those of infinite objects, or all but the spheres.
struct Rest<'a, V> {
    over_spheres: bool,
    visit: &'a mut V,
}

impl<S: Scalar, V: Visit<S>> Visit<S> for Rest<'_, V> {
    fn run<P: Primitive<S>>(&mut self, first: Object, run: &[P]) -> ControlFlow<()> {
        let in_nodes = if self.over_spheres { matches!(first, Object::Sphere(_)) } else { P::IS_FINITE };
        if in_nodes { ControlFlow::Continue(()) } else { self.visit.run(first, run) }
    }
}

/// The number of some objects and the sum of their hashes. Two sets that agree in both are equal but for one case in 2^64; so
/// they are compared without memory for a list.
#[derive(Default, PartialEq)]
struct Names {
    count: usize,
    sum: u64,
}

impl Names {
    fn add(&mut self, object: Object) {
        let mut hash = Fnv(0xcbf2_9ce4_8422_2325);
        object.hash(&mut hash);
        self.count += 1;
        self.sum = self.sum.wrapping_add(hash.finish());
    }
}

impl<S: Scalar> Visit<S> for Names {
    fn run<P: Primitive<S>>(&mut self, first: Object, run: &[P]) -> ControlFlow<()> {
        if P::IS_FINITE {
            (0..).zip(run).for_each(|(by, _)| self.add(first.after(by)));
        }
        ControlFlow::Continue(())
    }
}

/// The hash FNV-1a of 64 bits (G. Fowler, L. Noll and K. Vo, 1991).
struct Fnv(u64);

impl Hasher for Fnv {
    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    fn finish(&self) -> u64 {
        self.0
    }
}
