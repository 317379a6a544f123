//! Rays in `f32` in scenes of flat triangles alone, as those of paths and to lamps with a size in a room: what [`one`](crate::one) finds,
//! without what other objects need.
//!
//! In the Cornell box it takes three fifths of the instructions of paths.

use glam::Vec4;
use rta_core::Scalar;
use rta_core::accelerator::STEEPEST;
use rta_core::scene::Object;

use crate::four::geometry::Ray4;
use crate::four::triangle::Met4;
use crate::four::vector::{Vec3x4, lane, one};
use crate::leaf::{Bits, Boxes, Child, LARGEST, index};
use crate::number::ToF32;
use crate::packets::Packets;
use crate::query::{LEAST, TraversalStack};
use crate::rays::RayF32;

/// The nearest hit of a ray.
pub(crate) enum Nearest {
    /// It meets nothing.
    Nothing,
    /// It meets a triangle, by its number, so far away.
    Triangle(u32, f32),
    /// It meets several triangles that may lie at one place, or is too far away: [`Accelerator::closest`](rta_core::accelerator::Accelerator::closest)
    /// is to be asked.
    Unknown,
}

/// Four rays side by side, made ready for boxes and triangles.
pub(crate) struct Ready4 {
    rays: Ray4,
    margin: Vec4,
    /// For x, y and z: from where the way is to the planes that they enter boxes by, and to those that they leave by.
    starts: [[Vec4; 2]; 3],
    /// The reciprocals of their directions.
    inverse: [Vec4; 3],
    /// For x, y and z a bit for each that leads downwards.
    down: [u32; 3],
    /// A bit for each that is not too far away to be searched for.
    are_near: u32,
}

impl Ready4 {
    /// Returns rays made ready for the triangles of a scene.
    #[inline(always)]
    pub(crate) fn new(rays: &Ray4, packets: &Packets) -> Self {
        let far = rays.origin.largest().max(Vec4::splat(packets.size));
        let margin = far * Vec4::splat(f32::margin(1.0));
        let (Vec3x4(origins), Vec3x4(directions)) = (rays.origin, rays.direction);
        let mut starts = [[Vec4::ZERO; 2]; 3];
        for (start, (origin, direction)) in starts.iter_mut().zip(origins.into_iter().zip(directions)) {
            let by = margin.copysign(direction);
            *start = [origin + by, origin - by];
        }
        Self {
            rays: *rays,
            margin,
            starts,
            inverse: directions.map(|d| d.abs().max(Vec4::splat(LEAST)).copysign(d).recip()),
            down: directions.map(|d| d.is_negative_bitmask()),
            are_near: far.cmple(Vec4::splat(LARGEST)).bitmask(),
        }
    }

    /// Returns one of them, four times.
    #[inline(always)]
    fn one(&self, k: usize) -> Ready {
        // By reference, as what is copied would be so as a whole.
        let one = |four: &Vec4| Vec4::splat(lane(four, k));
        let all = |four: &[Vec4; 3]| four.each_ref().map(one);
        Ready {
            ray: Ray4 {
                origin: Vec3x4(all(&self.rays.origin.0)),
                direction: Vec3x4(all(&self.rays.direction.0)),
            },
            starts: self.starts.each_ref().map(|both| both.each_ref().map(one)),
            inverse: all(&self.inverse),
            entry: self.down.map(|down| index(down >> k & 1)),
            margin: lane(&self.margin, k),
        }
    }
}

/// One ray four times, made ready for four boxes or four triangles at once.
struct Ready {
    ray: Ray4,
    starts: [[Vec4; 2]; 3],
    inverse: [Vec4; 3],
    /// Which planes it enters boxes by: 0 are the least.
    entry: [usize; 3],
    margin: f32,
}

impl Ready {
    /// Returns where the ray enters each box, see [`Boxes::enter`].
    #[inline(always)]
    fn enter(&self, node: &Boxes, t_max: f32) -> (Vec4, u32) {
        node.enter((&self.starts, &self.inverse, &self.entry), t_max)
    }
}

