//! graPHIGS on the IBM RT PC: 1024 x 1024, 128 colours at once of 4096, spoken to by calls.
//!
//! [`Graphigs`] is the part of the API that a picture needs, each call under its own name;
//! [`GraphigsDisplay`] is the driver that draws with it, [`emulated::Workstation`] a workstation that
//! answers it. Names, parameters and error numbers are those of IBM's "The graPHIGS Programming
//! Interface: Subroutine Reference".
//!
//! Components of a colour are 0..1 in the API. Here they are `u16` fractions of 65535, so that no float
//! enters the fixed-point path; 65535 = 15 * 4369, so every level of a 4-bit gun is exact.
//!
//! Index 0 is the background. The colour tables of [`crate::quantize`] keep it black.

mod display;
pub mod emulated;
mod error;

use rta_core::color::Rgb;

pub use display::GraphigsDisplay;
pub use error::GpError;

use crate::display::Capabilities;

/// 1024 x 1024 on a square screen, 128 colours, 4 bits a gun.
pub const CAPABILITIES: Capabilities =
    Capabilities { width: 1024, height: 1024, colors: 128, gun_max: 15, aspect: (1, 1) };

/// A colour component of 1.
pub const ONE: u16 = u16::MAX;

/// Workstation identifier (`wsid`): the application chooses it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wsid(pub i32);

/// Nucleus identifier (`ncid`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ncid(pub i32);

/// Image board identifier (`ibid`): the application chooses it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ibid(pub i32);

/// Workstation type (`wstype`): eight characters, padded with blanks.
pub type WorkstationType = [u8; 8];

/// How the components of a colour are read (`model` of GPCML), by the API's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum ColorModel {
    /// Red, green, blue.
    Rgb = 1,
    /// Hue, saturation, value.
    Hsv = 2,
    /// Cyan, magenta, yellow.
    Cmy = 3,
    /// CIE 1976 L*u*v*.
    Cieluv = 4,
}

/// The answer of GPQCF.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ColorFacilities {
    /// The colour model of the workstation.
    pub model: ColorModel,
    /// The palette: how many different colours the guns can show.
    pub available: u32,
    /// Colour, not monochrome.
    pub color: bool,
    /// Entries of the default colour table that are predefined.
    pub predefined: u32,
}

/// The order of the rows of a pixel array, by the API's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum PixelOrder {
    /// The lowest row first.
    LeftRightBottomTop = 1,
    /// The highest row first.
    LeftRightTopBottom = 2,
}

/// Application image data in format 1, PIXEL_ARRAY, 8 bits deep.
#[derive(Debug, PartialEq, Eq)]
pub struct PixelArray<D> {
    /// Pixels in a row.
    pub x_size: u32,
    /// Rows.
    pub y_size: u32,
    /// Order of the rows in `data`.
    pub order: PixelOrder,
    /// `x_size * y_size` bytes at least: `&[u8]` to be written, `&mut [u8]` to be read into.
    pub data: D,
}

/// A pair of horizontal and vertical: an origin or a size. Vertical counts upwards.
pub type Pair = (u32, u32);

/// The calls of the graPHIGS API that showing a picture needs.
///
/// Every call may return [`GpError`]; which one, each says. A refused call changes nothing.
pub trait Graphigs {
    /// Open graPHIGS.
    ///
    /// # Errors
    /// 1 if it is open.
    fn gpopph(&mut self) -> Result<(), GpError>;

    /// Close graPHIGS.
    ///
    /// # Errors
    /// 2 if it is not open, or a workstation still is.
    fn gpclph(&mut self) -> Result<(), GpError>;

    /// Open workstation.
    ///
    /// # Errors
    /// 2 if graPHIGS is not open, 23 for an unknown type, in use if the identifier or the workstation is.
    fn gpopws(&mut self, wsid: Wsid, connid: &str, wstype: WorkstationType) -> Result<(), GpError>;

    /// Close workstation.
    ///
    /// # Errors
    /// 3, 25: it is not open.
    fn gpclws(&mut self, wsid: Wsid) -> Result<(), GpError>;

    /// Update workstation: what was set takes effect.
    ///
    /// # Errors
    /// 3, 25: it is not open.
    fn gpupws(&mut self, wsid: Wsid) -> Result<(), GpError>;

    /// Inquire colour facilities of a workstation type.
    ///
    /// # Errors
    /// 2, or 23 for an unknown type.
    fn gpqcf(&mut self, wstype: WorkstationType) -> Result<ColorFacilities, GpError>;

    /// Set colour model.
    ///
    /// # Errors
    /// 3, 25, or [`GpError::ColorModel`].
    fn gpcml(&mut self, wsid: Wsid, model: ColorModel) -> Result<(), GpError>;

    /// Set colour representation: entries from `index` up, components as fractions of [`ONE`]. The
    /// workstation takes the nearest it has.
    ///
    /// # Errors
    /// 3, 25, 49 for an entry beyond the table, 517 for no colours.
    fn gpcr(&mut self, wsid: Wsid, index: u32, colors: &[Rgb<u16>]) -> Result<(), GpError>;

    /// Inquire colour representation, as set: entries from `start` up.
    ///
    /// # Errors
    /// 3, 25, 551 for an entry beyond the table.
    fn gpqcr(&mut self, wsid: Wsid, start: u32, colors: &mut [Rgb<u16>]) -> Result<(), GpError>;

    /// Create image board, `depth` bits deep, of the type 1 = NORMAL.
    ///
    /// # Errors
    /// 2, 202, 217 for more than the nucleus has room for, 231, 233 unless `depth` is one the nucleus has,
    /// 234 for a size of 0.
    fn gpcrib(&mut self, ibid: Ibid, ncid: Ncid, depth: u32, h: u32, v: u32) -> Result<(), GpError>;

    /// Write rectangle: from application data to a board. What leaves the board is discarded, pixels
    /// are cut to the board's depth.
    ///
    /// # Errors
    /// 2, 232, 236 for a size of 0 or a source rectangle outside the data.
    fn gpwrct(
        &mut self,
        tibid: Ibid,
        torigin: Pair,
        size: Pair,
        image: PixelArray<&[u8]>,
        sorigin: Pair,
    ) -> Result<(), GpError>;

    /// Read rectangle: from a board to application data. What leaves the data is discarded.
    ///
    /// # Errors
    /// 2, 232, 236 for a size of 0 or a source rectangle outside the board.
    fn gprrct(
        &mut self,
        sibid: Ibid,
        sorigin: Pair,
        size: Pair,
        image: PixelArray<&mut [u8]>,
        torigin: Pair,
    ) -> Result<(), GpError>;

    /// Begin structure: primitives that follow are drawn on `wsid` at once and not retained.
    ///
    /// # Errors
    /// 3, 25.
    fn gpbgst(&mut self, wsid: Wsid) -> Result<(), GpError>;

    /// End structure.
    ///
    /// # Errors
    /// [`GpError::RequiresNrop`].
    fn gpenst(&mut self) -> Result<(), GpError>;

    /// Pixel 2: draws the whole pixel array with its upper left pixel at `point`, straight into the
    /// workstation's frame buffer. `point` counts pixels from the lower left, which is what model
    /// coordinates are under the view that maps one unit to one pixel.
    ///
    /// # Errors
    /// [`GpError::RequiresNrop`] outside GPBGST and GPENST; 236 for data that are too short.
    fn gppxl2(&mut self, point: (i32, i32), image: PixelArray<&[u8]>) -> Result<(), GpError>;
}
