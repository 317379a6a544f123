//! Error diffusion: what rounding loses of a pixel goes to its neighbours that are drawn later.

use core::fmt;
use core::marker::PhantomData;

use rta_core::color::Rgb;

use super::{DirectDither, Dither, entry};
use crate::display::{expand, reduce};
use crate::guns::{Guns, Three};
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

/// What error diffusion keeps of a column of the picture.
#[derive(Clone, Copy, Debug, Default)]
pub struct Column<G: Guns, K> {
    /// The error that comes down to it from the row before or, once the column is drawn, that which this row sends down.
    error: G::Each<i8>,
    /// The entry, or the levels, of its pixel in this row.
    drawn: K,
}

/// What error diffusion keeps of a column of a display with a colour table: 4 bytes.
pub type Cell = Column<Three, u8>;

/// What error diffusion keeps of a column of a display with direct colour: 6 bytes, 2 where there is one gun.
pub type DirectCell<G> = Column<G, <G as Guns>::Each<u8>>;

/// Error diffusion, row by row and each row in the direction opposite to the one before.
///
/// Rows must be whole and come in order, from top to bottom. A row that does not follow the one before, or is not of its length,
/// begins a new picture.
///
/// `W` is how the error is shared out, `M` memory for a row, one [`Cell`] a pixel: an array, a `Vec`, or a slice. On a display with direct
/// colour it is one [`DirectCell`] a pixel, and `G` says how many guns the display has.
#[derive(Clone, Debug)]
pub struct Diffusion<W, M, G: Guns = Three> {
    weights: PhantomData<W>,
    cells: M,
    /// The column of the row's first pixel.
    left: u32,
    /// The row after it and its length: what the next row must have, to follow.
    follows: Option<(u32, usize)>,
    /// Whether this row is drawn from right to left.
    leftward: bool,
    /// What the last pixel sends to the next one of its row.
    ahead: G::Each<i32>,
    /// What the last pixel sends to the one below the next.
    below_ahead: G::Each<i32>,
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

impl<W: Weights, M, G: Guns> Diffusion<W, M, G> {
    /// Makes the dithering for rows of at most `width` pixels, with memory for as many or more. What is in the memory does not matter.
    ///
    /// # Errors
    /// [`DitherError`] if the memory is too small. Of a row that is longer all the same, the pixels beyond the memory send nothing down, and
    /// it comes from left to right.
    pub fn new<K>(cells: M, width: usize) -> Result<Self, DitherError>
    where
        M: AsRef<[Column<G, K>]>,
    {
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
            ahead: G::Each::default(),
            below_ahead: G::Each::default(),
        })
    }

    /// Returns the place of a column of the screen in the memory.
    fn column(&self, x: u32) -> usize {
        x.wrapping_sub(self.left) as usize
    }

    /// Begins a row of `len` pixels from column `x` of row `y`. Returns whether it goes from right to left.
    fn start<K: Copy + Default>(&mut self, x: u32, y: u32, len: usize) -> bool
    where
        M: AsMut<[Column<G, K>]>,
    {
        let cells = self.cells.as_mut();
        if self.follows == Some((y, len)) && self.left == x {
            self.leftward = !self.leftward && len <= cells.len();
        } else {
            self.leftward = false;
            cells.fill(Column::default());
        }
        self.left = x;
        self.follows = Some((y.saturating_add(1), len));
        (self.ahead, self.below_ahead) = Default::default();
        self.leftward
    }

    /// Draws the next pixel, which is at column `x`: adds the errors of its neighbours to its light, asks `show` for what stands for that
    /// and the light that this shows, and shares out the difference. Returns what stands for it.
    fn draw<K: Copy>(
        &mut self,
        x: u32,
        light: G::Each<u8>,
        show: impl FnOnce(G::Each<u8>) -> (K, G::Each<u8>),
    ) -> K
    where
        M: AsMut<[Column<G, K>]>,
    {
        let at = self.column(x);
        let cells = self.cells.as_mut();
        let above = cells.get(at).map_or(G::Each::default(), |cell| cell.error);
        let error = G::zip(above, self.ahead, |above, ahead| i32::from(above) + ahead);
        // At most 255 + 127 + 112 in size.
        let wanted =
            G::zip(light, error, |level, error| (i32::from(level) + error).clamp(0, 255).to_le_bytes()[0]);
        let (drawn, shown) = show(wanted);
        let lost = G::zip(wanted, shown, |wanted, shown| i32::from(wanted) - i32::from(shown));
        let part = |weight: i32| G::map(lost, |lost: i32| (weight * lost) >> 4);
        let plus = |a: i32, b: i32| a + b;
        self.ahead = part(W::AHEAD);
        let (behind, below_ahead) = (part(W::BEHIND), part(W::BELOW_AHEAD));
        // The rest, so that no more is lost by rounding than the weights say.
        let given = G::zip(G::zip(self.ahead, behind, plus), below_ahead, plus);
        let below = G::zip(part(W::SUM), given, |all: i32, given: i32| all - given);
        let below = G::zip(below, self.below_ahead, plus);
        self.below_ahead = below_ahead;
        if let Some(here) = cells.get_mut(at) {
            *here = Column { error: G::map(below, saturated), drawn };
        }
        let place = if self.leftward { at.wrapping_add(1) } else { at.wrapping_sub(1) };
        if let Some(cell) = cells.get_mut(place) {
            cell.error = G::zip(cell.error, behind, |so_far, more| saturated(i32::from(so_far) + more));
        }
        drawn
    }
}

impl<W: Weights, M: AsRef<[Cell]> + AsMut<[Cell]>> Dither for Diffusion<W, M> {
    fn start_row(&mut self, x: u32, y: u32, len: usize) -> bool {
        self.start(x, y, len)
    }

    fn index<T: ColorTable + ?Sized>(
        &mut self,
        table: &mut T,
        gun_max: u8,
        (x, _): (u32, u32),
        light: Rgb<u8>,
    ) -> u8 {
        self.draw(x, light, |wanted| entry(table, gun_max, light, wanted))
    }

    fn drawn(&self, x: u32) -> u8 {
        self.cells.as_ref().get(self.column(x)).map_or(0, |cell| cell.drawn)
    }
}

impl<W, M, G> DirectDither<G> for Diffusion<W, M, G>
where
    W: Weights,
    M: AsRef<[DirectCell<G>]> + AsMut<[DirectCell<G>]>,
    G: Guns,
{
    fn start_row(&mut self, x: u32, y: u32, len: usize) -> bool {
        self.start(x, y, len)
    }

    fn levels(&mut self, gun_max: G::Each<u8>, (x, _): (u32, u32), light: G::Each<u8>) -> G::Each<u8> {
        self.draw(x, light, |wanted| {
            let levels = G::zip(wanted, gun_max, reduce);
            (levels, G::zip(levels, gun_max, expand))
        })
    }

    fn drawn(&self, x: u32) -> G::Each<u8> {
        self.cells.as_ref().get(self.column(x)).map_or(G::Each::default(), |cell| cell.drawn)
    }
}

/// Returns the nearest number of 8 bits. Errors are nearly always within them: a table has entries that near to most colours.
fn saturated(error: i32) -> i8 {
    // Clamped, it is its low byte.
    error.clamp(i8::MIN.into(), i8::MAX.into()).to_le_bytes()[0].cast_signed()
}
