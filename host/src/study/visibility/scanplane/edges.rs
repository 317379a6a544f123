//! The edges of the triangles as they are seen, where they cross, and the lines in which triangles pierce each other.

use std::collections::HashMap;

use crate::study::visibility::integer::{Triangle, Vector, View, number};
use crate::study::visibility::outcome::LeftOut;

/// The number of no vertex.
const NONE: u32 = u32::MAX;

/// The most pairs of edges, or of triangles, that are looked at, and the most crossings.
const MOST_PAIRS: u64 = 1 << 31;
const MOST_CROSSINGS: u64 = 1 << 24;

/// An edge on the image plane at distance 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Edge {
    /// The lower end, and of ends of one height the left one.
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
    /// The vertices, by number, in any order.
    ends: [u32; 2],
}

impl Edge {
    fn new(ends: [[f64; 2]; 2], vertices: [u32; 2]) -> Self {
        let [a, b] = ends;
        let is_up = (a[1], a[0]) <= (b[1], b[0]);
        let (low, high) = if is_up { (a, b) } else { (b, a) };
        Self { low, high, ends: vertices }
    }

    /// Returns the place at a height, on the line of the edge.
    pub(super) fn at(&self, v: f64) -> f64 {
        let ([a, b], [c, d]) = (self.low, self.high);
        if d > b { a + (v - b) / (d - b) * (c - a) } else { a }
    }

    /// Returns the height at which two edges cross, if they do.
    fn crossing(&self, other: &Self) -> Option<f64> {
        let shared = |vertex: &u32| *vertex != NONE && other.ends.contains(vertex);
        if self.ends.iter().any(shared) {
            return None;
        }
        let [a, b] = [self, other].map(|edge| [edge.high[0] - edge.low[0], edge.high[1] - edge.low[1]]);
        let way = [other.low[0] - self.low[0], other.low[1] - self.low[1]];
        let area = a[0] * b[1] - a[1] * b[0];
        let [own, others] = [(way[0] * b[1] - way[1] * b[0]) / area, (way[0] * a[1] - way[1] * a[0]) / area];
        let is_within = |part: f64| (0.0..=1.0).contains(&part);
        (is_within(own) && is_within(others)).then(|| self.low[1] + own * a[1])
    }

    const fn columns(&self) -> [f64; 2] {
        [self.low[0].min(self.high[0]), self.low[0].max(self.high[0])]
    }
}

/// All edges.
#[derive(Debug, Default)]
pub(super) struct Edges {
    /// Those of triangles, and then those in which triangles pierce each other.
    pub(super) all: Vec<Edge>,
    /// The three edges of each triangle, by number.
    pub(super) of: Vec<[u32; 3]>,
    /// The numbers of those in which triangles pierce each other, from the lowest upwards.
    pub(super) piercing: Vec<u32>,
    /// The heights at which edges cross.
    pub(super) crossings: Vec<f64>,
    /// Pairs of edges or triangles that were looked at.
    pub(super) pairs: u64,
}

impl Edges {
    pub(super) fn new(view: &View) -> Result<Self, LeftOut> {
        let mut edges = Self::default();
        let (mut vertices, mut known) = (HashMap::new(), HashMap::new());
        for triangle in &view.triangles {
            let numbers = triangle.vertices.map(|vertex| {
                let count = number(vertices.len());
                *vertices.entry(vertex).or_insert(count)
            });
            let [a, b, c] = [0, 1, 2].map(|n| (at(&triangle.vertices, n), at(&numbers, n)));
            edges.of.push([(a, b), (b, c), (c, a)].map(|(from, to)| {
                let key = (from.1.min(to.1), from.1.max(to.1));
                *known.entry(key).or_insert_with(|| {
                    edges.all.push(Edge::new([from.0, to.0].map(seen), [from.1, to.1]));
                    number(edges.all.len() - 1)
                })
            }));
        }
        edges.pierce(view)?;
        edges.cross()?;
        Ok(edges)
    }

    /// Returns the edge of a number.
    pub(super) fn at(&self, number: u32) -> Edge {
        self.all.get(number as usize).copied().unwrap_or(Edge {
            low: [0.0; 2],
            high: [0.0; 2],
            ends: [NONE; 2],
        })
    }

    /// Returns the heights at which slabs begin and end, from the lowest.
    pub(super) fn heights(&self) -> Vec<f64> {
        let ends = self.all.iter().flat_map(|edge| [edge.low[1], edge.high[1]]);
        let mut heights: Vec<_> = ends.chain(self.crossings.iter().copied()).collect();
        heights.sort_unstable_by(f64::total_cmp);
        heights.dedup();
        heights
    }

