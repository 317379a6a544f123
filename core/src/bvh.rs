//! A bounding volume hierarchy of boxes over all finite objects of a scene, made ahead and borrowed.
//!
//! A node holds the boxes of its four children (I. Wald, C. Benthin and S. Boulos, "Getting Rid of Packets", IEEE Symposium
//! on Interactive Ray Tracing, 2008). The search goes on in the nearest box that the ray enters and keeps the others on a
//! stack of fixed size. It is for machines without lanes; those that have some go by [`lanes`](crate::lanes).
//!
//! A box is never missed that holds something the ray meets: each plane is moved outwards by [`Scalar::margin`], more than
//! the object, its test and this one can be wrong together.

use core::fmt;
use core::num::NonZeroU32;

use heapless::Vec;

use crate::ray::Ray;
use crate::scalar::{Scalar, Unit};
use crate::vector::Vector;

/// Levels of nodes that a hierarchy may have.
pub const MAX_DEPTH: usize = 21;
/// Three of four children wait on each level.
const STACK: usize = 3 * MAX_DEPTH + 1;

/// A finite object: which, in the list of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Item {
    /// A sphere.
    Sphere(u32),
    /// An ellipsoid.
    Ellipsoid(u32),
    /// A cone.
    Cone(u32),
    /// A triangle.
    Triangle(u32),
    /// A visible lamp, which [`lanes`](crate::lanes) hold too.
    Lamp(u32),
}

/// What is in one of a node's boxes: nothing, another node, which comes later in the list, or a run of the items.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Child(u32);

/// The same to be looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Empty,
    Node(u32),
    Leaf(usize, usize),
}

impl Child {
    /// Nothing.
    pub const EMPTY: Self = Self(u32::MAX);
    /// The most items in a leaf.
    pub const MAX_COUNT: u32 = 14;
    /// The most items in all.
    pub const MAX_ITEMS: u32 = 1 << Self::FIRST_BITS;
    const FIRST_BITS: u32 = 27;
    const LEAF: u32 = 1 << 31;

    /// A node by its number, below 2^31; nothing where it is not.
    pub const fn node(number: u32) -> Self {
        if number < Self::LEAF { Self(number) } else { Self::EMPTY }
    }

    /// A run of `count` items from the item `first` on; nothing where there are too many.
    pub const fn leaf(first: u32, count: u32) -> Self {
        if first >= Self::MAX_ITEMS || count > Self::MAX_COUNT {
            return Self::EMPTY;
        }
        Self(Self::LEAF | count << Self::FIRST_BITS | first)
    }

    /// The node's number; nothing of a leaf, or where nothing is.
    #[inline]
    pub(crate) fn number(self) -> Option<usize> {
        (self.0 & Self::LEAF == 0).then(|| index(self.0))
    }

    /// The first of a leaf's run, and how many there are; where nothing is, a run beyond all lists.
    #[inline]
    pub(crate) fn run(self) -> (usize, usize) {
        (index(self.0 & (Self::MAX_ITEMS - 1)), index(self.0 >> Self::FIRST_BITS & 15))
    }

    fn kind(self) -> Kind {
        if self.0 & Self::LEAF == 0 {
            Kind::Node(self.0)
        } else if self == Self::EMPTY {
            Kind::Empty
        } else {
            let (first, count) = self.run();
            Kind::Leaf(first, count)
        }
    }
}

/// As an expression.
impl fmt::Debug for Child {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.kind() {
            Kind::Empty => f.write_str("Child::EMPTY"),
            Kind::Node(number) => write!(f, "Child::node({number})"),
            Kind::Leaf(first, count) => write!(f, "Child::leaf({first}, {count})"),
        }
    }
}

/// A node: four boxes.
#[derive(Clone, Copy, Debug)]
pub struct Boxes<S: Scalar> {
    /// For x, y and z: the least of each box, and the greatest.
    pub planes: [[[S; 4]; 2]; 3],
    /// What is in them.
    pub children: [Child; 4],
}

