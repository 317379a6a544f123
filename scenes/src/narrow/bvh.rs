//! Builds the hierarchy of boxes: top down by the surface area heuristic over sixteen bins (I. Wald, "On fast Construction
//! of SAH-based Bounding Volume Hierarchies", 2007), in pairs; then pairs of pairs become nodes of four.

use rta_core::bvh::{Boxes, Child, Item, MAX_DEPTH};

use super::Narrow;
use super::bounds::Bounds;
use crate::description::Description;
use crate::space::{difference, length};

/// Fewer objects than this are as quickly tried one after another, where a machine has lanes.
const FEWEST: usize = 4;
/// The same where it has none, or by a hierarchy of spheres.
const FEWEST_BY_ONE: usize = 100;
/// The same where there are cones or triangles.
const FEWEST_OTHERS: usize = 8;
/// What testing the boxes of a pair costs, in spheres.
const PAIR: f64 = 0.6;
/// The most objects in a leaf.
const LEAF: usize = 8;
const BINS: usize = 16;
/// Levels of pairs: two make one of nodes.
const MAX_PAIRS: usize = 2 * MAX_DEPTH - 1;

/// A hierarchy in one number format.
pub(super) struct Built<S: rta_core::Scalar> {
    pub(super) nodes: Vec<Boxes<S>>,
    pub(super) items: Vec<Item>,
    pub(super) size: S,
}

/// An object.
#[derive(Clone, Copy)]
struct Solid {
    bounds: Bounds,
    cost: f32,
    item: Item,
}

impl Solid {
    fn center(&self) -> [f64; 3] {
        self.bounds.center()
    }
}

enum Tree {
    /// Some objects that lie side by side: the first, and how many.
    Leaf(Bounds, usize, usize),
    Pair(Bounds, Box<[Tree; 2]>),
}

impl Tree {
    const fn bounds(&self) -> &Bounds {
        match self {
            Self::Leaf(bounds, ..) | Self::Pair(bounds, _) => bounds,
        }
    }
}

/// The hierarchy of a scene; none where there are few objects, or where the number format has no room for it.
pub(super) fn build<S: Narrow>(scene: &Description) -> Built<S> {
    let none = Built { nodes: Vec::new(), items: Vec::new(), size: S::ZERO };
    let count = scene.spheres.len() + scene.ellipsoids.len() + scene.cones.len() + scene.triangles.len();
    if (if S::LANES { count < FEWEST } else { !is_worthwhile(scene) }) || count > Child::MAX_ITEMS as usize {
        return none;
    }
    let mut solids = solids(scene);
    let whole = solids.iter().fold(Bounds::NONE, |bounds, solid| bounds.with(&solid.bounds));
    if whole.largest() > S::largest() / 2.0 {
        return none;
    }
    let tree = tree(&mut solids, 0, 0);
    let mut built = Built { size: S::length(whole.largest()), ..none };
    let depth = emit(&tree, &solids, true, &mut built);
    if depth > MAX_DEPTH {
        built.nodes.clear();
        built.items.clear();
        emit(&tree, &solids, false, &mut built);
    }
    built
}

/// Whether boxes save time on a machine without lanes.
pub(super) fn is_worthwhile(scene: &Description) -> bool {
    let others = scene.cones.len() + scene.triangles.len();
    let count = scene.spheres.len() + scene.ellipsoids.len() + others;
    count >= if others > 0 { FEWEST_OTHERS } else { FEWEST_BY_ONE }
}

