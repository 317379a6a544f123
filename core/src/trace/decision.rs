//! What is decided at a point: whether a lamp lights it, and which secondary rays are spawned with which weights.
//!
//! The decisions are apart from the computation of directions, so that a tracer of several rays side by side shares them.

pub use super::aspects::Aspects;
use crate::color::Rgb;
pub use crate::illumination::can_light;
use crate::illumination::{Bend, Illumination, Secondary, Weight};
use crate::light::Incident;
use crate::material::Glass;
use crate::needs::Needs;
use crate::ray::RayKind;
pub use crate::ray::Start;
use crate::scalar::vector::{UnitVec3, UnitVector};
use crate::scalar::{Light, Scalar, Unit};
use crate::scene::Scene;
use crate::surface::Surface;

/// The place of a ray in the ray tree.
#[derive(Clone, Copy, Debug)]
pub struct Branch<W> {
    /// The part of its light that arrives in the pixel.
    pub weight: W,
    /// Reflections and refractions between it and the eye.
    pub depth: u8,
    /// What it is traced for.
    pub kind: RayKind,
}

impl<W> Branch<W> {
    /// Returns the root of the ray tree: a ray from the eye.
    pub fn eye<S: Scalar>() -> Self
    where
        W: Weight<S>,
    {
        Self { weight: W::WHOLE, depth: 0, kind: RayKind::Primary }
    }
}

/// Returns the radiance that a surface sends back of the scene's ambient light.
#[inline]
pub fn ambient<S: Scalar, M: Illumination<S>, N: Needs>(
    model: &M,
    surface: &Surface<S>,
    ambient: Rgb<S::Light>,
) -> Rgb<S::Light> {
    if N::MESHES
        && let Some(mesh) = &surface.mesh
    {
        return Aspects::of::<N>(surface, mesh).ambient::<M, N>(model, ambient);
    }
    model.ambient::<N>(surface, ambient)
}

/// Returns the radiance that a surface sends back of a lamp, before shadows: black where the lamp [does not
/// reach](Illumination::is_reached) it.
// Called in two places, it would not be inlined: 5 % of the instructions of balls2.nff in f32.
#[cfg_attr(not(target_os = "none"), inline(always))]
pub fn direct<S: Scalar, M: Illumination<S>, N: Needs>(
    model: &M,
    surface: &Surface<S>,
    incident: &Incident<S>,
) -> Rgb<S::Light> {
    match &surface.mesh {
        Some(_) if N::MESHES && !model.is_reached::<N>(surface, incident) => Rgb::BLACK,
        Some(mesh) if N::MESHES => Aspects::of::<N>(surface, mesh).direct::<M, N>(model, incident.lamp),
        _ if model.is_reached::<N>(surface, incident) => model.direct::<N>(surface, incident),
        _ => Rgb::BLACK,
    }
}

/// Returns the radiance that a surface sends back of a place on a lamp, before shadows, so that the mean over all places is that of the
/// lamp: black where the lamp does not reach it from `place`. The model is shown the lamp as `lamp` has it. Gouraud's vertices, and the
/// middles of Bishop and Weimer, are lit by the lamp's own middle.
pub fn glimpsed<S: Scalar, M: Illumination<S>, N: Needs>(
    model: &M,
    surface: &Surface<S>,
    place: &Incident<S>,
    lamp: &Incident<S>,
) -> Rgb<S::Light> {
    if !model.is_reached::<N>(surface, place) {
        return Rgb::BLACK;
    }
    match &surface.mesh {
        Some(mesh) if N::MESHES => Aspects::of::<N>(surface, mesh).direct::<M, N>(model, lamp.lamp),
        _ => model.direct::<N>(surface, lamp),
    }
}

/// Returns whether a shadow ray is traced to a lamp of which the surface would send back `light`: not where that is black.
pub fn casts_shadow_ray<N: Needs, L: Light>(light: Rgb<L>) -> bool {
    N::SHADOWS && light != Rgb::BLACK
}

/// A secondary ray that is to be traced, if there is one.
type Spawned<S, W> = Option<(Branch<W>, Start<S>)>;

