//! Builds the hierarchy of machines without a heap: the core's [`Bvh`], or none where one object after the other is as quick.
//!
//! Two are built and the one is kept that the heuristic finds cheaper: over the spheres in the order of their list, which costs
//! no more than nodes, and over all finite objects in an order of its own.

use rta_core::accelerator::{Bvh, Node};
use rta_core::scene::Object;
use rta_core::vector::Vector;

use super::bounds::Bounds;
use super::sah::{Costs, Tree, tree};
use super::solid::{Solid, reach, solids};
use crate::description::Description;
use crate::narrow::Narrow;
use crate::space::{difference, dot};

/// Fewer spheres than this, in the order of their list, are as quickly tried one after another.
const FEWEST_SPHERES: usize = 12;
/// Fewer finite objects of all kinds are as quickly tried one after another, by a smaller program.
const FEWEST: usize = 20;
/// What looking at a node costs, in spheres.
const NODE: f64 = 1.0;
/// What finding an object by its name costs, over one in a run of its list.
const NAMED: f64 = 0.25;
/// An order of its own takes memory, and program to find objects by it: it is worth that where it saves more than a tenth.
const WORTH: f64 = 1.1;
/// Longer runs than this are cut into parts of an eighth at least.
const LONG: usize = 256;
/// A pair of nodes, and objects one by one.
const COSTS: Costs = Costs { pair: 2.0 * NODE, object: 1.0 + NAMED, group: 0.0, at_once: 1, leaf: 8 };

/// A hierarchy in one number format; without nodes it is none.
#[derive(Clone, Debug)]
pub struct Built<S: Narrow> {
    /// Nodes in preorder.
    pub nodes: Vec<Node<S>>,
    /// What their runs are of; the list of spheres where it is empty.
    pub order: Vec<Object>,
}

impl<S: Narrow> Built<S> {
    const NONE: Self = Self { nodes: Vec::new(), order: Vec::new() };

    /// Returns the hierarchy, borrowed, if there is one.
    #[must_use]
    pub fn bvh(&self) -> Option<Bvh<'_, S>> {
        (!self.nodes.is_empty()).then(|| Bvh { nodes: &self.nodes, order: &self.order })
    }

    /// What a ray costs, in spheres, that passes through a sphere of the radius `scene`, squared, in which most objects lie: it
    /// meets a node that is smaller as often as that node's surface is, and then its two children are looked at, or the objects
    /// of its run.
    fn cost(&self, scene: f64, run: impl Fn(usize, usize) -> f64) -> f64 {
        let is_met = |node: &Node<S>| {
            let radius = node.radius.to_f64();
            (radius * radius / scene).min(1.0)
        };
        let costs = self.nodes.iter().zip(1..).map(|(node, next)| {
            let is_leaf = node.skip == next;
            let below = if is_leaf { run(node.first as usize, node.end as usize) } else { 2.0 * NODE };
            below * is_met(node)
        });
        NODE + costs.sum::<f64>()
    }
}

/// Returns the square of the radius of a sphere about most objects, however large a few of them are: in a ball that is evenly
/// filled, it is 5/3 of the mean square of the distances from the middle.
#[allow(clippy::cast_precision_loss)] // far fewer than 2^53
fn spread(solids: &[Solid]) -> f64 {
    let count = solids.len() as f64;
    let mut middle = [0.0; 3];
    for solid in solids {
        middle.iter_mut().zip(solid.center()).for_each(|(sum, c)| *sum += c / count);
    }
    let squares = solids.iter().map(|solid| {
        let away = difference(solid.center(), middle);
        dot(away, away)
    });
    (5.0 / 3.0 * squares.sum::<f64>() / count).max(f64::MIN_POSITIVE)
}

/// Builds the hierarchy of a scene; none where there are few objects, or where the number format has no room for it.
#[must_use]
pub fn build<S: Narrow>(scene: &Description) -> Built<S> {
    let mut solids = solids(scene);
    if u32::try_from(solids.len()).is_err() {
        return Built::NONE;
    }
    let cost = |solids: &[Solid]| solids.iter().map(|solid| f64::from(solid.cost)).sum::<f64>();
    let size = spread(&solids);
    let mut best = (cost(&solids), Built::NONE);
    let mut offer = |cost: f64, built: Built<S>| {
        if !built.nodes.is_empty() && cost < best.0 {
            best = (cost, built);
        }
    };
    if scene.spheres.len() >= FEWEST_SPHERES {
        let (spheres, others) = solids.split_at(scene.spheres.len().min(solids.len()));
        let built = over_spheres::<S>(scene, spheres);
        #[allow(clippy::cast_precision_loss)] // far fewer than 2^53
        let spheres = built.cost(size, |first, end| (end - first) as f64);
        offer(cost(others) + spheres, built);
    }
    if solids.len() >= FEWEST {
        let built = over_all::<S>(scene, &mut solids);
        let all =
            built.cost(size, |first, end| COSTS.object * cost(solids.get(first..end).unwrap_or_default()));
        offer(WORTH * all, built);
    }
    best.1
}

/// Runs that are still to be made into nodes, the first one last; or a node whose subtree is complete.
enum Task<T> {
    Run(T),
    Close(usize),
}

