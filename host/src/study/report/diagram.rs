//! The work-precision diagram.

use core::ops::Range;

use plotters::coord::combinators::{BindKeyPoints, LogCoord, WithKeyPoints};
use plotters::prelude::*;
use rta_core::color::Rgb;
use rta_core::sampling::Places;

use super::measure::pareto_front;
use super::setting::Method;
use super::study::{Row, Study};
use crate::engine::Format;
use crate::study::plot::{self, Area, BOLD, DiagramError, DrawError, Drawing, LIGHT};

/// Pixels of a diagram.
pub const SIZE: (u32, u32) = (1200, 800);

/// Pixels of the key beside it.
const KEY: u32 = 260;

/// One level of guns with 4, 6 and 8 bits: the devices' own.
const LEVELS: [(&str, f64); 3] = [("1/15", 1.0 / 15.0), ("1/63", 1.0 / 63.0), ("1/255", 1.0 / 255.0)];

type Chart<'a, B> =
    ChartContext<'a, B, Cartesian2d<WithKeyPoints<LogCoord<f64>>, WithKeyPoints<LogCoord<f64>>>>;

/// Returns the diagram as SVG, with its text as text elements.
///
/// # Errors
/// [`DiagramError`].
pub fn svg(study: &Study) -> Result<String, DiagramError> {
    plot::svg(study)
}

/// Returns the diagram's pixels, row by row from the top.
///
/// # Errors
/// [`DiagramError`].
pub fn pixels(study: &Study) -> Result<Vec<Rgb<u8>>, DiagramError> {
    plot::pixels(study)
}

impl Drawing for Study {
    const SIZE: (u32, u32) = SIZE;

    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Result<(), DrawError<B>> {
        draw(area, self)
    }
}

/// Returns the cost of a setting: its place on the diagram's horizontal axis.
#[allow(clippy::cast_precision_loss)] // below 2^53
pub(super) fn cost(row: &Row) -> f64 {
    row.instructions.unwrap_or_else(|| row.all_rays()) as f64
}

/// Factor by which a point of the front must have less error than the one before it to be worth naming.
const WORTH: f64 = 0.99;

/// Returns the indexes of the rows on the Pareto front, the cheapest first, without those whose error is less than 1 % below that
/// of the one before.
pub(super) fn front(rows: &[Row]) -> Vec<usize> {
    let points: Vec<_> = rows.iter().map(|row| (cost(row), row.total.rmse)).collect();
    let mut front = pareto_front(&points);
    let mut last = f64::INFINITY;
    front.retain(|at| {
        let error = points.get(*at).map_or(f64::INFINITY, |(_, error)| *error);
        let worth = error <= WORTH * last;
        if worth {
            last = error;
        }
        worth
    });
    front
}

fn color(method: Method) -> RGBColor {
    // Distinct to the colour-blind too (Okabe and Ito's palette).
    match (method.format, method.sampling.is_jittered()) {
        (_, true) => RGBColor(204, 121, 167),
        (Format::F32, _) => RGBColor(0, 114, 178),
        (Format::Q16, _) => RGBColor(213, 94, 0),
        _ => RGBColor(0, 158, 115),
    }
}

/// Returns the size of a method's marks. Those of the fixed-point formats differ, so that one is seen around the other where the
/// formats draw the same picture.
fn radius(method: Method) -> i32 {
    if method.format == Format::Q16 { 5 } else { 3 }
}

/// An axis that holds all points with a little room.
pub(super) fn around(values: impl Iterator<Item = f64> + Clone) -> Range<f64> {
    let positive = values.filter(|value| *value > 0.0);
    let least = positive.clone().fold(f64::INFINITY, f64::min);
    let most = positive.fold(0.0, f64::max);
    if least <= most { least / 1.25..most * 1.25 } else { 0.1..1.0 }
}

/// An axis with its ticks at 1, 2 and 5 times the powers of ten.
pub(super) fn axis(range: &Range<f64>) -> WithKeyPoints<LogCoord<f64>> {
    let mut ticks = Vec::new();
    let mut power = 10_f64.powf(range.start.log10().floor());
    while power < range.end {
        ticks.extend(
            [1.0, 2.0, 5.0].map(|digit| digit * power).into_iter().filter(|tick| range.contains(tick)),
        );
        power *= 10.0;
    }
    range.clone().log_scale().with_key_points(ticks)
}

