//! Four rays beside each other, which are searched for together.
//!
//! Rays of neighbouring pixels hardly differ, and what one of them does not come near, the others seldom meet (I. Wald, P. Slusallek,
//! C. Benthin and M. Wagner, "Interactive Rendering with Coherent Ray Tracing", Computer Graphics Forum 20(3), 2001). So four items
//! are asked at once whether one of the rays, made as thick as the others are away from it, comes near; and of those that are
//! left each is tested against the four rays at once.

use glam::Vec4;

use super::rays::{Met, Rays};
use super::{LARGEST, Lanes, Pack, Posts, Rods};
use crate::bvh::{Bits, Item, index};
use crate::ray::Ray;
use crate::scalar::{Scalar, Unit};
use crate::vector::Vector;

/// Directions of rays that differ by more do not lead beside each other.
const LARGEST_TURN: f32 = 0.25;
/// A ray is not made thicker than this part of its length.
const THICKEST: f32 = 0.0625;

/// Four rays, or less.
pub(crate) struct Four<'a> {
    lanes: &'a Lanes<'a>,
    rays: Rays,
    /// One of them four times, as long as the longest; nothing where each item is tried.
    middle: Option<Rays>,
    /// Of a sphere that one of the rays meets, the middle one meets this part of its radius, and so much more, and so much
    /// of how far away it is.
    thick: [Vec4; 3],
}

impl<'a> Four<'a> {
    /// Four rays, and how far each goes; nothing where they are not beside each other.
    #[inline(always)]
    pub(crate) fn new<S: Scalar>(lanes: &'a Lanes<'a>, rays: [&Ray<S>; 4], t_max: [S; 4]) -> Option<Self> {
        let [a, b, c, d] = rays;
        let four = |number: fn(&Ray<S>) -> f32| Vec4::new(number(a), number(b), number(c), number(d));
        let origin = [
            four(|r| r.origin.x().coarse()),
            four(|r| r.origin.y().coarse()),
            four(|r| r.origin.z().coarse()),
        ];
        let direction = [
            four(|r| r.direction.x().coarse()),
            four(|r| r.direction.y().coarse()),
            four(|r| r.direction.z().coarse()),
        ];
        let [ox, oy, oz] = origin.map(Vec4::abs);
        let far = ox.max(oy).max(oz).max(Vec4::splat(lanes.size)).max_element();
        if far > LARGEST {
            return None;
        }
        let margin = S::coarse_margin(far);
        let t_max = Vec4::from_array(t_max.map(Scalar::coarse)) + Vec4::splat(margin);
        let rays = Rays { origin, direction, margin, t_max };
        let mut thick = [Vec4::ZERO; 3];
        let mut middle = None;
        if !lanes.nodes.is_empty() {
            let first = |four: Vec4| Vec4::splat(four.x);
            let longest = t_max.max_element();
            let one = Rays {
                origin: origin.map(first),
                direction: direction.map(first),
                margin,
                t_max: Vec4::splat(longest),
            };
            let beside = apart(origin, one.origin);
            let turn = apart(direction, one.direction);
            if !(turn < LARGEST_TURN && beside < THICKEST * longest) {
                return None;
            }
            // A sphere of the radius r that a ray meets is r + beside + turn x distance away from the middle one there, and
            // the distance is not above that of the middle one's foot point, and as much.
            let more = (1.0 - turn).recip();
            let part = more * (1.0 + turn);
            thick = [part, part * (beside + 2.0 * margin), more * turn].map(Vec4::splat);
            middle = Some(one);
        }
        Some(Self { lanes, rays, middle, thick })
    }

    /// The cells of a cube that the rays look through, if all start at the eye; else nothing.
    #[inline(always)]
    pub(crate) fn eye_cells(&self) -> Option<[usize; 4]> {
        let cube = self.lanes.cubes.first()?;
        let ([x, y, z], slack) = (self.rays.origin, cube.slack * cube.slack);
        let [cx, cy, cz, _] = cube.center.to_array();
        let (x, y, z) = (Vec4::splat(cx) - x, Vec4::splat(cy) - y, Vec4::splat(cz) - z);
        let there = (x * x + y * y + z * z).max_element() <= slack && self.rays.margin <= cube.margin;
        if there { Some(cube.cells(self.rays.direction)) } else { None }
    }

