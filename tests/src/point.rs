//! A point of a surface with a lamp and an eye in stated directions, as a model of illumination is asked about it.

use rta_core::Scalar;
use rta_core::color::Rgb;
use rta_core::illumination::Illumination;
use rta_core::light::{FallOff, Incident, Lamp};
use rta_core::material::{Finish, Glass, Material};
use rta_core::needs::Everything;
use rta_core::scalar::Unit;
use rta_core::scene::PLAIN;
use rta_core::surface::Surface;
use rta_core::trace::decision::direct;
use rta_core::vector::{UnitVec3, UnitVector, Vec3, Vector};
use rta_scenes::narrow::exponent;

use crate::measure::{Measure, direction, read_light};

/// A white point at the origin. Directions have any length but 0.
#[derive(Clone, Copy, Debug)]
pub struct Point<S: Scalar> {
    /// Unit normal, on the side of the eye.
    pub normal: UnitVec3<S>,
    /// Unit direction to the lamp.
    pub light: UnitVec3<S>,
    /// Unit direction to the eye.
    pub view: UnitVec3<S>,
    /// Length of the ray that meets the point.
    pub distance: S,
    /// Whether the ray comes from the inside.
    pub inside: bool,
    /// Colour.
    pub color: Rgb<S::Unit>,
    /// What it is made of.
    pub material: Material<S>,
    /// The number of its material.
    pub number: u16,
}

impl<S: Measure> Point<S> {
    /// Returns a diffuse point in the distance 1.
    #[must_use]
    pub fn new(normal: [f64; 3], light: [f64; 3], view: [f64; 3]) -> Self {
        let [normal, light, view] = [normal, light, view].map(direction::<S>);
        let (distance, one) = (S::length(1.0), S::Unit::ONE);
        let (color, material) = (Rgb::new(one, one, one), Material::Opaque);
        Self { normal, light, view, distance, inside: false, color, material, number: PLAIN }
    }

    /// Returns the point with coefficients of its own and an exponent.
    #[must_use]
    pub fn finish(self, kd: f64, ks: f64, n: f64) -> Self {
        let glass = Glass { kt: S::Unit::ZERO, ..Glass::new(S::unit(ks), 1, 1) };
        let (kd, exponent) = (S::unit(kd), exponent(n));
        let finish = Finish { ka: kd, kd, exponent, reflected: exponent, glass };
        Self { material: Material::Finish(finish), ..self }
    }

    /// Returns the point as a model sees it.
    #[must_use]
    pub fn surface(&self) -> Surface<'_, S> {
        let origin: Vec3<S> = Vector::new(S::ZERO, S::ZERO, S::ZERO);
        Surface {
            point: origin,
            normal: self.normal,
            face: None,
            incoming: -self.view,
            distance: self.distance,
            inside: self.inside,
            extent: S::length(1.0),
            color: self.color,
            material: &self.material,
            surroundings: false,
            mesh: None,
            number: self.number,
        }
    }

    /// Returns a white lamp without attenuation, of the intensity 1.
    #[must_use]
    pub fn lamp() -> Lamp<S> {
        let origin: Vec3<S> = Vector::new(S::ZERO, S::ZERO, S::ZERO);
        Lamp { fall_off: FallOff::Constant, ..Lamp::white(origin, S::ZERO, 1) }
    }

    /// Returns a lamp as the point sees it in a distance.
    #[must_use]
    pub fn incident<'a>(&self, lamp: &'a Lamp<S>, distance: S) -> Incident<'a, S> {
        let (cosine, inverse_distance) = (self.normal.dot(self.light), distance.inverse());
        Incident { direction: self.light, distance, inverse_distance, cosine, lamp }
    }

    /// Returns the radiance that the point sends back of the lamp [`Point::lamp`], by a model.
    #[must_use]
    pub fn lit(&self, model: &impl Illumination<S>) -> [f64; 3] {
        let lamp = Self::lamp();
        let incident = self.incident(&lamp, S::length(1.0));
        read_light::<S>(direct::<S, _, Everything>(model, &self.surface(), &incident))
    }

    /// Returns a point with a glass of an index of refraction.
    #[must_use]
    pub fn glass(self, ks: f64, kt: f64, index: f64) -> Self {
        let eta = S::unit(index.min(1.0 / index));
        let glass = Glass { ks: S::unit(ks), kt: S::unit(kt), eta, denser: index >= 1.0 };
        Self { material: Material::Transparent(glass), ..self }
    }
}

/// Returns a random vector, all directions alike.
pub fn random(dice: &mut fastrand::Rng) -> [f64; 3] {
    loop {
        let v = [(); 3].map(|()| 2.0 * dice.f64() - 1.0);
        if (0.01..=1.0).contains(&v.iter().map(|c| c * c).sum::<f64>()) {
            return v;
        }
    }
}

/// Returns a random vector on one side of a surface, all directions alike.
pub fn above(normal: [f64; 3], dice: &mut fastrand::Rng) -> [f64; 3] {
    let v = random(dice);
    let cosine: f64 = v.iter().zip(normal).map(|(a, b)| a * b).sum();
    if cosine < 0.0 { v.map(|c| -c) } else { v }
}
