//! What a scene does not need is not in the program.
//!
//! Each constant gates one branch of the tracer. A program that draws one scene names only what that scene uses, and
//! the compiler leaves the rest out.
//!
//! ```
//! use rta_core::prelude::*;
//! /// Spheres on a floor, one of them a mirror.
//! struct MirrorBall;
//! impl Needs for MirrorBall {
//!     const ELLIPSOIDS: bool = false;
//!     const CYLINDERS: bool = false;
//!     const GLINT: bool = false;
//!     const GLASS: bool = false;
//! }
//! ```

use crate::light::Lamp;
use crate::material::Material;
use crate::scalar::Scalar;
use crate::scene::Scene;

/// What a program must be able to draw. All of it is true unless said otherwise.
pub trait Needs: Send + Sync + 'static {
    /// Spheres.
    const SPHERES: bool = true;
    /// Ellipsoids.
    const ELLIPSOIDS: bool = true;
    /// Vertical cylinders.
    const CYLINDERS: bool = true;
    /// The chequered floor.
    const FLOOR: bool = true;
    /// A sky whose zenith differs from its horizon.
    const SKY_GRADIENT: bool = true;
    /// Lamps with a radius, which a ray can see.
    const VISIBLE_LAMPS: bool = true;
    /// Highlights on shiny surfaces.
    const GLINT: bool = true;
    /// Reflected rays.
    const MIRROR: bool = true;
    /// Transmitted rays; they take [`Needs::MIRROR`] for total internal reflection.
    const GLASS: bool = true;
    /// Shadows.
    const SHADOWS: bool = true;
    /// Transparent objects let part of the light through into their shadow.
    const TRANSPARENT_SHADOWS: bool = true;
}

/// Everything there is: what a program needs that reads its scene when it runs.
#[derive(Clone, Copy, Debug)]
pub struct Everything;

impl Needs for Everything {}

/// The name of the first constant that is false in `N` although the scene uses what it stands for. Where `Rta` is not the
/// illumination model, shiny surfaces may want reflected rays as well.
pub fn missing<N: Needs, S: Scalar>(scene: &Scene<S>) -> Option<&'static str> {
    let materials = || {
        let spheres = scene.spheres.iter().map(|s| &s.material);
        let ellipsoids = scene.ellipsoids.iter().map(|e| &e.material);
        spheres.chain(ellipsoids).chain(scene.cylinders.iter().map(|c| &c.material))
    };
    let glass = || materials().any(|m| matches!(m, Material::Transparent(_)));
    let seen = |lamp: &Lamp<S>| lamp.radius > S::ZERO;
    if !N::SPHERES && !scene.spheres.is_empty() {
        Some("SPHERES")
    } else if !N::ELLIPSOIDS && !scene.ellipsoids.is_empty() {
        Some("ELLIPSOIDS")
    } else if !N::CYLINDERS && !scene.cylinders.is_empty() {
        Some("CYLINDERS")
    } else if !N::FLOOR && scene.floor.is_some() {
        Some("FLOOR")
    } else if !N::SKY_GRADIENT && scene.sky.horizon != scene.sky.zenith {
        Some("SKY_GRADIENT")
    } else if !N::VISIBLE_LAMPS && scene.lamps.iter().any(seen) {
        Some("VISIBLE_LAMPS")
    } else if !N::GLINT && materials().any(|m| matches!(m, Material::Shiny)) {
        Some("GLINT")
    } else if !N::MIRROR && (glass() || materials().any(|m| matches!(m, Material::Mirror))) {
        Some("MIRROR")
    } else if !N::GLASS && glass() {
        Some("GLASS")
    } else if !N::TRANSPARENT_SHADOWS && N::SHADOWS && glass() {
        Some("TRANSPARENT_SHADOWS")
    } else {
        None
    }
}
