//! How the light at the corners of a row of pixels is kept, and which pixels are cut whatever it is.

use crate::color::Rgb;
use crate::scalar::{Light, Unit};

/// A light in the memory of a row.
pub trait Keep<L: Light>: Copy {
    /// Returns the light as it is kept.
    fn keep(light: Rgb<L>) -> Self;

    /// Returns the light that is kept.
    fn light(self) -> Rgb<L>;
}

/// As it is.
impl<L: Light> Keep<L> for Rgb<L> {
    fn keep(light: Self) -> Self {
        light
    }

    fn light(self) -> Self {
        self
    }
}

/// Light in three bytes: the nearest of the levels 0 to `MAX` of a display for each register; `MAX` is 1 or more.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Packed<const MAX: u8>(Rgb<u8>);

impl<L: Light, const MAX: u8> Keep<L> for Packed<MAX> {
    fn keep(light: Rgb<L>) -> Self {
        Self(light.levels(MAX))
    }

    fn light(self) -> Rgb<L> {
        self.0.map(|level| L::WHITE.times(L::Unit::ratio(level.into(), MAX.into())))
    }
}

/// Tells which pixels are cut to the full depth, although their corners may be alike: things that are smaller than a pixel may lie between
/// them.
pub trait Force {
    /// Returns whether the pixel in column `x` of row `y` is cut. It is asked once the light at its corners is known.
    fn is_cut(&self, x: u32, y: u32) -> bool;
}

/// None.
impl Force for () {
    fn is_cut(&self, _x: u32, _y: u32) -> bool {
        false
    }
}
