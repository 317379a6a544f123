//! Windows: the parts of a light buffer's six faces through which an object is seen; and the cells of the faces.

use core::ops::Range;

use rta_scenes::accelerator::bounds::Bounds;

/// More than a ratio in `f32` is wrong by.
const ROUNDING: f64 = 2e-6;
/// The edge of a face: a ray that is rounded to the other side of it is still on the face.
const EDGE: f64 = 1.0 + 2.0 * ROUNDING;
/// Cells of a face along an axis, at most.
const LONGEST: f64 = 4096.0;

/// The window of an object in a face: its least and greatest coordinates along the two axes of the face, at the distance 1. The
/// first axis is the one after the face's own.
#[derive(Clone, Copy)]
pub(super) struct Window(pub(super) [[f64; 2]; 2]);

impl Window {
    fn with(mut self, other: &Self) -> Self {
        for ([low, high], [from, to]) in self.0.iter_mut().zip(other.0) {
            (*low, *high) = (low.min(from), high.max(to));
        }
        self
    }

    pub(super) fn sides(&self) -> [f64; 2] {
        self.0.map(|[low, high]| high - low)
    }
}

/// The windows in the faces towards x, -x, y, -y, z, -z.
#[derive(Clone, Copy, Default)]
pub(super) struct Windows(pub(super) [Option<Window>; 6]);

impl Windows {
    /// Returns the windows of a box, relative to the point that it is seen from.
    pub(super) fn of(relative: &Bounds) -> Self {
        let ([lx, ly, lz], [hx, hy, hz]) = (relative.low, relative.high);
        let (x, y, z) = ([lx, hx], [ly, hy], [lz, hz]);
        let mut windows = [None; 6];
        for (pair, [own, first, second]) in windows.chunks_mut(2).zip([[x, y, z], [y, z, x], [z, x, y]]) {
            let [low, high] = own;
            for (window, [least, most]) in pair.iter_mut().zip([[low, high], [-high, -low]]) {
                if most > 0.0 {
                    *window = through(1.0 / least.max(f64::MIN_POSITIVE), 1.0 / most, [first, second]);
                }
            }
        }
        Self(windows)
    }

    pub(super) fn join(&mut self, other: &Self) {
        for (own, other) in self.0.iter_mut().zip(other.0) {
            *own = match (*own, other) {
                (Some(own), Some(other)) => Some(own.with(&other)),
                (own, other) => own.or(other),
            };
        }
    }

    pub(super) fn area(&self) -> f64 {
        self.0.iter().flatten().map(|window| window.sides().iter().product::<f64>()).sum()
    }
}

/// The window of what has its distances along the face's own axis between those of the reciprocals `near` and `far`; nothing
/// if it is on other faces.
fn through(near: f64, far: f64, sides: [[f64; 2]; 2]) -> Option<Window> {
    let mut window = sides;
    for [low, high] in &mut window {
        *low = *low * if *low < 0.0 { near } else { far } - ROUNDING;
        *high = *high * if *high > 0.0 { near } else { far } + ROUNDING;
        if *low > EDGE || *high < -EDGE {
            return None;
        }
        (*low, *high) = (low.max(-EDGE), high.min(EDGE));
    }
    Some(Window(window))
}

/// The cells of a face, in rows along its first axis, and one for what is seen beside them.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    pub(super) window: Window,
    pub(super) counts: [u32; 2],
    pub(super) first: u32,
}

impl Grid {
    /// Cells of about that length; none of a face that nothing is seen through.
    pub(super) fn new(window: Option<Window>, length: f64, first: u32) -> Self {
        // Above 0 and below 2^13.
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let count = |side: f64| (side / length).ceil().clamp(1.0, LONGEST) as u32;
        let counts = window.map_or([0; 2], |window| window.sides().map(count));
        Self { window: window.unwrap_or(Window([[0.0; 2]; 2])), counts, first }
    }

    /// The number of the cell for what is seen beside the others.
    pub(super) fn beside(&self) -> u32 {
        self.first + self.counts.iter().product::<u32>()
    }

