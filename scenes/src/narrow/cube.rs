//! Builds the direction cubes of the eye and the lamps.

use rta_core::Scalar;
use rta_core::lanes::{Cube, Entry, Face};

use super::bounds::Bounds;
use super::lanes::{Built, as_number, single};
use super::tree::Solid;
use crate::description::Description;

/// Packs that a cell has at most.
const MOST: u32 = 24;
/// More than a ratio in `f32` is wrong by.
const ROUNDING: f64 = 2e-6;
/// Packs at most that cells are not made for.
const LARGE: usize = 6;

/// The cubes of a scene whose nodes and packs are built; `runs` are the first of the `solids` in each pack and how many they are.
pub(super) fn build<S: Scalar>(scene: &Description, solids: &[Solid], runs: &[(u32, u32)], built: &mut Built) {
    let size = f64::from(built.size);
    let lamps = scene.lamps.iter().map(|lamp| (lamp.position, false));
    for (center, is_eye) in core::iter::once((scene.camera.eye, true)).chain(lamps) {
        let away = center.iter().fold(0.0f64, |most, c| most.max(c.abs()));
        let far = (4.0 * size).max(if is_eye { away } else { 0.0 });
        let margin = S::coarse_margin(single(far));
        // By so much a ray is pushed off a surface, and by so much its direction is rounded.
        let slack = 2.0 * margin + single(32.0 * f64::from(f32::EPSILON) * (away + size));
        let reach = 2.0 * f64::from(slack);
        // Where everything is everywhere, it does not help.
        let cube = if reach < size / 16.0 {
            let [x, y, z] = center.map(single);
            let faces = Point { center, reach }.faces(solids, runs, built);
            Cube { center: [x, y, z, built.size].into(), slack, margin, faces }
        } else {
            Cube::NONE
        };
        if std::env::var("DBG").is_ok() {
            let from = cube.faces.iter().map(|f| f.first).min().unwrap();
            let lens: Vec<u32> = built.cells.windows(2).skip(from as usize).map(|w| w[1] - w[0]).collect();
            let full = lens.iter().filter(|l| **l > MOST).count();
            let empty = lens.iter().filter(|l| **l == 0).count();
            eprintln!("cube {center:?} slack {} margin {} cells {} entries {} full {full} empty {empty} {:?}", cube.slack, cube.margin, lens.len(), lens.iter().sum::<u32>(), cube.faces.map(|f| (f.scale, f.end, f.first, f.beside)));
        }
        built.cubes.push(cube);
    }
    built.cells.push(as_number(built.entries.len()));
}

/// What of a face something is seen through: from where to where along its two axes, at the distance 1.
#[derive(Clone, Copy)]
struct Window([[f64; 2]; 2]);

impl Window {
    fn with(mut self, other: &Self) -> Self {
        for (own, other) in self.0.iter_mut().zip(other.0) {
            *own = [own[0].min(other[0]), own[1].max(other[1])];
        }
        self
    }

    fn sides(&self) -> [f64; 2] {
        self.0.map(|[low, high]| high - low)
    }

    fn area(&self) -> f64 {
        self.sides().iter().product()
    }
}

/// What of each face.
type Windows = [Option<Window>; 6];

fn join(all: &mut Windows, new: &Windows) {
    for (all, new) in all.iter_mut().zip(new) {
        *all = match (*all, new) {
            (Some(all), Some(new)) => Some(all.with(new)),
            (all, new) => all.or(*new),
        };
    }
}

fn area(windows: &Windows) -> f64 {
    windows.iter().flatten().map(Window::area).sum()
}

/// The cells of a face.
#[derive(Clone, Copy)]
struct Grid {
    window: Option<Window>,
    counts: [u32; 2],
    first: u32,
}

impl Grid {
    /// The cells that something is seen through, in rows and columns; and whether it is seen beside them too.
    fn cells(&self, seen: &Window) -> ([core::ops::Range<u32>; 2], bool) {
        let Some(Window(all)) = self.window else { return ([0..0, 0..0], true) };
        let mut cells = [0..0, 0..0];
        let mut is_beside = false;
        for (((cells, &count), [low, high]), [from, to]) in
            cells.iter_mut().zip(&self.counts).zip(all).zip(seen.0)
        {
            let scale = f64::from(count) / (high - low);
            is_beside |= from < low || to > high;
            if from <= high && to >= low {
                // Below 0 is 0.
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                let at = |c: f64| (((c - low) * scale) as u32).min(count - 1);
                *cells = at(from)..at(to) + 1;
            }
        }
        (cells, is_beside)
    }
}

