//! The binary tree that hierarchies are made from: top down by the surface area heuristic over sixteen bins
//! (I. Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007).

use super::bounds::Bounds;
use super::solid::Solid;

const BINS: usize = 16;
/// Levels of pairs at most.
pub const MAX_PAIRS: usize = 41;

/// The costs of the steps of a search. The unit is the test of one sphere.
#[derive(Clone, Copy, Debug)]
pub struct Costs {
    /// The test of the two boxes of a pair.
    pub pair: f64,
    /// The part of an object's own cost that counts for its leaf: a triangle costs as much as several spheres, but is often
    /// rejected by its bounding sphere.
    pub object: f64,
    /// The test of a group of objects at once, whatever they are; 0 where objects are tested one by one.
    pub group: f64,
    /// The number of objects in a group.
    pub at_once: usize,
    /// The most objects in a leaf.
    pub leaf: usize,
}

/// A tree over objects that the builder has sorted.
#[derive(Debug)]
pub enum Tree {
    /// Some objects that lie side by side: a box about them, the first, and how many.
    Leaf(Bounds, usize, usize),
    /// Two subtrees, the objects of the first before those of the second.
    Pair(Bounds, Box<[Tree; 2]>),
}

impl Tree {
    /// Returns the box about its objects.
    #[must_use]
    pub const fn bounds(&self) -> &Bounds {
        match self {
            Self::Leaf(bounds, ..) | Self::Pair(bounds, _) => bounds,
        }
    }

    /// Returns the first of its objects, and how many there are.
    #[must_use]
    pub fn run(&self) -> (usize, usize) {
        match self {
            Self::Leaf(_, first, count) => (*first, *count),
            Self::Pair(_, pair) => {
                let [one, other] = &**pair;
                let ((first, before), (_, after)) = (one.run(), other.run());
                (first, before + after)
            }
        }
    }
}

impl Costs {
    /// Returns the cost of a leaf of `count` objects whose own costs add up to `objects`.
    #[allow(clippy::cast_precision_loss)] // few
    fn leaf(&self, count: usize, objects: f64) -> f64 {
        self.object * objects + self.group * count.div_ceil(self.at_once) as f64
    }
}

/// Sorts some objects into a tree and returns it; they follow `before` others, `level` pairs below the root.
pub fn tree(solids: &mut [Solid], before: usize, level: usize, costs: &Costs) -> Tree {
    let bounds = solids.iter().fold(Bounds::NONE, |bounds, solid| bounds.with(&solid.bounds));
    let whole = costs.leaf(solids.len(), solids.iter().map(|solid| f64::from(solid.cost)).sum());
    // Halves from here on fit into what levels are left.
    let halves = usize::BITS as usize - solids.len().leading_zeros() as usize;
    let cut = if level + halves >= MAX_PAIRS { None } else { best_cut(solids, &bounds, costs) };
    let middle = match cut {
        Some(cut) if cut.cost + costs.pair < whole || solids.len() > costs.leaf => {
            partition(solids, |solid| cut.is_before(solid))
        }
        _ if solids.len() <= costs.leaf => return Tree::Leaf(bounds, before, solids.len()),
        _ => halve(solids),
    };
    // A cut that rounding has undone.
    let middle = if middle == 0 || middle == solids.len() { halve(solids) } else { middle };
    let (first, second) = solids.split_at_mut(middle);
    let pair = [tree(first, before, level + 1, costs), tree(second, before + middle, level + 1, costs)];
    Tree::Pair(bounds, Box::new(pair))
}

/// Puts the smaller half of the centres along the longest side first.
fn halve(solids: &mut [Solid]) -> usize {
    let centers = solids.iter().fold(Bounds::NONE, |b, s| b.with(&Bounds::about(s.center(), [0.0; 3])));
    let axis = centers.longest();
    let middle = solids.len() / 2;
    let along = |solid: &Solid| solid.center().get(axis).copied().unwrap_or(0.0);
    solids.select_nth_unstable_by(middle, |a, b| along(a).total_cmp(&along(b)));
    middle
}

