//! Builds the hierarchy over the spheres of a scene, top down, by the surface area heuristic (Goldsmith and Salmon 1987).
//!
//! The list is cut into runs and never sorted, so that what is equally near stays in the order of the file.

use rta_core::hierarchy::Node;
use rta_core::vector::Vector;

use super::Narrow;
use super::bounds::Bounds;
use crate::description::Sphere;

/// Fewer spheres than this are as quickly tried one after another.
const FEWEST: usize = 12;
/// What looking at a node costs, in spheres.
const NODE: f64 = 1.0;

/// Longer runs than this are cut into parts of an eighth at least.
const LONG: usize = 256;

/// The nodes in preorder; none where there are few spheres, or where the number format has no room for them.
pub(super) fn build<S: Narrow>(spheres: &[Sphere]) -> Vec<Node<S>> {
    let mut nodes = Vec::new();
    if spheres.len() < FEWEST || u32::try_from(spheres.len()).is_err() {
        return nodes;
    }
    // Runs that are still to be made into nodes, the first one last; or a node whose subtree is complete.
    enum Task {
        Run(usize, usize),
        Close(usize),
    }
    let mut tasks = vec![Task::Run(0, spheres.len())];
    while let Some(task) = tasks.pop() {
        match task {
            Task::Close(number) => {
                let skip = number_of(nodes.len());
                if let Some(node) = nodes.get_mut(number) {
                    let node: &mut Node<S> = node;
                    node.skip = skip;
                }
            }
            Task::Run(first, end) => {
                let Some(run) = spheres.get(first..end) else { continue };
                let Some(node) = node(run, first, end) else { return Vec::new() };
                tasks.push(Task::Close(nodes.len()));
                nodes.push(node);
                if let Some(cut) = best_cut(run) {
                    tasks.push(Task::Run(first + cut, end));
                    tasks.push(Task::Run(first, first + cut));
                }
            }
        }
    }
    nodes
}

fn number_of(index: usize) -> u32 {
    // There are fewer than twice as many nodes as spheres; more than 2^31 spheres do not come.
    u32::try_from(index).unwrap_or(u32::MAX)
}

/// The node of a run: centre and radius rounded so that the spheres lie within, as they are in the format.
fn node<S: Narrow>(run: &[Sphere], first: usize, end: usize) -> Option<Node<S>> {
    let center = run.iter().fold(Bounds::NONE, Bounds::with_sphere).center();
    let reach = |sphere: &Sphere| {
        let square: f64 = sphere.position.iter().zip(center).map(|(c, of)| (c - of) * (c - of)).sum();
        square.sqrt() + sphere.radius
    };
    let radius = run.iter().map(reach).fold(0.0, f64::max);
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
fn best_cut(run: &[Sphere]) -> Option<usize> {
    // The boxes of the last 1, 2, 3 ... spheres.
    let mut behind = Vec::with_capacity(run.len());
    let mut bounds = Bounds::NONE;
    for sphere in run.iter().rev() {
        bounds = bounds.with_sphere(sphere);
        behind.push(bounds.diagonal());
    }
    let whole = bounds.diagonal();
    let (mut bounds, mut best) = (Bounds::NONE, (None, whole * count(run.len())));
    // Cutting a few spheres off a long list again and again would take time with the square of its length.
    let least = if run.len() > LONG { run.len() / 8 } else { 1 };
    for (cut, sphere) in (1..run.len()).zip(run) {
        bounds = bounds.with_sphere(sphere);
        let after = run.len() - cut;
        if cut.min(after) < least {
            continue;
        }
        let last = behind.get(after - 1).copied().unwrap_or(whole);
        let cost = 2.0 * NODE * whole + bounds.diagonal() * count(cut) + last * count(after);
        if cost < best.1 {
            best = (Some(cut), cost);
        }
    }
    best.0
}

#[allow(clippy::cast_precision_loss)] // far fewer than 2^53
fn count(spheres: usize) -> f64 {
    spheres as f64
}
