//! What becomes of one pixel's rays: the object that the eye sees there, and how many rays it takes.

use rta_core::Scalar;
use rta_core::ray::RayKind;
use rta_core::scene::{Hit, Object};
use rta_core::surface::Surface;
use rta_core::trace::Observer;
use rta_core::trace::decision::Start;
use rta_packets::tally::{Rays, Tally};

/// An observer of the rays of one pixel.
#[derive(Debug, Default)]
pub struct Probe {
    tally: Tally,
    /// What the first primary ray hit; none before its hit is known.
    seen: Option<Option<Object>>,
}

impl Probe {
    /// Returns the object that the pixel's first primary ray hit; none is the sky.
    #[must_use]
    pub fn object(&self) -> Option<Object> {
        self.seen.flatten()
    }

    /// Returns the rays of all of the pixel's samples, by kind.
    #[must_use]
    pub const fn rays(&self) -> Rays {
        self.tally.0
    }
}

impl<S: Scalar> Observer<S> for Probe {
    fn ray(&mut self, kind: RayKind, depth: u8, start: &Start<S>) {
        self.tally.ray(kind, depth, start);
    }

    fn hit(&mut self, hit: Option<&Hit<S>>, _surface: Option<&Surface<S>>) {
        // The first hit that is told is that of the first primary ray.
        self.seen.get_or_insert(hit.map(|hit| hit.object));
    }

    fn shadow(&mut self, lamp: usize, start: &Start<S>) {
        self.tally.shadow(lamp, start);
    }
}
