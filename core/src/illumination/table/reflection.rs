//! What the border of a material reflects, by what a scene says of the material.

use super::{Kind, Properties, Value};
use crate::color::Rgb;
use crate::illumination::fresnel::{Shift, dielectric, inverse_index};
use crate::scalar::{Positive, Scalar, Unit};

/// What a material reflects, decided by what a scene says of it.
pub trait Reflecting<S: Scalar>: Copy + core::fmt::Debug + Send + Sync {
    /// Returns the reflectance of a material; of one that says nothing, as of the index 1.5.
    fn of(material: &impl Properties<S>) -> Self;
    /// Returns the part of the light that is reflected, 0 to 1, where a ray meets facets of a thing of that colour at that cosine;
    /// `inside` tells whether it comes from the inside.
    fn at(&self, color: Rgb<S::Unit>, inside: bool, cosine: S::Unit) -> Rgb<S::Unit>;
    /// Returns it as the value of a row.
    fn value(&self) -> Value<S>;
}

/// The reflectance of a material: of one that light enters by Fresnel's equations and its index of refraction, of a metal by Cook's
/// shift from its colour towards white.
#[derive(Clone, Copy, Debug)]
pub struct Reflection<S: Scalar> {
    /// Reflectance of each register at perpendicular incidence, 0 to 1.
    pub f0: Rgb<S::Unit>,
    /// The smaller of the indices of refraction inside and outside over the larger; of a metal, that of a grey material which reflects
    /// the mean of `f0`.
    pub q: S::Unit,
    /// Whether the inside has the larger index.
    pub denser: bool,
    /// Whether it is a metal.
    pub is_metal: bool,
    /// Whether it is a thin wall, which has no inside.
    pub is_thin: bool,
    /// Whether `f0` is the colour of the object, as a mirror's is.
    pub is_tinted: bool,
}

/// The index of refraction of a material of which a scene says nothing: 1.5.
const INDEX: (i64, i64) = (2, 3);

/// Returns the mean of the three registers.
fn mean<U: Unit>(Rgb { r, g, b }: Rgb<U>) -> U {
    let third = U::ratio(1, 3);
    r.times(third) + g.times(third) + b.times(third)
}

fn at_most_one<U: Unit>(value: U) -> U {
    if value > U::ONE { U::ONE } else { value }
}

impl<S: Scalar> Reflecting<S> for Reflection<S> {
    fn of(material: &impl Properties<S>) -> Self {
        let (is_metal, is_tinted) = match material.kind() {
            Kind::Mirror => (true, true),
            Kind::Metal => (true, material.reflectance().is_none()),
            _ => (false, false),
        };
        let (q, denser) = material.index().unwrap_or((S::Unit::ratio(INDEX.0, INDEX.1), true));
        let one = S::Unit::ONE;
        let root = (one - q).positive().over(one.positive().plus(q.positive())).unit();
        let grey = root.times(root);
        let f0 = material.reflectance().unwrap_or(Rgb::new(grey, grey, grey));
        let q = if is_metal { inverse_index(mean(f0)) } else { q };
        Self { f0, q, denser, is_metal, is_thin: material.is_thin(), is_tinted }
    }

    fn at(&self, color: Rgb<S::Unit>, inside: bool, cosine: S::Unit) -> Rgb<S::Unit> {
        let cosine = at_most_one(cosine);
        if !self.is_metal {
            let part = dielectric(self.q, self.denser != (inside && !self.is_thin), cosine);
            return Rgb::new(part, part, part);
        }
        let f0 = if self.is_tinted { color.map(at_most_one) } else { self.f0 };
        let mean = at_most_one(mean(f0));
        let q = if self.is_tinted { inverse_index(mean) } else { self.q };
        let white = Shift { mean, q }.white(cosine);
        f0.map(|register| register + (S::Unit::ONE - register).times(white))
    }

    fn value(&self) -> Value<S> {
        Value::Reflection(*self)
    }
}