/// The nodes over the list of spheres, which is cut into runs and never sorted, so that what is equally near stays in the order
/// of the file (Goldsmith and Salmon 1987).
fn over_spheres<S: Narrow>(scene: &Description, spheres: &[Solid]) -> Built<S> {
    let mut built = Built::NONE;
    let mut tasks = vec![Task::Run((0, spheres.len()))];
    while let Some(task) = tasks.pop() {
        match task {
            Task::Close(number) => close(&mut built.nodes, number),
            Task::Run((first, end)) => {
                let Some(run) = spheres.get(first..end) else { continue };
                let Some(node) = node(scene, run, first, end) else { return Built::NONE };
                tasks.push(Task::Close(built.nodes.len()));
                built.nodes.push(node);
                if let Some(cut) = best_cut(run) {
                    tasks.push(Task::Run((first + cut, end)));
                    tasks.push(Task::Run((first, first + cut)));
                }
            }
        }
    }
    built
}

/// The nodes over all finite objects, sorted by the surface area heuristic; of two children, the one nearer the eye is first.
fn over_all<S: Narrow>(scene: &Description, solids: &mut [Solid]) -> Built<S> {
    let root = tree(solids, 0, 0, &COSTS);
    let mut sorted = Vec::with_capacity(solids.len());
    let mut built = Built::NONE;
    let mut tasks = vec![Task::Run(&root)];
    while let Some(task) = tasks.pop() {
        match task {
            Task::Close(number) => close(&mut built.nodes, number),
            Task::Run(tree) => {
                let (from, count) = tree.run();
                let run = solids.get(from..from + count).unwrap_or_default();
                let first = sorted.len();
                let Some(node) = node(scene, run, first, first + count) else { return Built::NONE };
                tasks.push(Task::Close(built.nodes.len()));
                built.nodes.push(node);
                match tree {
                    Tree::Leaf(..) => sorted.extend_from_slice(run),
                    Tree::Pair(_, pair) => {
                        let [one, other] = &**pair;
                        let away = |tree: &Tree| tree.bounds().distance(scene.camera.eye);
                        let (near, far) = if away(other) < away(one) { (other, one) } else { (one, other) };
                        tasks.push(Task::Run(far));
                        tasks.push(Task::Run(near));
                    }
                }
            }
        }
    }
    built.order = sorted.iter().map(|solid| solid.object).collect();
    solids.copy_from_slice(&sorted);
    built
}

fn number_of(index: usize) -> u32 {
    // There are fewer than twice as many nodes as objects; more than 2^31 objects do not come.
    u32::try_from(index).unwrap_or(u32::MAX)
}

/// Tells a node that all nodes below it are there.
fn close<S: Narrow>(nodes: &mut [Node<S>], number: usize) {
    let skip = number_of(nodes.len());
    if let Some(node) = nodes.get_mut(number) {
        node.skip = skip;
    }
}

/// The node of a run: centre and radius rounded so that the objects lie within, as they are in the format.
fn node<S: Narrow>(scene: &Description, run: &[Solid], first: usize, end: usize) -> Option<Node<S>> {
    let center = run.iter().fold(Bounds::NONE, |bounds, solid| bounds.with(&solid.bounds)).center();
    let radius = run.iter().map(|solid| reach(scene, solid.object, center)).fold(0.0, f64::max);
    let farthest = center.iter().fold(radius, |most, c| most.max(c.abs()));
    // Half an LSB of each coordinate and radius, or some units of a float's last place.
    let radius = radius + 1e-6 * (radius + farthest) + S::SMALLEST_RADIUS / 4.0;
    if farthest + radius > S::largest() / 2.0 {
        return None;
    }
    let [x, y, z] = center.map(S::length);
    let (first, end) = (number_of(first), number_of(end));
    Some(Node { center: Vector::new(x, y, z), radius: S::length(radius), first, end, skip: 0 })
}

/// Where a run is best cut in two; nothing where it is best left whole.
#[allow(clippy::cast_precision_loss)] // far fewer than 2^53
fn best_cut(run: &[Solid]) -> Option<usize> {
    // The boxes of the last 1, 2, 3 ... spheres.
    let mut behind = Vec::with_capacity(run.len());
    let mut bounds = Bounds::NONE;
    for solid in run.iter().rev() {
        bounds = bounds.with(&solid.bounds);
        behind.push(bounds.diagonal());
    }
    let whole = bounds.diagonal();
    let (mut bounds, mut best) = (Bounds::NONE, (None, whole * run.len() as f64));
    // Cutting a few spheres off a long list again and again would take time with the square of its length.
    let least = if run.len() > LONG { run.len() / 8 } else { 1 };
    for (cut, solid) in (1..run.len()).zip(run) {
        bounds = bounds.with(&solid.bounds);
        let after = run.len() - cut;
        if cut.min(after) < least {
            continue;
        }
        let last = behind.get(after - 1).copied().unwrap_or(whole);
        let cost = 2.0 * NODE * whole + bounds.diagonal() * cut as f64 + last * after as f64;
        if cost < best.1 {
            best = (Some(cut), cost);
        }
    }
    best.0
}

#[cfg(test)]
mod tests;
