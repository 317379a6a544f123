//! Lamps, and a lamp as seen from a point.

pub mod area;
pub mod cone;
pub mod cover;

use crate::color::Rgb;
use crate::needs::Needs;
use crate::scalar::vector::{LengthVector, UnitVec3, UnitVector, Vec3};
use crate::scalar::{Light, Positive, Scalar, Unit};

/// A lamp: a point light at its centre, visible as a sphere if its radius is above 0. It casts no shadow.
#[derive(Clone, Copy, Debug)]
pub struct Lamp<S: Scalar> {
    /// Centre.
    pub position: Vec3<S>,
    /// Radius, 0 or more.
    pub radius: S,
    /// Reciprocal of the radius.
    pub inverse_radius: S::Inverse,
    /// Intensity of the strongest register: the irradiance at distance 1.
    pub power: S::Power,
    /// Each register as a part of the strongest one, 0 to 1.
    pub tint: Rgb<S::Unit>,
    /// Whether its light becomes less with the distance.
    pub fall_off: FallOff,
}

/// How the light of a lamp depends on the distance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FallOff {
    /// As the illumination model has it. Under a model of constant lamps an intensity above 1, such as the 40000 of the thesis's
    /// files, counts as 1.
    #[default]
    OfModel,
    /// It becomes less with the square of the distance, under every model.
    Square,
    /// It does not depend on the distance, under every model.
    Constant,
}

impl FallOff {
    /// Returns whether the light becomes less with the distance under a model whose lamps do so, or do not, by themselves.
    pub const fn fades(self, of_model: bool) -> bool {
        match self {
            Self::OfModel => of_model,
            Self::Square => true,
            Self::Constant => false,
        }
    }
}

impl<S: Scalar> Lamp<S> {
    /// Returns a lamp of the intensity `power` times `tint`, whose strongest register is 1, with the model's fall-off.
    pub fn new(position: Vec3<S>, radius: S, power: S::Power, tint: Rgb<S::Unit>) -> Self {
        Self { position, radius, inverse_radius: radius.inverse(), power, tint, fall_off: FallOff::OfModel }
    }

    /// Returns a white lamp of a whole-numbered intensity: the irradiance at distance 1.
    pub fn white(position: Vec3<S>, radius: S, intensity: u32) -> Self {
        let one = S::Unit::ONE;
        Self::new(position, radius, S::power(intensity, 0), Rgb::new(one, one, one))
    }

    /// Returns whether a constant lamp counts as one of the intensity 1. `fades` is as in [`Incident::light`].
    pub(crate) fn is_cut(&self, fades: bool) -> bool {
        !fades && self.fall_off == FallOff::OfModel && S::intensity(self.power) > S::Light::WHITE
    }

    /// Returns the radiance of the lamp as a ray sees it: intensity over radius squared (Graham 1987); saturates in fixed point.
    pub fn radiance(&self) -> Rgb<S::Light> {
        let light = S::fall_off(self.power, self.inverse_radius);
        self.tint.map(|part| light.times(part))
    }
}

/// One lamp as seen from a point of a surface.
#[derive(Clone, Copy, Debug)]
pub struct Incident<'a, S: Scalar> {
    /// Unit vector from the point to the lamp's centre.
    pub direction: UnitVec3<S>,
    /// Distance to the lamp's centre.
    pub distance: S,
    /// Reciprocal of the distance.
    pub inverse_distance: S::Inverse,
    /// Cosine of the angle between normal and [`Incident::direction`]; negative for a lamp behind the surface.
    pub cosine: S::Unit,
    /// The lamp.
    pub lamp: &'a Lamp<S>,
}

impl<'a, S: Scalar> Incident<'a, S> {
    /// Returns the lamp as seen from a point with a unit normal; `None` if the point is the lamp's centre.
    pub fn new(lamp: &'a Lamp<S>, point: Vec3<S>, normal: UnitVec3<S>) -> Option<Self> {
        let (direction, distance, inverse_distance) = (lamp.position - point).normalize()?;
        Some(Self { direction, distance, inverse_distance, cosine: normal.dot(direction), lamp })
    }

    /// Returns the irradiance of the strongest register on a surface that faces the lamp: intensity over distance squared.
    pub fn irradiance(&self) -> S::Light {
        S::fall_off(self.lamp.power, self.inverse_distance)
    }

    /// Returns the intensity of the strongest register as a radiance, not attenuated.
    pub fn intensity(&self) -> S::Light {
        S::intensity(self.lamp.power)
    }

    /// Returns the light of the strongest register on a surface that faces the lamp. `fades` tells whether the model's lamps become
    /// less with the distance where they do not say it themselves.
    pub fn light<N: Needs>(&self, fades: bool) -> S::Light {
        if N::ATTENUATION && (!N::SEVERAL_FALL_OFFS || self.lamp.fall_off.fades(fades)) {
            return self.irradiance();
        }
        if self.lamp.is_cut(fades) { S::Light::WHITE } else { self.intensity() }
    }

    /// Returns the light that a surface with the reflectance `reflectance` of each register sends back of the lamp; saturates. `fades` is
    /// as in [`Incident::light`].
    ///
    /// The irradiance of a lamp that fades is that of a point times 1 to 2: the solid angle of the sphere over `pi (r/d)^2`, which is
    /// `2 / (1 + sqrt(1 - (r/d)^2))`. A point within the lamp is taken as one on it.
    pub fn reflected<N: Needs>(&self, reflectance: Rgb<S::Power>, fades: bool) -> Rgb<S::Light> {
        let (one, half) = (S::Unit::ONE, S::Unit::ratio(1, 2));
        let sent = reflectance.zip(self.lamp.tint, |part, tint| part.times(tint.positive()));
        if !(N::ATTENUATION && (!N::SEVERAL_FALL_OFFS || self.lamp.fall_off.fades(fades))) {
            let power = if self.lamp.is_cut(fades) { one.positive() } else { self.lamp.power };
            return sent.map(|part| S::intensity(part.times(power)));
        }
        let (inverse, sine) = if self.lamp.radius < self.distance {
            (self.inverse_distance, self.lamp.radius.fraction(self.inverse_distance))
        } else {
            (self.lamp.inverse_radius, one)
        };
        let cosine = S::Unit::radical(one, S::Unit::ZERO, sine).unwrap_or(S::Unit::ZERO);
        let power = self.lamp.power.over((half + cosine.times(half)).positive());
        sent.map(|part| S::fall_off(part.times(power), inverse))
    }

    /// Returns the lamp's solid angle as a part of the full sphere (4 pi steradians): `(1 - sqrt(1 - (r/d)^2)) / 2`; 1/2 for a
    /// point within the lamp.
    pub fn solid_angle(&self) -> S::Unit {
        let half = S::Unit::ratio(1, 2);
        if self.lamp.radius >= self.distance {
            return half;
        }
        let sine = self.lamp.radius.fraction(self.inverse_distance);
        let cosine = S::Unit::radical(S::Unit::ONE, S::Unit::ZERO, sine).unwrap_or(S::Unit::ZERO);
        (S::Unit::ONE - cosine).times(half)
    }
}
