//! How many rays a picture takes.

use rta_core::Scalar;
use rta_core::ray::RayKind;
use rta_core::trace::Observer;
use rta_core::trace::decision::Start;

/// Rays by kind: primary, reflected, transmitted, shadow.
pub type Rays = [u64; 4];

/// Returns where in [`Rays`] a kind is counted.
#[must_use]
pub const fn place(kind: RayKind) -> usize {
    match kind {
        RayKind::Primary => 0,
        RayKind::Reflected => 1,
        RayKind::Transmitted => 2,
        RayKind::Shadow => 3,
    }
}

/// An observer that counts rays.
#[derive(Debug, Default)]
pub struct Tally(pub Rays);

impl Tally {
    fn count(&mut self, kind: RayKind) {
        if let Some(counter) = self.0.get_mut(place(kind)) {
            *counter += 1;
        }
    }
}

impl<S: Scalar> Observer<S> for Tally {
    fn ray(&mut self, kind: RayKind, _depth: u8, _start: &Start<S>) {
        self.count(kind);
    }

    fn shadow(&mut self, _lamp: usize, _start: &Start<S>) {
        self.count(RayKind::Shadow);
    }
}
