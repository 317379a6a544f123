//! The colour table that is built while the picture is drawn.

use rta_core::color::Rgb;

use super::{BACKGROUND, ColorTable, MAX_COLORS, TableError, nearest};
use crate::display::reduce;

/// Entries of the cache of colours already looked up: as many as a hash of one byte can name.
const SLOTS: usize = 256;

/// The colour table of the thesis, whose display program (its module RTA2) builds the table while it draws. A colour
/// that the table has is used again, a new one is appended while there is room, and once the table is full the
/// nearest entry stands for it.
///
/// A smooth sky can use up the table before anything below it is drawn. With a [`tolerance`], an entry that is near
/// enough is used again instead of appending another; with 0, the default, the table is that of the thesis.
///
/// The table takes 1804 bytes, of which 768 are its entries and 1024 a cache of colours already looked up, so it fits a
/// machine with 16 KiB of RAM.
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
    /// Entries so far, at least 1.
    len: u16,
    /// The most entries that the table may have.
    colors: u16,
    /// Squared distance up to which an entry is used again although the colour is another.
    tolerance: u32,
    /// The answer given last, because neighbouring pixels are often equal.
    last: Answer,
    /// Answers that can no longer change, each at the place that [`slot`] gives its colour. All start as that of black,
    /// which is entry 0.
    cache: [Answer; SLOTS],
}

/// A colour and the index that stands for it.
#[derive(Clone, Copy, Debug)]
struct Answer {
    levels: Rgb<u8>,
    index: u8,
}

impl Adaptive {
    /// Makes a table of at most `colors` entries, of which it has the first, black.
    ///
    /// # Errors
    /// [`TableError::Colors`] unless `colors` is 1..=256.
    pub const fn new(colors: u16) -> Result<Self, TableError> {
        if colors == 0 || colors > MAX_COLORS {
            return Err(TableError::Colors { colors, min: 1 });
        }
        let background = Answer { levels: BACKGROUND, index: 0 };
        Ok(Self {
            entries: [BACKGROUND; MAX_COLORS as usize],
            len: 1,
            colors,
            tolerance: 0,
            last: background,
            cache: [background; SLOTS],
        })
    }

    /// Makes a table of at most `colors` entries with a small tolerance, for guns of levels 0..=`gun_max`. A colour
    /// shares an entry that is as near as one whose three levels all differ by 6/255 of the guns' range, or nearer.
    /// So a smooth sky leaves room for what is below it.
    ///
    /// The 6 was chosen by the shipped scenes, whose pictures lose least with 4 to 12. On guns of 16 levels the
    /// tolerance is less than one level, so the table is that of [`Adaptive::new`].
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

    /// Sets the squared distance, in squared gun levels (see [`super::distance`]), up to which an existing entry is
    /// used instead of appending another.
    #[must_use]
    pub const fn with_tolerance(mut self, tolerance: u32) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Appends an entry and returns its index. The table must not be full.
    fn append(&mut self, levels: Rgb<u8>) -> u8 {
        if let Some(entry) = self.entries.get_mut(usize::from(self.len)) {
            *entry = levels;
        }
        // `len` is below `colors` and so below 256: its low byte is all of it.
        let index = self.len.to_le_bytes()[0];
        self.len += 1;
        index
    }
}

/// Returns the place of a colour in the cache: a hash of its three levels.
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
        let index = match self.cache.get(slot) {
            Some(cached) if cached.levels == levels => cached.index,
            _ => {
                let (near, distance) = nearest(self.entries(), levels);
                let full = self.len >= self.colors;
                let append = !full && distance > self.tolerance;
                let index = if append { self.append(levels) } else { near };
                // While entries are still appended, one of them may become nearer than an entry that is near but not
                // equal. Only answers that cannot change are kept.
                if (append || full || distance == 0)
                    && let Some(cached) = self.cache.get_mut(slot)
                {
                    *cached = Answer { levels, index };
                }
                index
            }
        };
        self.last = Answer { levels, index };
        index
    }

    fn index_near(&mut self, pixel: Rgb<u8>, color: Rgb<u8>, gun_max: u8) -> u8 {
        let _ = self.index(pixel.map(|level| reduce(level, gun_max)));
        // Distances in 1/255 of a level of the guns, whose squares leave 32 bits.
        let square = |entry: u8, wanted: u8| {
            let scaled = |level: u8, by: u8| u32::from(level) * u32::from(by);
            let d = u64::from(scaled(entry, u8::MAX).abs_diff(scaled(wanted, gun_max)));
            d * d
        };
        let distance =
            |entry: &Rgb<u8>| square(entry.r, color.r) + square(entry.g, color.g) + square(entry.b, color.b);
        let nearest = (0..=u8::MAX).zip(self.entries()).min_by_key(|(_, entry)| distance(entry));
        nearest.map_or(0, |(index, _)| index)
    }

    fn entries(&self) -> &[Rgb<u8>] {
        self.entries.get(..usize::from(self.len)).unwrap_or(&self.entries)
    }
}
