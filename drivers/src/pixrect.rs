//! PIXRECT (SUN SPARCstation, SunOS): 1152 x 900, 256 colours of 16 million.
//!
//! A pixrect is a rectangle of pixels with operations, wherever the pixels are: [`MemPixrect`] in memory,
//! [`Cgthree`] on a frame buffer board, [`Region`] a part of another. [`PixrectDisplay`] is the driver that
//! draws on any of them; [`emulated::Board`] is a cgthree to run it on where there is no real one. Names and
//! meanings are those of Sun's "Pixrect Reference Manual".

pub mod cgthree;
mod display;
pub mod emulated;
mod memory;
mod op;
mod region;

use core::fmt;

use rta_core::color::Rgb;

pub use cgthree::Cgthree;
pub use display::PixrectDisplay;
pub use memory::MemPixrect;
pub use op::{PIX_CLR, PIX_DONTCLIP, PIX_DST, PIX_SET, PIX_SRC, PixOp};
pub use region::Region;

use crate::display::Capabilities;

/// 1152 x 900 on a screen of that shape, 256 colours, 8 bits a gun.
pub const CAPABILITIES: Capabilities =
    Capabilities { width: 1152, height: 900, colors: 256, gun_max: 255, aspect: (1152, 900) };

/// Pixels combined at once; they wait on the stack.
const CHUNK: u32 = 64;

/// A rectangle: upper left pixel and size. It may leave the pixrect on any side; a width or height below 1
/// is empty.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rect {
    /// Leftmost column.
    pub x: i32,
    /// Highest row.
    pub y: i32,
    /// Width in pixels.
    pub w: i32,
    /// Height in pixels.
    pub h: i32,
}

/// A rectangle of pixels with operations.
///
/// An implementer supplies what touches the pixels; the operations by their own names come with the trait.
/// A pixel is one byte here whatever its depth: 0 or 1 in a depth of 1.
pub trait Pixrect {
    /// Width and height in pixels; each at most `i32::MAX`.
    fn size(&self) -> (u32, u32);

    /// Bits in a pixel: 1 or 8.
    fn depth(&self) -> u8;

    /// The plane mask: bits of a pixel that operations may change.
    fn planes(&self) -> u8;

    /// Sets the plane mask.
    fn pr_putattributes(&mut self, planes: u8);

    /// Reads pixels of one row, all of them inside. What is not inside is left as it was.
    fn read_row(&mut self, x: u32, y: u32, pixels: &mut [u8]);

    /// Writes pixels of one row, all of them inside, without regard to the plane mask. What is not inside
    /// is dropped.
    fn write_row(&mut self, x: u32, y: u32, pixels: &[u8]);

    /// Loads entries `index..` of the colormap.
    ///
    /// # Errors
    /// [`PixrectError::Colormap`] for entries beyond 256 or guns of different counts;
    /// [`PixrectError::NoColormap`] where there is none (memory).
    fn pr_putcolormap(
        &mut self,
        index: usize,
        red: &[u8],
        green: &[u8],
        blue: &[u8],
    ) -> Result<(), PixrectError>;

    /// Reads entries `index..` of the colormap.
    ///
    /// # Errors
    /// As [`Pixrect::pr_putcolormap`].
    fn pr_getcolormap(
        &mut self,
        index: usize,
        red: &mut [u8],
        green: &mut [u8],
        blue: &mut [u8],
    ) -> Result<(), PixrectError>;

    /// The value of the pixel at (`x`, `y`).
    ///
    /// # Errors
    /// [`PixrectError::OutOfBounds`].
    fn pr_get(&mut self, x: i32, y: i32) -> Result<u8, PixrectError> {
        let (x, y) = inside(self.size(), x, y)?;
        let mut pixel = [0];
        self.read_row(x, y, &mut pixel);
        Ok(pixel[0])
    }

    /// Sets the pixel at (`x`, `y`) in the planes of the mask.
    ///
    /// # Errors
    /// [`PixrectError::OutOfBounds`].
    fn pr_put(&mut self, x: i32, y: i32, value: u8) -> Result<(), PixrectError> {
        let (x, y) = inside(self.size(), x, y)?;
        combine(self, x, y, PIX_SRC, &mut [value]);
        Ok(())
    }