/// A hierarchy; without nodes it is none.
///
/// Admission sees that it leads on, ends and holds each index that it names, not that each box contains its objects: that is
/// the builder's promise. Where a box is too small, something is not seen; nothing else happens.
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
    /// For x, y and z: from where the way is to the plane that it enters by, and to the one that it leaves by: where it
    /// starts, moved by the margin.
    pub starts: [[S; 2]; 3],
    /// The reciprocals of its direction's size.
    pub inverse: [<S::Unit as Unit>::Inverse; 3],
    /// Which plane it enters by: 0 is the least.
    pub entry: [usize; 3],
}

impl<S: Scalar> Slabs<S> {
    /// A ray, for boxes whose coordinates are at most `size`.
    fn new(ray: &Ray<S>, size: S) -> Self {
        let (o, d) = (ray.origin, ray.direction);
        let directions = [d.x(), d.y(), d.z()];
        let entry = directions.map(|c| usize::from(c < S::Unit::ZERO));
        let origin = [o.x(), o.y(), o.z()];
        let away = origin.map(|c| if c < S::ZERO { -c } else { c });
        let far = away.into_iter().fold(size, |most, c| if c > most { c } else { most });
        let margin = far.margin();
        let mut starts = origin.map(|c| c.either_side(margin));
        for (starts, entry) in starts.iter_mut().zip(entry) {
            // Upwards it enters by the least plane, which is moved down by starting higher.
            if entry == 0 {
                starts.reverse();
            }
        }
        Self { starts, inverse: directions.map(Unit::reciprocal), entry }
    }
}

impl<S: Scalar> Boxes<S> {
    /// Where the ray enters each box, 0 if it starts within; and a bit for each that it enters before `t_max`, the lowest
    /// for the first.
    #[inline]
    pub(crate) fn enter(&self, slabs: &Slabs<S>, t_max: S) -> ([S; 4], u32) {
        let (mut near, mut far) = ([S::ZERO; 4], [t_max; 4]);
        for (((planes, starts), inverse), entry) in
            self.planes.iter().zip(slabs.starts).zip(slabs.inverse).zip(slabs.entry)
        {
            let ([low, high], [start, end]) = (planes, starts);
            for (((&low, &high), near), far) in low.iter().zip(high).zip(&mut near).zip(&mut far) {
                let (before, behind) =
                    if entry == 0 { (low - start, high - end) } else { (start - high, end - low) };
                let (before, behind) = (before.stretch(inverse), behind.stretch(inverse));
                *near = if before > *near { before } else { *near };
                *far = if behind < *far { behind } else { *far };
            }
        }
        let entered = near.iter().zip(&far).zip(self.children).enumerate();
        let mask = entered.fold(0, |mask, (k, ((near, far), child))| {
            mask | u32::from(near <= far && child != Child::EMPTY) << k
        });
        (near, mask)
    }
}

impl<'a, S: Scalar> Bvh<'a, S> {
    /// No hierarchy.
    pub const NONE: Self = Self { nodes: &[], items: &[], size: S::ZERO };

    /// Calls `visit` with the items that the ray may meet nearer than `t_max`, near boxes first. `visit` says how near that is
    /// which it has met, where nothing nearer was before; that shrinks `t_max`.
    #[inline]
    pub(crate) fn nearest(&self, ray: &Ray<S>, t_max: &mut S, mut visit: impl FnMut(Item) -> Option<S>) {
        let slabs = Slabs::new(ray, self.size);
        let mut waiting = Vec::<(Child, S), STACK>::new();
        let mut child = Child::node(0);
        loop {
            match child.kind() {
                Kind::Empty => {}
                Kind::Leaf(first, count) => {
                    for &item in self.run(first, count) {
                        if let Some(t) = visit(item) {
                            *t_max = t;
                        }
                    }
                }
                Kind::Node(number) => {
                    let Some(node) = self.nodes.get(index(number)) else { return };
                    let (near, mask) = node.enter(&slabs, *t_max);
                    let base = waiting.len();
                    for k in Bits(mask) {
                        if let (Some(&child), Some(&near)) = (node.children.get(k), near.get(k)) {
                            // There is room: the hierarchy is not deeper than the stack.
                            let _ = waiting.push((child, near));
                            if waiting.len() > base + 1 {
                                sort_last(&mut waiting, base);
                            }
                        }
                    }
                }
            }
            child = loop {
                match waiting.pop() {
                    Some((child, near)) if near < *t_max => break child,
                    Some(_) => {}
                    None => return,
                }
            };
        }
    }