    /// Calls `visit` for each cell that something is seen through.
    pub(super) fn each(&self, seen: &Window, mut visit: impl FnMut(u32)) {
        let Some((columns, is_left)) = self.range(seen, 0) else { return visit(self.beside()) };
        let Some((rows, is_above)) = self.range(seen, 1) else { return visit(self.beside()) };
        let [width, _] = self.counts;
        for row in rows {
            columns.clone().for_each(|column| visit(self.first + row * width + column));
        }
        if is_left || is_above {
            visit(self.beside());
        }
    }

    /// The cells along an axis, and whether there is something beside them; nothing if all of it is.
    fn range(&self, seen: &Window, axis: usize) -> Option<(Range<u32>, bool)> {
        let (&[low, high], &[from, to], &count) =
            (self.window.0.get(axis)?, seen.0.get(axis)?, self.counts.get(axis)?);
        if count == 0 || from > high || to < low {
            return None;
        }
        let scale = f64::from(count) / (high - low);
        // What is below 0 is 0.
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let cell = |place: f64| (((place - low) * scale) as u32).min(count - 1);
        Some((cell(from)..cell(to) + 1, from < low || to > high))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::indexing_slicing)] // a test may panic
    use fastrand::Rng;

    use super::*;

    /// The face that a direction leads through and the place on it, in `f32` as a ray sees it.
    fn place(way: [f32; 3]) -> (usize, [f64; 2]) {
        let size = way.map(f32::abs);
        let axis = (0..3).fold(0, |best, axis| if size[axis] > size[best] { axis } else { best });
        let over = way[axis].abs().recip();
        let along = |k: usize| f64::from(way[(axis + k) % 3] * over);
        (2 * axis + usize::from(way[axis] < 0.0), [along(1), along(2)])
    }

    #[test]
    fn what_is_in_a_box_is_seen_through_its_windows_and_their_cells() {
        let mut rng = Rng::with_seed(3);
        let mut seen = [0; 6];
        for _ in 0..2000 {
            let side = 10f64.powf(-3.0 * rng.f64());
            let low = [(); 3].map(|()| 2.0 * rng.f64() - 1.0);
            let bounds = Bounds { low, high: low.map(|c| c + side * rng.f64()) };
            let windows = Windows::of(&bounds);
            // Corners, edges and faces too.
            for _ in 0..100 {
                let mut way = [0.0; 3];
                for (c, (low, high)) in way.iter_mut().zip(bounds.low.iter().zip(bounds.high)) {
                    let part = rng.f64().mul_add(1.5, -0.25).clamp(0.0, 1.0);
                    #[allow(clippy::cast_possible_truncation)] // to the nearest
                    let near = (low + part * (high - low)) as f32;
                    *c = near;
                }
                let (face, at) = place(way);
                let window = windows.0[face].expect("it is seen");
                for (at, [low, high]) in at.iter().zip(window.0) {
                    assert!(low < *at && *at < high, "{way:?} at {at} in {low} to {high}");
                }
                seen[face] += 1;
                // A grid that ends somewhere on the face.
                let cut = 0.5 + rng.f64();
                let part = Window(window.0.map(|[low, high]| [low, low + (high - low) * cut]));
                let grid = Grid::new(Some(part), 0.1 * rng.f64() + 0.01, 7);
                let mut cells = Vec::new();
                grid.each(&window, |cell| cells.push(cell));
                let inside = at.iter().zip(part.0).all(|(at, [low, high])| *at > low && *at < high);
                let mut cell = 0.0;
                for ((at, [low, high]), (count, stride)) in
                    at.iter().zip(part.0).zip(grid.counts.iter().zip([1, grid.counts[0]]))
                {
                    cell += ((at - low) / (high - low) * f64::from(*count)).floor() * f64::from(stride);
                }
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a number of a cell
                let cell = if inside { 7 + cell as u32 } else { grid.beside() };
                assert!(cells.contains(&cell), "{cell} of {cells:?}");
            }
        }
        assert!(seen.iter().all(|&count| count > 10_000), "{seen:?}");
    }
}
