//! Four rays side by side.

mod air;
mod area;
pub(crate) mod closest;
pub(crate) mod dice;
pub(crate) mod geometry;
mod look;
mod mapping;
mod mesh;
pub(crate) mod packet;
mod pairs;
pub(crate) mod path;
mod spread;
pub(crate) mod surfaces;
#[cfg(test)]
#[allow(clippy::indexing_slicing, clippy::float_cmp, reason = "a test may panic, and is exact")]
mod tests;
pub(crate) mod trace;
pub(crate) mod transmittance;
pub(crate) mod triangle;
pub(crate) mod vector;
mod walk;
