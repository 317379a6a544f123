//! What is known from the rays before.

use crate::bvh::Item;
use crate::lanes::LANES;

/// What is known from the rays before; nothing where there are no lanes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known([Lately; KNOWN]);

/// What is known of the rays to a lamp, or of those from the eye.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lately {
    /// The object that hid the lamp from the last point that it was hidden from: it is the first to be asked the next time (the
    /// shadow cache, after E. Haines and D. Greenberg, "The Light Buffer", IEEE CG&A 6, 1986).
    pub(super) occluder: Item,
    /// Rays go one by one so many times; and the last time it was so many.
    alone: u8,
    before: u8,
}

/// More lamps share them; the last is the eye's.
const KNOWN: usize = if LANES { 9 } else { 0 };

impl Known {
    /// Nothing yet.
    pub(crate) const fn new() -> Self {
        Self([Lately { occluder: Item::NONE, alone: 0, before: 7 }; KNOWN])
    }

    /// Of a lamp.
    pub(super) fn of(&mut self, lamp: usize) -> Option<&mut Lately> {
        self.0.get_mut(lamp % 8)
    }

    /// Of the eye.
    pub(super) fn of_eye(&mut self) -> Option<&mut Lately> {
        self.0.get_mut(8)
    }
}

impl Lately {
    /// Whether four rays go beside each other.
    #[inline(always)]
    pub(super) fn go_together(&mut self) -> bool {
        let alone = self.alone;
        self.alone = alone.saturating_sub(1);
        alone == 0
    }

    /// Told how many items four rays have asked together.
    #[inline(always)]
    pub(super) fn have_asked(&mut self, items: u32) {
        if items > CROWD {
            self.before = self.before << 1 | 1;
            self.alone = self.before;
        } else {
            self.before = 7;
        }
    }
}

/// With more items on their way four rays are quicker one by one.
const CROWD: u32 = 8;