/// Puts those first for which `is_first` is true, and says how many.
fn partition(solids: &mut [Solid], is_first: impl Fn(&Solid) -> bool) -> usize {
    let mut count = 0;
    for i in 0..solids.len() {
        if solids.get(i).is_some_and(&is_first) {
            solids.swap(i, count);
            count += 1;
        }
    }
    count
}

/// Objects whose centres lie in the same part of an axis.
#[derive(Clone, Copy)]
struct Bin {
    bounds: Bounds,
    cost: f64,
    count: usize,
}

impl Bin {
    const EMPTY: Self = Self { bounds: Bounds::NONE, cost: 0.0, count: 0 };

    fn add(&mut self, other: &Self) {
        self.bounds = self.bounds.with(&other.bounds);
        self.cost += other.cost;
        self.count += other.count;
    }

    /// Half the surface times what its leaf would cost.
    fn weight(&self, costs: &Costs) -> f64 {
        self.bounds.surface() * costs.leaf(self.count, self.cost)
    }
}

/// Objects whose centres lie in a bin below `bin` go first.
struct Cut {
    axis: usize,
    bin: usize,
    low: f64,
    scale: f64,
    cost: f64,
}

impl Cut {
    /// The bin of a centre; of an axis along which there is no extent it is any.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // within the bins
    fn bin(c: f64, low: f64, scale: f64) -> usize {
        (((c - low) * scale) as usize).min(BINS - 1)
    }

    fn is_before(&self, solid: &Solid) -> bool {
        let c = solid.center().get(self.axis).copied().unwrap_or(self.low);
        Self::bin(c, self.low, self.scale) < self.bin
    }
}

/// The cheapest cut between two bins of the centres, along any axis; nothing where all centres are in one place.
#[allow(clippy::cast_precision_loss)] // sixteen
fn best_cut(solids: &[Solid], bounds: &Bounds, costs: &Costs) -> Option<Cut> {
    let centers = solids.iter().fold(Bounds::NONE, |b, s| b.with(&Bounds::about(s.center(), [0.0; 3])));
    let mut scales = centers.high;
    for (scale, low) in scales.iter_mut().zip(centers.low) {
        *scale = BINS as f64 / (*scale - low);
    }
    let mut bins = [[Bin::EMPTY; BINS]; 3];
    for solid in solids {
        let places = solid.center().into_iter().zip(centers.low).zip(scales);
        for (bins, ((c, low), scale)) in bins.iter_mut().zip(places) {
            if let Some(bin) = bins.get_mut(Cut::bin(c, low, scale)) {
                bin.add(&Bin { bounds: solid.bounds, cost: f64::from(solid.cost), count: 1 });
            }
        }
    }
    let surface = bounds.surface().max(f64::MIN_POSITIVE);
    let mut best: Option<Cut> = None;
    for (axis, ((bins, low), scale)) in bins.iter().zip(centers.low).zip(scales).enumerate() {
        if !scale.is_finite() {
            continue;
        }
        // The bins from each one on.
        let mut behind = [(0.0, 0); BINS];
        let mut gathered = Bin::EMPTY;
        for (behind, bin) in behind.iter_mut().zip(bins).rev() {
            gathered.add(bin);
            *behind = (if gathered.count > 0 { gathered.weight(costs) } else { 0.0 }, gathered.count);
        }
        let mut gathered = Bin::EMPTY;
        for (bin, (before, after)) in (1..BINS).zip(bins.iter().zip(behind.iter().skip(1))) {
            gathered.add(before);
            if gathered.count == 0 || after.1 == 0 {
                continue;
            }
            let cost = (gathered.weight(costs) + after.0) / surface;
            if best.as_ref().is_none_or(|best| cost < best.cost) {
                best = Some(Cut { axis, bin, low, scale, cost });
            }
        }
    }
    best
}
