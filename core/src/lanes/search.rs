//! The search: a ray against four boxes, four spheres, four cylinders, four triangles at once.

use glam::Vec4;
use heapless::Vec;

use super::{Boxes, LARGEST, Lanes, Pack, Posts, Rods, Sheets};
use crate::bvh::{Bits, Child, MAX_DEPTH};
use crate::ray::Ray;
use crate::scalar::{Scalar, Unit};
use crate::vector::Vector;

/// Three of four children wait on each level.
const STACK: usize = 3 * MAX_DEPTH + 1;
/// A component of a direction counts as this at least: its reciprocal is a number, and a ray does not drift off by more than
/// a margin.
const LEAST: f32 = 1e-12;

/// A ray in `f32`.
pub(super) struct CoarseRay {
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
    pub(super) ray: CoarseRay,
    origin: [Vec4; 3],
    direction: [Vec4; 3],
    pub(super) t_max: f32,
}

impl<'a> Probe<'a> {
    /// For what is nearer than `t_max`.
    #[inline(always)]
    pub(crate) fn new<S: Scalar>(lanes: &'a Lanes<'a>, ray: &Ray<S>, t_max: S) -> Self {
        let ray = CoarseRay::new(ray, lanes.size);
        Self {
            lanes,
            origin: splat(ray.origin),
            direction: splat(ray.direction),
            t_max: t_max.coarse() + ray.margin,
            ray,
        }
    }

    /// From now on only what is not farther than `t` is looked for.
    #[inline(always)]
    pub(crate) fn shorten<S: Scalar>(&mut self, t: S) {
        self.t_max = t.coarse() + self.ray.margin;
    }

    /// Whether what is not nearer than `near` is beyond its end.
    #[inline(always)]
    pub(crate) fn ends_before(&self, near: f32) -> bool {
        near > self.t_max
    }

