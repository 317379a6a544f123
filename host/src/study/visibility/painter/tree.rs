//! The tree of planes.

use core::cmp::Ordering;

use crate::study::visibility::integer::{Triangle, View, number};
use crate::study::visibility::outcome::LeftOut;

/// The number of no node and of no cut.
const NONE: u32 = u32::MAX;

/// The most fragments: 96 MB of them.
const MOST: u64 = 1 << 22;

/// The most tests of a fragment against a plane: some seconds of them.
const MOST_TESTS: u64 = 1 << 27;

/// The triangles whose planes are tried, of which the one that cuts least is taken.
const TRIED: usize = 5;

/// How near to a cut, in parts of the picture's plane at distance 1, the outline of a fragment may be and count as cut: more than an outline can
/// be off by all its roundings.
const SLACK: f64 = 1.0 / (1 << 30) as f64;

/// A fragment: a triangle and what cuts it. Those in one plane are one list.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// The triangle.
    pub(super) id: u32,
    /// The last of its cuts.
    pub(super) cuts: u32,
    /// The next fragment in the plane, of a lower number.
    pub(super) next: u32,
    /// The subtree behind the plane, of the first fragment in it.
    pub(super) far: u32,
    /// The subtree on the side of the eye.
    pub(super) near: u32,
}

/// A plane that cuts a fragment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    /// The triangle in the plane.
    pub(super) plane: u32,
    /// Whether the fragment is behind it; else it is on the side of the eye, with the line in the plane itself.
    pub(super) is_far: bool,
    /// The cut before.
    before: u32,
}

/// The tree.
#[derive(Debug)]
pub(super) struct Tree {
    pub(super) nodes: Vec<Node>,
    cuts: Vec<Cut>,
    pub(super) root: u32,
    /// Tests of a fragment against a plane.
    pub(super) planes: u64,
    /// Fragments that were cut in two.
    pub(super) splits: u64,
}

/// A fragment that is not in the tree yet.
struct Fragment<'a> {
    id: u32,
    triangle: &'a Triangle,
    cuts: u32,
    /// A polygon around it where its rays meet the plane at distance 1, a little larger than it is.
    outline: Vec<[f64; 2]>,
}

/// How a fragment lies to a plane.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    Far,
    Near,
    Within,
    Cut,
}

impl Tree {
    pub(super) fn new(view: &View) -> Result<Self, LeftOut> {
        let mut tree = Self { nodes: Vec::new(), cuts: Vec::new(), root: NONE, planes: 0, splits: 0 };
        let all = view.each().map(|(id, triangle)| Fragment {
            id,
            triangle,
            cuts: NONE,
            outline: outline(triangle),
        });
        let mut work = vec![(all.collect::<Vec<_>>(), None::<(u32, bool)>)];
        while let Some((fragments, parent)) = work.pop() {
            let Some(root) = tree.best(&fragments) else { continue };
            let place = number(tree.nodes.len());
            match parent.map(|(node, is_far)| (tree.nodes.get_mut(node as usize), is_far)) {
                Some((Some(node), true)) => node.far = place,
                Some((Some(node), false)) => node.near = place,
                _ => tree.root = place,
            }
            let (mut far, mut near, mut within) = (Vec::new(), Vec::new(), Vec::new());
            for fragment in fragments {
                tree.planes += 1;
                match fragment.place(root.1) {
                    Place::Far => far.push(fragment),
                    Place::Near => near.push(fragment),
                    Place::Within => within.push((fragment.id, fragment.cuts)),
                    Place::Cut => {
                        tree.splits += 1;
                        far.push(tree.part(&fragment, root, true));
                        near.push(tree.part(&fragment, root, false));
                    }
                }
            }
            tree.add(within);
            let count = tree.nodes.len() + far.len() + near.len();
            let waiting: usize = work.iter().map(|(fragments, _)| fragments.len()).sum();
            LeftOut::check("fragments", (count + waiting) as u64, MOST)?;
            LeftOut::check("tests of a fragment against a plane", tree.planes, MOST_TESTS)?;
            work.extend([(far, Some((place, true))), (near, Some((place, false)))]);
        }
        Ok(tree)
    }

    /// Adds the fragments in one plane, the one of the lowest number last, as it is to be drawn.
    fn add(&mut self, mut within: Vec<(u32, u32)>) {
        within.sort_unstable_by(|a, b| b.cmp(a));
        let count = within.len();
        for (place, (id, cuts)) in within.into_iter().enumerate() {
            let next = if place + 1 < count { number(self.nodes.len() + 1) } else { NONE };
            self.nodes.push(Node { id, cuts, next, far: NONE, near: NONE });
        }
    }

