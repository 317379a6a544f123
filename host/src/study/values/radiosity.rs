//! The functions of form factors, and of how often a Z-buffer writes, computed in f64 whatever the format.

use rta_core::radiosity::exact;

use super::functions::{Function, functions};

/// Returns the functions. `harmonic` is how often a Z-buffer writes a pixel that n faces cover in random order.
pub(super) fn all() -> Vec<Function> {
    functions! {
        ff_parallel(a, b, c) within 0.0 => exact::parallel(a, b, c);
        ff_perp(w, h, l) within 0.0 => exact::perpendicular(w, h, l);
        ff_discs(r1, r2, h) within 0.0 => exact::discs(r1, r2, h);
        harmonic(n) within 0.0 => harmonic(n);
    }
}

/// Returns the sum of `1/k` for k from 1 to n.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it saturates")]
fn harmonic(n: f64) -> f64 {
    (1..=n as u32).rev().map(|k| 1.0 / f64::from(k)).sum()
}
