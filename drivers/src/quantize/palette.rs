//! The colour table whose entries were chosen before the picture is drawn.

use rta_core::color::Rgb;

use super::{BACKGROUND, ColorTable, MAX_COLORS, TableError, distance};
use crate::display::{expand, reduce};

/// Starting places of the search: the sums of a colour's levels, at most 1020, in classes of 16.
const CLASSES: usize = 64;

/// A colour table of any entries, for light of 8 bits a gun. The entry that it finds is always the nearest.
///
/// The search (the partial distance of the sorted sum; L. Guan and M. Kamel, "Equal-average hyperplane partitioning method for vector
/// quantization of image data", Pattern Recognition Letters 13, 1992, with the sum weighted by gun) has its entries sorted by
/// `k = r + 2g + b`. By the inequality of Cauchy and Schwarz, two colours at the squared distance `d` have sums that differ by at most
/// `sqrt(6 d)`. So it walks from the place of the colour's own sum up, and then down, until the sums differ by more than the best
/// entry so far allows; the first of these is the entry of the pixel before.
///
/// The table takes 840 bytes on a processor of 32 bits, and may lie in flash: [`Palette::new`] is a constant function, and a shared
/// reference is a table too.
///
/// ```
/// use rta_core::color::Rgb;
/// use rta_drivers::quantize::{ColorTable, Palette, TableError};
///
/// static SUNSET: Result<Palette, TableError> = Palette::new(&[Rgb::new(63, 0, 0), Rgb::new(63, 32, 0)], 63);
/// let mut table: &Palette = SUNSET.as_ref().map_err(|error| *error)?;
/// assert_eq!(table.index(Rgb::new(250, 100, 0)), 2); // after black, by their sums
/// assert_eq!(table.entries()[2], Rgb::new(255, 130, 0)); // 32 of 63, in 8 bits
/// # Ok::<(), TableError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Palette {
    /// The entries in 8 bits a gun, sorted by [`key`], black first; then unused ones.
    entries: [Rgb<u8>; MAX_COLORS as usize],
    /// How many entries there are, at least 1.
    len: usize,
    /// The entry that was found last.
    last: u8,
    /// For each class of sums the first entry whose sum is in it or above it; the last entry, if none is.
    starts: [u8; CLASSES],
}

/// Returns what entries are sorted by, 0..=1020: the sum of the levels, with green, of which the eye sees most, counted twice.
const fn key(color: Rgb<u8>) -> u16 {
    color.r as u16 + 2 * color.g as u16 + color.b as u16
}

/// Returns a number that orders colours by [`key`], and those of one key by their levels.
const fn order(color: Rgb<u8>) -> u32 {
    (key(color) as u32) << 16 | (color.r as u32) << 8 | color.b as u32
}

impl Palette {
    /// Makes a table of black and of `colors`, which are levels 0..=`gun_max` of a display's guns, in any order. Higher levels count as
    /// `gun_max`; colours that are there twice, and black, become one entry.
    ///
    /// # Errors
    /// [`TableError::Colors`] for more than 256 entries; [`TableError::Guns`] if `gun_max` is 0.
    #[allow(clippy::indexing_slicing, reason = "each index is checked; a constant function cannot iterate")]
    pub const fn new(colors: &[Rgb<u8>], gun_max: u8) -> Result<Self, TableError> {
        if gun_max == 0 {
            return Err(TableError::Guns);
        }
        let mut entries = [BACKGROUND; MAX_COLORS as usize];
        let (mut len, mut next) = (1, 0);
        while next < colors.len() {
            let Rgb { r, g, b } = colors[next];
            let color = Rgb::new(expand(r, gun_max), expand(g, gun_max), expand(b, gun_max));
            // An insertion sort. Entries are few, and mostly come by twos that are alike.
            let mut place = len;
            while place > 0 && order(entries[place - 1]) > order(color) {
                place -= 1;
            }
            if place == 0 || order(entries[place - 1]) != order(color) {
                if len == MAX_COLORS as usize {
                    return Err(TableError::Colors { colors: MAX_COLORS + 1, min: 1 });
                }
                let mut last = len;
                while last > place {
                    entries[last] = entries[last - 1];
                    last -= 1;
                }
                entries[place] = color;
                len += 1;
            }
            next += 1;
        }
        Ok(Self { entries, len, last: 0, starts: starts(&entries, len) })
    }

