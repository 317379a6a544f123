//! Illumination models: what a point of a surface sends back along a ray.
//!
//! A model is asked by the tracer, never the other way: it sees a [`Surface`] and one [`Incident`] lamp at a time, and
//! says which secondary rays it wants with which [`Weight`]. Changing the model of a picture changes one type parameter.

use crate::color::Rgb;
use crate::light::Incident;
use crate::needs::Needs;
use crate::scalar::{Light, Scalar, Unit};
use crate::surface::Surface;

/// Declares the module of each model, and lets other crates repeat something for each of them.
macro_rules! models {
    (($d:tt) $($module:ident: $Model:ident = $name:literal, $about:literal;)*) => {
        $(
            mod $module;
            pub use $module::$Model;
        )*

        /// Calls the macro that it is given with all models of `rta_core::illumination`: after the arguments that follow the
        /// macro's name come, for each model, its type, its name on the command line and what a help text says of it.
        ///
        /// What is to be there for each model (a command line's choices, a dispatch) is made by such a macro, so that
        /// it has a new model by itself. Each type has a `default()`.
        ///
        /// ```
        /// macro_rules! names {
        ///     ($($Model:ident $name:literal $about:literal)*) => { [$($name),*] };
        /// }
        /// assert!(rta_core::with_models!(names).contains(&"phong"));
        /// ```
        #[macro_export]
        macro_rules! with_models {
            ($d macro:ident $d($d argument:tt)*) => {
                $d macro! { $d($d argument)* $($Model $name $about)* }
            };
        }
    };
}

// The models. A new one is its file and its line here: module, type, name, and the words of the help, without a full stop.
models! { ($)
    rta: Rta = "rta", "The thesis's: Whitted's with attenuated lamps and cut-out highlights";
    whitted: Whitted = "whitted", "Whitted 1980: lamps are not attenuated, highlights are powers of a cosine";
    phong: Phong = "phong", "Phong 1975 with Whitted's rays, the model of NFF: highlights are around the reflected ray";
    lambert: Lambert = "lambert", "Lambert 1760: every surface is diffuse, no ray is reflected or transmitted";
}

/// The rays that a point wants traced, and what part of their light it sends back.
#[derive(Clone, Copy, Debug)]
pub struct Secondary<W> {
    /// Weight of the reflected ray.
    pub reflected: Option<W>,
    /// Weight of the transmitted ray, which is a reflected one where there is total internal reflection.
    pub transmitted: Option<W>,
}

impl<W> Secondary<W> {
    /// No secondary rays.
    pub const NONE: Self = Self { reflected: None, transmitted: None };
}

/// A model of illumination for scenes in the scalar `S`.
pub trait Illumination<S: Scalar>: Send + Sync {
    /// The weight of a ray: [`Scalar::Unit`] where a surface treats the registers alike, [`Rgb`] of it where not.
    type Weight: Weight<S>;

    /// Whether lamps behind the surface count too (translucent things).
    const BOTH_SIDES: bool = false;

    /// Whether shiny surfaces reflect, and mirrors and glass show highlights: whoever bakes a scene for the model learns
    /// from it which [`Needs`] the scene has. A model that leaves this as it is gets more code than it may need, never less.
    const SPECULAR: bool = true;

    /// Whether the model asks for light that is attenuated with the distance of its lamp ([`Incident::irradiance`]): it
    /// decides the need [`Needs::ATTENUATION`], and how bright lamps have to be in a scene that is scaled.
    const ATTENUATION: bool = true;

    /// What the point sends back of the scene's ambient light.
    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light>;

    /// Whether lamps matter for this surface at all.
    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool;

    /// What the point sends back of one lamp that nothing hides. Where that is not dark, the tracer looks for what does.
    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light>;

    /// The secondary rays that the point wants.
    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<Self::Weight>;
}

/// What part of a ray's light arrives in the pixel.
pub trait Weight<S: Scalar>: Copy + core::fmt::Debug + Send + Sync {
    /// All of it.
    const WHOLE: Self;
    /// The part of a part.
    fn compose(self, other: Self) -> Self;
    /// The sum of two parts.
    fn join(self, other: Self) -> Self;
    /// The part of a light.
    fn filter(self, light: Rgb<S::Light>) -> Rgb<S::Light>;
    /// Whether the part is below `threshold` in every register.
    fn is_below(self, threshold: S::Unit) -> bool;
}

impl<S: Scalar<Unit = U>, U: Unit> Weight<S> for U {
    const WHOLE: Self = U::ONE;
    fn compose(self, other: Self) -> Self {
        Unit::times(self, other)
    }
    fn join(self, other: Self) -> Self {
        self + other
    }
    fn filter(self, light: Rgb<S::Light>) -> Rgb<S::Light> {
        light.map(|l| l.times(self))
    }
    fn is_below(self, threshold: U) -> bool {
        self < threshold
    }
}

impl<S: Scalar<Unit = U>, U: Unit> Weight<S> for Rgb<U> {
    const WHOLE: Self = Rgb::new(U::ONE, U::ONE, U::ONE);
    fn compose(self, other: Self) -> Self {
        self.zip(other, Unit::times)
    }
    fn join(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
    fn filter(self, light: Rgb<S::Light>) -> Rgb<S::Light> {
        light.zip(self, Light::times)
    }
    fn is_below(self, threshold: U) -> bool {
        self.r < threshold && self.g < threshold && self.b < threshold
    }
}