/// A search in a scene of flat triangles alone.
pub(crate) struct FlatSearch<'a> {
    packets: &'a Packets,
    stack: TraversalStack,
    /// The leaf that hid a lamp from the last point that one was hidden from.
    occluder: usize,
}

impl<'a> FlatSearch<'a> {
    /// Returns a search; `None` where not all is found in leaves of triangles.
    pub(crate) fn new(packets: &'a Packets) -> Option<Self> {
        let is_flat = packets.exact.len() == packets.leaves.len() && packets.columns.is_empty();
        let is_one = !packets.is_too_large && packets.lamps.is_none();
        (is_flat && is_one).then(|| Self { packets, stack: TraversalStack::new(), occluder: usize::MAX })
    }

    /// Returns what it searches in.
    pub(crate) const fn packets(&self) -> &'a Packets {
        self.packets
    }

    /// Visits the leaves on the way of a ray, near ones first, until one says that it is enough. `t_max` is how far the ray goes, with its margin,
    /// which gets less as hits are found.
    #[inline(always)]
    fn walk(&mut self, ray: &Ready, t_max: &mut f32, mut visit: impl FnMut(usize, &mut f32) -> bool) {
        let (nodes, waiting) = (&self.packets.nodes, &mut self.stack);
        waiting.clear();
        let mut child = Child::node(0);
        loop {
            // Of few objects there are no nodes.
            let mut leaves = 0..if nodes.is_empty() { self.packets.exact.len() } else { 0 };
            // The nearest child goes on at once.
            while let Some(node) = child.number().and_then(|number| nodes.get(number)) {
                let (near, mask) = ray.enter(node, *t_max);
                let mut entered = Bits(mask);
                let Some(first) = entered.next() else { break };
                let mut best = (one(&node.children, first), lane(&near, first));
                for k in entered {
                    let other = (one(&node.children, k), lane(&near, k));
                    let later = if other.1 < best.1 { core::mem::replace(&mut best, other) } else { other };
                    // There is room: the hierarchy is not deeper than the stack.
                    let _ = waiting.push(later);
                }
                child = best.0;
            }
            if child.number().is_none() {
                let (first, count) = child.run();
                leaves = first..first + count;
            }
            for leaf in leaves {
                if visit(leaf, t_max) {
                    return;
                }
            }
            child = loop {
                match waiting.pop() {
                    Some((child, near)) if near <= *t_max => break child,
                    Some(_) => {}
                    None => return,
                }
            };
        }
    }

    /// Returns the nearest hit of one of four rays, which comes from the eye if `is_eye`.
    pub(crate) fn nearest(&mut self, rays: &Ready4, k: usize, is_eye: bool) -> Nearest {
        if rays.are_near >> k & 1 == 0 {
            return Nearest::Unknown;
        }
        let (ray, packets) = (rays.one(k), self.packets);
        let (mut found, mut t_max) = (Found::NOTHING, f32::FAR);
        if !is_eye || !self.seen(&ray, &rays.single(k, packets.size), &mut found) {
            self.walk(&ray, &mut t_max, |leaf, t_max| {
                found.test(packets, leaf, (&ray, t_max));
                false
            });
        }
        found.told(packets)
    }

    /// Finds the nearest hit of a ray among what is seen from the eye in its direction. Returns whether there may be no others.
    fn seen(&self, ray: &Ready, single: &RayF32, found: &mut Found) -> bool {
        let packets = self.packets;
        let Some(seen) = packets.light_buffers.eye_sees(single) else { return false };
        let mut t_max = f32::FAR;
        for &candidate in seen.entries {
            if seen.near(candidate) > t_max {
                break;
            }
            let leaf = index(candidate.leaf());
            if leaf >= packets.exact.len() {
                // The rest is none of the leaves.
                *found = Found::NOTHING;
                return false;
            }
            found.test(packets, leaf, (ray, &mut t_max));
        }
        true
    }

    /// Returns whether one of four rays meets nothing before `t_max`; `None` if it is too far away.
    pub(crate) fn is_open(&mut self, rays: &Ready4, k: usize, t_max: f32) -> Option<bool> {
        if rays.are_near >> k & 1 == 0 {
            return None;
        }
        let (ray, packets) = (rays.one(k), self.packets);
        if hides_again(packets, self.occluder, (&ray, t_max)) {
            return Some(false);
        }
        let (mut length, mut occluder) = (t_max + ray.margin, None);
        self.walk(&ray, &mut length, |leaf, _| {
            let is_hidden = hides(packets, leaf, (&ray, t_max));
            if is_hidden {
                occluder = Some(leaf);
            }
            is_hidden
        });
        self.occluder = occluder.unwrap_or(usize::MAX);
        Some(occluder.is_none())
    }
}