fn draw<B: DrawingBackend>(root: &Area<B>, study: &Study) -> Result<(), DrawError<B>> {
    let (left, key) = root.split_horizontally(SIZE.0 - KEY);
    let rows = &study.rows;
    let counted = rows.iter().all(|row| row.instructions.is_some());
    let errors = rows.iter().map(|row| row.total.rmse);
    let mut chart = ChartBuilder::on(&left)
        .caption(format!("{}: error against run time", study.title), ("sans-serif", 22))
        .margin(12)
        .x_label_area_size(52)
        .y_label_area_size(76)
        .build_cartesian_2d(axis(&around(rows.iter().map(cost))), axis(&around(errors)))?;
    chart
        .configure_mesh()
        .x_desc(if counted { "cost of a picture (retired instructions)" } else { "cost of a picture (rays)" })
        .y_desc("error (RMSE against f64, depth 32, 1024 samples; 1 is white)")
        .x_label_formatter(&|value| label(*value))
        .y_label_formatter(&|value| label(*value))
        .axis_desc_style(("sans-serif", 15))
        .label_style(("sans-serif", 12))
        .light_line_style(LIGHT)
        .bold_line_style(BOLD)
        .draw()?;
    levels(&mut chart, rows)?;
    let mut methods: Vec<Method> = Vec::new();
    for row in rows {
        if !methods.contains(&row.method) {
            methods.push(row.method);
        }
    }
    for method in &methods {
        curve(&mut chart, rows, *method)?;
    }
    let best = front(rows).into_iter().filter_map(|at| rows.get(at));
    let best: Vec<_> = best.map(|row| (cost(row), row.total.rmse)).collect();
    chart.draw_series(LineSeries::new(best.iter().copied(), BLACK.stroke_width(2)))?;
    chart.draw_series(best.into_iter().map(|point| Circle::new(point, 6, BLACK.stroke_width(2))))?;
    legend(&key, &methods)
}

/// The label of a tick.
pub(super) fn label(tick: f64) -> String {
    let exponent = (tick * 1.0001).log10().floor();
    let digit = (tick / 10_f64.powf(exponent)).round();
    if (-4.0..0.0).contains(&exponent) {
        format!("{tick:.4}").trim_end_matches('0').to_owned()
    } else {
        format!("{digit}e{exponent}")
    }
}

/// Lines at one level of the devices' guns.
fn levels<B: DrawingBackend>(chart: &mut Chart<B>, rows: &[Row]) -> Result<(), DrawError<B>> {
    let (across, up) = (around(rows.iter().map(cost)), around(rows.iter().map(|row| row.total.rmse)));
    for (name, level) in LEVELS {
        if up.contains(&level) {
            let ends = [(across.start, level), (across.end, level)];
            chart.draw_series(DashedLineSeries::new(ends, 6, 5, RGBColor(120, 120, 120).stroke_width(1)))?;
            let style = ("sans-serif", 13).into_font().color(&RGBColor(90, 90, 90));
            chart.draw_series([Text::new(name, (across.start * 1.03, level * 1.02), style)])?;
        }
    }
    Ok(())
}

/// Draws all settings of a method as points, and those without a cut-off as a line.
fn curve<B: DrawingBackend>(chart: &mut Chart<B>, rows: &[Row], method: Method) -> Result<(), DrawError<B>> {
    let (color, size) = (color(method), radius(method));
    let of = rows.iter().filter(|row| row.method == method);
    let whole = of.clone().filter(|row| row.limit.cutoff == crate::engine::Cutoff::OFF);
    let line = whole.map(|row| (cost(row), row.total.rmse));
    chart.draw_series(LineSeries::new(line, color.mix(0.7).stroke_width(1)))?;
    let points = of.map(|row| (cost(row), row.total.rmse));
    // One shape for each number of samples.
    match method.sampling.samples() {
        1 => chart.draw_series(points.map(|at| Circle::new(at, size, color.filled())))?,
        4 => chart.draw_series(points.map(|at| TriangleMarker::new(at, size + 2, color.filled())))?,
        9 => chart.draw_series(points.map(|at| Cross::new(at, size, color.stroke_width(1))))?,
        _ => chart.draw_series(points.map(|at| Circle::new(at, size, color.stroke_width(1))))?,
    };
    Ok(())
}

fn legend<B: DrawingBackend>(key: &Area<B>, methods: &[Method]) -> Result<(), DrawError<B>> {
    let style = ("sans-serif", 13).into_font().color(&BLACK);
    for (at, method) in (0..).zip(methods) {
        let y = 64 + 24 * at;
        let (color, size) = (color(*method), radius(*method));
        key.draw(&PathElement::new([(6, y), (34, y)], color.mix(0.7).stroke_width(1)))?;
        match method.sampling.samples() {
            1 => key.draw(&Circle::new((20, y), size, color.filled()))?,
            4 => key.draw(&TriangleMarker::new((20, y), size + 2, color.filled()))?,
            9 => key.draw(&Cross::new((20, y), size, color.stroke_width(1)))?,
            _ => key.draw(&Circle::new((20, y), size, color.stroke_width(1)))?,
        }
        key.draw(&Text::new(method.to_string(), (44, y - 8), style.clone()))?;
    }
    let y = 64 + 24 * i32::try_from(methods.len()).unwrap_or(0);
    key.draw(&PathElement::new([(6, y), (34, y)], BLACK.stroke_width(2)))?;
    key.draw(&Circle::new((20, y), 6, BLACK.stroke_width(2)))?;
    key.draw(&Text::new("Pareto front", (44, y - 8), style.clone()))?;
    let notes = [
        "A point is a depth (0 to 8)",
        "and a cut-off (none, 1/1024,",
        "1/256, 1/64, 1/16); the line",
        "joins the depths without one.",
        "Dashes: a level of guns with",
        "4, 6 and 8 bits. The front is",
        "without points that gain less",
        "than 1 %.",
    ];
    for (at, note) in (0..).zip(notes) {
        key.draw(&Text::new(note, (6, y + 28 + 20 * at), style.clone()))?;
    }
    Ok(())
}
