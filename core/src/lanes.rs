//! The search of a machine whose processor has lanes: a bounding volume hierarchy, made ahead and borrowed, that tests four
//! boxes at once, and in its leaves four bounding spheres.
//!
//! All of it is in `f32` whatever the picture is traced in, and all of it only says what a ray cannot meet. What is left is
//! asked in the picture's own format, so that a picture in fixed point keeps its bytes: each box and each sphere is larger
//! by a [margin](Scalar::coarse_margin) than the object in it, that object's own test and this one can be wrong together.
//!
//! A node holds the boxes of its four children side by side (I. Wald, C. Benthin and S. Boulos, "Getting Rid of Packets",
//! IEEE Symposium on Interactive Ray Tracing, 2008). The search goes on in the nearest box that the ray enters and keeps
//! the others on a stack of fixed size. Firmware goes by [`bvh`](crate::bvh) or [`hierarchy`](crate::hierarchy) instead.
#![allow(clippy::float_arithmetic)] // machines without lanes have none of it

use glam::Vec4;
use heapless::Vec;

use crate::bvh::{Bits, Child, Item, MAX_DEPTH, first_wrong};
use crate::ray::Ray;
use crate::scalar::{Scalar, Unit};
use crate::vector::Vector;

/// Whether the machine that this is compiled for has lanes.
pub const LANES: bool = cfg!(any(target_feature = "sse2", target_feature = "neon", target_feature = "simd128"));

/// Coordinates are below this, so that no square overflows.
pub const LARGEST: f32 = 1e17;

/// Three of four children wait on each level.
const STACK: usize = 3 * MAX_DEPTH + 1;
/// A component of a direction counts as this at least: its reciprocal is a number, and a ray does not drift off by more than
/// a margin.
const LEAST: f32 = 1e-12;

/// A fixed-point number of an LSB of 2^-`fraction`, rounded.
#[inline]
#[allow(clippy::cast_precision_loss)] // to the nearest
pub(crate) fn coarse(bits: i32, fraction: u32) -> f32 {
    bits as f32 * f32::from_bits((127 - fraction) << 23)
}

/// [`Scalar::coarse_margin`] of a format whose own margin is `own`: what is rounded to an `f32` is wrong by half an EPSILON of
/// `far`, and a foot point in `f32` by 14 EPSILON of its distance, which is below 3.5 `far`. Twice as much is added.
#[inline]
pub(crate) fn margin(far: f32, own: f32) -> f32 {
    far * (100.0 * f32::EPSILON) + own
}

/// A node: four boxes.
#[derive(Clone, Copy, Debug)]
pub struct Boxes {
    /// For x, y and z: the least of each box, and the greatest. Where there is no child, the least is infinite and the
    /// greatest its negative.
    pub planes: [[Vec4; 2]; 3],
    /// What is in them.
    pub children: [Child; 4],
}

impl Boxes {
    /// No boxes.
    pub const EMPTY: Self =
        Self { planes: [[Vec4::INFINITY, Vec4::NEG_INFINITY]; 3], children: [Child::EMPTY; 4] };
}

/// Four bounding spheres.
#[derive(Clone, Copy, Debug)]
pub struct Pack {
    /// x, y and z of their centres.
    pub center: [Vec4; 3],
    /// Radii; of none it is negative and infinite.
    pub radius: Vec4,
    /// What is in them.
    pub items: [Item; 4],
}

impl Pack {
    /// No spheres.
    pub const EMPTY: Self =
        Self { center: [Vec4::ZERO; 3], radius: Vec4::NEG_INFINITY, items: [Item::Sphere(u32::MAX); 4] };
}

/// A hierarchy over all finite objects and all visible lamps; without packs it is none.
///
/// Admission sees that it leads on, ends and names each object once, not that each box contains its objects: that is the
/// builder's promise. Where one is too small, something is not seen; nothing else happens.
#[derive(Clone, Copy, Debug)]
pub struct Lanes<'a> {
    /// Nodes, the root first. Of few objects there are none: all packs are tried.
    pub nodes: &'a [Boxes],
    /// What the leaves hold: runs of it.
    pub packs: &'a [Pack],
    /// The largest size of a coordinate.
    pub size: f32,
}

/// A ray in `f32`, each number four times.
struct Probe {
    origin: [Vec4; 3],
    direction: [Vec4; 3],
    margin: f32,
}

