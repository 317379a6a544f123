//! The driver of graPHIGS: a [`Display`] on top of the calls of the API.

use rta_core::color::Rgb;

use super::{CAPABILITIES, ColorModel, GpError, Graphigs, Ibid, Ncid, ONE, PixelArray, PixelOrder, Wsid};
use super::{Pair, WorkstationType};
use crate::display::{Capabilities, Display, DriverError, ReadBack};

/// The identifier that the driver gives to its workstation.
const WSID: Wsid = Wsid(1);
/// The identifier that the driver gives to its image board.
const IBID: Ibid = Ibid(1);
/// The identifier of the nucleus that GPOPPH makes.
const NCID: Ncid = Ncid(1);
/// Depth of the image board in bits. A nucleus has 1, 2, 4 and 8; 128 indices need 7.
const DEPTH: u32 = 8;
/// Colours converted and set by one call, in a buffer of 192 bytes on the stack.
const CHUNK: usize = 32;
/// One level of a 4-bit gun as a fraction of [`ONE`]. The division is exact: 65535 = 15 * 4369.
const STEP: u16 = ONE / CAPABILITIES.gun_max as u16;

/// Draws on a graPHIGS workstation: opens it, makes an image board of the size of the screen, sets colours with GPCR
/// and writes rows with GPWRCT.
///
/// Colours take effect with [`Display::update`], which calls GPUPWS. The driver converts the rows of a [`Display`],
/// which count from the top, to those of a board, which count from the bottom.
#[derive(Clone, Debug)]
pub struct GraphigsDisplay<G> {
    api: G,
}

impl<G: Graphigs> GraphigsDisplay<G> {
    /// Opens graPHIGS and the workstation of type `wstype` at connection `connid`, sets the colour model RGB and
    /// makes the image board.
    ///
    /// # Errors
    /// Those of [`Graphigs::gpopph`], [`Graphigs::gpopws`], [`Graphigs::gpcml`] and [`Graphigs::gpcrib`].
    pub fn open(mut api: G, connid: &str, wstype: WorkstationType) -> Result<Self, GpError> {
        api.gpopph()?;
        api.gpopws(WSID, connid, wstype)?;
        api.gpcml(WSID, ColorModel::Rgb)?;
        api.gpcrib(IBID, NCID, DEPTH, CAPABILITIES.width, CAPABILITIES.height)?;
        Ok(Self { api })
    }

    /// Closes the workstation and graPHIGS and gives the API back.
    ///
    /// # Errors
    /// Those of [`Graphigs::gpclws`] and [`Graphigs::gpclph`].
    pub fn close(mut self) -> Result<G, GpError> {
        self.api.gpclws(WSID)?;
        self.api.gpclph()?;
        Ok(self.api)
    }

    /// Borrows the API, for example to look at the pixels of an emulated workstation.
    pub fn api(&self) -> &G {
        &self.api
    }

    /// Borrows the API to make calls of one's own. They must leave the driver's workstation and image board (both of
    /// identifier 1) open for the driver to go on.
    pub fn api_mut(&mut self) -> &mut G {
        &mut self.api
    }
}

/// Returns the rectangle of `len` pixels from (`x`, `y`) of the screen to the right: its origin on the board, which
/// counts from the bottom, and its size. The pixel must be on the screen.
fn row(x: u32, y: u32, len: usize) -> (Pair, Pair) {
    let size = u32::try_from(len).unwrap_or(u32::MAX);
    ((x, CAPABILITIES.height - 1 - y), (size, 1))
}

/// Wraps `data` as application data of the given size; the order of the rows does not matter where there is one.
fn array<D>(size: Pair, data: D) -> PixelArray<D> {
    PixelArray { x_size: size.0, y_size: size.1, order: PixelOrder::LeftRightTopBottom, data }
}

impl<G: Graphigs> Display for GraphigsDisplay<G> {
    type Error = DriverError<GpError>;

    fn capabilities(&self) -> Capabilities {
        CAPABILITIES
    }

    fn set_colors(&mut self, first: u8, colors: &[Rgb<u8>]) -> Result<(), Self::Error> {
        CAPABILITIES.check_colors(first, colors)?;
        for (index, chunk) in (u32::from(first)..).step_by(CHUNK).zip(colors.chunks(CHUNK)) {
            let mut components = [Rgb::new(0, 0, 0); CHUNK];
            for (to, from) in components.iter_mut().zip(chunk) {
                *to = from.map(|level| u16::from(level) * STEP);
            }
            self.api.gpcr(WSID, index, components.get(..chunk.len()).unwrap_or(&[]))?;
        }
        Ok(())
    }

    fn put_pixels(&mut self, x: u32, y: u32, indices: &[u8]) -> Result<(), Self::Error> {
        CAPABILITIES.check_pixels(x, y, indices.len())?;
        CAPABILITIES.check_indices(indices)?;
        if indices.is_empty() {
            return Ok(()); // GPWRCT would refuse an empty rectangle
        }
        let (origin, size) = row(x, y, indices.len());
        Ok(self.api.gpwrct(IBID, origin, size, array(size, indices), (0, 0))?)
    }

    fn update(&mut self) -> Result<(), Self::Error> {
        Ok(self.api.gpupws(WSID)?)
    }
}

impl<G: Graphigs> ReadBack for GraphigsDisplay<G> {
    fn read_colors(&mut self, first: u8, colors: &mut [Rgb<u8>]) -> Result<(), Self::Error> {
        CAPABILITIES.check_entries(first, colors.len())?;
        for (index, color) in (u32::from(first)..).zip(colors) {
            let mut components = [Rgb::new(0, 0, 0)];
            self.api.gpqcr(WSID, index, &mut components)?;
            // At most ONE / STEP = 15.
            *color = components[0].map(|component| (component / STEP).to_le_bytes()[0]);
        }
        Ok(())
    }

    fn read_pixels(&mut self, x: u32, y: u32, indices: &mut [u8]) -> Result<(), Self::Error> {
        CAPABILITIES.check_pixels(x, y, indices.len())?;
        if indices.is_empty() {
            return Ok(()); // GPRRCT would refuse an empty rectangle
        }
        let (origin, size) = row(x, y, indices.len());
        Ok(self.api.gprrct(IBID, origin, size, array(size, indices), (0, 0))?)
    }
}
