//! The scan-line (W. Bouknight, "A Procedure for Generation of Three-dimensional Half-toned Computer Graphics Presentations", 1970;
//! G. Watkins, "A Real Time Visible Surface Algorithm", 1970): row by row, the triangles in it cover columns from one to another, and between two
//! places where one begins or ends, whichever is nearest at both ends is seen. Where that is not one triangle the span is halved, as Watkins did.

use core::ops::Range;

use super::integer::{Raster, Triangle, View, dot};
use super::outcome::{Counts, LeftOut, Outcome, sorting};

/// The columns of a row that a triangle covers.
#[derive(Clone, Debug)]
struct Interval {
    columns: Range<u32>,
    id: u32,
}

/// Draws row by row.
///
/// # Errors
/// None.
pub fn scanned(view: &View) -> Result<Outcome, LeftOut> {
    let size = view.raster.size;
    let mut rows = Rows::default();
    let mut waiting: Vec<_> =
        view.each().filter(|(_, triangle)| !triangle.rows.is_empty()).map(|(id, _)| id).collect();
    let first = |id: &u32| view.triangle(*id).map_or(0, |triangle| triangle.rows.start);
    rows.sorting += sorting(waiting.len());
    waiting.sort_by_key(first);
    let mut waiting = waiting.into_iter().peekable();
    let count = waiting.len();
    let mut ids = view.blank();
    let (mut active, mut most): (Vec<u32>, _) = (Vec::new(), 0);
    for (y, row) in (0..size.height()).zip(ids.chunks_exact_mut(size.columns())) {
        while let Some(id) = waiting.next_if(|id| first(id) <= y) {
            active.push(id);
        }
        active.retain(|id| view.triangle(*id).is_some_and(|triangle| triangle.rows.end > y));
        most = most.max(active.len());
        rows.active += active.len() as u64;
        let found = active.iter().filter_map(|&id| {
            let columns = covered(view.triangle(id)?, &view.raster, y);
            (!columns.is_empty()).then_some(Interval { columns, id })
        });
        let mut intervals: Vec<_> = found.collect();
        rows.sorting += sorting(2 * intervals.len());
        intervals.sort_unstable_by_key(|interval| (interval.columns.start, interval.id));
        rows.row(view, y, &intervals, row);
    }
    let Rows { sorting, active, spans, compares, covered, writes } = rows;
    let counts = Counts::new()
        .step("sorting", sorting)
        .step("active", active)
        .step("spans", spans)
        .step("compares", compares)
        .step("writes", writes)
        .note("covered", covered);
    // The order, what is active with its intervals and their ends, and one row.
    let interval = size_of::<Interval>() + 2 * size_of::<u32>();
    let bytes = 4 * count + (4 + interval) * most + 4 * size.columns();
    Ok(Outcome { ids, counts, bytes: bytes as u64, areas: None })
}

/// Counts of all rows.
#[derive(Default)]
struct Rows {
    sorting: u64,
    active: u64,
    spans: u64,
    compares: u64,
    covered: u64,
    writes: u64,
}

impl Rows {
    /// Draws a row of intervals that are sorted by their first columns.
    fn row(&mut self, view: &View, y: u32, intervals: &[Interval], row: &mut [u32]) {
        let mut ends: Vec<_> =
            intervals.iter().flat_map(|own| [own.columns.start, own.columns.end]).collect();
        ends.sort_unstable();
        ends.dedup();
        let mut waiting = intervals.iter().peekable();
        let mut open: Vec<&Interval> = Vec::new();
        for (&start, &end) in ends.iter().zip(ends.iter().skip(1)) {
            open.retain(|interval| interval.columns.end > start);
            while let Some(interval) = waiting.next_if(|interval| interval.columns.start <= start) {
                open.push(interval);
            }
            if !open.is_empty() {
                self.covered += u64::from(end - start) * open.len() as u64;
                self.span(view, y, start..end, &open, row);
            }
        }
    }

    /// Draws a span in which all open triangles are met everywhere.
    fn span(&mut self, view: &View, y: u32, columns: Range<u32>, open: &[&Interval], row: &mut [u32]) {
        let mut parts = vec![columns];
        while let Some(Range { start, end }) = parts.pop() {
            self.spans += 1;
            let [left, right] = [start, end - 1].map(|x| {
                if let [only] = open {
                    return only.id;
                }
                self.compares += open.len() as u64 - 1;
                let ray = view.raster.ray(x, y);
                open.iter().fold(
                    0,
                    |nearest, own| if view.is_before(own.id, nearest, ray) { own.id } else { nearest },
                )
            });
            if left == right {
                // Inverse depths are linear, so what is nearest at both ends is so between them.
                self.writes += u64::from(end - start);
                row.get_mut(start as usize..end as usize).unwrap_or_default().fill(left);
            } else {
                let middle = start + (end - start) / 2;
                parts.extend([middle..end, start..middle]);
            }
        }
    }
}

/// Returns the columns of a row whose rays are covered, by the linear functions of the three sides.
fn covered(triangle: &Triangle, raster: &Raster, y: u32) -> Range<u32> {
    let (mut first, mut end) = (i128::from(triangle.columns.start), i128::from(triangle.columns.end));
    for side in &triangle.sides {
        // At column x it is at + slope x, which is to be at least 0, or 1 where the side is not owned.
        let slope = i128::from(side.normal[0]) * i128::from(raster.step());
        let at = dot(side.normal, raster.ray(0, y)) - i128::from(!side.is_owned);
        if slope > 0 {
            first = first.max(-at.div_euclid(slope));
        } else if slope < 0 {
            end = end.min(at.div_euclid(-slope) + 1);
        } else if at < 0 {
            return 0..0;
        }
    }
    let [first, end] = [first, end.max(first)].map(|x| u32::try_from(x).unwrap_or(0));
    first..end
}

#[cfg(test)]
mod tests {
    use super::covered;
    use crate::study::visibility::integer::Cover;
    use crate::study::visibility::samples::{random, view};

    #[test]
    fn columns_are_those_that_are_covered() {
        let view = view((23, 17), &random(7, 200, 30_000));
        for triangle in &view.triangles {
            for y in 0..17 {
                let columns = covered(triangle, &view.raster, y);
                for x in 0..23 {
                    let is_covered = triangle.cover(view.raster.ray(x, y)) != Cover::Outside;
                    assert_eq!(columns.contains(&x), is_covered, "{x} {y} {triangle:?}");
                }
            }
        }
    }
}