    /// Raster operation: combines the pixels of `to` with those of `source` from (`sx`, `sy`), clipped to
    /// both. A source of depth 1 writes the colour of the operation where it has a 1 (0 stands for all
    /// bits set) and 0 where it has a 0.
    ///
    /// # Errors
    /// [`PixrectError::Depth`] for depths that differ otherwise. With `PIX_DONTCLIP`,
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
        let blit = clip(to, self.size(), Some(((sx, sy), source.size())), op)?;
        for row in 0..blit.h {
            for (column, len) in chunks(blit.w, false) {
                let mut buffer = [0; CHUNK as usize];
                let pixels = first(&mut buffer, len);
                source.read_row(blit.source.0 + column, blit.source.1 + row, pixels);
                if stencil {
                    pixels.iter_mut().for_each(|p| *p = if *p == 0 { 0 } else { ink });
                }
                combine(self, blit.to.0 + column, blit.to.1 + row, op, pixels);
            }
        }
        Ok(())
    }

    /// `pr_rop` with a null source: combines the pixels of `to` with the colour of the operation.
    ///
    /// # Errors
    /// As [`Pixrect::pr_rop`] has them for `PIX_DONTCLIP`.
    fn pr_rop_null(&mut self, to: Rect, op: PixOp) -> Result<(), PixrectError> {
        let color = if self.depth() == 1 { u8::from(op.color() != 0) } else { op.color() };
        let blit = clip(to, self.size(), None, op)?;
        for row in 0..blit.h {
            for (column, len) in chunks(blit.w, false) {
                let mut buffer = [color; CHUNK as usize];
                combine(self, blit.to.0 + column, blit.to.1 + row, op, first(&mut buffer, len));
            }
        }
        Ok(())
    }

    /// `pr_rop` with itself for a source: the rectangles may overlap (scrolling).
    ///
    /// # Errors
    /// As [`Pixrect::pr_rop`].
    fn pr_rop_self(&mut self, to: Rect, op: PixOp, sx: i32, sy: i32) -> Result<(), PixrectError> {
        let blit = clip(to, self.size(), Some(((sx, sy), self.size())), op)?;
        // Start at the end towards which the pixels move, so that none is overwritten before it is read.
        let (down, right) = (blit.to.1 > blit.source.1, blit.to.0 > blit.source.0);
        for step in 0..blit.h {
            let row = if down { blit.h - 1 - step } else { step };
            for (column, len) in chunks(blit.w, right) {
                let mut buffer = [0; CHUNK as usize];
                let pixels = first(&mut buffer, len);
                self.read_row(blit.source.0 + column, blit.source.1 + row, pixels);
                combine(self, blit.to.0 + column, blit.to.1 + row, op, pixels);
            }
        }
        Ok(())
    }

    /// A pixrect of a part of this one, cut to what is inside. It begins with this one's plane mask and
    /// has its own from then on.
    fn pr_region(&mut self, part: Rect) -> Region<'_, Self>
    where
        Self: Sized,
    {
        Region::new(self, part)
    }
}

/// A rectangle after clipping: upper left pixel there and in the source, width and height. Both lie inside.
#[derive(Default)]
struct Blit {
    to: (u32, u32),
    source: (u32, u32),
    w: u32,
    h: u32,
}

fn inside((width, height): (u32, u32), x: i32, y: i32) -> Result<(u32, u32), PixrectError> {
    match (u32::try_from(x), u32::try_from(y)) {
        (Ok(x), Ok(y)) if x < width && y < height => Ok((x, y)),
        _ => Err(PixrectError::OutOfBounds),
    }
}

