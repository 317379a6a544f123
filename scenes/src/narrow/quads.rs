//! Quads in one number format, for radiosity.

use core::f64::consts::PI;

use rta_core::radiosity::{Quad, greatest_reflectance};

use super::check::Checker;
use super::{Narrow, NarrowError};
use crate::description::Description;

/// Returns the quads of a scene for [`Mesh`](rta_core::radiosity::Mesh), beside the triangles that [`narrow`](super::narrow) makes of it.
/// Reflectances above [`greatest_reflectance`] are that.
///
/// # Errors
/// What the format cannot hold.
pub fn quads<S: Narrow>(description: &Description) -> Result<Vec<Quad<S>>, NarrowError> {
    let mut first = 0u32;
    let mut made = Vec::with_capacity(description.quads.len());
    for (number, quad) in description.quads.iter().enumerate() {
        let triangles = quad.of(&description.triangles);
        let (Some(own), Some(corners)) = (triangles.first(), quad.corners(&description.triangles)) else {
            continue;
        };
        let check = Checker::<S>::new("quad", number, own.line);
        let [a, b, c, d] = corners.map(|corner| check.place(corner, 0.0));
        let kd = description.diffuse(&own.surface);
        let (most, color) = (greatest_reflectance::<S::Unit>(), own.color.map(|part| (part * kd).min(1.0)));
        let reflectance = check.color("a register of its reflectance", color)?;
        let emitted = description.emission(quad).unwrap_or_default();
        made.push(Quad {
            corners: [a?, b?, c?, d?],
            patches: quad.patches,
            first,
            reflectance: reflectance.map(|part| if part > most { most } else { part }),
            emission: check.light(emitted.map(|radiance| PI * radiance))?,
            emitting: quad.emitting_patches(),
            triangle: quad.triangle,
            triangles: quad.triangles(),
        });
        let [nu, nv] = quad.patches.map(u32::from);
        first = first.saturating_add(nu.saturating_mul(nv));
    }
    Ok(made)
}
