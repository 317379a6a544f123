//! Colour as three independent registers, and the rounding of linear light to the levels of a display.

use crate::scalar::Light;

/// Red, green and blue.
///
/// Light is linear, without gamma, as in the thesis. The type of the registers says what they hold: reflectances, radiances,
/// or levels of a display.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Rgb<T> {
    /// Red register.
    pub r: T,
    /// Green register.
    pub g: T,
    /// Blue register.
    pub b: T,
}

impl<T> Rgb<T> {
    /// Returns a colour from its three registers.
    pub const fn new(r: T, g: T, b: T) -> Self {
        Self { r, g, b }
    }

    /// Applies `f` to each register.
    #[inline]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Rgb<U> {
        Rgb { r: f(self.r), g: f(self.g), b: f(self.b) }
    }

    /// Applies `f` to each pair of registers.
    #[inline]
    pub fn zip<U, V>(self, other: Rgb<U>, mut f: impl FnMut(T, U) -> V) -> Rgb<V> {
        Rgb { r: f(self.r, other.r), g: f(self.g, other.g), b: f(self.b, other.b) }
    }
}

impl<L: Light> Rgb<L> {
    /// No light.
    pub const BLACK: Self = Self::new(L::ZERO, L::ZERO, L::ZERO);

    /// Returns the sum of two radiances.
    #[inline]
    pub fn plus(self, other: Self) -> Self {
        self.zip(other, L::plus)
    }

    /// Returns the nearest of the levels `0..=max` of a display, whose level `max` is radiance 1, for each register. Brighter
    /// light gives `max`.
    #[inline]
    pub fn levels(self, max: u8) -> Rgb<u8> {
        self.map(|light| light.level(max))
    }
}
