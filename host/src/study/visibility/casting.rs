//! Ray casting (A. Appel, "Some Techniques for Shading Machine Renderings of Solids", 1968): pixel by pixel, the nearest of all triangles; and
//! the same with a hierarchy of boxes, which leaves most triangles alone.

use super::integer::{Cover, Triangle, Vector, View, dot, number};
use super::outcome::{Counts, LeftOut, Outcome, sorting};

/// The most tests of a ray against a triangle: some seconds of them.
const MOST_TESTS: u64 = 1 << 29;

/// The most triangles in a leaf of the hierarchy.
const LEAF: usize = 4;

/// Draws by testing every triangle for every pixel.
///
/// # Errors
/// [`LeftOut`] for more than 2^29 tests.
pub fn exhaustive(view: &View) -> Result<Outcome, LeftOut> {
    let tests = view.raster.size.pixels() as u64 * view.triangles.len() as u64;
    LeftOut::check("tests", tests, MOST_TESTS)?;
    let mut compares = 0;
    let ids = cast(view, |ray| {
        view.each().fold(0, |nearest, (id, triangle)| {
            let is_met = triangle.cover(ray) != Cover::Outside;
            compares += u64::from(is_met);
            if is_met && view.is_before(id, nearest, ray) { id } else { nearest }
        })
    });
    let counts = Counts::new().step("tests", tests).step("compares", compares);
    Ok(Outcome { ids, counts, bytes: 0, areas: None })
}

/// Draws by a hierarchy of boxes: those that a ray misses, and those behind what it has met, are left alone.
///
/// # Errors
/// None.
pub fn by_hierarchy(view: &View) -> Result<Outcome, LeftOut> {
    let hierarchy = Hierarchy::new(view);
    let (mut boxes, mut tests, mut compares) = (0, 0, 0);
    let mut stack = Vec::new();
    let ids = cast(view, |ray| {
        let mut nearest = 0;
        stack.extend(hierarchy.root());
        while let Some(node) = stack.pop().and_then(|place: u32| hierarchy.nodes.get(place as usize)) {
            boxes += 1;
            if !node.is_met(ray, view.triangle(nearest)) {
                continue;
            }
            match node.content {
                // The last one in is looked at first.
                Content::Children { near, far } => stack.extend([far, near]),
                Content::Leaf { first, end } => {
                    for &id in hierarchy.ids.get(first as usize..end as usize).unwrap_or_default() {
                        tests += 1;
                        let is_met = view.triangle(id).is_some_and(|own| own.cover(ray) != Cover::Outside);
                        compares += u64::from(is_met);
                        if is_met && view.is_before(id, nearest, ray) {
                            nearest = id;
                        }
                    }
                }
            }
        }
        nearest
    });
    let bytes = (size_of::<Node>() * hierarchy.nodes.len() + 4 * hierarchy.ids.len()) as u64;
    let counts = Counts::new()
        .step("sorting", hierarchy.sorting)
        .step("boxes", boxes)
        .step("tests", tests)
        .step("compares", compares);
    Ok(Outcome { ids, counts, bytes, areas: None })
}

/// Returns the ids that the rays of all pixels come back with.
fn cast(view: &View, mut seen: impl FnMut(Vector) -> u32) -> Vec<u32> {
    let (columns, rows) = (view.raster.size.width(), view.raster.size.height());
    let places = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
    places.map(|(x, y)| seen(view.raster.ray(x, y))).collect()
}

/// A box around triangles.
struct Node {
    least: Vector,
    most: Vector,
    content: Content,
}

/// What is in the box of a node.
enum Content {
    Children {
        near: u32,
        far: u32,
    },
    /// A range of the hierarchy's ids.
    Leaf {
        first: u32,
        end: u32,
    },
}

/// A binary tree of boxes.
struct Hierarchy {
    nodes: Vec<Node>,
    ids: Vec<u32>,
    sorting: u64,
}

impl Hierarchy {
    fn new(view: &View) -> Self {
        let mut ids: Vec<_> = view.each().map(|(id, _)| id).collect();
        let (mut nodes, mut sorts) = (Vec::new(), 0);
        if !ids.is_empty() {
            build(view, &mut ids, 0, &mut nodes, &mut sorts);
        }
        Self { nodes, ids, sorting: sorts }
    }

    /// Returns the number of the root, if there is one.
    fn root(&self) -> Option<u32> {
        self.nodes.len().checked_sub(1).map(number)
    }
}

/// Adds the tree of `ids`, which begin at the place `first` of all, and returns its root, which is its last node.
fn build(view: &View, ids: &mut [u32], first: usize, nodes: &mut Vec<Node>, sorts: &mut u64) -> u32 {
    let (mut least, mut most) = ([i64::MAX; 3], [i64::MIN; 3]);
    for [x, y, z] in ids.iter().filter_map(|id| view.triangle(*id)).flat_map(|triangle| triangle.vertices) {
        least = [least[0].min(x), least[1].min(y), least[2].min(z)];
        most = [most[0].max(x), most[1].max(y), most[2].max(z)];
    }
    let end = number(first + ids.len());
    let mut content = Content::Leaf { first: number(first), end };
    if ids.len() > LEAF {
        let [x, y, z] = [most[0] - least[0], most[1] - least[1], most[2] - least[2]];
        let along = move |[a, b, c]: Vector| {
            if x >= y && x >= z {
                a
            } else if y >= z {
                b
            } else {
                c
            }
        };
        let middle = |id: &u32| {
            view.triangle(*id).map_or(0, |triangle| triangle.vertices.into_iter().map(along).sum::<i64>())
        };
        *sorts += sorting(ids.len());
        ids.sort_unstable_by_key(|id| (middle(id), *id));
        let (left, right) = ids.split_at_mut(ids.len() / 2);
        let half = left.len();
        let pair = [build(view, left, first, nodes, sorts), build(view, right, first + half, nodes, sorts)];
        let depth = |place: u32| nodes.get(place as usize).map_or(0, |node| node.least[2]);
        let [near, far] = if depth(pair[0]) <= depth(pair[1]) { pair } else { [pair[1], pair[0]] };
        content = Content::Children { near, far };
    }
    nodes.push(Node { least, most, content });
    number(nodes.len() - 1)
}

impl Node {
    /// Returns whether a ray meets the box, and not only behind the plane of the triangle that is the nearest so far.
    fn is_met(&self, ray: Vector, nearest: Option<&Triangle>) -> bool {
        // Where the ray enters and leaves the slab of each axis, as fractions with positive denominators.
        let mut slabs = [((0, 1), (1, 0)); 3];
        let axes = ray.into_iter().zip(self.least.into_iter().zip(self.most));
        for (slab, (r, (least, most))) in slabs.iter_mut().zip(axes) {
            *slab = match r {
                0 if least > 0 || most < 0 => return false,
                0 => continue,
                1.. => ((least, r), (most, r)),
                _ => ((-most, -r), (-least, -r)),
            };
        }
        let is_open = slabs
            .iter()
            .all(|(enter, _)| slabs.iter().all(|(_, leave)| enter.0 * leave.1 <= leave.0 * enter.1));
        is_open
            && nearest.is_none_or(|nearest| {
                let across = dot(nearest.normal, ray);
                let is_behind = |(n, d): (i64, i64)| {
                    i128::from(n) * across > i128::from(d) * i128::from(nearest.distance)
                };
                !slabs.iter().any(|(enter, _)| is_behind(*enter))
            })
    }
}
