//! Area subdivision (J. Warnock, "A Hidden Surface Algorithm for Computer Generated Halftone Pictures", 1969): a window is simple where it is empty or
//! where one triangle surrounds it and is nearer than all others; else it is cut in four. What is left of the size of a pixel is decided
//! by its ray.
//!
//! A window is the rectangle of its pixels' middles, so what its corners say holds of each of its pixels.

use core::ops::Range;

use super::integer::{Cover, Triangle, Vector, View, dot, pixels};
use super::outcome::{Counts, LeftOut, Outcome};

/// How a triangle lies to a window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    /// It covers none of its pixels.
    Disjoint,
    /// It covers all of them.
    Surrounds,
    /// It may cover some.
    Else,
}

/// Draws by windows.
///
/// # Errors
/// None.
pub fn subdivided(view: &View) -> Result<Outcome, LeftOut> {
    let size = view.raster.size;
    let mut work =
        Subdivision { view, ids: view.blank(), windows: 0, tests: 0, compares: 0, writes: 0, levels: 0 };
    let mut within: Vec<_> = view.each().map(|(id, _)| id).collect();
    work.window(&mut within, [0..size.width(), 0..size.height()], 1);
    let Subdivision { ids, windows, tests, compares, writes, levels, .. } = work;
    let counts = Counts::new()
        .step("windows", windows)
        .step("tests", tests)
        .step("compares", compares)
        .step("writes", writes)
        .note("levels", levels);
    // The order, and of each level how much of it is in the window.
    Ok(Outcome { ids, counts, bytes: 4 * within.len() as u64 + 8 * levels, areas: None })
}

struct Subdivision<'a> {
    view: &'a View,
    ids: Vec<u32>,
    windows: u64,
    tests: u64,
    compares: u64,
    writes: u64,
    levels: u64,
}

impl Subdivision<'_> {
    /// Draws a window. Of `ids` those come first, in any order, that are not disjoint.
    fn window(&mut self, ids: &mut [u32], window: [Range<u32>; 2], level: u64) {
        let [columns, rows] = &window;
        if columns.is_empty() || rows.is_empty() {
            return;
        }
        self.windows += 1;
        self.levels = self.levels.max(level);
        let ray = |x, y| self.view.raster.ray(x, y);
        let ([left, right], [top, bottom]) = ([columns.start, columns.end - 1], [rows.start, rows.end - 1]);
        let corners = [ray(left, top), ray(right, top), ray(left, bottom), ray(right, bottom)];
        let is_pixel = left == right && top == bottom;
        // The nearest at the first corner of those that surround the window.
        let (mut kept, mut nearest) = (0, 0);
        for at in 0..ids.len() {
            let Some(&id) = ids.get(at) else { break };
            let Some(triangle) = self.view.triangle(id) else { continue };
            self.tests += 1;
            let place = place(triangle, &corners);
            if place == Place::Disjoint {
                continue;
            }
            ids.swap(kept, at);
            kept += 1;
            if place == Place::Surrounds {
                self.compares += 1;
                if self.view.is_before(id, nearest, corners[0]) {
                    nearest = id;
                }
            }
        }
        let ids = ids.get_mut(..kept).unwrap_or_default();
        if ids.is_empty() {
            return;
        }
        // In a window of one pixel, what is not disjoint surrounds it.
        if is_pixel || nearest != 0 && self.is_before_all(nearest, ids, &corners) {
            self.fill(nearest, &window);
            return;
        }
        let halves = |range: &Range<u32>| {
            let middle = range.start + (range.end - range.start).div_ceil(2);
            [range.start..middle, middle..range.end]
        };
        for rows in halves(rows) {
            for columns in halves(columns) {
                self.window(ids, [columns, rows.clone()], level + 1);
            }
        }
    }

    /// Returns whether a triangle's plane is nearer at all corners than those of all others: then it is so at all places between them, since
    /// inverse depths are linear.
    fn is_before_all(&mut self, nearest: u32, ids: &[u32], corners: &[Vector; 4]) -> bool {
        let mut others = ids.iter().filter(|id| **id != nearest);
        others.all(|other| {
            corners.iter().all(|ray| {
                self.compares += 1;
                self.view.is_before(nearest, *other, *ray)
            })
        })
    }

    fn fill(&mut self, id: u32, [columns, rows]: &[Range<u32>; 2]) {
        let width = self.view.raster.size.width();
        for y in rows.clone() {
            let row = pixels(&mut self.ids, width, y, columns.clone());
            row.fill(id);
            self.writes += row.len() as u64;
        }
    }
}

/// Returns how a triangle lies to the window with these corners.
fn place(triangle: &Triangle, corners: &[Vector; 4]) -> Place {
    let mut surrounds = true;
    for side in &triangle.sides {
        let is_inside = |ray: &Vector| dot(side.normal, *ray) >= i128::from(!side.is_owned);
        let inside = corners.iter().filter(|ray| is_inside(ray)).count();
        if inside == 0 {
            return Place::Disjoint;
        }
        surrounds &= inside == corners.len();
    }
    debug_assert!(!surrounds || corners.iter().all(|ray| triangle.cover(*ray) != Cover::Outside));
    if surrounds { Place::Surrounds } else { Place::Else }
}

#[cfg(test)]
mod tests {
    use super::subdivided;
    use crate::study::visibility::samples::view;

    #[test]
    fn an_edge_along_the_diagonal_takes_1021_windows() {
        // Half of a picture of 256 x 256 pixels with its plane at distance 1, and more.
        for corner in [[9000, 9000, 1000], [-9000, -9000, 1000]] {
            let half = [[-9000, 9000, 1000], [9000, -9000, 1000], corner];
            let outcome = subdivided(&view((256, 256), &[half])).expect("few");
            assert_eq!(outcome.counts.of("windows"), Some(1021));
            let seen = outcome.ids.iter().filter(|id| **id == 1).count();
            // The middles on the diagonal belong to the half on its right, whose left side it is.
            let owned = if corner[0] > 0 { 256 } else { 0 };
            assert_eq!(seen, 255 * 128 + owned);
        }
    }
}
