//! Colour: three registers, each on its own; and linear light as the levels of a display.

use crate::scalar::Light;

/// Red, green and blue.
///
/// Linear light, no gamma, as in the thesis. What a register holds is its type: a
/// reflectance, a radiance, or a level of a display's gun.
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
    /// A colour from its three registers.
    pub const fn new(r: T, g: T, b: T) -> Self {
        Self { r, g, b }
    }

    /// Applies `f` to each register.
    #[inline]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Rgb<U> {
        Rgb { r: f(self.r), g: f(self.g), b: f(self.b) }
    }
}

impl<T> Rgb<T> {
    /// Applies `f` to each pair of registers.
    #[inline]
    pub fn zip<U, V>(self, other: Rgb<U>, mut f: impl FnMut(T, U) -> V) -> Rgb<V> {
        Rgb { r: f(self.r, other.r), g: f(self.g, other.g), b: f(self.b, other.b) }
    }
}

impl<L: Light> Rgb<L> {
    /// Darkness.
    pub const BLACK: Self = Self::new(L::ZERO, L::ZERO, L::ZERO);

    /// The sum of two lights.
    #[inline]
    pub fn plus(self, other: Self) -> Self {
        self.zip(other, L::plus)
    }

    /// The nearest levels `0..=max` of a display's guns, whose level `max` is radiance 1; what is brighter is that too.
    #[inline]
    pub fn levels(self, max: u8) -> Rgb<u8> {
        self.map(|light| light.level(max))
    }
}