/// Where things are seen from; they are larger by `reach`.
struct Point {
    center: [f64; 3],
    reach: f64,
}

impl Point {
    /// What of a face a box may be seen through: 0 to 5 for x, -x, y, -y, z, -z.
    fn window(&self, bounds: &Bounds, face: usize) -> Option<Window> {
        let (axis, reach) = (face / 2, self.reach);
        let side = |axis: usize| {
            let axis = axis % 3;
            Some([
                bounds.low.get(axis)? - self.center.get(axis)? - reach,
                bounds.high.get(axis)? - self.center.get(axis)? + reach,
            ])
        };
        let [low, high] = side(axis)?;
        let [least, most] = if face % 2 == 0 { [low, high] } else { [-high, -low] };
        if most <= 0.0 {
            return None;
        }
        let least = least.max(f64::MIN_POSITIVE);
        let mut window = [side(axis + 1)?, side(axis + 2)?];
        for [low, high] in &mut window {
            *low = *low / if *low < 0.0 { least } else { most } - ROUNDING;
            *high = *high / if *high > 0.0 { least } else { most } + ROUNDING;
            if *low > 1.0 || *high < -1.0 {
                return None;
            }
            (*low, *high) = (low.max(-1.0), high.min(1.0));
        }
        Some(Window(window))
    }

    fn windows(&self, bounds: &Bounds) -> Windows {
        let mut windows = [None; 6];
        for (face, window) in windows.iter_mut().enumerate() {
            *window = self.window(bounds, face);
        }
        windows
    }

    fn near(&self, bounds: &Bounds) -> f32 {
        let mut square = 0.0;
        for (c, (low, high)) in self.center.iter().zip(bounds.low.iter().zip(bounds.high)) {
            let beside = (low - c).max(c - high).max(0.0);
            square += beside * beside;
        }
        single(square.sqrt() - self.reach)
    }

    /// The part of the faces that cells are made for: it is smaller where a few packs are left out that are large.
    fn framed(&self, solids: &[Solid], runs: &[(u32, u32)], budget: f64) -> Windows {
        let most = LARGE.min(runs.len() / 4);
        let mut large: Vec<(f64, Windows)> = Vec::with_capacity(most + 1);
        let mut rest = [None; 6];
        let (mut sides, mut count) = (0.0, 0.0);
        for run in each(solids, runs) {
            let mut seen = [None; 6];
            for solid in run {
                join(&mut seen, &self.windows(&solid.bounds));
            }
            let area = area(&seen);
            let place = large.partition_point(|(other, _)| *other >= area);
            large.insert(place, (area, seen));
            if large.len() > most
                && let Some((_, least)) = large.pop()
            {
                join(&mut rest, &least);
                for window in least.iter().flatten() {
                    sides += window.sides().iter().sum::<f64>();
                    count += 1.0;
                }
            }
        }
        let mut all = rest;
        large.iter().for_each(|(_, seen)| join(&mut all, seen));
        let (all, small) = (area(&all), area(&rest));
        // How many packs are asked in vain, where half of the rays lead to small things and half anywhere: of small ones those that a
        // cell has and a ray does not lead to, and beside the cells all that are large.
        let cost = |windows: &Windows, without: usize| {
            let area = area(windows);
            let length = (area / budget).sqrt();
            without as f64 * (1.0 - area / all) + length * (sides + count * length) / small
        };
        let mut best = (cost(&rest, large.len()), rest);
        while let Some((_, seen)) = large.pop() {
            join(&mut rest, &seen);
            let cost = cost(&rest, large.len());
            if cost < best.0 {
                best = (cost, rest);
            }
        }
        best.1
    }

