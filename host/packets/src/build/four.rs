//! Nodes of four from a binary tree.

use rta_scenes::accelerator::sah::Tree;

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
