//! Drawings by lines and text, as SVG and as pixels: what the diagrams of `rta report` and the curves of `rta figures` have in common.

use std::sync::Once;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};
use rta_core::color::Rgb;

use crate::picture::file::{Displayed, Pixels};
use crate::picture::raster::Size;

/// Why a drawing fails on a back end.
pub type DrawError<B> = DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>;
/// An area whose coordinates are pixels.
pub type Area<B> = DrawingArea<B, Shift>;

/// The colour of the lines at the labels of an axis.
pub const BOLD: RGBColor = RGBColor(215, 215, 215);
/// The colour of the lines between the labels of an axis.
pub const LIGHT: RGBColor = RGBColor(240, 240, 240);

/// Why a diagram cannot be drawn.
#[derive(Debug, thiserror::Error)]
#[error("cannot draw the diagram: {0}")]
pub struct DiagramError(String);

impl DiagramError {
    fn new(error: impl core::fmt::Display) -> Self {
        Self(error.to_string())
    }
}

/// What can be drawn on any back end.
pub trait Drawing {
    /// Width and height in pixels.
    const SIZE: (u32, u32);

    /// Draws it on an area of that size, whose ground is white.
    ///
    /// # Errors
    /// Those of the back end.
    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Result<(), DrawError<B>>;
}

/// Returns a drawing as SVG, with its text as text elements.
///
/// # Errors
/// [`DiagramError`].
pub fn svg<D: Drawing>(drawing: &D) -> Result<String, DiagramError> {
    let mut text = String::new();
    draw(&SVGBackend::with_string(&mut text, D::SIZE).into_drawing_area(), drawing)?;
    Ok(text)
}

/// Returns a drawing's pixels, row by row from the top.
///
/// # Errors
/// [`DiagramError`].
pub fn pixels<D: Drawing>(drawing: &D) -> Result<Vec<Rgb<u8>>, DiagramError> {
    let mut pixels = vec![0; D::SIZE.0 as usize * D::SIZE.1 as usize * 3];
    draw(&BitMapBackend::with_buffer(&mut pixels, D::SIZE).into_drawing_area(), drawing)?;
    Ok(pixels.chunks_exact(3).filter_map(|p| Some(Rgb::new(*p.first()?, *p.get(1)?, *p.get(2)?))).collect())
}

/// Returns a drawing as a picture with square pixels.
///
/// # Errors
/// [`DiagramError`].
pub fn displayed<D: Drawing>(drawing: &D) -> Result<Displayed, DiagramError> {
    let pixels = Pixels::Direct(pixels(drawing)?);
    let size = Size::new(D::SIZE.0, D::SIZE.1).map_err(DiagramError::new)?;
    Ok(Displayed { size, aspect: size.ratio(), pixels })
}

fn draw<B: DrawingBackend>(area: &Area<B>, drawing: &impl Drawing) -> Result<(), DiagramError> {
    font();
    let drawn = area.fill(&WHITE).and_then(|()| drawing.draw(area)).and_then(|()| area.present());
    drawn.map_err(DiagramError::new)
}

/// A font for machines without one.
fn font() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // It is a font, or there is none and drawing says so.
        let _ = register_font("sans-serif", FontStyle::Normal, epaint_default_fonts::HACK_REGULAR);
    });
}