    /// Adds the lines in which triangles pierce each other.
    fn pierce(&mut self, view: &View) -> Result<(), LeftOut> {
        let boxes: Vec<_> = view
            .triangles
            .iter()
            .map(|triangle| {
                let places = triangle.vertices.map(seen);
                let bounds = |c: [f64; 3]| [c[0].min(c[1]).min(c[2]), c[0].max(c[1]).max(c[2])];
                [bounds(places.map(|place| place[1])), bounds(places.map(|place| place[0]))]
            })
            .collect();
        let mut found = Vec::new();
        self.pairs += overlapping(&boxes, |a, b| {
            if let (Some(a), Some(b)) = (view.triangles.get(a), view.triangles.get(b)) {
                found.extend(common(a, b));
            }
            Ok(())
        })?;
        found.sort_unstable_by(|a, b| a.low[1].total_cmp(&b.low[1]));
        let first = self.all.len();
        self.piercing = (first..first + found.len()).map(number).collect();
        self.all.extend(found);
        Ok(())
    }

    /// Adds the heights at which edges cross.
    fn cross(&mut self) -> Result<(), LeftOut> {
        let boxes: Vec<_> =
            self.all.iter().map(|edge| [[edge.low[1], edge.high[1]], edge.columns()]).collect();
        let (all, crossings) = (&self.all, &mut self.crossings);
        self.pairs += overlapping(&boxes, |a, b| {
            if let (Some(a), Some(b)) = (all.get(a), all.get(b)) {
                crossings.extend(a.crossing(b));
            }
            LeftOut::check("crossings", crossings.len() as u64, MOST_CROSSINGS)
        })?;
        Ok(())
    }
}

fn at<T: Copy>([a, b, c]: &[T; 3], place: u8) -> T {
    match place {
        0 => *a,
        1 => *b,
        _ => *c,
    }
}

/// Returns where a point is seen on the image plane at distance 1.
fn seen([x, y, z]: Vector) -> [f64; 2] {
    [x as f64 / z as f64, y as f64 / z as f64]
}

/// Calls `meet` with the numbers of each two boxes that overlap, and returns how many pairs were looked at: all those whose heights overlap. A
/// box has bounds of height and of width.
fn overlapping(
    boxes: &[[[f64; 2]; 2]],
    mut meet: impl FnMut(usize, usize) -> Result<(), LeftOut>,
) -> Result<u64, LeftOut> {
    let mut order: Vec<_> = boxes.iter().enumerate().collect();
    order.sort_by(|a, b| a.1[0][0].total_cmp(&b.1[0][0]));
    let mut active: Vec<(usize, &[[f64; 2]; 2])> = Vec::new();
    let mut pairs = 0;
    for (own, bounds) in order {
        let [[low, _], [left, right]] = *bounds;
        active.retain(|(_, other)| other[0][1] >= low);
        pairs += active.len() as u64;
        LeftOut::check("pairs", pairs, MOST_PAIRS)?;
        for (other, [_, columns]) in &active {
            if columns[0] <= right && left <= columns[1] {
                meet(*other, own)?;
            }
        }
        active.push((own, bounds));
    }
    Ok(pairs)
}

/// Returns the part that two triangles have in common of the line in which their planes meet, as it is seen; nothing where one of them is at one
/// side of the other.
fn common(a: &Triangle, b: &Triangle) -> Option<Edge> {
    let straddles = |triangle: &Triangle, plane: &Triangle| {
        let sides = triangle.vertices.map(|vertex| plane.side(vertex));
        sides.iter().any(|side| side.is_gt()) && sides.iter().any(|side| side.is_lt())
    };
    if !straddles(a, b) || !straddles(b, a) {
        return None;
    }
    let [x, y, z] = a.meeting(b).map(|c| c as f64);
    let size = x.hypot(y);
    if size <= 0.0 {
        return None;
    }
    let (x, y, z) = (x / size, y / size, z / size);
    // The places of the line are foot + t along.
    let (foot, along) = ([-x * z, -y * z], [-y, x]);
    let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
    for side in a.sides.iter().chain(&b.sides) {
        let [p, q, r] = side.normal.map(|c| c as f64);
        let (slope, at) = (p * along[0] + q * along[1], p * foot[0] + q * foot[1] + r);
        if slope > 0.0 {
            from = from.max(-at / slope);
        } else if slope < 0.0 {
            to = to.min(-at / slope);
        } else if at < 0.0 {
            return None;
        }
    }
    let place = |t: f64| [foot[0] + t * along[0], foot[1] + t * along[1]];
    (from < to && from.is_finite() && to.is_finite()).then(|| Edge::new([place(from), place(to)], [NONE; 2]))
}

/// Returns how far a place of the image plane at distance 1 is from the nearest edge of a triangle, or from the line in which its plane meets that of
/// another, which is 0 where they are one plane.
pub(in crate::study::visibility) fn distance(
    triangle: &Triangle,
    others: Option<&Triangle>,
    ray: Vector,
) -> f64 {
    let [u, v] = seen(ray);
    let far = |[a, b, c]: [f64; 3]| (a * u + b * v + c).abs() / a.hypot(b);
    let sides = triangle.sides.iter().map(|side| far(side.normal.map(|c| c as f64)));
    let line = others.map(|other| match triangle.meeting(other) {
        [0, 0, 0] => 0.0,
        line => far(line.map(|c| c as f64)),
    });
    sides.chain(line).fold(f64::INFINITY, f64::min)
}