    /// Returns the entries as levels 0..=`gun_max` of a display's guns, as [`Palette::new`] takes them.
    pub fn levels(&self, gun_max: u8) -> impl Iterator<Item = Rgb<u8>> {
        self.all().iter().map(move |color| color.map(|level| reduce(level, gun_max)))
    }

    /// Returns the index of the entry nearest to `color`, 8 bits a gun; of equally near ones, the lowest index.
    pub fn nearest(&self, color: Rgb<u8>) -> u8 {
        self.nearest_or(color, 0)
    }

    /// Returns what [`Palette::nearest`] does, whatever `guess` is. It is quicker the nearer that entry is, as the one of the pixel before
    /// mostly is.
    fn nearest_or(&self, color: Rgb<u8>, guess: u8) -> u8 {
        let (entries, wanted) = (self.all(), i32::from(key(color)));
        let class = self.starts.get(usize::from(key(color) / 16)).copied().unwrap_or(0);
        let (upper, lower) =
            entries.split_at_checked(class.into()).map_or((entries, &[][..]), |(a, b)| (b, a));
        let mut best = Best { distance: u32::MAX, limit: u32::MAX, index: guess };
        if let Some(&entry) = entries.get(usize::from(guess)) {
            best.meet(color, entry, guess);
        }
        // An index is that of one of at most 256 entries, so counting up ends before it wraps.
        let mut index = class;
        for &entry in upper {
            let gap = i32::from(key(entry)) - wanted;
            // The first few entries may have smaller sums than the colour.
            if gap > 0 && (gap * gap).cast_unsigned() > best.limit {
                break;
            }
            best.meet(color, entry, index);
            index = index.wrapping_add(1);
        }
        let mut index = class;
        for &entry in lower.iter().rev() {
            index = index.wrapping_sub(1);
            let gap = wanted - i32::from(key(entry));
            if (gap * gap).cast_unsigned() > best.limit {
                break;
            }
            best.meet(color, entry, index);
        }
        best.index
    }

    fn all(&self) -> &[Rgb<u8>] {
        self.entries.get(..self.len).unwrap_or(&self.entries)
    }
}

/// The nearest entry so far.
struct Best {
    distance: u32,
    /// The square of the greatest difference of sums that an entry as near can have.
    limit: u32,
    index: u8,
}

impl Best {
    #[inline]
    fn meet(&mut self, color: Rgb<u8>, entry: Rgb<u8>, index: u8) {
        let distance = distance(entry, color);
        if distance < self.distance || (distance == self.distance && index < self.index) {
            *self = Self { distance, limit: 6 * distance, index };
        }
    }
}

/// Returns for each class of sums the first entry that is in it or above it; the last entry, if none is.
#[allow(clippy::indexing_slicing, reason = "each index is checked; a constant function cannot iterate")]
const fn starts(entries: &[Rgb<u8>; MAX_COLORS as usize], len: usize) -> [u8; CLASSES] {
    let mut starts = [0; CLASSES];
    let (mut class, mut entry) = (0, 0);
    while class < CLASSES {
        while entry + 1 < len && (key(entries[entry]) as usize) < 16 * class {
            entry += 1;
        }
        // Below 256, as the length is at most that.
        starts[class] = entry.to_le_bytes()[0];
        class += 1;
    }
    starts
}

impl ColorTable for Palette {
    fn light_max(&self, _gun_max: u8) -> u8 {
        u8::MAX
    }
    fn index(&mut self, color: Rgb<u8>) -> u8 {
        self.last = self.nearest_or(color, self.last);
        self.last
    }
    fn index_near(&mut self, _pixel: Rgb<u8>, color: Rgb<u8>, _gun_max: u8) -> u8 {
        self.index(color)
    }
    fn entries(&self) -> &[Rgb<u8>] {
        self.all()
    }
}

/// A palette never changes, so a shared reference to one, in flash for example, is a colour table too.
impl ColorTable for &Palette {
    fn light_max(&self, _gun_max: u8) -> u8 {
        u8::MAX
    }
    fn index(&mut self, color: Rgb<u8>) -> u8 {
        self.nearest(color)
    }
    fn index_near(&mut self, _pixel: Rgb<u8>, color: Rgb<u8>, _gun_max: u8) -> u8 {
        self.nearest(color)
    }
    fn entries(&self) -> &[Rgb<u8>] {
        self.all()
    }
}
