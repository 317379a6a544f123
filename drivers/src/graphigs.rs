//! graPHIGS on the IBM RT PC: 1024 x 1024, 128 colours at once of 4096, reached by calls of an API.
//!
//! [`Graphigs`] is the part of the API that a picture needs, each call under its own name. [`GraphigsDisplay`] is the
//! driver that draws with these calls; [`emulated::Workstation`] is an emulated machine that answers them. Names,
//! parameters and error numbers are those of IBM's "The graPHIGS Programming Interface: Subroutine Reference".
//!
//! The components of a colour are real numbers of 0 to 1 in the API. Here they are `u16` fractions of [`ONE`] = 65535,
//! so that a program in fixed point contains no float. 65535 = 15 * 4369, so every level of a 4-bit gun is exact.
//!
//! Index 0 is the background. The colour tables of [`crate::quantize`] keep it black.

mod display;
pub mod emulated;
mod error;

use rta_core::color::Rgb;

pub use display::GraphigsDisplay;
pub use error::GpError;

use crate::display::Capabilities;

/// What the screen can show: 1024 x 1024 pixels on a square screen, 128 colours, 4 bits a gun.
pub const CAPABILITIES: Capabilities =
    Capabilities { width: 1024, height: 1024, colors: 128, gun_max: 15, aspect: (1, 1) };

/// The component of a colour that is 1 in the API; 0 is 0.
pub const ONE: u16 = u16::MAX;

/// Workstation identifier (`wsid`), chosen by the application.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wsid(pub i32);

/// Nucleus identifier (`ncid`). The nucleus is the part of graPHIGS that owns the image boards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ncid(pub i32);

/// Image board identifier (`ibid`), chosen by the application.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ibid(pub i32);

/// Workstation type (`wstype`): eight characters, padded with blanks.
pub type WorkstationType = [u8; 8];

/// What the three components of a colour mean (`model` of GPCML). The discriminants are the API's numbers.
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

/// The colour facilities of a workstation type: the answer of [`Graphigs::gpqcf`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ColorFacilities {
    /// The colour model of the workstation.
    pub model: ColorModel,
    /// How many different colours the guns can show.
    pub available: u32,
    /// Whether the workstation shows colours; false if it is monochrome.
    pub color: bool,
    /// Entries of the default colour table that are predefined.
    pub predefined: u32,
}

/// The order of the rows of a pixel array. The discriminants are the API's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum PixelOrder {
    /// The lowest row comes first.
    LeftRightBottomTop = 1,
    /// The highest row comes first.
    LeftRightTopBottom = 2,
}

/// Image data of the application in the API's format 1, PIXEL_ARRAY: one byte a pixel.
#[derive(Debug, PartialEq, Eq)]
pub struct PixelArray<D> {
    /// Pixels in a row.
    pub x_size: u32,
    /// Rows.
    pub y_size: u32,
    /// Order of the rows in `data`.
    pub order: PixelOrder,
    /// At least `x_size * y_size` bytes: a `&[u8]` that is drawn, or a `&mut [u8]` that pixels are read into.
    pub data: D,
}

/// Two numbers in pixels, horizontal and vertical: an origin, counted from the lower left, or a size.
pub type Pair = (u32, u32);

/// The calls of the graPHIGS API that showing a picture needs.
///
/// A call that fails changes nothing. Each call lists its errors by the numbers of [`GpError::number`].
///
/// Three errors are common to most calls: 2 while graPHIGS is not open, 3 while no workstation is open, and 25 if
/// the workstation that is open has another identifier than `wsid`.
pub trait Graphigs {
    /// Open graPHIGS.
    ///
    /// # Errors
    /// 1 if it is open already.
    fn gpopph(&mut self) -> Result<(), GpError>;

    /// Close graPHIGS.
    ///
    /// # Errors
    /// 2 if it is not open, or if a workstation is still open.
    fn gpclph(&mut self) -> Result<(), GpError>;

    /// Open workstation, of the type `wstype` at the connection `connid`, under the identifier `wsid`.
    ///
    /// # Errors
    /// 2 if graPHIGS is not open; 23 for an unknown type; [`GpError::WorkstationInUse`] if the workstation is open
    /// or the identifier is taken.
    fn gpopws(&mut self, wsid: Wsid, connid: &str, wstype: WorkstationType) -> Result<(), GpError>;

    /// Close workstation.
    ///
    /// # Errors
    /// 3 or 25 if it is not open.
    fn gpclws(&mut self, wsid: Wsid) -> Result<(), GpError>;