    fn faces(&self, solids: &[Solid], runs: &[(u32, u32)], built: &mut Built) -> [Face; 6] {
        let mult = std::env::var("CELLS").map_or(4.0, |v| v.parse::<f64>().unwrap());
        let least = std::env::var("LEAST").map_or(1024.0, |v| v.parse::<f64>().unwrap());
        let maxc = std::env::var("MOSTC").map_or(16384.0, |v| v.parse::<f64>().unwrap());
        let most = std::env::var("MOST").map_or(MOST, |v| v.parse::<u32>().unwrap());
        let budget = (mult * solids.len() as f64).clamp(least, maxc);
        let frame = self.framed(solids, runs, budget);
        let length = (area(&frame) / budget).sqrt();
        let mut total = 0;
        let grids = frame.map(|window| {
            let counts = window.map_or([0; 2], |w| w.sides().map(|side| (side / length).ceil().clamp(1.0, 4096.0) as u32));
            let first = total;
            total += counts[0] * counts[1] + 1;
            Grid { window, counts, first }
        });
        let mut order: Vec<(f32, u32, &[Solid])> = each(solids, runs).zip(0..).map(|(run, pack)| {
            let near = run.iter().map(|solid| self.near(&solid.bounds)).fold(f32::INFINITY, f32::min);
            (near, pack, run)
        }).collect();
        order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let mut counts = vec![0u32; total as usize];
        let mut marks = vec![u32::MAX; total as usize];
        let mut full = 0;
        let mut pairs: Vec<(u32, u32)> = Vec::new();
        for (&(_, pack, run), rank) in order.iter().zip(0u32..) {
            let mut add = |cell: u32| {
                let cell_ = cell as usize;
                if marks[cell_] != pack && counts[cell_] <= most {
                    marks[cell_] = pack;
                    counts[cell_] += 1;
                    full += u32::from(counts[cell_] > most);
                    pairs.push((cell, rank));
                }
            };
            for solid in run {
                for (face, grid) in grids.iter().enumerate() {
                    let Some(window) = self.window(&solid.bounds, face) else { continue };
                    let ([columns, rows], is_beside) = grid.cells(&window);
                    for row in rows {
                        for column in columns.clone() {
                            add(grid.first + row * grid.counts[0] + column);
                        }
                    }
                    if is_beside {
                        add(grid.first + grid.counts[0] * grid.counts[1]);
                    }
                }
            }
            if full == total {
                break;
            }
        }
        let base = as_number(built.cells.len());
        let mut next = as_number(built.entries.len());
        for count in &mut counts {
            built.cells.push(next);
            (*count, next) = (next, next + *count);
        }
        built.entries.resize(next as usize, Entry { near: 0.0, pack: Entry::REST });
        for (cell, rank) in pairs {
            let (near, pack, _) = order[rank as usize];
            let place = &mut counts[cell as usize];
            let is_rest = *place + 1 - built.cells[(base + cell) as usize] > most;
            built.entries[*place as usize] = Entry { near, pack: if is_rest { Entry::REST } else { pack } };
            *place += 1;
        }
        let mut faces = [Face::EMPTY; 6];
        for (number, (face, grid)) in faces.iter_mut().zip(grids).enumerate() {
            face.beside = base + grid.first + grid.counts[0] * grid.counts[1];
            face.first = base + grid.first;
            let Some(window) = grid.window else { continue };
            let [j, k] = [(number / 2 + 1) % 3, (number / 2 + 2) % 3];
            face.end = [0.5; 4].into();
            for (axis, (([low, high], count), stride)) in
                [j, k].into_iter().zip(window.0.into_iter().zip(grid.counts).zip([1, grid.counts[0]]))
            {
                let count = f64::from(count);
                let scale = count / (high - low);
                face.low[axis] = single(low + 0.5 / scale);
                face.scale[axis] = single(scale);
                face.end[axis] = single(count - 0.5);
                face.stride[axis] = single(f64::from(stride));
            }
        }
        faces
    }
}

/// The objects of each pack.
fn each<'a>(solids: &'a [Solid], runs: &[(u32, u32)]) -> impl Iterator<Item = &'a [Solid]> {
    runs.iter().map(|&(first, count)| {
        solids.get(first as usize..(first + count) as usize).unwrap_or_default()
    })
}
