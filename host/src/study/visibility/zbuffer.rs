//! The Z-buffer (E. Catmull, "A Subdivision Algorithm for Computer Display of Curved Surfaces", 1974): triangle by triangle, each pixel keeps
//! the nearest so far. The depth is that of the triangle whose id is kept, so a pixel takes 4 bytes.
//!
//! In bands of rows it goes through all triangles once a band and keeps one band, which is what a board can hold. The renderer of boards is
//! `rta_core::zbuffer`: a row of depths along rays, for objects of all kinds.

use core::iter;

use super::integer::{Cover, View, pixels};
use super::outcome::{Counts, LeftOut, Outcome};

/// Draws with a buffer of the whole picture.
///
/// # Errors
/// None.
pub fn whole(view: &View) -> Result<Outcome, LeftOut> {
    Ok(buffered(view, 1..=view.triangles.len(), view.raster.size.height()))
}

/// Draws with a buffer of one row.
///
/// # Errors
/// None.
pub fn banded(view: &View) -> Result<Outcome, LeftOut> {
    Ok(buffered(view, 1..=view.triangles.len(), 1))
}

/// Draws the triangles of these ids in this order, with a buffer of so many rows, at least one.
#[must_use]
pub fn buffered(view: &View, order: impl Iterator<Item = usize> + Clone, rows: u32) -> Outcome {
    let (size, mut ids) = (view.raster.size, view.blank());
    let (mut taken, mut tests, mut compares, mut writes) = (0, 0, 0, 0);
    let rows = rows.max(1);
    let bands = iter::successors(Some(0), |first: &u32| first.checked_add(rows));
    for first in bands.take_while(|first| *first < size.height()) {
        let end = first.saturating_add(rows).min(size.height());
        for id in order.clone() {
            taken += 1;
            let id = super::integer::number(id);
            let Some(triangle) = view.triangle(id) else { continue };
            for y in triangle.rows.start.max(first)..triangle.rows.end.min(end) {
                let columns = triangle.columns.clone();
                for (x, held) in columns.clone().zip(pixels(&mut ids, size.width(), y, columns)) {
                    tests += 1;
                    let ray = view.raster.ray(x, y);
                    if triangle.cover(ray) == Cover::Outside {
                        continue;
                    }
                    compares += 1;
                    if view.is_before(id, *held, ray) {
                        *held = id;
                        writes += 1;
                    }
                }
            }
        }
    }
    let counts = Counts::new()
        .step("triangles", taken)
        .step("tests", tests)
        .step("compares", compares)
        .step("writes", writes);
    Outcome {
        ids,
        counts,
        bytes: 4 * u64::from(size.width()) * u64::from(rows.min(size.height())),
        areas: None,
    }
}
