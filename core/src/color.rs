//! Colour: three registers, each on its own.

/// Red, green and blue.
///
/// Linear light, no gamma (thesis; rta-model section "World"). What a register holds is its type: a
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
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Rgb<U> {
        Rgb { r: f(self.r), g: f(self.g), b: f(self.b) }
    }
}