    /// Whether `visit` says yes to all items that the ray may meet nearer than `t_max`, as far as it is asked.
    #[inline]
    pub(crate) fn all(&self, ray: &Ray<S>, t_max: S, mut visit: impl FnMut(Item) -> bool) -> bool {
        let slabs = Slabs::new(ray, self.size);
        let mut waiting = Vec::<Child, STACK>::new();
        let mut next = Some(Child::node(0));
        while let Some(child) = next {
            match child.kind() {
                Kind::Empty => {}
                Kind::Leaf(first, count) => {
                    if !self.run(first, count).iter().all(|&item| visit(item)) {
                        return false;
                    }
                }
                Kind::Node(number) => {
                    let Some(node) = self.nodes.get(index(number)) else { return true };
                    let (_, mask) = node.enter(&slabs, t_max);
                    for k in Bits(mask) {
                        if let Some(&child) = node.children.get(k) {
                            let _ = waiting.push(child);
                        }
                    }
                }
            }
            next = waiting.pop();
        }
        true
    }

    fn run(&self, first: usize, count: usize) -> &'a [Item] {
        self.items.get(first..first + count).unwrap_or(&[])
    }

    /// The first node that is wrong. `counts` are the numbers of spheres, ellipsoids, cones and triangles.
    pub(crate) fn first_wrong(&self, counts: [usize; 4]) -> Option<usize> {
        if self.nodes.is_empty() {
            return None;
        }
        let [spheres, ellipsoids, cones, triangles] = counts;
        let all = self.items.len() == counts.iter().sum::<usize>();
        if !all || !self.items.iter().all(|item| item.is_in([spheres, ellipsoids, cones, triangles, 0])) {
            return Some(0);
        }
        first_wrong(|number| Some(self.nodes.get(number)?.children), self.nodes.len(), self.items.len())
    }
}

impl Item {
    /// No object.
    pub(crate) const NONE: Self = Self::Lamp(u32::MAX);

    /// Whether there is such a thing among so many spheres, ellipsoids, cones, triangles and lamps.
    pub(crate) fn is_in(self, [spheres, ellipsoids, cones, triangles, lamps]: [usize; 5]) -> bool {
        match self {
            Self::Sphere(i) => index(i) < spheres,
            Self::Ellipsoid(i) => index(i) < ellipsoids,
            Self::Cone(i) => index(i) < cones,
            Self::Triangle(i) => index(i) < triangles,
            Self::Lamp(i) => index(i) < lamps,
        }
    }
}

/// The first of `nodes` nodes that is wrong: that leads back or out of the list, or too deep, or whose leaves do not follow
/// each other through what `held` counts.
pub(crate) fn first_wrong(
    children: impl Fn(usize) -> Option<[Child; 4]>,
    nodes: usize,
    held: usize,
) -> Option<usize> {
    // In the order of the list each node must be asked for once, and after it was named.
    let mut waiting = Vec::<(u32, usize), STACK>::new();
    let _ = waiting.push((0, 1));
    let (mut expected, mut covered) = (0, 0);
    while let Some((number, depth)) = waiting.pop() {
        let Some(children) = children(index(number)) else { return Some(index(number)) };
        if number != expected || depth > MAX_DEPTH {
            return Some(index(number));
        }
        expected += 1;
        for child in children {
            if let Kind::Leaf(first, count) = child.kind() {
                if first != covered || count == 0 || first + count > held {
                    return Some(index(number));
                }
                covered += count;
            }
        }
        for child in children.into_iter().rev() {
            if let Kind::Node(below) = child.kind() {
                let _ = waiting.push((below, depth + 1));
            }
        }
    }
    (covered != held || index(expected) != nodes).then_some(0)
}

/// The numbers of the bits that are 1, of the lowest four.
pub(crate) struct Bits(pub(crate) u32);

impl Iterator for Bits {
    type Item = usize;

    #[inline]
    fn next(&mut self) -> Option<usize> {
        let lowest = NonZeroU32::new(self.0)?.trailing_zeros();
        self.0 &= self.0.wrapping_sub(1);
        Some(index(lowest & 3))
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
pub(crate) fn index(number: u32) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}
