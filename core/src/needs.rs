//! Code that a scene does not need is left out of the program.
//!
//! Each constant of [`Needs`] guards branches of the tracer. A program that draws a known scene sets to false what that scene
//! does not use, and the compiler removes the code.
//!
//! ```
//! use rta_core::prelude::*;
//! /// Spheres on a floor, one of them a mirror.
//! struct MirrorBall;
//! impl Needs for MirrorBall {
//!     const ELLIPSOIDS: bool = false;
//!     const CYLINDERS: bool = false;
//!     const GLINT: bool = false;
//!     const GLASS: bool = false;
//! }
//! ```

/// The needs `N`, for code that is compiled apart from what most surfaces run: a function that is called from there too would not be
/// inlined here.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Apart<N>(core::marker::PhantomData<fn() -> N>);

/// The needs `N`, for shadow rays that transparent things stop as others do.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Opaque<N>(core::marker::PhantomData<fn() -> N>);

/// Returns a need of [`Opaque`].
macro_rules! opaque {
    ($N:ident TRANSPARENT_SHADOWS) => {
        false
    };
    ($N:ident $NAME:ident) => {
        $N::$NAME
    };
}

/// Declares each need once: its constant, its field and its documentation.
macro_rules! needs {
    ($($(#[doc = $doc:literal])+ $NAME:ident $field:ident,)+) => {
        /// What a program must be able to draw. Every constant is true unless an implementation says otherwise.
        pub trait Needs: Send + Sync + 'static {
            $($(#[doc = $doc])+ const $NAME: bool = true;)+
        }

        impl<N: Needs> Needs for Apart<N> {
            $(const $NAME: bool = N::$NAME;)+
        }

        impl<N: Needs> Needs for Opaque<N> {
            $(const $NAME: bool = opaque!(N $NAME);)+
        }

        /// The constants of [`Needs`] as values; the crate `rta-scenes` finds those that a scene uses.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        #[allow(clippy::struct_excessive_bools, reason = "each is the constant of the same name")]
        pub struct Used {
            $($(#[doc = $doc])+ pub $field: bool,)+
        }

        impl Used {
            /// Returns the constants of `N` as values.
            pub const fn of<N: Needs>() -> Self {
                Self { $($field: N::$NAME,)+ }
            }

            /// Returns name and value of each constant.
            pub const fn named(self) -> [(&'static str, bool); [$(stringify!($NAME)),+].len()] {
                [$((stringify!($NAME), self.$field),)+]
            }
        }
    };
}

needs! {
    /// Spheres.
    SPHERES spheres,
    /// Ellipsoids.
    ELLIPSOIDS ellipsoids,
    /// Cones and cylinders between two points.
    CONES cones,
    /// Triangles.
    TRIANGLES triangles,
    /// Triangles with normals at their vertices.
    NORMALS normals,
    /// Infinite planes.
    PLANES planes,
    /// Infinite vertical cylinders.
    CYLINDERS cylinders,
    /// The chequered floor.
    FLOOR floor,
    /// A floor whose tiles do not have 3 x 3 units.
    TILES tiles,
    /// A sky whose zenith differs from its horizon.
    SKY_GRADIENT sky_gradient,
    /// Lamps with a radius, which a ray can see.
    VISIBLE_LAMPS visible_lamps,
    /// Highlights on shiny surfaces.
    GLINT glint,
    /// Reflected rays. Without them there are no transmitted rays either, no ray tree and no stack.
    MIRROR mirror,
    /// Transmitted rays; they need [`Needs::MIRROR`] for total internal reflection.
    GLASS glass,
    /// Surfaces with their own coefficients: [`Material::Finish`](crate::material::Material::Finish).
    FINISH finish,
    /// Lamps.
    LAMPS lamps,
    /// More than one lamp; without it only the first one shines.
    SEVERAL_LAMPS several_lamps,
    /// Light that is attenuated with the distance to the lamp.
    ATTENUATION attenuation,
    /// Besides lamps whose light is attenuated, others whose light is not.
    SEVERAL_FALL_OFFS several_fall_offs,
    /// Shadows.
    SHADOWS shadows,
    /// Transparent objects let part of the light through into their shadow.
    TRANSPARENT_SHADOWS transparent_shadows,
    /// Materials with coats: [`Coat`](crate::texture::Coat).
    COATS coats,
    /// Chequered coats.
    CHECKER checker,
    /// Coats of marble.
    MARBLE marble,
    /// Coats of wood.
    WOOD wood,
    /// Coats with pictures.
    IMAGES images,
    /// Coats with bumps; they need [`Needs::NORMALS`].
    BUMPS bumps,
    /// Coats whose mirror rays see the sky alone.
    SURROUNDINGS surroundings,
    /// Coats that send out light by themselves.
    EMISSION emission,
    /// Triangles whose normals are not mixed in space: [`Mesh`](crate::texture::Mesh); they need [`Needs::NORMALS`] and [`Needs::COATS`].
    MESHES meshes,
    /// A picture of the sky.
    SKY_MAP sky_map,
    /// Lamps with a size that are asked at places of theirs, where rays are [`Distributed`](crate::trace::Distributed).
    AREA_LAMPS area_lamps,
    /// Of these, parallelograms; they need [`Needs::AREA_LAMPS`].
    SQUARE_LAMPS square_lamps,
    /// Lamps with a size that are asked by cones, [`Lamps::Cone`](crate::trace::dice::Lamps::Cone); they need [`Needs::AREA_LAMPS`].
    CONE_LAMPS cone_lamps,
    /// A lens, where rays are distributed.
    LENS lens,
    /// Indirect light that was solved ahead, where rays are distributed: [`Indirect`](crate::radiosity::Indirect).
    RADIOSITY radiosity,
    /// A medium that ends at a distance from where a ray starts: the reach of a
    /// [`Medium`](crate::illumination::air::Medium).
    AIR_REACH air_reach,
    /// Shadows in a medium, where rays are distributed.
    SPREAD_AIR spread_air,
    /// An eye that moves while the shutter is open, where rays are distributed.
    EYE_MOTION eye_motion,
    /// Rough surfaces, where rays are distributed; they need [`Needs::MIRROR`].
    GLOSS gloss,
    /// Of these, surfaces of grooves with Beckmann's slopes: [`Spread::slopes`](crate::trace::dice::Spread::slopes); they need
    /// [`Needs::GLOSS`].
    GROOVES grooves,
}

/// All constants true: for a program that reads its scene at run time.
#[derive(Clone, Copy, Debug)]
pub struct Everything;

impl Needs for Everything {}
