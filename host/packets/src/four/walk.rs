//! The way of four rays side by side through the hierarchy.
//!
//! A box is entered by one of them at the earliest where a ray would that starts nearest to it and goes fastest towards it, and left at
//! the latest where one would that starts farthest and goes slowest: so one test per axis serves all four, as it does for one ray
//! (S. Boulos, I. Wald and P. Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", University of Utah, UUCS-06-010, 2006).

use glam::Vec4;

use super::packet::RayPacket;
use crate::leaf::{Bits, Boxes, Child, Sphere4};
use crate::packets::Packets;
use crate::query::{LEAST, TraversalStack};

/// Four rays made ready for many boxes, and what waits for them.
pub(crate) struct Walk<'a> {
    packets: &'a Packets,
    /// For x, y and z: from where the way is to the plane that they enter by, and to the one that they leave by.
    starts: [[Vec4; 2]; 3],
    /// The reciprocals of their directions with the least size and with the greatest.
    inverse: [[Vec4; 2]; 3],
    /// Which plane they enter by: 0 is the least.
    entry: [usize; 3],
    waiting: TraversalStack,
}

impl<'a> Walk<'a> {
    /// Begins at the root of the objects.
    #[inline(always)]
    pub(crate) fn new(packets: &'a Packets, four: &RayPacket) -> Self {
        let (mut starts, mut inverse, mut entry) = ([[Vec4::ZERO; 2]; 3], [[Vec4::ZERO; 2]; 3], [0; 3]);
        let ([origins, directions], margin) = four.rays();
        let axes = starts.iter_mut().zip(&mut inverse).zip(&mut entry);
        for (((starts, inverse), entry), (origin, direction)) in axes.zip(origins.into_iter().zip(directions))
        {
            let (least, most) = (direction.min_element(), direction.max_element());
            let (first, last) = (origin.min_element() - margin, origin.max_element() + margin);
            (*starts, *inverse, *entry) = if least > LEAST {
                ([last, first].map(Vec4::splat), [most, least].map(|d| Vec4::splat(d.recip())), 0)
            } else if most < -LEAST {
                ([first, last].map(Vec4::splat), [least, most].map(|d| Vec4::splat(d.recip())), 1)
            } else {
                // The signs differ, or one is too near to 0 to be known: entered long ago, and left late.
                ([f32::MAX, f32::MIN].map(Vec4::splat), [Vec4::ONE; 2], 0)
            };
        }
        let mut waiting = TraversalStack::new();
        let _ = waiting.push((Child::node(0), 0.0));
        Self { packets, starts, inverse, entry, waiting }
    }

    /// Where the first of the rays enters each box, or before; and a bit for each that one may enter before `longest`.
    #[inline(always)]
    #[allow(clippy::indexing_slicing, reason = "every index is below the length")]
    fn enter(&self, node: &Boxes, longest: f32) -> ([f32; 4], u32) {
        let (mut near, mut far) = (Vec4::ZERO, Vec4::splat(longest));
        for axis in 0..3 {
            let ([start, end], [slow, quick], entry) =
                (self.starts[axis], self.inverse[axis], self.entry[axis] & 1);
            near = ((node.planes[axis][entry] - start) * slow).max(near);
            far = ((node.planes[axis][entry ^ 1] - end) * quick).min(far);
        }
        (near.to_array(), near.cmple(far).bitmask())
    }

    /// The next leaves that one of the rays may meet something in before `longest`, near ones first.
    #[inline(always)]
    pub(crate) fn leaves(&mut self, longest: f32) -> Option<&'a [Sphere4]> {
        loop {
            let (child, near) = self.waiting.pop()?;
            if near > longest {
                continue;
            }
            let Some(number) = child.number() else {
                let (first, count) = child.run();
                return Some(self.packets.leaves.get(first..first + count).unwrap_or(&[]));
            };
            let node = self.packets.nodes.get(number)?;
            let (near, mask) = self.enter(node, longest);
            let mut nearest: Option<(Child, f32)> = None;
            for k in Bits(mask) {
                let (Some(&child), Some(&near)) = (node.children.get(k), near.get(k)) else { break };
                let later = match nearest {
                    Some(first) if first.1 <= near => (child, near),
                    _ => match nearest.replace((child, near)) {
                        Some(first) => first,
                        None => continue,
                    },
                };
                // There is room: the hierarchy is not deeper than the stack.
                let _ = self.waiting.push(later);
            }
            if let Some(first) = nearest {
                let _ = self.waiting.push(first);
            }
        }
    }
}
