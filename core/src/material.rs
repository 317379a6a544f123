//! Surfaces: the four types of the thesis, and surfaces with coefficients of their own.

use crate::needs::Needs;
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
    /// Diffuse, specular and transparent by coefficients of its own (NFF: E. Haines, "A Proposal for Standard Graphics
    /// Environments", IEEE CG&A 7, 1987).
    Finish(Finish<S>),
}

/// Coefficients of a surface. They need not add up to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finish<S: Scalar> {
    /// Diffuse coefficient, 0 or more.
    pub kd: S::Unit,
    /// Exponent of the highlight: the larger, the smaller.
    pub exponent: u32,
    /// What is reflected, highlights too, and what is transmitted, which may be nothing.
    pub glass: Glass<S>,
}

impl<S: Scalar> Material<S> {
    /// How light goes through, if any does.
    pub fn glass<N: Needs>(&self) -> Option<&Glass<S>> {
        match self {
            Self::Transparent(glass) if N::GLASS => Some(glass),
            Self::Finish(Finish { glass, .. }) if N::GLASS && N::FINISH && glass.kt > S::Unit::ZERO => {
                Some(glass)
            }
            _ => None,
        }
    }

    /// Coefficients of its own, if it has them.
    pub fn finish<N: Needs>(&self) -> Option<&Finish<S>> {
        match self {
            Self::Finish(finish) if N::FINISH => Some(finish),
            _ => None,
        }
    }
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