    /// Update workstation: the colours that were set take effect.
    ///
    /// # Errors
    /// 3 or 25 if it is not open.
    fn gpupws(&mut self, wsid: Wsid) -> Result<(), GpError>;

    /// Inquire colour facilities of a workstation type.
    ///
    /// # Errors
    /// 2 if graPHIGS is not open; 23 for an unknown type.
    fn gpqcf(&mut self, wstype: WorkstationType) -> Result<ColorFacilities, GpError>;

    /// Set colour model, in which [`Graphigs::gpcr`] and [`Graphigs::gpqcr`] read and return components.
    ///
    /// # Errors
    /// 3 or 25 if the workstation is not open; [`GpError::ColorModel`] if it does not have the model.
    fn gpcml(&mut self, wsid: Wsid, model: ColorModel) -> Result<(), GpError>;

    /// Set colour representation: the entries of the colour table from `index` up. Components are fractions of
    /// [`ONE`]; the workstation takes the nearest levels that it has. The colours take effect with
    /// [`Graphigs::gpupws`].
    ///
    /// # Errors
    /// 3 or 25 if the workstation is not open; 49 for an entry beyond the table; 517 for no colours.
    fn gpcr(&mut self, wsid: Wsid, index: u32, colors: &[Rgb<u16>]) -> Result<(), GpError>;

    /// Inquire colour representation: the entries of the colour table from `start` up as they were set, in effect or
    /// not. Components are fractions of [`ONE`], rounded to the levels of the workstation.
    ///
    /// # Errors
    /// 3 or 25 if the workstation is not open; 551 for an entry beyond the table.
    fn gpqcr(&mut self, wsid: Wsid, start: u32, colors: &mut [Rgb<u16>]) -> Result<(), GpError>;

    /// Create image board, of `h` x `v` pixels (horizontal, vertical) of `depth` bits, on the nucleus `ncid`; its type
    /// is 1, NORMAL. Its pixels are 0.
    ///
    /// # Errors
    /// 2 if graPHIGS is not open; 202 for an unknown nucleus; 217 for more than the nucleus has room for; 231 if the
    /// identifier is taken; 233 for a depth that the nucleus does not have; 234 for a size of 0.
    fn gpcrib(&mut self, ibid: Ibid, ncid: Ncid, depth: u32, h: u32, v: u32) -> Result<(), GpError>;

    /// Write rectangle: copies `size` pixels at `sorigin` of the application data to `torigin` on the board. What
    /// leaves the board is discarded, and of each pixel only the bits that the board's depth has are kept.
    ///
    /// # Errors
    /// 2 if graPHIGS is not open; 232 for an unknown board; 236 for a size of 0, a source rectangle that leaves the
    /// application data, or data that are too short.
    fn gpwrct(
        &mut self,
        tibid: Ibid,
        torigin: Pair,
        size: Pair,
        image: PixelArray<&[u8]>,
        sorigin: Pair,
    ) -> Result<(), GpError>;

    /// Read rectangle: copies `size` pixels at `sorigin` on the board to `torigin` of the application data. What leaves
    /// the data is discarded.
    ///
    /// # Errors
    /// 2 if graPHIGS is not open; 232 for an unknown board; 236 for a size of 0, a source rectangle that leaves the
    /// board, or data that are too short.
    fn gprrct(
        &mut self,
        sibid: Ibid,
        sorigin: Pair,
        size: Pair,
        image: PixelArray<&mut [u8]>,
        torigin: Pair,
    ) -> Result<(), GpError>;

    /// Begin structure: the primitives that follow are drawn on the workstation at once and not retained.
    ///
    /// # Errors
    /// 3 or 25 if the workstation is not open.
    fn gpbgst(&mut self, wsid: Wsid) -> Result<(), GpError>;

    /// End structure.
    ///
    /// # Errors
    /// 5 if no structure was begun.
    fn gpenst(&mut self) -> Result<(), GpError>;

    /// Pixel 2: draws the whole pixel array, with its upper left pixel at `point`, into the workstation's frame buffer.
    /// `point` counts pixels from the lower left; these are model coordinates under a view that maps one unit to one
    /// pixel. What leaves the frame buffer is discarded.
    ///
    /// # Errors
    /// 5 unless called between [`Graphigs::gpbgst`] and [`Graphigs::gpenst`]; 236 for an empty array or data that are
    /// too short.
    fn gppxl2(&mut self, point: (i32, i32), image: PixelArray<&[u8]>) -> Result<(), GpError>;
}
