//! Directions, surfaces and lamps of stated values, in one number format. Angles are in degrees, the normal is (0, 0, 1).

use rta_core::color::Rgb;
use rta_core::illumination::Illumination;
use rta_core::illumination::microfacet::{Facet, Roughness};
use rta_core::light::{Incident, Lamp};
use rta_core::material::{Finish, Glass, Material};
use rta_core::needs::Everything;
use rta_core::scalar::{Scalar, Unit};
use rta_core::scene::PLAIN;
use rta_core::surface::Surface;
use rta_core::vector::{UnitVec3, UnitVector, Vec3, Vector};
use rta_scenes::narrow::{Narrow, exponent};

/// Returns the unit vector at an angle from the normal and another around it.
pub(super) fn direction<S: Narrow>(from_normal: f64, around: f64) -> UnitVec3<S> {
    let ((s, c), (sine, cosine)) = (sin_cos(from_normal), sin_cos(around));
    Vector::new(S::unit(s * cosine), S::unit(s * sine), S::unit(c))
}

/// Returns sine and cosine of an angle in degrees, exact at multiples of 90.
fn sin_cos(degrees: f64) -> (f64, f64) {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let exact = |value: f64| if value.abs() < 1e-15 { 0.0 } else { value };
    (exact(sine), exact(cosine))
}

/// Returns the cosine of an angle.
pub(super) fn cosine<S: Narrow>(degrees: f64) -> S::Unit {
    S::unit(sin_cos(degrees).1)
}

/// Returns the facets between a lamp at `tl` and an eye at `tv`, `phi` around.
pub(super) fn facet<S: Narrow>(tl: f64, tv: f64, phi: f64) -> Option<Facet<S::Unit>> {
    Facet::between::<S>(UnitVec3::<S>::Z, direction::<S>(tl, 0.0), direction::<S>(tv, phi))
}

/// Returns a number that may be large.
pub(super) fn positive<S: Narrow>(value: f64) -> S::Power {
    <S as Narrow>::power(value)
}

/// Returns facets of the slope `m`, as a part of all.
pub(super) fn roughness<S: Narrow>(share: f64, m: f64) -> Roughness<S::Unit> {
    Roughness { share: S::unit(share), inverse: positive::<S>(1.0 / m) }
}

/// A surface of the colour white, an eye and a lamp without attenuation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lit<S: Scalar> {
    /// What the surface is made of.
    pub(super) material: Material<S>,
    /// Direction to the lamp.
    pub(super) light: UnitVec3<S>,
    /// Direction to the eye.
    pub(super) view: UnitVec3<S>,
    /// Distance of the eye.
    pub(super) distance: S,
}

impl<S: Narrow> Lit<S> {
    /// Returns a diffuse surface.
    pub(super) fn new(tl: f64, tv: f64, phi: f64) -> Self {
        let (light, view) = (direction::<S>(tl, 0.0), direction::<S>(tv, phi));
        Self { material: Material::Opaque, light, view, distance: S::length(1.0) }
    }

    /// Returns a surface with coefficients of its own.
    pub(super) fn finish(self, kd: f64, ks: f64, n: f64) -> Self {
        let glass = Glass { kt: S::Unit::ZERO, ..Glass::new(S::unit(ks), 1, 1) };
        let (kd, exponent) = (S::unit(kd), exponent(n));
        let finish = Finish { ka: kd, kd, exponent, reflected: exponent, glass };
        Self { material: Material::Finish(finish), ..self }
    }

    /// Returns what the surface sends back by a model, of ambient light of radiance 0 or 1 and of a lamp of the intensity 1.
    pub(super) fn light(self, model: &impl Illumination<S>, ambient: f64) -> f64 {
        let one = S::Unit::ONE;
        let zero: Vec3<S> = Vector::new(S::ZERO, S::ZERO, S::ZERO);
        let surface = Surface {
            point: zero,
            normal: UnitVec3::<S>::Z,
            face: None,
            incoming: -self.view,
            distance: self.distance,
            inside: false,
            extent: S::length(1.0),
            color: Rgb::new(one, one, one),
            material: &self.material,
            surroundings: false,
            mesh: None,
            number: PLAIN,
        };
        let lamp = Lamp::white(zero, S::ZERO, 1);
        let distance = S::length(1.0);
        let incident = Incident {
            direction: self.light,
            distance,
            inverse_distance: distance.inverse(),
            cosine: surface.normal.dot(self.light),
            lamp: &lamp,
        };
        let ambient = S::light(ambient);
        let mut light = model.ambient::<Everything>(&surface, Rgb::new(ambient, ambient, ambient));
        if model.is_lit::<Everything>(&surface) && !surface.is_behind::<Everything>(&incident) {
            light = light.plus(model.direct::<Everything>(&surface, &incident));
        }
        S::light_to_f64(light.g)
    }
}

/// Returns what a surface of that reflectance sends back of a lamp of the intensity P and the radius r at a distance d.
pub(super) fn reflected_lamp<S: Narrow>(reflectance: S::Power, [p, r, d]: [f64; 3]) -> f64 {
    let zero: Vec3<S> = Vector::new(S::ZERO, S::ZERO, S::ZERO);
    let one = S::Unit::ONE;
    let lamp = Lamp::new(zero, S::length(r), positive::<S>(p), Rgb::new(one, one, one));
    let distance = S::length(d);
    let incident = Incident {
        direction: UnitVec3::<S>::Z,
        distance,
        inverse_distance: distance.inverse(),
        cosine: one,
        lamp: &lamp,
    };
    let reflectance = Rgb::new(reflectance, reflectance, reflectance);
    S::light_to_f64(incident.reflected::<Everything>(reflectance, true).r)
}
