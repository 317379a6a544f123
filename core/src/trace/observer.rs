//! Observers of the tracer: they count rays, or explain how a pixel came about.

use super::decision::Start;
use crate::color::Rgb;
use crate::light::Incident;
use crate::ray::RayKind;
use crate::scalar::Scalar;
use crate::scene::Hit;
use crate::surface::Surface;

/// A type whose methods the tracer calls for each ray. `()` is the observer that does nothing and costs nothing.
///
/// For a ray of the tree the order of calls is: [`ray`](Observer::ray), [`hit`](Observer::hit), for each lamp of a lit
/// surface [`shadow`](Observer::shadow) if a shadow ray is traced and [`lamp`](Observer::lamp), [`light`](Observer::light), and
/// [`spawned`](Observer::spawned) for each ray that it spawns. Of the rays that wait, the one spawned last is traced next.
pub trait Observer<S: Scalar> {
    /// A ray of the tree is traced, `depth` reflections and refractions away from the eye.
    fn ray(&mut self, _kind: RayKind, _depth: u8, _start: &Start<S>) {}

    /// The search is done: the nearest hit, `None` for the sky, and the surface there, `None` for sky and lamps.
    fn hit(&mut self, _hit: Option<&Hit<S>>, _surface: Option<&Surface<S>>) {}

    /// A shadow ray is traced to lamp number `lamp`.
    fn shadow(&mut self, _lamp: usize, _start: &Start<S>) {}

    /// The surface sends back `part` (0 to 1) of `light`, the radiance due to lamp number `lamp` before shadows; `light` is black
    /// where the lamp is behind the surface or too faint.
    fn lamp(&mut self, _lamp: usize, _incident: &Incident<S>, _light: Rgb<S::Light>, _part: S::Unit) {}

    /// The radiance of the ray without its secondary rays, times its weight.
    fn light(&mut self, _weighted: Rgb<S::Light>) {}

    /// A secondary ray was spawned. `passes` returns whether it would also be spawned with another cut-off.
    fn spawned(&mut self, _passes: &dyn Fn(S::Unit) -> bool) {}

    /// A surface reflects all of the light that it would transmit: total internal reflection.
    fn total_reflection(&mut self) {}

    /// A path ends because it has as many bounces as it may have, although it would go on.
    fn cut(&mut self) {}
}

impl<S: Scalar> Observer<S> for () {}
