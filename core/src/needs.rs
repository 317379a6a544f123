//! What a scene does not need is not in the program.
//!
//! Each constant of [`Needs`] gates one branch of the tracer. A program that draws one scene names only what that scene
//! uses, and the compiler leaves the rest out.
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

/// Declares each need once: its constant, its field and its documentation.
macro_rules! needs {
    ($($(#[doc = $doc:literal])+ $NAME:ident $field:ident,)+) => {
        /// What a program must be able to draw. Every constant is true unless an implementation says otherwise.
        pub trait Needs: Send + Sync + 'static {
            $($(#[doc = $doc])+ const $NAME: bool = true;)+
        }

        /// What a scene uses: the constants of [`Needs`] as values. [`Used::by`](crate::used) finds them.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        #[allow(clippy::struct_excessive_bools, reason = "each is the constant of the same name")]
        pub struct Used {
            $($(#[doc = $doc])+ pub $field: bool,)+
        }

        impl Used {
            /// The constants of `N` as values.
            pub const fn of<N: Needs>() -> Self {
                Self { $($field: N::$NAME,)+ }
            }

            /// Each constant's name and value.
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
    /// Vertical cylinders without ends.
    CYLINDERS cylinders,
    /// The chequered floor.
    FLOOR floor,
    /// A sky whose zenith differs from its horizon.
    SKY_GRADIENT sky_gradient,
    /// Lamps with a radius, which a ray can see.
    VISIBLE_LAMPS visible_lamps,
    /// Highlights on shiny surfaces.
    GLINT glint,
    /// Reflected rays. Without them, and so without transmitted ones, there is no ray tree and no stack for it.
    MIRROR mirror,
    /// Transmitted rays; they need [`Needs::MIRROR`] for total internal reflection.
    GLASS glass,
    /// Surfaces with coefficients of their own.
    FINISH finish,
    /// Lamps.
    LAMPS lamps,
    /// More than one lamp; without it only the first one shines.
    SEVERAL_LAMPS several_lamps,
    /// Surfaces whose light falls off with the distance to the lamp.
    ATTENUATION attenuation,
    /// Shadows.
    SHADOWS shadows,
    /// Transparent objects let part of the light through into their shadow.
    TRANSPARENT_SHADOWS transparent_shadows,
}

/// Everything there is: what a program needs that reads its scene when it runs.
#[derive(Clone, Copy, Debug)]
pub struct Everything;

impl Needs for Everything {}
