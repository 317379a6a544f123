//! What a metal reflects by its complex index of refraction.

use super::{Properties, Reflecting, Reflection, Value};
use crate::color::Rgb;
use crate::illumination::fresnel::Conductor;
use crate::scalar::{Scalar, Unit};

/// The reflectance of a material without an approximation: of a metal by Fresnel's equations for the complex index of refraction of each
/// register, if that is stated; of all else as [`Reflection`] has it.
#[derive(Clone, Copy, Debug)]
pub struct Exact<S: Scalar> {
    /// The index of each register.
    pub metal: Option<Rgb<Conductor<S::Unit>>>,
    /// The reflectance without one.
    pub plain: Reflection<S>,
}

impl<S: Scalar> Reflecting<S> for Exact<S> {
    fn of(material: &impl Properties<S>) -> Self {
        Self { metal: material.conductor(), plain: Reflection::of(material) }
    }

    fn at(&self, color: Rgb<S::Unit>, inside: bool, cosine: S::Unit) -> Rgb<S::Unit> {
        let cosine = if cosine > S::Unit::ONE { S::Unit::ONE } else { cosine };
        match self.metal {
            Some(metal) => metal.map(|register| register.reflectance(cosine)),
            None => self.plain.at(color, inside, cosine),
        }
    }

    fn value(&self) -> Value<S> {
        Value::Exact(*self)
    }
}
