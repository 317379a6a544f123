//! The continuous scan-plane (G. Hamlin and C. Gear, "Raster-Scan Hidden Surface Algorithm Techniques", SIGGRAPH 77): the picture is cut in slabs at
//! the heights of all vertices and of all points where edges cross, so that within a slab edges have one order, and between two neighbours one
//! triangle is seen. It knows no pixels: what comes out is the visible area of each triangle, as by the polygons that K. Weiler and P. Atherton cut
//! ("Hidden Surface Removal Using Polygon Area Sorting", SIGGRAPH 77). In `f64`; the only one of the algorithms that rounds.
//!
//! Lines in which two triangles pierce each other are edges too. The picture of ids is sampled from the slabs afterwards.

use core::ops::Range;

use super::integer::{View, pixels};
use super::outcome::{Counts, LeftOut, Outcome};

mod edges;

pub(super) use edges::distance;
use edges::{Edge, Edges};

/// The most visits of a triangle by a slab: some seconds of them.
const MOST: u64 = 1 << 26;

/// A triangle as the slabs have it.
struct Face {
    id: u32,
    /// Its edges, by number.
    edges: [u32; 3],
    /// Lowest and highest place.
    reach: [f64; 2],
    /// Its inverse depth as a linear function of the place.
    near: [f64; 3],
}

/// Where a face begins or ends on a level.
#[derive(Clone, Copy)]
struct Boundary {
    u: f64,
    edge: u32,
    /// The face, or none for an edge in which faces pierce each other.
    face: usize,
    is_start: bool,
}

/// Returns the visible areas, and the ids sampled from them.
///
/// # Errors
/// [`LeftOut`] if there are too many slabs, or too many crossings.
pub fn swept(view: &View) -> Result<Outcome, LeftOut> {
    let edges = Edges::new(view)?;
    let mut faces: Vec<_> = view
        .each()
        .filter_map(|(id, triangle)| {
            let of = edges.of.get(id as usize - 1).copied()?;
            let heights = triangle.vertices.map(|[_, y, z]| y as f64 / z as f64);
            let [a, b, c] = heights;
            let near = triangle.normal.map(|c| c as f64 / triangle.distance as f64);
            Some(Face { id, edges: of, reach: [a.min(b).min(c), a.max(b).max(c)], near })
        })
        .collect();
    faces.sort_by(|a, b| a.reach[0].total_cmp(&b.reach[0]));
    let heights = edges.heights();
    let place = |height: f64| heights.partition_point(|own| *own < height) as u64;
    let visits = faces.iter().map(|face| place(face.reach[1]) - place(face.reach[0])).sum();
    LeftOut::check("visits of triangles by slabs", visits, MOST)?;

    let corner = view.raster.corner().map(|c| c as f64);
    let (right, top) = (corner[0] / corner[2], corner[1] / corner[2]);
    let mut sweep = Sweep::new(view, &edges, &faces);
    let (mut active, mut next): (Vec<usize>, _) = (Vec::new(), 0);
    let mut piercing = edges.piercing.iter().copied().peekable();
    let mut most = 0;
    for (&low, &high) in heights.iter().zip(heights.iter().skip(1)) {
        let (low, high) = (low.max(-top), high.min(top));
        let middle = f64::midpoint(low, high);
        if !(low < middle && middle < high) {
            continue;
        }
        while faces.get(next).is_some_and(|face| face.reach[0] < middle) {
            active.push(next);
            next += 1;
        }
        active.retain(|face| faces.get(*face).is_some_and(|face| face.reach[1] > middle));
        let new: Vec<_> =
            core::iter::from_fn(|| piercing.next_if(|edge| edges.at(*edge).low[1] < middle)).collect();
        sweep.slab([low, high], right, &active, &new);
        most = most.max(sweep.boundaries.len());
    }
    let Sweep { ids, areas, sorting, slabs, visited, compares, .. } = sweep;
    let counts = Counts::new()
        .step("pairs", edges.pairs)
        .step("sorting", sorting)
        .step("visits", visited)
        .step("compares", compares)
        .note("slabs", slabs)
        .note("crossings", edges.crossings.len() as u64)
        .note("piercing", edges.piercing.len() as u64);
    let mut by_id = vec![0.0; view.triangles.len()];
    for (face, area) in faces.iter().zip(areas) {
        if let Some(own) = by_id.get_mut(face.id as usize - 1) {
            *own = area / (4.0 * right * top);
        }
    }
    let bytes = size_of::<Edge>() * edges.all.len()
        + (size_of::<Face>() + size_of::<Option<[(f64, u32); 2]>>()) * faces.len()
        + size_of::<f64>() * heights.len()
        + size_of::<Boundary>() * most;
    Ok(Outcome { ids, counts, bytes: bytes as u64, areas: Some(by_id) })
}

