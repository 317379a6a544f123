//! The work-precision diagrams of a room: all methods, each with the curve of its best settings.

use plotters::prelude::*;

use super::method::Method;
use super::{Row, Study};
use crate::study::plot::{Area, BOLD, DrawError, Drawing, LIGHT};
use crate::study::report::diagram::{around, axis, label};
use crate::study::report::measure::pareto_front;

/// Pixels of the key beside the diagram.
const KEY: u32 = 260;

/// What lies on the horizontal axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Instructions, or, where none were counted, rays: the same in every run.
    Work,
    /// CPU seconds on one thread.
    Seconds,
}

impl Axis {
    /// Returns the cost of a row.
    #[must_use]
    pub fn cost(self, row: &Row) -> f64 {
        match self {
            Self::Work => row.instructions.unwrap_or_else(|| row.all_rays()),
            Self::Seconds => row.seconds,
        }
    }

    fn told(self, study: &Study) -> &'static str {
        match self {
            Self::Work if study.rows.iter().all(|row| row.instructions.is_some()) => {
                "cost of solution and picture (retired instructions)"
            }
            Self::Work => "cost of solution and picture (rays)",
            Self::Seconds => "cost of solution and picture (CPU seconds, one thread)",
        }
    }
}

/// A diagram of a study.
#[derive(Clone, Copy, Debug)]
pub struct Diagram<'a> {
    /// The study.
    pub study: &'a Study,
    /// Its horizontal axis.
    pub axis: Axis,
}

/// Returns the rows of a method than which none of its others is better without costing more, the cheapest first.
#[must_use]
pub fn front(rows: &[Row], method: Option<Method>, axis: Axis) -> Vec<&Row> {
    let of: Vec<_> = rows.iter().filter(|row| method.is_none_or(|method| row.method == method)).collect();
    let points: Vec<_> = of.iter().map(|row| (axis.cost(row), row.error)).collect();
    pareto_front(&points).into_iter().filter_map(|at| of.get(at).copied()).collect()
}

/// Distinct to the colour-blind too (Okabe and Ito's palette).
const fn color(method: Method) -> RGBColor {
    match method {
        Method::Ambient => RGBColor(120, 120, 120),
        Method::Distributed => RGBColor(0, 114, 178),
        Method::Radiosity => RGBColor(213, 94, 0),
        Method::TwoPasses => RGBColor(0, 158, 115),
        Method::Cache => RGBColor(230, 159, 0),
        Method::Paths => RGBColor(204, 121, 167),
    }
}

impl Drawing for Diagram<'_> {
    const SIZE: (u32, u32) = crate::study::report::diagram::SIZE;

    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Result<(), DrawError<B>> {
        let Self { study, axis: cost } = *self;
        let (left, key) = area.split_horizontally(Self::SIZE.0 - KEY);
        let rows = &study.rows;
        let across = around(rows.iter().map(|row| cost.cost(row)));
        let up = around(rows.iter().map(|row| row.error));
        let mut chart = ChartBuilder::on(&left)
            .caption(format!("{}: light that goes round", study.title), ("sans-serif", 22))
            .margin(12)
            .x_label_area_size(52)
            .y_label_area_size(76)
            .build_cartesian_2d(axis(&across), axis(&up))?;
        chart
            .configure_mesh()
            .x_desc(cost.told(study))
            .y_desc(format!("error (RMSE against {} paths a pixel; 1 is white)", study.reference.samples))
            .x_label_formatter(&|value| label(*value))
            .y_label_formatter(&|value| label(*value))
            .axis_desc_style(("sans-serif", 15))
            .label_style(("sans-serif", 12))
            .light_line_style(LIGHT)
            .bold_line_style(BOLD)
            .draw()?;
        let style = ("sans-serif", 13).into_font().color(&BLACK);
        for (at, method) in (0..).zip(Method::ALL) {
            let color = color(method);
            let point = |row: &Row| (cost.cost(row), row.error);
            let best = front(rows, Some(method), cost).into_iter().map(point);
            chart.draw_series(LineSeries::new(best, color.stroke_width(2)))?;
            let all = rows.iter().filter(|row| row.method == method).map(point);
            chart.draw_series(all.map(|at| Circle::new(at, 3, color.filled())))?;
            let y = 64 + 24 * at;
            key.draw(&PathElement::new([(6, y), (34, y)], color.stroke_width(2)))?;
            key.draw(&Circle::new((20, y), 3, color.filled()))?;
            key.draw(&Text::new(method.name(), (44, y - 8), style.clone()))?;
        }
        let notes = [
            "A point is a picture: so many",
            "samples a pixel, and, of the",
            "three with patches, a solution",
            "with so many patches and rays.",
            "A line joins those of a method",
            "that no other of it beats.",
            "Where it runs level, the method",
            "leaves something out.",
        ];
        for (at, note) in (0..).zip(notes) {
            key.draw(&Text::new(note, (6, 224 + 20 * at), style.clone()))?;
        }
        Ok(())
    }
}
