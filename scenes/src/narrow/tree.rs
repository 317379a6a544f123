//! The binary tree that both hierarchies of boxes are made from: top down by the surface area heuristic over sixteen bins
//! (I. Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", 2007).

use rta_core::bvh::{Item, MAX_DEPTH};

use super::bounds::Bounds;
use crate::description::Description;
use crate::space::{difference, length};

const BINS: usize = 16;
/// Levels of pairs: two make one level of nodes of four.
const MAX_PAIRS: usize = 2 * MAX_DEPTH - 1;

/// What a search costs, in spheres that are tried one by one.
#[derive(Clone, Copy)]
pub(super) struct Costs {
    /// Testing the boxes of a pair.
    pub(super) pair: f64,
    /// Of what an object costs that is not a sphere but as many, the part that is spent where its leaf is looked at.
    pub(super) object: f64,
    /// Looking at as many objects of a leaf as are looked at at once, whatever they are.
    pub(super) pack: f64,
    /// How many that are.
    pub(super) at_once: usize,
    /// The most objects in a leaf.
    pub(super) leaf: usize,
}

/// An object.
#[derive(Clone, Copy)]
pub(super) struct Solid {
    pub(super) bounds: Bounds,
    cost: f32,
    pub(super) item: Item,
}

impl Solid {
    /// A sphere, or what costs as much.
    pub(super) fn sphere(position: [f64; 3], radius: f64, item: Item) -> Self {
        Self { bounds: Bounds::about(position, [radius; 3]), cost: 1.0, item }
    }

    fn center(&self) -> [f64; 3] {
        self.bounds.center()
    }
}

pub(super) enum Tree {
    /// Some objects that lie side by side: the first, and how many.
    Leaf(Bounds, usize, usize),
    Pair(Bounds, Box<[Tree; 2]>),
}

impl Tree {
    pub(super) const fn bounds(&self) -> &Bounds {
        match self {
            Self::Leaf(bounds, ..) | Self::Pair(bounds, _) => bounds,
        }
    }
}

/// All finite objects of a scene.
pub(super) fn solids(scene: &Description) -> Vec<Solid> {
    let number = |i: usize| u32::try_from(i).unwrap_or(u32::MAX);
    let solid = |bounds: Bounds, cost: f32, item: Item| Solid { bounds, cost, item };
    let spheres = scene
        .spheres
        .iter()
        .enumerate()
        .map(|(i, s)| solid(Bounds::about(s.position, [s.radius; 3]), 1.0, Item::Sphere(number(i))));
    let ellipsoids = scene
        .ellipsoids
        .iter()
        .enumerate()
        .map(|(i, e)| solid(Bounds::about(e.position, e.radii), 3.0, Item::Ellipsoid(number(i))));
    let cones = scene.cones.iter().enumerate().map(|(i, c)| {
        // A disc reaches as far along an axis as that is across the disc's own.
        let way = difference(c.apex, c.base);
        let height = length(way);
        let disc = |radius: f64| {
            way.map(|along| radius * (1.0 - (along / height) * (along / height)).max(0.0).sqrt())
        };
        let ends = [Bounds::about(c.base, disc(c.base_radius)), Bounds::about(c.apex, disc(c.apex_radius))];
        let [base, apex] = ends;
        solid(base.with(&apex), 3.0, Item::Cone(number(i)))
    });
    let triangles = scene.triangles.iter().enumerate().map(|(i, t)| {
        let corner = |bounds: Bounds, v: &[f64; 3]| bounds.with(&Bounds::about(*v, [0.0; 3]));
        solid(t.vertices.iter().fold(Bounds::NONE, corner), 1.5, Item::Triangle(number(i)))
    });
    spheres.chain(ellipsoids).chain(cones).chain(triangles).collect()
}

impl Costs {
    /// What looking at a leaf costs of so many objects that cost so much together.
    #[allow(clippy::cast_precision_loss)] // few
    fn leaf(&self, count: usize, objects: f64) -> f64 {
        self.object * objects + self.pack * count.div_ceil(self.at_once) as f64
    }
}

/// The tree over some objects, which follow `before` others, `level` pairs below the root.
pub(super) fn tree(solids: &mut [Solid], before: usize, level: usize, costs: &Costs) -> Tree {
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

/// What a node of four holds: the largest of its children are opened until there are four; or else each of the two, once,
/// so that a node is two levels of the tree.
pub(super) fn four(tree: &Tree, by_size: bool) -> Vec<&Tree> {
    let mut children: Vec<&Tree> = vec![tree];
    let opened = |children: &mut Vec<&Tree>, at: usize| {
        if let Some(Tree::Pair(_, pair)) = children.get(at).copied() {
            let [first, second] = &**pair;
            children.splice(at..=at, [first, second]);
        }
    };
    opened(&mut children, 0);
    if by_size {
        while children.len() < 4 {
            let pairs = children.iter().enumerate().filter(|(_, child)| matches!(child, Tree::Pair(..)));
            let sizes = pairs.map(|(at, child)| (at, child.bounds().surface()));
            let Some((at, _)) = sizes.max_by(|a, b| a.1.total_cmp(&b.1)) else { break };
            opened(&mut children, at);
        }
    } else {
        for at in (0..children.len()).rev() {
            opened(&mut children, at);
        }
    }
    children
}