    /// The same if all end at a lamp, by its number; and how far away the farthest of them starts.
    #[inline(always)]
    pub(crate) fn lamp_cells(&self, lamp: usize) -> Option<([usize; 4], f32)> {
        let cube = self.lanes.cubes.get(lamp + 1)?;
        let ([ox, oy, oz], [dx, dy, dz]) = (self.rays.origin, self.rays.direction);
        let [cx, cy, cz, _] = cube.center.to_array();
        let (x, y, z) = (Vec4::splat(cx) - ox, Vec4::splat(cy) - oy, Vec4::splat(cz) - oz);
        let along = x * dx + y * dy + z * dz;
        let (x, y, z) = (x - dx * along, y - dy * along, z - dz * along);
        let beside = (x * x + y * y + z * z).max_element();
        let far = along + Vec4::splat(cube.slack);
        let there = beside <= cube.slack * cube.slack
            && self.rays.margin <= cube.margin
            && self.rays.t_max.cmple(far).all();
        if there { Some((cube.cells([-dx, -dy, -dz]), far.max_element())) } else { None }
    }

    /// Which of a pack's items a ray may meet.
    #[inline(always)]
    pub(crate) fn touch(&self, pack: &Pack) -> Bits {
        let Some(middle) = &self.middle else { return Bits(15) };
        let ([ox, oy, oz], [dx, dy, dz], [cx, cy, cz]) = (middle.origin, middle.direction, pack.center);
        let (x, y, z) = (cx - ox, cy - oy, cz - oz);
        let b = x * dx + y * dy + z * dz;
        let (x, y, z) = (x - dx * b, y - dy * b, z - dz * b);
        let across = x * x + y * y + z * z;
        let [part, more, far] = self.thick;
        let r = pack.radius * part + more + b.abs() * far;
        let is_along = (b + r).cmpgt(Vec4::ZERO) & (b - r).cmplt(middle.t_max);
        Bits((across.cmple(r * r) & is_along).bitmask())
    }

    /// Which rays may meet item `k` of a pack.
    #[inline(always)]
    pub(crate) fn meet<S: Scalar>(&self, pack: &Pack, k: usize) -> Met {
        let center = pack.center.map(|four| pick(four, k));
        let sheets = self.lanes.sheets.get(index(pack.sheets));
        if let Some(sheets) = sheets
            && let Some(Item::Triangle(_)) = pack.items.get(k)
        {
            let mask = self.rays.meet_sheets::<S>(sheets, |four| pick(*four, k), 15);
            return Met { mask, along: Vec4::ZERO, across: Vec4::ZERO };
        }
        let mut met = self.rays.meet_spheres(center, pick(pack.radius, k));
        if met.mask != 0 && pack.rods != Pack::NO_RODS {
            let rods = self.lanes.rods.get(index(pack.rods));
            let one = |rods: &Rods| Rods {
                axis: rods.axis.map(|four| pick(four, k)),
                radius: pick(rods.radius, k),
            };
            met.mask &= rods.map_or(met.mask, |rods| self.rays.meet_rods(center, &one(rods)));
        }
        met
    }

    /// Which rays may meet cylinder `k` of four.
    #[inline(always)]
    pub(crate) fn meet_post(&self, posts: &Posts, k: usize) -> Bits {
        Bits(self.rays.meet_posts(posts.center.map(|four| pick(four, k)), pick(posts.radius, k)))
    }

    /// The distance of a hit of ray `r` nearer than `t_max`, if item `k` of a pack is a sphere; nothing where it has to be asked itself.
    #[inline(always)]
    pub(crate) fn sphere<S: Scalar>(
        &self,
        (pack, k): (&Pack, usize),
        met: &Met,
        r: usize,
        t_max: S,
    ) -> Option<Option<S>> {
        let lane = |four: &Vec4, k: usize| four.as_ref().get(k).copied();
        S::of_lane(lane(&met.along, r)?, lane(&met.across, r)?, lane(&pack.radius, k)?, t_max)
    }

    /// From now on for ray `r` only what is not farther than `t` is looked for.
    #[inline(always)]
    pub(crate) fn shorten<S: Scalar>(&mut self, r: usize, t: S) {
        if let Some(t_max) = self.rays.t_max.as_mut().get_mut(r) {
            *t_max = t.coarse() + self.rays.margin;
        }
        let longest = Vec4::splat(self.rays.t_max.max_element());
        if let Some(middle) = &mut self.middle {
            middle.t_max = longest;
        }
    }

    /// Whether what is not nearer than `near` is beyond the end of all of them.
    #[inline(always)]
    pub(crate) fn ends_before(&self, near: f32) -> bool {
        near > self.rays.t_max.max_element()
    }
}

/// How far the four vectors are from another one at most.
#[inline(always)]
fn apart([x, y, z]: [Vec4; 3], [ox, oy, oz]: [Vec4; 3]) -> f32 {
    let (x, y, z) = (x - ox, y - oy, z - oz);
    // Rounded upwards.
    libm::sqrtf((x * x + y * y + z * z).max_element()) * (1.0 + 4.0 * f32::EPSILON)
}

#[inline(always)]
fn pick(four: Vec4, k: usize) -> Vec4 {
    Vec4::splat(four.as_ref().get(k).copied().unwrap_or(f32::NAN))
}
