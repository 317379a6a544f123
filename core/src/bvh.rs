//! A bounding volume hierarchy of boxes over all finite objects of a scene, made ahead and borrowed.
//!
//! A node holds the boxes of its four children side by side (I. Wald, C. Benthin and S. Boulos, "Getting Rid of Packets",
//! IEEE Symposium on Interactive Ray Tracing, 2008), so that a machine with lanes tests them at once. The search goes on
//! in the nearest box that the ray enters and keeps the others on a stack of fixed size.
//!
//! A box is never missed that holds something the ray meets: each plane is moved outwards by [`Scalar::margin`], more than
//! the object, its test and this one can be wrong together.

use heapless::Vec;

use crate::ray::Ray;
use crate::scalar::{Scalar, Unit};
use crate::vector::Vector;

/// Levels of nodes that a hierarchy may have.
pub const MAX_DEPTH: usize = 21;
/// Three of four children wait on each level.
const STACK: usize = 3 * MAX_DEPTH + 1;

/// A finite object: which, in the list of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item {
    /// A sphere.
    Sphere(u32),
    /// An ellipsoid.
    Ellipsoid(u32),
    /// A cone.
    Cone(u32),
    /// A triangle.
    Triangle(u32),
}

/// What is in one of a node's boxes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Child {
    /// Nothing.
    Empty,
    /// Another node, which comes later in the list.
    Node(u32),
    /// A run of the items: the first, and how many.
    Leaf(u32, u16),
}

/// A node: four boxes.
#[derive(Clone, Copy, Debug)]
pub struct Boxes<S: Scalar> {
    /// Least x of the boxes, least y, least z.
    pub low: [[S; 4]; 3],
    /// Greatest x of the boxes, greatest y, greatest z.
    pub high: [[S; 4]; 3],
    /// What is in them.
    pub children: [Child; 4],
}

/// A hierarchy; without nodes it is none.
#[derive(Clone, Copy, Debug)]
pub struct Bvh<'a, S: Scalar> {
    /// Nodes, the root first.
    pub nodes: &'a [Boxes<S>],
    /// What the leaves hold: each finite object of the scene once.
    pub items: &'a [Item],
    /// The largest size of a box's coordinate.
    pub size: S,
}

/// A ray made ready for many boxes.
#[derive(Clone, Copy, Debug)]
pub struct Slabs<S: Scalar> {
    /// Where it starts.
    pub origin: [S; 3],
    /// The reciprocals of its direction's sizes.
    pub inverse: [<S::Unit as Unit>::Inverse; 3],
    /// Whether it goes down.
    pub backwards: [bool; 3],
    /// How far the planes are moved outwards.
    pub margin: S,
}

impl<S: Scalar> Slabs<S> {
    /// A ray, for boxes whose coordinates are at most `size`.
    fn new(ray: &Ray<S>, size: S) -> Self {
        let (o, d) = (ray.origin, ray.direction);
        let directions = [d.x(), d.y(), d.z()];
        let backwards = directions.map(|c| c < S::Unit::ZERO);
        let inverse = directions.map(|c| if c < S::Unit::ZERO { -c } else { c }.reciprocal());
        let origin = [o.x(), o.y(), o.z()];
        let away = origin.map(|c| if c < S::ZERO { -c } else { c });
        let far = away.into_iter().fold(size, |most, c| if c > most { c } else { most });
        Self { origin, inverse, backwards, margin: far.margin() }
    }
}

impl<S: Scalar> Boxes<S> {
    /// Where the ray enters each box, 0 if it starts within; and whether it does so before `t_max`.
    #[inline]
    pub(crate) fn enter(&self, slabs: &Slabs<S>, t_max: S) -> ([S; 4], [bool; 4]) {
        let (mut near, mut far) = ([S::ZERO; 4], [t_max; 4]);
        let axes = self.low.iter().zip(&self.high).zip(slabs.origin).zip(slabs.inverse).zip(slabs.backwards);
        for ((((low, high), origin), inverse), backwards) in axes {
            let planes = low.iter().zip(high).zip(near.iter_mut().zip(&mut far));
            for ((&low, &high), (near, far)) in planes {
                let (before, behind) =
                    if backwards { (origin - high, origin - low) } else { (low - origin, high - origin) };
                let before = (before - slabs.margin).stretch(inverse);
                let behind = (behind + slabs.margin).stretch(inverse);
                *near = if before > *near { before } else { *near };
                *far = if behind < *far { behind } else { *far };
            }
        }
        let mut enters = [false; 4];
        for (enters, (near, far)) in enters.iter_mut().zip(near.iter().zip(&far)) {
            *enters = near <= far;
        }
        (near, enters)
    }
}

impl<'a, S: Scalar> Bvh<'a, S> {
    /// No hierarchy.
    pub const NONE: Self = Self { nodes: &[], items: &[], size: S::ZERO };

