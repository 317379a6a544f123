//! The contact sheet: all pictures side by side, each with its caption.

use super::Shown;
use super::row::Row;
use crate::picture::coloring::DitherKind;
use crate::picture::file::Displayed;
use crate::picture::frame::Frame;
use crate::study::error::StudyError;
use crate::study::sheet::{GAP, beside, cell, displayed, stacked, title};

use clap::ValueEnum;

/// Returns the sheet: for each device a title and a row of pictures for each colour table, one picture for each dithering. Each row
/// begins with the picture without a device.
///
/// # Errors
/// [`StudyError::Sheet`] if it is too large for a picture file.
pub fn sheet(shown: &[Shown]) -> Result<Displayed, StudyError> {
    let blocks: Vec<_> = shown.iter().map(block).collect();
    displayed(&stacked(&blocks))
}

/// Returns the part of the sheet that is one device's.
fn block(shown: &Shown) -> Frame {
    let Shown { device, caption, rows, traced } = shown;
    let reference = || cell((traced.size, traced.aspect), &traced.reference, "no device");
    let lines = rows.chunks(DitherKind::value_variants().len()).map(|rows| {
        let pictures = rows
            .iter()
            .map(|row| cell((traced.size, traced.aspect), &row.picture.colors(), &label(row, shown)));
        beside(&[reference()].into_iter().chain(pictures).collect::<Vec<_>>())
    });
    let lines: Vec<_> = lines.collect();
    let words = format!(
        "{} on {device}, {}; FLIP at {} pixels a degree; * default",
        caption.title,
        traced.size,
        device.pixels_per_degree()
    );
    let width = lines.first().map_or(0, |line| line.width.saturating_sub(GAP));
    stacked(&[vec![title(width, &words)], lines].concat())
}

fn label(row: &Row, shown: &Shown) -> String {
    let mark = if row.is_default(shown.device) { "* " } else { "" };
    format!("{mark}{}, {}  {:.3}", row.coloring.table, row.coloring.dither, row.own.flip)
}
