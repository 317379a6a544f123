//! Regions (pr_region): a part of a pixrect that is a pixrect itself.

use super::{Pixrect, PixrectError, Rect};

/// A part of another pixrect, made by [`Pixrect::pr_region`]. It has its own coordinates and plane mask; its pixels
/// and its colormap are those of the other.
#[derive(Debug)]
pub struct Region<'a, P> {
    parent: &'a mut P,
    origin: (u32, u32),
    size: (u32, u32),
    planes: u8,
}

impl<'a, P: Pixrect> Region<'a, P> {
    /// Makes the region of `parent` that `part` covers; empty if it covers none.
    pub(super) fn new(parent: &'a mut P, part: Rect) -> Self {
        // For one axis, the part of `at..at + len` that lies in `0..end`, as its start and its length.
        let axis = |at: i32, len: i32, end: u32| {
            let (at, len, end) = (i64::from(at), i64::from(len).max(0), i64::from(end));
            let (start, stop) = (at.clamp(0, end), (at + len).clamp(0, end));
            (u32::try_from(start).unwrap_or(0), u32::try_from(stop - start).unwrap_or(0))
        };
        let (width, height) = parent.size();
        let ((x, w), (y, h)) = (axis(part.x, part.w, width), axis(part.y, part.h, height));
        let planes = parent.planes();
        Self { parent, origin: (x, y), size: (w, h), planes }
    }

    /// Returns how many of the `len` pixels from (`x`, `y`) to the right are inside the region.
    fn inside(&self, x: u32, y: u32, len: usize) -> usize {
        let room = if y < self.size.1 { self.size.0.saturating_sub(x) } else { 0 };
        len.min(usize::try_from(room).unwrap_or(usize::MAX))
    }
}

impl<P: Pixrect> Pixrect for Region<'_, P> {
    fn size(&self) -> (u32, u32) {
        self.size
    }

    fn depth(&self) -> u8 {
        self.parent.depth()
    }

    fn planes(&self) -> u8 {
        self.planes
    }

    fn pr_putattributes(&mut self, planes: u8) {
        self.planes = planes;
    }

    fn read_row(&mut self, x: u32, y: u32, pixels: &mut [u8]) {
        let len = self.inside(x, y, pixels.len());
        if let Some(pixels @ [_, ..]) = pixels.get_mut(..len) {
            self.parent.read_row(self.origin.0 + x, self.origin.1 + y, pixels);
        }
    }

    fn write_row(&mut self, x: u32, y: u32, pixels: &[u8]) {
        if let Some(pixels @ [_, ..]) = pixels.get(..self.inside(x, y, pixels.len())) {
            self.parent.write_row(self.origin.0 + x, self.origin.1 + y, pixels);
        }
    }

    fn pr_putcolormap(&mut self, index: usize, r: &[u8], g: &[u8], b: &[u8]) -> Result<(), PixrectError> {
        self.parent.pr_putcolormap(index, r, g, b)
    }

    fn pr_getcolormap(
        &mut self,
        index: usize,
        r: &mut [u8],
        g: &mut [u8],
        b: &mut [u8],
    ) -> Result<(), PixrectError> {
        self.parent.pr_getcolormap(index, r, g, b)
    }
}