fn solids(scene: &Description) -> Vec<Solid> {
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

/// The tree over some objects, which follow `before` others, `level` pairs below the root.
fn tree(solids: &mut [Solid], before: usize, level: usize) -> Tree {
    let bounds = solids.iter().fold(Bounds::NONE, |bounds, solid| bounds.with(&solid.bounds));
    let whole: f64 = solids.iter().map(|solid| f64::from(solid.cost)).sum();
    // Halves from here on fit into what levels are left.
    let halves = usize::BITS as usize - solids.len().leading_zeros() as usize;
    let cut = if level + halves >= MAX_PAIRS { None } else { best_cut(solids, &bounds) };
    let middle = match cut {
        Some(cut) if cut.cost + PAIR < whole || solids.len() > LEAF => {
            partition(solids, |solid| cut.is_before(solid))
        }
        _ if solids.len() <= LEAF => return Tree::Leaf(bounds, before, solids.len()),
        _ => halve(solids),
    };
    // A cut that rounding has undone.
    let middle = if middle == 0 || middle == solids.len() { halve(solids) } else { middle };
    let (first, second) = solids.split_at_mut(middle);
    let pair = [tree(first, before, level + 1), tree(second, before + middle, level + 1)];
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
}

impl Bin {
    const EMPTY: Self = Self { bounds: Bounds::NONE, cost: 0.0 };

    fn add(&mut self, bounds: &Bounds, cost: f64) {
        self.bounds = self.bounds.with(bounds);
        self.cost += cost;
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
fn best_cut(solids: &[Solid], bounds: &Bounds) -> Option<Cut> {
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
                bin.add(&solid.bounds, f64::from(solid.cost));
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
        let mut behind = [(0.0, 0.0); BINS];
        let mut gathered = Bin::EMPTY;
        for (behind, bin) in behind.iter_mut().zip(bins).rev() {
            gathered.add(&bin.bounds, bin.cost);
            *behind = (gathered.bounds.surface(), gathered.cost);
        }
        let mut gathered = Bin::EMPTY;
        for (bin, (before, after)) in (1..BINS).zip(bins.iter().zip(behind.iter().skip(1))) {
            gathered.add(&before.bounds, before.cost);
            if gathered.cost == 0.0 || after.1 == 0.0 {
                continue;
            }
            let cost = (gathered.bounds.surface() * gathered.cost + after.0 * after.1) / surface;
            if best.as_ref().is_none_or(|best| cost < best.cost) {
                best = Some(Cut { axis, bin, low, scale, cost });
            }
        }
    }
    best
}

/// Writes a tree as nodes of four, preorder, and says how many levels they have. The largest of a node's children are
/// opened until there are four; or else each of the two, once, so that a node is two levels of the tree.
fn emit<S: Narrow>(tree: &Tree, solids: &[Solid], by_size: bool, built: &mut Built<S>) -> usize {
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
    let number = built.nodes.len();
    let mut planes = [[[S::ZERO; 4]; 2]; 3];
    for (slot, child) in children.iter().enumerate() {
        let Bounds { low, high } = child.bounds();
        for (planes, sides) in planes.iter_mut().zip(low.iter().zip(high)) {
            for (places, &side) in planes.iter_mut().zip([sides.0, sides.1]) {
                // What is not used is a copy of the last: no number in it is out of the scene.
                for place in places.iter_mut().skip(slot) {
                    *place = S::length(side);
                }
            }
        }
    }
    built.nodes.push(Boxes { planes, children: [Child::EMPTY; 4] });
    let as_number = |index: usize| u32::try_from(index).unwrap_or(u32::MAX);
    let mut kinds = [Child::EMPTY; 4];
    for (kind, child) in kinds.iter_mut().zip(&children) {
        if let Tree::Leaf(_, first, count) = child {
            let run = solids.iter().skip(*first).take(*count);
            *kind = Child::leaf(as_number(built.items.len()), as_number(*count));
            built.items.extend(run.map(|solid| solid.item));
        }
    }
    let mut depth = 0;
    for (kind, child) in kinds.iter_mut().zip(&children) {
        if let Tree::Pair(..) = child {
            *kind = Child::node(as_number(built.nodes.len()));
            depth = depth.max(emit(child, solids, by_size, built));
        }
    }
    if let Some(node) = built.nodes.get_mut(number) {
        node.children = kinds;
    }
    depth + 1
}
