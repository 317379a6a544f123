//! A diagram of curves, each named where it ends.

use core::ops::Range;

use plotters::prelude::*;

use crate::study::plot::{Area, BOLD, DrawError, Drawing, LIGHT};

/// Points of a curve.
const POINTS: u32 = 480;

/// Pixels of the names beside the curves.
const NAMES: u32 = 250;

/// Pixels between two names, one below the other.
const LINE: i32 = 22;

/// Pixels of the line before a name.
const SAMPLE: i32 = 34;

/// Pixels between the diagram's edge and the first or the last name.
const MARGIN: i32 = 60;

/// Colours that differ to the colour-blind too (Okabe and Ito's palette), without yellow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// For what the others are compared with.
    Black,
    /// Blue; the blue register.
    Blue,
    /// Vermilion; the red register.
    Red,
    /// Bluish green; the green register.
    Green,
    /// Reddish purple.
    Purple,
    /// Orange.
    Orange,
    /// Sky blue.
    Sky,
}

impl Ink {
    const fn color(self) -> RGBColor {
        match self {
            Self::Black => BLACK,
            Self::Blue => RGBColor(0, 114, 178),
            Self::Red => RGBColor(213, 94, 0),
            Self::Green => RGBColor(0, 158, 115),
            Self::Purple => RGBColor(204, 121, 167),
            Self::Orange => RGBColor(230, 159, 0),
            Self::Sky => RGBColor(86, 180, 233),
        }
    }
}

/// A line from point to point.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Its name.
    pub name: String,
    /// Its colour.
    pub ink: Ink,
    /// Pixels of a dash and of the gap after it; none for a line without gaps.
    pub dashes: Option<(u32, u32)>,
    /// Its points from left to right.
    pub points: Vec<(f64, f64)>,
}

impl Curve {
    /// Returns the curve of a function over a range of its argument, both ends included.
    pub fn of(name: impl Into<String>, ink: Ink, over: &Range<f64>, value: impl Fn(f64) -> f64) -> Self {
        let place = |point: u32| f64::from(point) / f64::from(POINTS);
        let x = |point| over.start + (over.end - over.start) * place(point);
        let points = (0..=POINTS).map(x).map(|x| (x, value(x))).collect();
        Self { name: name.into(), ink, dashes: None, points }
    }

    /// Returns the curve with long dashes.
    pub fn dashed(self) -> Self {
        Self { dashes: Some((12, 6)), ..self }
    }

    /// Returns the curve with short dashes.
    pub fn dotted(self) -> Self {
        Self { dashes: Some((3, 5)), ..self }
    }

    /// Returns the style of its line.
    fn style(&self) -> ShapeStyle {
        self.ink.color().stroke_width(2)
    }
}

/// What an axis measures, and the part of it that is shown.
#[derive(Clone, Debug)]
pub struct Axis {
    /// The quantity and its unit.
    pub name: &'static str,
    /// From the left, or from below.
    pub range: Range<f64>,
}

/// Curves over one pair of axes.
#[derive(Clone, Debug)]
pub struct Chart {
    /// What is shown.
    pub title: &'static str,
    /// The axis of the argument.
    pub x: Axis,
    /// The axis of the values.
    pub y: Axis,
    /// The curves. Of two that end at one height, the name of the first stands higher.
    pub curves: Vec<Curve>,
}

/// Returns the text at a place of an axis: up to three decimals.
fn label(value: f64) -> String {
    let text = format!("{value:.3}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

/// Moves heights apart, so that each is at least a line below the one before and all lie from `top` to `bottom` if there is room.
/// They come in ascending order.
fn spread(heights: &mut [i32], top: i32, bottom: i32) {
    let mut least = top;
    for height in heights.iter_mut() {
        *height = (*height).max(least);
        least = *height + LINE;
    }
    let mut most = bottom;
    for height in heights.iter_mut().rev() {
        *height = (*height).min(most);
        most = *height - LINE;
    }
}

impl Drawing for Chart {
    const SIZE: (u32, u32) = (960, 560);

    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Result<(), DrawError<B>> {
        let (left, names) = area.split_horizontally(Self::SIZE.0 - NAMES);
        let mut chart = ChartBuilder::on(&left)
            .caption(self.title, ("sans-serif", 20))
            .margin(12)
            .x_label_area_size(48)
            .y_label_area_size(66)
            .build_cartesian_2d(self.x.range.clone(), self.y.range.clone())?;
        chart
            .configure_mesh()
            .x_desc(self.x.name)
            .y_desc(self.y.name)
            .x_labels(10)
            .y_labels(10)
            .x_label_formatter(&|value| label(*value))
            .y_label_formatter(&|value| label(*value))
            .axis_desc_style(("sans-serif", 16))
            .label_style(("sans-serif", 14))
            .light_line_style(LIGHT)
            .bold_line_style(BOLD)
            .draw()?;
        // The first curve lies on top of the others.
        for curve in self.curves.iter().rev() {
            let points = curve.points.iter().copied();
            match curve.dashes {
                None => chart.draw_series(LineSeries::new(points, curve.style()))?,
                Some((dash, gap)) => {
                    chart.draw_series(DashedLineSeries::new(points, dash, gap, curve.style()))?
                }
            };
        }
        let end = |curve: &Curve| curve.points.last().map_or(MARGIN, |&point| chart.backend_coord(&point).1);
        let mut ends: Vec<_> = self.curves.iter().map(|curve| (end(curve), curve)).collect();
        ends.sort_by_key(|(height, _)| *height);
        let mut heights: Vec<_> = ends.iter().map(|(height, _)| *height).collect();
        let bottom = i32::try_from(Self::SIZE.1).unwrap_or(i32::MAX) - MARGIN;
        spread(&mut heights, MARGIN, bottom);
        for (height, (_, curve)) in heights.into_iter().zip(ends) {
            let (from, to) = ((4, height), (4 + SAMPLE, height));
            if let Some((dash, gap)) = curve.dashes {
                let pitch = i32::try_from(dash + gap).unwrap_or(SAMPLE);
                let dash = i32::try_from(dash).unwrap_or(SAMPLE);
                for start in (from.0..to.0).step_by(usize::try_from(pitch).unwrap_or(1)) {
                    let stop = (start + dash).min(to.0);
                    names.draw(&PathElement::new([(start, height), (stop, height)], curve.style()))?;
                }
            } else {
                names.draw(&PathElement::new([from, to], curve.style()))?;
            }
            let style = ("sans-serif", 15).into_font().color(&BLACK);
            names.draw(&Text::new(curve.name.clone(), (12 + SAMPLE, height - 8), style))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod unit {
    use super::{LINE, label, spread};

    #[test]
    fn labels_are_short() {
        assert_eq!(
            [0.0, -0.0, 0.5, 1.35, 90.0, -90.0, 400.0].map(label),
            ["0", "0", "0.5", "1.35", "90", "-90", "400"]
        );
    }

    #[test]
    fn names_do_not_overlap() {
        let mut heights = [10, 12, 100, 200, 200];
        spread(&mut heights, 20, 210);
        assert_eq!(heights, [20, 20 + LINE, 100, 210 - LINE, 210]);
    }
}
