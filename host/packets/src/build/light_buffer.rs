//! Builds the light buffers of the eye and the lamps.

use rta_scenes::accelerator::bounds::Bounds;
use rta_scenes::accelerator::solid::Solid;
use rta_scenes::description::Description;

use super::window::{Grid, Windows};
use super::{as_number, single};
use crate::light_buffer::{Candidate, Face, LightBuffer};
use crate::number::ToF32;
use crate::packets::Packets;

/// The most leaves that a cell lists. More are seldom needed: the eye's rays have met something before, and for a shadow ray the
/// hierarchy is as quick.
const MOST: u32 = 24;
/// The number of leaves up to which the hierarchy is as quick as a lamp's light buffer.
const FEW: usize = 2;
/// The most large leaves for which no cells are made.
const LARGE: usize = 6;
/// The least and the greatest number of cells of a light buffer; between these, half as many as there are objects.
const CELLS: core::ops::RangeInclusive<usize> = 4096..=65536;

/// Bytes that the light buffers of all lamps together may take, whatever the scene, and for each of its objects. The lamps that
/// come after these are searched for by the hierarchy.
const BYTES: [usize; 2] = [2 << 20, 256];
/// The number of times that a leaf is put into a cell, for each cell and for each object: where everything is seen through every
/// cell, the hierarchy is searched for what is behind.
const VISITS: [usize; 2] = [512, 16];

/// Adds the light buffers to `built`, whose nodes and leaves are complete; `runs` has for each leaf the index of its first object
/// in `solids`, and the number of its objects. The first `occluders` leaves are those that may hide a lamp.
pub(super) fn build<S: ToF32>(
    scene: &Description,
    solids: Vec<Solid>,
    (runs, occluders): (&[(u32, u32)], usize),
    built: &mut Packets,
) {
    if built.leaves.len() >= Candidate::REST as usize {
        return;
    }
    let boxes: Vec<_> = solids.into_iter().map(|solid| Rounded::new(&solid.bounds)).collect();
    let buffer = about::<S>(scene.camera.eye, true, &boxes, runs, built);
    built.light_buffers.buffers.push(buffer);
    let before = built.light_buffers.bytes();
    let [whole, each] = BYTES;
    for lamp in &scene.lamps {
        if occluders <= FEW || built.light_buffers.bytes() - before > whole + each * boxes.len() {
            break;
        }
        let runs = runs.get(..occluders).unwrap_or_default();
        let buffer = about::<S>(lamp.position, false, &boxes, runs, built);
        built.light_buffers.buffers.push(buffer);
    }
    built.light_buffers.cells.push(as_number(built.light_buffers.candidates.len()));
}

/// Returns the light buffer of a point, whose cells and their candidates are appended to those that are built.
fn about<S: ToF32>(
    center: [f64; 3],
    is_eye: bool,
    boxes: &[Rounded],
    runs: &[(u32, u32)],
    built: &mut Packets,
) -> LightBuffer {
    let size = f64::from(built.size);
    let away = center.iter().fold(0.0f64, |most, c| most.max(c.abs()));
    // Rays start in the scene, not far from it, or at the eye.
    let far = (4.0 * size).max(if is_eye { away } else { 0.0 });
    let margin = S::margin(single(far));
    // By so much a ray may pass by the point: it is pushed off a surface, and its direction is rounded.
    let slack = 2.0 * margin + single(32.0 * f64::from(f32::EPSILON) * (away + size));
    // Twice the slack, for the ray's own margin and the rounding of the light buffer's numbers too.
    let reach = 2.0 * f64::from(slack);
    if reach >= size / 16.0 {
        // Where everything is everywhere, it does not help.
        return LightBuffer::NONE;
    }
    let [x, y, z] = center.map(single);
    let buffer = LightBuffer { center: [x, y, z, built.size].into(), slack, margin, ..LightBuffer::NONE };
    Point { center, reach }.look(buffer, boxes, runs, built)
}

/// The boxes of the objects of each leaf.
fn each<'a>(boxes: &'a [Rounded], runs: &[(u32, u32)]) -> impl Iterator<Item = &'a [Rounded]> {
    runs.iter().map(|&(first, count)| boxes.get(first as usize..(first + count) as usize).unwrap_or_default())
}

/// A box about an object in half the space, rounded outwards.
#[derive(Clone, Copy)]
struct Rounded {
    low: [f32; 3],
    high: [f32; 3],
}

