//! Weights of rays: one number for all registers of a colour, or one for each.

use crate::color::Rgb;
use crate::scalar::{Light, Scalar, Unit};

/// The weight of a ray: the part of its light that arrives in the pixel.
pub trait Weight<S: Scalar>: Copy + core::fmt::Debug + Send + Sync {
    /// The weight of the primary ray: 1.
    const WHOLE: Self;
    /// Returns the product of two weights.
    fn compose(self, other: Self) -> Self;
    /// Returns the sum of two weights.
    fn join(self, other: Self) -> Self;
    /// Returns the weight times a number.
    fn dimmed(self, factor: S::Unit) -> Self;
    /// Returns `light` times the weight.
    fn filter(self, light: Rgb<S::Light>) -> Rgb<S::Light>;
    /// Returns the weight of each register.
    fn registers(self) -> Rgb<S::Unit>;
    /// Returns whether the weight is below `threshold` in every register.
    fn is_below(self, threshold: S::Unit) -> bool;
}

impl<S: Scalar<Unit = U>, U: Unit> Weight<S> for U {
    const WHOLE: Self = U::ONE;
    fn compose(self, other: Self) -> Self {
        Unit::times(self, other)
    }
    fn join(self, other: Self) -> Self {
        self + other
    }
    fn dimmed(self, factor: U) -> Self {
        Unit::times(self, factor)
    }
    fn filter(self, light: Rgb<S::Light>) -> Rgb<S::Light> {
        light.map(|l| l.times(self))
    }
    fn registers(self) -> Rgb<U> {
        Rgb::new(self, self, self)
    }
    fn is_below(self, threshold: U) -> bool {
        self < threshold
    }
}

impl<S: Scalar<Unit = U>, U: Unit> Weight<S> for Rgb<U> {
    const WHOLE: Self = Rgb::new(U::ONE, U::ONE, U::ONE);
    fn compose(self, other: Self) -> Self {
        self.zip(other, Unit::times)
    }
    fn join(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
    fn dimmed(self, factor: U) -> Self {
        self.map(|register| register.times(factor))
    }
    fn filter(self, light: Rgb<S::Light>) -> Rgb<S::Light> {
        light.zip(self, Light::times)
    }
    fn registers(self) -> Self {
        self
    }
    fn is_below(self, threshold: U) -> bool {
        self.r < threshold && self.g < threshold && self.b < threshold
    }
}
