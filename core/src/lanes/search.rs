//! The search: a ray against four boxes, four spheres, four cylinders, four triangles at once.

use glam::Vec4;
use heapless::Vec;

use super::rays::{Met, Rays};
use super::{Boxes, LARGEST, Lanes, Pack, Posts};
use crate::bvh::{Bits, Child, MAX_DEPTH, index};
use crate::ray::Ray;
use crate::scalar::{Scalar, Unit};
use crate::vector::Vector;

/// Three of four children wait on each level.
const STACK: usize = 3 * MAX_DEPTH + 1;
/// A component of a direction counts as this at least: its reciprocal is a number, and a ray does not drift off by more than
/// a margin.
const LEAST: f32 = 1e-12;

/// A ray in `f32`.
pub(crate) struct CoarseRay {
    pub(super) origin: Vec4,
    pub(super) direction: Vec4,
    pub(super) margin: f32,
}

impl CoarseRay {
    /// Of a ray from so far away that its test could overflow, one that meets everything.
    #[inline(always)]
    fn new<S: Scalar>(ray: &Ray<S>, size: f32) -> Self {
        let (o, d) = (ray.origin, ray.direction);
        let origin = Vec4::new(o.x().coarse(), o.y().coarse(), o.z().coarse(), size);
        let direction = Vec4::new(d.x().coarse(), d.y().coarse(), d.z().coarse(), 0.0);
        let far = origin.abs().max_element();
        if far <= LARGEST {
            Self { origin, direction, margin: S::coarse_margin(far) }
        } else {
            Self { origin: Vec4::ZERO, direction: Vec4::ZERO, margin: f32::INFINITY }
        }
    }
}

/// Each coordinate four times.
#[inline(always)]
fn splat(v: Vec4) -> [Vec4; 3] {
    [Vec4::splat(v.x), Vec4::splat(v.y), Vec4::splat(v.z)]
}

/// A ray made ready for many packs, and how far it goes.
pub(crate) struct Probe<'a> {
    lanes: &'a Lanes<'a>,
    pub(crate) ray: CoarseRay,
    rays: Rays,
    pub(crate) t_max: f32,
}

impl<'a> Probe<'a> {
    /// For what is nearer than `t_max`.
    #[inline(always)]
    pub(crate) fn new<S: Scalar>(lanes: &'a Lanes<'a>, ray: &Ray<S>, t_max: S) -> Self {
        let ray = CoarseRay::new(ray, lanes.size);
        let t_max = t_max.coarse() + ray.margin;
        let (origin, direction) = (splat(ray.origin), splat(ray.direction));
        Self {
            lanes,
            rays: Rays { origin, direction, margin: ray.margin, t_max: Vec4::splat(t_max) },
            t_max,
            ray,
        }
    }

    /// From now on only what is not farther than `t` is looked for.
    #[inline(always)]
    pub(crate) fn shorten<S: Scalar>(&mut self, t: S) {
        self.t_max = t.coarse() + self.ray.margin;
        self.rays.t_max = Vec4::splat(self.t_max);
    }

    /// Whether what is not nearer than `near` is beyond its end.
    #[inline(always)]
    pub(crate) fn ends_before(&self, near: f32) -> bool {
        near > self.t_max
    }

    /// Which of a pack's items the ray may meet ahead and before its end.
    #[inline(always)]
    pub(crate) fn meet<S: Scalar>(&self, pack: &Pack) -> Met {
        let mut met = self.rays.meet_spheres(pack.center, pack.radius);
        if met.mask != 0 && pack.rods != Pack::NO_RODS {
            let rods = self.lanes.rods.get(index(pack.rods));
            met.mask &= rods.map_or(met.mask, |rods| self.rays.meet_rods(pack.center, rods));
        }
        if met.mask != 0 && pack.sheets != Pack::NO_SHEETS {
            let sheets = self.lanes.sheets.get(index(pack.sheets));
            met.mask &= sheets.map_or(met.mask, |sheets| self.rays.meet_sheets::<S>(sheets, met.mask));
        }
        met
    }

    /// The distance of a hit nearer than `t_max`, if item `k` of a pack is a sphere. Nothing where it has to be asked itself: in
    /// another format, and for a ray from too far away.
    #[inline(always)]
    pub(crate) fn sphere<S: Scalar>(&self, pack: &Pack, met: &Met, k: usize, t_max: S) -> Option<Option<S>> {
        if self.ray.margin == f32::INFINITY {
            return None;
        }
        let lane = |four: &Vec4| four.as_ref().get(k).copied();
        S::of_lane(lane(&met.along)?, lane(&met.across)?, lane(&pack.radius)?, t_max)
    }

    /// Which of four vertical cylinders the ray may meet ahead and before its end.
    #[inline(always)]
    pub(crate) fn meet_posts(&self, posts: &Posts) -> Bits {
        Bits(self.rays.meet_posts(posts.center, posts.radius))
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
    fn new(ray: &CoarseRay) -> Self {
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

    /// Where the ray enters each box, 0 if it starts within; and a bit for each that it enters before `t_max`, the lowest
    /// for the first.
    #[inline(always)]
    #[allow(clippy::indexing_slicing, reason = "every index is below the length")]
    fn enter(&self, node: &Boxes, t_max: f32) -> ([f32; 4], u32) {
        let (mut near, mut far) = (Vec4::ZERO, Vec4::splat(t_max));
        for axis in 0..3 {
            let ([start, end], inverse, entry) =
                (self.starts[axis], self.inverse[axis], self.entry[axis] & 1);
            // Where there is no number, the second operand is the result.
            near = ((node.planes[axis][entry] - start) * inverse).max(near);
            far = ((node.planes[axis][entry ^ 1] - end) * inverse).min(far);
        }
        (near.to_array(), near.cmple(far).bitmask())
    }
}

/// The way of a ray through the leaves that it may meet something in.
pub(crate) struct Search<'a, 'w> {
    pub(crate) probe: Probe<'a>,
    slabs: Slabs,
    /// Not its own, as it would be copied whole.
    waiting: &'w mut Waiting,
}

/// The children that wait for their turn, and where the ray enters them.
pub(crate) type Waiting = Vec<(Child, f32), STACK>;

impl<'a, 'w> Search<'a, 'w> {
    /// A search from the root on.
    #[inline(always)]
    pub(crate) fn new(probe: Probe<'a>, waiting: &'w mut Waiting) -> Self {
        let slabs = Slabs::new(&probe.ray);
        let _ = waiting.push((Child::node(0), 0.0));
        Self { probe, slabs, waiting }
    }

    /// The next leaf, near ones first.
    #[inline(always)]
    pub(crate) fn leaf(&mut self) -> Option<&'a [Pack]> {
        loop {
            let (mut child, near) = self.waiting.pop()?;
            if near > self.probe.t_max {
                continue;
            }
            // The nearest child goes on at once.
            while let Some(number) = child.number() {
                let node = self.probe.lanes.nodes.get(number)?;
                let (near, mask) = self.slabs.enter(node, self.probe.t_max);
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
    fn run(&self, child: Child) -> &'a [Pack] {
        let (first, count) = child.run();
        self.probe.lanes.packs.get(first..first + count).unwrap_or(&[])
    }
}
