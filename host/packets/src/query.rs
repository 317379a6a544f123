//! The search: a ray against four boxes, four spheres, four cylinders, four triangles at once.

use glam::Vec4;
use heapless::Vec;
use rta_core::ray::Ray;

use crate::four::vector::lane;
use crate::leaf::{Bits, Boxes, Child, Column4, MAX_DEPTH, Sphere4, index};
use crate::number::ToF32;
use crate::packets::Packets;
use crate::rays::{Mask, RayF32, Rays};

/// A component of a direction counts as this at least: its reciprocal is a number, and a ray does not drift off by more than
/// a margin.
pub(crate) const LEAST: f32 = 1e-12;
/// Three of four children wait on each level, and one of two roots.
const STACK: usize = 3 * MAX_DEPTH + 2;
/// Each coordinate four times.
#[inline(always)]
fn splat(v: Vec4) -> [Vec4; 3] {
    [Vec4::splat(v.x), Vec4::splat(v.y), Vec4::splat(v.z)]
}

/// A ray made ready for many leaves, and how far it goes.
pub(crate) struct Query<'a> {
    packets: &'a Packets,
    pub(crate) ray: RayF32,
    rays: Rays,
    pub(crate) t_max: f32,
}

impl<'a> Query<'a> {
    /// For what is nearer than `t_max`.
    #[inline(always)]
    pub(crate) fn new<S: ToF32>(packets: &'a Packets, ray: &Ray<S>, t_max: S) -> Self {
        let ray = RayF32::new(ray, packets.size);
        let t_max = t_max.to_f32() + ray.margin;
        let (origin, direction) = (splat(ray.origin), splat(ray.direction));
        Self {
            packets,
            rays: Rays { origin, direction, margin: ray.margin, t_max: Vec4::splat(t_max) },
            t_max,
            ray,
        }
    }

    /// From now on only what is not farther than `t` is looked for.
    #[inline(always)]
    pub(crate) fn shorten<S: ToF32>(&mut self, t: S) {
        self.t_max = t.to_f32() + self.ray.margin;
        self.rays.t_max = Vec4::splat(self.t_max);
    }

    /// Whether what is not nearer than `near` is beyond its end.
    #[inline(always)]
    pub(crate) fn ends_before(&self, near: f32) -> bool {
        near > self.t_max
    }

    /// Which of a leaf's items the ray may meet ahead and before its end.
    #[inline(always)]
    pub(crate) fn meet<S: ToF32>(&self, leaf: &Sphere4) -> Mask {
        let mut met = self.rays.meet_spheres(leaf.center, leaf.radius);
        if met.mask != 0 && leaf.cones != Sphere4::NO_CONES {
            let cones = self.packets.cones.get(index(leaf.cones));
            met.mask &= cones.map_or(met.mask, |cones| self.rays.meet_cones(leaf.center, cones));
        }
        if met.mask != 0 && leaf.triangles != Sphere4::NO_TRIANGLES {
            if !S::IS_F32 {
                let triangles = self.packets.triangles.get(index(leaf.triangles));
                met.mask &=
                    triangles.map_or(met.mask, |triangles| self.rays.meet_triangles(triangles, met.mask));
            } else if self.ray.margin < f32::INFINITY
                && let Some(triangles) = self.packets.exact.get(index(leaf.triangles))
            {
                self.rays.find_triangles(triangles, &mut met);
            }
        }
        met
    }

    /// The distance of a hit nearer than `t_max`, if item `k` of a leaf is a sphere. Nothing where it has to be asked itself: in
    /// another format, and for a ray from too far away.
    #[inline(always)]
    pub(crate) fn sphere<S: ToF32>(
        &self,
        leaf: &Sphere4,
        met: &Mask,
        k: usize,
        t_max: S,
    ) -> Option<Option<S>> {
        if self.ray.margin == f32::INFINITY {
            return None;
        }
        let lane = |four: &Vec4| four.as_ref().get(k).copied();
        S::of_sphere(lane(&met.along)?, lane(&met.across)?, lane(&leaf.radius)?, t_max)
    }

    /// The distance of a hit nearer than `t_max`, if item `k` of a leaf is a triangle. Nothing where it has to be asked itself, as
    /// [`Query::sphere`].
    #[inline(always)]
    pub(crate) fn triangle<S: ToF32>(&self, met: &Mask, k: usize, t_max: S) -> Option<Option<S>> {
        if met.triangles >> k & 1 == 0 {
            return None;
        }
        S::of_triangle(lane(&met.distance, k), lane(&met.begin, k), t_max)
    }

