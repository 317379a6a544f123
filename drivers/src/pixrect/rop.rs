//! The steps of a raster operation: clipping, the division of a row into chunks, and the combination of source and
//! destination in the planes of the mask.

use super::{PixOp, Pixrect, PixrectError, Rect};

/// Pixels of a row that are combined at once, in two buffers of as many bytes on the stack.
pub(super) const CHUNK: u32 = 64;

/// The rectangle of a raster operation after clipping: it lies inside the destination and inside the source.
#[derive(Default)]
pub(super) struct Clipped {
    /// Its upper left pixel in the destination.
    pub(super) to: (u32, u32),
    /// Its upper left pixel in the source; meaningless where there is no source.
    pub(super) source: (u32, u32),
    /// Width in pixels.
    pub(super) width: u32,
    /// Height in pixels.
    pub(super) height: u32,
}

/// Returns the coordinates of a pixel that is inside a pixrect of the given width and height.
pub(super) fn inside((width, height): (u32, u32), x: i32, y: i32) -> Result<(u32, u32), PixrectError> {
    match (u32::try_from(x), u32::try_from(y)) {
        (Ok(x), Ok(y)) if x < width && y < height => Ok((x, y)),
        _ => Err(PixrectError::OutOfBounds),
    }
}

/// Clips `to` to a destination of `size` and to a source, given as the pixel that falls on the upper left one of
/// `to` and the source's size. What is empty after clipping has width and height 0.
///
/// Fails with `PIX_DONTCLIP` in `op` where something would have been cut.
pub(super) fn clip(
    to: Rect,
    size: (u32, u32),
    source: Option<((i32, i32), (u32, u32))>,
    op: PixOp,
) -> Result<Clipped, PixrectError> {
    // For one axis, `low..high` is the part of `0..len` that is inside both. Returned are its start in the
    // destination and in the source, its length, and whether it is all of `0..len`. All inputs have at most 33
    // bits, so nothing overflows in i64.
    let axis = |at: i32, len: i32, end: u32, source: Option<(i32, u32)>| {
        let (at, len) = (i64::from(at), i64::from(len).max(0));
        let (mut low, mut high) = ((-at).max(0), len.min(i64::from(end) - at));
        if let Some((s, end)) = source {
            low = low.max(-i64::from(s));
            high = high.min(i64::from(end) - i64::from(s));
        }
        let start = |at: i64| u32::try_from(at + low).unwrap_or(0);
        let len_inside = u32::try_from(high - low).unwrap_or(0);
        (start(at), start(source.map_or(0, |(s, _)| s.into())), len_inside, i64::from(len_inside) == len)
    };
    let (x, sx, w, whole_x) = axis(to.x, to.w, size.0, source.map(|((s, _), (end, _))| (s, end)));
    let (y, sy, h, whole_y) = axis(to.y, to.h, size.1, source.map(|((_, s), (_, end))| (s, end)));
    if op.dont_clip() && !(whole_x && whole_y) {
        return Err(PixrectError::OutOfBounds);
    }
    if w == 0 || h == 0 {
        return Ok(Clipped::default());
    }
    Ok(Clipped { to: (x, y), source: (sx, sy), width: w, height: h })
}

/// The chunks of a row of `width` pixels, each as its first column and its length, from the left or from the right.
pub(super) fn chunks(width: u32, from_right: bool) -> impl Iterator<Item = (u32, u32)> {
    let count = width.div_ceil(CHUNK);
    (0..count).map(move |i| {
        let start = if from_right { count - 1 - i } else { i } * CHUNK;
        (start, (width - start).min(CHUNK))
    })
}

/// Returns the first `len` pixels of a chunk's buffer; all of it if `len` is more.
pub(super) fn first(buffer: &mut [u8; CHUNK as usize], len: u32) -> &mut [u8] {
    let len = usize::try_from(len).unwrap_or(usize::MAX).min(buffer.len());
    buffer.split_at_mut(len).0
}

/// Combines `pixels` of a source, at most [`CHUNK`], with those of row `y` from column `x` on, in the planes of the
/// mask. All of them must lie inside. `pixels` is overwritten with the result.
pub(super) fn combine<P: Pixrect + ?Sized>(to: &mut P, x: u32, y: u32, op: PixOp, pixels: &mut [u8]) {
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