    /// Calls `visit` with the items that the ray may meet nearer than `t_max`, which `visit` may shrink; near boxes first.
    #[inline]
    pub(crate) fn nearest(&self, ray: &Ray<S>, t_max: &mut S, mut visit: impl FnMut(Item, &mut S)) {
        let slabs = Slabs::new(ray, self.size);
        let mut waiting = Vec::<(Child, S), STACK>::new();
        let mut next = Some((Child::Node(0), S::ZERO));
        while let Some((child, entered)) = next {
            if entered < *t_max {
                match child {
                    Child::Empty => {}
                    Child::Leaf(first, count) => {
                        for &item in self.run(first, count) {
                            visit(item, t_max);
                        }
                    }
                    Child::Node(number) => {
                        let Some(node) = self.nodes.get(index(number)) else { return };
                        let (near, enters) = S::enter(node, &slabs, *t_max);
                        let base = waiting.len();
                        for ((child, near), enters) in node.children.into_iter().zip(near).zip(enters) {
                            if enters {
                                // There is room: the hierarchy is not deeper than the stack.
                                let _ = waiting.push((child, near));
                                sort_last(&mut waiting, base);
                            }
                        }
                    }
                }
            }
            next = waiting.pop();
        }
    }

    /// Whether `visit` says no to an item that the ray may meet nearer than `t_max`.
    #[inline]
    pub(crate) fn all(&self, ray: &Ray<S>, t_max: S, mut visit: impl FnMut(Item) -> bool) -> bool {
        let slabs = Slabs::new(ray, self.size);
        let mut waiting = Vec::<Child, STACK>::new();
        let mut next = Some(Child::Node(0));
        while let Some(child) = next {
            match child {
                Child::Empty => {}
                Child::Leaf(first, count) => {
                    if !self.run(first, count).iter().all(|&item| visit(item)) {
                        return false;
                    }
                }
                Child::Node(number) => {
                    let Some(node) = self.nodes.get(index(number)) else { return true };
                    let (_, enters) = S::enter(node, &slabs, t_max);
                    for (child, enters) in node.children.into_iter().zip(enters) {
                        if enters {
                            let _ = waiting.push(child);
                        }
                    }
                }
            }
            next = waiting.pop();
        }
        true
    }

    fn run(&self, first: u32, count: u16) -> &'a [Item] {
        self.items.get(index(first)..index(first) + usize::from(count)).unwrap_or(&[])
    }

    /// The first node that is wrong: that leads back or out of the list, or too deep, or whose leaves do not follow each
    /// other through the items. `counts` are the numbers of spheres, ellipsoids, cones and triangles.
    pub(crate) fn first_wrong(&self, counts: [usize; 4]) -> Option<usize> {
        if self.nodes.is_empty() {
            return None;
        }
        let [spheres, ellipsoids, cones, triangles] = counts;
        let is_there = |item: &Item| match *item {
            Item::Sphere(i) => index(i) < spheres,
            Item::Ellipsoid(i) => index(i) < ellipsoids,
            Item::Cone(i) => index(i) < cones,
            Item::Triangle(i) => index(i) < triangles,
        };
        if self.items.len() != counts.iter().sum::<usize>() || !self.items.iter().all(is_there) {
            return Some(0);
        }
        // In the order of the list each node must be asked for once, and after it was named.
        let mut waiting = Vec::<(u32, usize), STACK>::new();
        let _ = waiting.push((0, 1));
        let (mut expected, mut covered) = (0, 0);
        while let Some((number, depth)) = waiting.pop() {
            let Some(node) = self.nodes.get(index(number)) else { return Some(index(number)) };
            if number != expected || depth > MAX_DEPTH {
                return Some(index(number));
            }
            expected += 1;
            for child in node.children {
                if let Child::Leaf(first, count) = child {
                    if index(first) != covered || self.run(first, count).is_empty() {
                        return Some(index(number));
                    }
                    covered += usize::from(count);
                }
            }
            for child in node.children.into_iter().rev() {
                if let Child::Node(below) = child {
                    let _ = waiting.push((below, depth + 1));
                }
            }
        }
        (covered != self.items.len() || index(expected) != self.nodes.len()).then_some(0)
    }
}

/// Puts the last of those from `base` on in its place: the nearest is to be last.
#[inline]
fn sort_last<S: Scalar>(waiting: &mut [(Child, S)], base: usize) {
    let Some(mut rest) = waiting.get_mut(base..) else { return };
    while let [before @ .., a, b] = rest {
        if a.1 >= b.1 {
            return;
        }
        core::mem::swap(a, b);
        let end = before.len() + 1;
        rest = rest.get_mut(..end).unwrap_or_default();
    }
}

/// A number of a node or of an item as an index.
fn index(number: u32) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}
