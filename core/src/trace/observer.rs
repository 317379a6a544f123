//! Who watches the tracer: counters, explanations, reports.

use super::decision::Start;
use crate::color::Rgb;
use crate::light::Incident;
use crate::ray::RayKind;
use crate::scalar::Scalar;
use crate::scene::Hit;
use crate::surface::Surface;

/// Is told what happens to each ray, with what the tracer knows. `()` hears nothing and costs nothing.
///
/// Of a ray of the tree it is told in this order: [`ray`](Observer::ray), [`hit`](Observer::hit), for each lamp of a lit
/// surface [`shadow`](Observer::shadow) if a shadow ray is traced and [`lamp`](Observer::lamp), [`light`](Observer::light), and
/// [`spawned`](Observer::spawned) for each ray that it spawns. Of the rays that wait, the one spawned last is traced next.
pub trait Observer<S: Scalar> {
    /// A ray of the tree is traced, `depth` reflections and refractions away from the eye.
    fn ray(&mut self, _kind: RayKind, _depth: u8, _start: &Start<S>) {}

    /// The ray has met something or not: its nearest hit, and the surface there, if that is no lamp.
    fn hit(&mut self, _hit: Option<&Hit<S>>, _surface: Option<&Surface<S>>) {}

    /// A shadow ray is traced to lamp number `lamp`.
    fn shadow(&mut self, _lamp: usize, _start: &Start<S>) {}

    /// Of lamp number `lamp`, the surface sends back the part `part` of `light`; `light` is darkness where the lamp is behind
    /// the surface or too faint.
    fn lamp(&mut self, _lamp: usize, _incident: &Incident<S>, _light: Rgb<S::Light>, _part: S::Unit) {}

    /// What the ray brings of its own, as it arrives in the pixel.
    fn light(&mut self, _weighted: Rgb<S::Light>) {}

    /// A ray was spawned that is traced later. `passes` says whether it would also be spawned with another cut-off.
    fn spawned(&mut self, _passes: &dyn Fn(S::Unit) -> bool) {}

    /// All of the light that should have been transmitted is reflected.
    fn total_reflection(&mut self) {}
}

impl<S: Scalar> Observer<S> for () {}
