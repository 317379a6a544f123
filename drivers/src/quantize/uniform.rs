//! The colour table that is alike for every picture.

use rta_core::color::Rgb;

use super::{BACKGROUND, ColorTable, MAX_COLORS, TableError};

/// A fixed cube of evenly spaced levels, red x green x blue: 6 x 7 x 6 = 252 entries where there is room for 256
/// colours, 5 x 5 x 5 = 125 where there is room for 128.
///
/// The sides differ by one at most; green, to which the eye is most sensitive, is the first to get one level more. The
/// entry found for a colour is always the nearest of the cube. The table takes 771 bytes.
#[derive(Clone, Debug)]
pub struct Uniform {
    /// The cube, in which blue varies fastest and red slowest, then unused entries.
    entries: [Rgb<u8>; MAX_COLORS as usize],
    /// Levels of each gun in the cube, at least 2.
    sides: Rgb<u8>,
}

impl Uniform {
    /// Makes the largest cube that has at most `colors` entries, for guns of levels 0..=`gun_max`.
    ///
    /// # Errors
    /// [`TableError::Colors`] unless `colors` is 8..=256; [`TableError::Guns`] if `gun_max` is 0.
    #[allow(
        clippy::indexing_slicing,
        reason = "every index is below the length; a constant function cannot iterate"
    )]
    pub const fn new(colors: u16, gun_max: u8) -> Result<Self, TableError> {
        if colors < 8 || colors > MAX_COLORS {
            return Err(TableError::Colors { colors, min: 8 });
        }
        if gun_max == 0 {
            return Err(TableError::Guns);
        }
        // The sides grow by one level in turn (green, red, blue) as long as the cube has at most `colors` entries and
        // the guns have the levels: up to 7, 6 and 6.
        let mut sides = [2_u8; 3];
        let mut raised = 0;
        let most = gun_max.saturating_add(1);
        let order = [1, 0, 2];
        loop {
            let mut larger = sides;
            larger[order[raised % 3]] += 1;
            let size = larger[0] as u16 * larger[1] as u16 * larger[2] as u16;
            if size > colors || larger[order[raised % 3]] > most {
                break;
            }
            sides = larger;
            raised += 1;
        }
        let sides = Rgb::new(sides[0], sides[1], sides[2]);
        let (greens, blues) = (sides.g as usize, sides.b as usize);
        let mut entries = [BACKGROUND; MAX_COLORS as usize];
        let mut index = 0;
        while index < sides.r as usize * greens * blues {
            let step = [index / (greens * blues), index / blues % greens, index % blues];
            entries[index] = Rgb::new(
                level(step[0], sides.r, gun_max),
                level(step[1], sides.g, gun_max),
                level(step[2], sides.b, gun_max),
            );
            index += 1;
        }
        Ok(Self { entries, sides })
    }

    /// Returns how many levels of red, green and blue the cube has, 2..=7 each.
    pub fn sides(&self) -> Rgb<u8> {
        self.sides
    }
}

/// Returns level number `step` of `side` evenly spaced ones from 0 to `gun_max`, rounded to the nearest. `side` is at
/// least 2.
#[allow(clippy::cast_possible_truncation, reason = "a step is below 7, so the quotient is at most gun_max")]
const fn level(step: usize, side: u8, gun_max: u8) -> u8 {
    let (step, last, max) = (step as u32, side as u32 - 1, gun_max as u32);
    ((2 * step * max + last) / (2 * last)) as u8
}

impl Uniform {
    /// Returns the index of the entry nearest to `levels`; of equally near ones, that of the lowest index.
    pub fn nearest(&self, levels: Rgb<u8>) -> u8 {
        self.nearest_of(levels, 1, 1)
    }

    /// Returns the index of the entry nearest to a colour whose levels, times `wanted` and over `level`, are levels of the guns.
    fn nearest_of(&self, color: Rgb<u8>, wanted: u8, level: u8) -> u8 {
        // The cube has every combination of its levels, so the nearest entry is made of the nearest level of each gun.
        let (green, blue) = (u16::from(self.sides.g), u16::from(self.sides.b));
        let scaled = |register: u8| u16::from(register) * u16::from(wanted);
        let r = self.step(0, green * blue, scaled(color.r), level);
        let g = self.step(1, blue, scaled(color.g), level);
        let b = self.step(2, 1, scaled(color.b), level);
        // At most 251: the index of the cube's last entry.
        ((r * green + g) * blue + b).to_le_bytes()[0]
    }

    /// Returns which of the levels of `gun` (0 is red, 1 green, 2 blue) in the cube is nearest to `wanted`, counted
    /// from the lowest; of two equally near ones the lower. `stride` is the number of entries from one level to the
    /// next, and `wanted` is in units of 1 / `scale` of a level.
    // One call for each gun: firmware, where size counts, holds this loop once and not three times.
    #[cfg_attr(target_os = "none", inline(never))]
    fn step(&self, gun: usize, stride: u16, wanted: u16, scale: u8) -> u16 {
        let mut best = (0, u16::MAX);
        for (step, entry) in (0_u16..).zip(self.entries.iter().step_by(usize::from(stride))) {
            let level = [entry.r, entry.g, entry.b].get(gun).copied().unwrap_or(0);
            let d = (u16::from(level) * u16::from(scale)).abs_diff(wanted);
            // The levels of a gun rise until the cube begins anew with level 0, so once the distance no longer shrinks
            // no later level is nearer.
            if step > 0 && d >= best.1 {
                break;
            }
            best = (step, d);
        }
        best.0
    }

    /// The entries of the cube.
    fn cube(&self) -> &[Rgb<u8>] {
        let len = usize::from(self.sides.r) * usize::from(self.sides.g) * usize::from(self.sides.b);
        self.entries.get(..len).unwrap_or(&self.entries)
    }
}

impl ColorTable for Uniform {
    fn index(&mut self, levels: Rgb<u8>) -> u8 {
        self.nearest(levels)
    }
    fn index_near(&mut self, _pixel: Rgb<u8>, color: Rgb<u8>, gun_max: u8) -> u8 {
        self.nearest_of(color, gun_max, u8::MAX)
    }
    fn entries(&self) -> &[Rgb<u8>] {
        self.cube()
    }
}

/// The cube never changes, so a shared reference to one, in flash for example, is a colour table too.
impl ColorTable for &Uniform {
    fn index(&mut self, levels: Rgb<u8>) -> u8 {
        self.nearest(levels)
    }
    fn index_near(&mut self, _pixel: Rgb<u8>, color: Rgb<u8>, gun_max: u8) -> u8 {
        self.nearest_of(color, gun_max, u8::MAX)
    }
    fn entries(&self) -> &[Rgb<u8>] {
        self.cube()
    }
}
