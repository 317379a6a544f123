//! What is known from the rays before.

use crate::bvh::Item;
use crate::lanes::LANES;

/// What is known from the rays before; nothing where there are no lanes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known {
    of: [Lately; KNOWN],
}

/// What is known of the rays to a lamp, or of those from the eye.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lately {
    /// The object that hid the lamp from the last point that it was hidden from: it is the first to be asked the next time (the
    /// shadow cache, after E. Haines and D. Greenberg, "The Light Buffer", IEEE CG&A 6, 1986).
    pub(super) occluder: Item,
    alone: Alone,
}

/// How many times the rays of four pixels are searched for one by one, and how many it was the last time: twice as many the next.
#[derive(Clone, Copy, Debug)]
struct Alone {
    left: u8,
    last: u8,
}

/// More lamps share them; the last is the eye's.
const KNOWN: usize = if LANES { 9 } else { 0 };
/// With more items on their way four rays are quicker one by one.
const CROWD: u32 = 8;

impl Alone {
    const NEVER: Self = Self { left: 0, last: 7 };

    /// Whether four go together.
    #[inline(always)]
    fn is_over(&mut self) -> bool {
        let left = self.left;
        self.left = left.saturating_sub(1);
        left == 0
    }

    /// Told whether that was good.
    #[inline(always)]
    fn learn(&mut self, was_good: bool) {
        *self = if was_good {
            Self::NEVER
        } else {
            let last = self.last << 1 | 1;
            Self { left: last, last }
        };
    }
}

impl Known {
    /// Nothing yet.
    pub(crate) const fn new() -> Self {
        let nothing = Lately { occluder: Item::NONE, alone: Alone::NEVER };
        Self { of: [nothing; KNOWN] }
    }

    /// What is known of the rays from the eye.
    pub(super) fn of_eye(&mut self) -> Option<&mut Lately> {
        self.of.get_mut(8)
    }

    /// What is known of the rays to a lamp.
    pub(super) fn of(&mut self, lamp: usize) -> Option<&mut Lately> {
        self.of.get_mut(lamp % 8)
    }
}

impl Lately {
    /// Whether four rays are searched for together.
    #[inline(always)]
    pub(super) fn go_together(&mut self) -> bool {
        self.alone.is_over()
    }

    /// Told how many items they have asked.
    #[inline(always)]
    pub(super) fn have_asked(&mut self, items: u32) {
        self.alone.learn(items <= CROWD);
    }
}
