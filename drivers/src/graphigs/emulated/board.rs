//! The image board, and rectangles copied between it and the data of the application.

use crate::graphigs::{GpError, Ibid, Pair, PixelArray, PixelOrder};

/// An image board. Its pixels lie in memory that the board does not own, one byte each, row by row; the lowest row
/// comes first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Board {
    pub(super) id: Ibid,
    /// The bits of a pixel that the board's depth has.
    pub(super) mask: u8,
    /// Width in pixels.
    pub(super) width: u32,
    /// Height in pixels.
    pub(super) height: u32,
}

impl Board {
    /// Returns the offset in memory of the pixel at (`x`, `y`) from the lower left; `None` outside the board.
    pub(super) fn offset(&self, x: u64, y: u64) -> Option<usize> {
        let (width, height) = (u64::from(self.width), u64::from(self.height));
        if x < width && y < height { usize::try_from(y * width + x).ok() } else { None }
    }

    /// Copies the rectangle of `size` at `from` in the application data to `to` on the board, whose pixels are
    /// `memory`. Both origins are lower left pixels. What leaves the board is discarded.
    pub(super) fn write(
        &self,
        memory: &mut [u8],
        to: (i64, i64),
        size: Pair,
        image: &PixelArray<&[u8]>,
        from: Pair,
    ) {
        for row in 0..size.1 {
            for column in 0..size.0 {
                let target = |start: i64, step: u32| u64::try_from(start + i64::from(step)).ok();
                let offset = target(to.0, column).zip(target(to.1, row)).and_then(|(x, y)| self.offset(x, y));
                let source = image
                    .offset(u64::from(from.0) + u64::from(column), u64::from(from.1) + u64::from(row))
                    .and_then(|offset| image.data.get(offset));
                if let (Some(pixel), Some(value)) = (offset.and_then(|o| memory.get_mut(o)), source) {
                    *pixel = value & self.mask;
                }
            }
        }
    }

    /// Copies the rectangle of `size` at `from` on the board, whose pixels are `memory`, to `to` in the application
    /// data. Both origins are lower left pixels. What leaves the data is discarded.
    pub(super) fn read(
        &self,
        memory: &[u8],
        from: Pair,
        size: Pair,
        image: &mut PixelArray<&mut [u8]>,
        to: Pair,
    ) {
        for row in 0..size.1 {
            for column in 0..size.0 {
                let at = |origin: Pair| {
                    (u64::from(origin.0) + u64::from(column), u64::from(origin.1) + u64::from(row))
                };
                let ((sx, sy), (tx, ty)) = (at(from), at(to));
                let source = self.offset(sx, sy).and_then(|offset| memory.get(offset));
                let offset = image.offset(tx, ty);
                if let (Some(&value), Some(pixel)) = (source, offset.and_then(|o| image.data.get_mut(o))) {
                    *pixel = value;
                }
            }
        }
    }
}

impl<D> PixelArray<D> {
    /// Returns the offset in the data of the pixel at (`x`, `y`) from the lower left; `None` outside the array.
    fn offset(&self, x: u64, y: u64) -> Option<usize> {
        let (width, height) = (u64::from(self.x_size), u64::from(self.y_size));
        if x >= width || y >= height {
            return None;
        }
        let row = if self.order == PixelOrder::LeftRightTopBottom { height - 1 - y } else { y };
        usize::try_from(row.checked_mul(width)?.checked_add(x)?).ok()
    }

    /// Checks that the array is not empty and that `len` bytes of data hold its pixels.
    pub(super) fn check(&self, len: usize) -> Result<(), GpError> {
        let pixels = u64::from(self.x_size) * u64::from(self.y_size);
        let holds = u64::try_from(len).is_ok_and(|len| len >= pixels);
        if pixels > 0 && holds { Ok(()) } else { Err(GpError::Rectangle) }
    }
}

/// Checks that a rectangle is not empty and lies within `width` x `height` pixels.
pub(super) fn check_inside(origin: Pair, size: Pair, width: u32, height: u32) -> Result<(), GpError> {
    let fits = |start: u32, len: u32, end: u32| len > 0 && start.checked_add(len).is_some_and(|e| e <= end);
    if fits(origin.0, size.0, width) && fits(origin.1, size.1, height) {
        Ok(())
    } else {
        Err(GpError::Rectangle)
    }
}
