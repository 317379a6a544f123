//! The desktop's fast way through a picture: a search that tests four things at once, and four samples traced side by side.
//!
//! [`Packets`] is an [`Accelerator`](rta_core::accelerator::Accelerator) for a processor with SIMD registers: a bounding volume
//! hierarchy whose nodes hold four boxes (I. Wald, C. Benthin and S. Boulos, "Getting Rid of Packets", IEEE Symposium on
//! Interactive Ray Tracing, 2008) and whose leaves hold four bounding spheres, and light buffers about the eye and the first lamps
//! (E. Haines and D. Greenberg, "The Light Buffer: A Shadow-Testing Accelerator", IEEE CG&A 6, 1986). It searches in `f32`
//! whatever the picture is traced in, and only says what a ray cannot meet; what is left is asked in the picture's own format,
//! so that a picture keeps its bytes: each box and each sphere is larger by a [margin](ToF32::margin) than the object in it,
//! that object's own test and this one can be wrong together.
//!
//! A picture in `f32` has the search's own numbers. There [`Rows::trace_rows`] follows four samples side by side: where they meet
//! something, how they leave it and where the lamps are from there is computed four at once, by the operations of the core in
//! its order, so that each of the four is what it is by itself, to the last bit. All decisions are those of
//! [`rta_core::trace::decision`]. Samples whose rays are spread take the same way ([`Rows::trace_samples`]): their pairs of numbers, their places
//! on lens and lamps and the shadow rays there are computed four at once. Paths of light in rooms of flat, diffuse triangles too
//! ([`Rows::follow_diffuse`]). In such rooms each spread ray is searched for by itself, among triangles alone.
//!
//! | step | where |
//! | --- | --- |
//! | nodes and leaves are built from a scene's description | `build.rs`, `build/*.rs` |
//! | one ray is searched for | `one.rs`, `query.rs`, `rays.rs`, `light_buffer.rs`, `cache.rs` |
//! | four samples are traced | `rows.rs`, `four/*.rs` |
//! | their rays are spread | `four/dice.rs`, `four/pairs.rs`, `four/mapping.rs`, `four/area.rs`, `four/spread.rs` |
//! | four paths are followed in a room | `four/path.rs`, `four/path/*.rs` |
//! | what is met in a room | `flat.rs`, `four/look.rs` |
//! | whether a pixel has samples enough | `agreement.rs` |
//! | a picture of any format and model | `picture.rs` |
#![forbid(unsafe_code)]

pub mod agreement;
mod build;
mod cache;
mod flat;
mod four;
mod leaf;
mod light_buffer;
mod number;
mod one;
mod packets;
pub mod picture;
mod query;
mod rays;
mod rows;
pub mod tally;

pub use cache::ShadowCache;
pub use number::ToF32;
pub use packets::Packets;
pub use picture::Picture;
pub use rows::{Rows, Samples};

/// The code of the README, compiled and run with the other examples.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