/// The same made ready for many boxes.
struct Slabs {
    /// For x, y and z: from where the way is to the plane that it enters by, and to the one that it leaves by: where it
    /// starts, moved by the margin.
    starts: [[Vec4; 2]; 3],
    /// The reciprocals of its direction.
    inverse: [Vec4; 3],
    /// Which plane it enters by: 0 is the least.
    entry: [usize; 3],
}

impl Probe {
    /// Nothing for a ray from so far away that its test could overflow.
    #[inline(always)]
    fn new<S: Scalar>(ray: &Ray<S>, size: f32) -> Option<Self> {
        let (o, d) = (ray.origin, ray.direction);
        let origin = [o.x(), o.y(), o.z()].map(Scalar::coarse);
        let far = origin.iter().fold(size, |most, c| if c.abs() > most { c.abs() } else { most });
        (far <= LARGEST).then(|| Self {
            origin: origin.map(Vec4::splat),
            direction: [d.x(), d.y(), d.z()].map(|d| Vec4::splat(d.coarse())),
            margin: S::coarse_margin(far),
        })
    }

    #[inline(always)]
    fn slabs(&self) -> Slabs {
        let margin = Vec4::splat(self.margin);
        // Upwards it enters by the least plane, which is moved down by starting higher.
        let axis = |o: Vec4, d: Vec4| {
            let size = if d.x.abs() < LEAST { LEAST } else { d.x.abs() };
            if d.x < 0.0 {
                ([o - margin, o + margin], Vec4::splat(-1.0 / size), 1)
            } else {
                ([o + margin, o - margin], Vec4::splat(1.0 / size), 0)
            }
        };
        let ([ox, oy, oz], [dx, dy, dz]) = (self.origin, self.direction);
        let [x, y, z] = [axis(ox, dx), axis(oy, dy), axis(oz, dz)];
        Slabs { starts: [x.0, y.0, z.0], inverse: [x.1, y.1, z.1], entry: [x.2, y.2, z.2] }
    }

    /// A bit for each sphere that the ray meets ahead and before `t_max`, the lowest for the first.
    #[inline(always)]
    fn meet(&self, pack: &Pack, t_max: f32) -> u32 {
        let ([ox, oy, oz], [dx, dy, dz], [cx, cy, cz]) = (self.origin, self.direction, pack.center);
        let (x, y, z) = (cx - ox, cy - oy, cz - oz);
        let b = x * dx + y * dy + z * dz;
        let (x, y, z) = (x - dx * b, y - dy * b, z - dz * b);
        let r = pack.radius + Vec4::splat(self.margin);
        let is_across = (x * x + y * y + z * z).cmple(r * r);
        (is_across & (b + r).cmpgt(Vec4::ZERO) & (b - r).cmplt(Vec4::splat(t_max))).bitmask()
    }
}

impl Probe {
    /// Calls `visit` with what the ray may meet of some packs, as [`Lanes::nearest`] does.
    #[inline(always)]
    fn visit_nearest<S: Scalar>(
        &self,
        packs: &[Pack],
        t_max: &mut f32,
        visit: &mut impl FnMut(Item) -> Option<S>,
    ) {
        for pack in packs {
            for k in Bits(self.meet(pack, *t_max)) {
                if let Some(t) = pack.items.get(k).and_then(|item| visit(*item)) {
                    *t_max = t.coarse() + self.margin;
                }
            }
        }
    }

    /// Whether `visit` says yes to all that the ray may meet of some packs.
    #[inline(always)]
    fn visit_all(&self, packs: &[Pack], t_max: f32, visit: &mut impl FnMut(Item) -> bool) -> bool {
        for pack in packs {
            for k in Bits(self.meet(pack, t_max)) {
                if !pack.items.get(k).is_none_or(|item| visit(*item)) {
                    return false;
                }
            }
        }
        true
    }
}

impl Slabs {
    /// Where the ray enters each box, 0 if it starts within; and a bit for each that it enters before `t_max`, the lowest
    /// for the first.
    #[inline(always)]
    #[allow(clippy::indexing_slicing, reason = "every index is below the length")]
    fn enter(&self, node: &Boxes, t_max: f32) -> (Vec4, u32) {
        let (mut near, mut far) = (Vec4::ZERO, Vec4::splat(t_max));
        for axis in 0..3 {
            let ([start, end], inverse, entry) = (self.starts[axis], self.inverse[axis], self.entry[axis] & 1);
            near = ((node.planes[axis][entry] - start) * inverse).max(near);
            far = ((node.planes[axis][entry ^ 1] - end) * inverse).min(far);
        }
        (near, near.cmple(far).bitmask())
    }
}

