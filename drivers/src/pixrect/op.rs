//! The operation word of a raster operation: a boolean function, a colour and a flag.

use core::ops::{BitAnd, BitOr, BitXor, Not};

/// A raster operation, encoded as in `<pixrect/pixrect.h>`: bit 0 is [`PIX_DONTCLIP`], bits 1 to 4 are the
/// truth table of the function, bits 5 to 12 the colour (PIX_COLOR).
///
/// [`PIX_SRC`] and [`PIX_DST`] hold the truth tables of "source" and "destination", so any function of the two is
/// written as an expression of them:
///
/// ```
/// use rta_drivers::pixrect::{PIX_DST, PIX_SRC};
/// assert_eq!((PIX_SRC ^ PIX_DST).apply(0b1100, 0b1010), 0b0110);
/// assert_eq!((!PIX_SRC & PIX_DST).apply(0b1100, 0b1010), 0b0010); // PIX_NOT(PIX_SRC) & PIX_DST
/// assert_eq!(PIX_SRC.with_color(7).color(), 7);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixOp(u16);

/// The function that returns the source.
pub const PIX_SRC: PixOp = PixOp(0xC << 1);
/// The function that returns the destination.
pub const PIX_DST: PixOp = PixOp(0xA << 1);
/// The function that clears all bits.
pub const PIX_CLR: PixOp = PixOp(0x0 << 1);
/// The function that sets all bits.
pub const PIX_SET: PixOp = PixOp(0xF << 1);
/// The flag that says that the rectangle is known to be inside, to be ORed with a function. If the rectangle is not
/// inside, the manual leaves the result open; here the operation is refused.
pub const PIX_DONTCLIP: PixOp = PixOp(1);

/// The bits of the word that hold the function.
const OPMASK: u16 = 0x1E;

impl PixOp {
    /// Returns the operation with a colour (PIX_COLOR), which is used for a null source and where a source of depth 1
    /// has a 1.
    #[must_use]
    pub const fn with_color(self, color: u8) -> Self {
        Self(self.0 & 0x1F | (color as u16) << 5)
    }

    /// Returns the colour (PIX_OPCOLOR); 0 where none was set.
    pub const fn color(self) -> u8 {
        (self.0 >> 5).to_le_bytes()[0]
    }

    /// Tells whether [`PIX_DONTCLIP`] is set.
    pub const fn dont_clip(self) -> bool {
        self.0 & PIX_DONTCLIP.0 != 0
    }

    /// Returns the encoded word.
    pub const fn bits(self) -> u16 {
        self.0
    }

    /// Applies the function to each bit of a source pixel and a destination pixel.
    pub const fn apply(self, src: u8, dst: u8) -> u8 {
        let table = self.0 >> 1;
        (src & dst & spread(table >> 3))
            | (src & !dst & spread(table >> 2))
            | (!src & dst & spread(table >> 1))
            | (!src & !dst & spread(table))
    }

    /// Tells whether the result depends on the destination.
    pub const fn needs_dst(self) -> bool {
        // Bits 0 and 2 of the table are for a destination of 0, bits 1 and 3 for one of 1.
        let table = self.0 >> 1;
        table & 0b0101 != table >> 1 & 0b0101
    }
}

/// Returns a byte whose eight bits are all the lowest bit of `bit`.
const fn spread(bit: u16) -> u8 {
    if bit & 1 != 0 { 0xFF } else { 0 }
}

/// PIX_NOT: the complement of the function. The colour and the flag are dropped, as the manual's macro does.
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
