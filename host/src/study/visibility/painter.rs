//! The painter: from far to near, each triangle over what is there. The order comes from a binary tree of planes (H. Fuchs, Z. Kedem and
//! B. Naylor, "On Visible Surface Generation by a Priori Tree Structures", SIGGRAPH 80), which cuts triangles where there is no order.
//!
//! A fragment of a triangle is that triangle and the planes that cut it, so no vertex is made and nothing is rounded. Where a fragment is
//! surely at one side of a plane, which its outline in `f64` tells, it is not cut.
//!
//! M. Newell, R. Newell and T. Sancha's sort by depth (1972) needs no tree: triangles are sorted by their farthest vertex, and each is compared
//! with those before it whose depths overlap its own, by five tests that end with planes. Where no order is found they must be cut too,
//! so it is not built here.
//!
//! There is an order of surfaces, but none of the points in which they touch, such as a corner of one on the face of another. So at a pixel whose
//! ray passes an edge of what is drawn or of what is there, exactly, depths are compared; these are counted as ties. At all other pixels
//! nothing is.

use super::integer::{Cover, Vector, View, pixels};
use super::outcome::{Counts, LeftOut, Outcome};

mod tree;

use tree::Tree;

/// The bit of an id whose ray passes an edge.
const EDGE: u32 = 1 << 31;

/// Draws from far to near.
///
/// # Errors
/// [`LeftOut`] if the triangles are cut into too many fragments.
pub fn painted(view: &View) -> Result<Outcome, LeftOut> {
    let tree = Tree::new(view)?;
    let mut painting = Painting { view, ids: view.blank(), tests: 0, cuts: 0, writes: 0, ties: 0 };
    let mut visits = 0;
    // All triangles turn their backs to the eye: what is on the side of the eye is before them.
    let mut stack = vec![Visit::Subtree(tree.root)];
    while let Some(visit) = stack.pop() {
        match visit {
            Visit::Subtree(place) => {
                if let Some(node) = tree.nodes.get(place as usize) {
                    visits += 1;
                    stack.extend([Visit::Subtree(node.near), Visit::Plane(place), Visit::Subtree(node.far)]);
                }
            }
            Visit::Plane(mut place) => {
                while let Some(node) = tree.nodes.get(place as usize) {
                    painting.fragment(&tree, node.id, node.cuts);
                    place = node.next;
                }
            }
        }
    }
    let Painting { ids, tests, cuts, writes, ties, .. } = painting;
    let counts = Counts::new()
        .step("planes", tree.planes)
        .step("visits", visits)
        .step("tests", tests)
        .step("cuts", cuts)
        .step("writes", writes)
        .step("compares", 0)
        .step("ties", ties)
        .note("splits", tree.splits)
        .note("fragments", tree.nodes.len() as u64);
    let ids = ids.into_iter().map(|id| id & !EDGE).collect();
    Ok(Outcome { ids, counts, bytes: tree.bytes(), areas: None })
}

/// What of the tree is still to be drawn.
enum Visit {
    Subtree(u32),
    /// The fragments in the plane of a node.
    Plane(u32),
}

struct Painting<'a> {
    view: &'a View,
    ids: Vec<u32>,
    tests: u64,
    cuts: u64,
    writes: u64,
    ties: u64,
}

impl Painting<'_> {
    fn fragment(&mut self, tree: &Tree, id: u32, cuts: u32) {
        let Some(triangle) = self.view.triangle(id) else { return };
        let width = self.view.raster.size.width();
        let planes: Vec<_> = tree
            .cuts(cuts)
            .filter_map(|cut| Some((triangle.meeting(self.view.triangle(cut.plane)?), cut.is_far)))
            .collect();
        for y in triangle.rows.clone() {
            let columns = triangle.columns.clone();
            for (x, held) in columns.clone().zip(pixels(&mut self.ids, width, y, columns)) {
                self.tests += 1;
                let ray = self.view.raster.ray(x, y);
                let mut cover = triangle.cover(ray);
                for (plane, is_far) in &planes {
                    if cover == Cover::Outside {
                        break;
                    }
                    self.cuts += 1;
                    let side = apply(*plane, ray);
                    cover = match side {
                        0 if *is_far => Cover::Outside,
                        0 => Cover::Edge,
                        _ if (side > 0) == *is_far => cover,
                        _ => Cover::Outside,
                    };
                }
                let mark = match cover {
                    Cover::Outside => continue,
                    Cover::Edge => EDGE,
                    Cover::Inside => 0,
                };
                if *held != 0 && (mark | *held) & EDGE != 0 {
                    self.ties += 1;
                    if !self.view.is_before(id, *held & !EDGE, ray) {
                        continue;
                    }
                }
                *held = id | mark;
                self.writes += 1;
            }
        }
    }
}

fn apply(plane: [i128; 3], ray: Vector) -> i128 {
    let [x, y, z] = ray.map(i128::from);
    plane[0] * x + plane[1] * y + plane[2] * z
}
