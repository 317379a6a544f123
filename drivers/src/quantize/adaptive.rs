//! The colour table that is built while the picture is drawn.

use rta_core::color::Rgb;

use super::{BACKGROUND, ColorTable, MAX_COLORS, TableError, nearest};

/// Slots of the memory of colours already looked up; a power of two, at most 256.
const SLOTS: usize = 256;

/// The thesis's colour table (rta-model, "Devices of the thesis"): a colour that the table has is used
/// again, a new one is appended while there is room, and once the table is full the nearest entry stands
/// for it.
///
/// A smooth sky can use up the table before anything below it is drawn. With a [`tolerance`] an entry
/// that is near enough is used again instead of appending another; 0, the default, is the thesis's way.
///
/// Takes 1804 bytes (768 of entries, 1024 of colours already looked up): it fits a machine with
/// 16 KiB of RAM.
///
/// [`tolerance`]: Adaptive::with_tolerance
///
/// ```
/// use rta_core::color::Rgb;
/// use rta_drivers::quantize::{Adaptive, ColorTable};
///
/// let mut table = Adaptive::new(3)?;
/// assert_eq!(table.index(Rgb::new(9, 9, 9)), 1); // 0 is the background, black
/// assert_eq!(table.index(Rgb::new(63, 0, 0)), 2); // appended; the table is full
/// assert_eq!(table.index(Rgb::new(50, 0, 0)), 2); // the nearest
/// # Ok::<(), rta_drivers::quantize::TableError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Adaptive {
    entries: [Rgb<u8>; MAX_COLORS as usize],
    len: u16,
    colors: u16,
    tolerance: u32,
    /// The colour asked for last and its index: neighbouring pixels are often equal.
    last: Found,
    /// Answers that can no longer change, one in each slot; see [`slot`]. Slots start with the
    /// background at index 0, which is true.
    found: [Found; SLOTS],
}

/// A colour and the index that stands for it.
#[derive(Clone, Copy, Debug)]
struct Found {
    levels: Rgb<u8>,
    index: u8,
}

impl Adaptive {
    /// A table of at most `colors` entries that has the background only.
    ///
    /// # Errors
    /// [`TableError::Colors`] unless `colors` is 1..=256.
    pub const fn new(colors: u16) -> Result<Self, TableError> {
        if colors == 0 || colors > MAX_COLORS {
            return Err(TableError::Colors { colors, min: 1 });
        }
        let background = Found { levels: BACKGROUND, index: 0 };
        Ok(Self {
            entries: [BACKGROUND; MAX_COLORS as usize],
            len: 1,
            colors,
            tolerance: 0,
            last: background,
            found: [background; SLOTS],
        })
    }

    /// The same table for guns of `gun_max` + 1 levels, with a small tolerance: what is within 6 of 255 levels of an
    /// entry shares it, so that a smooth sky leaves room for what is below it. The shipped scenes lose least by 4 to 12;
    /// on guns of 16 levels it is less than one, which makes no difference.
    ///
    /// # Errors
    /// [`TableError::Colors`] unless `colors` is 1..=256.
    pub const fn tolerant(colors: u16, gun_max: u8) -> Result<Self, TableError> {
        match Self::new(colors) {
            Ok(table) => {
                let (levels, of) = (6 * gun_max as u32, u8::MAX as u32);
                Ok(table.with_tolerance(3 * levels * levels / (of * of)))
            }
            Err(error) => Err(error),
        }
    }

    /// Uses an existing entry within `tolerance`, in squared gun levels (see [`super::distance`]),
    /// before it appends another.
    #[must_use]
    pub const fn with_tolerance(mut self, tolerance: u32) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Appends `levels` and returns its index. There must be room.
    fn append(&mut self, levels: Rgb<u8>) -> u8 {
        if let Some(entry) = self.entries.get_mut(usize::from(self.len)) {
            *entry = levels;
        }
        // len < colors <= 256 here, so the new index is one byte.
        let index = self.len.to_le_bytes()[0];
        self.len += 1;
        index
    }
}

/// Where the answer for `levels` is kept: a hash of the three levels.
fn slot(levels: Rgb<u8>) -> usize {
    let hash = levels
        .r
        .wrapping_mul(167)
        .wrapping_add(levels.g.wrapping_mul(59))
        .wrapping_add(levels.b.wrapping_mul(13));
    usize::from(hash) % SLOTS
}

impl ColorTable for Adaptive {
    fn index(&mut self, levels: Rgb<u8>) -> u8 {
        if self.last.levels == levels {
            return self.last.index;
        }
        let slot = slot(levels);
        let index = match self.found.get(slot) {
            Some(found) if found.levels == levels => found.index,
            _ => {
                let (near, distance) = nearest(self.entries(), levels);
                let full = self.len >= self.colors;
                let append = !full && distance > self.tolerance;
                let index = if append { self.append(levels) } else { near };
                // An entry that is near but not equal may be bettered while entries are still being
                // appended: only answers that last are kept.
                if (append || full || distance == 0)
                    && let Some(found) = self.found.get_mut(slot)
                {
                    *found = Found { levels, index };
                }
                index
            }
        };
        self.last = Found { levels, index };
        index
    }

    fn entries(&self) -> &[Rgb<u8>] {
        self.entries.get(..usize::from(self.len)).unwrap_or(&self.entries)
    }
}
