//! One table with one dithering: its picture, how different that looks, and what it costs.

use super::memory;
use super::traced::Traced;
use crate::picture::coloring::Coloring;
use crate::picture::device::Device;
use crate::picture::file::Displayed;
use crate::study::difference::Difference;
use crate::study::error::StudyError;
use crate::study::measure::{Pair, PixelsPerDegree, flip, mean};

/// A row of the table.
#[derive(Clone, Debug)]
pub struct Row {
    /// Colour table and dithering.
    pub coloring: Coloring,
    /// The picture that the device shows.
    pub picture: Displayed,
    /// How different it looks at the device's own distance.
    pub own: Difference,
    /// FLIP on a screen of today, which has [`PixelsPerDegree::DEFAULT`].
    pub fine: f64,
    /// Instructions that turn a pixel's light into an index, if they were counted.
    pub instructions: Option<f64>,
    /// Bytes of RAM.
    pub memory: usize,
}

impl Row {
    /// Shows a picture on a device and measures it. Instructions are not counted.
    ///
    /// # Errors
    /// Those of [`Traced::displayed`].
    pub fn measured(device: Device, coloring: Coloring, traced: &Traced) -> Result<Self, StudyError> {
        let picture = traced.displayed(device, coloring)?;
        let colors = picture.colors();
        let pair = Pair::new(&traced.reference, &colors, traced.size)?;
        let own = Difference::of(&pair, device.pixels_per_degree());
        let fine = mean(&flip::map(&pair, PixelsPerDegree::DEFAULT));
        let memory = memory::bytes(coloring, traced.size).map_err(StudyError::palette)?;
        drop(colors);
        Ok(Self { coloring, picture, own, fine, instructions: None, memory })
    }

    /// Returns whether this is what a device does if nothing else is asked for.
    #[must_use]
    pub fn is_default(&self, device: Device) -> bool {
        let Coloring { table, dither, .. } = Coloring::of(device);
        (self.coloring.table, self.coloring.dither) == (table, dither)
    }
}
