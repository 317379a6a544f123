//! PIXRECT, the raster library of SunOS, on a SUN SPARCstation: 1152 x 900, 256 colours of 16,777,216.
//!
//! A pixrect is a rectangle of pixels with operations, wherever the pixels are: in memory ([`MemPixrect`]), on a
//! frame buffer board ([`Cgthree`]), or in a part of another pixrect ([`Region`]). [`PixrectDisplay`] is the driver
//! that draws on any of them; [`emulated::Board`] is a cgthree to run it on where there is no real one. Names and
//! meanings are those of Sun's "Pixrect Reference Manual".

pub mod cgthree;
mod colormap;
mod display;
pub mod emulated;
mod error;
mod memory;
mod op;
mod region;
mod rop;

pub use cgthree::Cgthree;
pub use display::PixrectDisplay;
pub use error::PixrectError;
pub use memory::MemPixrect;
pub use op::{PIX_CLR, PIX_DONTCLIP, PIX_DST, PIX_SET, PIX_SRC, PixOp};
pub use region::Region;

use crate::display::Capabilities;
use rop::{CHUNK, chunks, clip, combine, first, inside};

/// What the screen can show: 1152 x 900 square pixels, 256 colours, 8 bits a gun.
pub const CAPABILITIES: Capabilities =
    Capabilities { width: 1152, height: 900, colors: 256, gun_max: 255, aspect: (1152, 900) };

/// A rectangle of pixels, given by its upper left pixel and its size. It may leave the pixrect on any side; with a
/// width or a height below 1 it is empty.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rect {
    /// Leftmost column, counted from the left of the pixrect.
    pub x: i32,
    /// Highest row, counted from the top of the pixrect.
    pub y: i32,
    /// Width in pixels.
    pub w: i32,
    /// Height in pixels.
    pub h: i32,
}

/// A rectangle of pixels with operations. (0, 0) is its upper left pixel.
///
/// An implementer supplies the size, the plane mask, the colormap and the access to one row of pixels; the
/// operations of the manual from [`Pixrect::pr_get`] on come with the trait. A pixel is handed over as one byte
/// whatever its depth; in a depth of 1 the byte is 0 or 1.
pub trait Pixrect {
    /// Width and height in pixels; each at most `i32::MAX`.
    fn size(&self) -> (u32, u32);

    /// Bits of a pixel: 1 or 8.
    fn depth(&self) -> u8;

    /// The plane mask: operations change only those bits of a pixel that are 1 in the mask.
    fn planes(&self) -> u8;

    /// Sets the plane mask.
    fn pr_putattributes(&mut self, planes: u8);

    /// Reads pixels of row `y` from column `x` to the right. Callers ask for pixels inside the pixrect; bytes for
    /// pixels outside are left as they were.
    fn read_row(&mut self, x: u32, y: u32, pixels: &mut [u8]);

    /// Writes pixels of row `y` from column `x` to the right, in all planes: the caller has applied the plane
    /// mask. Callers give pixels inside the pixrect; others are dropped.
    fn write_row(&mut self, x: u32, y: u32, pixels: &[u8]);

    /// Loads the colormap from entry `index` up; one level 0..=255 of each gun for every entry.
    ///
    /// # Errors
    /// [`PixrectError::Colormap`] for entries beyond 255 or arrays of different lengths;
    /// [`PixrectError::NoColormap`] where there is none, as in memory.
    fn pr_putcolormap(
        &mut self,
        index: usize,
        red: &[u8],
        green: &[u8],
        blue: &[u8],
    ) -> Result<(), PixrectError>;

    /// Reads the colormap from entry `index` up, as many entries as the arrays are long.
    ///
    /// # Errors
    /// Those of [`Pixrect::pr_putcolormap`].
    fn pr_getcolormap(
        &mut self,
        index: usize,
        red: &mut [u8],
        green: &mut [u8],
        blue: &mut [u8],
    ) -> Result<(), PixrectError>;

    /// Returns the value of the pixel at (`x`, `y`).
    ///
    /// # Errors
    /// [`PixrectError::OutOfBounds`] for a pixel outside the pixrect.
    fn pr_get(&mut self, x: i32, y: i32) -> Result<u8, PixrectError> {
        let (x, y) = inside(self.size(), x, y)?;
        let mut pixel = [0];
        self.read_row(x, y, &mut pixel);
        Ok(pixel[0])
    }

    /// Sets the pixel at (`x`, `y`) in the planes of the mask.
    ///
    /// # Errors
    /// [`PixrectError::OutOfBounds`] for a pixel outside the pixrect.
    fn pr_put(&mut self, x: i32, y: i32, value: u8) -> Result<(), PixrectError> {
        let (x, y) = inside(self.size(), x, y)?;
        combine(self, x, y, PIX_SRC, &mut [value]);
        Ok(())
    }

