//! How pixels are cut.

/// How pixels are cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Cutting {
    /// How often a pixel is halved along each side at most, 0 to [`Cutting::DEEPEST`].
    pub(super) depth: u8,
    /// Corners of a whole pixel that differ by more than this share of white, in 256ths, in any register are not alike.
    pub(super) tolerance: u8,
}

impl Default for Cutting {
    /// Twice, with [`Cutting::TOLERANCE`].
    fn default() -> Self {
        Self { depth: 2, tolerance: Self::TOLERANCE }
    }
}

impl Cutting {
    /// The largest depth.
    pub const DEEPEST: u8 = 4;

    /// The usual tolerance: a sixteenth of white.
    pub const TOLERANCE: u8 = 16;

    /// Returns a depth and a tolerance in 256ths of white; `None` where the depth is above [`Cutting::DEEPEST`].
    pub const fn new(depth: u8, tolerance: u8) -> Option<Self> {
        if depth > Self::DEEPEST { None } else { Some(Self { depth, tolerance }) }
    }

    /// Returns the deepest cutting, of pixels that differ at all.
    pub const fn most() -> Self {
        Self { depth: Self::DEEPEST, tolerance: 0 }
    }

    /// Returns the depth.
    pub const fn depth(self) -> u8 {
        self.depth
    }

    /// Returns the tolerance, in 256ths of white.
    pub const fn tolerance(self) -> u8 {
        self.tolerance
    }

    /// Returns how many places of a pixel have light of their own at most: `(2^depth + 1)^2`, the room of a [`Corners`](super::Corners).
    pub const fn places(self) -> usize {
        let side = (1 << self.depth) + 1;
        side * side
    }

    /// Returns how many places on an edge of a pixel, without its corners, have light of their own at most: the room of
    /// [`Corners::sharing`](super::Corners::sharing).
    pub const fn edges(self) -> usize {
        (1 << self.depth) - 1
    }
}
