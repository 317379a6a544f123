//! A triangle in one number format: everything but the vertices is made in `f64`.

use rta_core::scene::PLAIN;
use rta_core::shape::Triangle;
use rta_core::vector::{UnitVec3, Vector};

use super::{Checker, Narrow, NarrowError};
use crate::description;
use crate::space::{cross, difference, length, unit};

/// A direction in the format.
pub fn direction<S: Narrow>(v: [f64; 3]) -> UnitVec3<S> {
    let [x, y, z] = v.map(S::unit);
    Vector::new(x, y, z)
}

/// Returns triangle number `index` of a description in the format `S`, of no material yet.
///
/// # Errors
/// What of it the format cannot hold.
pub fn narrow<S: Narrow>(index: usize, of: &description::Triangle) -> Result<Triangle<S>, NarrowError> {
    let check = Checker::<S>::new("triangle", index, of.line);
    let [a, b, c] = of.vertices;
    let vertices = [check.place(a, 0.0)?, check.place(b, 0.0)?, check.place(c, 0.0)?];
    let (ab, ac, bc) = (difference(b, a), difference(c, a), difference(c, b));
    let extent = length(ab).max(length(ac));
    let area = cross(ab, ac);
    let normal = unit(area);
    // The height over each edge is twice the area over its length.
    let heights = [bc, ac, ab].map(|edge| length(area) / length(edge));
    let least = heights.iter().copied().fold(extent, f64::min);
    let (Some(normal), true) = (normal, least >= S::SMALLEST_RADIUS / 16.0) else {
        return Err(check.error(
            "the height",
            if least > 0.0 { least } else { 0.0 },
            S::SMALLEST_RADIUS / 16.0,
        ));
    };
    let extent = check.radius(extent)?;
    let normals = of.normals.map(|normals| normals.map(|n| direction::<S>(unit(n).unwrap_or(normal))));
    Ok(Triangle {
        vertices,
        extent,
        normal: direction::<S>(normal),
        normals,
        one_sided: of.one_sided,
        color: check.color("a colour's register", of.color)?,
        material: PLAIN,
    })
}