struct Sweep<'a> {
    view: &'a View,
    edges: &'a Edges,
    faces: &'a [Face],
    ids: Vec<u32>,
    areas: Vec<f64>,
    /// Of each face, place and edge of its two boundaries in the last slab that it was in.
    ends: Vec<Option<[(f64, u32); 2]>>,
    boundaries: Vec<Boundary>,
    open: Vec<usize>,
    sorting: u64,
    slabs: u64,
    visited: u64,
    compares: u64,
}

impl<'a> Sweep<'a> {
    fn new(view: &'a View, edges: &'a Edges, faces: &'a [Face]) -> Self {
        Self {
            view,
            edges,
            faces,
            ids: view.blank(),
            areas: vec![0.0; faces.len()],
            ends: vec![None; faces.len()],
            boundaries: Vec::new(),
            open: Vec::new(),
            sorting: 0,
            slabs: 0,
            visited: 0,
            compares: 0,
        }
    }

    /// Adds the areas of a slab, and the ids of its rows.
    fn slab(&mut self, [low, high]: [f64; 2], right: f64, active: &[usize], piercing: &[u32]) {
        self.slabs += 1;
        self.visited += active.len() as u64;
        let middle = f64::midpoint(low, high);
        let mut boundaries = core::mem::take(&mut self.boundaries);
        self.bring(&mut boundaries, middle, active, piercing);
        self.sorting += sort(&mut boundaries);
        let rows = rows(self.view, [low, high]);
        self.open.clear();
        let (mut seen, mut begun) = (None, Vec::new());
        for (left, end) in boundaries.iter().zip(boundaries.iter().skip(1)) {
            // What is seen stays so until it ends, a nearer one begins, or faces pierce each other.
            if left.is_start {
                self.open.push(left.face);
                begun.push(left.face);
            } else if let Some(place) = self.open.iter().position(|face| *face == left.face) {
                self.open.swap_remove(place);
                begun.retain(|face| *face != left.face);
                seen = seen.filter(|face| *face != left.face);
            } else {
                seen = None;
            }
            // What is outside the picture does not count.
            let [from, to] = [left.u, end.u].map(|u| u.clamp(-right, right));
            if from >= to {
                continue;
            }
            begun.extend(seen);
            let candidates = if seen.is_some() { &begun } else { &self.open };
            self.compares += (candidates.len() as u64).saturating_sub(1);
            seen = self.nearest(candidates, [f64::midpoint(from, to), middle]);
            begun.clear();
            if let Some(face) = seen {
                if let Some(area) = self.areas.get_mut(face) {
                    *area += (to - from) * (high - low);
                }
                for y in rows.clone() {
                    self.sample(face, y, [left.edge, end.edge]);
                }
            }
        }
        self.boundaries = boundaries;
    }

    /// Brings the boundaries of the slab before to the middle of the next: those that end are taken out, new ones are added at the end, and the
    /// others keep their order, which is nearly that of their new places.
    /// Lines in which faces pierce each other are passed as far as they are new.
    fn bring(&mut self, boundaries: &mut Vec<Boundary>, middle: f64, active: &[usize], piercing: &[u32]) {
        for &face in active {
            let (Some(own), Some(ends)) = (self.faces.get(face), self.ends.get_mut(face)) else { continue };
            let met = own.edges.map(|edge| (edge, self.edges.at(edge)));
            let met = met.iter().filter(|(_, edge)| edge.low[1] < middle && middle < edge.high[1]);
            let mut met = met.map(|(number, edge)| (edge.at(middle), *number));
            let is_new = ends.is_none();
            *ends = match (met.next(), met.next()) {
                (Some(a), Some(b)) if a.0 <= b.0 => Some([a, b]),
                (Some(a), Some(b)) => Some([b, a]),
                _ => None,
            };
            if is_new && ends.is_some() {
                let boundary = Boundary { u: 0.0, edge: 0, face, is_start: true };
                boundaries.extend([boundary, Boundary { is_start: false, ..boundary }]);
            }
        }
        boundaries.extend(piercing.iter().map(|&edge| Boundary {
            u: 0.0,
            edge,
            face: usize::MAX,
            is_start: false,
        }));
        boundaries.retain_mut(|own| {
            let Some(face) = self.faces.get(own.face) else {
                let edge = self.edges.at(own.edge);
                own.u = edge.at(middle);
                return edge.high[1] > middle;
            };
            let ends = self.ends.get(own.face).copied().flatten().filter(|_| face.reach[1] > middle);
            let end = ends.map(|[start, end]| if own.is_start { start } else { end });
            (own.u, own.edge) = end.unwrap_or_default();
            end.is_some()
        });
    }