impl Lanes<'_> {
    /// No hierarchy.
    pub const NONE: Self = Self { nodes: &[], packs: &[], size: 0.0 };

    /// Calls `visit` with the items that the ray may meet nearer than `t_max`, near boxes first. `visit` says how near that is
    /// which it has met, where it is nearer than what was before.
    #[inline]
    pub(crate) fn nearest<S: Scalar>(
        &self,
        ray: &Ray<S>,
        t_max: S,
        mut visit: impl FnMut(Item) -> Option<S>,
    ) {
        let Some(probe) = Probe::new(ray, self.size) else {
            return self.each(|item| {
                visit(item);
                true
            });
        };
        let mut t_max = t_max.coarse() + probe.margin;
        if self.nodes.is_empty() {
            return probe.visit_nearest(self.packs, &mut t_max, &mut visit);
        }
        let slabs = probe.slabs();
        let mut waiting = Vec::<(Child, f32), STACK>::new();
        let mut next = Some(Child::node(0));
        loop {
            // The nearest child goes on at once.
            while let Some(child) = next {
                next = None;
                let Some(number) = child.number() else {
                    probe.visit_nearest(self.run(child), &mut t_max, &mut visit);
                    break;
                };
                let Some(node) = self.nodes.get(number) else { return };
                let (near, mask) = slabs.enter(node, t_max);
                let near = near.to_array();
                let mut best = 0.0;
                for k in Bits(mask) {
                    let (Some(&child), Some(&near)) = (node.children.get(k), near.get(k)) else { break };
                    // There is room: the hierarchy is not deeper than the stack.
                    match next {
                        None => (next, best) = (Some(child), near),
                        Some(before) if near < best => {
                            let _ = waiting.push((before, best));
                            (next, best) = (Some(child), near);
                        }
                        Some(_) => {
                            let _ = waiting.push((child, near));
                        }
                    }
                }
            }
            next = loop {
                match waiting.pop() {
                    Some((child, near)) if near <= t_max => break Some(child),
                    Some(_) => {}
                    None => return,
                }
            };
        }
    }

    /// Whether `visit` says yes to all items that the ray may meet nearer than `t_max`, as far as it is asked.
    #[inline]
    pub(crate) fn all<S: Scalar>(
        &self,
        ray: &Ray<S>,
        t_max: S,
        mut visit: impl FnMut(Item) -> bool,
    ) -> bool {
        let Some(probe) = Probe::new(ray, self.size) else {
            let mut all = true;
            self.each(|item| {
                all = visit(item);
                all
            });
            return all;
        };
        let t_max = t_max.coarse() + probe.margin;
        if self.nodes.is_empty() {
            return probe.visit_all(self.packs, t_max, &mut visit);
        }
        let slabs = probe.slabs();
        let mut waiting = Vec::<Child, STACK>::new();
        let mut next = Some(Child::node(0));
        while let Some(child) = next {
            match child.number().and_then(|number| self.nodes.get(number)) {
                None => {
                    if !probe.visit_all(self.run(child), t_max, &mut visit) {
                        return false;
                    }
                }
                Some(node) => {
                    let (_, mask) = slabs.enter(node, t_max);
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

    /// Calls `visit` with all items, as long as it says yes.
    #[cold]
    fn each(&self, mut visit: impl FnMut(Item) -> bool) {
        let _ = self.packs.iter().flat_map(|pack| pack.items).all(&mut visit);
    }

    /// The first node that is wrong; without nodes it is 0 where something is missing. `counts` are the numbers of spheres,
    /// ellipsoids, cones, triangles and visible lamps, and `lamps` that of all lamps.
    pub(crate) fn first_wrong(&self, counts: [usize; 5], lamps: usize) -> Option<usize> {
        if self.packs.is_empty() {
            return (!self.nodes.is_empty()).then_some(0);
        }
        let [spheres, ellipsoids, cones, triangles, _] = counts;
        let there = |item: &Item| item.is_in([spheres, ellipsoids, cones, triangles, lamps]);
        if self.packs.iter().flat_map(|pack| pack.items).filter(there).count() != counts.iter().sum::<usize>() {
            return Some(0);
        }
        if self.nodes.is_empty() {
            return None;
        }
        first_wrong(|number| Some(self.nodes.get(number)?.children), self.nodes.len(), self.packs.len())
    }

    fn run(&self, child: Child) -> &[Pack] {
        let (first, count) = child.run();
        self.packs.get(first..first + count).unwrap_or(&[])
    }
}
