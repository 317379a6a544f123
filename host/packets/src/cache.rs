//! What a thread keeps from ray to ray: the last occluder of each lamp, and whether four rays are best searched for together.

use rta_core::scene::Object;

/// What is known from the rays before, of the eye's rays and of those to each lamp.
#[derive(Clone, Copy, Debug)]
pub struct ShadowCache {
    eye: History,
    /// More lamps share them.
    lamps: [History; 8],
}

/// What is known from the rays before that ended at a lamp, or started at the eye.
#[derive(Clone, Copy, Debug)]
pub(crate) struct History {
    /// The object that hid the lamp from the last point that it was hidden from: it is the first to be asked the next time (the
    /// shadow cache of E. Haines and D. Greenberg, "The Light Buffer", IEEE CG&A 6, 1986).
    pub(crate) occluder: Option<Object>,
    /// How often four rays are still to be searched for one by one before they are tried together again.
    left: u8,
    /// How often that was when it last began: the next time it is twice as often.
    last: u8,
}

/// Four rays with more items on their way than this are quicker one by one.
const MAX_TESTS: u32 = 8;

impl History {
    const NONE: Self = Self { occluder: None, left: 0, last: 7 };

    /// Returns whether four rays are to be searched for together this time.
    #[inline(always)]
    pub(crate) fn go_together(&mut self) -> bool {
        let left = self.left;
        self.left = left.saturating_sub(1);
        left == 0
    }

    /// Is told how many items four rays have tested together.
    #[inline(always)]
    pub(crate) fn have_tested(&mut self, items: u32) {
        if items <= MAX_TESTS {
            (self.left, self.last) = (0, 7);
        } else {
            self.last = self.last << 1 | 1;
            self.left = self.last;
        }
    }
}

impl ShadowCache {
    /// Returns what is known of the rays from the eye.
    #[inline(always)]
    pub(crate) fn of_eye(&mut self) -> &mut History {
        &mut self.eye
    }

    /// Returns what is known of the rays to a lamp.
    #[inline(always)]
    #[allow(clippy::indexing_slicing, reason = "the index is below 8")]
    pub(crate) fn of_lamp(&mut self, lamp: usize) -> &mut History {
        &mut self.lamps[lamp % 8]
    }
}

impl Default for ShadowCache {
    fn default() -> Self {
        Self { eye: History::NONE, lamps: [History::NONE; 8] }
    }
}