/// Returns the weights of the secondary rays of a surface.
#[inline]
pub fn secondary<S: Scalar, M: Illumination<S>, N: Needs>(
    model: &M,
    surface: &Surface<S>,
) -> Secondary<M::Weight> {
    match &surface.mesh {
        Some(mesh) if N::MESHES => Aspects::of::<N>(surface, mesh).secondary::<M, N>(model),
        _ => model.secondary::<N>(surface),
    }
}

/// Returns the transmitted and the reflected ray that a surface spawns, with the weights `secondary`. A ray whose weight is below
/// `cutoff` is left out. `reflected` computes the start of the reflected ray, `refracted` that of the transmitted ray, or `None`
/// where there is total internal reflection; then the weights of both are joined in the reflected ray. `straight` computes the start
/// of a transmitted ray that is not bent.
#[cfg_attr(not(target_os = "none"), inline(always))]
pub fn branch<S: Scalar, W: Weight<S>, N: Needs>(
    secondary: Secondary<W>,
    surface: &Surface<S>,
    (parent, cutoff): (&Branch<W>, S::Unit),
    reflected: impl FnOnce() -> Start<S>,
    refracted: impl FnOnce(&Glass<S>) -> Option<Start<S>>,
    straight: impl FnOnce() -> Start<S>,
) -> [Spawned<S, W>; 2] {
    let ray = |weight: W, kind| {
        let weight = parent.weight.compose(weight);
        (!weight.is_below(cutoff)).then(|| Branch { weight, depth: parent.depth + 1, kind })
    };
    let (mut transmitted, mut mirrored) = (None, secondary.reflected);
    if N::GLASS
        && let Some(through) = secondary.transmitted
    {
        let start = match secondary.bend {
            Bend::Refracted => surface.material.glass::<N>().map(refracted),
            Bend::Straight => Some(Some(straight())),
        };
        match start {
            None => {}
            Some(Some(start)) => {
                transmitted = ray(through, RayKind::Transmitted).map(|branch| (branch, start));
            }
            Some(None) => mirrored = Some(mirrored.map_or(through, |weight| weight.join(through))),
        }
    }
    let mirrored = mirrored.and_then(|weight| ray(weight, RayKind::Reflected));
    [transmitted, mirrored.map(|branch| (branch, reflected()))]
}

/// Returns the part of the sky's radiance in the direction of a reflected ray of that weight that arrives in the pixel, for a surface that mirrors
/// the sky alone.
#[inline(never)] // few surfaces ask; where the sky is inlined twice, it is not inlined where all rays ask
pub fn mirrored_sky<S: Scalar, W: Weight<S>, N: Needs>(
    scene: &Scene<S>,
    weight: W,
    direction: UnitVec3<S>,
) -> Rgb<S::Light> {
    weight.filter(scene.radiance::<N>(direction))
}

/// Returns the unit direction of the transmitted ray by Snell's law; `None` where there is total internal reflection.
///
/// `T = eta I + (eta cos - sqrt(1 - eta^2 (1 - cos^2))) N`, where eta is the index of refraction where the ray comes
/// from over that where it goes. An eta above 1 divides the whole sum, so that no number exceeds 1: the direction is
/// normalised in the end anyway.
pub fn refract<S: Scalar>(surface: &Surface<S>, glass: &Glass<S>) -> Option<UnitVec3<S>> {
    let one = S::Unit::ONE;
    let cosine = -surface.normal.dot(surface.incoming);
    let direction = if surface.inside != glass.denser {
        // Into the denser: 1 - eta^2 + (eta cos)^2.
        let slanted = glass.eta.times(cosine);
        let root = S::Unit::radical(one, slanted, glass.eta)?;
        surface.incoming.scale(glass.eta).plus(surface.normal, slanted - root)
    } else {
        // Into the thinner, over eta: (1/eta)^2 - 1 + cos^2.
        let root = S::Unit::radical(cosine, glass.eta, one)?;
        surface.incoming.plus(surface.normal, cosine - root)
    };
    direction.normalize().map(|(direction, _)| direction)
}
