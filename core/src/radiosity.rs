//! Radiosity: the light that diffuse surfaces send to each other, solved once for all eyes.
//!
//! C. Goral, K. Torrance, D. Greenberg and B. Battaile, "Modeling the Interaction of Light Between Diffuse Surfaces", SIGGRAPH 84;
//! M. Cohen and D. Greenberg, "The Hemi-Cube", SIGGRAPH 85; M. Cohen, S. Chen, J. Wallace and D. Greenberg, "A Progressive Refinement
//! Approach to Fast Radiosity Image Generation", SIGGRAPH 88; J. Wallace, K. Elmquist and E. Haines, "A Ray Tracing Algorithm for
//! Progressive Radiosity", SIGGRAPH 89.
//!
//! A [`Mesh`] is a list of quadrilaterals, each divided into patches. The radiosity of patch i is `B_i = E_i + rho_i sum_j F_ij B_j`: what
//! it emits, and the part of what arrives that it reflects. F_ij, a form factor, is the part of what leaves i that arrives at j, which is
//! also the part that j has of what i sees. All three registers have the same factors. B is pi times a radiance.
//!
//! | way | memory for each patch | where |
//! | --- | --- | --- |
//! | gathering: what is seen from a patch is traced anew in each sweep | 12 bytes in `Q16` | [`Solver`] |
//! | gathering, with what is seen kept | 20 bytes more for each ray | [`Solver::view`] |
//! | shooting: the brightest patch sends its light to all others | 24 bytes | [`Shooter`] |
//! | Gauss and Gauss-Seidel, with all factors in memory | 4 bytes for each pair of patches | [`Matrix`] |
//!
//! Light is in slices of the caller, in the order of the patches' numbers. What is seen from a patch is found by rays ([`Rays`]) or along the
//! cells of a hemi-cube ([`HemiCube`]), through the scene's own accelerator. A ray that meets a quadrilateral from behind, or anything else
//! that has no patches, is lost: it brings no light. Mirrors and glass send it on, up to four times, weighted as by [`Rta`]: extended form
//! factors (Wallace, Cohen and Greenberg 1987; Sillion and Puech 1989). Light that lamps send through them is found by such rays alone, and so
//! well only where lamps are large.
//!
//! [`Rta`]: crate::illumination::Rta

use core::fmt;

use crate::quantity::Bound;

mod cast;
mod ends;
#[cfg(feature = "f64")]
pub mod exact;
mod factor;
mod follow;
mod gather;
mod indirect;
mod matrix;
mod mesh;
mod place;
mod quad;
mod shoot;
mod sweep;
mod vertex;
mod view;
mod wallace;

pub use cast::{Cast, Casts, HemiCube, Rays};
pub use ends::{End, View};
pub use factor::point_to_polygon;
pub use gather::Solver;
pub use indirect::Indirect;
pub use matrix::Matrix;
pub use mesh::{Fault, Mesh, Patch, Site};
pub use quad::{Quad, greatest_reflectance};
pub use shoot::Shooter;
pub use sweep::{Outcome, Stop};
pub use vertex::{Corners, Solution};
pub use wallace::Balance;

/// The reason why radiosity is refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A quadrilateral is wrong.
    Quad {
        /// Its number, from 0.
        quad: usize,
        /// What is wrong.
        fault: Fault,
    },
    /// The light may be brighter than the number format can hold.
    Exceeds(Bound),
    /// The form factors of a patch are negative, come to more than 1, or have it see itself.
    Factors(Patch),
    /// A slice is too short.
    Room {
        /// How many elements are needed.
        needed: usize,
        /// How many there are.
        found: usize,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Quad { quad, fault } => {
                write!(f, "quadrilateral {} {fault}", quad.saturating_add(1))
            }
            Self::Exceeds(bound) => crate::Error::Exceeds(bound).fmt(f),
            Self::Factors(Patch { quad, cell: [i, j] }) => {
                let quad = quad.saturating_add(1);
                write!(
                    f,
                    "the form factors of patch {i}, {j} of quadrilateral {quad} are not parts of what it sees"
                )
            }
            Self::Room { needed, found } => {
                write!(f, "there is room for {found} numbers where {needed} are needed")
            }
        }
    }
}

impl core::error::Error for Error {}

/// Returns as many elements of a slice as are needed.
///
/// # Errors
/// [`Error::Room`] where there are fewer.
fn room<T>(slice: &mut [T], needed: usize) -> Result<&mut [T], Error> {
    let found = slice.len();
    slice.get_mut(..needed).ok_or(Error::Room { needed, found })
}

#[cfg(test)]
#[cfg(feature = "f64")]
#[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, clippy::indexing_slicing)] // tests
mod tests;