    /// Returns the nearest of some faces at a place.
    fn nearest(&self, faces: &[usize], [u, v]: [f64; 2]) -> Option<usize> {
        let faces = faces.iter().filter_map(|&place| self.faces.get(place).map(|face| (place, face)));
        let near = faces.map(|(place, Face { near: [a, b, c], id, .. })| (a * u + b * v + c, *id, place));
        near.max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1))).map(|(_, _, place)| place)
    }

    /// Gives the pixels of a row between two edges to a face.
    fn sample(&mut self, face: usize, y: u32, between: [u32; 2]) {
        let [x, height, z] = self.view.raster.ray(0, y).map(|c| c as f64);
        let step = self.view.raster.step() as f64;
        let size = self.view.raster.size;
        let column = |edge: u32| {
            let u = self.edges.at(edge).at(height / z);
            ((u * z - x) / step).ceil().clamp(0.0, f64::from(size.width()))
        };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is within the width")]
        let [start, end] = between.map(|edge| column(edge) as u32);
        let id = self.faces.get(face).map_or(0, |face| face.id);
        pixels(&mut self.ids, size.width(), y, start..end.max(start)).fill(id);
    }
}

/// Sorts boundaries that are nearly sorted by insertion, and returns the number of comparisons.
fn sort(boundaries: &mut [Boundary]) -> u64 {
    let mut compares = 0;
    for end in 1..boundaries.len() {
        for place in (1..=end).rev() {
            compares += 1;
            let pair = [place - 1, place].map(|place| boundaries.get(place).map(|boundary| boundary.u));
            if pair[0] <= pair[1] {
                break;
            }
            boundaries.swap(place - 1, place);
        }
    }
    compares
}

/// Returns the rows of the picture whose middles are in a slab.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is within the height")]
fn rows(view: &View, slab: [f64; 2]) -> Range<u32> {
    let size = view.raster.size;
    let [_, first, z] = view.raster.ray(0, 0).map(|c| c as f64);
    let [_, last, _] = view.raster.ray(0, size.height() - 1).map(|c| c as f64);
    let step = (first - last) / f64::from(size.height() - 1).max(1.0);
    // One row, in a picture of one, is in the slab or not.
    let step = if step > 0.0 { step } else { z };
    let row = |height: f64| ((first - height * z) / step).ceil().clamp(0.0, f64::from(size.height())) as u32;
    let [low, high] = slab;
    row(high)..row(low).max(row(high))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::indexing_slicing, reason = "a test may panic")]
    use super::swept;
    use crate::study::visibility::samples::view;

    #[test]
    fn areas_are_exact() {
        // The picture is seen from distance 1, from -1 to 1. A half of a square, half of it hidden by a nearer one.
        let far = [[-500, -500, 1000], [500, -500, 1000], [-500, 500, 1000]];
        let near = [[-500, 0, 500], [250, 0, 500], [-500, 500, 500]];
        let areas = swept(&view((7, 9), &[far, near])).expect("few").areas.expect("areas");
        let whole = |area: f64| area * 4.0;
        assert!((whole(areas[1]) - 0.75).abs() < 1e-12, "{areas:?}");
        assert!((whole(areas[0]) - 0.375).abs() < 1e-12, "{areas:?}");
    }

    #[test]
    fn a_pierced_pair_shares_its_area() {
        // Two halves of the picture that lean against each other and meet in the line u = 0.
        let one = [[-4000, -8000, 2000], [4000, -8000, 4000], [4000, 8000, 4000]];
        let rest = [[-4000, -8000, 2000], [4000, 8000, 4000], [-4000, 8000, 2000]];
        let lean = |[x, y, z]: [i64; 3]| [-x, y, z];
        let all = [one, rest, one.map(lean), rest.map(lean)];
        let areas = swept(&view((8, 8), &all)).expect("few").areas.expect("areas");
        let sides = [areas[0] + areas[1], areas[2] + areas[3]];
        assert!(sides.iter().all(|side| (side - 0.5).abs() < 1e-12), "{areas:?}");
    }
}