impl Rounded {
    fn new(bounds: &Bounds) -> Self {
        Self {
            low: bounds.low.map(|c| single(c).next_down()),
            high: bounds.high.map(|c| single(c).next_up()),
        }
    }

    fn bounds(&self) -> Bounds {
        Bounds { low: self.low.map(f64::from), high: self.high.map(f64::from) }
    }
}

/// Where things are seen from; they are larger by `reach`.
struct Point {
    center: [f64; 3],
    reach: f64,
}

impl Point {
    fn windows(&self, bounds: &Bounds) -> Windows {
        let mut relative = *bounds;
        for ((low, high), c) in relative.low.iter_mut().zip(&mut relative.high).zip(self.center) {
            *low -= c + self.reach;
            *high -= c - self.reach;
        }
        Windows::of(&relative)
    }

    /// No more than the distance of what is in a box.
    fn near(&self, bounds: &Bounds) -> f64 {
        let mut square = 0.0;
        for (c, (low, high)) in self.center.iter().zip(bounds.low.iter().zip(bounds.high)) {
            let beside = (low - c).max(c - high).max(0.0);
            square += beside * beside;
        }
        square.sqrt() - self.reach
    }

    /// The part of the faces that `cells` are made for: it is smaller where a few large leaves are left out.
    #[allow(clippy::cast_precision_loss)] // few
    fn frame(&self, boxes: &[Rounded], runs: &[(u32, u32)], cells: f64) -> Windows {
        let most = LARGE.min(runs.len() / 4);
        let mut large: Vec<(f64, Windows)> = Vec::with_capacity(most + 1);
        let (mut frame, mut sides, mut count) = (Windows::default(), 0.0, 0.0);
        for run in each(boxes, runs) {
            let mut windows = Windows::default();
            run.iter().for_each(|rounded| windows.join(&self.windows(&rounded.bounds())));
            let area = windows.area();
            let place = large.partition_point(|(other, _)| *other >= area);
            large.insert(place, (area, windows));
            if large.len() > most
                && let Some((_, small)) = large.pop()
            {
                frame.join(&small);
                for window in small.0.iter().flatten() {
                    sides += window.sides().iter().sum::<f64>();
                    count += 1.0;
                }
            }
        }
        let mut all = frame;
        large.iter().for_each(|(_, windows)| all.join(windows));
        let (all, small) = (all.area(), frame.area());
        // How many leaves are tried in vain, if half of the rays lead to small things and half anywhere: beside the cells all
        // large ones, and in them the small ones that reach into a cell but not to the ray.
        let cost = |frame: &Windows, without: usize| {
            let area = frame.area();
            let length = (area / cells).sqrt();
            without as f64 * (1.0 - area / all) + length * (sides + count * length) / small
        };
        let mut best = (cost(&frame, large.len()), frame);
        while let Some((_, windows)) = large.pop() {
            frame.join(&windows);
            let cost = cost(&frame, large.len());
            // Where nothing small is seen, it is no number.
            if cost < best.0 || best.0.is_nan() {
                best = (cost, frame);
            }
        }
        best.1
    }

    /// Completes a light buffer; its cells and their candidates are appended to those that are built.
    fn look(
        &self,
        buffer: LightBuffer,
        boxes: &[Rounded],
        runs: &[(u32, u32)],
        built: &mut Packets,
    ) -> LightBuffer {
        let objects: usize = runs.iter().map(|&(_, count)| count as usize).sum();
        let cells = (objects / 2).clamp(*CELLS.start(), *CELLS.end());
        #[allow(clippy::cast_precision_loss)] // few
        let cells = cells as f64;
        let frame = self.frame(boxes, runs, cells);
        let length = (frame.area() / cells).sqrt();
        let mut total = 0;
        let grids = frame.0.map(|window| {
            let grid = Grid::new(window, length, total);
            total = grid.beside() + 1;
            grid
        });
        // All leaves, the nearest first.
        let mut order: Vec<(f64, u32, &[Rounded])> = each(boxes, runs)
            .zip(0..)
            .map(|(run, leaf)| {
                let near = run.iter().map(|rounded| self.near(&rounded.bounds()));
                (near.fold(f64::INFINITY, f64::min), leaf, run)
            })
            .collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        let nearest = order.first().map_or(0.0, |first| first.0);
        let mut lists = Lists::new(total);
        for &(near, leaf, run) in &order {
            let near = single(near - nearest);
            for rounded in run {
                for (grid, window) in grids.iter().zip(self.windows(&rounded.bounds()).0) {
                    if let Some(window) = window {
                        grid.each(&window, |cell| lists.add(cell, leaf, near));
                    }
                }
            }
            if lists.are_full() {
                break;
            }
            if lists.visits > VISITS[0] * total as usize + VISITS[1] * objects {
                lists.end(near);
                break;
            }
        }
        let base = as_number(built.light_buffers.cells.len());
        lists.append(built);
        let mut faces = [Face::EMPTY; 6];
        for ((number, face), grid) in faces.iter_mut().enumerate().zip(&grids) {
            *face = self::face(number / 2, grid, base);
        }
        LightBuffer { nearest: single(nearest), faces, ..buffer }
    }
}

