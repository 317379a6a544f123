//! A hierarchy of boxes, so that scenes of thousands of objects take seconds.

use super::super::vector::{Vector, difference, largest, product, sum};
use super::crossing::{Ray, around};

/// Most objects of a leaf.
const LEAF: usize = 4;

pub(super) struct Boxes {
    bounds: [Vector; 2],
    below: Below,
}

enum Below {
    Objects(Vec<usize>),
    Halves(Box<[Boxes; 2]>),
}

impl Boxes {
    /// Returns the hierarchy over numbered objects, of which the boxes are given; each box grows by `margin` on all sides.
    pub(super) fn new(mut objects: Vec<(usize, [Vector; 2])>, margin: f64) -> Self {
        let ends: Vec<_> = objects.iter().flat_map(|(_, bounds)| *bounds).collect();
        let [low, high] = around(&ends);
        let bounds = [low.map(|part| part - margin), high.map(|part| part + margin)];
        if objects.len() <= LEAF {
            let numbers = objects.into_iter().map(|(number, _)| number).collect();
            return Self { bounds, below: Below::Objects(numbers) };
        }
        // Halved in the middle of the order along the longest side.
        let sides = difference(high, low);
        let longest = sides.map(|side| f64::from(u8::from(side == largest(sides))));
        let place = |[low, high]: [Vector; 2]| product(longest, sum([low, high])).iter().sum::<f64>();
        objects.sort_by(|(_, a), (_, b)| place(*a).total_cmp(&place(*b)));
        let rest = objects.split_off(objects.len() / 2);
        Self { bounds, below: Below::Halves(Box::new([objects, rest].map(|half| Self::new(half, margin)))) }
    }

    /// Calls `meet` with the number of each object that the ray may meet before the distance that `meet` last returned.
    pub(super) fn visit(&self, ray: Ray, before: &mut f64, meet: &mut impl FnMut(usize) -> f64) {
        if !self.is_met(ray, *before) {
            return;
        }
        match &self.below {
            Below::Objects(numbers) => numbers.iter().for_each(|number| *before = meet(*number)),
            Below::Halves(halves) => halves.iter().for_each(|half| half.visit(ray, before, meet)),
        }
    }

    fn is_met(&self, ray: Ray, before: f64) -> bool {
        let [low, high] = self.bounds.map(|corner| {
            let [x, y, z] = difference(corner, ray.origin);
            [x / ray.direction[0], y / ray.direction[1], z / ray.direction[2]]
        });
        // Where a component is 0 / 0, the other side decides: `min` and `max` pass over what is no number.
        let (mut enters, mut leaves) = (0.0_f64, before);
        for (one, other) in low.into_iter().zip(high) {
            enters = enters.max(one.min(other));
            leaves = leaves.min(one.max(other));
        }
        enters <= leaves
    }
}
