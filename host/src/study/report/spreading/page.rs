//! The study of rays that are spread, to read and as comma-separated values.

use core::fmt::Write;

use super::variance::{Costs, PLACES, SEEDS, Variances};
use super::{Curve, REFERENCE, REPEATS, Row, STEP, Spread};
use crate::study::markdown::table;
use crate::study::report::measure::pareto_front;

/// Returns the pictures of all studies as comma-separated values. The last column, `cpu_s`, is the only one whose values differ from run
/// to run.
///
/// # Errors
/// Those of writing to memory: none are expected.
pub fn csv(studies: &[Spread]) -> Result<Vec<u8>, csv::Error> {
    let mut out = csv::Writer::from_writer(Vec::new());
    out.write_record([
        "scene",
        "sampler",
        "lamps",
        "aa",
        "split",
        "samples",
        "primary",
        "reflected",
        "transmitted",
        "shadow",
        "rays",
        "rmse",
        "worst",
        "slope",
        "cpu_s",
    ])?;
    for study in studies {
        for curve in &study.curves {
            for row in &curve.rows {
                let mut record = vec![study.title.clone()];
                record.extend(curve.way.iter().cloned());
                record.push(row.samples.to_string());
                record.extend(row.rays.map(|rays| rays.to_string()));
                record.push(row.rays.iter().sum::<u64>().to_string());
                record.extend([row.error.rmse, row.error.worst].map(|error| format!("{error:.9}")));
                record.push(curve.slope.map_or_else(String::new, |slope| format!("{slope:.3}")));
                record.push(format!("{:.5}", row.seconds));
                out.write_record(record)?;
            }
        }
    }
    out.into_inner().map_err(|error| csv::Error::from(error.into_error()))
}

/// Writes the part of the page about rays that are spread.
pub fn markdown(page: &mut String, studies: &[Spread]) {
    if studies.is_empty() {
        return;
    }
    // Writing to a string does not fail.
    let _ = write!(page, "\n# Rays that are spread\n\n{}", method());
    for study in studies {
        let _ = scene(page, study);
    }
}

fn method() -> String {
    format!(
        "\
Pictures a {STEP}th as wide and high, in f64, by the scene's own model. The error is the RMSE of linear light, each sample cut to
0 to 1, against {REFERENCE} samples of sobol by another seed, whose lamps have their size. What draws another picture, because its rays
are not spread or its lamps are points or fixed places, has an error that does not go away. Slopes are those of log error over log
samples, by least squares: -0.5 is random, about -0.75 that of edges with well spread samples (-0.6 where an edge
is crossed by two pairs of numbers together, as those of pixel and lamp), and -1.5 of smooth light. CPU seconds
are of one thread, up to 16 samples the median of {REPEATS} runs. Everything but the seconds is the same in every run.

The two variances are of one sample, as means over all pixels and registers: of the place on the lamps where the ray from the eye
ends, and of all else. They are measured by {SEEDS} pictures of one sample with independent seeds, each with one place on the lamps
and with the mean of {PLACES}. The best split S = sqrt((v_lamp c_eye)/(v_pixel c_shadow)) makes the least error for a cost; c_eye is
what a sample costs without, c_shadow one shadow ray more to each lamp (Cook, Porter and Carpenter split rays so in 1984).
"
    )
}

fn scene(page: &mut String, study: &Spread) -> core::fmt::Result {
    let Spread { title, size, curves, variances, reference_error } = study;
    writeln!(page, "\n## {title}, spread\n")?;
    writeln!(page, "{size} pixels. The reference's own error is estimated as {reference_error:.1e}.\n")?;
    if let Some(variances) = variances {
        writeln!(page, "{}\n", told(variances))?;
    }
    let rows: Vec<_> = curves
        .iter()
        .map(|curve| {
            let ends = curve.rows.first().zip(curve.rows.last());
            let (few, many) = ends.map_or_else(Default::default, |(first, last)| {
                let told = |row: &Row| format!("{:.5} ({})", row.error.rmse, row.samples);
                (told(first), told(last))
            });
            let slope = curve.slope.map_or_else(|| "-".to_owned(), |slope| format!("{slope:.2}"));
            [&curve.way[..], &[few, many, slope]].concat()
        })
        .collect();
    let head = ["sampler", "lamps", "aa", "split", "error (samples)", "error (samples)", "slope"];
    writeln!(page, "{}", table(&head, &rows, 4))?;
    for (name, cost) in [("CPU time", seconds as fn(&Row) -> f64), ("rays", rays)] {
        writeln!(page, "The Pareto front of error against {name}:\n\n{}", front(curves, cost))?;
    }
    Ok(())
}

/// Returns what is told of the variances of a scene.
fn told(variances: &Variances) -> String {
    let Variances { lamp, pixel, rays, seconds } = *variances;
    let costs =
        |Costs { eye, shadow }: Costs, unit: f64| format!("{:.3} and {:.3}", eye * unit, shadow * unit);
    format!(
        "Variance of the lamps alone {lamp:.3e}, of the pixel {pixel:.3e}; best split {:.2} by rays (c_eye and c_shadow {}), {:.2} by \
         CPU time ({} microseconds).",
        variances.best_split(rays),
        costs(rays, 1.0),
        variances.best_split(seconds),
        costs(seconds, 1e6)
    )
}

fn seconds(row: &Row) -> f64 {
    row.seconds
}

#[allow(clippy::cast_precision_loss)] // below 2^53
fn rays(row: &Row) -> f64 {
    row.rays.iter().sum::<u64>() as f64
}

/// Returns the table of the pictures than which no other is better without costing more.
fn front(curves: &[Curve], cost: fn(&Row) -> f64) -> String {
    let all: Vec<_> =
        curves.iter().flat_map(|curve| curve.rows.iter().map(|row| (&curve.way, row))).collect();
    let points: Vec<_> = all.iter().map(|(_, row)| (cost(row), row.error.rmse)).collect();
    let on_front = pareto_front(&points).into_iter().filter_map(|at| all.get(at));
    let rows: Vec<_> = on_front
        .map(|(way, row)| {
            let numbers = [
                row.samples.to_string(),
                format!("{:.3} M", rays(row) / 1e6),
                format!("{:.4}", row.seconds),
                format!("{:.5}", row.error.rmse),
            ];
            [&way[..], &numbers].concat()
        })
        .collect();
    table(&["sampler", "lamps", "aa", "split", "samples", "rays", "CPU seconds", "RMSE"], &rows, 4)
}
