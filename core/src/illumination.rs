//! Illumination models: the light that a point of a surface sends back along a ray.
//!
//! The tracer calls the model, never the other way: for a [`Surface`] and one [`Incident`] lamp at a time the model returns
//! light, and for a surface the [`Weight`]s of its secondary rays. The model of a picture is one type parameter.

pub mod air;
pub mod fade;
pub mod fresnel;
pub mod microfacet;
mod passage;
pub mod table;
mod weight;

pub use passage::{Passage, Way};
use table::rowless;
pub use weight::Weight;

use crate::color::Rgb;
use crate::light::Incident;
use crate::material::Material;
use crate::needs::Needs;
use crate::scalar::vector::Vec3;
use crate::scalar::{Scalar, Unit};
use crate::surface::Surface;

/// Declares the module of each model, and lets other crates repeat something for each of them.
macro_rules! models {
    (($d:tt) $($module:ident: $Model:ident = $name:literal $facts:tt;)*) => {
        $(
            mod $module;
            pub use $module::*;
        )*

        /// Calls the macro that it is given with all models of `rta_core::illumination`: after the arguments that follow the
        /// macro's name come, for each model, its type, its name on the command line and, as the fields of [`Facts`] in braces, what is
        /// to be said of it.
        ///
        /// Code that needs each model (a command line's choices, a dispatch) uses such a macro, and so has a new model
        /// without a change. Each type has a `default()`.
        ///
        /// ```
        /// macro_rules! names {
        ///     ($($Model:ident $name:literal $facts:tt)*) => { [$($name),*] };
        /// }
        /// assert!(rta_core::with_models!(names).contains(&"phong"));
        /// ```
        #[macro_export]
        macro_rules! with_models {
            ($d macro:ident $d($d argument:tt)*) => {
                $d macro! { $d($d argument)* $($Model $name $facts)* }
            };
        }
    };
}

/// What a list of models says of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Facts {
    /// The year of its publication.
    pub year: &'static str,
    /// Its author.
    pub author: &'static str,
    /// Its formula, in the letters of its documentation.
    pub formula: &'static str,
    /// The secondary rays that it asks for, and their weights.
    pub rays: &'static str,
    /// What is special about it, without a full stop.
    pub about: &'static str,
}

// The models. A new one is its file and its line here: module, type, name, and what is to be said of it.
#[rustfmt::skip]
models! { ($)
    rta: Rta = "rta" { year: "1990", author: "Graham; thesis", formula: "kd ((Nz + 1.5) .4 Ia C + sum S ((1 - B) N.L E C + B I)) + ks C Ir + kt It", rays: "reflected ks C, refracted kt", about: "The thesis's: Whitted's with attenuated lamps and cut-out highlights" };
    whitted: Whitted = "whitted" { year: "1980", author: "Whitted", formula: "ka C Ia + sum S I (kd C N.L + ks (N.H)^n) + ks Ir + kt It", rays: "reflected ks, refracted kt", about: "Lamps are not attenuated, highlights are powers of a cosine" };
    phong: Phong = "phong" { year: "1975", author: "Phong", formula: "ka C Ia + sum S I (kd C N.L + ks (R.L)^n) + ks Ir + kt It", rays: "reflected ks, refracted kt", about: "With Whitted's rays, the model of NFF: highlights are around the reflected ray" };
    lambert: Lambert = "lambert" { year: "1760", author: "Lambert", formula: "ka C Ia + sum S E kd C N.L + sum' S E kdt C (-N.L)", rays: "none", about: "Every surface is diffuse, no ray is reflected or transmitted" };
    flat: Flat = "flat" { year: "", author: "", formula: "C", rays: "none", about: "Every surface shows its colour, without lamps" };
    bouknight: Bouknight = "bouknight" { year: "1970", author: "Bouknight", formula: "C (ka Ia + kd sum S I (N.L)^1.25)", rays: "none", about: "Diffuse surfaces without a Mach band at the edge of a shadow" };
    romney: Romney = "romney" { year: "1970", author: "Romney", formula: "C (N.V)^2 min(1, d0/d)^4", rays: "none", about: "The only lamp is in the eye" };
    blinn: Blinn = "blinn" { year: "1977", author: "Blinn", formula: "ka C Ia + sum S I (kd C N.L + ks (N.H)^n) + ks Ir + kt It", rays: "reflected ks, refracted kt", about: "Phong's highlights by the vector halfway between lamp and eye" };
    newell: Newell = "newell" { year: "1972", author: "Newell, Newell, Sancha", formula: "(1 - t) (phong without rays) + t It", rays: "straight t", about: "Transparency without refraction, denser at edges, over Phong's surfaces" };
    kay_greenberg: KayGreenberg = "kay-greenberg" { year: "1979", author: "Kay, Greenberg", formula: "whitted, each ray inside of a material times A^d", rays: "reflected ks, refracted kt", about: "Whitted's with light that is absorbed inside of materials" };
    cook_torrance: CookTorrance = "cook-torrance" { year: "1982", author: "Cook, Torrance", formula: "ka C Ia + sum S E (s D G F / (4 N.V) + (1 - s) C N.L)", rays: "reflected mirror F", about: "Rough surfaces of small mirrors, metals in their colours" };
    blinn_full: BlinnFull = "blinn-full" { year: "1977", author: "Blinn", formula: "ka C Ia + sum S I (kd C N.L + ks D G F / N.V) + ks Ir + kt It", rays: "reflected ks, refracted kt", about: "Highlights of small mirrors, brighter where they are seen at an angle" };
    hall_greenberg: HallGreenberg = "hall-greenberg" { year: "1983", author: "Hall, Greenberg", formula: "ka C Ia + kd C sum S I N.L + ks (F Ir A^d + sum S I F (N.H)^n) + kt ((1 - F) It A^d + sum' S I (1 - F) (N'.H')^n)", rays: "reflected ks F, refracted kt (1 - F)", about: "Fresnel's equations share the light, glass absorbs, lamps are seen through it" };
}