    /// Which of four vertical cylinders the ray may meet ahead and before its end.
    #[inline(always)]
    pub(crate) fn meet_columns(&self, columns: &Column4) -> Bits {
        Bits(self.rays.meet_columns(columns.center, columns.radius))
    }
}

/// A ray made ready for many boxes.
struct Slabs {
    /// For x, y and z: from where the way is to the plane that it enters by, and to the one that it leaves by: where it
    /// starts, moved by the margin.
    starts: [[Vec4; 2]; 3],
    /// The reciprocals of its direction.
    inverse: [Vec4; 3],
    /// Which plane it enters by: 0 is the least.
    entry: [usize; 3],
}

impl Slabs {
    #[inline(always)]
    fn new(ray: &RayF32) -> Self {
        let (o, d) = (ray.origin, ray.direction);
        // Upwards it enters by the least plane, which is moved down by starting higher.
        let by = Vec4::splat(ray.margin).copysign(d);
        let inverse = d.abs().max(Vec4::splat(LEAST)).copysign(d).recip();
        let (start, end, signs) = (o + by, o - by, d.is_negative_bitmask() as usize);
        let ([ax, ay, az], [bx, by, bz]) = (splat(start), splat(end));
        Self {
            starts: [[ax, bx], [ay, by], [az, bz]],
            inverse: splat(inverse),
            entry: [signs & 1, signs >> 1 & 1, signs >> 2 & 1],
        }
    }

    /// Where the ray enters each box, see [`Boxes::enter`].
    #[inline(always)]
    fn enter(&self, node: &Boxes, t_max: f32) -> ([f32; 4], u32) {
        let (near, mask) = node.enter((&self.starts, &self.inverse, &self.entry), t_max);
        (near.to_array(), mask)
    }
}

/// The way of a ray through the leaves that it may meet something in.
pub(crate) struct Traversal<'a, 'w> {
    pub(crate) query: Query<'a>,
    slabs: Slabs,
    /// Not its own, as it would be copied whole.
    waiting: &'w mut TraversalStack,
}

/// The children that wait for their turn, and where the ray enters them.
pub(crate) type TraversalStack = Vec<(Child, f32), STACK>;

impl<'a, 'w> Traversal<'a, 'w> {
    /// A search for objects and lamps.
    #[inline(always)]
    pub(crate) fn of_all(query: Query<'a>, waiting: &'w mut TraversalStack) -> Self {
        if let Some(root) = query.packets.lamps {
            let _ = waiting.push((Child::node(root), 0.0));
        }
        Self::of_objects(query, waiting)
    }

    /// A search for objects; where there are few lamps, they are among them.
    #[inline(always)]
    pub(crate) fn of_objects(query: Query<'a>, waiting: &'w mut TraversalStack) -> Self {
        let slabs = Slabs::new(&query.ray);
        let _ = waiting.push((Child::node(0), 0.0));
        Self { query, slabs, waiting }
    }

    /// The next leaf, near ones first.
    #[inline(always)]
    pub(crate) fn leaf(&mut self) -> Option<&'a [Sphere4]> {
        loop {
            let (mut child, near) = self.waiting.pop()?;
            if near > self.query.t_max {
                continue;
            }
            // The nearest child goes on at once.
            while let Some(number) = child.number() {
                let node = self.query.packets.nodes.get(number)?;
                let (near, mask) = self.slabs.enter(node, self.query.t_max);
                let mut entered = Bits(mask);
                let first = entered.next().and_then(|k| Some((*node.children.get(k)?, *near.get(k)?)));
                let Some(mut best) = first else { break };
                for k in entered {
                    let (Some(&child), Some(&near)) = (node.children.get(k), near.get(k)) else { break };
                    let later = if near < best.1 {
                        core::mem::replace(&mut best, (child, near))
                    } else {
                        (child, near)
                    };
                    // There is room: the hierarchy is not deeper than the stack.
                    let _ = self.waiting.push(later);
                }
                child = best.0;
            }
            if child.number().is_none() {
                return Some(self.run(child));
            }
        }
    }

    #[inline(always)]
    fn run(&self, child: Child) -> &'a [Sphere4] {
        let (first, count) = child.run();
        self.query.packets.leaves.get(first..first + count).unwrap_or(&[])
    }
}
