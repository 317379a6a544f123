//! Error diffusion: what rounding loses of a pixel goes to its neighbours that are drawn later.

use core::fmt;
use core::marker::PhantomData;

use rta_core::color::Rgb;

use super::{Dither, entry};
use crate::quantize::ColorTable;

/// Which parts of a pixel's error its neighbours get, in sixteenths. A type, so that a program multiplies by constants.
pub trait Weights {
    /// The next pixel of the row.
    const AHEAD: i32;
    /// Of the next row, the pixel behind, to the side from which the pixels come.
    const BEHIND: i32;
    /// Of the next row, the pixel ahead.
    const BELOW_AHEAD: i32;
    /// All together, with the pixel below, which gets the rest.
    const SUM: i32;
}

/// 7, 3, 5 and 1 sixteenths, the whole error: R. Floyd and L. Steinberg, "An Adaptive Algorithm for Spatial Grey Scale", Proceedings of the
/// Society for Information Display 17, 2, 1976. Best with evenly spaced tables.
#[derive(Clone, Copy, Debug)]
pub struct FloydSteinberg;

impl Weights for FloydSteinberg {
    const AHEAD: i32 = 7;
    const BEHIND: i32 = 3;
    const BELOW_AHEAD: i32 = 1;
    const SUM: i32 = 16;
}

/// 6, 3, 4 and 1 sixteenths. An eighth of the error is lost, so that no error wanders far through a picture whose table has nothing
/// near: fewer stray dots with irregular tables.
#[derive(Clone, Copy, Debug)]
pub struct Damped;

impl Weights for Damped {
    const AHEAD: i32 = 6;
    const BEHIND: i32 = 3;
    const BELOW_AHEAD: i32 = 1;
    const SUM: i32 = 14;
}

/// What error diffusion keeps of a column of the picture: 4 bytes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cell {
    /// The error that comes down to it from the row before or, once the column is drawn, that which this row sends down.
    error: Rgb<i8>,
    /// The entry of its pixel in this row.
    index: u8,
}

/// Error diffusion, row by row and each row in the direction opposite to the one before.
///
/// Rows must be whole and come in order, from top to bottom. A row that does not follow the one before, or is not of its length,
/// begins a new picture.
///
/// `W` is how the error is shared out, `M` memory for a row, one [`Cell`] a pixel: an array, a `Vec`, or a slice.
#[derive(Clone, Debug)]
pub struct Diffusion<W, M> {
    weights: PhantomData<W>,
    cells: M,
    /// The column of the row's first pixel.
    left: u32,
    /// The row after it and its length: what the next row must have, to follow.
    follows: Option<(u32, usize)>,
    /// Whether this row is drawn from right to left.
    leftward: bool,
    /// What the last pixel sends to the next one of its row.
    ahead: Rgb<i32>,
    /// What the last pixel sends to the one below the next.
    below_ahead: Rgb<i32>,
}

/// The memory for error diffusion is too small.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DitherError {
    /// Pixels of a row for which there is memory.
    pub memory: usize,
    /// Pixels of a row.
    pub width: usize,
}

impl fmt::Display for DitherError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { memory, width } = self;
        write!(f, "error diffusion over rows of {width} pixels has memory for {memory}")
    }
}

impl core::error::Error for DitherError {}

impl<W: Weights, M: AsRef<[Cell]> + AsMut<[Cell]>> Diffusion<W, M> {
    /// Makes the dithering for rows of at most `width` pixels, with memory for as many or more. What is in the memory does not matter.
    ///
    /// # Errors
    /// [`DitherError`] if the memory is too small. Of a row that is longer all the same, the pixels beyond the memory send nothing down, and
    /// it comes from left to right.
    pub fn new(cells: M, width: usize) -> Result<Self, DitherError> {
        let memory = cells.as_ref().len();
        if memory < width {
            return Err(DitherError { memory, width });
        }
        Ok(Self {
            weights: PhantomData,
            cells,
            left: 0,
            follows: None,
            leftward: false,
            ahead: Rgb::new(0, 0, 0),
            below_ahead: Rgb::new(0, 0, 0),
        })
    }
}

impl<W, M> Diffusion<W, M> {
    /// Returns the place of a column of the screen in the memory.
    fn column(&self, x: u32) -> usize {
        x.wrapping_sub(self.left) as usize
    }
}

impl<W: Weights, M: AsRef<[Cell]> + AsMut<[Cell]>> Dither for Diffusion<W, M> {
    fn start_row(&mut self, x: u32, y: u32, len: usize) -> bool {
        if self.follows == Some((y, len)) && self.left == x {
            self.leftward = !self.leftward && len <= self.cells.as_ref().len();
        } else {
            self.leftward = false;
            self.cells.as_mut().fill(Cell::default());
        }
        self.left = x;
        self.follows = Some((y.saturating_add(1), len));
        (self.ahead, self.below_ahead) = (Rgb::new(0, 0, 0), Rgb::new(0, 0, 0));
        self.leftward
    }

    fn index<T: ColorTable + ?Sized>(
        &mut self,
        table: &mut T,
        gun_max: u8,
        (x, _): (u32, u32),
        light: Rgb<u8>,
    ) -> u8 {
        let at = self.column(x);
        let cells = self.cells.as_mut();
        let above = cells.get(at).map_or(Rgb::new(0, 0, 0), |cell| cell.error);
        let error = above.zip(self.ahead, |above, ahead| i32::from(above) + ahead);
        // At most 255 + 127 + 112 in size.
        let wanted =
            light.zip(error, |level, error| (i32::from(level) + error).clamp(0, 255).to_le_bytes()[0]);
        let (index, shown) = entry(table, gun_max, light, wanted);
        let lost = wanted.zip(shown, |wanted, shown| i32::from(wanted) - i32::from(shown));
        let part = |weight: i32| lost.map(|lost| (weight * lost) >> 4);
        self.ahead = part(W::AHEAD);
        let (behind, below_ahead) = (part(W::BEHIND), part(W::BELOW_AHEAD));
        // The rest, so that no more is lost by rounding than the weights say.
        let given = self.ahead.zip(behind, |a, b| a + b).zip(below_ahead, |a, b| a + b);
        let below = part(W::SUM).zip(given, |all, given| all - given).zip(self.below_ahead, |a, b| a + b);
        self.below_ahead = below_ahead;
        if let Some(here) = cells.get_mut(at) {
            *here = Cell { error: below.map(saturated), index };
        }
        let place = if self.leftward { at.wrapping_add(1) } else { at.wrapping_sub(1) };
        if let Some(cell) = cells.get_mut(place) {
            cell.error = cell.error.zip(behind, |so_far, more| saturated(i32::from(so_far) + more));
        }
        index
    }

    fn drawn(&self, x: u32) -> u8 {
        self.cells.as_ref().get(self.column(x)).map_or(0, |cell| cell.index)
    }
}

/// Returns the nearest number of 8 bits. Errors are nearly always within them: a table has entries that near to most colours.
fn saturated(error: i32) -> i8 {
    // Clamped, it is its low byte.
    error.clamp(i8::MIN.into(), i8::MAX.into()).to_le_bytes()[0].cast_signed()
}