/// Cuts `to` to `size` and to the source, which is at ((sx, sy), size).
fn clip(
    to: Rect,
    size: (u32, u32),
    source: Option<((i32, i32), (u32, u32))>,
    op: PixOp,
) -> Result<Blit, PixrectError> {
    // One axis: the part lo..hi of 0..len that is inside, the positions of its start, and whether it is
    // all there was. In i64 nothing can overflow.
    let axis = |at: i32, len: i32, end: u32, source: Option<(i32, u32)>| {
        let (at, len) = (i64::from(at), i64::from(len).max(0));
        let (mut lo, mut hi) = ((-at).max(0), len.min(i64::from(end) - at));
        if let Some((s, end)) = source {
            lo = lo.max(-i64::from(s));
            hi = hi.min(i64::from(end) - i64::from(s));
        }
        let start = |at: i64| u32::try_from(at + lo).unwrap_or(0);
        let len_inside = u32::try_from(hi - lo).unwrap_or(0);
        (start(at), start(source.map_or(0, |(s, _)| s.into())), len_inside, i64::from(len_inside) == len)
    };
    let (x, sx, w, whole_x) = axis(to.x, to.w, size.0, source.map(|((s, _), (end, _))| (s, end)));
    let (y, sy, h, whole_y) = axis(to.y, to.h, size.1, source.map(|((_, s), (_, end))| (s, end)));
    if op.dont_clip() && !(whole_x && whole_y) {
        return Err(PixrectError::OutOfBounds);
    }
    if w == 0 || h == 0 {
        return Ok(Blit::default());
    }
    Ok(Blit { to: (x, y), source: (sx, sy), w, h })
}

/// Starts and lengths of the chunks of a row, from the left or from the right.
fn chunks(width: u32, from_right: bool) -> impl Iterator<Item = (u32, u32)> {
    let count = width.div_ceil(CHUNK);
    (0..count).map(move |i| {
        let start = if from_right { count - 1 - i } else { i } * CHUNK;
        (start, (width - start).min(CHUNK))
    })
}

/// The first `len` pixels of a chunk.
fn first(buffer: &mut [u8; CHUNK as usize], len: u32) -> &mut [u8] {
    let len = usize::try_from(len).unwrap_or(usize::MAX).min(buffer.len());
    buffer.split_at_mut(len).0
}

/// Combines up to a chunk of source pixels with a row, in the planes of the mask. Pixels lie inside.
fn combine<P: Pixrect + ?Sized>(to: &mut P, x: u32, y: u32, op: PixOp, pixels: &mut [u8]) {
    let depth_mask = if to.depth() == 1 { 0x01 } else { 0xFF };
    let planes = to.planes() & depth_mask;
    let mut buffer = [0; CHUNK as usize];
    let old = first(&mut buffer, u32::try_from(pixels.len()).unwrap_or(CHUNK));
    if op.needs_dst() || planes != depth_mask {
        to.read_row(x, y, old);
    }
    for (pixel, &old) in pixels.iter_mut().zip(&*old) {
        *pixel = (op.apply(*pixel, old) & planes) | (old & depth_mask & !planes);
    }
    to.write_row(x, y, pixels);
}

/// The guns of `index..index + red.len()` are of one count and in a colormap of 256 entries.
fn check_colormap(index: usize, red: usize, green: usize, blue: usize) -> Result<(), PixrectError> {
    let inside = index.checked_add(red).is_some_and(|end| end <= 256);
    if inside && red == green && red == blue { Ok(()) } else { Err(PixrectError::Colormap) }
}

/// Reads entries of a colormap into three arrays.
fn split_guns(entries: &[Rgb<u8>], red: &mut [u8], green: &mut [u8], blue: &mut [u8]) {
    for (((entry, r), g), b) in entries.iter().zip(red).zip(green).zip(blue) {
        (*r, *g, *b) = (entry.r, entry.g, entry.b);
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

/// What an operation refuses (PIX_ERR in the manual).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PixrectError {
    /// A pixel outside the pixrect, or an operation with PIX_DONTCLIP that needs clipping.
    OutOfBounds,
    /// Depths that cannot be combined, or a depth other than 1 and 8.
    Depth,
    /// Entries beyond the colormap, or guns of different counts.
    Colormap,
    /// The pixrect has no colormap.
    NoColormap,
    /// The memory is too small for the size.
    Memory,
}

impl fmt::Display for PixrectError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::OutOfBounds => "outside the pixrect",
            Self::Depth => "depths cannot be combined",
            Self::Colormap => "entries leave the colormap, or the guns differ in count",
            Self::NoColormap => "the pixrect has no colormap",
            Self::Memory => "memory too small for the size of the pixrect",
        })
    }
}

impl core::error::Error for PixrectError {}
