//! Quantisation: from the levels of three guns to an index of the colour table.
//!
//! Two tables. [`Uniform`] is a fixed cube: the same for every picture, known before it is drawn.
//! [`Adaptive`] is the thesis's: built while the picture is drawn.
//!
//! Index 0 is black in both. It is the background of a graPHIGS workstation, the border of a VGA screen
//! (overscan, attribute register 11h = 0) and what cleared memory shows on all three devices; a table
//! that put the picture's first colour there would tint all that is not drawn yet.
//!
//! Distance is squared Euclidean in gun levels (at most 3 * 255^2); of equally near entries the lowest
//! index wins, so the same picture always gives the same indices.

mod adaptive;

use core::fmt;

use rta_core::color::Rgb;

pub use adaptive::Adaptive;

/// Most entries a table can have: an index is one byte.
pub const MAX_COLORS: u16 = 256;

/// Black: entry 0 of every table here.
pub const BACKGROUND: Rgb<u8> = Rgb::new(0, 0, 0);

/// A colour table that is asked for the index of a colour.
pub trait ColorTable {
    /// The index of the entry that stands for `levels`. May append entries, never changes or removes
    /// one.
    fn index(&mut self, levels: Rgb<u8>) -> u8;

    /// The entries so far, at least one. Those beyond the length seen before are new: a driver loads
    /// them while the picture is being drawn (see [`crate::painter::Painter`]).
    fn entries(&self) -> &[Rgb<u8>];
}

impl<T: ColorTable + ?Sized> ColorTable for &mut T {
    fn index(&mut self, levels: Rgb<u8>) -> u8 {
        T::index(self, levels)
    }
    fn entries(&self) -> &[Rgb<u8>] {
        T::entries(self)
    }
}

/// A colour table cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TableError {
    /// The number of colours is outside the table's range.
    Colors {
        /// The number asked for.
        colors: u16,
        /// The fewest the table can have; the most is [`MAX_COLORS`].
        min: u16,
    },
    /// A gun with level 0 only.
    Guns,
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Colors { colors, min } => {
                write!(f, "a table of {colors} colours: from {min} to {MAX_COLORS} are possible")
            }
            Self::Guns => write!(f, "the guns have no level above 0"),
        }
    }
}

impl core::error::Error for TableError {}

/// Squared distance of two colours, in squared gun levels: 0..=195075.
pub fn distance(a: Rgb<u8>, b: Rgb<u8>) -> u32 {
    let square = |a: u8, b: u8| {
        let d = u32::from(a.abs_diff(b));
        d * d
    };
    square(a.r, b.r) + square(a.g, b.g) + square(a.b, b.b)
}

/// The entry nearest to `levels` and its squared distance. Ties go to the lowest index; no entries at
/// all give index 0 at the greatest distance. Only the first 256 entries are looked at.
pub fn nearest(entries: &[Rgb<u8>], levels: Rgb<u8>) -> (u8, u32) {
    let mut best = (0, u32::MAX);
    for (index, &entry) in (0..=u8::MAX).zip(entries) {
        let d = distance(entry, levels);
        if d < best.1 {
            best = (index, d);
        }
    }
    best
}

/// A fixed cube of evenly spaced levels: 6 x 7 x 6 = 252 entries of 256 colours, 5 x 5 x 5 = 125 of 128.
///
/// The sides differ by one at most and green, to which the eye is most sensitive, has the first of the
/// spare ones. The answer is the nearest entry of the cube, exactly. Takes 771 bytes.
#[derive(Clone, Debug)]
pub struct Uniform {
    entries: [Rgb<u8>; MAX_COLORS as usize],
    sides: Rgb<u8>,
}

impl Uniform {
    /// The largest cube within `colors` entries for guns of `gun_max` + 1 levels.
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
        // Raise one side after another, round after round, while the cube fits: green, red, blue, at most 7 x 6 x 6.
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

    /// Levels of each gun that the cube has.
    pub fn sides(&self) -> Rgb<u8> {
        self.sides
    }
}

/// Level `step` of `side` evenly spaced ones (`side` > 1), rounded to the nearest.
#[allow(clippy::cast_possible_truncation, reason = "a step is below 7, so the quotient is at most gun_max")]
const fn level(step: usize, side: u8, gun_max: u8) -> u8 {
    let (step, last, max) = (step as u32, side as u32 - 1, gun_max as u32);
    ((2 * step * max + last) / (2 * last)) as u8
}

impl Uniform {
    /// The index of the entry nearest to `levels`.
    pub fn nearest(&self, levels: Rgb<u8>) -> u8 {
        // The guns are independent, so the nearest entry is the nearest level of each.
        let (green, blue) = (u16::from(self.sides.g), u16::from(self.sides.b));
        let r = self.step(0, green * blue, levels.r);
        let g = self.step(1, blue, levels.g);
        let b = self.step(2, 1, levels.b);
        // At most 251: the index of the cube's last entry.
        ((r * green + g) * blue + b).to_le_bytes()[0]
    }

    /// The step of a gun (0 is red, 1 green, 2 blue), `stride` entries each, whose level is nearest to `wanted`; the lower
    /// of two equally near. A gun's levels rise until they begin anew, so the search ends where they leave.
    #[cfg_attr(target_os = "none", inline(never))] // three guns ask
    fn step(&self, gun: usize, stride: u16, wanted: u8) -> u16 {
        let mut best = (0, u8::MAX);
        for (step, entry) in (0_u16..).zip(self.entries.iter().step_by(usize::from(stride))) {
            let level = [entry.r, entry.g, entry.b].get(gun).copied().unwrap_or(0);
            let d = level.abs_diff(wanted);
            if step > 0 && d >= best.1 {
                break;
            }
            best = (step, d);
        }
        best.0
    }

    fn cube(&self) -> &[Rgb<u8>] {
        let len = usize::from(self.sides.r) * usize::from(self.sides.g) * usize::from(self.sides.b);
        self.entries.get(..len).unwrap_or(&self.entries)
    }
}

impl ColorTable for Uniform {
    fn index(&mut self, levels: Rgb<u8>) -> u8 {
        self.nearest(levels)
    }
    fn entries(&self) -> &[Rgb<u8>] {
        self.cube()
    }
}

/// The cube never changes, so one in flash will do.
impl ColorTable for &Uniform {
    fn index(&mut self, levels: Rgb<u8>) -> u8 {
        self.nearest(levels)
    }
    fn entries(&self) -> &[Rgb<u8>] {
        self.cube()
    }
}