/// Returns whether a triangle of a leaf is on the way of a ray before `t_max`.
#[inline(always)]
fn hides(packets: &Packets, leaf: usize, (ray, t_max): (&Ready, f32)) -> bool {
    let (Some(triangles), end) = (packets.exact.get(leaf), Vec4::splat(t_max)) else { return false };
    if !ray.ray.meet_planes(triangles, end, Vec4::splat(4.0 * ray.margin)).any() {
        return false;
    }
    let Met4 { is_met, begin, .. } = ray.ray.meet_triangles(triangles, end);
    (is_met & begin.cmplt(end)).any()
}

/// Returns what [`hides`] does, for the leaf that hid a lamp before.
#[inline(never)] // so that the other is inlined where it is asked most
fn hides_again(packets: &Packets, leaf: usize, ray: (&Ready, f32)) -> bool {
    hides(packets, leaf, ray)
}

impl Ready4 {
    /// Returns one of them.
    #[inline(always)]
    fn single(&self, k: usize, size: f32) -> RayF32 {
        let ([x, y, z], [dx, dy, dz]) =
            (self.rays.origin.lane(k).to_array(), self.rays.direction.lane(k).to_array());
        RayF32 {
            origin: Vec4::new(x, y, z, size),
            direction: Vec4::new(dx, dy, dz, 0.0),
            margin: lane(&self.margin, k),
        }
    }
}

/// What has been found of the nearest hit.
struct Found {
    nearest: f32,
    /// The distance of the nearest of all others.
    second: f32,
    /// From where on hits are of no interest: beyond what may lie at the place of the nearest.
    limit: f32,
    /// The leaf of the nearest, and its place in it.
    at: (usize, usize),
}

impl Found {
    const NOTHING: Self = Self { nearest: f32::FAR, second: f32::FAR, limit: f32::FAR, at: (usize::MAX, 0) };

    /// Adds the hits of a ray with the triangles of a leaf. The ray goes as far as `t_max`, with its margin.
    #[inline(always)]
    fn test(&mut self, packets: &Packets, leaf: usize, (ray, t_max): (&Ready, &mut f32)) {
        let Some(triangles) = packets.exact.get(leaf) else { return };
        let length = Vec4::splat(*t_max);
        if !ray.ray.meet_planes(triangles, length, Vec4::splat(4.0 * ray.margin)).any() {
            return;
        }
        let Met4 { is_met, distance, begin } = ray.ray.meet_triangles(triangles, length);
        for k in Bits(is_met.bitmask()) {
            let distance = lane(&distance, k);
            if distance < self.limit && lane(&begin, k) < self.limit {
                if distance < self.nearest {
                    (self.second, self.nearest, self.at) = (self.nearest, distance, (leaf, k));
                    // An edge is at most as long as the diagonal of the box about all.
                    self.limit = distance.at_one_place(4.0 * packets.size, 1.0 / STEEPEST as f32);
                    *t_max = self.limit + ray.margin;
                } else if distance < self.second {
                    self.second = distance;
                }
            }
        }
    }

    /// Returns what has been found in all.
    #[inline(always)]
    fn told(&self, packets: &Packets) -> Nearest {
        let (leaf, k) = self.at;
        let Some(leaf) = packets.leaves.get(leaf) else { return Nearest::Nothing };
        match one(&leaf.items, k) {
            Object::Triangle(i) if self.second > self.limit => Nearest::Triangle(i, self.nearest),
            _ => Nearest::Unknown,
        }
    }
}

#[cfg(test)]
#[allow(clippy::indexing_slicing, reason = "a test may panic")]
mod tests;