    /// Which of a pack's items the ray may meet ahead and before its end.
    #[inline(always)]
    pub(crate) fn meet<S: Scalar>(&self, pack: &Pack) -> Met {
        let ([ox, oy, oz], [dx, dy, dz], [cx, cy, cz]) = (self.origin, self.direction, pack.center);
        let (x, y, z) = (cx - ox, cy - oy, cz - oz);
        let b = x * dx + y * dy + z * dz;
        let (x, y, z) = (x - dx * b, y - dy * b, z - dz * b);
        let across = x * x + y * y + z * z;
        let r = pack.radius + Vec4::splat(self.ray.margin);
        let is_along = (b + r).cmpgt(Vec4::ZERO) & (b - r).cmplt(Vec4::splat(self.t_max));
        let mut mask = (across.cmple(r * r) & is_along).bitmask();
        if mask != 0 && pack.rods != Pack::NO_RODS {
            let rods = usize::try_from(pack.rods).ok().and_then(|number| self.lanes.rods.get(number));
            mask &= rods.map_or(mask, |rods| self.meet_rods(pack, rods));
        }
        if mask != 0 && pack.sheets != Pack::NO_SHEETS {
            let sheets = usize::try_from(pack.sheets).ok().and_then(|number| self.lanes.sheets.get(number));
            mask &= sheets.map_or(mask, |sheets| self.meet_sheets::<S>(sheets, mask));
        }
        Met { mask, along: b, across }
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

    /// Which of four vertical cylinders the ray may meet ahead and before its end: as [`Probe::meet_rods`] sees it. Its way
    /// seen from above is not longer than the way.
    #[inline(always)]
    pub(crate) fn meet_posts(&self, posts: &Posts) -> Bits {
        let ([ox, oy, _], [dx, dy, _], [cx, cy]) = (self.origin, self.direction, posts.center);
        let margin = Vec4::splat(self.ray.margin);
        let (x, y, r) = (cx - ox, cy - oy, posts.radius + margin);
        let (b, s) = (x * dx + y * dy, ((x * dy - y * dx).abs() - margin).max(Vec4::ZERO));
        let is_along = (b + r).cmpgt(Vec4::ZERO) & (b - r).cmplt(Vec4::splat(self.t_max));
        Bits((is_along & !(s * s).cmpgt(r * r * (dx * dx + dy * dy))).bitmask())
    }

    /// Of the triangles in `mask`, those that the ray may meet.
    ///
    /// In `f32` those are left out that it leads away from, by the first test of [`Triangle`](crate::shape::Triangle) and its arithmetic;
    /// but for a ray from too far away, whose numbers are not its own. Then those are left out whose plane it meets beyond an
    /// edge, by the part `cosine` of how far. A triangle's own test lets by as much as 168 EPSILON of `far`, or 4 LSB and 2^-25
    /// of its distance, and these sums err by less than 60 EPSILON of `far`: four margins are more.
    #[inline]
    fn meet_sheets<S: Scalar>(&self, sheets: &Sheets, mask: u32) -> u32 {
        let ([ox, oy, oz], [dx, dy, dz]) = (self.origin, self.direction);
        let ([x, y, z], [nx, ny, nz]) = (sheets.corner, sheets.normal);
        let (x, y, z) = (x - ox, y - oy, z - oz);
        let height = x * nx + y * ny + z * nz;
        let cosine = nx * dx + ny * dy + nz * dz;
        let (zero, mut mask) = (Vec4::ZERO, mask);
        let is_upwards = cosine.cmpgt(zero);
        if S::IN_LANES && self.ray.margin < f32::INFINITY {
            let behind = (is_upwards & height.cmple(zero)) | (cosine.cmple(zero) & height.cmpge(zero));
            mask &= !behind.bitmask();
        }
        if mask == 0 {
            return 0;
        }
        let least = Vec4::splat(-4.0 * self.ray.margin);
        let [first, second, third] = sheets
            .inward
            .map(|[ix, iy, iz]| height * (ix * dx + iy * dy + iz * dz) - cosine * (x * ix + y * iy + z * iz));
        let first = first + sheets.height * cosine;
        // Upwards none of them is below 0, downwards none above.
        let is_upwards = is_upwards & (first.cmplt(least) | second.cmplt(least) | third.cmplt(least));
        let is_downwards =
            cosine.cmplt(zero) & (first.cmpgt(-least) | second.cmpgt(-least) | third.cmpgt(-least));
        mask & !(is_upwards | is_downwards).bitmask()
    }

    /// A bit for each cylinder that the ray meets if it is endless too. The nearest of the two lines is `|s| / |n|`, with `n`
    /// normal to both; `s` errs by less than the margin, as a foot point does. What is no number, as where the margin is
    /// infinite, is met.
    #[inline]
    fn meet_rods(&self, pack: &Pack, rods: &Rods) -> u32 {
        let ([ox, oy, oz], [dx, dy, dz], [cx, cy, cz]) = (self.origin, self.direction, pack.center);
        let ([ax, ay, az], margin) = (rods.axis, Vec4::splat(self.ray.margin));
        let (nx, ny, nz) = (dy * az - dz * ay, dz * ax - dx * az, dx * ay - dy * ax);
        let s = (cx - ox) * nx + (cy - oy) * ny + (cz - oz) * nz;
        let (s, r) = ((s.abs() - margin).max(Vec4::ZERO), rods.radius + margin);
        (!(s * s).cmpgt(r * r * (nx * nx + ny * ny + nz * nz))).bitmask()
    }
}

/// What a ray may meet of a pack.
pub(crate) struct Met {
    mask: u32,
    /// Distance of the foot point of each centre.
    along: Vec4,
    /// The square of how far the foot point is from the centre.
    across: Vec4,
}

impl Met {
    /// The numbers of the items, 0 to 3.
    #[inline(always)]
    pub(crate) fn items(&self) -> Bits {
        Bits(self.mask)
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
