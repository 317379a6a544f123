//! Counts the rays of a picture, by kind.

use core::sync::atomic::{AtomicU64, Ordering};

use rta_core::color::Rgb;
use rta_core::illumination::{Illumination, RayKind, Secondary, Surface};
use rta_core::light::Incident;
use rta_core::needs::Needs;
use rta_core::scalar::Scalar;

/// Numbers of rays by kind: primary, reflected, transmitted, shadow.
pub type Rays = [u64; 4];

/// Returns the index of a kind in [`Rays`].
#[must_use]
pub const fn place(kind: RayKind) -> usize {
    match kind {
        RayKind::Primary => 0,
        RayKind::Reflected => 1,
        RayKind::Transmitted => 2,
        RayKind::Shadow => 3,
    }
}

/// Counters, one for each kind of ray.
#[derive(Debug, Default)]
pub struct Tally([AtomicU64; 4]);

impl Tally {
    /// Returns the model `inner` with its rays counted.
    pub const fn model<M>(&self, inner: M) -> Tallied<'_, M> {
        Tallied { inner, tally: self }
    }

    /// Returns the rays counted so far.
    #[must_use]
    pub fn rays(&self) -> Rays {
        self.0.each_ref().map(|counter| counter.load(Ordering::Relaxed))
    }
}

/// A model that counts the rays it is told of, and does all else as the one in it.
#[derive(Clone, Copy, Debug)]
pub struct Tallied<'a, M> {
    inner: M,
    tally: &'a Tally,
}

impl<S: Scalar, M: Illumination<S>> Illumination<S> for Tallied<'_, M> {
    type Weight = M::Weight;
    const BOTH_SIDES: bool = M::BOTH_SIDES;

    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light> {
        self.inner.ambient::<N>(surface, ambient)
    }

    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool {
        self.inner.is_lit::<N>(surface)
    }

    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light> {
        self.inner.direct::<N>(surface, incident)
    }

    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<Self::Weight> {
        self.inner.secondary::<N>(surface)
    }

    fn note(&self, kind: RayKind) {
        self.inner.note(kind);
        if let Some(counter) = self.tally.0.get(place(kind)) {
            counter.fetch_add(1, Ordering::Relaxed);
        }
    }

    fn note_light(&self, light: Rgb<S::Light>) {
        self.inner.note_light(light);
    }

    fn note_shadow(&self, part: S::Unit) {
        self.inner.note_shadow(part);
    }
}

#[cfg(test)]
mod tests {
    use rta_scenes::{dat, shipped};

    use crate::engine::{Engine, Settings};

    #[test]
    fn every_kind_of_ray_is_counted_and_depth_0_has_no_tree() {
        let scene = dat::read(shipped::GLASS_2.as_bytes(), "glass-2.dat").expect("a shipped scene");
        let rays = |depth| {
            let settings = Settings { width: 32, height: 20, depth, ..Settings::default() };
            Engine::new(&scene, &settings).expect("a shipped scene").rays()
        };
        let [flat, deep] = [rays(0), rays(5)];
        let [primary, reflected, transmitted, shadow] = deep;
        assert_eq!(primary, 640);
        assert!(reflected > 50 && transmitted > 50 && shadow > 640, "{deep:?}");
        assert!(flat[..3] == [640, 0, 0] && (1..shadow).contains(&flat[3]), "{flat:?}");
    }
}
