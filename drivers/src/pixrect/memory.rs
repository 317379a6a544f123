//! Pixrects in memory that the caller lends: mem_point and mem_create of the manual.

use super::{Pixrect, PixrectError};

/// A pixrect in memory, 1 or 8 bits deep, without a colormap.
///
/// Rows follow each other from the top, and each begins at a multiple of 16 bits, as in SunOS. In a depth of 1 the
/// leftmost of eight pixels is the most significant bit of a byte.
#[derive(Clone, Debug)]
pub struct MemPixrect<M> {
    memory: M,
    width: u32,
    height: u32,
    depth: u8,
    planes: u8,
}

/// Bytes of a row of `width` pixels of `depth` bits, padded to a multiple of 2.
fn line_bytes(width: u32, depth: u8) -> u64 {
    (u64::from(width) * u64::from(depth)).div_ceil(16) * 2
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> MemPixrect<M> {
    /// Makes a pixrect whose pixels are what `memory` holds (mem_point).
    ///
    /// # Errors
    /// [`PixrectError::Depth`] unless `depth` is 1 or 8; [`PixrectError::Memory`] if `memory` is too small
    /// or a side is above `i32::MAX`.
    pub fn new(memory: M, width: u32, height: u32, depth: u8) -> Result<Self, PixrectError> {
        if depth != 1 && depth != 8 {
            return Err(PixrectError::Depth);
        }
        let needed = line_bytes(width, depth).checked_mul(height.into());
        let fits = needed.is_some_and(|n| u64::try_from(memory.as_ref().len()).is_ok_and(|len| n <= len));
        if !fits || i32::try_from(width).is_err() || i32::try_from(height).is_err() {
            return Err(PixrectError::Memory);
        }
        Ok(Self { memory, width, height, depth, planes: 0xFF })
    }

    /// The bytes of row `y` in memory; none if the pixrect has no such row.
    fn row(&self, y: u32) -> core::ops::Range<usize> {
        let bytes = line_bytes(self.width, self.depth);
        let start = usize::try_from(bytes.saturating_mul(y.into())).unwrap_or(usize::MAX);
        let end = start.saturating_add(usize::try_from(bytes).unwrap_or(usize::MAX));
        if y < self.height { start..end } else { 0..0 }
    }
}

/// The columns from `x` to the right edge.
fn columns(x: u32, width: u32) -> impl Iterator<Item = usize> {
    (x..width).map(|x| usize::try_from(x).unwrap_or(usize::MAX))
}

impl<M: AsRef<[u8]> + AsMut<[u8]>> Pixrect for MemPixrect<M> {
    fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    fn depth(&self) -> u8 {
        self.depth
    }

    fn planes(&self) -> u8 {
        self.planes
    }

    fn pr_putattributes(&mut self, planes: u8) {
        self.planes = planes;
    }

    fn read_row(&mut self, x: u32, y: u32, pixels: &mut [u8]) {
        let row = self.memory.as_ref().get(self.row(y)).unwrap_or(&[]);
        for (pixel, x) in pixels.iter_mut().zip(columns(x, self.width)) {
            let value = if self.depth == 1 {
                row.get(x / 8).map(|byte| byte >> (7 - x % 8) & 1)
            } else {
                row.get(x).copied()
            };
            *pixel = value.unwrap_or(*pixel);
        }
    }

    fn write_row(&mut self, x: u32, y: u32, pixels: &[u8]) {
        let (width, depth, row) = (self.width, self.depth, self.row(y));
        let row = self.memory.as_mut().get_mut(row).unwrap_or(&mut []);
        for (&pixel, x) in pixels.iter().zip(columns(x, width)) {
            if depth == 1 {
                if let Some(byte) = row.get_mut(x / 8) {
                    let bit = 0x80 >> (x % 8);
                    *byte = if pixel & 1 != 0 { *byte | bit } else { *byte & !bit };
                }
            } else if let Some(byte) = row.get_mut(x) {
                *byte = pixel;
            }
        }
    }

    fn pr_putcolormap(&mut self, _: usize, _: &[u8], _: &[u8], _: &[u8]) -> Result<(), PixrectError> {
        Err(PixrectError::NoColormap)
    }

    fn pr_getcolormap(
        &mut self,
        _: usize,
        _: &mut [u8],
        _: &mut [u8],
        _: &mut [u8],
    ) -> Result<(), PixrectError> {
        Err(PixrectError::NoColormap)
    }
}
