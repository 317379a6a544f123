//! The study as comma-separated values.

use super::measure::Difference;
use super::study::{DEVICES, Row, Study};
use rta_core::sampling::Places;

/// Returns the rows of all studies as comma-separated values.
///
/// # Errors
/// Those of writing to memory: none are expected.
pub fn csv(studies: &[Study]) -> Result<Vec<u8>, csv::Error> {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record(head())?;
    for study in studies {
        for row in &study.rows {
            table.write_record(record(&study.title, row))?;
        }
    }
    table.into_inner().map_err(|error| csv::Error::from(error.into_error()))
}

/// Returns the names of the columns. The last, `cpu_s`, is the only one whose values differ from run to run.
fn head() -> Vec<String> {
    let plain = [
        "scene",
        "format",
        "samples",
        "sampler",
        "depth",
        "cutoff",
        "primary",
        "reflected",
        "transmitted",
        "shadow",
        "rays",
        "instructions",
    ];
    let mut names: Vec<_> = plain.map(String::from).into();
    for error in ["rounding", "truncation", "sampling", "tracing", "total"] {
        names
            .extend(["rmse", "worst", "psnr_db", "within_level"].map(|measure| format!("{error}_{measure}")));
    }
    for device in DEVICES {
        names.extend(
            ["rmse_levels", "worst_levels", "within_level"].map(|measure| format!("{device}_{measure}")),
        );
    }
    names.push("cpu_s".to_owned());
    names
}

fn record(title: &str, row: &Row) -> Vec<String> {
    let method = row.method;
    let mut record = vec![
        title.to_owned(),
        method.format.to_string(),
        method.sampling.samples().to_string(),
        method.sampler().to_owned(),
        row.limit.depth.to_string(),
        row.limit.cutoff.to_string(),
    ];
    record.extend(row.rays.map(|rays| rays.to_string()));
    record.push(row.all_rays().to_string());
    record.push(row.instructions.map_or_else(String::new, |count| count.to_string()));
    for error in [row.rounding, row.truncation, row.sampling, row.tracing, row.total] {
        let Difference { rmse, worst, within } = error;
        record.extend([rmse, worst].map(|value| format!("{value:.9}")));
        record.push(format!("{:.2}", error.psnr()));
        record.push(format!("{within:.6}"));
    }
    for Difference { rmse, worst, within } in row.display {
        record.extend([rmse, worst].map(|value| format!("{value:.4}")));
        record.push(format!("{within:.6}"));
    }
    record.push(format!("{:.5}", row.seconds));
    record
}
