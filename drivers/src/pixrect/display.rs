//! The driver of PIXRECT: a [`Display`] on top of any pixrect of depth 8.

use rta_core::color::Rgb;

use super::colormap::split_guns;
use super::rop::CHUNK;
use super::{CAPABILITIES, MemPixrect, PIX_DONTCLIP, PIX_SRC, Pixrect, PixrectError, Rect};
use crate::display::{Capabilities, Display, DriverError, ReadBack};

/// Draws on a pixrect: loads colours with [`Pixrect::pr_putcolormap`] and copies rows from a pixrect in memory with
/// [`Pixrect::pr_rop`].
#[derive(Clone, Debug)]
pub struct PixrectDisplay<P> {
    pixrect: P,
}

impl<P: Pixrect> PixrectDisplay<P> {
    /// Takes a pixrect of depth 8 that has a colormap.
    ///
    /// # Errors
    /// [`PixrectError::Depth`] for another depth, [`PixrectError::NoColormap`] for a pixrect without a colormap.
    pub fn new(mut pixrect: P) -> Result<Self, PixrectError> {
        if pixrect.depth() != 8 {
            return Err(PixrectError::Depth);
        }
        pixrect.pr_getcolormap(0, &mut [], &mut [], &mut [])?;
        Ok(Self { pixrect })
    }

    /// Borrows the pixrect, for example to look at what is behind it.
    pub fn pixrect(&self) -> &P {
        &self.pixrect
    }

    /// Gives the pixrect back.
    pub fn release(self) -> P {
        self.pixrect
    }
}

/// Converts a coordinate or a width. Sides of a pixrect are at most `i32::MAX`, so what is inside fits.
fn coordinate(x: u32) -> i32 {
    i32::try_from(x).unwrap_or(i32::MAX)
}

impl<P: Pixrect> Display for PixrectDisplay<P> {
    type Error = DriverError<PixrectError>;

    /// Returns the size of the pixrect, its colours and its shape; pixels are square, so the shape of the screen is
    /// that of the raster.
    fn capabilities(&self) -> Capabilities {
        let (width, height) = self.pixrect.size();
        Capabilities { width, height, aspect: (width, height), ..CAPABILITIES }
    }

    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error> {
        self.capabilities().check_colors(first, colors)?;
        let mut index = usize::from(first);
        for chunk in colors.chunks(CHUNK as usize) {
            let mut guns = [[0; CHUNK as usize]; 3];
            let [red, green, blue] = &mut guns;
            split_guns(chunk, red, green, blue);
            let [red, green, blue] = guns.each_ref().map(|gun| gun.get(..chunk.len()).unwrap_or(gun));
            self.pixrect.pr_putcolormap(index, red, green, blue)?;
            index += chunk.len();
        }
        Ok(())
    }

    fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error> {
        self.capabilities().check_pixels(x, y, indices.len())?;
        let mut column = x;
        for chunk in indices.chunks(CHUNK as usize) {
            let mut line = [0; CHUNK as usize];
            for (to, &from) in line.iter_mut().zip(chunk) {
                *to = from;
            }
            let mut line = MemPixrect::new(line, CHUNK, 1, 8)?;
            let w = u32::try_from(chunk.len()).unwrap_or(CHUNK);
            let to = Rect { x: coordinate(column), y: coordinate(y), w: coordinate(w), h: 1 };
            self.pixrect.pr_rop(to, PIX_SRC | PIX_DONTCLIP, &mut line, 0, 0)?;
            column += w;
        }
        Ok(())
    }
}

impl<P: Pixrect> ReadBack for PixrectDisplay<P> {
    fn read_colors(&mut self, first: u8, colors: &mut [Rgb<u8>]) -> Result<(), Self::Error> {
        self.capabilities().check_entries(first, colors.len())?;
        for (index, color) in (usize::from(first)..).zip(colors) {
            let (mut r, mut g, mut b) = ([0], [0], [0]);
            self.pixrect.pr_getcolormap(index, &mut r, &mut g, &mut b)?;
            *color = Rgb::new(r[0], g[0], b[0]);
        }
        Ok(())
    }

    fn read_pixels(&mut self, x: u32, y: u32, indices: &mut [u8]) -> Result<(), Self::Error> {
        self.capabilities().check_pixels(x, y, indices.len())?;
        self.pixrect.read_row(x, y, indices);
        Ok(())
    }
}
