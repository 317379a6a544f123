//! Surfaces: the four types of the thesis (rta-model section 1).

use crate::scalar::{Scalar, Unit};

/// What a surface does with light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Material<S: Scalar> {
    /// Type 0: diffuse.
    Opaque,
    /// Type 1: diffuse, with a highlight of each lamp.
    Shiny,
    /// Type 2: a perfect mirror.
    Mirror,
    /// Type 3: reflects one part of the light and lets another through.
    Transparent(Glass<S>),
}

/// A transparent material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glass<S: Scalar> {
    /// Weight of the reflected ray, 0 to 1.
    pub ks: S::Unit,
    /// Weight of the transmitted ray, 0 to 1.
    pub kt: S::Unit,
    /// The smaller index of refraction over the larger, of inside and outside: ]0, 1].
    pub eta: S::Unit,
    /// Whether the inside has the larger index.
    pub denser: bool,
}

impl<S: Scalar> Glass<S> {
    /// Glass whose inside is `numerator / denominator` times as dense as its outside, that reflects the part `ks` and
    /// lets the rest through.
    pub fn new(ks: S::Unit, numerator: u32, denominator: u32) -> Self {
        let (smaller, larger) = (numerator.min(denominator), numerator.max(denominator));
        Self {
            ks,
            kt: S::Unit::ONE - ks,
            eta: S::Unit::ratio(i64::from(smaller), i64::from(larger)),
            denser: numerator >= denominator,
        }
    }
}
