//! Refraction obeys Snell's law.

use rta_core::color::Rgb;
use rta_core::material::{Glass, Material};
use rta_core::surface::Surface;
use rta_core::trace::decision::refract;

use super::*;

pub(super) fn check<S: Measure>(
    incoming: Triple,
    normal: Triple,
    ior: f64,
    inside: bool,
) -> Result<(), TestCaseError> {
    let (incoming, normal): (UnitVec3<S>, UnitVec3<S>) = (direction::<S>(incoming), direction::<S>(normal));
    let normal = if normal.dot(incoming) > S::Unit::ZERO { -normal } else { normal };
    let half = S::unit(0.5);
    let eta = S::unit(if ior > 1.0 { 1.0 / ior } else { ior });
    let glass = Glass { ks: half, kt: half, eta, denser: ior >= 1.0 };
    let material = Material::Transparent(glass);
    let surface = Surface {
        point: place::<S>([0.0; 3]),
        normal,
        face: None,
        incoming,
        distance: S::ZERO,
        inside,
        extent: S::ZERO,
        color: Rgb::new(half, half, half),
        material: &material,
        surroundings: false,
        mesh: None,
        number: 0,
    };
    let sine = |v: UnitVec3<S>| {
        let (v, n) = (read_direction::<S>(v), read_direction::<S>(normal));
        let along = dot(v, n) / dot(n, n);
        length(minus(v, n.map(|c| c * along)))
    };
    // The index that goes with the ray: above 1 into the denser.
    let eta = if inside == glass.denser { 1.0 / S::unit_to_f64(eta) } else { S::unit_to_f64(eta) };
    let bent = eta * sine(incoming);
    // Roundings of the two directions and of the root, and of eta where it magnifies.
    let tolerance = 8.0 * S::UNIT * eta.max(1.0);
    match refract(&surface, &glass) {
        None => prop_assert!(bent >= 1.0 - tolerance, "{}: total reflection at {}", S::NAME, bent),
        Some(out) => {
            prop_assert!((sine(out) - bent).abs() <= tolerance, "{}: {} for {}", S::NAME, sine(out), bent);
            prop_assert!(
                (length(read_direction::<S>(out)) - 1.0).abs() <= 4.0 * S::UNIT,
                "{}: length",
                S::NAME
            );
            prop_assert!(out.dot(normal) <= S::unit(8.0 * S::UNIT), "{}: on the wrong side", S::NAME);
        }
    }
    Ok(())
}
