//! The study of cones as a part of a page.

use core::fmt::Write;

use super::pixels::CASES;
use super::{PIXEL, REFERENCE, Study, Ways};
use crate::study::markdown::table;

/// Writes the part of a page about cones.
pub fn markdown(page: &mut String, study: &Study) {
    // Writing to a string does not fail.
    let _ = write!(page, "\n# Cones\n\n{}\n", method());
    let rows: Vec<_> = CASES
        .iter()
        .zip(&study.pixels)
        .map(|(case, pixel)| {
            let numbers =
                [pixel.cone, pixel.rays, pixel.cone - pixel.rays].map(|light| format!("{light:.3}"));
            [&[case.name.to_owned()][..], &numbers].concat()
        })
        .collect();
    let _ = writeln!(page, "{}", table(&["in a pixel", "one cone", "many rays", "difference"], &rows, 1));
    for ways in &study.pictures {
        let _ = picture(page, ways);
    }
}

fn method() -> String {
    format!(
        "\
One cone over each pixel (`--integrator cones`; J. Amanatides 1984), in f64. What is wrong is systematic: no number of
samples makes it less. First single pixels, their green light by one cone and by {PIXEL} rays: why. Then pictures of small
scenes beside {REFERENCE} samples, whose lamps have their size: by how much, and what as many rays as cones and more have. RMSE of linear
light; `rta figures` has the pictures.
"
    )
}

fn picture(page: &mut String, ways: &Ways) -> core::fmt::Result {
    writeln!(page, "\n## {}, by cones\n\n{}.\n", ways.title, ways.about)?;
    let rows: Vec<_> = ways
        .rows
        .iter()
        .map(|row| {
            vec![
                row.way.to_owned(),
                row.rays.iter().sum::<u64>().to_string(),
                format!("{:.4}", row.seconds),
                format!("{:.5}", row.error.rmse),
                format!("{:.3}", row.error.worst),
                format!("{:.1} %", 100.0 * row.error.within),
            ]
        })
        .collect();
    writeln!(
        page,
        "{}",
        table(&["a pixel", "rays", "CPU seconds", "RMSE", "worst", "within 1/255"], &rows, 1)
    )
}
