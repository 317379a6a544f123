//! Where the rays of patches end, as it is kept.

use crate::color::Rgb;
use crate::scalar::{Scalar, Summed};

/// The end of a ray of a patch on another patch.
#[derive(Clone, Copy, Debug)]
pub struct End<S: Scalar> {
    /// The number of the other patch among all.
    pub(super) number: u32,
    /// The part of its light that arrives, register by register.
    pub(super) weights: Rgb<S::Unit>,
    /// Whether the ray came there straight, not by mirrors or glass.
    pub(super) is_straight: bool,
}

/// What a patch sees: the ends of its rays, in their order, and the sum of the weights of all its rays.
pub struct View<'v, S: Scalar> {
    /// The ends.
    pub ends: &'v [End<S>],
    /// The sum of the weights, also of rays that are lost.
    pub whole: <S::Light as Summed>::Sum,
}
