//! Builds the hierarchy of boxes in the picture's own format, for machines without lanes.

use rta_core::bvh::{Boxes, Child, Item, MAX_DEPTH};

use super::Narrow;
use super::bounds::Bounds;
use super::tree::{Costs, Solid, Tree, four, solids, tree};
use crate::description::Description;

/// Fewer objects than this are as quickly tried one after another, or by a hierarchy of spheres.
const FEWEST: usize = 100;
/// The same where there are cones or triangles.
const FEWEST_OTHERS: usize = 8;
/// Objects are tried one by one.
const COSTS: Costs = Costs { pair: 0.6, object: 1.0, pack: 0.0, at_once: 1, leaf: 8 };

/// A hierarchy in one number format.
pub(super) struct Built<S: rta_core::Scalar> {
    pub(super) nodes: Vec<Boxes<S>>,
    pub(super) items: Vec<Item>,
    pub(super) size: S,
}

/// The hierarchy of a scene; none where there are few objects, or where the number format has no room for it.
pub(super) fn build<S: Narrow>(scene: &Description) -> Built<S> {
    let none = Built { nodes: Vec::new(), items: Vec::new(), size: S::ZERO };
    let mut solids = solids(scene);
    if !is_worthwhile(scene) || solids.len() > Child::MAX_ITEMS as usize {
        return none;
    }
    let whole = solids.iter().fold(Bounds::NONE, |bounds, solid| bounds.with(&solid.bounds));
    if whole.largest() > S::largest() / 2.0 {
        return none;
    }
    let tree = tree(&mut solids, 0, 0, &COSTS);
    let mut built = Built { size: S::length(whole.largest()), ..none };
    let depth = emit(&tree, &solids, true, &mut built);
    if depth > MAX_DEPTH {
        built.nodes.clear();
        built.items.clear();
        emit(&tree, &solids, false, &mut built);
    }
    built
}

/// Whether boxes save time.
pub(super) fn is_worthwhile(scene: &Description) -> bool {
    let others = scene.cones.len() + scene.triangles.len();
    let count = scene.spheres.len() + scene.ellipsoids.len() + others;
    count >= if others > 0 { FEWEST_OTHERS } else { FEWEST }
}

/// Writes a tree as nodes of four, preorder, and says how many levels they have.
fn emit<S: Narrow>(tree: &Tree, solids: &[Solid], by_size: bool, built: &mut Built<S>) -> usize {
    let children = four(tree, by_size);
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