    /// Returns the triangle whose plane cuts the fewest of the fragments, of some that are tried, and of equal ones the one with as many behind as
    /// before it.
    fn best<'a>(&mut self, fragments: &[Fragment<'a>]) -> Option<(u32, &'a Triangle)> {
        let tried = TRIED.min(fragments.len());
        let candidates = (0..tried).filter_map(|number| fragments.get(number * fragments.len() / tried));
        if tried <= 1 {
            return fragments.first().map(|fragment| (fragment.id, fragment.triangle));
        }
        let rated = candidates.map(|candidate| {
            self.planes += fragments.len() as u64;
            let (mut cut, mut far, mut near) = (0_usize, 0_usize, 0_usize);
            for fragment in fragments {
                match fragment.place(candidate.triangle) {
                    Place::Cut => cut += 1,
                    Place::Far => far += 1,
                    Place::Near => near += 1,
                    Place::Within => {}
                }
            }
            ((cut, far.abs_diff(near)), (candidate.id, candidate.triangle))
        });
        rated.min_by_key(|(rating, _)| *rating).map(|(_, plane)| plane)
    }

    /// Returns the part of a fragment on one side of a plane.
    fn part<'a>(&mut self, of: &Fragment<'a>, plane: (u32, &Triangle), is_far: bool) -> Fragment<'a> {
        self.cuts.push(Cut { plane: plane.0, is_far, before: of.cuts });
        let side = if is_far { 1.0 } else { -1.0 };
        let line = line(of.triangle, plane.1).map(|c| c * side);
        let outline = clipped(&of.outline, line);
        Fragment { cuts: number(self.cuts.len() - 1), outline, ..*of }
    }

    /// Returns the cuts of a fragment, from the last.
    pub(super) fn cuts(&self, last: u32) -> impl Iterator<Item = &Cut> {
        let mut place = last;
        core::iter::from_fn(move || {
            let cut = self.cuts.get(place as usize)?;
            place = cut.before;
            Some(cut)
        })
    }

    /// Returns the bytes of the tree.
    pub(super) const fn bytes(&self) -> u64 {
        (size_of::<Node>() * self.nodes.len() + size_of::<Cut>() * self.cuts.len()) as u64
    }
}

impl Fragment<'_> {
    /// Returns how it lies to the plane of a triangle.
    fn place(&self, plane: &Triangle) -> Place {
        let sides = self.triangle.vertices.map(|vertex| plane.side(vertex));
        match [Ordering::Greater, Ordering::Less].map(|side| sides.contains(&side)) {
            [false, false] => return Place::Within,
            [true, false] => return Place::Far,
            [false, true] => return Place::Near,
            [true, true] if self.outline.is_empty() => return Place::Cut,
            [true, true] => {}
        }
        let line = line(self.triangle, plane);
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for height in self.outline.iter().map(|place| height(line, *place)) {
            (least, most) = (least.min(height), most.max(height));
        }
        if least > SLACK {
            Place::Far
        } else if most < -SLACK {
            Place::Near
        } else {
            Place::Cut
        }
    }
}

/// Returns the line in which a plane meets that of a triangle, as seen from the eye: `a u + b v + c`, above 0 behind the plane, with a and b of the
/// length 1 or, where it is far outside the picture, c.
fn line(triangle: &Triangle, plane: &Triangle) -> [f64; 3] {
    let [a, b, c] = triangle.meeting(plane).map(|c| c as f64);
    let size = a.hypot(b).max(c.abs() / 16.0);
    if size > 0.0 { [a / size, b / size, c / size] } else { [0.0; 3] }
}

fn height([a, b, c]: [f64; 3], [u, v]: [f64; 2]) -> f64 {
    a * u + b * v + c
}

/// Returns a polygon around a triangle.
fn outline(triangle: &Triangle) -> Vec<[f64; 2]> {
    let places = triangle.vertices.map(|[x, y, z]| [x as f64 / z as f64, y as f64 / z as f64]);
    let [us, vs] = [places.map(|place| place[0]), places.map(|place| place[1])];
    let bounds = |c: [f64; 3]| {
        let least = c.into_iter().fold(f64::INFINITY, f64::min);
        let most = c.into_iter().fold(f64::NEG_INFINITY, f64::max);
        [least - SLACK, most + SLACK]
    };
    let ([left, right], [bottom, top]) = (bounds(us), bounds(vs));
    let frame = vec![[left, bottom], [right, bottom], [right, top], [left, top]];
    triangle.sides.iter().fold(frame, |outline, side| {
        let [a, b, c] = side.normal.map(|c| c as f64);
        let size = a.hypot(b).max(c.abs() / 16.0);
        clipped(&outline, [a / size, b / size, c / size])
    })
}

/// Returns what of a polygon is at most [`SLACK`] below a line.
fn clipped(outline: &[[f64; 2]], line: [f64; 3]) -> Vec<[f64; 2]> {
    let after = outline.iter().cycle().skip(1);
    let mut clipped = Vec::with_capacity(outline.len() + 1);
    for (&from, &to) in outline.iter().zip(after) {
        let [start, end] = [from, to].map(|place| height(line, place) + SLACK);
        if start >= 0.0 {
            clipped.push(from);
        }
        if (start >= 0.0) != (end >= 0.0) {
            let part = start / (start - end);
            clipped.push([from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])]);
        }
    }
    clipped
}
