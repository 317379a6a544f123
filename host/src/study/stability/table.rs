//! The table, as text and as Markdown.

use super::Row;
use super::guard::CHECKED;
use super::measure::{Measured, Outcome};

/// Marks the beginning of the part of a Markdown file that [`into_markdown`] replaces.
const BEGIN: &str = "<!-- `rta stability -o` writes from here -->";
/// Marks its end.
const END: &str = "<!-- to here -->";

const HEADS: [&str; 12] = [
    "case",
    "format",
    "panics",
    "overflows",
    "non-finite",
    "acne",
    "of points",
    "wrong hit/miss",
    "median",
    "99 %",
    "worst",
    "of rays",
];

/// Returns the cells after case and format.
fn cells(measured: &Measured) -> [String; 10] {
    let count = |n: u64| if CHECKED || n > 0 { n.to_string() } else { "?".into() };
    let levels = |error: f64| match error {
        0.0 => "0".into(),
        error if error < 1e7 => format!("{error:.4}"),
        error => format!("{error:.4e}"),
    };
    [
        count(measured.panics),
        count(measured.overflows),
        measured.non_finite.to_string(),
        measured.acne.points.to_string(),
        measured.acne.of.to_string(),
        measured.wrong.to_string(),
        levels(measured.median),
        levels(measured.p99),
        levels(measured.worst),
        format!("{} ({})", measured.samples, measured.rays),
    ]
}

/// Returns the case and format of a row, and its cells, or why the case was refused.
fn line(row: &Row) -> (String, String, Result<[String; 10], String>) {
    let cells = match &row.outcome {
        Outcome::Traced(measured) => Ok(cells(measured)),
        Outcome::Refused(reason) => Err(format!("refused: {reason}")),
    };
    (row.case.clone(), row.format.to_string(), cells)
}

/// Returns the table as text with aligned columns.
#[must_use]
pub fn text(rows: &[Row]) -> String {
    let lines: Vec<_> = rows.iter().map(line).collect();
    let mut widths = HEADS.map(str::len);
    for (case, format, cells) in &lines {
        let columns = [case, format].into_iter().chain(cells.iter().flatten());
        for (width, cell) in widths.iter_mut().zip(columns) {
            *width = (*width).max(cell.chars().count());
        }
    }
    let [first, second, ..] = widths;
    let mut text = String::new();
    let mut put = |cells: &mut dyn Iterator<Item = &str>| {
        for (i, (cell, width)) in cells.zip(widths).enumerate() {
            let cell = if i < 2 { format!("{cell:<width$}  ") } else { format!("{cell:>width$}  ") };
            text.push_str(&cell);
        }
        text.truncate(text.trim_end().len());
        text.push('\n');
    };
    put(&mut HEADS.into_iter());
    for (case, format, cells) in &lines {
        let columns = [case, format].into_iter().map(String::as_str);
        match cells {
            Ok(cells) => put(&mut columns.chain(cells.iter().map(String::as_str))),
            Err(reason) => {
                let line = format!("{case:<first$}  {format:<second$}  {reason}");
                put(&mut [line.as_str()].into_iter());
            }
        }
    }
    text + &failures(rows, "")
}

/// Returns a list of the messages of the first panics and of the first points with acne.
fn failures(rows: &[Row], bullet: &str) -> String {
    let mut text = String::new();
    for Row { case, format, outcome } in rows {
        let Outcome::Traced(measured) = outcome else { continue };
        for what in [&measured.failure, &measured.acne.first].into_iter().flatten() {
            text += &format!("{bullet}{case}, {format}: {what}\n");
        }
    }
    if text.is_empty() { text } else { format!("\n{text}") }
}

/// Returns the table in Markdown.
#[must_use]
pub fn markdown(rows: &[Row]) -> String {
    let mut text = format!("| {} |\n|{}\n", HEADS.join(" | "), " --- |".repeat(HEADS.len()));
    for row in rows {
        let (case, format, cells) = line(row);
        let cells = match cells {
            Ok(cells) => cells.join(" | "),
            Err(reason) => format!("{reason}{}", " |".repeat(HEADS.len() - 3)),
        };
        text += &format!("| {case} | {format} | {cells} |\n");
    }
    text + &failures(rows, "- ")
}

/// Returns the text of `file` with `part` in the place that is marked for it: between the marks, or at the end if there are none.
#[must_use]
pub fn into_markdown(file: &str, part: &str) -> String {
    let marked = format!("{BEGIN}\n{part}{END}\n");
    if let Some((before, rest)) = file.split_once(BEGIN)
        && let Some((_, after)) = rest.split_once(END)
    {
        return format!("{before}{marked}{}", after.strip_prefix('\n').unwrap_or(after));
    }
    if file.is_empty() { marked } else { format!("{}\n\n{marked}", file.trim_end()) }
}

#[cfg(test)]
mod tests {
    use super::{into_markdown, markdown, text};
    use crate::engine::Format;
    use crate::study::stability::Row;
    use crate::study::stability::measure::{Measured, Outcome};

    fn rows() -> [Row; 2] {
        let measured = Measured { worst: 0.25, wrong: 3, samples: 10, rays: 12, ..Measured::default() };
        let refused = Outcome::Refused("too far".into());
        [
            Row { case: "a sphere".into(), format: Format::Q16, outcome: Outcome::Traced(measured) },
            Row { case: "far".into(), format: Format::Q20, outcome: refused },
        ]
    }

    #[test]
    fn columns_are_aligned_and_reasons_are_told() {
        let text = text(&rows());
        let lines: Vec<&str> = text.lines().collect();
        let [heads, traced, refused] = lines.as_slice() else { panic!("{text}") };
        assert_eq!(heads.len(), traced.len() - "10 (12)".len() + "of rays".len());
        assert_eq!(*refused, "far       q20     refused: too far");
        let markdown = markdown(&rows());
        let bars = |line: &str| line.matches('|').count();
        assert!(markdown.lines().all(|line| bars(line) == 13), "{markdown}");
    }

    #[test]
    fn only_the_marked_part_of_a_file_changes() {
        let fresh = into_markdown("# Stability\n", "one\n");
        let again = into_markdown(&(fresh.clone() + "\n## Fuzzing\n"), "two\n");
        assert_eq!(again, fresh.replace("one", "two") + "\n## Fuzzing\n");
    }
}
