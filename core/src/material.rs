//! Surfaces: the four types of the thesis, and surfaces with coefficients of their own.

use crate::needs::Needs;
use crate::scalar::{Exponent, Scalar, Unit};

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
    /// Diffuse, specular and transparent with its own coefficients (NFF: E. Haines, "A Proposal for Standard Graphics
    /// Environments", IEEE CG&A 7, 1987).
    Finish(Finish<S>),
}

/// Coefficients of a surface. They need not add up to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finish<S: Scalar> {
    /// Coefficient of ambient light, 0 or more; usually kd.
    pub ka: S::Unit,
    /// Diffuse coefficient, 0 or more.
    pub kd: S::Unit,
    /// Exponent of the highlight, a real number: the larger the exponent, the smaller the highlight.
    pub exponent: Exponent,
    /// The exponent for highlights around the reflected ray, for Phong's model: the same, unless the size of highlights is given as
    /// an angle.
    pub reflected: Exponent,
    /// Reflection, whose `ks` weighs highlights too, and transmission; a `kt` of 0 makes the surface opaque.
    pub glass: Glass<S>,
}

impl<S: Scalar> Material<S> {
    /// Returns the coefficients of transmission; `None` for an opaque material.
    pub fn glass<N: Needs>(&self) -> Option<&Glass<S>> {
        match self {
            Self::Transparent(glass) if N::GLASS => Some(glass),
            Self::Finish(Finish { glass, .. }) if N::GLASS && N::FINISH && glass.kt > S::Unit::ZERO => {
                Some(glass)
            }
            _ => None,
        }
    }

    /// Returns the material's own coefficients; `None` for one of the thesis's four types.
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
    /// The smaller of the indices of refraction inside and outside over the larger: above 0, at most 1.
    pub eta: S::Unit,
    /// Whether the inside has the larger index of refraction, or both are equal.
    pub denser: bool,
}

impl<S: Scalar> Glass<S> {
    /// Returns glass with the index of refraction `numerator / denominator` relative to its outside, which reflects the part
    /// `ks` (0 to 1) and transmits the rest.
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
