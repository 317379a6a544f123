//! Scene files of rta: readers, and their way into a scene of any number format.
//!
//! A reader turns a file into a [`description::Description`], owned and in `f64`; [`dat`] reads the thesis's own
//! format. [`shipped`] holds the scenes that come with rta.
//!
//! ```
//! use rta_scenes::{dat, shipped};
//!
//! let juggler = dat::read(shipped::JUGGLER.as_bytes(), "juggler.dat")?;
//! assert_eq!(juggler.spheres.len(), 70);
//!
//! let error = dat::read(b"0 0 1\n0 1 zero", "scene.dat").unwrap_err();
//! assert_eq!(
//!     error.to_string(),
//!     "scene.dat:2:5: expected the z of the direction of view (a number), found \"zero\", not a number"
//! );
//! # Ok::<(), rta_scenes::error::SceneError>(())
//! ```

pub mod bake;
pub mod dat;
pub mod description;
pub mod error;
pub mod narrow;
pub mod nff;
mod numbers;
pub mod shipped;
mod space;
mod tokens;

pub use bake::bake;