/// A face across an axis, 0 for x.
fn face(axis: usize, grid: &Grid, base: u32) -> Face {
    let mut face = Face { first: base + grid.first, beside: base + grid.beside(), ..Face::EMPTY };
    if grid.counts != [0; 2] {
        face.end = [0.5; 4].into();
        let [width, _] = grid.counts;
        let axes = [(axis + 1) % 3, (axis + 2) % 3].into_iter().zip([1, width]);
        for ((axis, stride), ([low, high], count)) in axes.zip(grid.window.0.into_iter().zip(grid.counts)) {
            let scale = f64::from(count) / (high - low);
            face.low[axis] = single(low + 0.5 / scale);
            face.scale[axis] = single(scale);
            face.end[axis] = single(f64::from(count) - 0.5);
            face.stride[axis] = single(f64::from(stride));
        }
    }
    face
}

/// The leaves of each cell while they are found.
struct Lists {
    /// How many leaves a cell has, and the last of them.
    cells: Vec<(u32, u32)>,
    /// Cells and what they have, near ones first, in pieces: one long list would be half empty, and copied as it grows.
    found: Vec<Vec<(u32, Candidate)>>,
    full: usize,
    /// How often a leaf was put into a cell, or was found to be there, or the cell to be full.
    visits: usize,
}

/// Entries of a piece.
const PIECE: usize = 4096;

impl Lists {
    fn new(cells: u32) -> Self {
        Self { cells: vec![(0, u32::MAX); cells as usize], found: Vec::new(), full: 0, visits: 0 }
    }

    fn are_full(&self) -> bool {
        self.full == self.cells.len()
    }

    /// Tells all cells that are not full that there may be more leaves, none of them nearer than `near`.
    fn end(&mut self, near: f32) {
        for cell in 0..as_number(self.cells.len()) {
            if let Some((count, _)) = self.cells.get_mut(cell as usize)
                && *count <= MOST
            {
                *count += 1;
                self.push(cell, Candidate::new(near, Candidate::REST));
            }
        }
    }

    fn add(&mut self, cell: u32, leaf: u32, near: f32) {
        self.visits += 1;
        let Some((count, last)) = self.cells.get_mut(cell as usize) else { return };
        if *last == leaf || *count > MOST {
            return;
        }
        let leaf = if *count == MOST { Candidate::REST } else { leaf };
        (*count, *last) = (*count + 1, leaf);
        self.full += usize::from(*count > MOST);
        self.push(cell, Candidate::new(near, leaf));
    }

    fn push(&mut self, cell: u32, candidate: Candidate) {
        if self.found.last().is_none_or(|piece| piece.len() == PIECE) {
            self.found.push(Vec::with_capacity(PIECE));
        }
        if let Some(piece) = self.found.last_mut() {
            piece.push((cell, candidate));
        }
    }

    fn append(mut self, built: &mut Packets) {
        let mut next = built.light_buffers.candidates.len();
        built.light_buffers.cells.reserve_exact(self.cells.len() + 1);
        built.light_buffers.candidates.reserve_exact(self.found.iter().map(Vec::len).sum());
        for (count, _) in &mut self.cells {
            let end = next + *count as usize;
            built.light_buffers.cells.push(as_number(next));
            *count = as_number(next);
            next = end;
        }
        built.light_buffers.candidates.resize(next, Candidate::new(0.0, Candidate::REST));
        for (cell, entry) in self.found.into_iter().flatten() {
            if let Some((place, _)) = self.cells.get_mut(cell as usize)
                && let Some(slot) = built.light_buffers.candidates.get_mut(*place as usize)
            {
                (*slot, *place) = (entry, *place + 1);
            }
        }
    }
}
