//! Parameters that a model has of its own for each material: a table of rows, in the order of the scene's materials.
//!
//! Rows are made where a scene becomes one of a number format, on a machine that reads scenes, and are borrowed by the model, as the
//! scene borrows its lists: in RAM or in flash. A program that draws with one model holds the rows of that model and no others.

mod exact;
mod reflection;

pub use exact::Exact;
pub use reflection::{Reflecting, Reflection};

use super::Illumination;
use super::fresnel::Conductor;
use super::microfacet::Roughness;
use crate::color::Rgb;
use crate::scalar::{Exponent, Scalar, Unit};

/// The most slopes that one material has.
pub const MOST_SLOPES: usize = 4;

/// The type of [`Positive`](crate::scalar::Positive) numbers of a format.
pub type PositiveOf<S> = <<S as Scalar>::Unit as Unit>::Positive;

/// What decides the coefficients that a material does not state, and what the models take it for that know only the thesis's
/// types.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// Type 0: diffuse.
    #[default]
    Opaque,
    /// Type 1: diffuse with highlights.
    Shiny,
    /// Type 2: a perfect mirror.
    Mirror,
    /// Glass: it reflects a tenth of the light and transmits the rest where the model knows no better.
    Glass,
    /// A metal.
    Metal,
}

/// What a scene says of a material, in the numbers of a format. What it does not say is `None`; then the model decides.
pub trait Properties<S: Scalar> {
    /// Returns ka, the coefficient of ambient light, 0 or more.
    fn ambient(&self) -> Option<S::Unit>;
    /// Returns kd, the diffuse coefficient, 0 or more.
    fn diffuse(&self) -> Option<S::Unit>;
    /// Returns the coefficient of light that shines through diffusely from behind, 0 to 1.
    fn back(&self) -> Option<S::Unit>;
    /// Returns ks, the specular coefficient, 0 or more.
    fn specular(&self) -> Option<S::Unit>;
    /// Returns kt, the share of the light that is transmitted, 0 or more.
    fn transmit(&self) -> Option<S::Unit>;
    /// Returns the share of the light of a reflected ray in models that have highlights without one, 0 to 1.
    fn mirror(&self) -> Option<S::Unit>;
    /// Returns the exponent of highlights by the halfway vector.
    fn exponent(&self) -> Option<Exponent>;
    /// Returns c of [`Gauss`](super::microfacet::Gauss).
    fn narrowness(&self) -> Option<PositiveOf<S>>;
    /// Returns c of [`Trowbridge`](super::microfacet::Trowbridge), above 0, at most 1.
    fn roundness(&self) -> Option<S::Unit>;
    /// Returns the slope number `index`, from 0, of [`Beckmann`](super::microfacet::Beckmann).
    fn slope(&self, index: usize) -> Option<Roughness<S::Unit>>;
    /// Returns what it is like where it states nothing.
    fn kind(&self) -> Kind;
    /// Returns the reflectance at perpendicular incidence: of a metal, or by the index of refraction.
    fn reflectance(&self) -> Option<Rgb<S::Unit>>;
    /// Returns the complex index of refraction of each register, if it is stated.
    fn conductor(&self) -> Option<Rgb<Conductor<S::Unit>>>;
    /// Returns the index of refraction: the smaller of the indices inside and outside over the larger, and whether the inside has the
    /// larger.
    fn index(&self) -> Option<(S::Unit, bool)>;
    /// Returns -log2 of what is left of light inside after a length of 1.
    fn absorption(&self) -> Option<Rgb<PositiveOf<S>>>;
    /// Returns how a thin wall transmits light: exponent, least and most.
    fn edge(&self) -> Option<(Exponent, S::Unit, S::Unit)>;
    /// Returns whether it is a thin wall, through which light goes straight on.
    fn is_thin(&self) -> bool;
}

/// A value of a row, for programs that write rows as source text.
#[derive(Clone, Copy, Debug)]
pub enum Value<S: Scalar> {
    /// A coefficient.
    Unit(S::Unit),
    /// A number of 0 or more and of any size.
    Positive(PositiveOf<S>),
    /// An exponent.
    Exponent(Exponent),
    /// A coefficient of each register.
    Color(Rgb<S::Unit>),
    /// A number of 0 or more and of any size for each register.
    Positives(Rgb<PositiveOf<S>>),
    /// Yes or no.
    Flag(bool),
    /// A reflectance.
    Reflection(Reflection<S>),
    /// A reflectance, of metals by their complex index of refraction.
    Exact(Exact<S>),
    /// Slopes, of which the last ones may have a share of 0.
    Slopes([Roughness<S::Unit>; MOST_SLOPES]),
}

/// The parameters of one material.
pub trait Row<S: Scalar>: Copy + core::fmt::Debug + Send + Sync {
    /// The name of the type in `rta_core::illumination`; empty for a model that has no parameters of its own.
    const NAME: &'static str;
    /// Calls `see` with the name and the value of each field.
    fn fields(&self, see: impl FnMut(&'static str, Value<S>));
}

impl<S: Scalar> Row<S> for () {
    const NAME: &'static str = "";
    fn fields(&self, _see: impl FnMut(&'static str, Value<S>)) {}
}

/// A model with the table that it needs, which is empty for most.
pub trait Tabled<S: Scalar>: Illumination<S> + Copy {
    /// What it must know of a material.
    type Row: Row<S>;
    /// The model over rows that live so long.
    type Over<'r>: Illumination<S> + Copy;
    /// Returns the row of a material.
    fn row(&self, material: &impl Properties<S>) -> Self::Row;
    /// Returns the model over other rows, which are in the order of the scene's materials.
    fn over<'r>(&self, rows: &'r [Self::Row]) -> Self::Over<'r>;
    /// Returns the model for a picture in whose middle a ray is so long, of which a model may fade what is farther.
    #[must_use]
    fn focused(self, _length: S) -> Self {
        self
    }
}

/// Says of a model that it has no parameters of its own.
macro_rules! rowless {
    ($Model:ty $(, $more:item)?) => {
        impl<S: Scalar> $crate::illumination::table::Tabled<S> for $Model {
            type Row = ();
            type Over<'r> = Self;
            fn row(&self, _material: &impl $crate::illumination::table::Properties<S>) {}
            fn over(&self, _rows: &[()]) -> Self {
                *self
            }
            $($more)?
        }
    };
}
pub(super) use rowless;
