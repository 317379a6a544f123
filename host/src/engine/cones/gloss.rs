//! Where a rough surface reflects and refracts a cone to: one cone for all of its facets.

use rta_core::needs::Everything;
use rta_core::sampling::mapping::Facets;
use rta_core::surface::Surface;
use rta_core::trace::decision::refract;
use rta_core::vector::{UnitVec3, Vec3};

/// Facets that are asked, chosen by pairs of numbers as those of samples are.
const FACETS: u32 = 64;

/// What a rough surface makes of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lobe {
    /// The mean of the directions.
    pub axis: UnitVec3<f64>,
    /// The half angle of the cone about it, in radians, half of whose area has half of the light.
    pub width: f64,
    /// The part of the light that neighbouring facets do not hide, and that does not leave on the wrong side.
    pub part: f64,
}

/// Returns what the facets of a rough surface reflect; `None` if nothing leaves it.
pub fn reflected(surface: &Surface<f64>, roughness: f64) -> Option<Lobe> {
    lobe(surface, roughness, 1.0, |facet| Some(surface.incoming.reflect(facet.normal)))
}

/// Returns what they refract; `None` if nothing leaves it, or if it has no index of refraction.
pub fn refracted(surface: &Surface<f64>, roughness: f64) -> Option<Lobe> {
    let glass = surface.material.glass::<Everything>()?;
    lobe(surface, roughness, -1.0, |facet| refract(facet, glass))
}

/// Returns the lobe of the directions `bent` by facets, of those that leave on the `side` of the surface: 1 before it, -1 behind it.
fn lobe(
    surface: &Surface<f64>,
    roughness: f64,
    side: f64,
    bent: impl Fn(&Surface<f64>) -> Option<UnitVec3<f64>>,
) -> Option<Lobe> {
    let facets = Facets { roughness };
    let view = -surface.incoming;
    let step = u32::MAX / (2 * FACETS);
    let mut ways = Vec::with_capacity(FACETS as usize);
    let (mut sum, mut part) = (Vec3::<f64>::ZERO, 0.0);
    for number in 0..FACETS {
        // One of them in each row and in each column (J. Hammersley 1960).
        let pair = [number.reverse_bits(), (2 * number + 1) * step];
        let normal = facets.seen::<f64>(surface.normal, view, pair);
        let Some(direction) = bent(&Surface { normal, ..*surface }) else { continue };
        let cosine = side * surface.normal.dot(direction);
        if cosine <= 0.0 {
            continue;
        }
        let passed = facets.passed(surface.normal.dot(view), cosine);
        sum += direction * passed;
        part += passed;
        ways.push((direction, passed));
    }
    let length = sum.length();
    if length <= 0.0 {
        return None;
    }
    let axis = sum / length;
    let mut angles: Vec<_> =
        ways.iter().map(|(way, passed)| (axis.dot(*way).clamp(-1.0, 1.0).acos(), *passed)).collect();
    angles.sort_by(|(one, _), (other, _)| one.total_cmp(other));
    let mut within = 0.0;
    let median = angles.iter().find_map(|(angle, passed)| {
        within += passed;
        (within >= part / 2.0).then_some(*angle)
    });
    let width = core::f64::consts::SQRT_2 * median.unwrap_or(0.0);
    Some(Lobe { axis, width, part: part / f64::from(FACETS) })
}

#[cfg(test)]
mod tests {
    use rta_core::color::Rgb;
    use rta_core::material::{Glass, Material};
    use rta_core::surface::Surface;
    use rta_core::vector::{UnitVec3, Vec3};

    use super::{Lobe, reflected, refracted};

    fn surface(degrees: f64, material: &Material<f64>) -> Surface<'_, f64> {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        Surface {
            point: Vec3::<f64>::ZERO,
            normal: UnitVec3::<f64>::Z,
            face: None,
            incoming: UnitVec3::<f64>::new(0.0, sine, -cosine),
            distance: 1.0,
            inside: false,
            extent: 1.0,
            color: Rgb::new(1.0, 1.0, 1.0),
            material,
            surroundings: false,
            mesh: None,
            number: 0,
        }
    }

    #[test]
    fn lobes() {
        // What of the light leaves a rough mirror: the directional albedo.
        for (roughness, degrees, albedo) in
            [(0.3, 60.0, 0.821_711_003), (0.5, 0.0, 0.687_848_515), (1.0, 80.0, 0.668_185_944)]
        {
            let Lobe { part, .. } =
                reflected(&surface(degrees, &Material::Mirror), roughness).expect("some of it");
            assert!((part - albedo).abs() < 0.02, "{roughness} {degrees}: {part}");
        }
        // Half of the facets are tilted by less than the arc tangent of the roughness; a mirror turns by twice that.
        for roughness in [0.01, 0.05, 0.1] {
            let lobe = reflected(&surface(0.0, &Material::Mirror), roughness).expect("nearly all of it");
            let width = core::f64::consts::SQRT_2 * 2.0 * f64::atan(roughness);
            assert!((lobe.width / width - 1.0).abs() < 0.1, "{roughness}: {}, {width}", lobe.width);
            assert!(lobe.axis.z > 0.999, "{}", lobe.axis);
            // Glass turns what goes through by a third.
            let glass = Material::Transparent(Glass::new(0.1, 3, 2));
            let through = refracted(&surface(0.0, &glass), roughness).expect("nearly all of it");
            assert!((through.width * 6.0 / lobe.width - 1.0).abs() < 0.1, "{roughness}: {}", through.width);
            assert!(through.axis.z < -0.999, "{}", through.axis);
        }
        // Smooth ones have no width.
        let smooth = reflected(&surface(30.0, &Material::Mirror), 0.0).expect("all of it");
        assert!(smooth.width < 1e-6 && (smooth.part - 1.0).abs() < 1e-9, "{smooth:?}");
        assert_eq!(refracted(&surface(30.0, &Material::Mirror), 0.1), None);
    }
}