    /// Raster operation: combines the pixels of `to` with those of `source` whose upper left one is (`sx`, `sy`),
    /// clipped to both pixrects. On a destination of depth 8, a source of depth 1 stands for the colour of the
    /// operation where it has a 1 (colour 0 means all bits set) and for 0 where it has a 0.
    ///
    /// # Errors
    /// [`PixrectError::Depth`] for any other pair of different depths. With [`PIX_DONTCLIP`],
    /// [`PixrectError::OutOfBounds`] where clipping would have been needed; nothing is drawn then.
    fn pr_rop(
        &mut self,
        to: Rect,
        op: PixOp,
        source: &mut impl Pixrect,
        sx: i32,
        sy: i32,
    ) -> Result<(), PixrectError>
    where
        Self: Sized,
    {
        let stencil = source.depth() == 1 && self.depth() != 1;
        if source.depth() != self.depth() && !stencil {
            return Err(PixrectError::Depth);
        }
        let ink = if op.color() == 0 { 0xFF } else { op.color() };
        let area = clip(to, self.size(), Some(((sx, sy), source.size())), op)?;
        for row in 0..area.height {
            for (column, len) in chunks(area.width, false) {
                let mut buffer = [0; CHUNK as usize];
                let pixels = first(&mut buffer, len);
                source.read_row(area.source.0 + column, area.source.1 + row, pixels);
                if stencil {
                    pixels.iter_mut().for_each(|p| *p = if *p == 0 { 0 } else { ink });
                }
                combine(self, area.to.0 + column, area.to.1 + row, op, pixels);
            }
        }
        Ok(())
    }

    /// Raster operation with a null source: combines the pixels of `to` with the colour of the operation.
    ///
    /// # Errors
    /// [`PixrectError::OutOfBounds`] with [`PIX_DONTCLIP`] where clipping would have been needed; nothing is
    /// drawn then.
    fn pr_rop_null(&mut self, to: Rect, op: PixOp) -> Result<(), PixrectError> {
        let color = if self.depth() == 1 { u8::from(op.color() != 0) } else { op.color() };
        let area = clip(to, self.size(), None, op)?;
        for row in 0..area.height {
            for (column, len) in chunks(area.width, false) {
                let mut buffer = [color; CHUNK as usize];
                combine(self, area.to.0 + column, area.to.1 + row, op, first(&mut buffer, len));
            }
        }
        Ok(())
    }

    /// Raster operation whose source is the pixrect itself, from (`sx`, `sy`). The two rectangles may overlap, as
    /// in scrolling.
    ///
    /// # Errors
    /// [`PixrectError::OutOfBounds`] with [`PIX_DONTCLIP`] where clipping would have been needed; nothing is
    /// drawn then.
    fn pr_rop_self(&mut self, to: Rect, op: PixOp, sx: i32, sy: i32) -> Result<(), PixrectError> {
        let area = clip(to, self.size(), Some(((sx, sy), self.size())), op)?;
        // Starting on the side towards which the pixels move, none is overwritten before it is read.
        let (down, right) = (area.to.1 > area.source.1, area.to.0 > area.source.0);
        for step in 0..area.height {
            let row = if down { area.height - 1 - step } else { step };
            for (column, len) in chunks(area.width, right) {
                let mut buffer = [0; CHUNK as usize];
                let pixels = first(&mut buffer, len);
                self.read_row(area.source.0 + column, area.source.1 + row, pixels);
                combine(self, area.to.0 + column, area.to.1 + row, op, pixels);
            }
        }
        Ok(())
    }

    /// Returns the part of this pixrect that `part` covers as a pixrect of its own; empty if it covers none. Its
    /// plane mask is a copy of this one's, so later changes of either do not concern the other.
    fn pr_region(&mut self, part: Rect) -> Region<'_, Self>
    where
        Self: Sized,
    {
        Region::new(self, part)
    }
}

impl<P: Pixrect + ?Sized> Pixrect for &mut P {
    fn size(&self) -> (u32, u32) {
        P::size(self)
    }
    fn depth(&self) -> u8 {
        P::depth(self)
    }
    fn planes(&self) -> u8 {
        P::planes(self)
    }
    fn pr_putattributes(&mut self, planes: u8) {
        P::pr_putattributes(self, planes);
    }
    fn read_row(&mut self, x: u32, y: u32, pixels: &mut [u8]) {
        P::read_row(self, x, y, pixels);
    }
    fn write_row(&mut self, x: u32, y: u32, pixels: &[u8]) {
        P::write_row(self, x, y, pixels);
    }
    fn pr_putcolormap(&mut self, index: usize, r: &[u8], g: &[u8], b: &[u8]) -> Result<(), PixrectError> {
        P::pr_putcolormap(self, index, r, g, b)
    }
    fn pr_getcolormap(
        &mut self,
        index: usize,
        r: &mut [u8],
        g: &mut [u8],
        b: &mut [u8],
    ) -> Result<(), PixrectError> {
        P::pr_getcolormap(self, index, r, g, b)
    }
}
