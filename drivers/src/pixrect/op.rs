//! The operation of a raster operation: a boolean function, a colour and a flag in one word.

use core::ops::{BitAnd, BitOr, BitXor, Not};

/// A raster operation, encoded as in `<pixrect/pixrect.h>`: bit 0 is [`PIX_DONTCLIP`], bits 1 to 4 the
/// truth table of the function, bits 5 and up the colour (PIX_COLOR).
///
/// The codes of source and destination are their own truth tables, so functions are written as the
/// expressions they are:
///
/// ```
/// use rta_drivers::pixrect::{PIX_DST, PIX_SRC};
/// assert_eq!((PIX_SRC ^ PIX_DST).apply(0b1100, 0b1010), 0b0110);
/// assert_eq!((!PIX_SRC & PIX_DST).apply(0b1100, 0b1010), 0b0010); // PIX_NOT(PIX_SRC) & PIX_DST
/// assert_eq!(PIX_SRC.with_color(7).color(), 7);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixOp(u16);

/// The source.
pub const PIX_SRC: PixOp = PixOp(0xC << 1);
/// The destination.
pub const PIX_DST: PixOp = PixOp(0xA << 1);
/// All bits 0.
pub const PIX_CLR: PixOp = PixOp(0x0 << 1);
/// All bits 1.
pub const PIX_SET: PixOp = PixOp(0xF << 1);
/// To be ORed in: the rectangle is known to be inside. If it is not, the operation is an error here and not
/// undefined.
pub const PIX_DONTCLIP: PixOp = PixOp(1);

const OPMASK: u16 = 0x1E;

impl PixOp {
    /// The operation with a colour (PIX_COLOR), used for a null source or where a source of depth 1 has a 1.
    #[must_use]
    pub const fn with_color(self, color: u8) -> Self {
        Self(self.0 & 0x1F | (color as u16) << 5)
    }

    /// The colour (PIX_OPCOLOR).
    pub const fn color(self) -> u8 {
        (self.0 >> 5).to_le_bytes()[0]
    }

    /// The rectangle is known to be inside.
    pub const fn dont_clip(self) -> bool {
        self.0 & PIX_DONTCLIP.0 != 0
    }

    /// The encoded word.
    pub const fn bits(self) -> u16 {
        self.0
    }

    /// The function, for each bit of a pixel.
    pub const fn apply(self, src: u8, dst: u8) -> u8 {
        let table = self.0 >> 1;
        (src & dst & spread(table >> 3))
            | (src & !dst & spread(table >> 2))
            | (!src & dst & spread(table >> 1))
            | (!src & !dst & spread(table))
    }

    /// The result depends on the destination.
    pub const fn needs_dst(self) -> bool {
        // Bits 0 and 2 of the table are for a destination of 0, bits 1 and 3 for one of 1.
        let table = self.0 >> 1;
        table & 0b0101 != table >> 1 & 0b0101
    }
}

/// All bits the lowest bit.
const fn spread(bit: u16) -> u8 {
    if bit & 1 != 0 { 0xFF } else { 0 }
}

/// PIX_NOT: the complement of the function; colour and flag are dropped, as the manual's macro does.
impl Not for PixOp {
    type Output = Self;
    fn not(self) -> Self {
        Self(!self.0 & OPMASK)
    }
}

impl BitOr for PixOp {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl BitAnd for PixOp {
    type Output = Self;
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl BitXor for PixOp {
    type Output = Self;
    fn bitxor(self, other: Self) -> Self {
        Self(self.0 ^ other.0)
    }
}