/// The secondary rays of a point, by their weights: the part of their light that the point sends back; `None` for no ray.
#[derive(Clone, Copy, Debug)]
pub struct Secondary<W> {
    /// Weight of the reflected ray.
    pub reflected: Option<W>,
    /// Weight of the transmitted ray; where there is total internal reflection, it is added to the reflected ray's.
    pub transmitted: Option<W>,
    /// Where the transmitted ray goes.
    pub bend: Bend,
}

/// Where a transmitted ray goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Bend {
    /// By Snell's law, where the material has an index of refraction.
    #[default]
    Refracted,
    /// Straight on, as through a thin wall.
    Straight,
}

impl<W> Secondary<W> {
    /// No secondary rays.
    pub const NONE: Self = Self { reflected: None, transmitted: None, bend: Bend::Refracted };

    /// Returns the rays with weights of three registers.
    pub fn registers<S: Scalar>(self) -> Secondary<Rgb<S::Unit>>
    where
        W: Weight<S>,
    {
        let Self { reflected, transmitted, bend } = self;
        Secondary { reflected: reflected.map(W::registers), transmitted: transmitted.map(W::registers), bend }
    }
}

/// A model of illumination for scenes in the scalar `S`.
pub trait Illumination<S: Scalar>: Send + Sync {
    /// The weight of a ray: [`Scalar::Unit`] if the model reflects red, green and blue alike, [`Rgb`] of it if not.
    type Weight: Weight<S>;

    /// Whether lamps behind the surface light it too, as for translucent materials.
    const BOTH_SIDES: bool = false;

    /// Whether a ray inside of a material sees lamps outside through its surface.
    const REFRACTS_LAMPS: bool = false;

    /// Whether shiny surfaces reflect, and mirrors and glass show highlights. The [`Needs`] of a scene are
    /// derived from it; true, the default, may compile in more code than necessary, never less.
    const SPECULAR: bool = true;

    /// Whether the model uses [`Incident::irradiance`], light that is attenuated with the distance of its lamp. It decides
    /// [`Needs::ATTENUATION`], and how bright lamps have to be in a scene that is scaled.
    const ATTENUATION: bool = true;

    /// Whether the model has rays that are bent by an index of refraction: true, the default, may trace more wavelengths than
    /// necessary, never less.
    const REFRACTS: bool = true;

    /// Returns the radiance that the point sends back of the scene's ambient light.
    fn ambient<N: Needs>(&self, surface: &Surface<S>, ambient: Rgb<S::Light>) -> Rgb<S::Light>;

    /// Returns whether lamps can light this surface at all.
    fn is_lit<N: Needs>(&self, surface: &Surface<S>) -> bool;

    /// Returns whether a lamp can light the point: whether it is before the surface, or the model lights
    /// [both sides](Illumination::BOTH_SIDES), or its lamps shine [into](Illumination::REFRACTS_LAMPS) a material.
    #[inline]
    fn is_reached<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> bool
    where
        Self: Sized,
    {
        can_light::<S, Self>(surface.inside, || surface.is_behind::<N>(incident))
    }

    /// Returns the radiance that the point sends back of one lamp, without shadows. Unless it is black, the tracer then traces a
    /// shadow ray.
    fn direct<N: Needs>(&self, surface: &Surface<S>, incident: &Incident<S>) -> Rgb<S::Light>;

    /// Returns the part, 0 to 1, of the light from all sides that the point sends back evenly to all sides: its colour times its diffuse
    /// coefficient; none of mirrors and glass without coefficients of their own. [`Paths`](crate::trace::Paths) ask for it.
    fn diffuse<N: Needs>(&self, surface: &Surface<S>) -> Rgb<S::Unit> {
        match surface.material {
            Material::Mirror | Material::Transparent(_) => surface.color.map(|_| S::Unit::ZERO),
            _ => surface.diffuse::<N>(),
        }
    }

    /// Returns whether lamps become less with the distance where they do not say it themselves.
    fn fades(&self) -> bool {
        Self::ATTENUATION
    }

    /// Returns the weight below which a secondary ray is not traced, where a [`Tracer`](crate::trace::Tracer) is not told another: 0, the
    /// default, traces all.
    fn cutoff(&self) -> S::Unit {
        S::Unit::ZERO
    }

    /// Returns the weights of the secondary rays of the point.
    fn secondary<N: Needs>(&self, surface: &Surface<S>) -> Secondary<Self::Weight>;

    /// Whether [`Illumination::along`] does anything.
    const ALONG: bool = false;

    /// Returns what happens to the light of a ray on its way; `None`, the default, if nothing does. `lit` returns the part of the
    /// light of a lamp, by its number, that reaches a place, 0 to 1; it traces a shadow ray.
    fn along<N: Needs>(
        &self,
        way: &Way<S>,
        lit: impl FnMut(Vec3<S>, usize) -> S::Unit,
    ) -> Option<Passage<S, Self::Weight>> {
        let _ = (way, lit);
        None
    }
}

/// Returns whether a lamp can light a surface that is seen from inside or not, if `is_behind` says whether it is behind: see
/// [`Illumination::is_reached`].
#[inline]
pub fn can_light<S: Scalar, M: Illumination<S>>(inside: bool, is_behind: impl FnOnce() -> bool) -> bool {
    M::BOTH_SIDES || (M::REFRACTS_LAMPS && inside) || !is_behind()
}
